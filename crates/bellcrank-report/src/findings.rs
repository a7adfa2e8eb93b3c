//! What a study found, picked out of its table: drives, strokes, reactions, residuals.

use bellcrank_results::{Column, Extreme, Reductions, StudyResult};

use crate::number;

/// A column and what it comes to.
pub(crate) struct Finding<'a> {
    pub(crate) column: &'a Column,
    pub(crate) reductions: Reductions,
}

impl<'a> Finding<'a> {
    pub(crate) fn of(column: &'a Column) -> Option<Self> {
        Some(Self { column, reductions: Reductions::of(&column.values)? })
    }

    /// An SI value of this column as text with its unit.
    pub(crate) fn shown(&self, si: f64) -> String {
        number::with_unit(&number::alone(self.column.unit.show(si)), &self.column.unit.symbol)
    }

    /// Decimals that its extremes and range have in common.
    pub(crate) fn decimals(&self) -> Option<usize> {
        let found = &self.reductions;
        let shown = [found.min.value, found.max.value, found.range].map(|si| self.column.unit.show(si));
        number::shared_decimals(&shown)
    }

    /// The largest magnitude, SI.
    pub(crate) fn peak(&self) -> f64 {
        self.reductions.peak().value.abs()
    }
}

/// The finding of the signal of that name.
pub(crate) fn finding<'a>(study: &'a StudyResult, name: &str) -> Option<Finding<'a>> {
    Finding::of(study.table.column(name)?)
}

/// The joint in `joint.J.position`, `drive.J.force.1` and the like.
///
/// Joint names may hold dots themselves (subsystems), so the middle is what the ends leave over.
pub(crate) fn owner<'a>(signal: &'a str, group: &str, quantity: &str) -> Option<&'a str> {
    let rest = signal.strip_prefix(group)?.strip_prefix('.')?;
    let whole = match rest.rsplit_once('.') {
        Some((front, index)) if index.bytes().all(|b| b.is_ascii_digit()) => front,
        _ => rest,
    };
    whole.strip_suffix(quantity)?.strip_suffix('.')
}

/// Findings of all columns `group.NAME.quantity`, with the name.
pub(crate) fn family<'a>(study: &'a StudyResult, group: &str, quantity: &str) -> Vec<(&'a str, Finding<'a>)> {
    let found = |column: &'a Column| Some((owner(&column.name, group, quantity)?, Finding::of(column)?));
    study.table.columns.iter().filter_map(found).collect()
}

/// The efforts of the driven coordinates.
pub(crate) fn drives(study: &StudyResult) -> Vec<(&str, Finding<'_>)> {
    family(study, "drive", "force")
}

/// Joints of a machine let go whose ranges are shown though nothing drives them.
const MOST_FREE: usize = 8;

/// Positions of the driven joints and the swept ones: the strokes. Of a machine let go also those of its first free
/// joints: where they get to is news.
pub(crate) fn strokes(study: &StudyResult) -> Vec<Finding<'_>> {
    let driven: Vec<&str> = drives(study).into_iter().map(|(joint, _)| joint).collect();
    let mut free = if study.events.is_some() { MOST_FREE } else { 0 };
    let mut wanted = |(joint, finding): (&str, Finding<'_>)| {
        let mut moves = driven.contains(&joint) || study.axis.contains(&finding.column.name);
        if !moves && free > 0 && finding.reductions.range > 0.0 {
            free -= 1;
            moves = true;
        }
        moves.then_some(finding.column.name.clone())
    };
    let names: Vec<String> = family(study, "joint", "position").into_iter().filter_map(&mut wanted).collect();
    names.iter().filter_map(|name| finding(study, name)).collect()
}

/// Why the study stopped; the page and the summary name the study themselves.
pub(crate) fn why_stopped(study: &StudyResult) -> Option<&str> {
    let message = study.failure.as_ref()?.message.as_str();
    let rest = message.strip_prefix(&format!("study `{}`", study.name));
    Some(rest.and_then(|rest| rest.strip_prefix(", ").or(rest.strip_prefix(": "))).unwrap_or(message))
}

/// One position only, as the result of a study of statics: then there are values, not extremes.
pub(crate) fn is_single(study: &StudyResult) -> bool {
    study.table.rows() == 1
}

/// What a single position consists of: efforts of drives and holds, and where every joint is.
pub(crate) fn values(study: &StudyResult) -> Vec<Finding<'_>> {
    let efforts = drives(study).into_iter();
    efforts.chain(family(study, "joint", "position")).map(|(_, finding)| finding).collect()
}

/// Force magnitudes of all joints, strongest first.
pub(crate) fn strongest(study: &StudyResult) -> Vec<(&str, Finding<'_>)> {
    let mut found = family(study, "joint", "reaction.force");
    found.sort_by(|a, b| b.1.peak().total_cmp(&a.1.peak()));
    found
}

