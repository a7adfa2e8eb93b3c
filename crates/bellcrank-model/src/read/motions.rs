//! `[motions]`.

use std::sync::Arc;

use bellcrank_doc::{Diagnostic, Entry, Spanned, Value};
use bellcrank_multibody::{Coordinate, JointId};

use super::bodies::entries;
use super::files::Tables;
use super::starts::{self, Waiting};
use super::{Machine, PartReader};
use crate::design::{Goal, Law, Prescribed, Segment, SegmentKind};
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::motion::Profile;
use crate::names::{self, Index};
use crate::schema::{Along, MOTION, SEGMENT};
use crate::signals::TimeOnly;

/// The motions of a model by name.
pub(crate) struct ReadMotions {
    pub(crate) list: Vec<Prescribed>,
    pub(crate) names: Index,
    /// Names whose definitions were reported as wrong.
    pub(crate) faulty: Index,
    /// Each after the one it waits for.
    pub(crate) order: Vec<usize>,
}

/// What a motion moves: all coordinates of a joint, or one of them.
struct Target {
    coordinates: Vec<Coordinate>,
    motions: Vec<Motion>,
}

pub(crate) fn read(parts: &[PartReader<'_>], machine: &Machine, tables: &Tables<'_>) -> ReadMotions {
    let (names, faulty) = (Index::default(), Index::default());
    let mut read = ReadMotions { list: Vec::new(), names, faulty, order: Vec::new() };
    let mut waiting = Vec::new();
    for part in parts {
        for entry in entries(part, "motions") {
            if let Some(fault) = names::fault(entry, "motion") {
                part.reader.report(fault);
            }
            let (name, place) = (part.full(&entry.key), read.list.len());
            let (motion, waits) = read_motion(*part, machine, tables, entry, place);
            waiting.extend(waits.map(|waits| waits.of(motion.is_some())));
            match motion {
                Some(motion) => {
                    read.names.insert(&name, place);
                    read.list.push(motion);
                }
                None => read.faulty.insert(&name, 0),
            }
        }
    }
    read.order = starts::resolve(&waiting, &mut read);
    read
}

/// The motion at `place` in the list, and what it waits for, which is told even of one that is wrong.
fn read_motion<'a>(
    part: PartReader<'a>,
    machine: &Machine,
    tables: &Tables<'_>,
    entry: &'a Entry,
    place: usize,
) -> (Option<Prescribed>, Option<Waiting<'a>>) {
    let Some(fields) = part.reader.fields(&entry.value, &format!("motion `{}`", entry.key)) else {
        return (None, None);
    };
    let keyed = Keyed::new(fields, &MOTION, part.space());
    let target = keyed.text("joint").and_then(|name| target(part, machine, &keyed, name));
    let law = target.as_ref().and_then(|target| law(part, &keyed, target, tables));
    let (start, waits) = starts::read(part, &keyed, place, entry.key_span);
    keyed.finish();
    let (name, span) = (part.full(&entry.key), entry.key_span);
    let motion =
        target.zip(law).map(|(target, law)| Prescribed { name, span, coordinates: target.coordinates, law, start });
    (motion, waits)
}

/// A list of expressions moves all coordinates of a joint; everything else moves one.
fn target(part: PartReader<'_>, machine: &Machine, keyed: &Keyed<'_>, name: Spanned<&str>) -> Option<Target> {
    let listed = keyed.value("expression").is_some_and(|value| value.as_list().is_some());
    let whole = machine.joint_names.get(&part.full(name.value)).filter(|_| listed);
    let Some(joint) = whole else {
        let (coordinate, motion) = part.coordinate(machine, name)?;
        return Some(Target { coordinates: vec![coordinate], motions: vec![motion] });
    };
    let motions = machine.joints[joint].coordinates(part.planar).to_vec();
    let coordinates = (0..motions.len()).map(|index| Coordinate { joint: JointId(joint), index }).collect();
    Some(Target { coordinates, motions })
}

fn law(part: PartReader<'_>, keyed: &Keyed<'_>, target: &Target, tables: &Tables<'_>) -> Option<Law> {
    let forms = ["segments", "expression", "table", "velocity"];
    let given: Vec<&'static str> = forms.into_iter().filter(|form| keyed.has(form)).collect();
    let [form] = given.as_slice() else {
        let message = match given.as_slice() {
            [] => format!("{} says nothing about how it goes", keyed.what()),
            _ => format!("{} has more than one law: {}", keyed.what(), given.join(", ")),
        };
        let hint = "give one of `segments`, `expression`, `table`, `velocity`";
        keyed.report(Diagnostic::error("motion-law", keyed.span(), message).hint(hint));
        return None;
    };
    let motion = target.motions.first().copied()?;
    match *form {
        "segments" => segments(part, keyed, motion),
        "expression" => expressions(part, keyed, target),
        "table" => keyed.text("table").and_then(|file| table(part, keyed, file, motion, tables)),
        _ => keyed.along("velocity", motion).map(|velocity| Law::Velocity(part.quantity(velocity))),
    }
}

