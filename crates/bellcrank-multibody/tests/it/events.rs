//! Events in machines with loops: stops, friction, stiffness.

use crate::build::*;
use crate::forward::{Nothing, run_to};
use bellcrank_multibody::{
    Blueprint, Coordinate, Dynamics, Engine, Event, EventKind, Force, ForceId, JointId, JointKind, Method, Reading,
    Readings, Seeded, Surroundings, Value, engine_for,
};

fn constant(x: f64) -> Value<f64> {
    Value::Constant(x)
}

fn stop(coordinate: Coordinate, limits: [Option<f64>; 2], restitution: f64) -> Force<f64> {
    let [min, max] = limits.map(|l| l.map(constant));
    Force::Stop {
        coordinate,
        min,
        max,
        stiffness: constant(0.0),
        damping: constant(0.0),
        restitution: Some(constant(restitution)),
    }
}

fn friction(coordinate: Coordinate, coulomb: f64, radius: Option<f64>) -> Force<f64> {
    Force::Friction {
        coordinate,
        coulomb: constant(coulomb),
        static_coefficient: None,
        stribeck_velocity: None,
        viscous: constant(0.0),
        radius: radius.map(constant),
        smoothing_velocity: None,
    }
}

/// A slider-crank under gravity, offset, the guide last: its coordinate closes the loop.
fn slider_crank(forces: Vec<Force<f64>>) -> Blueprint<f64> {
    let joints = vec![
        started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.7]),
        started(pin(at(1, 0.3, 0.0, 0.0), at(2, 0.0, 0.0, 0.0)), &[-1.2]),
        pin(at(2, 0.8, 0.0, 0.0), at(3, 0.0, 0.0, 0.0)),
        started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.05, 0.0), at(3, 0.0, 0.0, 0.0)), &[0.9]),
    ];
    let bodies = vec![body(1.1, [0.14, 0.01], 0.02), body(1.9, [0.4, -0.02], 0.11), body(2.3, [0.01, 0.02], 0.01)];
    blueprint([0.9, -9.81, 0.0], bodies, joints, forces)
}

fn begun(b: &Blueprint<f64>, dynamics: &Dynamics) -> Box<dyn Engine> {
    let mut e = engine_for(true, b).expect("builds");
    e.assemble(&[(coordinate(0), 0.7)]).expect("assembles");
    e.begin(dynamics, &mut Nothing).expect("begins");
    e
}

fn energy(e: &dyn Engine) -> f64 {
    e.energy().kinetic + e.energy().potential
}

#[test]
fn elastic_impacts_in_a_loop_keep_the_energy() {
    let guide = coordinate(3);
    let b = slider_crank(vec![stop(guide, [Some(0.75), Some(1.02)], 1.0)]);
    let mut e = begun(&b, &Dynamics { tolerance: 1e-9, ..Dynamics::free() });
    let before = energy(&*e);
    let events = run_to(&mut *e, 3.0, &mut Nothing);
    let impacts = events.iter().filter(|e| matches!(e.kind, EventKind::Impact { .. })).count();
    assert!(impacts >= 4 && impacts == events.len(), "{events:?}");
    assert!((energy(&*e) - before).abs() < 1e-6, "{}", energy(&*e) - before);
    assert!(e.checks().closure < 1e-13);
    let place = e.coordinate(guide).position;
    assert!((0.75..=1.02).contains(&place));
}

#[test]
fn plastic_impacts_close_the_stop_until_it_would_pull() {
    let guide = coordinate(3);
    let b = slider_crank(vec![stop(guide, [None, Some(1.02)], 0.0)]);
    let mut e = begun(&b, &Dynamics { velocities: vec![(coordinate(0), -2.0)], ..Dynamics::free() });
    let events = run_to(&mut *e, 3.0, &mut Nothing);
    let first = events.iter().find(|e| matches!(e.kind, EventKind::Impact { .. })).expect("hits");
    let EventKind::Impact { upper: true, speed, .. } = first.kind else { unreachable!("{first:?}") };
    assert!(speed > 0.0);
    // With e = 0 every impact leaves the guide at rest: the stop is touched, or the slider turns back.
    for pair in events.windows(2) {
        if let [Event { kind: EventKind::Contact { .. }, time }, next] = pair {
            assert!(matches!(next.kind, EventKind::Release { upper: true, .. }) && next.time >= *time, "{events:?}");
        }
    }
    assert!(e.coordinate(guide).position <= 1.02 + 1e-9);
}

#[test]
fn friction_in_a_closing_joint_brings_the_machine_to_rest() {
    let b = slider_crank(vec![friction(coordinate(3), 0.25, None), friction(coordinate(2), 0.3, Some(0.02))]);
    let mut e = begun(&b, &Dynamics::free());
    let mut before = energy(&*e);
    let mut events = Vec::new();
    for k in 1..=80 {
        events.extend(run_to(&mut *e, 0.1 * f64::from(k), &mut Nothing));
        let now = energy(&*e);
        assert!(now <= before + 1e-6, "friction gave {} J at {}", now - before, 0.1 * f64::from(k));
        before = now;
    }
    assert!(matches!(events.last(), Some(Event { kind: EventKind::Stick { .. }, .. })), "{events:?}");
    assert!(e.energy().kinetic < 1e-20 && e.checks().balance < 1e-9);
}

