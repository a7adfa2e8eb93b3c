//! `[joints]`.

use bellcrank_doc::{Diagnostic, Dimension, Entry, Span, Value};
use bellcrank_multibody::Coordinate;

use super::bodies::entries;
use super::machine::describe_coordinates;
use super::{Machine, PartReader};
use crate::design::{Direction, Joint, JointShape, Quantity, coordinates};
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::names;
use crate::schema::{Along, JOINT};

/// Kinds that the plane does not have.
const SPATIAL_ONLY: &[&str] = &["cylindrical", "screw", "universal", "spherical"];

/// Reads the joints of all parts; couplers last, since they refer to the others.
pub(crate) fn read(parts: &[PartReader<'_>], machine: &mut Machine) {
    let mut couplers = Vec::new();
    for part in parts {
        for entry in entries(part, "joints") {
            if let Some(fault) = names::fault(entry, "joint") {
                part.reader.report(fault);
            }
            match open(*part, entry) {
                Some((keyed, "coupler")) => couplers.push((*part, entry, keyed)),
                Some((keyed, kind)) => {
                    let joint = read_joint(*part, machine, entry, keyed, kind);
                    add(*part, machine, entry, joint);
                }
                None => machine.faulty_joints.insert(&part.full(&entry.key), 0),
            }
        }
    }
    for (part, entry, keyed) in couplers {
        let joint = read_coupler(part, machine, entry, keyed);
        add(part, machine, entry, joint);
    }
}

fn add(part: PartReader<'_>, machine: &mut Machine, entry: &Entry, joint: Option<Joint>) {
    match joint {
        Some(joint) => {
            machine.joint_names.insert(&joint.name, machine.joints.len());
            machine.joints.push(joint);
        }
        None => machine.faulty_joints.insert(&part.full(&entry.key), 0),
    }
}

/// Opens the table of a joint whose kind is known.
fn open<'a>(part: PartReader<'a>, entry: &'a Entry) -> Option<(Keyed<'a>, &'static str)> {
    let fields = part.reader.fields(&entry.value, &format!("joint `{}`", entry.key))?;
    let keyed = Keyed::new(fields, &JOINT, part.space());
    match keyed.kind() {
        Some(kind) if part.planar && SPATIAL_ONLY.contains(&kind) => {
            let message = format!("a {kind} joint has no meaning in the plane");
            let report = Diagnostic::error("not-in-plane", keyed.span(), message);
            keyed.report(report.hint("use `revolute`, `prismatic`, `planar` or `weld`, or `space = \"spatial\"`"));
            None
        }
        // In space it must not leave its plane.
        Some("free") if part.is_embedded() => Some((keyed, "planar")),
        Some(kind) => Some((keyed, kind)),
        None => {
            keyed.finish();
            None
        }
    }
}

fn read_joint(
    part: PartReader<'_>,
    machine: &Machine,
    entry: &Entry,
    keyed: Keyed<'_>,
    kind: &'static str,
) -> Option<Joint> {
    let connects_value = keyed.value("connects");
    let connects_span = connects_value.map_or(entry.key_span, |value| value.span);
    let connects = connects_value.and_then(|value| part.pair(machine, value, &keyed.named("connects")));
    if let Some([a, b]) = connects
        && a.body == b.body
    {
        let message = format!("joint `{}` connects a body with itself", entry.key);
        keyed.report(Diagnostic::error("self-joint", connects_span, message));
    }
    let shape = shape(part, &keyed, kind);
    let held = matches!(shape, Some(JointShape::Distance { length: Some(_) }));
    let motions = if held { &[] } else { coordinates(kind, part.planar) };
    let start = values_of(part, &keyed, "start", Along::Position, kind, motions);
    let start_velocity = values_of(part, &keyed, "start_velocity", Along::Velocity, kind, motions);
    let at_start = keyed.boolean("at_start");
    if let Some(flag) = at_start
        && flag.value
        && start.is_empty()
    {
        let message = format!("joint `{}` is to be held at its start, but has no `start`", entry.key);
        keyed.report(Diagnostic::error("missing-key", flag.span, message));
    }
    keyed.finish();
    Some(Joint {
        name: part.full(&entry.key),
        span: entry.key_span,
        kind,
        shape: shape?,
        connects,
        start,
        start_velocity,
        at_start: at_start.is_some_and(|flag| flag.value),
        planar: part.planar,
    })
}

