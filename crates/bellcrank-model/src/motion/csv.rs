//! Tables of a motion: times and positions in CSV.

use bellcrank_doc::{Diagnostic, Diagnostics, Dimension, SourceId, Sources, Span, unit};

use super::Spline;

/// What the two columns measure.
#[derive(Clone, Copy)]
pub(crate) struct Columns {
    pub(crate) position: Dimension,
}

/// Factors from the numbers of each column to SI.
#[derive(Clone, Copy)]
struct Scale {
    time: f64,
    position: f64,
}

/// Reads `time,position` lines: SI, unless a header names units (`time [ms],s [mm]`). Blank lines and lines that
/// start with `#` do not count; `;` and tabs separate, too.
pub(crate) fn read_table(
    sources: &Sources,
    id: SourceId,
    columns: Columns,
    diagnostics: &mut Diagnostics,
) -> Option<Spline> {
    let before = diagnostics.errors();
    let mut scale = Scale { time: 1.0, position: 1.0 };
    let (mut times, mut values) = (Vec::new(), Vec::new());
    let mut first = true;
    for (offset, line) in lines(sources.text(id)) {
        let span = Span::new(id, offset, offset + line.len());
        match numbers(line) {
            Some([time, value]) => {
                check_row(time * scale.time, times.last().copied(), value, span, diagnostics);
                times.push(time * scale.time);
                values.push(value * scale.position);
            }
            None if first => scale = header(line, span, columns, diagnostics),
            None => diagnostics.push(not_a_row(line, span)),
        }
        first = false;
        if diagnostics.errors() > before + MOST {
            break;
        }
    }
    if diagnostics.errors() > before {
        return None;
    }
    let spline = Spline::through(times, values);
    if spline.is_none() {
        let message = "a table of a motion needs at least two lines of time and position";
        diagnostics.push(Diagnostic::error("short-table", Span::new(id, 0, 0), message));
    }
    spline
}

/// Faults of one table that are told.
const MOST: usize = 5;

fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let mut offset = 0;
    text.split_inclusive('\n')
        .map(move |line| {
            let start = offset;
            offset += line.len();
            (start, line.trim_end())
        })
        .filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'))
}

fn cells(line: &str) -> Vec<&str> {
    let separator = [';', '\t', ','].into_iter().find(|&c| line.contains(c)).unwrap_or(',');
    line.split(separator).map(|cell| cell.trim().trim_matches('"')).collect()
}

fn numbers(line: &str) -> Option<[f64; 2]> {
    match cells(line).as_slice() {
        [time, value] => Some([time.parse().ok()?, value.parse().ok()?]),
        _ => None,
    }
}

fn not_a_row(line: &str, span: Span) -> Diagnostic {
    let count = cells(line).len();
    let message = match count {
        2 => "expected two numbers, time and position".to_owned(),
        n => format!("expected two numbers, time and position, found {n} cells"),
    };
    Diagnostic::error("bad-table", span, message)
}

fn check_row(time: f64, before: Option<f64>, value: f64, span: Span, diagnostics: &mut Diagnostics) {
    if !time.is_finite() || !value.is_finite() {
        diagnostics.push(Diagnostic::error("not-finite", span, "a table holds finite numbers only"));
    } else if before.is_some_and(|before| time <= before) {
        let message = "times of a table increase from line to line";
        diagnostics.push(Diagnostic::error("bad-table", span, message));
    }
}

/// Units of a header such as `time [ms], s [mm]`; SI where none is named.
fn header(line: &str, span: Span, columns: Columns, diagnostics: &mut Diagnostics) -> Scale {
    let cells = cells(line);
    if cells.len() != 2 {
        diagnostics.push(not_a_row(line, span));
    }
    let mut factor = |index: usize, dimension: Dimension| {
        let cell = cells.get(index).copied().unwrap_or("");
        let Some(symbol) = cell.split_once('[').and_then(|(_, rest)| rest.split_once(']')).map(|(unit, _)| unit) else {
            return 1.0;
        };
        match unit(symbol.trim()) {
            Ok(unit) if unit.dimension.agrees(dimension) => unit.factor,
            Ok(unit) => {
                let message = format!("expected {}, found a unit of {}", dimension.phrase(), unit.dimension.phrase());
                diagnostics.push(Diagnostic::error("wrong-dimension", span, message));
                1.0
            }
            Err(why) => {
                diagnostics.push(Diagnostic::error("unknown-unit", span, why));
                1.0
            }
        }
    };
    Scale { time: factor(0, Dimension::TIME), position: factor(1, columns.position) }
}
