//! Findings as small tables of numbers and words: one file a table, for people with spreadsheets.

mod flexible;

use crate::summary::{change, rounded};
use crate::{
    BodyModes, Candidate, Check, Event, Events, Field, Findings, Modes, Optimization, Sensitivity, Sizing, Stress,
    TextTable, Tolerance, Unit, heading,
};

pub use flexible::flexible_tables;

/// The tables of a finding, each with the stem of its file: `sensitivity`, `curves`, `iterations`, ...
///
/// Designs have none: their rows were written while they were computed.
pub fn finding_tables(findings: &Findings) -> Vec<(String, TextTable)> {
    let tables = match findings {
        Findings::Sensitivity(found) => vec![("sensitivity", sensitivities(found)), ("curves", curves(found))],
        Findings::Optimization(found) => vec![
            ("variables", variables(found)),
            ("constraints", constraints(found)),
            ("iterations", iterations(found)),
            ("starts", starts(found)),
        ],
        Findings::Tolerance(found) => vec![("tolerances", tolerances(found)), ("histogram", histogram(found))],
        Findings::Modes(found) => vec![("modes", modes(found))],
        Findings::Sizing(found) => vec![("candidates", candidates(found))],
        Findings::Stress(found) => vec![("hot_spots", hot_spots(found)), ("meshes", meshes(found))],
        Findings::BodyModes(found) => vec![("frequencies", frequencies(found))],
        Findings::Designs(_) => Vec::new(),
    };
    let filled = tables.into_iter().filter(|(_, table)| !table.rows.is_empty());
    filled.map(|(stem, table)| (stem.to_owned(), table)).collect()
}

fn table<const N: usize>(heads: [String; N], rows: Vec<Vec<Field>>) -> TextTable {
    TextTable { heads: heads.to_vec(), rows }
}

fn heads<const N: usize>(names: [&str; N]) -> [String; N] {
    names.map(str::to_owned)
}

fn number(si: f64, unit: &Unit) -> Field {
    Field::Number(rounded(si, unit))
}

fn text(words: &str) -> Field {
    Field::Text(words.to_owned())
}

/// Rows of different units carry the unit in a column of its own.
fn sensitivities(found: &Sensitivity) -> TextTable {
    let rows = found.parameters.iter().map(|row| {
        vec![
            text(&row.name),
            number(row.value, &row.unit),
            text(&row.unit.symbol),
            number(row.derivative, &row.derivative_unit),
            text(&row.derivative_unit.symbol),
            Field::Number(row.relative),
            text(&row.note),
        ]
    });
    let names = ["parameter", "value", "unit", "derivative", "derivative unit", "relative", "note"];
    table(heads(names), rows.collect())
}

fn curves(found: &Sensitivity) -> TextTable {
    let with_curve = found.parameters.iter().filter_map(|row| Some((row, row.curve.as_ref()?)));
    let points = with_curve.flat_map(|(row, curve)| {
        let point = |(parameter, response): (&f64, &f64)| {
            vec![text(&row.name), number(*parameter, &row.unit), text(&row.unit.symbol), number(*response, &found.unit)]
        };
        curve.parameter.iter().zip(&curve.response).map(point).collect::<Vec<_>>()
    });
    let response = heading("response", &found.unit);
    table(["parameter".to_owned(), "value".to_owned(), "unit".to_owned(), response], points.collect())
}

fn variables(found: &Optimization) -> TextTable {
    let rows = found.variables.iter().map(|row| {
        vec![
            text(&row.name),
            number(row.start, &row.unit),
            number(row.value, &row.unit),
            Field::Number(change(row.start, row.value)),
            text(&row.unit.symbol),
            number(row.bounds.0, &row.unit),
            number(row.bounds.1, &row.unit),
            text(row.bound.unwrap_or("")),
            number(row.multiplier, &row.multiplier_unit),
            text(&row.multiplier_unit.symbol),
        ]
    });
    let names =
        ["variable", "start", "value", "change", "unit", "min", "max", "bound", "multiplier", "multiplier unit"];
    table(heads(names), rows.collect())
}

fn constraints(found: &Optimization) -> TextTable {
    let rows = found.constraints.iter().map(|row| {
        vec![
            text(&row.written),
            number(row.left.0, &row.unit),
            number(row.left.1, &row.unit),
            number(row.right, &row.unit),
            text(&row.unit.symbol),
            text(if row.active { "active" } else { "" }),
            number(row.violation, &row.unit),
            number(row.multiplier, &row.multiplier_unit),
            text(&row.multiplier_unit.symbol),
        ]
    });
    let names =
        ["constraint", "start", "left", "right", "unit", "active", "violation", "multiplier", "multiplier unit"];
    table(heads(names), rows.collect())
}

