//! Kinds of joints and forces, and their keys.

use bellcrank_doc::Dimension as D;

use super::keys::Shape::{Axis, Boolean, List, Name, Names, OneOf, Signal, SignalVector, Value, Values};
use super::keys::{Along, Key, Kind, Schema, Shape};

const fn kind(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Kind {
    Kind { name, doc, keys }
}

const CONNECTS: Key = Key::required("connects", Names, "two points, [\"body.point\", \"body.point\"]");
const START: Key =
    Key::optional("start", Values, "first guess of the coordinate (a list for several); selects the assembly branch");
const START_VELOCITY: Key = Key::optional("start_velocity", Values, "first guess of its rate");
const AT_START: Key = Key::optional("at_start", Boolean, "hold the start exactly during assembly");
const AXIS_Z: Key = Key::optional("axis", Axis, "axis of the first point's frame; z unless given");
const AXIS: Key = Key::required("axis", Axis, "axis of the first point's frame: \"x\", \"y\", \"z\" or a vector");

pub(crate) static JOINT: Schema = Schema {
    name: "joint",
    doc: "Connects two points; the coordinate measures the second against the first.",
    keys: &[],
    kinds: &[
        kind("revolute", "turns about an axis: angle", &[CONNECTS, START, START_VELOCITY, AT_START, AXIS_Z]),
        kind("prismatic", "slides along an axis: distance", &[CONNECTS, START, START_VELOCITY, AT_START, AXIS]),
        kind(
            "cylindrical",
            "slides along and turns about an axis: distance, angle",
            &[CONNECTS, START, START_VELOCITY, AT_START, AXIS],
        ),
        kind(
            "screw",
            "turns about an axis and advances with it: angle",
            &[
                CONNECTS,
                START,
                START_VELOCITY,
                AT_START,
                AXIS,
                Key::required("pitch", Value(D::LENGTH), "advance a full turn"),
            ],
        ),
        kind(
            "universal",
            "turns about an axis of each point: two angles",
            &[
                CONNECTS,
                START,
                START_VELOCITY,
                AT_START,
                Key::required("axis", Axis, "axis on the first point"),
                Key::required("axis2", Axis, "axis on the second point, perpendicular to the first"),
            ],
        ),
        kind("spherical", "turns any way: roll, pitch, yaw", &[CONNECTS, START, START_VELOCITY, AT_START]),
        kind(
            "planar",
            "moves in the x-y plane of the first point: x, y, angle",
            &[CONNECTS, START, START_VELOCITY, AT_START],
        ),
        kind(
            "free",
            "moves any way: x, y, z, roll, pitch, yaw (in the plane x, y, angle)",
            &[CONNECTS, START, START_VELOCITY, AT_START],
        ),
        kind("weld", "does not move", &[CONNECTS]),
        kind(
            "distance",
            "distance of two points: held, or a coordinate without `length`",
            &[
                CONNECTS,
                START,
                START_VELOCITY,
                AT_START,
                Key::optional("length", Value(D::LENGTH), "held distance; without it the distance is a coordinate"),
            ],
        ),
        kind(
            "point-on-line",
            "the second point stays on a line of the first: place on the line",
            &[CONNECTS, START, START_VELOCITY, AT_START, AXIS],
        ),
        kind(
            "coupler",
            "two coordinates move together: b = ratio·a + offset",
            &[
                Key::required("joints", Names, "two coordinates, [\"a\", \"b\"]; `a.1` for one of several"),
                Key::required("ratio", Values, "b over a"),
                Key::optional("offset", Shape::Along(Along::Position), "b where a is 0; 0 unless given"),
            ],
        ),
    ],
    usual: None,
};

const AXES: Key = Key::optional("axes", OneOf(&["world", "body"]), "axes of the components; world unless given");
const BETWEEN: Key = Key::required("between", Names, "two points, [\"body.point\", \"body.point\"]");
const COORDINATE: Key = Key::required("joint", Name, "joint, or `joint.1` for one of several coordinates");
const BUSHING_LENGTHS: &[usize] = &[3, 6];

pub(crate) static FORCE: Schema = Schema {
    name: "force",
    doc: "A force element. Any of its values may be an expression of `time` and of signals.",
    keys: &[],
    kinds: &[
        kind(
            "force",
            "a force at a point",
            &[
                Key::required("on", Name, "\"body.point\""),
                Key::required("vector", SignalVector(D::FORCE), "components"),
                AXES,
            ],
        ),
        kind(
            "torque",
            "a free moment on a body",
            &[
                Key::required("on", Name, "body"),
                Key::optional("vector", SignalVector(D::MOMENT), "components (space)"),
                Key::optional("value", Signal(D::MOMENT), "about z (plane)"),
                AXES,
            ],
        ),
        kind(
            "effort",
            "along a joint coordinate",
            &[
                COORDINATE,
                Key::required("value", Shape::Along(Along::Effort), "pushes the coordinate up when positive"),
            ],
        ),
        kind(
            "spring",
            "spring and damper between two points",
            &[
                BETWEEN,
                Key::optional("stiffness", Signal(D::STIFFNESS), "0 unless given"),
                Key::optional("damping", Signal(D::DAMPING), "0 unless given"),
                Key::optional("free_length", Signal(D::LENGTH), "0 unless given"),
                Key::optional("preload", Signal(D::FORCE), "pushes the points apart when positive; 0 unless given"),
            ],
        ),
        kind(
            "joint-spring",
            "spring and damper on a joint coordinate",
            &[
                COORDINATE,
                Key::optional("stiffness", Shape::Along(Along::Stiffness), "0 unless given"),
                Key::optional("damping", Shape::Along(Along::Damping), "0 unless given"),
                Key::optional("free_position", Shape::Along(Along::Position), "0 unless given"),
                Key::optional("preload", Shape::Along(Along::Effort), "0 unless given"),
            ],
        ),
        kind(
            "friction",
            "friction in a joint",
            &[
                COORDINATE,
                Key::optional("coulomb", Signal(D::NONE), "coefficient; 0 unless given"),
                Key::optional("static", Signal(D::NONE), "coefficient at the onset of motion"),
                Key::optional("stribeck_velocity", Shape::Along(Along::Velocity), "width of the Stribeck drop"),
                Key::optional("viscous", Shape::Along(Along::Damping), "0 unless given"),
                Key::optional("radius", Signal(D::LENGTH), "where friction acts on a turning joint"),
                Key::optional(
                    "smoothing_velocity",
                    Shape::Along(Along::Velocity),
                    "below it friction grows smoothly with the speed; without it friction can stick",
                ),
            ],
        ),
        kind(
            "stop",
            "limits of a joint coordinate",
            &[
                COORDINATE,
                Key::optional("min", Shape::Along(Along::Position), "lower limit"),
                Key::optional("max", Shape::Along(Along::Position), "upper limit"),
                Key::optional("stiffness", Shape::Along(Along::Stiffness), "of a soft stop"),
                Key::optional("damping", Shape::Along(Along::Damping), "of a soft stop; 0 unless given"),
                Key::optional(
                    "restitution",
                    Signal(D::NONE),
                    "of a hard stop, 0 to 1: part of the speed an impact leaves",
                ),
            ],
        ),
        kind(
            "bushing",
            "springs and dampers in all directions between two points",
            &[
                BETWEEN,
                Key::required(
                    "stiffness",
                    List(D::STIFFNESS, BUSHING_LENGTHS),
                    "x, y, z and about x, y, z of the first point; in the plane x, y and the angle",
                ),
                Key::optional("damping", List(D::DAMPING, BUSHING_LENGTHS), "likewise; 0 unless given"),
            ],
        ),
    ],
    usual: None,
};
