//! The key `flexible` of a body.

use bellcrank_doc::{Diagnostic, Reader, Span, Spanned};

use super::parts::mesh;
use super::{Machine, PartReader};
use crate::build::MOST_MODES;
use crate::design::{Body, Flexible, Force, Kept, MeshForm, Quantity, holds};
use crate::keyed::{Keyed, Switch};

/// Modes of a solid unless given.
const MODES: usize = 10;
/// At most so many where a frequency says which.
const ALL_MODES: usize = 200;

/// What a body says of its deformation, before it is known what takes hold of it.
#[derive(Debug)]
pub(crate) struct Deforming {
    /// Place in the list of bodies.
    body: usize,
    span: Span,
    /// Keys `solid` or `beam` are there, right or wrong.
    has_form: bool,
    interfaces: Option<Vec<Spanned<String>>>,
    reference: Option<Spanned<String>>,
    modes: Option<Spanned<usize>>,
    frequency: Option<Quantity>,
    coupling: Option<Spanned<bool>>,
    damping: Option<Quantity>,
    stiffening: Option<Spanned<bool>>,
    mesh: Option<(Span, MeshForm)>,
    segments: Option<Spanned<usize>>,
}

impl Deforming {
    /// Of a body of the machine.
    pub(super) fn of(self, body: usize) -> Deforming {
        Deforming { body, ..self }
    }

    /// Place in the list of bodies.
    pub(super) fn body(&self) -> usize {
        self.body
    }
}

/// Reads the key; `None` for a rigid body.
pub(super) fn read(part: PartReader<'_>, keyed: &Keyed<'_>, body: &Body) -> Option<Deforming> {
    let switch = keyed.switch("flexible")?;
    let span = keyed.value("flexible").map_or(body.span, |value| value.span);
    let has_form = keyed.has("solid") || keyed.has("beam");
    let plain = Deforming {
        body: 0,
        span,
        has_form,
        interfaces: None,
        reference: None,
        modes: None,
        frequency: None,
        coupling: None,
        damping: None,
        stiffening: None,
        mesh: None,
        segments: None,
    };
    match switch {
        Switch::Flag(false) => None,
        Switch::Flag(true) => Some(plain),
        Switch::Table(table) => Some(said(part, table, plain)),
    }
}

fn said(part: PartReader<'_>, table: Keyed<'_>, plain: Deforming) -> Deforming {
    let owned = |name: Spanned<&str>| Spanned { value: name.value.to_owned(), span: name.span };
    let whole = |name| {
        let count = table.whole(name)?;
        Some(Spanned { value: usize::try_from(count.value).ok()?, span: count.span })
    };
    let quantity = |name| table.quantity(name).map(|value| part.quantity(value));
    let span = |name| table.value(name).map_or(plain.span, |value| value.span);
    let read = Deforming {
        interfaces: table.texts("interfaces").map(|names| names.into_iter().map(owned).collect()),
        reference: table.text("reference").map(owned),
        modes: whole("modes"),
        frequency: quantity("frequency"),
        coupling: table.choice("coupling").map(|word| Spanned { value: word.value == "rigid", span: word.span }),
        damping: quantity("damping"),
        stiffening: table.boolean("stiffening"),
        mesh: table.table("mesh").map(|sizes| (span("mesh"), mesh(sizes, part))),
        segments: whole("segments"),
        ..plain
    };
    table.finish();
    read
}

/// Settles what bodies leave open by what takes hold of them; what they lack is reported.
pub(super) fn fit(reader: &Reader<'_>, machine: &mut Machine, forces: &[Force]) {
    for form in std::mem::take(&mut machine.deforming) {
        let body = form.body;
        let mut fitting = Fitting { reader, machine, form: &form, sound: true };
        let flexible = fitting.flexible(forces);
        let sound = fitting.sound;
        machine.bodies[body].flexible = flexible.filter(|_| sound);
    }
}

/// One body while it is settled.
struct Fitting<'a> {
    reader: &'a Reader<'a>,
    machine: &'a Machine,
    form: &'a Deforming,
    sound: bool,
}

