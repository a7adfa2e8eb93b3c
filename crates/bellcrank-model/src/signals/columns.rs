//! The signals of each source: names, measures, and when they are known.

use bellcrank_multibody::Coordinate;

use super::{Layout, Outputs, Source};
use crate::measure::{Measure, Motion};

/// What must have been solved before a signal is known.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Level {
    Position,
    Velocity,
    Acceleration,
    Force,
}

/// A signal's name and measure.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Column {
    pub(crate) name: String,
    pub(crate) measure: Measure,
    pub(crate) level: Level,
}

type Part = (&'static str, Measure, Level);

/// The signals of a source, in the order in which [`super::View::read`] answers them.
pub(crate) fn columns(source: Source, layout: &Layout) -> Vec<Column> {
    match source {
        Source::Time => named("time", "", &[("", Measure::Time, Level::Position)]),
        Source::Joint(c) => joint(c, layout),
        Source::Drive(c) => drive(c, layout),
        Source::Reaction(joint) => reaction(joint, layout),
        Source::Point { body, point } => point_of(body, point, layout),
        Source::Body(body) => {
            let name = format!("body.{}", layout.bodies.get(body).map_or("", |(name, _)| name));
            named(&name, "", if layout.planar { PLANAR_BODY } else { SPATIAL_BODY })
        }
        Source::Force(force) => element(force, layout),
        Source::Stress(body) => stress(body, layout),
        Source::Energy => named("energy", "", ENERGY),
        Source::Check => named("check", "", CHECK),
    }
}

/// The largest stress of all that can be trusted, then that of each bore.
fn stress(body: usize, layout: &Layout) -> Vec<Column> {
    let name = layout.bodies.get(body).map_or("", |(name, _)| name);
    let regions = layout.stresses.iter().find(|(of, _)| *of == body).map_or(&[][..], |(_, regions)| regions);
    let column = |region: &String| Column {
        name: format!("stress.{name}.{region}"),
        measure: Measure::Stress,
        level: Level::Force,
    };
    regions.iter().map(column).collect()
}

fn named(owner: &str, suffix: &str, parts: &[Part]) -> Vec<Column> {
    let column = |&(part, measure, level): &Part| {
        let dot = if part.is_empty() { "" } else { "." };
        Column { name: format!("{owner}{dot}{part}{suffix}"), measure, level }
    };
    parts.iter().map(column).collect()
}

/// `.1` for one of several coordinates.
fn suffix(c: Coordinate, count: usize) -> String {
    if count > 1 { format!(".{}", c.index) } else { String::new() }
}

fn motion(c: Coordinate, layout: &Layout) -> (String, Motion, String) {
    let Some(joint) = layout.joints.get(c.joint.0) else { return (String::new(), Motion::Slide, String::new()) };
    let motion = joint.coordinates.get(c.index).copied().unwrap_or(Motion::Slide);
    (joint.name.clone(), motion, suffix(c, joint.coordinates.len()))
}

fn joint(c: Coordinate, layout: &Layout) -> Vec<Column> {
    let (name, motion, suffix) = motion(c, layout);
    let parts = [
        ("position", Measure::position(motion), Level::Position),
        ("velocity", Measure::velocity(motion), Level::Velocity),
        ("acceleration", Measure::acceleration(motion), Level::Acceleration),
    ];
    named(&format!("joint.{name}"), &suffix, &parts)
}

fn drive(c: Coordinate, layout: &Layout) -> Vec<Column> {
    let (name, motion, suffix) = motion(c, layout);
    let parts = [("force", Measure::effort(motion), Level::Force), ("power", Measure::Power, Level::Force)];
    named(&format!("drive.{name}"), &suffix, &parts)
}

const fn force(name: &'static str) -> Part {
    (name, Measure::Force, Level::Force)
}

const fn moment(name: &'static str) -> Part {
    (name, Measure::Moment, Level::Force)
}

/// The place of the angle among the signals of a body in the plane.
pub(crate) const PLANAR_ANGLE: usize = 6;

/// Components of a reaction, as in [`bellcrank_results::Reaction::unique`], with their place in fx .. mz.
pub(crate) fn reaction_components(planar: bool) -> &'static [(&'static str, usize)] {
    if planar {
        &[("fx", 0), ("fy", 1), ("mz", 5)]
    } else {
        &[("fx", 0), ("fy", 1), ("fz", 2), ("mx", 3), ("my", 4), ("mz", 5)]
    }
}

