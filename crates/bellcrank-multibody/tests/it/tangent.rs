//! Exact derivatives through closed loops against differences of high order, on random mechanisms.
//!
//! Every number of a mechanism depends on four parameters at once; all answers are compared with Richardson's
//! extrapolation of central differences (four levels: error O(h⁸), rounding near 1e-12).

use crate::build::*;
use crate::random::{Dice, prepared, random_mechanism};
use bellcrank_math::{Real, matrix_from_rpy};
use bellcrank_multibody::{
    Actuation, Blueprint, BodyId, Coordinate, Engine, Force, JointId, JointKind, Place, Prescription, Readings, SEEDS,
    Seeded, Value, engine_for,
};

/// Numbers that depend on the parameters, the same way for every scalar.
struct Varied<'p, T> {
    p: &'p [T; SEEDS],
    dice: Dice,
}

impl<T: Real> Varied<'_, T> {
    fn by(&mut self, size: f64) -> T {
        let k = self.dice.below(SEEDS);
        self.p[k] * T::from_f64(self.dice.within(-size, size))
    }
    fn each(&mut self, numbers: &mut [T], size: f64) {
        for x in numbers {
            *x += self.by(size);
        }
    }
    fn place(&mut self, place: &mut Place<T>, planar: bool) {
        let moved = if planar { 2 } else { 3 };
        self.each(&mut place.position[..moved], 0.5);
        let mut rpy = [T::zero(); 3];
        self.each(&mut rpy[if planar { 2 } else { 0 }..], 0.5);
        let turn = matrix_from_rpy(&rpy);
        let old = place.rotation;
        place.rotation =
            std::array::from_fn(|i| std::array::from_fn(|j| (0..3).fold(T::zero(), |s, k| s + old[i][k] * turn[k][j])));
    }
    fn value(&mut self, value: &mut Value<T>, size: f64) {
        if let Value::Constant(x) = value {
            *x += self.by(size);
        }
    }
    fn force(&mut self, force: &mut Force<T>, planar: bool) {
        match force {
            Force::Point { at, vector, .. } => {
                self.place(at, planar);
                vector[..2].iter_mut().for_each(|v| self.value(v, 5.0));
            }
            Force::Spring { between, stiffness, damping, free_length, preload } => {
                between.iter_mut().for_each(|place| self.place(place, planar));
                for (value, size) in [(stiffness, 30.0), (damping, 2.0), (free_length, 0.1), (preload, 3.0)] {
                    self.value(value, size);
                }
            }
            Force::Friction { coulomb, viscous, radius, .. } => {
                self.value(coulomb, 0.02);
                self.value(viscous, 0.5);
                radius.iter_mut().for_each(|r| self.value(r, 0.01));
            }
            _ => {}
        }
    }
}

fn varied<T: Real>(b: &Blueprint<f64>, p: &[T; SEEDS], planar: bool, seed: u64) -> Blueprint<T> {
    let mut numbers = Varied { p, dice: Dice::new(seed) };
    let mut b = b.map(T::from_f64);
    numbers.each(&mut b.gravity[..2], 1.0);
    for body in b.bodies.iter_mut().skip(1) {
        body.mass += numbers.by(0.3);
        numbers.each(&mut body.center[..if planar { 2 } else { 3 }], 0.2);
        (0..3).for_each(|i| body.inertia[i][i] += numbers.by(0.01));
    }
    for joint in &mut b.joints {
        joint.places.iter_mut().flatten().for_each(|place| numbers.place(place, planar));
        if let JointKind::Screw { pitch, .. } = &mut joint.kind {
            *pitch += numbers.by(0.1);
        }
        if let JointKind::Coupler { ratio, offset, .. } = &mut joint.kind {
            *ratio += numbers.by(0.1);
            *offset += numbers.by(0.1);
        }
    }
    b.forces.iter_mut().for_each(|force| numbers.force(force, planar));
    b
}

/// Everything an engine answers, in one list.
fn answers<T: Real>(e: &dyn Readings<T>, bodies: usize, joints: usize, drives: usize) -> Vec<T> {
    let mut all = Vec::new();
    for j in (0..joints).map(JointId) {
        for index in 0..e.coordinates_of(j) {
            let c = e.coordinate(Coordinate { joint: j, index });
            all.extend([c.position, c.velocity, c.acceleration]);
        }
        let w = e.reaction(j);
        all.extend(w.force.iter().chain(&w.moment));
    }
    for b in (0..bodies).map(BodyId) {
        let m = e.body(b);
        all.extend(m.rotation.iter().flatten().chain(&m.omega).chain(&m.alpha));
        let c = &m.center;
        all.extend(c.position.iter().chain(&c.velocity).chain(&c.acceleration));
    }
    all.extend((0..drives).map(|i| e.drive(i)));
    let energy = e.energy();
    all.extend([energy.kinetic, energy.potential]);
    all
}