/// Pulls the first coordinate along at a constant speed.
struct Pull(f64);

impl Surroundings for Pull {
    fn inputs(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, t: f64, motion: &mut [Reading]) {
        motion[0] = Reading { position: self.0 * t, velocity: self.0, acceleration: 0.0 };
    }
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

#[test]
fn a_block_pulled_by_a_spring_sticks_and_slips() {
    // Coulomb friction, μ_s = 0.4, with a narrow drop to the sliding coefficient: the block
    // waits until the spring carries μ_s m g, and slips when it does.
    let (k, m, v, mu_s, mu) = (60.0, 1.3, 0.11, 0.4, 0.25);
    let slide = |body: usize| joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(body, 0.0, 0.0, 0.0));
    let spring = Force::Spring {
        between: [at(2, 0.0, 0.0, 0.0), at(1, 1.0, 0.0, 0.0)],
        stiffness: constant(k),
        damping: constant(0.0),
        free_length: constant(1.0),
        preload: constant(0.0),
    };
    let mut law = friction(coordinate(1), mu, None);
    if let Force::Friction { static_coefficient, stribeck_velocity, .. } = &mut law {
        (*static_coefficient, *stribeck_velocity) = (Some(constant(mu_s)), Some(constant(1e-6)));
    }
    let b = blueprint(
        [0.0, -9.81, 0.0],
        vec![body(0.5, [0.0, 0.0], 0.01), body(m, [0.0, 0.0], 0.01)],
        vec![slide(1), slide(2)],
        vec![spring, law],
    );
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    let mut around = Pull(v);
    e.begin(&Dynamics { driven: vec![coordinate(0)], tolerance: 1e-8, ..Dynamics::free() }, &mut around)
        .expect("begins");
    let events = run_to(&mut *e, 8.0, &mut around);
    let first = mu_s * m * 9.81 / (k * v);
    assert!(matches!(events[0].kind, EventKind::Slip { force: ForceId(1), rising: true }));
    assert!((events[0].time - first).abs() < 1e-8, "{} against {first}", events[0].time);
    // Slips and sticks follow each other; all periods are alike.
    for (i, event) in events.iter().enumerate() {
        let sticks = matches!(event.kind, EventKind::Stick { .. });
        assert_eq!(sticks, i % 2 == 1, "{events:?}");
    }
    let slips: Vec<f64> = events.iter().step_by(2).map(|e| e.time).collect();
    assert!(slips.len() >= 4);
    // After the drop to μ: the block swings about the sliding equilibrium for half a period (and the little that the
    // pull adds); it sticks with the spring as far below as it was above: 2 (μ_s − μ) m g / k to be pulled again.
    let period = slips[2] - slips[1];
    let waits = 2.0 * (mu_s - mu) * m * 9.81 / (k * v);
    let w = (k / m).sqrt();
    let slides = 2.0 * (std::f64::consts::PI - ((mu_s - mu) * 9.81 / (w * v)).atan()) / w;
    assert!((period - (waits + slides)).abs() < 1e-3, "{period} against {}", waits + slides);
}

#[test]
fn hard_springs_call_for_the_implicit_method() {
    // A heavy stop: stiffness 10⁸ N/m, damping near critical; the automatic choice changes over.
    let k = constant;
    let soft = Force::Stop {
        coordinate: coordinate(0),
        min: Some(k(0.0)),
        max: None,
        stiffness: k(1e8),
        damping: k(4e5),
        restitution: None,
    };
    let slide = started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.1]);
    let b = blueprint([-9.81, 0.0, 0.0], vec![body(1.3, [0.0, 0.0], 0.01)], vec![slide], vec![soft]);
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    e.begin(&Dynamics::free(), &mut Nothing).expect("begins");
    run_to(&mut *e, 5.0, &mut Nothing);
    let effort = e.solver_effort();
    let rests = -1.3 * 9.81 / 1e8;
    assert!((e.coordinate(coordinate(0)).position - rests).abs() < 1e-9, "{effort:?}");
    assert!(effort.implicit_steps > 0 && effort.evaluations < 40_000, "{effort:?}");
}

