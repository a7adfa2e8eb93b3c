//! Designs from a CSV file: a column a parameter, its unit in the header, a line a design.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Diagnostics, ParameterSet, SourceId, Sources, Span, Spanned, Unit, unit};

use super::given::unknown_parameter;
use crate::design::{Levels, Varied};
use crate::keyed::Keyed;
use crate::read::study_keys::Referred;

/// Faults of one table that are told.
const MOST: usize = 5;

/// Designs of a table.
#[derive(Clone, Debug)]
pub(crate) struct DesignTable {
    pub(super) vary: Vec<Varied>,
    pub(super) names: Vec<String>,
    /// SI, in the order of `vary`.
    pub(super) rows: Arc<Vec<Vec<f64>>>,
}

/// The table that the key names; what is wrong with it is said in the file.
pub(super) fn read_designs(keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Spanned<DesignTable>> {
    let file = keyed.text("table")?;
    let path = of.part.part.folder.join(file.value);
    let parameters = of.part.reader.parameters();
    match (of.designs)(&path, file.span, parameters) {
        Ok(designs) => Some(Spanned { value: designs, span: file.span }),
        Err(reports) => {
            reports.into_iter().for_each(|report| keyed.report(report));
            None
        }
    }
}

type Cell<'t> = Spanned<&'t str>;

/// A line that holds something.
struct Line<'t> {
    cells: Vec<Cell<'t>>,
    span: Span,
}

struct Column {
    varied: Varied,
    name: String,
    unit: Unit,
}

/// Reads a table; what is wrong with it is reported in its text.
pub(crate) fn design_table(
    sources: &Sources,
    id: SourceId,
    parameters: &ParameterSet,
    diagnostics: &mut Diagnostics,
) -> Option<DesignTable> {
    let before = diagnostics.errors();
    let mut lines = lines(sources.text(id), id);
    let Some(header) = lines.next() else {
        diagnostics.push(Diagnostic::error("short-table", Span::new(id, 0, 0), "this table is empty").hint(HEADER));
        return None;
    };
    let columns = columns(&header.cells, parameters, diagnostics)?;
    let mut rows = Vec::new();
    for line in lines {
        rows.extend(row(&line, &columns, diagnostics));
        if diagnostics.errors() > before + MOST {
            break;
        }
    }
    if diagnostics.errors() > before {
        return None;
    }
    if rows.is_empty() {
        let message = "this table has no designs, only a header";
        diagnostics.push(Diagnostic::error("short-table", header.span, message));
        return None;
    }
    let names = columns.iter().map(|column| column.name.clone()).collect();
    let vary = columns.into_iter().map(|column| column.varied).collect();
    Some(DesignTable { vary, names, rows: Arc::new(rows) })
}

const HEADER: &str = "the first line names parameters and their units, as `l31 [mm],l5 [mm]`";

/// Lines that hold something, in cells. Blank lines and lines that start with `#` do not count; `;` and tabs
/// separate, too.
fn lines(text: &str, id: SourceId) -> impl Iterator<Item = Line<'_>> {
    let mut offset = 0;
    let placed = text.split_inclusive('\n').map(move |line| {
        let start = offset;
        offset += line.len();
        (start, line.trim_end())
    });
    let filled = placed.filter(|(_, line)| !line.trim().is_empty() && !line.starts_with('#'));
    filled.map(move |(start, line)| Line {
        cells: cells(line, start, id),
        span: Span::new(id, start, start + line.len()),
    })
}

fn cells(line: &str, start: usize, id: SourceId) -> Vec<Cell<'_>> {
    let separator = [';', '\t', ','].into_iter().find(|&c| line.contains(c)).unwrap_or(',');
    let mut offset = start;
    let cell = |cell: &'_ str| {
        let before = cell.len() - cell.trim_start().len();
        let span = Span::new(id, offset + before, offset + before + cell.trim().len());
        offset += cell.len() + 1;
        span
    };
    let spans: Vec<Span> = line.split(separator).map(cell).collect();
    let texts = line.split(separator).map(|cell| cell.trim().trim_matches('"').trim());
    texts.zip(spans).map(|(value, span)| Spanned { value, span }).collect()
}

