//! The six-axis arm of `benches/peers/arm.txt`, and random states of it as the peers draw them.

use bellcrank_math::Spatial;
use bellcrank_multibody::{Blueprint, Body, BodyId, Joint, JointKind, Machine, Place};

pub const AXES: usize = 6;
pub const STATES: usize = 256;

/// Positions, velocities and accelerations.
pub type State = [[f64; AXES]; 3];

pub fn machine() -> Machine<Spatial<f64>> {
    Machine::new(blueprint()).expect("builds")
}

fn blueprint() -> Blueprint<f64> {
    let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
    let mut bodies = vec![Body { mass: 0.0, center: [0.0; 3], inertia: [[0.0; 3]; 3] }];
    let mut joints = Vec::new();
    let lines = include_str!("../../../../benches/peers/arm.txt").lines().filter(|l| !l.starts_with('#'));
    for (i, line) in lines.enumerate() {
        let n: Vec<f64> = line.split_whitespace().map(|n| n.parse().expect("a number")).collect();
        let rotation = if n[0] == 0.0 { upright } else { [[1.0, 0.0, 0.0], [0.0, 0.0, -n[0]], [0.0, n[0], 0.0]] };
        let first = Place { body: BodyId(i), position: [n[1], n[2], n[3]], rotation };
        let second = Place { body: BodyId(i + 1), position: [0.0; 3], rotation: upright };
        let inertia = [[n[8], n[9], n[10]], [n[9], n[11], n[12]], [n[10], n[12], n[13]]];
        bodies.push(Body { mass: n[4], center: [n[5], n[6], n[7]], inertia });
        let kind = JointKind::Revolute { axis: [0.0, 0.0, 1.0] };
        joints.push(Joint { kind, places: Some([first, second]), start: Vec::new(), at_start: false });
    }
    Blueprint { gravity: [0.0, 0.0, -9.81], bodies, joints, forces: Vec::new(), flexible: Vec::new(), inputs: 0 }
}

/// Random states within 3 rad, 2 rad/s, 5 rad/s²: the generator of `pinocchio_arm.cpp`.
pub fn states() -> Vec<State> {
    let mut seed = 1_u64;
    let mut draw = |most: f64| {
        seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        most * (2.0 * ((seed >> 11) as f64 / 9_007_199_254_740_992.0) - 1.0)
    };
    let mut state = || {
        let axes: [[f64; 3]; AXES] = std::array::from_fn(|_| [draw(3.0), draw(2.0), draw(5.0)]);
        std::array::from_fn(|k| axes.map(|axis| axis[k]))
    };
    (0..STATES).map(|_| state()).collect()
}
