//! The estimate by exact derivatives.

use bellcrank_study::statistics::{linear_sigma, linear_worst_case, variance_shares};

use super::inputs::Input;
use crate::ask::Asking;
use crate::trial::{Piece, Trial, Undefined};

/// Extremes whose values differ by less than this share are the same.
const TIED: f64 = 1e-9;
/// Derivatives that differ by less than this share are the same.
const SAME: f64 = 1e-6;

/// A response as a linear function of the deviations; SI.
#[derive(Clone, Debug)]
pub(super) struct Linear {
    pub(super) nominal: f64,
    /// By input; NaN where it is not defined.
    pub(super) gradient: Vec<f64>,
    /// The response at other local extremes.
    pub(super) others: Vec<Piece>,
    /// Standard deviation.
    pub(super) sigma: f64,
    /// Greatest deviation.
    pub(super) reach: f64,
    pub(super) variance_shares: Vec<f64>,
    pub(super) worst_shares: Vec<f64>,
}

impl Linear {
    /// At the design that the trial ran last, with what a reader should know about it.
    pub(super) fn of(
        asking: &Asking<'_>,
        inputs: &[Input],
        nominal: f64,
        trial: &mut Trial<'_>,
    ) -> (Linear, Vec<String>) {
        let by: Vec<usize> = inputs.iter().map(|input| input.parameter).collect();
        let mut warnings = Vec::new();
        let (gradient, others) = match trial.gradients(&by).map(|mut all| all.swap_remove(0)) {
            Ok(derived) => {
                let gradient = derived.active.gradient;
                warnings.extend(undefined(asking, inputs, &gradient, trial.is_ambiguous(0)));
                (gradient.into_iter().map(|g| if g.is_finite() { g } else { f64::NAN }).collect(), derived.others)
            }
            Err(why) => {
                warnings.push(no_derivatives(&why));
                (vec![f64::NAN; inputs.len()], Vec::new())
            }
        };
        let linear = Linear::with(nominal, gradient, others, inputs);
        warnings.extend(linear.kink(inputs));
        (linear, warnings)
    }

    fn with(nominal: f64, gradient: Vec<f64>, others: Vec<Piece>, inputs: &[Input]) -> Linear {
        // What does not move has no part in it, whatever its derivative.
        let acting: Vec<f64> =
            gradient.iter().zip(inputs).map(|(g, input)| if input.moves() { *g } else { 0.0 }).collect();
        let sigmas: Vec<f64> = inputs.iter().map(|input| input.distribution.sigma()).collect();
        let widths = widths(inputs);
        let reach = linear_worst_case(&acting, &widths);
        let worst_share = |(g, t): (&f64, &f64)| if reach == 0.0 { 0.0 } else { (g * t).abs() / reach };
        Linear {
            nominal,
            sigma: linear_sigma(&acting, &sigmas),
            variance_shares: variance_shares(&acting, &sigmas),
            worst_shares: acting.iter().zip(&widths).map(worst_share).collect(),
            reach,
            gradient,
            others,
        }
    }

    /// How far a piece and the present one part within the tolerances.
    fn parting(&self, piece: &Piece, widths: &[f64]) -> f64 {
        let part = |((a, b), t): ((&f64, &f64), &f64)| {
            if (a - b).abs() > SAME * a.abs().max(b.abs()) { (a - b).abs() * t } else { 0.0 }
        };
        piece.gradient.iter().zip(&self.gradient).zip(widths).map(part).sum()
    }

    /// Whether another extreme may take over within the tolerances.
    fn kink(&self, inputs: &[Input]) -> Option<String> {
        let widths = widths(inputs);
        let gap = |piece: &Piece| (piece.value - self.nominal).abs();
        let near: Vec<&Piece> = self.others.iter().filter(|piece| self.parting(piece, &widths) > gap(piece)).collect();
        let tied = near.iter().any(|piece| gap(piece) <= TIED * self.nominal.abs());
        match (near.is_empty(), tied) {
            (true, _) => None,
            (_, true) => Some(
                "two positions have the same extreme here, each with other derivatives: the linear estimate follows one \
                 of them, and holds on one side only"
                    .to_owned(),
            ),
            _ => Some(
                "within the tolerances another position can become the extreme: the linear estimate follows the present \
                 one only"
                    .to_owned(),
            ),
        }
    }
}

/// The worst case by the derivatives is wrong by a share of it that is worth a word.
const MATTERS: f64 = 0.1;

/// The worst case by the derivatives beside that at the corners, where they part.
pub(super) fn beside_the_corners(linear: &Linear, exact: (f64, f64)) -> Option<String> {
    let (low, high) = (linear.nominal - linear.reach, linear.nominal + linear.reach);
    let off = (low - exact.0).abs().max((high - exact.1).abs());
    // Not so for a NaN, of which a warning tells already. Rounding is no difference.
    let matters = off > MATTERS * (exact.1 - exact.0) && off > TIED * linear.nominal.abs();
    matters.then(|| {
        "the worst case by the derivatives is off by more than 10 % of its width: trust the one evaluated at the corners"
            .to_owned()
    })
}

pub(super) fn widths(inputs: &[Input]) -> Vec<f64> {
    inputs.iter().map(|input| input.width).collect()
}

fn no_derivatives(why: &Undefined) -> String {
    format!("there is no linear estimate, as the derivatives cannot be computed: {}", why.message)
}

fn undefined(asking: &Asking<'_>, inputs: &[Input], gradient: &[f64], ambiguous: bool) -> Option<String> {
    let bad = inputs.iter().zip(gradient).filter(|(input, g)| input.moves() && !g.is_finite());
    let names: Vec<String> = bad.map(|(input, _)| format!("`{}`", asking.parameter(input.parameter).name)).collect();
    let why = if ambiguous {
        "equilibrium alone does not determine this reaction"
    } else {
        "the response has a kink here, or redundant loops do not close with one dimension changed alone"
    };
    let message =
        format!("there is no linear estimate: the response has no derivative by {} ({why})", names.join(", "));
    (!names.is_empty()).then_some(message)
}
