//! Forward and inverse dynamics undo each other: the efforts that a motion takes, put on with nothing driven, give the
//! motion back.

use crate::forward::run_to;
use crate::random::{Dice, Motion, largest, prepared, random_mechanism, solve};
use bellcrank_multibody::{
    Blueprint, BodyId, Coordinate, Dynamics, Engine, Force, JointKind, Method, Reading, Readings, Seeded, Surroundings,
    Value, engine_for,
};

/// Efforts of a known motion, worked out by inverse dynamics at every time that is asked for.
struct Recorded {
    known: Box<dyn Engine>,
    motion: Motion,
}

impl Surroundings for Recorded {
    fn inputs(&mut self, at: &dyn Readings<f64>, values: &mut [f64]) {
        assert!(solve(&mut *self.known, &self.motion, at.time()), "the known motion goes on");
        values.iter_mut().enumerate().for_each(|(k, value)| *value = self.known.drive(k));
    }
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, _: f64, _: &mut [Reading]) {}
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// The machine with an effort on each coordinate of the list, which its surroundings tell.
fn with_efforts(b: &Blueprint<f64>, list: &[Coordinate]) -> Blueprint<f64> {
    let mut pushed = b.clone();
    pushed.inputs = list.len();
    let efforts = list.iter().enumerate();
    pushed.forces.extend(efforts.map(|(k, &coordinate)| Force::Effort { coordinate, value: Value::Input(k) }));
    pushed
}

/// Largest difference of two machines' body accelerations, over the largest of them.
fn apart(a: &dyn Engine, b: &dyn Engine, bodies: usize) -> f64 {
    let mut size = 1.0_f64;
    let mut off = 0.0_f64;
    for i in (0..bodies).map(BodyId) {
        let (x, y) = (a.body(i), b.body(i));
        for (p, q) in [(x.center.acceleration, y.center.acceleration), (x.alpha, y.alpha)] {
            size = size.max(largest(q));
            off = off.max(largest(std::array::from_fn(|k| p[k] - q[k])));
        }
    }
    off / size
}

/// `None` for a draw that cannot be asked: stuck, near a singular position, or with the angles of a ball among its
/// drives, which take no effort one at a time.
fn there_and_back(seed: u64, planar: bool) -> Option<()> {
    let b = random_mechanism(seed, planar, 2 + (seed as usize) % 5, (seed as usize) % 4);
    let (mut known, list) = prepared(&b, planar)?;
    let ball = |c: &Coordinate| match b.joints[c.joint.0].kind {
        JointKind::Spherical => true,
        JointKind::Free => !planar && c.index > 2,
        _ => false,
    };
    if list.iter().any(ball) {
        return None;
    }
    let mut dice = Dice::new(seed + 31);
    let motion = Motion {
        at: list.iter().map(|c| known.coordinate(*c).position).collect(),
        rate: list.iter().map(|_| dice.within(-0.5, 0.5)).collect(),
        accel: list.iter().map(|_| dice.within(-0.5, 0.5)).collect(),
    };
    let time = 0.1;
    for step in (0..=10).rev() {
        solve(&mut *known, &motion, time * f64::from(step) / 10.0).then_some(())?;
        let speed = (0..b.bodies.len()).map(|i| largest(known.body(BodyId(i)).omega)).fold(0.0, f64::max);
        (speed < 10.0).then_some(())?;
    }
    let mut e = engine_for(planar, &with_efforts(&b, &list)).expect("builds");
    let hold: Vec<(Coordinate, f64)> = list.iter().copied().zip(motion.at.iter().copied()).collect();
    e.assemble(&hold).ok()?;
    let velocities = list.iter().copied().zip(motion.rate.iter().copied()).collect();
    let dynamics = Dynamics { velocities, tolerance: 1e-10, method: Method::Explicit, ..Dynamics::free() };
    let (places, rates) = (motion.position(time), motion.velocity(time));
    let mut around = Recorded { known, motion };
    let begun = e.begin(&dynamics, &mut around).expect("begins");
    assert_eq!(begun.freedom, list.len(), "seed {seed}");
    solve(&mut *around.known, &around.motion, 0.0).then_some(())?;
    let off = apart(&*e, &*around.known, b.bodies.len());
    assert!(off < 1e-9, "seed {seed}, planar {planar}: accelerations are off by {off:e}");
    run_to(&mut *e, time, &mut around);
    for (k, c) in list.iter().enumerate() {
        let found = e.coordinate(*c);
        let (p, v) = ((found.position - places[k]).abs(), (found.velocity - rates[k]).abs());
        assert!(p < 1e-7 && v < 1e-6, "seed {seed}, planar {planar}: {c:?} is off by {p:e}, {v:e}");
    }
    Some(())
}

#[test]
fn the_efforts_of_a_motion_give_it_back() {
    for planar in [true, false] {
        let tested = (0..80).filter(|&seed| there_and_back(seed + 300, planar).is_some()).count();
        assert!(tested >= 50, "only {tested} of 80 draws (planar {planar}) could be tested");
    }
}