/// The largest reaction force of the study, N; 0 without reactions.
pub(crate) fn strongest_peak(study: &StudyResult) -> f64 {
    strongest(study).first().map_or(0.0, |(_, finding)| finding.peak())
}

/// A trust signal against its limit.
pub(crate) struct Check<'a> {
    pub(crate) title: &'static str,
    pub(crate) meaning: &'static str,
    pub(crate) finding: Finding<'a>,
    /// In the signal's own SI unit.
    pub(crate) limit: f64,
}

impl Check<'_> {
    pub(crate) fn passed(&self) -> bool {
        self.finding.peak() <= self.limit
    }
}

/// Loop-closure error up to which a position counts as assembled, m (or rad).
const CLOSURE_LIMIT: f64 = 1e-9;
/// Power-balance residual up to which forces count as consistent, relative.
const BALANCE_LIMIT: f64 = 1e-9;

/// The trust signals that the study has.
pub(crate) fn checks(study: &StudyResult) -> Vec<Check<'_>> {
    let closure = finding(study, "check.closure").map(|finding| Check {
        title: "Loop closure",
        meaning: "largest gap left in a closed loop",
        finding,
        limit: CLOSURE_LIMIT,
    });
    let balance = finding(study, "check.balance").map(|finding| Check {
        title: "Power balance",
        meaning: "power of drives and loads against the rate of energy",
        limit: BALANCE_LIMIT * balance_scale(study, &finding),
        finding,
    });
    closure.into_iter().chain(balance).collect()
}

/// A trust signal is beyond its limit, or a check of a flexible body.
pub(crate) fn is_doubtful(study: &StudyResult) -> bool {
    let bodies = study.flexible.iter().flat_map(|of| &of.bodies);
    let failed = bodies.flat_map(|body| &body.checks).any(|check| check.passed() == Some(false));
    failed || checks(study).iter().any(|check| !check.passed())
}

/// A residual in watts is judged by the power that flows; a pure number stands for itself.
fn balance_scale(study: &StudyResult, balance: &Finding<'_>) -> f64 {
    if balance.column.unit.symbol.is_empty() {
        return 1.0;
    }
    let powers = family(study, "drive", "power");
    powers.iter().map(|(_, finding)| finding.peak()).fold(f64::MIN_POSITIVE, f64::max)
}

/// Where an extreme occurs, on the axes of the study: `30 deg`, or `x = 1 mm, y = 2 mm` on several.
pub(crate) fn whereabouts(study: &StudyResult, extreme: Extreme) -> String {
    let axes: Vec<Finding<'_>> = study.axis.iter().filter_map(|name| finding(study, name)).collect();
    let place = |axis: &Finding<'_>| {
        let unit = &axis.column.unit;
        let si = axis.column.values.get(extreme.row).copied().unwrap_or(f64::NAN);
        let text = number::place(unit.show(si), unit.show(axis.reductions.range));
        let text = number::with_unit(&text, &unit.symbol);
        if axes.len() == 1 { text } else { format!("{} = {text}", axis.column.name) }
    };
    if axes.is_empty() && is_single(study) {
        return String::new();
    }
    if axes.is_empty() {
        return format!("row {}", extreme.row);
    }
    axes.iter().map(place).collect::<Vec<_>>().join(", ")
}

/// From where to where each axis runs: name and `-30 … 30 deg`.
pub(crate) fn axis_ranges(study: &StudyResult) -> Vec<(String, String)> {
    let range = |axis: Finding<'_>| {
        let unit = &axis.column.unit;
        let show = |si: f64| number::place(unit.show(si), unit.show(axis.reductions.range));
        let (from, to) = (show(axis.reductions.first), show(axis.reductions.last));
        (axis.column.name.clone(), number::with_unit(&format!("{from} … {to}"), &unit.symbol))
    };
    study.axis.iter().filter_map(|name| finding(study, name)).map(range).collect()
}

#[cfg(test)]
mod tests {
    use super::owner;

    #[test]
    fn joints_are_found_in_signal_names() {
        assert_eq!(owner("joint.B.position", "joint", "position"), Some("B"));
        assert_eq!(owner("joint.lift.B.position.1", "joint", "position"), Some("lift.B"));
        assert_eq!(owner("joint.B.reaction.force", "joint", "reaction.force"), Some("B"));
        assert_eq!(owner("joint.B.reaction.force", "joint", "force"), Some("B.reaction"));
        assert_eq!(owner("drive.B.force", "joint", "force"), None);
        assert_eq!(owner("joint.position", "joint", "position"), None);
    }
}
