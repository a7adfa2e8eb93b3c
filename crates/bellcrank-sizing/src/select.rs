//! All candidates in order, and the one to take.

use crate::{Check, Verdict};

/// Something that was checked against a duty.
pub trait Candidate {
    /// Its name in the catalogue.
    fn name(&self) -> &str;
    /// Its checks, the most important first.
    fn checks(&self) -> &[Check];
    /// How big it is, the most important number first; smaller is cheaper.
    fn size(&self) -> [f64; 3];

    /// No check fails.
    fn passes(&self) -> bool {
        self.checks().iter().all(|check| check.verdict != Verdict::Fails)
    }
    /// The checks that fail.
    fn failures(&self) -> Vec<&Check> {
        self.checks().iter().filter(|check| check.verdict == Verdict::Fails).collect()
    }
    /// The check that leaves least, or is missed most.
    fn tightest(&self) -> Option<&Check> {
        let checked = self.checks().iter().filter(|check| check.verdict != Verdict::NotChecked);
        checked.rev().max_by(|a, b| a.utilization().total_cmp(&b.utilization()))
    }
}

/// All candidates: those that pass first, smallest first; then the others, the one first whose worst check is missed by
/// least.
#[derive(Clone, Debug, PartialEq)]
pub struct Selection<C> {
    /// In order.
    pub candidates: Vec<C>,
}

impl<C: Candidate> Selection<C> {
    pub(crate) fn new(mut candidates: Vec<C>) -> Selection<C> {
        candidates.sort_by(|a, b| {
            let missed = || if a.passes() { std::cmp::Ordering::Equal } else { missed(a).total_cmp(&missed(b)) };
            b.passes().cmp(&a.passes()).then_with(missed).then_with(|| by_size(a, b))
        });
        Selection { candidates }
    }
    /// The smallest that passes; it stands first.
    pub fn chosen(&self) -> Option<&C> {
        self.candidates.first().filter(|candidate| candidate.passes())
    }
    /// Of those that fail, the one whose worst check is missed by least; the smaller of two equals.
    pub fn nearest(&self) -> Option<&C> {
        self.candidates.iter().find(|candidate| !candidate.passes())
    }
    /// What to say of the outcome in one sentence.
    pub fn summary(&self) -> String {
        match (self.chosen(), self.nearest()) {
            (Some(chosen), _) => format!("`{}` is the smallest that passes", chosen.name()),
            (None, Some(nearest)) => {
                let reasons: Vec<&str> = nearest.failures().iter().map(|check| check.reason.as_str()).collect();
                format!("none passes; `{}` comes nearest: {}", nearest.name(), reasons.join("; "))
            }
            (None, None) => "there was nothing to choose from".to_owned(),
        }
    }
}

/// How much more than there is the worst check needs.
fn missed<C: Candidate>(candidate: &C) -> f64 {
    candidate.tightest().map_or(f64::INFINITY, Check::utilization)
}

fn by_size<C: Candidate>(a: &C, b: &C) -> std::cmp::Ordering {
    let pairs = a.size().into_iter().zip(b.size());
    pairs.fold(std::cmp::Ordering::Equal, |order, (a, b)| order.then(a.total_cmp(&b)))
}