/// What is prescribed, as a function of the parameters.
#[derive(Clone)]
struct Course {
    at: Vec<[f64; 3]>,
    slope: Vec<[f64; 3]>,
}

impl Course {
    fn new(places: &[f64], dice: &mut Dice) -> Self {
        let mut triple = |first: f64| [first, dice.within(-1.0, 1.0), dice.within(-1.0, 1.0)];
        let at = places.iter().map(|x| triple(*x)).collect();
        let slope = places.iter().map(|_| triple(0.3)).collect();
        Self { at, slope }
    }
    fn part<T: Real>(&self, part: usize, p: &[T; SEEDS]) -> Vec<T> {
        let one = |k: usize| T::from_f64(self.at[k][part]) + p[k % SEEDS] * T::from_f64(self.slope[k][part]);
        (0..self.at.len()).map(one).collect()
    }
}

struct Case<'c> {
    b: &'c Blueprint<f64>,
    planar: bool,
    seed: u64,
    actuation: Actuation,
    /// Of the positions and of the rates, whose coordinates may differ.
    position: Course,
    rate: Course,
}

impl Case<'_> {
    fn solve(&self, p: [f64; SEEDS]) -> Option<Box<dyn Engine>> {
        let mut e = engine_for(self.planar, &varied(self.b, &p, self.planar, self.seed)).ok()?;
        e.assemble(&[]).ok()?;
        e.prepare(&self.actuation).ok()?;
        e.move_to(0.0, &self.position.part(0, &p)).ok()?;
        e.set_rates(&self.rate.part(1, &p), &self.rate.part(2, &p)).ok()?;
        e.solve_forces(&mut |_, _| {}).ok()?;
        Some(e)
    }

    fn answers(&self, e: &dyn Engine) -> Vec<f64> {
        answers::<f64>(e, self.b.bodies.len(), self.b.joints.len(), self.actuation.effort.len())
    }

    fn exact(&self) -> Option<Vec<Seeded>> {
        let mut e = self.solve([0.0; SEEDS])?;
        let p: [Seeded; SEEDS] = std::array::from_fn(|i| Seeded::variable(0.0, i));
        e.seed(&varied(self.b, &p, self.planar, self.seed)).ok()?;
        let (position, velocity) = (self.position.part(0, &p), self.rate.part(1, &p));
        let acceleration = self.rate.part(2, &p);
        let at = Prescription {
            time: Seeded::zero(),
            position: &position,
            velocity: &velocity,
            acceleration: &acceleration,
        };
        e.differentiate(&at, &mut |_, _| {}).ok()?;
        let (bodies, joints) = (self.b.bodies.len(), self.b.joints.len());
        Some(answers(e.derivatives()?, bodies, joints, self.actuation.effort.len()))
    }

    fn difference(&self, lane: usize) -> Option<Vec<(f64, f64)>> {
        let mut levels = Vec::new();
        for level in 0..4 {
            let h = 4e-3 / f64::from(1 << level);
            let side = |sign: f64| -> Option<Vec<f64>> {
                let mut p = [0.0; SEEDS];
                p[lane] = sign * h;
                Some(self.answers(&*self.solve(p)?))
            };
            let (up, down) = (side(1.0)?, side(-1.0)?);
            levels.push(up.iter().zip(&down).map(|(a, b)| (a - b) / (2.0 * h)).collect::<Vec<f64>>());
        }
        Some(extrapolated(levels))
    }

    /// Largest error of all answers relative to their size; `None` for what cannot be solved or is near-singular.
    fn worst(&self) -> Option<f64> {
        let exact = self.exact()?;
        let size = exact.iter().fold(1.0, |m: f64, x| m.max(x.re.abs()));
        let mut worst: f64 = 0.0;
        for lane in 0..SEEDS {
            let difference = self.difference(lane)?;
            let slope = exact.iter().fold(size, |m: f64, x| m.max(x.eps[lane].abs()));
            for (x, (d, uncertain)) in exact.iter().zip(&difference) {
                // Near a singular position the differences, not the derivatives, lose their digits.
                if *uncertain > 1e-10 * slope {
                    return None;
                }
                worst = worst.max((x.eps[lane] - d).abs() / slope);
            }
        }
        Some(worst)
    }
}

/// Richardson's extrapolation of halved steps, and how far it is from the one with a level less.
fn extrapolated(mut levels: Vec<Vec<f64>>) -> Vec<(f64, f64)> {
    let mut factor = 4.0;
    let mut coarser = levels[0].clone();
    while levels.len() > 1 {
        coarser.clone_from(&levels[levels.len() - 1]);
        let finer = |pair: &[Vec<f64>]| -> Vec<f64> {
            pair[0].iter().zip(&pair[1]).map(|(a, b)| b + (b - a) / (factor - 1.0)).collect()
        };
        levels = levels.windows(2).map(finer).collect();
        factor *= 4.0;
    }
    levels[0].iter().zip(&coarser).map(|(a, b)| (*a, (a - b).abs())).collect()
}

