//! Machines drawn at random.

use bellcrank_results::{HistogramBin, MonteCarlo, Unit, Yield};
use bellcrank_study::sampling::unit;
use bellcrank_study::statistics::{Histogram, Limits, Moments, Sorted, freedman_diaconis, wilson};

use super::All;
use super::machines::Machines;
use crate::design::Tolerance;
use crate::run::shown;

/// Responses kept for quantiles and the histogram: those of the first machines. Moments and the yield are of all.
const KEPT: u64 = 1_000_000;
/// Probabilities of the quantiles; the outer ones are those of ± 3 standard deviations of a normal distribution.
const QUANTILES: [f64; 7] = [0.00135, 0.01, 0.05, 0.5, 0.95, 0.99, 0.99865];
/// Bins of the histogram at most.
const BINS: usize = 60;
/// Confidence of the interval of the yield.
const CONFIDENCE: f64 = 0.95;
/// Differences of more standard errors than these are not chance ...
const SURE: f64 = 3.0;
/// ... and matter above this share of the standard deviation: for the deviation itself, and for the mean.
const MATTERS: (f64, f64) = (0.02, 0.05);
/// Reasons told at most.
const REASONS: usize = 3;

/// What machines drawn at random came to.
#[derive(Default)]
pub(super) struct Drawn {
    /// How many were drawn.
    pub(super) count: u64,
    /// Of those with a response.
    pub(super) moments: Moments,
    kept: Vec<f64>,
    good: u64,
    failed: u64,
    /// Reasons that differ in more than their numbers: sample, message.
    reasons: Vec<(u64, String)>,
}

/// Draws the machines: number i depends on the seed and i alone.
pub(super) fn draw(machines: &mut Machines<'_, '_>, question: &Tolerance, limits: &Limits) -> Drawn {
    let (inputs, seed) = (machines.inputs, question.seed);
    let deviations = |sample: u64| {
        let deviation = |(i, input): (usize, &super::Input)| input.distribution.deviation(unit(seed, sample, i as u64));
        inputs.iter().enumerate().map(deviation).collect()
    };
    let mut drawn = Drawn::default();
    machines.each(question.samples, "drawing machines", deviations, |sample, answer| {
        drawn.count += 1;
        match answer {
            Ok(value) => drawn.take(value, limits),
            Err(why) => drawn.note(sample, why.message),
        }
    });
    drawn
}

impl Drawn {
    fn take(&mut self, value: f64, limits: &Limits) {
        self.moments.push(value);
        self.good += u64::from(limits.holds(value));
        if self.count <= KEPT {
            self.kept.push(value);
        }
    }

    fn note(&mut self, sample: u64, message: String) {
        self.failed += 1;
        let key = |text: &str| text.replace(|c: char| c.is_ascii_digit() || ".+-e".contains(c), "");
        let known = self.reasons.iter().any(|(_, other)| key(other) == key(&message));
        if !known && self.reasons.len() < REASONS {
            self.reasons.push((sample, message));
        }
    }

    pub(super) fn told(&self, question: &Tolerance, limits: &Limits) -> MonteCarlo {
        let sorted = Sorted::new(self.kept.clone());
        let asked = limits.lower.is_some() || limits.upper.is_some();
        let within = wilson(self.good, self.count, CONFIDENCE);
        let moments = &self.moments;
        MonteCarlo {
            samples: self.count,
            seed: question.seed,
            failed: self.failed,
            mean: (moments.mean(), moments.mean_error()),
            deviation: (moments.sigma(), moments.sigma_error()),
            range: (moments.least(), moments.greatest()),
            quantiles: QUANTILES.iter().map(|&p| (p, sorted.quantile(p))).collect(),
            histogram: histogram(&sorted),
            within: asked.then_some(Yield { share: within.estimate, interval: (within.low, within.high) }),
        }
    }

    /// What a reader should know about the sample, and about the linear estimate beside it.
    pub(super) fn warnings(&self, all: &All<'_, '_>, exact: Option<(f64, f64)>) -> Vec<String> {
        let unit = all.asking.unit(all.question.response.value.dimension());
        let mut warnings: Vec<String> = self.failures(all).into_iter().collect();
        warnings.extend(self.beyond(all, exact, &unit));
        warnings.extend(self.off(all.linear.sigma, &unit));
        warnings.extend(self.shifted(all.linear.nominal, &unit));
        warnings
    }

    fn failures(&self, all: &All<'_, '_>) -> Option<String> {
        let asked = all.limits.lower.is_some() || all.limits.upper.is_some();
        let outside = if asked { ", which counts as outside the limits" } else { "" };
        let reasons: Vec<String> =
            self.reasons.iter().map(|(sample, message)| format!("machine {sample}: {message}")).collect();
        let message = format!(
            "{} of {} machines gave no result{outside}, and are not in mean and deviation; {}",
            self.failed,
            self.count,
            reasons.join("; ")
        );
        (self.failed > 0).then_some(message)
    }

    /// Corners are the worst case of what rises or falls with each dimension all the way; a sample beyond them says
    /// that this does not.
    fn beyond(&self, all: &All<'_, '_>, exact: Option<(f64, f64)>, unit: &Unit) -> Option<String> {
        let (low, high) = exact.filter(|_| all.inputs.iter().all(super::Input::is_bounded))?;
        let (least, greatest) = (self.moments.least(), self.moments.greatest());
        let slack = 1e-9 * (high - low);
        (least < low - slack || greatest > high + slack).then(|| {
            format!(
                "the worst case is not at the ends of the tolerances: machines between them reach {} to {}",
                shown(least, unit),
                shown(greatest, unit)
            )
        })
    }

    /// The linear standard deviation, where it is wrong by more than chance and by an amount that matters.
    fn off(&self, linear: f64, unit: &Unit) -> Option<String> {
        let (sigma, error) = (self.moments.sigma(), self.moments.sigma_error());
        let off = linear - sigma;
        // Not so for a NaN, of which a warning tells already.
        let matters = off.abs() > SURE * error && off.abs() > MATTERS.0 * sigma;
        matters.then(|| {
            format!(
                "the linear estimate of the standard deviation is off by {:.2} %: {} instead of {} ± {}; trust the drawn \
                 machines",
                100.0 * off / sigma,
                shown(linear, unit),
                shown(sigma, unit),
                shown(error, unit)
            )
        })
    }

    /// A mean that the linear estimate, which has it at the nominal value, does not explain.
    fn shifted(&self, nominal: f64, unit: &Unit) -> Option<String> {
        let (mean, error, sigma) = (self.moments.mean(), self.moments.mean_error(), self.moments.sigma());
        let shift = mean - nominal;
        let matters = shift.abs() > SURE * error && shift.abs() > MATTERS.1 * sigma;
        matters.then(|| {
            format!(
                "the mean lies {} ± {} from the nominal value, which the linear estimate does not see: the response \
                 is curved",
                shown(shift, unit),
                shown(error, unit)
            )
        })
    }
}

fn histogram(sorted: &Sorted) -> Vec<HistogramBin> {
    let ends = (sorted.quantile(0.0), sorted.quantile(1.0));
    let Some(mut bins) = Histogram::new(ends.0, ends.1, freedman_diaconis(sorted, BINS)) else { return Vec::new() };
    sorted.values().iter().for_each(|x| bins.push(*x));
    let edges = bins.edges();
    let bin = |(ends, &count): (&[f64], &u64)| HistogramBin { from: ends[0], to: ends[1], count };
    edges.windows(2).zip(bins.counts()).map(bin).collect()
}
