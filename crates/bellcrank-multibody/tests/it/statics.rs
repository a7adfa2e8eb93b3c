//! Equilibria against closed forms.

use crate::build::*;
use bellcrank_multibody::{Force, Readings, Value, engine_for};

fn no_inputs(_: &dyn Readings<f64>, _: &mut [f64]) {}

/// A bar of mass m pinned at O, with a torsion spring: m g c cos(θ) = −k (θ − θ₀).
#[test]
fn bar_on_a_torsion_spring() {
    let (m, c, g, k) = (3.7, 0.41, 9.81, 9.0);
    let spring = Force::JointSpring {
        coordinate: coordinate(0),
        stiffness: Value::Constant(k),
        damping: Value::Constant(1.0),
        free_position: Value::Constant(0.3),
        preload: Value::Constant(0.7),
    };
    let b = blueprint(
        [0.0, -g, 0.0],
        vec![body(m, [c, 0.0], 0.2)],
        vec![started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.1])],
        vec![spring],
    );
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    let found = e.equilibrium(&[], &mut no_inputs).expect("finds");
    let theta = e.coordinate(coordinate(0)).position;
    assert!((m * g * c * theta.cos() + k * (theta - 0.3) - 0.7).abs() < 1e-9);
    assert!((found.stiffness[0] - (k - m * g * c * theta.sin())).abs() < 1e-9 && found.stable);
    assert!((e.reaction(bellcrank_multibody::JointId(0)).force[1] - m * g).abs() < 1e-9);
}

/// A double pendulum hangs straight down from any start; upside down it is found unstable.
#[test]
fn double_pendulum_hangs() {
    let make = |start: [f64; 2]| {
        let joints = vec![
            started(pin(at(0, 0.1, 0.2, 0.0), at(1, 0.0, 0.0, 0.0)), &[start[0]]),
            started(pin(at(1, 0.7, 0.0, 0.0), at(2, 0.0, 0.0, 0.0)), &[start[1]]),
        ];
        let b = blueprint(
            [0.0, -9.81, 0.0],
            vec![body(2.0, [0.3, 0.0], 0.1), body(1.3, [0.25, 0.0], 0.05)],
            joints,
            vec![],
        );
        let mut e = engine_for(true, &b).expect("builds");
        e.assemble(&[]).expect("assembles");
        e
    };
    let mut e = make([0.4, 1.1]);
    let down = e.equilibrium(&[], &mut no_inputs).expect("finds");
    let q: Vec<f64> = (0..2).map(|j| e.coordinate(coordinate(j)).position).collect();
    assert!((q[0] + std::f64::consts::FRAC_PI_2).abs() < 1e-9 && q[1].abs() < 1e-9 && down.stable, "{q:?}");
    let mut e = make([std::f64::consts::FRAC_PI_2, 0.0]);
    let up = e.equilibrium(&[], &mut no_inputs).expect("finds");
    assert!(!up.stable && up.stiffness.iter().all(|s| *s < 0.0));
}
