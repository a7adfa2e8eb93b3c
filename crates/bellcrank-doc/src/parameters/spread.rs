//! How the value of a parameter scatters: tolerance, distribution, standard deviation.

use super::Parameter;
use crate::fields::quoted;
use crate::{Diagnostic, Diagnostics, Entry, Expression, Table, ValueKind, nearest};

/// How the real values of a parameter lie about the one that is written. Data only: what a study
/// makes of it is the study's.
///
/// The convention of the keys: `uniform` is even over value ± half width; `normal` has standard
/// deviation `sigma`, or half width/3 where that is not given; `truncated` is the same cut off at
/// ± half width. Without a `distribution` the study chooses.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Spread {
    /// Tolerance: the value lies within ± this. SI, not negative.
    pub half_width: Option<f64>,
    /// Shape.
    pub distribution: Option<Distribution>,
    /// Standard deviation. SI, not negative.
    pub sigma: Option<f64>,
}

/// The shape of a scatter.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Distribution {
    /// Even over the tolerance.
    Uniform,
    /// Normal, without bounds.
    Normal,
    /// Normal, cut off at the tolerance.
    Truncated,
}

const DISTRIBUTIONS: [(&str, Distribution); 3] =
    [("uniform", Distribution::Uniform), ("normal", Distribution::Normal), ("truncated", Distribution::Truncated)];

impl Distribution {
    /// As a file writes it.
    #[must_use]
    pub fn name(self) -> &'static str {
        DISTRIBUTIONS.iter().find(|(_, distribution)| *distribution == self).map_or("", |(name, _)| name)
    }

    /// The distribution of a name.
    #[must_use]
    pub fn named(name: &str) -> Option<Distribution> {
        DISTRIBUTIONS.iter().find(|(known, _)| *known == name).map(|(_, distribution)| *distribution)
    }
}

/// The key `distribution` of a parameter's table.
pub(super) fn distribution(entry: &Entry, details: &Table, diagnostics: &mut Diagnostics) -> Option<Distribution> {
    let written = details.get("distribution")?;
    let found = match &written.value.kind {
        ValueKind::String(text) => Distribution::named(&text.value),
        ValueKind::Faulty => return None,
        _ => {
            let message = format!("`distribution` needs a string, found {}", written.value.describe());
            diagnostics.push(Diagnostic::error("wrong-type", written.value.span, message));
            return None;
        }
    };
    match (found, details.get("sigma")) {
        (None, _) => {
            let name = written.value.as_str().unwrap_or("");
            let message = format!("`distribution` of parameter `{}` cannot be `{name}`", entry.key);
            let names = DISTRIBUTIONS.map(|(name, _)| name);
            let error = Diagnostic::error("unknown-choice", written.value.span, message);
            let error = error.did_you_mean(nearest(name, names));
            diagnostics.push(error.hint(format!("known: {}", quoted(&names))));
        }
        (Some(Distribution::Uniform), Some(sigma)) => {
            let message = format!("parameter `{}` is uniform and cannot have a `sigma`", entry.key);
            let error = Diagnostic::error("tolerance", sigma.key_span, message);
            let hint = "a uniform distribution is as wide as the tolerance; `sigma` goes with `normal` and `truncated`";
            diagnostics.push(error.also(written.value.span, "uniform").hint(hint));
        }
        _ => {}
    }
    found
}

/// Reports a tolerance or a standard deviation that is negative or no number.
pub(super) fn judge(parameter: &Parameter, diagnostics: &mut Diagnostics) {
    let name = &parameter.name;
    let limits = &parameter.limits;
    let widths = [
        ("tolerance", &limits.tolerance, parameter.spread.half_width),
        ("`sigma`", &limits.sigma, parameter.spread.sigma),
    ];
    for (what, expression, value) in widths {
        let Some((span, value)) = expression.as_ref().map(Expression::span).zip(value) else { continue };
        if !value.is_finite() {
            let message = format!("the {what} of `{name}` is {value}, not a finite number");
            diagnostics.push(Diagnostic::error("not-finite", span, message));
        } else if value < 0.0 {
            let message = format!("the {what} of `{name}` is negative");
            diagnostics.push(Diagnostic::error("tolerance", span, message).hint("it is a width: 0 or more"));
        }
    }
}
