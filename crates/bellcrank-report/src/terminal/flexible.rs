//! Flexible bodies: hot spots over the rows, and checks that failed.

use bellcrank_results::{FlexibleBodies, FlexibleBody, SpotHistory};

use super::grid::{Cell, Grid};
use crate::number;
use crate::told::flexible::{repeats, with_error};

/// Rows of a body; the report has them all.
const MOST_ROWS: usize = 12;

pub(super) fn tables(found: &FlexibleBodies) -> Vec<Grid> {
    vec![hot_spots(found), failed(found)]
}

/// Those that mean nothing say so.
fn hot_spots(found: &FlexibleBodies) -> Grid {
    let mut grid = Grid::new(["hot spot", "largest von Mises", "margin", "life", "at"]);
    for body in &found.bodies {
        for spot in body.spots.iter().take(MOST_ROWS) {
            grid.push(row(found, body, spot));
        }
        if let Some(rest) = body.spots.len().checked_sub(MOST_ROWS).filter(|rest| *rest > 0) {
            grid.push(vec![Cell::left(&format!("and {rest} more regions in the report"))]);
        }
    }
    grid
}

fn row(found: &FlexibleBodies, body: &FlexibleBody, spot: &SpotHistory) -> Vec<Cell> {
    let margin = spot.margin.map_or_else(String::new, |margin| number::significant(margin, 3));
    let said = spot.singular.map_or_else(|| spot.place.clone(), |why| format!("NOT TO BE TRUSTED, {why}"));
    vec![
        Cell::left(&format!("{} {}", body.body, spot.region)),
        Cell::right(&with_error(spot, found)),
        Cell::right(&margin),
        Cell::right(&spot.fatigue.as_ref().map_or_else(String::new, repeats)),
        Cell::left(&said),
    ]
}

fn failed(found: &FlexibleBodies) -> Grid {
    let mut grid = Grid::new(["reduction", "FAILED check", "value", "limit"]);
    for body in &found.bodies {
        for check in body.checks.iter().filter(|check| check.passed() == Some(false)) {
            let limit = check.limit.map_or_else(String::new, |limit| number::significant(limit, 2));
            let value = number::significant(check.value, 2);
            grid.push(vec![
                Cell::left(&body.body),
                Cell::left(&check.meaning),
                Cell::right(&value),
                Cell::right(&limit),
            ]);
        }
    }
    grid
}