impl Fitting<'_> {
    fn body(&self) -> &Body {
        &self.machine.bodies[self.form.body]
    }

    fn report(&mut self, report: Diagnostic) {
        self.sound = false;
        self.reader.report(report);
    }

    fn fault(&mut self, code: &'static str, span: Span, message: String, hint: &str) {
        self.report(Diagnostic::error(code, span, message).hint(hint));
    }

    fn flexible(&mut self, forces: &[Force]) -> Option<Flexible> {
        self.has_form()?;
        self.elastic();
        self.fitting_keys();
        let interfaces = self.interfaces(forces)?;
        let reference = self.reference(&interfaces)?;
        let is_rod = self.body().rod.is_some();
        let form = self.form;
        let usual = match &form.frequency {
            Some(_) if is_rod => MOST_MODES,
            Some(_) => ALL_MODES,
            None if is_rod => 0,
            None => MODES,
        };
        let count = form.modes.as_ref().map_or(usual, |modes| modes.value);
        if interfaces.len() == 1 && count == 0 && !is_rod {
            let span = form.modes.as_ref().map_or(form.span, |modes| modes.span);
            let message = format!("body `{}` has one interface and no modes: nothing of it deforms", self.body().name);
            self.fault("no-deformation", span, message, "keep some `modes`, or name a second interface");
        }
        Some(Flexible {
            span: form.span,
            interfaces,
            reference,
            modes: Kept { count, frequency: form.frequency.clone() },
            rigid: form.coupling.as_ref().is_some_and(|coupling| coupling.value),
            damping: form.damping.clone(),
            stiffening: form.stiffening.as_ref().map_or(is_rod, |flag| flag.value),
            mesh: form.mesh.as_ref().map(|(_, mesh)| mesh.clone()).unwrap_or_default(),
            segments: form.segments.as_ref().map_or(1, |segments| segments.value),
        })
    }

    /// A solid or a beam; where one is wrong, that has been told.
    fn has_form(&mut self) -> Option<()> {
        let body = self.body();
        if body.solid.is_some() || body.rod.is_some() {
            return Some(());
        }
        if !self.form.has_form {
            let message = format!("body `{}` is flexible, but has no solid and no beam", body.name);
            let hint = "give it one: `solid = \"NAME\"` or `beam = \"NAME\"`; what deforms needs a form and a material";
            self.fault("no-solid", self.form.span, message, hint);
        }
        None
    }

    /// What makes its material elastic. A density that is missing has been told.
    fn elastic(&mut self) {
        let machine = self.machine;
        let body = self.body();
        let solid = body.solid.as_ref().and_then(|worn| machine.solids.get(worn.solid)?.material);
        let beam = body.rod.as_ref().and_then(|rod| machine.beams.get(rod.beam)?.material);
        let Some(material) = solid.or(beam).and_then(|material| machine.materials.get(material)) else { return };
        if material.elastic.is_none() && !material.faulty {
            let message = format!(
                "material `{}` has no `young` and `poisson`, which the flexible body `{}` needs",
                material.name, body.name
            );
            let report = Diagnostic::error("missing-key", material.span, message).also(self.form.span, "needed here");
            self.report(report.hint("steel: `young = \"210 GPa\"` and `poisson = 0.3`"));
        }
    }

    /// Keys that are for beams alone, and for solids alone.
    fn fitting_keys(&mut self) {
        let form = self.form;
        let name = self.body().name.clone();
        let wrong: Vec<(&str, Option<Span>)> = match self.body().rod {
            Some(_) => vec![
                ("mesh", form.mesh.as_ref().map(|(span, _)| *span)),
                ("coupling", form.coupling.as_ref().map(|one| one.span)),
            ],
            None => vec![("segments", form.segments.as_ref().map(|one| one.span))],
        };
        if let Some(modes) = form.modes.as_ref().filter(|modes| modes.value > MOST_MODES && self.body().rod.is_some()) {
            let message = format!("{} modes of a segment of a beam; at most {MOST_MODES} are kept", modes.value);
            self.fault("out-of-range", modes.span, message, "take more `segments`");
        }
        let (is, other) = if self.body().rod.is_some() { ("beam", "solids") } else { ("solid", "beams") };
        for (key, span) in wrong.into_iter().filter_map(|(key, span)| Some((key, span?))) {
            let message = format!("`{key}` of the flexible body `{name}` is for {other}; it has a {is}");
            let hint = match key {
                "segments" => "a solid deforms as a whole, by `modes`; large deflections need a beam in segments",
                _ => "leave it out: a beam is worked out from its section",
            };
            self.fault("conflicting-keys", span, message, hint);
        }
    }

    fn interfaces(&mut self, forces: &[Force]) -> Option<Vec<Spanned<usize>>> {
        match &self.form.interfaces {
            Some(names) => self.named(names),
            None => self.usual(forces),
        }
    }

    /// The points where joints and forces take hold, in the order of the body's points.
    fn usual(&mut self, forces: &[Force]) -> Option<Vec<Spanned<usize>>> {
        let (machine, form) = (self.machine, self.form);
        let held = holds(form.body, &machine.joints, forces, &machine.bodies);
        let points = 0..self.body().points.len();
        let held: Vec<Spanned<usize>> = points
            .filter(|point| held.iter().any(|one| one.point == *point))
            .map(|value| Spanned { value, span: form.span })
            .collect();
        if held.is_empty() {
            let message = format!("nothing takes hold of the flexible body `{}` at a point", self.body().name);
            let hint = "name its interfaces: `flexible = { interfaces = [\"A\", \"B\"] }`";
            self.fault("no-interface", form.span, message, hint);
            return None;
        }
        Some(held)
    }

    fn named(&mut self, names: &[Spanned<String>]) -> Option<Vec<Spanned<usize>>> {
        if names.is_empty() {
            let message = format!("`interfaces` of the flexible body `{}` names no point", self.body().name);
            let hint = "one or more points of the body; or leave the key out: those where joints and forces take hold";
            self.fault("wrong-length", self.form.span, message, hint);
            return None;
        }
        let mut found: Vec<Spanned<usize>> = Vec::with_capacity(names.len());
        for name in names {
            let Some(point) = self.point(name) else { continue };
            match found.iter().find(|one| one.value == point) {
                Some(first) => {
                    let message = format!("interface `{}` is named twice", name.value);
                    let report = Diagnostic::error("named-twice", name.span, message).also(first.span, "first here");
                    self.report(report);
                }
                None => found.push(Spanned { value: point, span: name.span }),
            }
        }
        (found.len() == names.len()).then_some(found)
    }

    fn point(&mut self, name: &Spanned<String>) -> Option<usize> {
        let names = &self.machine.point_names[self.form.body];
        let found = names.get(&name.value);
        if found.is_none() {
            let message = format!("body `{}` has no point `{}` for an interface", self.body().name, name.value);
            let report = Diagnostic::error("unknown-name", name.span, message);
            let hint = match (names.nearest(&name.value), names.listed("")) {
                (Some(near), _) => format!("did you mean `{near}`?"),
                (None, Some(all)) => format!("points of `{}`: {all}", self.body().name),
                (None, None) => "the body has no points".to_owned(),
            };
            self.report(report.hint(hint));
        }
        found
    }

    /// Place among the interfaces. The frame of a beam goes with an end of it.
    fn reference(&mut self, interfaces: &[Spanned<usize>]) -> Option<usize> {
        let ends = self.body().rod.as_ref().map(|rod| rod.ends);
        let is_end = |point: usize| ends.is_none_or(|ends| ends.contains(&point));
        let Some(name) = &self.form.reference else {
            return Some(interfaces.iter().position(|one| is_end(one.value)).unwrap_or(0));
        };
        let point = self.point(name)?;
        if !is_end(point) {
            let message = format!("`reference` names `{}`, which is no end of the beam", name.value);
            self.fault("no-interface", name.span, message, "the frame of a beam goes with one of its ends");
            return None;
        }
        let place = interfaces.iter().position(|one| one.value == point);
        if place.is_none() {
            let points = &self.body().points;
            let known: Vec<String> = interfaces.iter().map(|one| format!("`{}`", points[one.value].name)).collect();
            let message = format!("`reference` names `{}`, which is no interface of the body", name.value);
            let hint = format!("one of {}", known.join(", "));
            self.fault("no-interface", name.span, message, &hint);
        }
        place
    }
}
