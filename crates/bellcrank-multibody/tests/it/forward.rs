//! Forward dynamics against theory and published cases.

use crate::build::*;
use crate::machines::*;
use crate::random::{Dice, largest, prepared, random_mechanism, solve};
use bellcrank_multibody::{
    Actuation, Advance, Blueprint, Body, BodyId, Coordinate, Dynamics, Engine, Event, EventKind, Force, ForceId,
    JointId, JointKind, MechanismError, Method, Reading, Readings, Seeded, SolverEffort, Surroundings, Value,
    engine_for,
};

/// Nothing around: no inputs, no drives, no switches.
pub struct Nothing;

impl Surroundings for Nothing {
    fn inputs(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, _: f64, _: &mut [Reading]) {}
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// On to a time, collecting events.
pub fn run_to(e: &mut dyn Engine, time: f64, around: &mut dyn Surroundings) -> Vec<Event> {
    let mut events = Vec::new();
    loop {
        match e.advance(time, around).expect("goes on") {
            Advance::Reached => return events,
            Advance::Event(event) => events.push(event),
            Advance::Working => {}
        }
    }
}

#[test]
fn andrews_squeezer() {
    // Quad-precision solutions of two models (test-set equations, absolute coordinates).
    let known = [
        (0.005, 0.211_076_385_903_266_7, 151.010_701_269_234_35, 65_664.770_859_532_07),
        (0.010, 2.160_113_131_531_526_5, 711.923_152_831_104, 209_058.278_532_541_17),
        (0.015, 5.655_429_749_991_794, 441.701_993_255_252_4, -39_300.234_413_648_88),
        (0.030, 15.810_771_195_353_707, 1_139.920_302_259_106, -24_631.763_122_874_63),
    ];
    for tolerance in [1e-4, 1e-6, 1e-8, 1e-10] {
        let mut e = engine_for(true, &andrews()).expect("builds");
        e.assemble(&[(coordinate(0), -0.061_713_890_014_276_5)]).expect("assembles");
        let begun = e.begin(&Dynamics { tolerance, ..Dynamics::free() }, &mut Nothing).expect("begins");
        assert_eq!(begun.freedom, 1);
        for (time, position, velocity, acceleration) in known {
            run_to(&mut *e, time, &mut Nothing);
            let crank = e.coordinate(coordinate(0));
            assert!((crank.position - position).abs() < tolerance.max(1e-9), "{tolerance} {time} {crank:?}");
            assert!((crank.velocity / velocity - 1.0).abs() < tolerance.max(1e-9), "{tolerance} {time} {crank:?}");
            assert!((crank.acceleration / acceleration - 1.0).abs() < 20.0 * tolerance, "{tolerance} {time} {crank:?}");
            assert!(e.checks().closure < 1e-14 && e.checks().balance < 1e-10);
        }
    }
}

#[test]
fn pendulum_period() {
    // IFToMM A01: a point mass on a rod of 1 m let go from the horizontal.
    let pendulum = blueprint(
        [0.0, -9.81, 0.0],
        vec![body(1.0, [-1.0, 0.0], 0.0)],
        vec![started(joint(JointKind::Revolute { axis: Z }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.0])],
        Vec::new(),
    );
    let mut e = engine_for(true, &pendulum).expect("builds");
    e.assemble(&[]).expect("assembles");
    e.begin(&Dynamics { tolerance: 1e-10, ..Dynamics::free() }, &mut Nothing).expect("begins");
    run_to(&mut *e, 2.367_841_947_576_237_4, &mut Nothing);
    let p = e.coordinate(coordinate(0));
    assert!(p.position.abs() < 1e-8 && p.velocity.abs() < 1e-8);
}

/// A block on a line with gravity `g` along it (negative: falling back), and what forces it meets.
fn block(g: f64, start: f64, forces: Vec<Force<f64>>) -> Box<dyn Engine> {
    let slide = started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[start]);
    let b = blueprint([g, -9.81, 0.0], vec![body(1.3, [0.0, 0.0], 0.01)], vec![slide], forces);
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    e
}

