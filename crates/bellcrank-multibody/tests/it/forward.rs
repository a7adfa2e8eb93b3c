//! Forward dynamics against theory and published cases.

use crate::build::*;
use crate::machines::*;
use bellcrank_multibody::{
    Advance, Blueprint, Body, BodyId, Coordinate, Dynamics, Engine, Event, EventKind, Force, ForceId, JointId,
    JointKind, Reading, Readings, Seeded, Surroundings, Value, engine_for,
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
        (0.010, 2.160_113_131_531_526_5, 711.923_152_831_103_98, 209_058.278_532_541_17),
        (0.015, 5.655_429_749_991_794, 441.701_993_255_252_35, -39_300.234_413_648_88),
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
            println!(
                "{tolerance:.0e} {time} {:.2e} {:.2e} {:.2e} closure {:.1e} balance {:.1e}",
                crank.position - position,
                crank.velocity / velocity - 1.0,
                crank.acceleration / acceleration - 1.0,
                e.checks().closure,
                e.checks().balance
            );
        }
        println!("{:?}", e.solver_effort());
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
    println!("{p:?} {:?}", e.solver_effort());
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
    println!("{events:?} {:?}", e.solver_effort());
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
        println!("{time} {:?} {:?}", [0, 1, 2].map(|i| p[i] - place[i]), e.solver_effort());
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
        println!("{time} {:.1e} {:.1e} energy {:.1e} {:?}", p[0] - x, p[1] - y, energy(&*e) - begin, e.solver_effort());
    }
}
