//! Short ways to write blueprints.

use bellcrank_multibody::{Axes, Blueprint, Body, BodyId, Coordinate, Force, Joint, JointId, JointKind, Place, Value};

pub const X: [f64; 3] = [1.0, 0.0, 0.0];
pub const Z: [f64; 3] = [0.0, 0.0, 1.0];
pub const UPRIGHT: [[f64; 3]; 3] = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

/// A place with the body's axes.
pub fn at(body: usize, x: f64, y: f64, z: f64) -> Place<f64> {
    Place { body: BodyId(body), position: [x, y, z], rotation: UPRIGHT }
}

/// A joint without a start.
pub fn joint(kind: JointKind<f64>, first: Place<f64>, second: Place<f64>) -> Joint<f64> {
    Joint { kind, places: Some([first, second]), start: Vec::new(), at_start: false }
}

/// The same with starts.
pub fn started(mut joint: Joint<f64>, start: &[f64]) -> Joint<f64> {
    joint.start = start.iter().map(|s| Some(*s)).collect();
    joint
}

pub fn pin(first: Place<f64>, second: Place<f64>) -> Joint<f64> {
    joint(JointKind::Revolute { axis: Z }, first, second)
}

/// A planar body.
pub fn body(mass: f64, center: [f64; 2], inertia: f64) -> Body<f64> {
    let mut tensor = [[0.0; 3]; 3];
    tensor[2][2] = inertia;
    Body { mass, center: [center[0], center[1], 0.0], inertia: tensor }
}

pub fn blueprint(
    gravity: [f64; 3],
    bodies: Vec<Body<f64>>,
    joints: Vec<Joint<f64>>,
    forces: Vec<Force<f64>>,
) -> Blueprint<f64> {
    let ground = body(0.0, [0.0, 0.0], 0.0);
    Blueprint {
        gravity,
        bodies: std::iter::once(ground).chain(bodies).collect(),
        joints,
        forces,
        flexible: Vec::new(),
        inputs: 0,
    }
}

pub fn force(at: Place<f64>, vector: [f64; 3]) -> Force<f64> {
    Force::Point { at, vector: vector.map(Value::Constant), axes: Axes::World }
}

pub fn coordinate(joint: usize) -> Coordinate {
    Coordinate { joint: JointId(joint), index: 0 }
}