fn iterations(found: &Optimization) -> TextTable {
    let unit = &found.objective.unit;
    let rows = found.iterations.iter().map(|row| {
        vec![
            Field::Number(row.start as f64),
            Field::Number(row.iteration as f64),
            Field::Number(row.evaluations as f64),
            number(row.objective, unit),
            Field::Number(row.violation),
            Field::Number(row.optimality),
            Field::Number(row.step),
        ]
    });
    let mut names = heads(["start", "iteration", "evaluations", "", "violation", "optimality", "step"]);
    names[3] = heading("objective", unit);
    table(names, rows.collect())
}

/// One start only is told by the variables.
fn starts(found: &Optimization) -> TextTable {
    if found.starts.len() < 2 {
        return TextTable::default();
    }
    let place =
        |word: &str| found.variables.iter().map(|row| heading(&format!("{word} {}", row.name), &row.unit)).collect();
    let columns: [Vec<String>; 5] = [
        vec!["start".to_owned()],
        place("from"),
        place("to"),
        vec![heading("objective", &found.objective.unit)],
        vec!["violation".to_owned(), "status".to_owned()],
    ];
    let point = |values: &[f64]| -> Vec<Field> {
        found.variables.iter().zip(values).map(|(row, si)| number(*si, &row.unit)).collect()
    };
    let rows = found.starts.iter().map(|row| {
        let mut fields = vec![Field::Number(row.start as f64)];
        fields.extend(point(&row.from));
        fields.extend(point(&row.point));
        fields.extend([number(row.objective, &found.objective.unit), row.violation.into(), text(&row.status)]);
        fields
    });
    TextTable { heads: columns.concat(), rows: rows.collect() }
}

fn tolerances(found: &Tolerance) -> TextTable {
    let rows = found.inputs.iter().map(|row| {
        vec![
            text(&row.name),
            number(row.nominal, &row.unit),
            number(row.half_width, &row.unit),
            number(row.deviation, &row.unit),
            text(&row.unit.symbol),
            text(row.distribution),
            number(row.derivative, &row.derivative_unit),
            text(&row.derivative_unit.symbol),
            Field::Number(row.variance_share),
            Field::Number(row.worst_share),
        ]
    });
    let names = [
        "parameter",
        "nominal",
        "half width",
        "deviation",
        "unit",
        "distribution",
        "derivative",
        "derivative unit",
        "share of variance",
        "share of worst case",
    ];
    table(heads(names), rows.collect())
}

fn histogram(found: &Tolerance) -> TextTable {
    let bins = found.monte_carlo.iter().flat_map(|run| &run.histogram);
    let unit = &found.unit;
    let rows = bins.map(|bin| vec![number(bin.from, unit), number(bin.to, unit), Field::Number(bin.count as f64)]);
    table([heading("from", unit), heading("to", unit), "samples".to_owned()], rows.collect())
}

/// A row a mode; of each coordinate the size of its amplitude and its phase.
fn modes(found: &Modes) -> TextTable {
    let mut heads = heads(["mode", "frequency [Hz]", "damping", "re [1/s]", "im [1/s]", "what"]).to_vec();
    for of in found.modes.first().into_iter().flat_map(|mode| &mode.shape) {
        heads.push(heading(&of.coordinate, &of.unit));
        heads.push(format!("{} phase [deg]", of.coordinate));
    }
    let row = |(index, mode): (usize, &crate::ModeRow)| {
        let [re, im] = mode.eigenvalue;
        let numbers = [(index + 1) as f64, mode.frequency, mode.damping, re, im].map(Field::Number);
        let mut row = numbers.to_vec();
        row.push(text(&found.kind(mode).words().to_lowercase()));
        row.extend(mode.shape.iter().flat_map(|of| [of.size(), of.phase().to_degrees()].map(Field::Number)));
        row
    };
    TextTable { heads, rows: found.modes.iter().enumerate().map(row).collect() }
}

