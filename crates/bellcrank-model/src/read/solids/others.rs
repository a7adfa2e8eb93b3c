//! Bodies of revolution, and solids from files.

use std::path::Path;
use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Dimension, Span, Spanned, unit};

use super::files;
use super::form::FormReader;
use crate::design::{FileForm, RevolvedForm, SolidForm, Spot};
use crate::keyed::Keyed;
use crate::read::PartReader;

/// Keys of links that have no meaning here.
const OF_LINKS: [&str; 3] = ["thickness", "fillet", "plane"];

pub(super) fn revolved(reader: &mut FormReader<'_>, keyed: &Keyed<'_>) -> Option<SolidForm> {
    refuse(keyed, &OF_LINKS, "a body of revolution has none");
    refuse(keyed, &["unit"], "it belongs to a `file`");
    let inner = keyed.table("revolved")?;
    let at = match inner.value("at") {
        Some(value) => reader.spot(value, &inner.named("at"), reader.part.space()),
        None => Some(Spot::At(Vec::new())),
    };
    let axis = match inner.has("axis") {
        true => inner.axis("axis").map(|axis| reader.part.direction(axis)),
        false => Some(PartReader::z(inner.span())),
    };
    let span = inner.value("profile").map_or(inner.span(), |value| value.span);
    let pairs = inner.pairs("profile");
    if let Some(found) = pairs.as_ref().map(Vec::len).filter(|&found| found < 3) {
        let message = format!("{} needs three corners or more, found {found}", inner.named("profile"));
        inner.report(Diagnostic::error("wrong-length", span, message));
        return None;
    }
    inner.finish();
    let profile = pairs?.into_iter().map(|pair| pair.map(|one| reader.part.quantity(one))).collect();
    Some(SolidForm::Revolved(RevolvedForm { at: at?, axis: axis?, profile, profile_span: span }))
}

fn refuse(keyed: &Keyed<'_>, names: &[&'static str], why: &str) {
    for name in names.iter().filter(|name| keyed.has(name)) {
        let span = keyed.value(name).map_or(keyed.span(), |value| value.span);
        let message = format!("{} has no meaning here: {why}", keyed.named(name));
        keyed.report(Diagnostic::error("conflicting-keys", span, message).hint("leave it out"));
    }
}

pub(super) fn file(reader: &FormReader<'_>, keyed: &Keyed<'_>) -> Option<SolidForm> {
    refuse(keyed, &OF_LINKS, "a file has its own form");
    let file = keyed.text("file")?;
    let ending = Path::new(file.value).extension().map(|ending| ending.to_string_lossy().to_lowercase());
    let path = reader.part.part.folder.join(file.value);
    let mesh = match ending.as_deref() {
        Some("step" | "stp") => {
            refuse(keyed, &["unit"], "a STEP file says its own");
            files::part(&path)
        }
        Some(ending @ ("inp" | "msh")) => files::mesh(&path, ending, scale(keyed)?),
        _ => {
            let message = format!("{} ends in none of `.inp`, `.msh`, `.step`, `.stp`", keyed.named("file"));
            Err(vec![Diagnostic::error("unknown-choice", file.span, message)])
        }
    };
    match mesh {
        Ok(mesh) => Some(SolidForm::File(FileForm { mesh: Arc::new(mesh), file: file.value.to_owned() })),
        Err(reports) => {
            // What is wrong in the file is told where the model names it.
            reports.into_iter().for_each(|report| keyed.report(placed(report, file.span)));
            None
        }
    }
}

fn placed(report: Diagnostic, span: Span) -> Diagnostic {
    let primary = report.primary.or_else(|| Diagnostic::error("", span, "").primary);
    Diagnostic { primary, ..report }
}

/// Meshes have no unit of their own.
fn scale(keyed: &Keyed<'_>) -> Option<f64> {
    let Some(Spanned { value, span }) = keyed.text("unit") else {
        if !keyed.has("unit") {
            let message = format!("`unit` is missing in {}", keyed.what());
            let hint = "a mesh does not say what its numbers are counted in: `unit = \"mm\"` or `unit = \"m\"`";
            keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
        }
        return None;
    };
    match unit(value) {
        Ok(unit) if unit.dimension == Dimension::LENGTH => Some(unit.factor),
        Ok(unit) => {
            let message =
                format!("{} needs a unit of a length, found one of {}", keyed.named("unit"), unit.dimension.phrase());
            keyed.report(Diagnostic::error("wrong-dimension", span, message));
            None
        }
        Err(why) => {
            keyed.report(Diagnostic::error("unknown-unit", span, why));
            None
        }
    }
}