fn expressions(part: PartReader<'_>, keyed: &Keyed<'_>, target: &Target) -> Option<Law> {
    let value = keyed.value("expression")?;
    let what = keyed.named("expression");
    let dimensions: Vec<_> = target.motions.iter().map(|motion| Along::Position.dimension(*motion)).collect();
    let read = match value.as_list() {
        Some(_) => part.reader.signal_vector(value, &what, &dimensions, &mut TimeOnly)?,
        None => vec![part.reader.signal_quantity(value, &what, dimensions[0], &mut TimeOnly)?],
    };
    Some(Law::Expressions(part.quantities(read)))
}

fn segments(part: PartReader<'_>, keyed: &Keyed<'_>, motion: Motion) -> Option<Law> {
    let what = keyed.named("segments");
    let value = keyed.value("segments")?;
    let list = part.reader.list(value, &what)?;
    if list.is_empty() {
        keyed.report(Diagnostic::error("wrong-length", value.span, format!("{what} is empty")));
    }
    let one =
        |(i, value): (usize, &Value)| segment(part, value, &format!("segment {} of {}", i + 1, keyed.what()), motion);
    // All are read before giving up, for the errors of each.
    let read: Vec<Option<Segment>> = list.iter().enumerate().map(one).collect();
    let read = read.into_iter().collect::<Option<Vec<_>>>()?;
    check_names(keyed, &read);
    Some(Law::Segments(read))
}

/// A name leads to one segment.
fn check_names(keyed: &Keyed<'_>, segments: &[Segment]) {
    for (place, segment) in segments.iter().enumerate() {
        let Some(name) = &segment.name else { continue };
        if let Some(first) = segments[..place].iter().find(|other| other.name.as_ref() == Some(name)) {
            let message = format!("{} has two segments `{name}`", keyed.what());
            let report = Diagnostic::error("two-of-one-name", segment.span, message);
            keyed.report(report.also(first.span, "the other one"));
        }
    }
}

fn segment(part: PartReader<'_>, value: &Value, what: &str, motion: Motion) -> Option<Segment> {
    let keyed = Keyed::new(part.reader.fields(value, what)?, &SEGMENT, part.space());
    let hold = keyed.quantity("hold");
    let (to, by) = (keyed.along("to", motion), keyed.along("by", motion));
    let over = keyed.quantity("over");
    let profile = keyed.choice("profile").and_then(|name| Profile::named(name.value)).unwrap_or(Profile::Cycloidal);
    let name = keyed.text("name");
    if let Some(fault) = name.and_then(|name| names::fault_in(name, "segment")) {
        keyed.report(fault);
    }
    let goals = usize::from(keyed.has("to")) + usize::from(keyed.has("by"));
    let moves = goals > 0 || keyed.has("over") || keyed.has("profile");
    if keyed.has("hold") == moves || moves && !(goals == 1 && keyed.has("over")) {
        keyed.fault("segment", format!("{what} needs `to` (or `by`) and `over`, or `hold` alone"));
    }
    let span = name.map_or(value.span, |name| name.span);
    keyed.finish();
    let (kind, duration) = match hold {
        Some(hold) => (SegmentKind::Hold, hold),
        None => {
            let goal = match (to, by) {
                (Some(to), _) => Goal::To(part.quantity(to)),
                (None, by) => Goal::By(part.quantity(by?)),
            };
            (SegmentKind::Move { goal, profile }, over?)
        }
    };
    let name = name.map(|name| name.value.to_owned());
    Some(Segment { name, span, kind, duration: part.quantity(duration) })
}

/// The table was read with the files; a faulty one has been reported there.
fn table(
    part: PartReader<'_>,
    keyed: &Keyed<'_>,
    file: Spanned<&str>,
    motion: Motion,
    tables: &Tables<'_>,
) -> Option<Law> {
    let path = part.part.folder.join(file.value);
    let read = tables.read(&path, Along::Position.dimension(motion), file.span);
    match read {
        Ok(spline) => Some(Law::Table(Arc::new(spline))),
        Err(reports) => {
            reports.into_iter().for_each(|report| keyed.report(report));
            None
        }
    }
}
