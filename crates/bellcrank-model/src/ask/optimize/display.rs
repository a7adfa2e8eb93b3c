//! The iterations as they run.

use bellcrank_results::Unit;
use bellcrank_study::nlp::Progress as At;

use super::sign;
use crate::ask::Asking;
use crate::design::Optimize;
use crate::progress::Progress;

/// Writes a line an iteration.
pub(super) struct Display {
    unit: Unit,
    sign: f64,
    starts: usize,
    headed: Option<usize>,
    name: String,
}

impl Display {
    pub(super) fn new(asking: &Asking<'_>, question: &Optimize) -> Display {
        let unit = match question.terms.as_slice() {
            [only] => asking.unit(only.response.value.dimension()),
            _ => Unit::one(),
        };
        let name = asking.study.name.clone();
        Display { unit, sign: sign(question.maximize), starts: question.starts, headed: None, name }
    }

    pub(super) fn row(&mut self, start: usize, at: &At, progress: &mut dyn Progress) {
        let message = format!("optimizing, iteration {}", at.iteration);
        progress.at(start as f64 / self.starts.max(1) as f64, &message);
        if self.headed != Some(start) {
            self.headed = Some(start);
            self.head(start).iter().for_each(|line| progress.line(line));
        }
        progress.line(&format!(
            "{:>5} {:>11} {:>16} {:>11.2e} {:>11.2e} {:>11.2e}",
            at.iteration,
            at.evaluations,
            digits(self.unit.show(self.sign * at.objective)),
            at.violation,
            at.optimality,
            at.step
        ));
    }

    fn head(&self, start: usize) -> Vec<String> {
        let of = if self.starts > 1 { format!(", start {} of {}", start + 1, self.starts) } else { String::new() };
        let unit = if self.unit.symbol.is_empty() { String::new() } else { format!(" [{}]", self.unit.symbol) };
        vec![
            format!("{}{of}", self.name),
            format!(
                "{:>5} {:>11} {:>16} {:>11} {:>11} {:>11}",
                "iter",
                "evaluations",
                format!("objective{unit}"),
                "violation",
                "optimality",
                "step"
            ),
        ]
    }
}

/// Eight significant digits: the last steps of a search change no more.
fn digits(value: f64) -> String {
    let power = value.abs().log10().floor();
    if value == 0.0 || !(-4.0..7.0).contains(&power) {
        return format!("{value:.7e}");
    }
    format!("{value:.*}", (7.0 - power) as usize)
}
