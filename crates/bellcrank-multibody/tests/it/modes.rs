//! The linearized machine against closed forms.

use crate::build::*;
use crate::forward::Nothing;
use bellcrank_multibody::{Force, JointKind, MechanismError, Value, engine_for};

#[test]
fn modes_of_a_double_pendulum() {
    // Two equal uniform rods of length L hinged in a row: ω² = 3 (1 ∓ 2/√7) g/L.
    let (l, g) = (0.7, 9.81);
    let rod = || body(1.7, [0.0, -l / 2.0], 1.7 * l * l / 12.0);
    let joints = vec![pin(at(0, 0.1, 0.2, 0.0), at(1, 0.0, 0.0, 0.0)), pin(at(1, 0.0, -l, 0.0), at(2, 0.0, 0.0, 0.0))];
    let b = blueprint([0.0, -g, 0.0], vec![rod(), rod()], joints, Vec::new());
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    let found = e.linearize(&[], &mut Nothing).expect("regular");
    assert_eq!(found.modes.len(), 2);
    assert!(found.unbalanced < 1e-12);
    for (mode, sign) in found.modes.iter().zip([-1.0, 1.0]) {
        let known = (3.0 * (1.0 + sign * 2.0 / 7.0_f64.sqrt()) * g / l).sqrt();
        assert!((mode.eigenvalue[1] / known - 1.0).abs() < 1e-10, "{mode:?} against {known}");
        assert!(mode.damping.abs() < 1e-10);
    }
    for (k, mode) in found.modes.iter().enumerate() {
        e.show_mode(k, 0.0);
        let (a, b) = (e.coordinate(coordinate(0)).velocity, e.coordinate(coordinate(1)).velocity);
        let w2 = mode.eigenvalue[1].powi(2) * l / g;
        // (3/2 − 4/3 w²) θ₁ − w²/2 θ₂ = 0 in absolute angles.
        assert!(((1.5 - w2 * 4.0 / 3.0) * a - 0.5 * w2 * (a + b)).abs() < 1e-8, "{a} {b}");
    }
}

fn oscillator(stiffness: f64, damping: f64) -> bellcrank_multibody::Linearized {
    let k = Value::Constant;
    let spring = Force::JointSpring {
        coordinate: coordinate(0),
        stiffness: k(stiffness),
        damping: k(damping),
        free_position: k(0.1),
        preload: k(0.0),
    };
    let slide = started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.1]);
    let b = blueprint([0.0, -9.81, 0.0], vec![body(1.3, [0.0, 0.0], 0.01)], vec![slide], vec![spring]);
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    e.linearize(&[], &mut Nothing).expect("regular")
}

#[test]
fn modes_of_a_damped_oscillator() {
    let natural = (130.0 / 1.3_f64).sqrt();
    let ratio = |damping: f64| damping / 2.0 / (130.0 * 1.3_f64).sqrt();
    let weak = oscillator(130.0, 2.6);
    assert!((weak.modes[0].frequency - natural / std::f64::consts::TAU).abs() < 1e-10);
    assert!((weak.modes[0].damping - ratio(2.6)).abs() < 1e-10);
    let (strong, z) = (oscillator(130.0, 60.0), ratio(60.0));
    let known = [-natural * (z - (z * z - 1.0).sqrt()), -natural * (z + (z * z - 1.0).sqrt())];
    assert_eq!(strong.modes.len(), 2);
    assert!((0..2).all(|i| (strong.modes[i].eigenvalue[0] - known[i]).abs() < 1e-9), "{strong:?}");
    let free = oscillator(0.0, 0.0);
    assert_eq!((free.modes.len(), free.modes[0].frequency), (1, 0.0));
}

#[test]
fn a_closed_loop_swings_as_its_energy_says() {
    // A parallelogram of two upright rods under a coupler, turned by 0.3 rad and held there by a torsion spring: one
    // freedom, I θ̈ = −k θ' + m g terms; all from the energy V(θ) and the mass I = Σ m r².
    let (l, m, mc, k, at_rest) = (0.8, 1.1, 2.3, 40.0, 0.3_f64);
    let rod = || body(m, [l / 2.0, 0.0], m * l * l / 12.0);
    let angle = std::f64::consts::FRAC_PI_2 + at_rest;
    let joints = vec![
        started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[angle]),
        started(pin(at(0, 1.0, 0.0, 0.0), at(2, 0.0, 0.0, 0.0)), &[angle]),
        pin(at(1, l, 0.0, 0.0), at(3, 0.0, 0.0, 0.0)),
        pin(at(2, l, 0.0, 0.0), at(3, 1.0, 0.0, 0.0)),
    ];
    let weight = 9.81 * l * (m + mc);
    // Balance at θ = 0.3: the spring's moment against that of the weights, weight·sin θ about upright.
    let spring = Force::JointSpring {
        coordinate: coordinate(0),
        stiffness: Value::Constant(k),
        damping: Value::Constant(0.0),
        free_position: Value::Constant(angle - weight * at_rest.sin() / k),
        preload: Value::Constant(0.0),
    };
    let b = blueprint([0.0, -9.81, 0.0], vec![rod(), rod(), body(mc, [0.5, 0.1], 0.2)], joints, vec![spring]);
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[(coordinate(0), angle)]).expect("assembles");
    let found = e.linearize(&[], &mut Nothing).expect("regular");
    let inertia = 2.0 * m * l * l / 3.0 + mc * l * l;
    let known = ((k - weight * at_rest.cos()) / inertia).sqrt();
    assert!(found.unbalanced < 1e-9);
    assert!((found.modes[0].eigenvalue[1] / known - 1.0).abs() < 1e-9, "{found:?} against {known}");
}

#[test]
fn a_coordinate_without_mass_is_named() {
    let slide = joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0));
    let b = blueprint([0.0, -9.81, 0.0], vec![body(0.0, [0.0, 0.0], 0.0)], vec![slide], Vec::new());
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    let error = e.linearize(&[], &mut Nothing).expect_err("nothing moves");
    assert_eq!(error, MechanismError::NoMass { mobile: vec![coordinate(0)] });
}