fn stop(min: f64, restitution: f64) -> Force<f64> {
    let k = Value::Constant;
    Force::Stop {
        coordinate: coordinate(0),
        min: Some(k(min)),
        max: None,
        stiffness: k(0.0),
        damping: k(0.0),
        restitution: Some(k(restitution)),
    }
}

fn friction(coulomb: f64) -> Force<f64> {
    Force::Friction {
        coordinate: coordinate(0),
        coulomb: Value::Constant(coulomb),
        static_coefficient: None,
        stribeck_velocity: None,
        viscous: Value::Constant(0.0),
        radius: None,
        smoothing_velocity: None,
    }
}

#[test]
fn a_bouncing_mass_comes_to_rest() {
    // h = 1 m, e = 0.8: impacts at t0 = √(2h/g), t0 (1 + 2e), ...; rest at t0 (1 + e)/(1 − e).
    let mut e = block(-9.81, 1.0, vec![stop(0.0, 0.8)]);
    e.begin(&Dynamics::free(), &mut Nothing).expect("begins");
    let events = run_to(&mut *e, 5.0, &mut Nothing);
    let impacts: Vec<&Event> = events.iter().filter(|e| matches!(e.kind, EventKind::Impact { .. })).collect();
    for (event, known) in
        impacts.iter().zip([0.451_523_640_985_730_9, 1.173_961_466_562_900_1, 1.751_911_727_024_683_5])
    {
        assert!((event.time - known).abs() < 1e-9, "{} against {known}", event.time);
    }
    let rest = events.iter().find(|e| matches!(e.kind, EventKind::Contact { .. })).expect("comes to rest");
    assert!((rest.time - 4.063_712_768_871_579).abs() < 1e-6, "{}", rest.time);
    assert_eq!(events.len(), impacts.len() + 1);
    let EventKind::Impact { speed, impulse, .. } = impacts[0].kind else { unreachable!() };
    assert!((speed - (2.0 * 9.81_f64).sqrt()).abs() < 1e-9 && (impulse - 1.3 * 1.8 * speed).abs() < 1e-9);
    assert!((e.force(ForceId(0)).effort - 1.3 * 9.81).abs() < 1e-9, "the stop carries the weight");
}

#[test]
fn friction_stops_and_holds() {
    // Sliding at 3 m/s with μ = 0.3: rest after v/(μ g), at v²/(2 μ g).
    let mut e = block(0.0, 0.0, vec![friction(0.3)]);
    let velocities = vec![(coordinate(0), 3.0)];
    e.begin(&Dynamics { velocities, ..Dynamics::free() }, &mut Nothing).expect("begins");
    let events = run_to(&mut *e, 2.0, &mut Nothing);
    assert!(matches!(events[..], [Event { kind: EventKind::Stick { .. }, .. }]));
    assert!((events[0].time - 1.019_367_991_845_056).abs() < 1e-9);
    assert!((e.coordinate(coordinate(0)).position - 1.529_051_987_767_584).abs() < 1e-9);
    // A slope of 25° with μ = 0.2 slides at g (sin − μ cos); with μ = 0.5 it holds.
    let (s, c) = 25.0_f64.to_radians().sin_cos();
    for (mu, known) in [(0.2, 2.367_709_269_510_354_5), (0.5, 0.0)] {
        let slide =
            started(joint(JointKind::Prismatic { axis: X }, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.0]);
        let g = [9.81 * s, -9.81 * c, 0.0];
        let b = blueprint(g, vec![body(1.3, [0.02, 0.0], 0.01)], vec![slide], vec![friction(mu)]);
        let mut e = engine_for(true, &b).expect("builds");
        e.assemble(&[]).expect("assembles");
        e.begin(&Dynamics::free(), &mut Nothing).expect("begins");
        run_to(&mut *e, 1.0, &mut Nothing);
        let a = e.coordinate(coordinate(0)).acceleration;
        assert!((a - known).abs() < 1e-9, "{a} against {known}");
        if mu > 0.4 {
            assert!((e.force(ForceId(0)).effort + 1.3 * 9.81 * s).abs() < 1e-9);
        }
    }
}