fn shape(part: PartReader<'_>, keyed: &Keyed<'_>, kind: &str) -> Option<JointShape> {
    let axis = |name| keyed.axis(name).map(|axis| part.direction(axis));
    Some(match kind {
        "revolute" => JointShape::Revolute { axis: axis_or_z(part, keyed)? },
        "prismatic" => JointShape::Prismatic { axis: axis("axis")? },
        "cylindrical" => JointShape::Cylindrical { axis: axis("axis")? },
        "screw" => {
            let (axis, pitch) = (axis("axis"), keyed.quantity("pitch"));
            JointShape::Screw { axis: axis?, pitch: part.quantity(pitch?) }
        }
        "universal" => {
            let (axis, axis2) = (axis("axis"), axis("axis2"));
            JointShape::Universal { axis: axis?, axis2: axis2? }
        }
        "spherical" => JointShape::Spherical,
        "planar" => JointShape::Planar,
        "free" => JointShape::Free,
        "distance" => JointShape::Distance { length: keyed.quantity("length").map(|length| part.quantity(length)) },
        "point-on-line" => JointShape::PointOnLine { axis: axis("axis")? },
        _ => JointShape::Weld,
    })
}

/// The axis of a hinge; a wrong one is `None`, an absent one z.
fn axis_or_z(part: PartReader<'_>, keyed: &Keyed<'_>) -> Option<Direction> {
    match keyed.has("axis") {
        true => keyed.axis("axis").map(|axis| part.direction(axis)),
        false => Some(PartReader::z(keyed.span())),
    }
}

/// A value, or a list of up to as many values as the joint has coordinates.
fn values_of(
    part: PartReader<'_>,
    keyed: &Keyed<'_>,
    name: &'static str,
    along: Along,
    kind: &str,
    motions: &[Motion],
) -> Vec<Option<Quantity>> {
    let Some(value) = keyed.value(name) else { return Vec::new() };
    let what = keyed.named(name);
    let single = std::slice::from_ref(value);
    let values: &[Value] = value.as_list().unwrap_or(single);
    if values.len() > motions.len() {
        let message = format!("{what} has {} values, a {kind} joint has {} coordinates", values.len(), motions.len());
        let report = Diagnostic::error("wrong-length", value.span, message);
        keyed.report(match motions.is_empty() {
            true => report,
            false => report.hint(format!("its coordinates: {}", describe_coordinates(kind, part.planar))),
        });
        return Vec::new();
    }
    let one = |(value, motion): (&Value, &Motion)| {
        part.reader.quantity(value, &what, along.dimension(*motion)).map(|value| part.quantity(value))
    };
    values.iter().zip(motions).map(one).collect()
}

fn read_coupler(part: PartReader<'_>, machine: &Machine, entry: &Entry, keyed: Keyed<'_>) -> Option<Joint> {
    let pair = coupled(part, machine, &keyed);
    let ratio = keyed.value("ratio");
    let read = pair.and_then(|[(a, of_a), (b, of_b)]| {
        let position = |motion| Along::Position.dimension(motion);
        let dimension = position(of_b).over(position(of_a)).unwrap_or(Dimension::NONE);
        let ratio = part.reader.quantity(ratio?, &keyed.named("ratio"), dimension);
        let offset = keyed.along("offset", of_b);
        Some((a, b, part.quantity(ratio?), offset.map(|offset| part.quantity(offset))))
    });
    keyed.finish();
    let (a, b, ratio, offset) = read?;
    Some(Joint {
        name: part.full(&entry.key),
        span: entry.key_span,
        kind: "coupler",
        shape: JointShape::Coupler { a, b, ratio, offset },
        connects: None,
        start: Vec::new(),
        start_velocity: Vec::new(),
        at_start: false,
        planar: part.planar,
    })
}

fn coupled(part: PartReader<'_>, machine: &Machine, keyed: &Keyed<'_>) -> Option<[(Coordinate, Motion); 2]> {
    let names = keyed.texts("joints")?;
    if names.len() != 2 {
        let message = format!("{} needs two coordinates, found {}", keyed.named("joints"), names.len());
        keyed.report(Diagnostic::error("wrong-length", keyed.span(), message));
        return None;
    }
    let read: Vec<Option<(Coordinate, Motion)>> = names.iter().map(|name| part.coordinate(machine, *name)).collect();
    match read.as_slice() {
        [Some(a), Some(b)] if a.0 == b.0 => {
            let span: Span = names[1].span;
            keyed.report(Diagnostic::error("self-joint", span, "a coupler needs two different coordinates"));
            None
        }
        [Some(a), Some(b)] => Some([*a, *b]),
        _ => None,
    }
}
