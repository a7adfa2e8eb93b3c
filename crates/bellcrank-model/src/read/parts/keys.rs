//! The keys that studies of kind `stress`, and those of kind `modes` with a body, have to themselves.

use bellcrank_doc::{Diagnostic, Entry, Spanned, Value, ValueKind};

use super::acting;
use crate::design::{Accuracy, At, Hinges, LoadForm, MeshForm, SupportForm};
use crate::keyed::Keyed;
use crate::read::PartReader;
use crate::read::study_keys::Referred;

/// Meshes after the first, unless given.
const REFINEMENTS: usize = 4;
/// An error that can be reached.
const FINEST: f64 = 1e-4;

/// What they say; `None` where a key is absent (or wrong, and reported).
#[derive(Clone, Debug, Default)]
pub(crate) struct PartKeys {
    /// Where the study names bodies, and which.
    pub(crate) bodies: Option<Vec<Spanned<usize>>>,
    pub(crate) of: Option<Spanned<String>>,
    pub(crate) at: Option<At>,
    pub(crate) hinges: Option<Hinges>,
    pub(crate) accuracy: Option<Accuracy>,
    pub(crate) mesh: Option<MeshForm>,
    pub(crate) supports: Option<Vec<SupportForm>>,
    pub(crate) loads: Option<Vec<LoadForm>>,
    pub(crate) count: Option<usize>,
    pub(crate) fixed: Option<Vec<Spanned<String>>>,
}

impl PartKeys {
    pub(crate) fn read(keyed: &Keyed<'_>, of: Referred<'_>) -> PartKeys {
        match keyed.kind() {
            Some("stress") => PartKeys {
                bodies: bodies(keyed, of),
                of: keyed.text("of").map(owned),
                at: keyed.value("at").and_then(|value| at(value, keyed, of)),
                hinges: keyed.choice("hinges").map(|word| Hinges::named(word.value)),
                accuracy: keyed.table("stress").and_then(accuracy),
                mesh: keyed.table("mesh").map(|table| mesh(table, of.part)),
                supports: named(keyed, "supports", |entry| acting::support(entry, keyed, of)),
                loads: named(keyed, "loads", |entry| acting::load(entry, keyed, of)),
                ..PartKeys::default()
            },
            Some("modes") => PartKeys {
                bodies: bodies(keyed, of),
                mesh: keyed.table("mesh").map(|table| mesh(table, of.part)),
                count: keyed.whole("modes").and_then(|count| usize::try_from(count.value).ok()),
                fixed: keyed.texts("fixed").map(|names| names.into_iter().map(owned).collect()),
                ..PartKeys::default()
            },
            _ => PartKeys::default(),
        }
    }

    /// These keys, and those of `beneath` where there are none.
    pub(crate) fn over(self, beneath: PartKeys) -> PartKeys {
        PartKeys {
            bodies: self.bodies.or(beneath.bodies),
            of: self.of.or(beneath.of),
            at: self.at.or(beneath.at),
            hinges: self.hinges.or(beneath.hinges),
            accuracy: self.accuracy.or(beneath.accuracy),
            mesh: self.mesh.or(beneath.mesh),
            supports: self.supports.or(beneath.supports),
            loads: self.loads.or(beneath.loads),
            count: self.count.or(beneath.count),
            fixed: self.fixed.or(beneath.fixed),
        }
    }
}

pub(super) fn owned(text: Spanned<&str>) -> Spanned<String> {
    Spanned { value: text.value.to_owned(), span: text.span }
}