fn check(seed: u64, planar: bool) -> bool {
    let mut b = random_mechanism(seed, planar, 3 + (seed % 3) as usize, (seed % 4) as usize);
    // Friction along the first coordinate, whatever joint it is.
    if seed.is_multiple_of(3) {
        b.forces.push(friction(coordinate(0)));
    }
    let Some((e, list)) = prepared(&b, planar) else { return false };
    let mut dice = Dice::new(seed + 5);
    let places: Vec<f64> = list.iter().map(|c| e.coordinate(*c).position).collect();
    let position = Course::new(&places, &mut dice);
    let rate = Course::new(&places, &mut dice);
    let actuation = Actuation { position: list.clone(), rate: list.clone(), effort: list };
    let case = Case { b: &b, planar, seed, actuation, position, rate };
    let Some(worst) = case.worst() else { return false };
    assert!(worst < 1e-9, "seed {seed} planar {planar}: relative error {worst:e}");
    true
}

fn friction(c: Coordinate) -> Force<f64> {
    let k = Value::Constant;
    Force::Friction {
        coordinate: c,
        coulomb: k(0.07),
        static_coefficient: None,
        stribeck_velocity: None,
        viscous: k(1.3),
        radius: Some(k(0.03)),
        smoothing_velocity: None,
    }
}

#[test]
fn derivatives_are_those_of_the_differences_in_the_plane() {
    let tested = (0..60).filter(|&seed| check(seed, true)).count();
    assert!(tested >= 40, "only {tested} of 60 draws could be tested");
}

#[test]
fn derivatives_are_those_of_the_differences_in_space() {
    let tested = (0..60).filter(|&seed| check(seed, false)).count();
    assert!(tested >= 35, "only {tested} of 60 draws could be tested");
}

/// A crank geared to a second one that drives a slider: a coupling between tree and measured coordinates.
fn geared() -> Blueprint<f64> {
    let bodies = vec![
        body(1.3, [0.11, 0.02], 0.013),
        body(0.7, [0.2, -0.05], 0.02),
        body(2.1, [0.04, 0.03], 0.01),
        body(0.9, [0.05, 0.08], 0.007),
    ];
    let joints = vec![
        started(pin(at(0, 0.1, -0.2, 0.3), at(1, 0.02, 0.01, 0.2)), &[0.7]),
        started(pin(at(1, 0.25, 0.03, 0.1), at(2, -0.03, 0.02, 0.4)), &[-0.5]),
        started(pin(at(0, -0.4, 0.3, 0.0), at(4, 0.01, 0.0, 0.1)), &[0.2]),
        joint(JointKind::PointOnLine { axis: X }, at(0, 0.2, 0.05, 0.4), at(2, 0.6, 0.04, 0.0)),
        started(
            joint(JointKind::Prismatic { axis: [0.8, 0.3, 0.0] }, at(2, 0.1, 0.1, 0.2), at(3, 0.0, 0.02, 0.1)),
            &[0.1],
        ),
    ];
    let mut b = blueprint([0.7, -9.3, 0.0], bodies, joints, Vec::new());
    let coupler = |a: usize, c: usize, ratio: f64| bellcrank_multibody::Joint {
        kind: JointKind::Coupler { a: coordinate(a), b: coordinate(c), ratio, offset: 0.05 },
        places: None,
        start: Vec::new(),
        at_start: false,
    };
    b.joints.extend([coupler(0, 2, -1.7), coupler(3, 4, 0.4)]);
    b.forces = vec![force(at(3, 0.07, 0.02, 0.0), [3.0, -21.0, 0.0]), force(at(4, 0.3, 0.1, 0.0), [-5.0, 8.0, 0.0])];
    b
}

#[test]
fn a_drive_elsewhere_and_couplings_have_derivatives_too() {
    let lift = crate::machines::lift_blueprint([19.84, 20.8, 19.4]);
    let geared = geared();
    let joint = |j| vec![coordinate(j)];
    for (b, swept, driven, place) in
        [(&lift, 2, 1, -0.31), (&lift, 2, 0, 0.17), (&geared, 0, 3, 0.72), (&geared, 3, 2, 0.5)]
    {
        let mut dice = Dice::new(91 + swept as u64);
        let (position, rate) = (Course::new(&[place], &mut dice), Course::new(&[0.0], &mut dice));
        let actuation = Actuation { position: joint(swept), rate: joint(driven), effort: joint(driven) };
        let case = Case { b, planar: true, seed: 17, actuation, position, rate };
        let worst = case.worst();
        assert!(worst.is_some_and(|w| w < 1e-9), "swept {swept} driven {driven}: {worst:?}");
    }
}
