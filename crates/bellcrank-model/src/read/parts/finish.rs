//! From the keys of a study to what it does; what the bodies lack is reported.

use bellcrank_doc::{Diagnostic, Entry, Span, Spanned};

use super::PartKeys;
use crate::design::{At, BodyModes, Hinges, PartQuestion, Parts, SolidForm, StressForm};
use crate::elastic::ENDS;
use crate::read::study_keys::Referred;

/// Modes of a body unless given.
const MODES: usize = 10;

/// The study; `None` after an error.
pub(crate) fn parts(entry: &Entry, kind: &str, keys: PartKeys, of: Referred<'_>) -> Option<Parts> {
    let own = |key: &str| entry.value.as_table().is_some_and(|table| table.get(key).is_some());
    let Some(bodies) = keys.bodies else {
        if !own("body") && !own("bodies") {
            let message = format!("`body` is missing in study `{}`", entry.key);
            let hint = "the body whose solid is analysed: `body = \"NAME\"`";
            of.part.reader.report(Diagnostic::error("missing-key", entry.key_span, message).hint(hint));
        }
        return None;
    };
    let before = of.part.reader.errors();
    let checked = Checked { of, entry };
    bodies.iter().for_each(|body| checked.body(*body));
    let named = |name: &Spanned<String>| bodies.iter().for_each(|body| checked.set(body.value, name));
    let question = if kind == "modes" {
        let fixed = keys.fixed.unwrap_or_default();
        fixed.iter().for_each(named);
        PartQuestion::Modes(BodyModes { count: keys.count.unwrap_or(MODES), fixed })
    } else {
        if let (Some(_), None) = (&keys.at, &keys.of)
            && !own("of")
        {
            let message = format!("study `{}` has `at`, but no study `of` that it would be a position of", entry.key);
            of.part.reader.report(Diagnostic::error("missing-key", entry.key_span, message));
        }
        let (supports, loads) = (keys.supports.unwrap_or_default(), keys.loads.unwrap_or_default());
        supports.iter().for_each(|support| named(&support.set));
        loads.iter().filter_map(|load| load.set.as_ref()).for_each(named);
        if keys.of.is_none() && loads.is_empty() && supports.is_empty() && !own("of") && !own("loads") {
            let message = format!("study `{}` has nothing that loads the body", entry.key);
            let hint = "the loads of a position: `of = \"STUDY\"`; or `[studies.NAME.loads.NAME]`";
            of.part.reader.report(Diagnostic::error("missing-key", entry.key_span, message).hint(hint));
        }
        PartQuestion::Stress(Box::new(StressForm {
            of: keys.of.map(|of| of.value),
            at: keys.at.unwrap_or(At::Worst),
            hinges: keys.hinges.unwrap_or(Hinges::Bearing),
            accuracy: keys.accuracy,
            supports,
            loads,
        }))
    };
    let sound = of.part.reader.errors() == before;
    let bodies = bodies.into_iter().map(|body| body.value).collect();
    sound.then(|| Parts { bodies, mesh: keys.mesh.unwrap_or_default(), question })
}

struct Checked<'a> {
    of: Referred<'a>,
    entry: &'a Entry,
}

impl Checked<'_> {
    fn report(&self, code: &'static str, span: Span, message: String, hint: String) {
        self.of.part.reader.report(Diagnostic::error(code, span, message).hint(hint));
    }

    /// It needs a solid, and its material what makes it elastic.
    fn body(&self, body: Spanned<usize>) {
        let machine = self.of.machine;
        let Some(of) = machine.bodies.get(body.value) else { return };
        let Some(solid) = of.solid.as_ref().and_then(|worn| machine.solids.get(worn.solid)) else {
            // One whose points are missing has been reported, and has none here; its mass is not from numbers.
            if of.mass.is_some() || self.of.part.reader.errors() == 0 {
                let message = format!("body `{}` has no solid to make a mesh of", of.name);
                let hint = "give it one: `solid = \"NAME\"`, and its form in `[solids.NAME]`".to_owned();
                self.report("no-solid", body.span, message, hint);
            }
            return;
        };
        let Some(material) = solid.material.and_then(|material| machine.materials.get(material)) else { return };
        if material.elastic.is_none() && !material.faulty {
            let message = format!(
                "material `{}` has no `young` and `poisson`, which study `{}` needs",
                material.name, self.entry.key
            );
            let hint = "steel: `young = \"210 GPa\"` and `poisson = 0.3`".to_owned();
            let report = Diagnostic::error("missing-key", material.span, message).also(body.span, "needed here");
            self.of.part.reader.report(report.hint(hint));
        }
    }

    /// Of a link the sets are known before the mesh is made.
    fn set(&self, body: usize, name: &Spanned<String>) {
        let machine = self.of.machine;
        let worn = machine.bodies.get(body).and_then(|body| body.solid.as_ref());
        let Some(SolidForm::Link(link)) = worn.and_then(|worn| machine.solids.get(worn.solid)).map(|solid| &solid.form)
        else {
            return;
        };
        let mut known: Vec<String> = link.eyes.iter().map(|eye| format!("bore.{}", eye.name)).collect();
        known.extend(["surface", "top", "bottom"].map(str::to_owned));
        known.extend(ENDS.iter().flatten().map(|name| (*name).to_owned()));
        let full = format!("bore.{}", name.value);
        if known.contains(&name.value) || known.contains(&full) {
            return;
        }
        let message = format!("body `{}` has no set `{}`", machine.bodies[body].name, name.value);
        let near = bellcrank_doc::nearest(&name.value, known.iter().map(String::as_str));
        let hint = match near {
            Some(near) => format!("did you mean `{near}`?"),
            None => format!("its sets are {}", known.join(", ")),
        };
        self.report("unknown-name", name.span, message, hint);
    }
}
