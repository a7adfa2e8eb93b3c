//! A catalogue from its text: see the table in [`bellcrank_sizing::catalogue`].

use bellcrank_doc::{
    Diagnostic, Diagnostics, Dimension as D, Entry as Written, Fields, ParameterSet, Reader, SourceId, Sources, Span,
    nearest, parse,
};
use bellcrank_sizing::SizingError;
use bellcrank_sizing::electric::{Drive, Gear, Kind};
use bellcrank_sizing::pneumatic::Cylinder;

use super::Stock;
use super::entry::{Allowed, Entry};

/// Reads a catalogue; everything that is wrong with it is reported in its text.
pub(crate) fn stock(sources: &Sources, id: SourceId, diagnostics: &mut Diagnostics) -> Option<Stock> {
    let before = diagnostics.errors();
    let table = parse(sources, id, diagnostics);
    if table.is_empty() && diagnostics.errors() > before {
        return None;
    }
    let none = ParameterSet::default();
    let reader = Reader::new(&none);
    let fields = Fields::new(&reader, &table, "the catalogue");
    let series = fields.entries("series");
    let catalogue = Catalogue { reader: &reader, series };
    let (cylinders, drives) = (fields.entries("cylinders"), fields.entries("drives"));
    let (has_cylinders, has_drives) = (fields.has("cylinders"), fields.has("drives"));
    fields.finish();
    if !has_cylinders && !has_drives {
        let message = "this catalogue has neither cylinders nor drives";
        let hint = "an entry is a table: `[cylinders.NAME]` with `bore` and `rod`, or `[drives.NAME]` with `kind`";
        reader.report(Diagnostic::error("no-entries", Span::new(id, 0, 0), message).hint(hint));
    }
    let stock = Stock {
        cylinders: cylinders.iter().filter_map(|entry| catalogue.cylinder(entry)).collect(),
        drives: drives.iter().filter_map(|entry| catalogue.drive(entry)).collect(),
    };
    // What is wrong with a series is found once for each entry that uses it.
    let mut told: Vec<Diagnostic> = Vec::new();
    for report in reader.finish() {
        if !told.contains(&report) {
            told.push(report.clone());
            diagnostics.push(report);
        }
    }
    (diagnostics.errors() == before).then_some(stock)
}

struct Catalogue<'a> {
    reader: &'a Reader<'a>,
    series: &'a [Written],
}