fn reaction(index: usize, layout: &Layout) -> Vec<Column> {
    let Some(joint) = layout.joints.get(index) else { return Vec::new() };
    let owner = format!("joint.{}.reaction", joint.name);
    if joint.coupler {
        return named(&owner, "", &[force("effort")]);
    }
    let components = reaction_components(layout.planar).iter();
    let mut parts: Vec<Part> =
        components.map(|(name, place)| if *place < 3 { force(name) } else { moment(name) }).collect();
    parts.extend([force("force"), moment("moment")]);
    named(&owner, "", &parts)
}

const POINT: [&[Part]; 3] = [
    &[
        ("x", Measure::Length, Level::Position),
        ("y", Measure::Length, Level::Position),
        ("z", Measure::Length, Level::Position),
    ],
    &[
        ("vx", Measure::Velocity, Level::Velocity),
        ("vy", Measure::Velocity, Level::Velocity),
        ("vz", Measure::Velocity, Level::Velocity),
    ],
    &[
        ("ax", Measure::Acceleration, Level::Acceleration),
        ("ay", Measure::Acceleration, Level::Acceleration),
        ("az", Measure::Acceleration, Level::Acceleration),
    ],
];

fn point_of(body: usize, point: usize, layout: &Layout) -> Vec<Column> {
    let Some((name, points)) = layout.bodies.get(body) else { return Vec::new() };
    let owner = format!("point.{name}.{}", points.get(point).map_or("", String::as_str));
    let axes = if layout.planar { 2 } else { 3 };
    POINT.iter().flat_map(|parts| named(&owner, "", &parts[..axes])).collect()
}

const PLANAR_BODY: &[Part] = &[
    ("x", Measure::Length, Level::Position),
    ("y", Measure::Length, Level::Position),
    ("vx", Measure::Velocity, Level::Velocity),
    ("vy", Measure::Velocity, Level::Velocity),
    ("ax", Measure::Acceleration, Level::Acceleration),
    ("ay", Measure::Acceleration, Level::Acceleration),
    ("angle", Measure::Angle, Level::Position),
    ("omega", Measure::AngularVelocity, Level::Velocity),
    ("alpha", Measure::AngularAcceleration, Level::Acceleration),
];

const SPATIAL_BODY: &[Part] = &[
    ("x", Measure::Length, Level::Position),
    ("y", Measure::Length, Level::Position),
    ("z", Measure::Length, Level::Position),
    ("vx", Measure::Velocity, Level::Velocity),
    ("vy", Measure::Velocity, Level::Velocity),
    ("vz", Measure::Velocity, Level::Velocity),
    ("ax", Measure::Acceleration, Level::Acceleration),
    ("ay", Measure::Acceleration, Level::Acceleration),
    ("az", Measure::Acceleration, Level::Acceleration),
    ("roll", Measure::Angle, Level::Position),
    ("pitch", Measure::Angle, Level::Position),
    ("yaw", Measure::Angle, Level::Position),
    ("omega_x", Measure::AngularVelocity, Level::Velocity),
    ("omega_y", Measure::AngularVelocity, Level::Velocity),
    ("omega_z", Measure::AngularVelocity, Level::Velocity),
    ("alpha_x", Measure::AngularAcceleration, Level::Acceleration),
    ("alpha_y", Measure::AngularAcceleration, Level::Acceleration),
    ("alpha_z", Measure::AngularAcceleration, Level::Acceleration),
];

const ENERGY: &[Part] = &[
    ("kinetic", Measure::Energy, Level::Velocity),
    ("potential", Measure::Energy, Level::Position),
    ("total", Measure::Energy, Level::Velocity),
];

const CHECK: &[Part] = &[("closure", Measure::Length, Level::Position), ("balance", Measure::One, Level::Force)];

fn element(index: usize, layout: &Layout) -> Vec<Column> {
    let Some(element) = layout.forces.get(index) else { return Vec::new() };
    let owner = format!("force.{}", element.name);
    let effort = |motion| ("effort", Measure::effort(motion), Level::Force);
    let parts: Vec<Part> = match element.outputs {
        Outputs::Force => vec![force("fx"), force("fy"), force("fz"), force("effort")],
        Outputs::Torque => vec![moment("mx"), moment("my"), moment("mz"), moment("effort")],
        Outputs::Effort(motion) => vec![effort(motion)],
        Outputs::Element(motion) => vec![
            ("length", Measure::position(motion), Level::Position),
            ("rate", Measure::velocity(motion), Level::Velocity),
            effort(motion),
        ],
    };
    // In the plane a force has no z and a torque nothing else.
    let inside = |part: &Part| match element.outputs {
        Outputs::Force => !layout.planar || part.0 != "fz",
        Outputs::Torque => !layout.planar || !matches!(part.0, "mx" | "my"),
        _ => true,
    };
    let parts: Vec<Part> = parts.into_iter().filter(inside).collect();
    named(&owner, "", &parts)
}