/// `body` or `bodies`.
fn bodies(keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Vec<Spanned<usize>>> {
    let several = keyed.kind() == Some("stress");
    let one = keyed.text("body");
    let all = if several { keyed.texts("bodies") } else { None };
    if several && let (Some(one), Some(other)) = (keyed.value("body"), keyed.value("bodies")) {
        let message = format!("{} has `body` and `bodies`; give one", keyed.what());
        keyed.report(Diagnostic::error("conflicting-keys", other.span, message).also(one.span, "and this"));
        return None;
    }
    let names = one.map(|one| vec![one]).or(all)?;
    if names.is_empty() {
        let span = keyed.value("bodies").map_or(keyed.span(), |value| value.span);
        let message = format!("{} names no body", keyed.named("bodies"));
        keyed.report(Diagnostic::error("wrong-length", span, message));
        return None;
    }
    let found: Vec<Option<Spanned<usize>>> = names.into_iter().map(|name| body(name, keyed, of)).collect();
    found.into_iter().collect()
}

fn body(name: Spanned<&str>, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<Spanned<usize>> {
    match of.machine.body_names.find(name.value, of.part.prefix(), "body", name.span) {
        Ok(0) => {
            let message = "the ground has no solid: it does not deform";
            keyed.report(Diagnostic::error("no-solid", name.span, message));
            None
        }
        Ok(body) => Some(Spanned { value: body, span: name.span }),
        Err(report) => {
            keyed.report(*report);
            None
        }
    }
}

/// A word, the number of a row, or a signal and its value.
fn at(value: &Value, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<At> {
    let what = keyed.named("at");
    match &value.kind {
        ValueKind::Faulty => None,
        ValueKind::Integer(_) => {
            let row = of.part.reader.integer(value, &what, 0..=1_000_000)?;
            Some(At::Row(usize::try_from(row.value).ok()?))
        }
        ValueKind::Table(_) => nearest(value, &what, keyed, of),
        _ => match of.part.reader.one_of(value, &what, &["worst", "all"])?.value {
            "all" => Some(At::All),
            _ => Some(At::Worst),
        },
    }
}

fn nearest(value: &Value, what: &str, keyed: &Keyed<'_>, of: Referred<'_>) -> Option<At> {
    let entries: Vec<&Entry> = value.as_table()?.iter().collect();
    let [entry] = entries.as_slice() else {
        let message = format!("{what} needs one signal and its value, found {}", entries.len());
        let hint = "as `at = { \"joint.B.position\" = \"-30 deg\" }`";
        keyed.report(Diagnostic::error("wrong-length", value.span, message).hint(hint));
        return None;
    };
    let Some(signal) = of.catalogue.find(&entry.key) else {
        let message = format!("there is no signal `{}`", entry.key);
        let near =
            bellcrank_doc::nearest(&entry.key, of.catalogue.names().collect::<Vec<_>>().iter().map(String::as_str))
                .map(str::to_owned);
        keyed.report(Diagnostic::error("unknown-name", entry.key_span, message).did_you_mean(near.as_deref()));
        return None;
    };
    let column = of.catalogue.column(signal)?;
    let value =
        of.part.reader.quantity(&entry.value, &format!("`{}` in {what}", entry.key), column.measure.dimension())?;
    Some(At::Nearest { signal: column.name, value: of.part.quantity(value) })
}

/// `"3 %"` or a number; how many meshes it may take.
fn accuracy(keyed: Keyed<'_>) -> Option<Accuracy> {
    let error = share(&keyed, "accuracy");
    let refinements = keyed.whole("refinements");
    keyed.finish();
    let refinements = refinements.and_then(|count| usize::try_from(count.value).ok()).unwrap_or(REFINEMENTS);
    Some(Accuracy { error: error?, refinements })
}

fn share(keyed: &Keyed<'_>, name: &'static str) -> Option<f64> {
    let value = keyed.value(name)?;
    let percent = value.as_str().and_then(|text| text.trim().strip_suffix('%'));
    let error = match (percent, &value.kind) {
        (Some(number), _) => number.trim().parse::<f64>().ok().map(|percent| percent / 100.0),
        (None, ValueKind::Faulty) => return None,
        (None, _) => keyed.quantity(name)?.as_constant(),
    };
    if let Some(error) = error.filter(|error| (FINEST..1.0).contains(error)) {
        return Some(error);
    }
    let message = format!("{} must be a number from {FINEST} to 1, or a percentage", keyed.named(name));
    keyed.report(Diagnostic::error("out-of-range", value.span, message).hint("as `accuracy = \"3 %\"`"));
    None
}

/// Sizes of elements.
pub(crate) fn mesh(keyed: Keyed<'_>, part: PartReader<'_>) -> MeshForm {
    let quantity = |name| keyed.quantity(name).map(|value| part.quantity(value));
    let form = MeshForm {
        size: quantity("size"),
        bores: quantity("bores"),
        fillets: quantity("fillets"),
        layers: keyed.whole("layers").and_then(|layers| usize::try_from(layers.value).ok()),
        tetrahedra: keyed.choice("element").is_some_and(|word| word.value == "tet10"),
        scale: None,
    };
    keyed.finish();
    form
}

/// A table of named tables; each is read, and those that are wrong are left out: the model is refused anyway.
fn named<T>(keyed: &Keyed<'_>, name: &'static str, read: impl Fn(&Entry) -> Option<T>) -> Option<Vec<T>> {
    let value = keyed.value(name)?;
    let fields = keyed.reader().fields(value, &keyed.named(name))?;
    Some(fields.table().iter().filter_map(read).collect())
}