impl<'a> Catalogue<'a> {
    /// An entry with its series; hints say what to write for a required key.
    fn entry(&self, written: &'a Written, sort: &str, hints: fn(&str) -> Option<String>) -> Option<Entry<'a>> {
        let own = self.reader.fields(&written.value, &format!("{sort} `{}`", written.key))?.with_hints(hints);
        let series = match own.optional_string("series") {
            None if own.has("series") => return None,
            None => None,
            Some(name) => {
                let Some(found) = self.series.iter().find(|series| series.key == name.value) else {
                    let message = format!("there is no series `{}` in this catalogue", name.value);
                    let near = nearest(name.value, self.series.iter().map(|series| series.key.as_str()));
                    let report = Diagnostic::error("unknown-name", name.span, message);
                    self.reader.report(match near {
                        Some(near) => report.did_you_mean(Some(near)),
                        None => report.hint("what entries share stands in `[series.NAME]` of the same file"),
                    });
                    return None;
                };
                Some(self.reader.fields(&found.value, &format!("series `{}`", found.key))?)
            }
        };
        Some(Entry::new(own, series))
    }

    fn cylinder(&self, written: &'a Written) -> Option<Cylinder> {
        let entry = self.entry(written, "cylinder", cylinder_hint)?;
        let read = cylinder(&entry, &written.key);
        let sound = read.filter(|cylinder| {
            let rod = cylinder.rod < cylinder.bore;
            if !rod {
                let message = format!("the rod of {} is not thinner than its bore", entry.what());
                let span = entry.value("rod").map_or(written.key_span, |(value, _)| value.span);
                entry.report(Diagnostic::error("out-of-range", span, message));
            }
            let strokes = !cylinder.strokes.is_empty() || cylinder.max_stroke.is_some();
            if !strokes {
                let message = format!("{} has neither `strokes` nor `max_stroke`", entry.what());
                entry.error(
                    "missing-key",
                    message,
                    "write `strokes = [\"100 mm\", \"160 mm\"]`, `max_stroke`, or both",
                );
            }
            rod && strokes && usable(&entry, cylinder.validate())
        });
        entry.finish();
        sound
    }

    fn drive(&self, written: &'a Written) -> Option<Drive> {
        let entry = self.entry(written, "drive", drive_hint)?;
        let kind = match entry.one_of("kind", &["linear", "rotary"])? {
            Some("linear") => Kind::Linear,
            Some(_) => Kind::Rotary,
            None => {
                let message = format!("`kind` is missing in {}", entry.what());
                entry.error("missing-key", message, "write `kind = \"linear\"` or `kind = \"rotary\"`");
                return None;
            }
        };
        let read = drive(&entry, &written.key, kind);
        let sound = read.filter(|drive| {
            let peak = drive.peak_effort >= drive.rated_effort;
            if !peak {
                let key = names(kind).peak;
                let message = format!("`{key}` of {} is below `{}`", entry.what(), names(kind).rated);
                let span = entry.value(key).map_or(written.key_span, |(value, _)| value.span);
                entry.report(Diagnostic::error("out-of-range", span, message));
            }
            peak && usable(&entry, drive.validate())
        });
        entry.finish();
        sound
    }
}

/// Whatever the keys' own checks let through.
fn usable(entry: &Entry<'_>, judged: Result<(), SizingError>) -> bool {
    let fault = judged.err();
    if let Some(fault) = &fault {
        entry.error("out-of-range", fault.to_string(), "look at the units of this entry");
    }
    fault.is_none()
}

fn cylinder_hint(key: &str) -> Option<String> {
    Some(match key {
        "rod" => "write `rod = \"20 mm\"`, or `rod = 0` for a cylinder without one".to_owned(),
        _ => format!("write `{key} = \"63 mm\"`"),
    })
}

fn cylinder(entry: &Entry<'_>, name: &str) -> Option<Cylinder> {
    use Allowed::{NotNegative, Positive};
    let standard = entry.text("standard");
    let bore = entry.needed("bore", D::LENGTH, Positive);
    let rod = entry.needed("rod", D::LENGTH, NotNegative);
    let strokes = entry.numbers("strokes", D::LENGTH, Positive);
    let max_stroke = entry.number("max_stroke", D::LENGTH, Positive);
    let max_pressure = entry.number("max_pressure", D::PRESSURE, Positive);
    let max_speed = entry.number("max_speed", D::VELOCITY, Positive);
    let cushion_energy = entry.number("cushion_energy", D::ENERGY, NotNegative);
    let moving_mass = entry.number("moving_mass", D::MASS, NotNegative);
    let moving_mass_per_stroke = entry.number("moving_mass_per_stroke", D::MASS / D::LENGTH, NotNegative);
    let base_length = entry.number("base_length", D::LENGTH, NotNegative);
    let youngs_modulus = entry.number("youngs_modulus", D::PRESSURE, Positive);
    let bare = Cylinder::bare();
    Some(Cylinder {
        name: name.to_owned(),
        standard: standard?.unwrap_or_default(),
        bore: bore?,
        rod: rod?,
        strokes: strokes?,
        max_stroke: max_stroke?,
        max_pressure: max_pressure?,
        max_speed: max_speed?,
        cushion_energy: cushion_energy?,
        moving_mass: moving_mass?,
        moving_mass_per_stroke: moving_mass_per_stroke?,
        base_length: base_length?,
        youngs_modulus: youngs_modulus?.unwrap_or(bare.youngs_modulus),
    })
}

/// Keys and dimensions that follow the kind of a drive.
struct Names {
    rated: &'static str,
    peak: &'static str,
    inertia: &'static str,
    effort: D,
    speed: D,
    travel: D,
    mass: D,
}

fn names(kind: Kind) -> Names {
    match kind {
        Kind::Linear => Names {
            rated: "rated_force",
            peak: "peak_force",
            inertia: "moving_mass",
            effort: D::FORCE,
            speed: D::VELOCITY,
            travel: D::LENGTH,
            mass: D::MASS,
        },
        Kind::Rotary => Names {
            rated: "rated_torque",
            peak: "peak_torque",
            inertia: "inertia",
            effort: D::MOMENT,
            speed: D::ANGULAR_VELOCITY,
            travel: D::ANGLE,
            mass: D::INERTIA,
        },
    }
}

fn drive_hint(key: &str) -> Option<String> {
    let value = match key {
        "rated_force" => "400 N",
        "peak_force" => "800 N",
        "rated_torque" => "1.27 N*m",
        "peak_torque" => "3.81 N*m",
        _ => return Some("a speed: `max_speed = \"500 mm/s\"`, of a rotary drive `\"3000 rpm\"`".to_owned()),
    };
    Some(format!("write `{key} = \"{value}\"`"))
}

fn drive(entry: &Entry<'_>, name: &str, kind: Kind) -> Option<Drive> {
    use Allowed::{NotNegative, Positive, Share};
    let of = names(kind);
    let rated_effort = entry.needed(of.rated, of.effort, Positive);
    let peak_effort = entry.needed(of.peak, of.effort, Positive);
    let max_speed = entry.needed("max_speed", of.speed, Positive);
    let knee_speed = entry.number("knee_speed", of.speed, NotNegative);
    let rated_power = entry.number("rated_power", D::POWER, Positive);
    let peak_power = entry.number("peak_power", D::POWER, Positive);
    let strokes = entry.numbers("strokes", of.travel, Positive);
    let max_stroke = entry.number("max_stroke", of.travel, Positive);
    let inertia = entry.number(of.inertia, of.mass, NotNegative);
    let ratio = entry.number("gear_ratio", D::NONE, Positive);
    let efficiency = entry.number("gear_efficiency", D::NONE, Share);
    let gear = match (ratio?, efficiency?) {
        (Some(ratio), efficiency) => Some(Gear { ratio, efficiency: efficiency.unwrap_or(1.0) }),
        (None, None) => None,
        (None, Some(_)) => {
            let message = format!("{} has a `gear_efficiency`, but no `gear_ratio`", entry.what());
            entry.error("missing-key", message, "turns of the motor for one of the output: `gear_ratio = 10`");
            return None;
        }
    };
    Some(Drive {
        name: name.to_owned(),
        kind,
        rated_effort: rated_effort?,
        peak_effort: peak_effort?,
        max_speed: max_speed?,
        knee_speed: knee_speed?,
        rated_power: rated_power?,
        peak_power: peak_power?,
        strokes: strokes?,
        max_stroke: max_stroke?,
        inertia: inertia?,
        gear,
    })
}
