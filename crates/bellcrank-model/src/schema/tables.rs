//! The tables of a model file, but for joints, forces and studies.

use bellcrank_doc::Dimension as D;

use super::flexible::{BEAM, FLEXIBLE};
use super::joints_and_forces::{FORCE, JOINT};
use super::keys::Shape::{
    Axis, List, Map, Name, Named, OneOf, Parameters, Points, Switch, Table, Tables, Text, Value, Values, Vector,
    Version, Whole,
};
use super::keys::{Along, Key, Schema, Shape};
use super::solids::{MATERIAL, SOLID};
use super::studies::STUDY;

const fn plain(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Schema {
    Schema { name, doc, keys, kinds: &[], usual: None }
}

pub(crate) static MODEL: Schema = plain(
    "model",
    "A machine and what to find out about it.",
    &[
        Key::required("bellcrank", Version, "format version, 1"),
        Key::optional("title", Text, "one line for people"),
        Key::required("space", OneOf(&["planar", "spatial"]), "x-y plane with moments about z, or three dimensions"),
        Key::required("gravity", Vector(D::ACCELERATION), "acceleration of free fall, world axes; no hidden default"),
        Key::optional("units", Table(&UNITS), "display units"),
        Key::optional("parameters", Parameters, "named values that everything else may use"),
        Key::optional("ground", Table(&GROUND), "the body that does not move"),
        Key::optional("bodies", Named(&BODY), "bodies"),
        Key::optional("joints", Named(&JOINT), "joints and constraints"),
        Key::optional("forces", Named(&FORCE), "force elements; weight is always there"),
        Key::optional("motions", Named(&MOTION), "coordinates prescribed in time"),
        Key::optional("studies", Named(&STUDY), "what to find out"),
        Key::optional("subsystems", Named(&SUBSYSTEM), "other model files as parts of this machine"),
        Key::optional("materials", Named(&MATERIAL), "materials of solids"),
        Key::optional("solids", Named(&SOLID), "parts as solids, which mass properties come from"),
        Key::optional("beams", Named(&BEAM), "straight rods of one section, which mass properties come from"),
    ],
);

pub(crate) static UNITS: Schema = plain(
    "units",
    "Display units: how results are shown. What is computed does not depend on them.",
    &[
        Key::optional("length", Text, "mm unless given"),
        Key::optional("angle", Text, "deg unless given"),
        Key::optional("force", Text, "N unless given"),
        Key::optional("time", Text, "s unless given"),
        Key::optional("stress", Text, "MPa unless given"),
        Key::optional("moment", Text, "N*m unless given"),
        Key::optional("mass", Text, "kg unless given"),
        Key::optional("power", Text, "W unless given"),
        Key::optional("energy", Text, "J unless given"),
        Key::optional("velocity", Text, "length over time unless given"),
        Key::optional("acceleration", Text, "length over time squared unless given"),
        Key::optional("angular_velocity", Text, "angle over time unless given"),
        Key::optional("angular_acceleration", Text, "angle over time squared unless given"),
    ],
);

pub(crate) static GROUND: Schema = plain(
    "ground",
    "The body that does not move; its axes are the world's.",
    &[Key::optional("points", Points, "named points")],
);

pub(crate) static BODY: Schema = plain(
    "body",
    "A body, rigid unless it is `flexible`. Without a mass it is massless.",
    &[
        Key::optional("mass", Value(D::MASS), "mass"),
        Key::optional("center", Vector(D::LENGTH), "centre of mass, body axes; the origin unless given"),
        Key::optional(
            "inertia",
            List(D::INERTIA, &[1, 3, 6]),
            "about the centre of mass: in the plane one value (or as in space), in space [Ixx, Iyy, Izz] or [Ixx, Iyy, Izz, Ixy, Ixz, \
             Iyz] (tensor entries), body axes",
        ),
        Key::optional("points", Points, "named points"),
        Key::optional("solid", Name, "the solid that the mass properties come from"),
        Key::optional("beam", Name, "the beam that the mass properties come from"),
        Key::optional("flexible", Switch(&FLEXIBLE), "how it deforms: `true`, or a table; rigid unless given"),
    ],
);

/// A point written as a table.
pub(crate) static PLACE: Schema = plain(
    "point",
    "A point with axes of its own.",
    &[
        Key::required("at", Vector(D::LENGTH), "place, body axes"),
        Key::optional("rotate", Table(&ROTATE), "turn the axes by an angle about an axis"),
        Key::optional("quaternion", List(D::NONE, &[4]), "orientation [w, x, y, z]"),
        Key::optional("rpy", List(D::ANGLE, &[3]), "roll, pitch, yaw: R = Rz Ry Rx"),
    ],
);

pub(crate) static ROTATE: Schema = plain(
    "rotate",
    "A turn about an axis.",
    &[Key::optional("axis", Axis, "z unless given"), Key::required("angle", Value(D::ANGLE), "angle")],
);

pub(crate) static MOTION: Schema = plain(
    "motion",
    "A joint coordinate prescribed in time, by one of `segments`, `expression`, `table`, `velocity`.",
    &[
        Key::required("joint", Name, "joint, or `joint.1` for one of several coordinates"),
        Key::optional("segments", Tables(&SEGMENT), "one after another, from the start position"),
        Key::optional("expression", Values, "of `time`; a list for all coordinates of a joint"),
        Key::optional("table", Text, "CSV file of times and positions, beside the model file"),
        Key::optional("velocity", Shape::Along(Along::Velocity), "constant, from the start position"),
        Key::optional(
            "start",
            Shape::Start,
            "when it begins: a time, or `after NAME` or `with NAME` of a motion or of a segment, `MOTION.SEGMENT`; time \
             0 unless given",
        ),
        Key::optional("delay", Value(D::TIME), "comes on top of `start`"),
    ],
);

/// Profiles of a segment.
pub(crate) const PROFILES: &[&str] = &["cycloidal", "poly5", "trapezoid", "s-curve", "linear"];

pub(crate) static SEGMENT: Schema = plain(
    "segment",
    "A move to a place, or a hold.",
    &[
        Key::optional("to", Shape::Along(Along::Position), "where the segment ends"),
        Key::optional("by", Shape::Along(Along::Position), "how far it goes from where it begins, in place of `to`"),
        Key::optional("over", Value(D::TIME), "how long it takes"),
        Key::optional("profile", OneOf(PROFILES), "cycloidal unless given"),
        Key::optional("hold", Value(D::TIME), "rest this long"),
        Key::optional("name", Text, "a name that a `start` can refer to, as `MOTION.NAME`"),
    ],
);

pub(crate) static SWEEP: Schema = plain(
    "sweep",
    "Equal steps of one joint coordinate.",
    &[
        Key::required("joint", Name, "the swept joint, or `joint.1`"),
        Key::required("from", Shape::Along(Along::Position), "first position"),
        Key::required("to", Shape::Along(Along::Position), "last position"),
        Key::required("points", Whole(2, 1_000_000), "number of positions"),
    ],
);

pub(crate) static DRIVE: Schema = plain(
    "drive",
    "The joint that moves at a given rate and carries the force.",
    &[
        Key::optional("joint", Name, "the swept joint unless given"),
        Key::optional("velocity", Shape::Along(Along::Velocity), "0 unless given"),
        Key::optional("acceleration", Shape::Along(Along::Acceleration), "0 unless given"),
    ],
);

pub(crate) static SUBSYSTEM: Schema = plain(
    "subsystem",
    "Another model file as a part of this machine; its names get the prefix `NAME.`.",
    &[
        Key::required("file", Text, "model file, relative to this one"),
        Key::optional("ground", Name, "`body.point` that carries its ground; the ground of this file unless given"),
        Key::optional("set", Map, "its parameters, in terms of this file's"),
    ],
);
