//! Sobol' indices: shares of the variance that hold for any response, not only a linear one.

use bellcrank_results::SobolIndices;
use bellcrank_study::statistics::{Saltelli, SensitivityIndex};

use super::Input;
use super::machines::Machines;
use crate::design::Tolerance;

/// Base samples at most; a study with n dimensions needs (n + 2) machines for each.
const MOST: u64 = 4096;
/// Base samples of a study that draws no machines otherwise.
const ALONE: u64 = 1024;
/// Bootstrap samples for the standard errors.
const RESAMPLES: usize = 100;

/// The machines to try. Sobol' points are evenest in powers of two, so it is one: the greatest within `samples`.
pub(super) fn plan(question: &Tolerance, inputs: &[Input]) -> Saltelli {
    let wanted = if question.samples == 0 { ALONE } else { question.samples.min(MOST) };
    Saltelli::new(1 << wanted.ilog2(), inputs.len(), question.seed)
}

/// The indices of each input; `None` when stopped.
pub(super) fn found(
    machines: &mut Machines<'_, '_>,
    plan: &Saltelli,
    warnings: &mut Vec<String>,
) -> Option<Vec<SobolIndices>> {
    let inputs = machines.inputs;
    let deviations = |row: u64| {
        let point = plan.point(row).unwrap_or_default();
        inputs.iter().zip(point).map(|(input, u)| input.distribution.deviation(u)).collect()
    };
    let mut results = Vec::with_capacity(plan.rows() as usize);
    machines.each(plan.rows(), "machines for Sobol' indices", deviations, |_, answer| {
        results.push(answer.unwrap_or(f64::NAN));
    });
    if machines.stopped {
        return None;
    }
    let failed = results.iter().filter(|value| value.is_nan()).count();
    if failed > 0 {
        warnings.push(format!(
            "Sobol' indices are of those machines that have a result; {failed} of {} have none",
            plan.rows()
        ));
    }
    let index = |index: SensitivityIndex| SobolIndices {
        first: (index.first, index.first_error),
        total: (index.total, index.total_error),
    };
    Some(plan.indices(&results, RESAMPLES).into_iter().map(index).collect())
}
