//! How far results move with more modes and finer meshes.

use bellcrank_results::{Convergence, Ladder, Over, Rung};

use super::grid::{Cell, Grid};
use super::paint::{Ink, clean};
use super::{Page, Style};
use crate::number;

/// What a study of convergence found, for a terminal.
///
/// For each ladder a table with every watched number and its change against the finest setting, and the coarsest setting
/// that is enough; where not even the finest can be trusted, that is said.
pub fn terminal_convergence(found: &Convergence, style: &Style) -> String {
    let page = Page { style };
    let tolerance = number::percent(found.tolerance);
    let name = style.paint(Ink::Bold, &clean(&found.study));
    let mut text = format!("{name}  {}, convergence within {tolerance}\n", clean(&found.kind));
    for ladder in &found.ladders {
        text.push('\n');
        text.push_str(&table(found, ladder).text(style));
        text.push_str(&page.verdict(found, ladder));
    }
    for note in &found.notes {
        text.push_str(&page.note("note", Ink::Yellow, note));
    }
    text
}

fn table(found: &Convergence, ladder: &Ladder) -> Grid {
    let head = match ladder.over {
        Over::Modes => "modes of each body",
        Over::Mesh => "sizes of elements",
    };
    let mut grid = Grid::new([head, "nodes", "number", "value", "against the finest"]);
    for (place, rung) in ladder.rungs.iter().enumerate() {
        let mut first = [setting(ladder.over, rung.setting), nodes(rung)];
        for (index, watched) in found.quantities.iter().enumerate() {
            let Some(value) = rung.values.get(index).copied().flatten() else { continue };
            let value = number::with_unit(&number::significant(watched.unit.show(value), 5), &watched.unit.symbol);
            let change = match ladder.change(place, index) {
                _ if rung.failure.is_some() => "STOPPED EARLY".to_owned(),
                Some(change) => number::change(change),
                None => String::new(),
            };
            let [setting, nodes] = std::mem::take(&mut first);
            grid.push(vec![
                Cell::left(&setting),
                Cell::right(&nodes),
                Cell::left(&watched.name),
                Cell::right(&value),
                Cell::right(&change),
            ]);
        }
    }
    grid
}

fn setting(over: Over, setting: f64) -> String {
    match over {
        Over::Modes => format!("{setting}"),
        Over::Mesh => format!("x {setting}"),
    }
}

fn nodes(rung: &Rung) -> String {
    if rung.nodes == 0 { String::new() } else { rung.nodes.to_string() }
}

impl Page<'_> {
    fn verdict(&self, found: &Convergence, ladder: &Ladder) -> String {
        let mut text = String::new();
        for rung in &ladder.rungs {
            let told = |why: &String| format!("{}: {why}", in_words(ladder.over, rung.setting));
            text.push_str(
                &rung.failure.as_ref().map_or_else(String::new, |why| self.note("stopped", Ink::Red, &told(why))),
            );
        }
        if let Some(why) = &ladder.ended {
            text.push_str(&self.note("no finer setting", Ink::Yellow, why));
        }
        let Some(finest) = ladder.rungs.last() else { return text };
        let last = in_words(ladder.over, finest.setting);
        let tolerance = number::percent(found.tolerance);
        match ladder.enough(found.tolerance).map(|place| in_words(ladder.over, ladder.rungs[place].setting)) {
            Some(enough) => {
                let sentence = format!("Enough: {enough}. From there on every number is within {tolerance} of {last}.");
                text + &self.line(&sentence)
            }
            None => text + &self.note("NOT CONVERGED", Ink::Red, &why_not(ladder, &last, &tolerance)),
        }
    }
}

/// What the finest setting cannot be compared with, or how far it is from the one before.
fn why_not(ladder: &Ladder, last: &str, tolerance: &str) -> String {
    let Some(before) = ladder.rungs.len().checked_sub(2) else {
        return format!("there is nothing to compare {last} with");
    };
    let other = in_words(ladder.over, ladder.rungs[before].setting);
    match ladder.largest(before) {
        Some(change) => {
            let more = match ladder.over {
                Over::Modes => "more `modes` in the file make the ladder longer",
                Over::Mesh => {
                    "smaller sizes in the file's `mesh` make finer ladders; a stress that keeps growing belongs to a sharp edge"
                }
            };
            format!("{last} and {other} differ by {}, more than {tolerance}; {more}", number::percent(change))
        }
        None => format!("{last} and {other} do not have the same numbers to compare"),
    }
}

fn in_words(over: Over, setting: f64) -> String {
    match over {
        Over::Modes if setting == 0.0 => "no modes".to_owned(),
        Over::Modes if setting == 1.0 => "1 mode of each body".to_owned(),
        Over::Modes => format!("{setting} modes of each body"),
        Over::Mesh if setting == 1.0 => "the sizes of the file".to_owned(),
        Over::Mesh => format!("sizes x {setting}"),
    }
}