#[test]
fn quaternions_stay_units_in_both_methods() {
    let top = blueprint(
        [0.0, 0.0, -9.81],
        vec![bellcrank_multibody::Body {
            mass: 15.0,
            center: [0.0, 1.0, 0.0],
            inertia: [[0.234_375, 0.0, 0.0], [0.0, 0.468_75, 0.0], [0.0, 0.0, 0.234_375]],
        }],
        vec![started(joint(JointKind::Spherical, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.0; 3])],
        Vec::new(),
    );
    let velocities: Vec<(Coordinate, f64)> = [0.0, 150.0, -4.61538]
        .iter()
        .enumerate()
        .map(|(index, w)| (Coordinate { joint: JointId(0), index }, *w))
        .collect();
    let known = [0.605_550_561_377_119_8, 0.598_957_681_694_915_2, -0.523_983_027_433_000_2];
    for (method, fixed_step, near) in [
        (Method::Explicit, None, 1e-6),
        (Method::GeneralizedAlpha { spectral_radius: 0.9 }, Some(1e-4), 1e-3),
        (Method::GeneralizedAlpha { spectral_radius: 0.9 }, Some(0.5e-4), 2.5e-4),
    ] {
        let mut e = engine_for(false, &top).expect("builds");
        e.assemble(&[]).expect("assembles");
        let dynamics =
            Dynamics { method, fixed_step, velocities: velocities.clone(), tolerance: 1e-7, ..Dynamics::free() };
        e.begin(&dynamics, &mut Nothing).expect("begins");
        run_to(&mut *e, 0.2, &mut Nothing);
        let p = e.point(bellcrank_multibody::BodyId(1), [0.0, 1.0, 0.0]).position;
        let apart = (0..3).fold(0.0, |m: f64, i| m.max((p[i] - known[i]).abs()));
        assert!(apart < near, "{method:?} {fixed_step:?}: {apart}");
        let length = p.iter().map(|x| x * x).sum::<f64>().sqrt();
        assert!((length - 1.0).abs() < 1e-14, "the top has grown to {length}");
    }
}

#[test]
fn rows_of_four_bars_stay_on_their_branch() {
    // Uprights of all four-bars stay parallel through the stretched poses, whatever the tolerance.
    for (n, tolerances) in [(2, &[1e-5, 1e-7, 1e-9, 1e-10, 1e-11, 1e-12][..]), (40, &[1e-5, 1e-7, 1e-8, 1e-9][..])] {
        for &tolerance in tolerances {
            let mut e = engine_for(true, &crate::machines::chain_from(n, std::f64::consts::FRAC_PI_2)).expect("builds");
            e.assemble(&[]).expect("assembles");
            let velocities = vec![(coordinate(0), -1.0)];
            let dynamics = Dynamics { velocities, tolerance, breaks: vec![3.0], ..Dynamics::free() };
            e.begin(&dynamics, &mut Nothing).expect("begins");
            run_to(&mut *e, 3.0, &mut Nothing);
            let omega = |upright: usize| e.body(bellcrank_multibody::BodyId(1 + 2 * upright)).omega[2];
            let apart = (1..=n).fold(0.0, |m: f64, i| m.max((omega(i) - omega(0)).abs()));
            assert!(apart < 1e-9, "{n} four-bars, tolerance {tolerance}: {apart}");
            // Upright at the start: the energy gives the speed at any angle.
            let (count, angle) = (n as f64, e.coordinate(coordinate(0)).position);
            let (inertia, weight) = ((count + 1.0) / 3.0 + count, 9.81 * ((count + 1.0) / 2.0 + count));
            let speed = (1.0 + 2.0 * weight / inertia * (1.0 - angle.sin())).sqrt();
            assert!((omega(0).abs() - speed).abs() < 1e3 * tolerance.max(1e-10));
        }
    }
}

#[test]
fn soft_stops_that_are_touched_together_are_both_told() {
    // Two sliders that a coupler ties: both touch their stops at one time.
    let soft = |joint: usize, min: f64| Force::Stop {
        coordinate: coordinate(joint),
        min: Some(constant(min)),
        max: None,
        stiffness: constant(4e5),
        damping: constant(50.0),
        restitution: None,
    };
    let slide = |body: usize, y: f64| {
        started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, y, 0.0), at(body, 0.0, 0.0, 0.0)), &[0.1])
    };
    let tie = bellcrank_multibody::Joint {
        kind: JointKind::Coupler { a: coordinate(0), b: coordinate(1), ratio: 1.0, offset: 0.0 },
        places: None,
        start: Vec::new(),
        at_start: false,
    };
    let b = blueprint(
        [-9.81, 0.0, 0.0],
        vec![body(1.3, [0.0, 0.0], 0.01), body(2.1, [0.0, 0.0], 0.01)],
        vec![slide(1, 0.0), slide(2, 0.3), tie],
        vec![soft(0, 0.02), soft(1, 0.02)],
    );
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    e.begin(&Dynamics { tolerance: 1e-5, ..Dynamics::free() }, &mut Nothing).expect("begins");
    let events = run_to(&mut *e, 0.2, &mut Nothing);
    let touch = (2.0 * 0.08 / 9.81_f64).sqrt();
    let contacts: Vec<&Event> = events.iter().filter(|e| matches!(e.kind, EventKind::Contact { .. })).collect();
    assert!(contacts.len() >= 2, "{events:?}");
    assert!(contacts[..2].iter().all(|e| (e.time - touch).abs() < 1e-9), "{events:?} {touch}");
    let releases = events.iter().filter(|e| matches!(e.kind, EventKind::Release { .. })).count();
    assert_eq!(releases % 2, 0, "{events:?}");
}
