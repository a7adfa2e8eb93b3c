//! Frequencies, damping and shapes.

use bellcrank_results::{ModeRow, Modes};

use super::super::Escaped;
use super::super::rows::{Rows, digits, words};
use crate::number;
use crate::told::modes::{movers, ratio};

/// Modes with a row, and coordinates in it; the file has all.
const MOST: usize = 60;
const MOVERS: usize = 6;

pub(super) fn section(found: &Modes) -> String {
    let heads = ["Mode", " Frequency in Hz", " Damping ratio", " Eigenvalue in 1/s", "", "Moves most"];
    let mut rows = Rows::new(&heads);
    for (index, mode) in found.modes.iter().take(MOST).enumerate() {
        rows.push(&cells(found, index, mode));
    }
    let rest = found.modes.len().saturating_sub(MOST);
    let rest = if rest > 0 { format!(" {rest} more are in <code>modes.csv</code>.") } else { String::new() };
    format!("<h3>Modes</h3>\n<p class=\"hint\">{LEGEND}{rest}</p>\n{}", rows.html())
}

const LEGEND: &str = "Amplitudes of the joint coordinates, the largest of a mode 1 m or 1 rad. A minus is the opposite way; \
    a phase stands beside those that are neither in step nor opposite.";

fn cells(found: &Modes, index: usize, mode: &ModeRow) -> [String; 6] {
    [
        (index + 1).to_string(),
        digits(mode.frequency, 6),
        number::typeset(&ratio(mode)),
        eigenvalue(mode),
        Escaped(found.kind(mode).words()).to_string(),
        words(&movers(mode, MOVERS)),
    ]
}

/// `-0.12 ± 3.4 i`.
fn eigenvalue(mode: &ModeRow) -> String {
    let [re, im] = mode.eigenvalue;
    if im == 0.0 {
        return digits(re, 4);
    }
    format!("{} ± {} i", digits(re, 4), digits(im, 4))
}
