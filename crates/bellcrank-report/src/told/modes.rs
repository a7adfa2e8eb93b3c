//! How a machine rings, in words.

use bellcrank_results::{ModeKind, ModeRow, Modes};

use super::listed;
use crate::number;

pub(super) fn sentences(found: &Modes) -> Vec<String> {
    let of = |kind| found.modes.iter().filter(move |mode| found.kind(mode) == kind);
    let where_ = if found.at_equilibrium { "about equilibrium" } else { "about the position as assembled" };
    let mut first = match of(ModeKind::Oscillation).next() {
        Some(slowest) => {
            let frequency = number::with_unit(&number::alone(slowest.frequency), "Hz");
            format!("The slowest oscillation {where_} has {frequency}, {}", damping(slowest.damping))
        }
        None if found.all == 0 => "Nothing can move, so there are no modes".to_owned(),
        None => format!("Nothing oscillates {where_}"),
    };
    first.push('.');
    let kinds = [
        (ModeKind::Oscillation, "oscillates", "oscillate"),
        (ModeKind::Decay, "decays", "decay"),
        (ModeKind::Drift, "moves freely", "move freely"),
        (ModeKind::Growth, "grows", "grow"),
    ];
    let part = |(kind, one, many)| match of(kind).count() {
        0 => None,
        1 => Some(format!("1 {one}")),
        count => Some(format!("{count} {many}")),
    };
    let parts: Vec<String> = kinds.into_iter().filter_map(part).collect();
    let told = if found.modes.len() < found.all {
        format!("{} of {} modes are listed", found.modes.len(), found.all)
    } else {
        let plural = if found.all == 1 { "" } else { "s" };
        format!("{} mode{plural}", found.all)
    };
    let free = if found.freedom == 1 { "1 degree".to_owned() } else { format!("{} degrees", found.freedom) };
    let second = (found.all > 0).then(|| format!("{told} of {free} of freedom: {}.", listed(&parts)));
    std::iter::once(first).chain(second).collect()
}

fn damping(ratio: f64) -> String {
    if ratio.abs() < 1e-9 { "undamped".to_owned() } else { format!("damping ratio {}", number::significant(ratio, 4)) }
}

/// The damping ratio as a cell; rounding is not shown as damping.
pub(crate) fn ratio(mode: &ModeRow) -> String {
    if mode.damping.abs() < 1e-9 { "0".to_owned() } else { number::significant(mode.damping, 4) }
}

/// Coordinates that take most part, as `hinge 1 rad, slide -0.2 m`; with a phase where it is not 0 or half a turn.
pub(crate) fn movers(mode: &ModeRow, most: usize) -> String {
    let mut shape: Vec<_> = mode.shape.iter().filter(|of| of.size() > 1e-3).collect();
    shape.sort_by(|a, b| b.size().total_cmp(&a.size()));
    let one = |of: &&bellcrank_results::ShapeRow| {
        let [re, im] = of.amplitude;
        let in_line = im.abs() <= 1e-3 * of.size();
        let size = if in_line { re } else { of.size() };
        let amplitude = number::with_unit(&number::significant(size, 3), &of.unit.symbol);
        let phase = of.phase().to_degrees();
        let phase = if in_line { String::new() } else { format!(" at {} deg", number::significant(phase, 3)) };
        format!("{} {amplitude}{phase}", of.coordinate)
    };
    shape.iter().take(most).map(one).collect::<Vec<_>>().join(", ")
}
