//! Tables of the flexible bodies of a study.

use super::{heads, number, text};
use crate::{Field, FlexibleBodies, FlexibleBody, SpotHistory, TextTable, heading};

/// The tables of the flexible bodies, each with the stem of its file.
pub fn flexible_tables(found: &FlexibleBodies) -> Vec<(String, TextTable)> {
    let tables = [("flexible_hot_spots", spots(found)), ("flexible_modes", modes(found))];
    let filled = tables.into_iter().filter(|(_, table)| !table.rows.is_empty());
    filled.map(|(stem, table)| (stem.to_owned(), table)).collect()
}

/// A row a region of a body.
fn spots(found: &FlexibleBodies) -> TextTable {
    let all = found.bodies.iter().flat_map(|body| body.spots.iter().map(move |spot| (body, spot)));
    let mut names = heads(["body", "region", "position"]).to_vec();
    names.extend(["x", "y", "z"].map(|name| heading(name, &found.length)));
    let stresses = ["von Mises", "error", "largest principal", "smallest principal", "amplitude", "mean"];
    names.extend(stresses.map(|name| heading(name, &found.unit)));
    names.extend(heads(["margin", "cycles", "damage of a repeat", "life in repeats", "signal", "not to be trusted"]));
    TextTable { heads: names, rows: all.map(|(body, spot)| row(found, body, spot)).collect() }
}

fn row(found: &FlexibleBodies, body: &FlexibleBody, spot: &SpotHistory) -> Vec<Field> {
    let bare = |value: Option<f64>| Field::Number(value.unwrap_or(f64::NAN));
    let stress = |value: Option<f64>| number(value.unwrap_or(f64::NAN), &found.unit);
    let fatigue = spot.fatigue;
    let mut row = vec![text(&body.body), text(&spot.region), text(&spot.place)];
    row.extend(spot.at.map(|x| number(x, &found.length)));
    row.extend([Some(spot.value), spot.error, Some(spot.principal[0]), Some(spot.principal[1])].map(stress));
    row.extend([fatigue.map(|of| of.amplitude), fatigue.map(|of| of.mean)].map(stress));
    row.extend([spot.margin, fatigue.map(|of| of.cycles), fatigue.map(|of| of.damage)].map(bare));
    row.push(bare(fatigue.and_then(|of| of.life)));
    row.extend([text(&spot.signal), text(spot.singular.unwrap_or(""))]);
    row
}

/// A row a mode with the interfaces held.
fn modes(found: &FlexibleBodies) -> TextTable {
    let rows = found.bodies.iter().flat_map(|body| {
        let row = |(index, mode): (usize, &crate::KeptMode)| {
            let numbers = [(index + 1) as f64, mode.frequency, mode.damping].map(Field::Number);
            [vec![text(&body.body)], numbers.to_vec()].concat()
        };
        body.modes.iter().enumerate().map(row).collect::<Vec<_>>()
    });
    TextTable { heads: heads(["body", "mode", "frequency [Hz]", "damping"]).to_vec(), rows: rows.collect() }
}
