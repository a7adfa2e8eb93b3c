//! The keys that studies of kind `dynamics` and `modes` have to themselves.

use bellcrank_doc::{Diagnostic, Expression, Spanned, Value, ValueKind};

use super::study_keys::Referred;
use crate::design::{Quantity, Stepping, StopWhen};
use crate::keyed::Keyed;

/// What they say; `None` where a key is absent (or wrong, and reported).
#[derive(Clone, Debug, Default)]
pub(crate) struct ForwardKeys {
    pub(crate) output_step: Option<Quantity>,
    pub(crate) tolerance: Option<Quantity>,
    pub(crate) method: Option<Stepping>,
    pub(crate) spectral_radius: Option<Quantity>,
    pub(crate) largest_step: Option<Quantity>,
    pub(crate) stop_when: Option<Vec<StopWhen>>,
    pub(crate) count: Option<usize>,
    pub(crate) equilibrium: Option<bool>,
}

impl ForwardKeys {
    /// Reads them; `beneath` are those of the study that this one is like.
    pub(crate) fn read(keyed: &Keyed<'_>, of: Referred<'_>, beneath: &ForwardKeys) -> ForwardKeys {
        let quantity = |name| keyed.quantity(name).map(|value: Expression| of.part.quantity(value));
        match keyed.kind() {
            Some("dynamics") => {
                let word = keyed.choice("method");
                let method = word.map(|word| Stepping::named(word.value));
                let keys = ForwardKeys {
                    output_step: quantity("output_step"),
                    tolerance: quantity("tolerance"),
                    method,
                    spectral_radius: quantity("spectral_radius"),
                    largest_step: quantity("largest_step"),
                    stop_when: keyed.value("stop_when").map(|value| read_stops(value, keyed, of)),
                    ..ForwardKeys::default()
                };
                refuse_radius(keyed, keys.method.or(beneath.method), word);
                refuse_largest_step(keyed);
                keys
            }
            Some("modes") => ForwardKeys {
                count: keyed.whole("count").and_then(|count| usize::try_from(count.value).ok()),
                equilibrium: keyed.boolean("equilibrium").map(|flag| flag.value),
                ..ForwardKeys::default()
            },
            _ => ForwardKeys::default(),
        }
    }

    /// These keys, and those of `beneath` where there are none. What does not go with a method or step given here is
    /// hidden.
    pub(crate) fn over(self, beneath: ForwardKeys, fixed_step: bool) -> ForwardKeys {
        let no_radius = self.method.is_some_and(|method| method != Stepping::GeneralizedAlpha);
        ForwardKeys {
            output_step: self.output_step.or(beneath.output_step),
            tolerance: self.tolerance.or(beneath.tolerance),
            method: self.method.or(beneath.method),
            spectral_radius: self.spectral_radius.or(beneath.spectral_radius.filter(|_| !no_radius)),
            largest_step: self.largest_step.or(beneath.largest_step.filter(|_| !fixed_step)),
            stop_when: self.stop_when.or(beneath.stop_when),
            count: self.count.or(beneath.count),
            equilibrium: self.equilibrium.or(beneath.equilibrium),
        }
    }
}

/// The spectral radius means something for one method only.
fn refuse_radius(keyed: &Keyed<'_>, method: Option<Stepping>, word: Option<Spanned<&str>>) {
    let Some(value) = keyed.value("spectral_radius") else { return };
    if method == Some(Stepping::GeneralizedAlpha) || keyed.has("method") && word.is_none() {
        return;
    }
    let message = format!("{} goes with `method = \"generalized-alpha\"`", keyed.named("spectral_radius"));
    let report = Diagnostic::error("conflicting-keys", value.span, message);
    keyed.report(match word {
        Some(word) => report.also(word.span, "another method"),
        None => report.hint("write `method = \"generalized-alpha\"`, or leave it out"),
    });
}

fn refuse_largest_step(keyed: &Keyed<'_>) {
    if let (Some(value), Some(step)) = (keyed.value("largest_step"), keyed.value("step")) {
        let message = format!("{} has a fixed `step`, so `largest_step` has no place", keyed.what());
        keyed.report(Diagnostic::error("conflicting-keys", value.span, message).also(step.span, "the fixed step"));
    }
}

/// One condition, or a list of them.
fn read_stops(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Vec<StopWhen> {
    let what = keyed.named("stop_when");
    let all = match &value.kind {
        ValueKind::List(_) => of.part.reader.list(value, &what).unwrap_or_default(),
        _ => std::slice::from_ref(value),
    };
    all.iter().filter_map(|one| read_stop(one, &what, of)).collect()
}

fn read_stop(value: &Value, what: &str, of: Referred<'_>) -> Option<StopWhen> {
    let condition = of.condition(value, what)?;
    let span = condition.left.span().to(condition.right.span());
    let written = condition.left.written().trim().to_owned();
    let (left, right) = (of.part.quantity(condition.left), of.part.quantity(condition.right));
    let stop = StopWhen { left, comparison: condition.comparison, right, written, span };
    if [&stop.left, &stop.right].iter().all(|side| side.expression.signals().is_empty()) {
        let message = format!("{what} never changes: `{}` has no signal in it", stop.written);
        let hint = "compare a signal, as `joint.slide.position > 200 mm`, or shorten `duration`";
        of.part.reader.report(Diagnostic::error("no-signal", span, message).hint(hint));
        return None;
    }
    Some(stop)
}
