//! Studies of modes against closed forms.

use std::f64::consts::TAU;

use bellcrank_results::{Findings, ModeKind, Modes, StudyResult};

use crate::support::{model, run};

/// Two cars on a rail, coupled by a spring; the first hangs on a spring and a damper.
fn cars(damping: f64) -> String {
    format!(
        r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]
[ground.points]
O = [0, 0]
[bodies.first]
mass = "2 kg"
inertia = 0
points = {{ O = [0, 0] }}
[bodies.second]
mass = "3 kg"
inertia = 0
points = {{ O = [0, 0] }}
[joints]
a = {{ kind = "prismatic", connects = ["ground.O", "first.O"], axis = "x" }}
b = {{ kind = "prismatic", connects = ["first.O", "second.O"], axis = "x" }}
[forces]
wall = {{ kind = "joint-spring", joint = "a", stiffness = "500 N/m", damping = "{damping} N*s/m" }}
link = {{ kind = "joint-spring", joint = "b", stiffness = "300 N/m" }}
"#
    )
}

const BOB: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0]
[bodies.bob]
mass = "2 kg"
center = [0, "-0.5 m"]
inertia = "0.1 kg*m^2"
points = { O = [0, 0] }
[joints]
hinge = { kind = "revolute", connects = ["ground.O", "bob.O"], start = "START" }
"#;

fn study(name: &str, machine: &str, keys: &str) -> StudyResult {
    let result = run(&model(name, &format!("{machine}\n[studies.a]\nkind = \"modes\"\n{keys}")), "a");
    assert!(result.failure.is_none(), "{:?}", result.failure);
    result
}

fn found(result: &StudyResult) -> &Modes {
    match &result.findings {
        Some(Findings::Modes(found)) => found,
        other => panic!("no modes: {other:?}"),
    }
}

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9 * b.abs().max(1.0)
}

#[test]
fn two_cars_swing_in_step_and_against_each_other() {
    let result = study("cars", &cars(0.0), "");
    let modes = &found(&result).modes;
    // (k₁ + k₂ − 2 ω²)(k₂ − 3 ω²) = k₂²
    let (k1, k2, m1, m2) = (500.0, 300.0, 2.0, 3.0);
    let (p, q): (f64, f64) = ((k1 + k2) / m1 + k2 / m2, k1 * k2 / (m1 * m2));
    for (mode, sign) in modes.iter().zip([-1.0, 1.0]) {
        let square = p / 2.0 + sign * (p * p / 4.0 - q).sqrt();
        assert!(near(mode.frequency, square.sqrt() / TAU), "{} {}", mode.frequency, square.sqrt() / TAU);
        assert!(mode.damping.abs() < 1e-12);
        // The second car in the world, against the first; the coordinate b is the difference.
        let [first, between] = [0, 1].map(|i| mode.shape[i].amplitude);
        assert!(near((first[0] + between[0]) / first[0], k2 / (k2 - m2 * square)), "{first:?} {between:?}");
        assert!(first[1] == 0.0 && between[1] == 0.0, "{first:?} {between:?}");
    }
    assert_eq!(modes.len(), 2);
}

#[test]
fn damping_is_told_and_overdamped_modes_decay() {
    let held = "hold = [\"b\"]\n";
    let light = study("light", &cars(10.0), held);
    let mode = &found(&light).modes[0];
    let (k, m, c) = (500.0_f64, 5.0, 10.0);
    assert!(near(mode.eigenvalue[0], -c / (2.0 * m)) && near(mode.damping, c / (2.0 * (k * m).sqrt())));
    assert!(near(mode.frequency, (k / m).sqrt() / TAU));
    let heavy = study("heavy", &cars(200.0), held);
    let both = found(&heavy);
    assert_eq!((both.modes.len(), both.freedom), (2, 1));
    assert!(both.modes.iter().all(|mode| both.kind(mode) == ModeKind::Decay));
    let product = both.modes[0].eigenvalue[0] * both.modes[1].eigenvalue[0];
    assert!(near(product, k / m), "{product}");
}

#[test]
fn a_pendulum_swings_about_its_equilibrium() {
    let bob = BOB.replace("START", "-20 deg");
    let result = study("bob", &bob, "");
    let expected = (2.0 * 9.81 * 0.5_f64 / 0.6).sqrt() / TAU;
    assert!(near(found(&result).modes[0].frequency, expected));
    assert_eq!(result.table.rows(), 1);
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
}

#[test]
fn a_position_that_is_left_is_told() {
    let top = study("top", &BOB.replace("START", "180 deg"), "equilibrium = false\n");
    assert!(top.warnings.iter().any(|told| told.contains("not stable: 1 mode grows")), "{:?}", top.warnings);
    let slant = study("slant", &BOB.replace("START", "60 deg"), "equilibrium = false\ncount = 1\n");
    assert!(slant.warnings.iter().any(|told| told.contains("no equilibrium")), "{:?}", slant.warnings);
    // Held elsewhere it has no modes at all.
    let held = study("held-bob", &BOB.replace("START", "60 deg"), "hold = [\"hinge\"]\n");
    assert_eq!((found(&held).freedom, found(&held).modes.len()), (0, 0));
}

#[test]
fn a_body_that_nothing_brings_back_moves_freely() {
    let free = cars(0.0).replace("wall =", "# wall =");
    let result = study("free-cars", &free, "");
    let both = found(&result);
    let kinds: Vec<ModeKind> = both.modes.iter().map(|mode| both.kind(mode)).collect();
    assert!(kinds.contains(&ModeKind::Drift) && kinds.contains(&ModeKind::Oscillation), "{kinds:?}");
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
}