fn columns(header: &[Cell<'_>], parameters: &ParameterSet, diagnostics: &mut Diagnostics) -> Option<Vec<Column>> {
    let read: Vec<Option<Column>> = header.iter().map(|cell| column(*cell, parameters, diagnostics)).collect();
    for (i, column) in read.iter().enumerate() {
        let Some(column) = column else { continue };
        let first = read[..i].iter().flatten().find(|before| before.varied.parameter == column.varied.parameter);
        if let Some(first) = first {
            let message = format!("`{}` has two columns", column.name);
            let report = Diagnostic::error("duplicate-name", column.varied.span, message);
            diagnostics.push(report.also(first.varied.span, "first here"));
            return None;
        }
    }
    read.into_iter().collect()
}

fn column(cell: Cell<'_>, parameters: &ParameterSet, diagnostics: &mut Diagnostics) -> Option<Column> {
    let (name, symbol) = match cell.value.split_once('[') {
        Some((name, rest)) => (name.trim(), rest.split_once(']').map_or(rest, |(unit, _)| unit).trim()),
        None => (cell.value, ""),
    };
    if name.is_empty() || name.parse::<f64>().is_ok() {
        let message = match name {
            "" => "this column has no name".to_owned(),
            number => format!("expected the name of a parameter, found the number {number}"),
        };
        diagnostics.push(Diagnostic::error("bad-table", cell.span, message).hint(HEADER));
        return None;
    }
    let Some(index) = parameters.index(name) else {
        // One that is there, but wrong, has been told.
        if !parameters.is_faulty(name) {
            diagnostics.push(unknown_parameter(parameters, name, cell.span));
        }
        return None;
    };
    let parameter = parameters.all().get(index)?;
    let fault = |message: String| Diagnostic::error("wrong-dimension", cell.span, message);
    let found = match symbol {
        "" if parameter.dimension.is_none() => Ok(Unit { factor: 1.0, offset: 0.0, dimension: parameter.dimension }),
        "" => Err(fault(format!("column `{name}` has no unit")).hint(format!(
            "write `{name} [{}]`",
            parameter.unit_as_written().filter(|unit| !unit.is_empty()).unwrap_or_else(|| parameter.dimension.unit())
        ))),
        symbol => match unit(symbol) {
            Ok(unit) if unit.dimension.agrees(parameter.dimension) => Ok(unit),
            Ok(unit) => Err(fault(format!(
                "column `{name}` needs {}, found {}",
                parameter.dimension.phrase(),
                unit.dimension.phrase()
            ))
            .also(parameter.span, format!("`{name}` is defined here"))),
            Err(message) => Err(Diagnostic::error("unknown-unit", cell.span, message)),
        },
    };
    let unit = found.map_err(|report| diagnostics.push(report)).ok()?;
    let varied = Varied { parameter: index, span: cell.span, levels: Levels::List(Vec::new()) };
    Some(Column { varied, name: name.to_owned(), unit })
}

fn row(line: &Line<'_>, columns: &[Column], diagnostics: &mut Diagnostics) -> Option<Vec<f64>> {
    if line.cells.len() != columns.len() {
        let plural = if columns.len() == 1 { "" } else { "s" };
        let message = format!(
            "expected {} number{plural}, as many as the header has columns; found {}",
            columns.len(),
            line.cells.len()
        );
        diagnostics.push(Diagnostic::error("bad-table", line.span, message));
        return None;
    }
    let mut values = Vec::with_capacity(columns.len());
    for (cell, column) in line.cells.iter().zip(columns) {
        match cell.value.parse::<f64>() {
            Ok(value) if value.is_finite() => values.push(column.unit.to_si(value)),
            Ok(_) => diagnostics.push(Diagnostic::error("not-finite", cell.span, "a table holds finite numbers only")),
            Err(_) => {
                let report = Diagnostic::error("bad-table", cell.span, not_a_number(cell.value, column));
                let comma = cell.value.replace(',', ".").parse::<f64>().is_ok();
                diagnostics.push(if comma { report.hint("decimals stand behind a point") } else { report });
            }
        }
    }
    (values.len() == columns.len()).then_some(values)
}

fn not_a_number(found: &str, column: &Column) -> String {
    match found {
        "" => format!("column `{}` is empty here", column.name),
        found => format!("column `{}` needs a number, found `{found}`", column.name),
    }
}