/// A row a region of a body.
fn hot_spots(found: &Stress) -> TextTable {
    let rows = found.bodies.iter().flat_map(|body| body.spots.iter().map(move |spot| (body, spot)));
    let row = |(body, spot): (&crate::StressBody, &crate::HotSpot)| {
        let mut row = vec![text(&body.body), text(&spot.region)];
        row.push(text(if spot.place.is_empty() { &body.place } else { &spot.place }));
        row.extend(spot.at.map(|x| number(x, &found.length)));
        row.extend([spot.value, spot.error, spot.principal[0], spot.principal[1]].map(|si| number(si, &found.unit)));
        row.push(Field::Number(spot.margin.unwrap_or(f64::NAN)));
        row.push(text(spot.singular.unwrap_or("")));
        row
    };
    let mut names = heads(["body", "region", "position"]).to_vec();
    names.extend(["x", "y", "z"].map(|name| heading(name, &found.length)));
    let stresses = ["von Mises", "error", "largest principal", "smallest principal"];
    names.extend(stresses.map(|name| heading(name, &found.unit)));
    names.extend(heads(["margin", "not to be trusted"]));
    TextTable { heads: names, rows: rows.map(row).collect() }
}

/// A row a mesh.
fn meshes(found: &Stress) -> TextTable {
    let rows =
        found.bodies.iter().flat_map(|body| body.meshes.iter().enumerate().map(move |(k, mesh)| (body, k, mesh)));
    let row = |(body, k, mesh): (&crate::StressBody, usize, &crate::MeshRow)| {
        vec![
            text(&body.body),
            Field::Number((k + 1) as f64),
            Field::Number(mesh.nodes as f64),
            Field::Number(mesh.elements as f64),
            text(&mesh.element),
            Field::Number(mesh.worst_jacobian),
            number(mesh.peak, &found.unit),
            Field::Number(mesh.error),
        ]
    };
    let mut names = heads(["body", "mesh", "nodes", "elements", "element", "worst scaled Jacobian", "", "error"]);
    names[6] = heading("peak", &found.unit);
    table(names, rows.map(row).collect())
}

fn frequencies(found: &BodyModes) -> TextTable {
    let rows = found.bodies.iter().flat_map(|body| {
        let row = |(k, f): (usize, &f64)| vec![text(&body.body), Field::Number((k + 1) as f64), Field::Number(*f)];
        body.frequencies.iter().enumerate().map(row).collect::<Vec<_>>()
    });
    table(heads(["body", "mode", "frequency [Hz]"]), rows.collect())
}

/// What happened, a row an event; nothing without.
pub fn event_table(events: &Events) -> Option<TextTable> {
    if events.list.is_empty() {
        return None;
    }
    let mut names: Vec<&'static str> = Vec::new();
    for (name, ..) in events.list.iter().flat_map(|event| &event.numbers) {
        if !names.contains(name) {
            names.push(name);
        }
    }
    let mut heads = vec![heading("time", &events.unit)];
    heads.extend(["event", "name", "joint", "side"].map(str::to_owned));
    heads.extend(names.iter().flat_map(|name| [(*name).to_owned(), format!("{name} unit")]));
    let rows = events.list.iter().map(|event| event_row(event, &names, &events.unit)).collect();
    Some(TextTable { heads, rows })
}

fn event_row(event: &Event, names: &[&'static str], unit: &Unit) -> Vec<Field> {
    let mut row = vec![number(event.time, unit)];
    row.extend([event.kind.word(), &event.name, &event.joint, event.side].map(text));
    for name in names {
        let found = event.numbers.iter().find(|(other, ..)| other == name);
        row.extend(match found {
            Some((_, si, unit)) => [number(*si, unit), text(&unit.symbol)],
            None => [Field::Number(f64::NAN), text("")],
        });
    }
    row
}

/// One row a check, so that a spreadsheet can filter by either.
fn candidates(found: &Sizing) -> TextTable {
    let rows = found
        .candidates
        .iter()
        .flat_map(|candidate| candidate.checks.iter().map(|check| check_row(candidate, check)).collect::<Vec<_>>());
    let names = ["candidate", "candidate passes", "check", "check passes", "needed", "available", "unit", "reason"];
    table(heads(names), rows.collect())
}

fn check_row(candidate: &Candidate, check: &Check) -> Vec<Field> {
    let word = |passes: Option<bool>| match passes {
        Some(true) => "yes",
        Some(false) => "no",
        None => "not checked",
    };
    vec![
        text(&candidate.name),
        text(word(Some(candidate.passes))),
        text(&check.key),
        text(word(check.passes)),
        number(check.needed, &check.unit),
        number(check.available, &check.unit),
        text(&check.unit.symbol),
        text(&check.reason),
    ]
}
