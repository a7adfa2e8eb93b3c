//! Machines that tests and benches share.

use crate::build::*;
use bellcrank_multibody::{Axes, Blueprint, BodyId, Engine, Force, JointKind, Value, engine_for};

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
    chain_from(n, 1.3)
}

/// The same at an angle of the first rod.
pub fn chain_from(n: usize, angle: f64) -> Blueprint<f64> {
    let rod = || body(1.0, [0.5, 0.0], 1.0 / 12.0);
    let upright = |i: usize| 1 + 2 * i;
    let mut bodies = vec![rod()];
    let mut joints = vec![started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[angle])];
    for i in 1..=n {
        bodies.extend([rod(), rod()]);
        let (coupler, next) = (2 * i, upright(i));
        joints.push(started(pin(at(0, i as f64, 0.0, 0.0), at(next, 0.0, 0.0, 0.0)), &[angle]));
        joints.push(started(pin(at(upright(i - 1), 1.0, 0.0, 0.0), at(coupler, 0.0, 0.0, 0.0)), &[-angle]));
        joints.push(pin(at(coupler, 1.0, 0.0, 0.0), at(next, 1.0, 0.0, 0.0)));
    }
    blueprint([0.0, -9.81, 0.0], bodies, joints, Vec::new())
}

/// Andrews' squeezing mechanism (Schiehlen 1990; IVP test set `andrews`): joint 0 is the crank.
pub fn andrews() -> Blueprint<f64> {
    let m = [0.04325, 0.00365, 0.02373, 0.00706, 0.07050, 0.00706, 0.05498];
    let inertia = [2.194e-6, 4.410e-7, 5.255e-6, 5.667e-7, 1.169e-5, 5.667e-7, 1.912e-5];
    let center = [
        [0.00092, 0.0],
        [-0.0115, 0.0],
        [0.01043, -0.01874],
        [0.0, -(0.02 - 0.01421)],
        [0.02308, 0.00916],
        [0.02 - 0.01421, 0.0],
        [-0.00449, -0.01228],
    ];
    let bodies = (0..7).map(|i| body(m[i], center[i], inertia[i])).collect();
    let (ax, ay, bx, by, cx, cy) = (-0.06934, -0.00227, -0.03635, 0.03273, 0.014, 0.072);
    let pins = |a, b, start: f64| started(pin(a, b), &[start]);
    let joints = vec![
        pins(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0), -0.061_713_890_014_276_5),
        pins(at(1, 0.007, 0.0, 0.0), at(2, 0.0, 0.0, 0.0), 0.0),
        pins(at(0, bx, by, 0.0), at(3, 0.0, 0.0, 0.0), 0.455_279_819_163_070_4),
        pins(at(0, ax, ay, 0.0), at(5, 0.0, 0.0, 0.0), 0.487_364_979_543_842_6),
        pins(at(0, ax, ay, 0.0), at(7, 0.0, 0.0, 0.0), 1.230_547_444_549_821_2),
        pins(at(5, 0.04, 0.0, 0.0), at(4, 0.0, 0.0, 0.0), 0.222_668_390_165_885_9),
        pins(at(7, 0.0, -0.04, 0.0), at(6, 0.0, 0.0, 0.0), -0.222_668_390_165_885_9),
        pin(at(2, -0.028, 0.0, 0.0), at(3, 0.0, -0.035, 0.0)),
        pin(at(4, 0.0, -0.02, 0.0), at(3, 0.0, -0.035, 0.0)),
        pin(at(6, 0.02, 0.0, 0.0), at(3, 0.0, -0.035, 0.0)),
    ];
    let zero = Value::Constant(0.0);
    let forces = vec![
        Force::Torque { on: BodyId(1), vector: [zero, zero, Value::Constant(0.033)], axes: Axes::World },
        Force::Spring {
            between: [at(0, cx, cy, 0.0), at(3, 0.02, -0.018, 0.0)],
            stiffness: Value::Constant(4530.0),
            damping: zero,
            free_length: Value::Constant(0.07785),
            preload: zero,
        },
    ];
    blueprint([0.0; 3], bodies, joints, forces)
}
