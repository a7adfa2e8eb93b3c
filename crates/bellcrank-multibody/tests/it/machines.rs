//! Machines that tests and benches share.

use crate::build::*;
use bellcrank_multibody::{Blueprint, Engine, JointKind, engine_for};

/// The assist manipulator's lift with these masses of links 1, 3 and 5 (kg).
pub fn lift_blueprint(masses: [f64; 3]) -> Blueprint<f64> {
    let (l31, l32, l5, l62, l42) = (0.732, 0.16, 0.95, 0.2, 0.1);
    let [m1, m3, m5] = masses;
    let (c1, c3, c5) = (l31 / 2.0, l5 / 2.0 - 0.05, l5 / 2.0);
    let bodies = vec![
        body(m1, [c1, 0.0], m1 * c1 * c1),
        body(0.0, [0.0, 0.0], 0.0),
        body(m3, [c3, 0.0], m3 * c3 * c3),
        body(0.0, [0.0, 0.0], 0.0),
        body(m5, [c5, 0.0], m5 * c5 * c5),
    ];
    let joints = vec![
        pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)),
        started(joint(JointKind::Prismatic { axis: X }, at(1, 0.0, 0.0, 0.0), at(2, 0.0, 0.0, 0.0)), &[l31]),
        started(pin(at(0, 0.0, l32, 0.0), at(3, 0.0, 0.0, 0.0)), &[0.0]),
        pin(at(0, 0.0, l32 + l62, 0.0), at(5, 0.0, 0.0, 0.0)),
        pin(at(3, l5, 0.0, 0.0), at(4, 0.0, 0.0, 0.0)),
        pin(at(5, l5, 0.0, 0.0), at(4, 0.0, l62, 0.0)),
        pin(at(3, l31, -l32, 0.0), at(2, 0.0, 0.0, 0.0)),
    ];
    let load = vec![force(at(4, l42, l62, 0.0), [0.0, -800.0, 0.0])];
    blueprint([0.0, -9.81, 0.0], bodies, joints, load)
}

/// The same, built.
pub fn lift(masses: [f64; 3]) -> Box<dyn Engine> {
    engine_for(true, &lift_blueprint(masses)).expect("builds")
}

/// N four-bars in a row: 2N + 1 rods of 1 m and 1 kg, one degree of freedom (IFToMM A02).
pub fn chain(n: usize) -> Blueprint<f64> {
    let rod = || body(1.0, [0.5, 0.0], 1.0 / 12.0);
    let upright = |i: usize| 1 + 2 * i;
    let mut bodies = vec![rod()];
    let mut joints = vec![started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[1.3])];
    for i in 1..=n {
        bodies.extend([rod(), rod()]);
        let (coupler, next) = (2 * i, upright(i));
        joints.push(started(pin(at(0, i as f64, 0.0, 0.0), at(next, 0.0, 0.0, 0.0)), &[1.3]));
        joints.push(started(pin(at(upright(i - 1), 1.0, 0.0, 0.0), at(coupler, 0.0, 0.0, 0.0)), &[-1.3]));
        joints.push(pin(at(coupler, 1.0, 0.0, 0.0), at(next, 1.0, 0.0, 0.0)));
    }
    blueprint([0.0, -9.81, 0.0], bodies, joints, Vec::new())
}
