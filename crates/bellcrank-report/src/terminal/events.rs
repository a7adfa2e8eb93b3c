//! What happened during a study: the first of it.

use bellcrank_results::Events;

use super::grid::{Cell, Grid};
use crate::told::{events, shown};

/// Events of a table; the report has more, `events.csv` all.
const MOST: usize = 8;

pub(super) fn table(of: &Events) -> Grid {
    let mut grid = Grid::new(["at", "event", "of", "where", ""]);
    for event in of.list.iter().take(MOST) {
        grid.push(vec![
            Cell::right(&shown(event.time, &of.unit)),
            Cell::left(event.kind.word()),
            Cell::left(&event.name),
            Cell::left(&events::whereabouts(event)),
            Cell::left(&events::numbers(event)),
        ]);
    }
    let rest = of.count().saturating_sub(MOST);
    if rest > 0 {
        let plural = if rest == 1 { "" } else { "s" };
        grid.push(vec![Cell::left(&format!("and {rest} more event{plural} in the report"))]);
    }
    grid
}