/// The heavy top of the literature: 15 kg, X = (0, 1, 0), spun at 150 rad/s about its axis.
fn heavy_top() -> Blueprint<f64> {
    let inertia = [[0.234_375, 0.0, 0.0], [0.0, 0.468_75, 0.0], [0.0, 0.0, 0.234_375]];
    let top = Body { mass: 15.0, center: [0.0, 1.0, 0.0], inertia };
    let tip = started(joint(JointKind::Spherical, at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[0.0; 3]);
    blueprint([0.0, 0.0, -9.81], vec![top], vec![tip], Vec::new())
}

#[test]
fn heavy_top_of_the_literature() {
    let known = [
        (0.2, [0.605_550_561_377_119_8, 0.598_957_681_694_915_2, -0.523_983_027_433_000_2]),
        (1.0, [0.173_343_964_098_386_04, 0.640_088_592_070_568_8, -0.748_490_791_133_581_3]),
        (2.0, [-0.150_416_822_745_641_76, -0.724_165_591_636_895_6, -0.673_022_269_560_444_1]),
    ];
    let mut e = engine_for(false, &heavy_top()).expect("builds");
    e.assemble(&[]).expect("assembles");
    let rates = [(0, 0.0), (1, 150.0), (2, -4.61538)];
    let velocities = rates.iter().map(|&(index, w)| (Coordinate { joint: JointId(0), index }, w)).collect();
    e.begin(&Dynamics { velocities, tolerance: 1e-10, ..Dynamics::free() }, &mut Nothing).expect("begins");
    for (time, place) in known {
        run_to(&mut *e, time, &mut Nothing);
        let p = e.point(BodyId(1), [0.0, 1.0, 0.0]).position;
        assert!((0..3).all(|i| (p[i] - place[i]).abs() < 1e-7), "{time}: {p:?}");
    }
}

#[test]
fn four_bars_pass_their_singular_poses() {
    // IFToMM A02 with two loops: upright at the start, 1 m/s; stretched twice a turn.
    let mut e = engine_for(true, &chain_from(2, std::f64::consts::FRAC_PI_2)).expect("builds");
    e.assemble(&[]).expect("assembles");
    let velocities = vec![(coordinate(0), -1.0)];
    e.begin(&Dynamics { velocities, tolerance: 1e-9, ..Dynamics::free() }, &mut Nothing).expect("begins");
    let energy = |e: &dyn Engine| e.energy().kinetic + e.energy().potential;
    let begin = energy(&*e);
    for (time, x, y) in [
        (0.5, 0.695_286_633_164_400_5, 0.718_732_563_435_741_6),
        (1.0, -0.195_020_301_949_435_1, -0.980_799_205_662_173_8),
        (2.0, 0.057_815_795_768_011_43, 0.998_327_267_863_455_5),
        (5.0, -0.811_310_461_005_107_4, -0.584_615_545_348_975_5),
        (10.0, 0.328_458_111_540_815_4, 0.944_518_538_178_601),
    ] {
        run_to(&mut *e, time, &mut Nothing);
        let p = e.point(BodyId(1), [1.0, 0.0, 0.0]).position;
        assert!((p[0] - x).abs() < 1e-7 && (p[1] - y).abs() < 1e-7, "{time}: {p:?}");
        assert!((energy(&*e) - begin).abs() < 1e-6);
    }
}

/// The lift let go at 20°, with a damper and a spring at the cylinder.
fn falling_lift() -> Blueprint<f64> {
    let mut b = lift_blueprint([19.84, 20.8, 19.4]);
    let k = Value::Constant;
    b.forces.push(Force::JointSpring {
        coordinate: coordinate(1),
        stiffness: k(4e4),
        damping: k(300.0),
        free_position: k(0.8),
        preload: k(500.0),
    });
    b
}

/// Positions, rates and two reactions at a time.
fn observed(e: &dyn Engine) -> Vec<f64> {
    let (c, r) = (e.coordinate(coordinate(2)), [6, 4].map(|j| e.reaction(JointId(j)).force));
    vec![c.position, c.velocity, c.acceleration, r[0][0], r[0][1], r[1][0], r[1][1]]
}

fn fall(method: Method, fixed_step: Option<f64>, tolerance: f64) -> (Vec<f64>, SolverEffort) {
    let mut e = engine_for(true, &falling_lift()).expect("builds");
    e.assemble(&[(coordinate(2), 0.35)]).expect("assembles");
    e.begin(&Dynamics { method, fixed_step, tolerance, breaks: vec![0.4], ..Dynamics::free() }, &mut Nothing)
        .expect("begins");
    run_to(&mut *e, 0.4, &mut Nothing);
    (observed(&*e), e.solver_effort())
}

#[test]
fn generalized_alpha_is_of_second_order_in_motion_and_reactions() {
    let (truth, _) = fall(Method::Explicit, None, 1e-12);
    // One of the seven (a reaction component that is a constant) has no error to compare.
    let compared = [0, 1, 2, 3, 4, 6];
    for (spectral_radius, spread) in [(0.3, 0.3), (0.6, 0.1), (1.0, 0.05)] {
        let method = Method::GeneralizedAlpha { spectral_radius };
        let errors = |steps: f64| -> Vec<f64> {
            let (found, _) = fall(method, Some(0.4 / steps), 1e-9);
            compared.iter().map(|&k| (found[k] - truth[k]).abs()).collect()
        };
        let (coarse, fine) = (errors(400.0), errors(800.0));
        for (k, (a, b)) in coarse.iter().zip(&fine).enumerate() {
            let order = (a / b).log2();
            assert!((order - 2.0).abs() < spread, "radius {spectral_radius}, number {k}: order {order}");
        }
    }
}

#[test]
fn both_methods_agree_within_their_tolerances() {
    let (truth, _) = fall(Method::Explicit, None, 1e-12);
    for (method, tolerance) in
        [(Method::Explicit, 1e-6), (Method::GeneralizedAlpha { spectral_radius: 0.8 }, 1e-6), (Method::Automatic, 1e-8)]
    {
        let (found, effort) = fall(method, None, tolerance);
        let [place, speed] = [0, 1].map(|k| (found[k] - truth[k]).abs());
        assert!(place < 10.0 * tolerance && speed < 100.0 * tolerance, "{method:?}: {place:e} {speed:e} {effort:?}");
    }
}

/// Drives that are polynomials of time.
struct Driving(crate::random::Motion);

impl Surroundings for Driving {
    fn inputs(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, t: f64, motion: &mut [Reading]) {
        let (p, v) = (self.0.position(t), self.0.velocity(t));
        for (k, motion) in motion.iter_mut().enumerate() {
            *motion = Reading { position: p[k], velocity: v[k], acceleration: self.0.accel[k] };
        }
    }
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// A machine whose drives take all freedom moves as the inverse dynamics say, with the same efforts.
fn driven_as_prescribed(seed: u64, planar: bool) -> bool {
    let b = random_mechanism(seed, planar, 4, 3);
    let Some((mut known, list)) = prepared(&b, planar) else { return false };
    let mut dice = Dice::new(seed + 5);
    let motion = crate::random::Motion {
        at: list.iter().map(|c| known.coordinate(*c).position).collect(),
        rate: list.iter().map(|_| dice.within(-0.5, 0.5)).collect(),
        accel: list.iter().map(|_| dice.within(-0.5, 0.5)).collect(),
    };
    let time = 0.1;
    for step in 1..=10 {
        if !solve(&mut *known, &motion, time * f64::from(step) / 10.0) {
            return false;
        }
    }
    let speed = (0..b.bodies.len()).fold(0.0, |s: f64, i| s.max(largest(known.body(BodyId(i)).omega)));
    if speed > 20.0 {
        return false;
    }
    let mut e = engine_for(planar, &b).expect("builds");
    let hold: Vec<(Coordinate, f64)> = list.iter().copied().zip(motion.at.iter().copied()).collect();
    if e.assemble(&hold).is_err() {
        return false;
    }
    let dynamics = Dynamics { driven: list.clone(), tolerance: 1e-9, ..Dynamics::free() };
    let mut around = Driving(motion);
    let begun = e.begin(&dynamics, &mut around).expect("begins");
    assert_eq!(begun.freedom, 0);
    run_to(&mut *e, time, &mut around);
    for i in 0..b.bodies.len() {
        let (x, y) = (e.body(BodyId(i)), known.body(BodyId(i)));
        let apart: [f64; 3] = std::array::from_fn(|k| x.center.acceleration[k] - y.center.acceleration[k]);
        assert!(largest(apart) < 1e-6 * (1.0 + largest(y.center.acceleration)), "seed {seed} body {i}: {apart:?}");
    }
    let scale = (0..list.len()).fold(1.0, |s: f64, k| s.max(known.drive(k).abs()));
    for k in 0..list.len() {
        assert!((e.drive(k) - known.drive(k)).abs() < 1e-7 * scale, "seed {seed}: drive {k}");
    }
    assert!(e.checks().closure < 1e-11 && e.checks().balance < 1e-8, "seed {seed}: {:?}", e.checks());
    true
}

#[test]
fn driven_machines_move_as_prescribed() {
    for planar in [true, false] {
        let tested = (0..60).filter(|&seed| driven_as_prescribed(seed, planar)).count();
        assert!(tested >= 25, "only {tested} of 60 draws (planar {planar}) could be tested");
    }
}

/// Nodes' places after a free run of a random machine; `None` where it has no freedom or runs wild.
fn let_go(
    b: &Blueprint<f64>,
    planar: bool,
    dynamics: &Dynamics,
    time: f64,
) -> Result<(Vec<f64>, f64, f64), MechanismError> {
    let mut e = engine_for(planar, b).expect("builds");
    e.assemble(&[]).expect("assembles");
    e.begin(dynamics, &mut Nothing)?;
    let energy = |e: &dyn Engine| e.energy().kinetic + e.energy().potential;
    let before = energy(&*e);
    loop {
        if e.advance(time, &mut Nothing)? == Advance::Reached {
            break;
        }
    }
    let places = (0..b.bodies.len()).flat_map(|i| e.body(BodyId(i)).center.position).collect();
    Ok((places, energy(&*e) - before, e.checks().closure))
}

#[test]
fn random_machines_keep_energy_and_constraints() {
    for planar in [true, false] {
        for seed in 0..25 {
            let mut b = random_mechanism(seed, planar, 5, 3);
            let run = |b: &Blueprint<f64>, tolerance: f64, method: Method| {
                let dynamics = Dynamics { tolerance, method, breaks: vec![0.5], ..Dynamics::free() };
                let_go(b, planar, &dynamics, 0.5).expect("goes on")
            };
            let alpha = Method::GeneralizedAlpha { spectral_radius: 0.8 };
            let (fine, rough, other) =
                (run(&b, 1e-10, Method::Explicit), run(&b, 1e-5, Method::Explicit), run(&b, 1e-5, alpha));
            let apart = |a: &[f64]| a.iter().zip(&fine.0).fold(0.0, |m: f64, (a, b)| m.max((a - b).abs()));
            assert!(apart(&rough.0) < 1e-4 && apart(&other.0) < 5e-3, "seed {seed} planar {planar}");
            assert!([&fine, &rough, &other].iter().all(|r| r.2 < 1e-12), "seed {seed} planar {planar}");
            b.forces.clear();
            let (fine, rough) = (run(&b, 1e-9, Method::Explicit).1.abs(), run(&b, 1e-4, Method::Explicit).1.abs());
            assert!(fine < 1e-6 && rough < 1e-2 && fine <= rough.max(1e-9), "seed {seed}: {fine:e} {rough:e}");
        }
    }
}

#[test]
fn over_constrained_machines_share_the_load_as_in_inverse_dynamics() {
    // A planar four-bar written in space: three equations say nothing new.
    let plane = four_bar_in_space();
    let mut known = engine_for(false, &plane).expect("builds");
    known.assemble(&[(coordinate(0), 1.0)]).expect("assembles");
    let list = vec![coordinate(0)];
    known
        .prepare(&Actuation { position: list.clone(), rate: list.clone(), effort: list.clone() })
        .expect("one freedom");
    let motion = crate::random::Motion { at: vec![1.0], rate: vec![2.0], accel: vec![1.5] };
    let mut e = engine_for(false, &plane).expect("builds");
    e.assemble(&[(coordinate(0), 1.0)]).expect("assembles");
    let mut around = Driving(crate::random::Motion { at: vec![1.0], rate: vec![2.0], accel: vec![1.5] });
    let begun = e.begin(&Dynamics { driven: list, ..Dynamics::free() }, &mut around).expect("begins");
    assert!(!begun.redundant.is_empty());
    for time in [0.1, 0.2, 0.3] {
        run_to(&mut *e, time, &mut around);
        assert!(solve(&mut *known, &motion, time));
        for j in 0..4 {
            let (a, b) = (e.reaction(JointId(j)), known.reaction(JointId(j)));
            let apart: [f64; 3] = std::array::from_fn(|k| a.force[k] - b.force[k]);
            let turned: [f64; 3] = std::array::from_fn(|k| a.moment[k] - b.moment[k]);
            assert!(largest(apart) < 1e-6 && largest(turned) < 1e-6, "joint {j}: {a:?} {b:?}");
        }
        assert!((e.drive(0) - known.drive(0)).abs() < 1e-8);
        assert_eq!(e.uniqueness(), known.uniqueness());
    }
}

fn four_bar_in_space() -> Blueprint<f64> {
    let rod = |l: f64| Body {
        mass: 1.3,
        center: [0.5 * l, 0.02, 0.03],
        inertia: [[0.01, 0.0, 0.0], [0.0, 0.1 * l * l, 0.0], [0.0, 0.0, 0.1 * l * l]],
    };
    let joints = vec![
        started(pin(at(0, 0.0, 0.0, 0.0), at(1, 0.0, 0.0, 0.0)), &[1.0]),
        pin(at(1, 0.4, 0.0, 0.1), at(2, 0.0, 0.0, 0.0)),
        pin(at(2, 1.0, 0.0, 0.0), at(3, 0.7, 0.0, 0.1)),
        started(pin(at(0, 1.1, 0.2, 0.0), at(3, 0.0, 0.0, 0.0)), &[1.4]),
    ];
    blueprint([0.3, -9.81, 0.7], vec![rod(0.4), rod(1.0), rod(0.7)], joints, Vec::new())
}

/// Work done is part of the promise: a change shows here, and is looked at.
#[test]
fn solver_effort_of_known_runs() {
    let mut e = engine_for(true, &andrews()).expect("builds");
    e.assemble(&[(coordinate(0), -0.061_713_890_014_276_5)]).expect("assembles");
    e.begin(&Dynamics { breaks: vec![0.03], ..Dynamics::free() }, &mut Nothing).expect("begins");
    run_to(&mut *e, 0.03, &mut Nothing);
    let squeezer = e.solver_effort();
    let (_, falling) = fall(Method::GeneralizedAlpha { spectral_radius: 0.8 }, None, 1e-5);
    let [a, b] = [squeezer, falling].map(|e| {
        format!(
            "{} steps, {} rejected, {} evaluations, {} iterations, {} factorizations, {} jacobians",
            e.steps, e.rejected, e.evaluations, e.newton_iterations, e.factorizations, e.jacobians
        )
    });
    assert_eq!(a, "55 steps, 27 rejected, 960 evaluations, 0 iterations, 960 factorizations, 0 jacobians");
    assert_eq!(b, "152 steps, 2 rejected, 862 evaluations, 858 iterations, 32 factorizations, 3 jacobians");
}

/// A chain of rods that hangs over the ground between turning joints, in plane or space.
fn rope(n: usize, planar: bool) -> Blueprint<f64> {
    let mut dice = Dice::new(n as u64);
    let mut bodies = Vec::new();
    let mut joints = Vec::new();
    for i in 0..n {
        let mass = dice.within(0.5, 2.0);
        let inertia = [[0.03, 0.001, -0.002], [0.001, 0.04, 0.003], [-0.002, 0.003, 0.05]];
        let center = [dice.within(0.0, 0.2), dice.within(-0.1, 0.1), if planar { 0.0 } else { 0.07 }];
        bodies.push(Body { mass, center, inertia });
        let from = if i == 0 { at(0, 0.1, 0.2, 0.0) } else { at(i, 0.3, 0.0, 0.0) };
        let kind = match (planar, i % 5) {
            (_, 3) => JointKind::Prismatic { axis: [0.6, 0.8, 0.0] },
            (false, 1) => JointKind::Spherical,
            (false, 2) => JointKind::Universal { axis: [0.0, 0.6, 0.8], axis2: X },
            _ => JointKind::Revolute { axis: if planar { Z } else { [0.3, -0.5, 0.8] } },
        };
        joints.push(joint(kind, from, at(i + 1, 0.0, 0.0, 0.0)));
    }
    blueprint([0.4, -9.81, if planar { 0.0 } else { 0.9 }], bodies, joints, Vec::new())
}

#[test]
fn long_trees_move_as_their_mass_matrix_says() {
    // 30 joints are solved body by body; a stop that is far away asks for the matrix.
    for planar in [true, false] {
        let plain = rope(30, planar);
        let mut watched = plain.clone();
        let far = Value::Constant(1e3);
        let none = Value::Constant(0.0);
        watched.forces.push(Force::Stop {
            coordinate: coordinate(0),
            min: None,
            max: Some(far),
            stiffness: none,
            damping: none,
            restitution: Some(none),
        });
        let places: Vec<Vec<f64>> = [plain, watched]
            .iter()
            .map(|b| {
                let mut e = engine_for(planar, b).expect("builds");
                e.assemble(&[]).expect("assembles");
                let velocities = vec![(coordinate(0), 0.7), (coordinate(3), -0.2)];
                let dynamics =
                    Dynamics { driven: vec![coordinate(8)], velocities, tolerance: 1e-8, ..Dynamics::free() };
                let motion = crate::random::Motion { at: vec![0.0], rate: vec![0.3], accel: vec![-0.5] };
                let mut around = Driving(motion);
                e.begin(&dynamics, &mut around).expect("begins");
                run_to(&mut *e, 0.2, &mut around);
                (1..=30).flat_map(|i| e.body(BodyId(i)).center.acceleration).collect()
            })
            .collect();
        let size = places[0].iter().fold(1.0, |m: f64, x| m.max(x.abs()));
        for (a, b) in places[0].iter().zip(&places[1]) {
            assert!((a - b).abs() < 1e-6 * size, "{a} {b}");
        }
    }
}
