//! Flexible bodies against sums over their particles: places differenced, no integral shared with the crate.

use crate::build::*;
use crate::forward::Nothing;
use crate::random::Dice;
use bellcrank_math::{Planar, Real, Space, Spatial};
use bellcrank_multibody::{
    Actuation, Advance, Blueprint, Body, BodyId, Coordinate, Dynamics, Engine, Flexible, JointId, JointKind, Machine,
    Method, Place, Prescription, Seeded, ShapeInertia, Shortening, engine_for,
};

type Vec3 = [f64; 3];

/// A particle of a flexible body: mass, place, and its displacement by each coordinate.
struct Particle {
    mass: f64,
    at: Vec3,
    shapes: Vec<Vec3>,
}

/// A machine whose flexible body is known particle by particle.
struct Sample {
    blueprint: Blueprint<f64>,
    particles: Vec<Particle>,
    /// Of the rigid body that hangs on the interface.
    child: Vec<(f64, Vec3)>,
    /// The elastic coordinates, and all coordinates of the tree in the order they are driven in.
    elastic: Vec<Coordinate>,
    all: Vec<Coordinate>,
}

const FLEXIBLE: BodyId = BodyId(1);
const INTERFACE: BodyId = BodyId(2);
const MODES: BodyId = BodyId(3);
const CHILD: BodyId = BodyId(4);
const GRAVITY: Vec3 = [1.3, -9.1, 2.2];

fn particles(dice: &mut Dice, planar: bool, coordinates: usize) -> Vec<Particle> {
    let mut vector = |size: f64| {
        let z = if planar { 0.0 } else { dice.within(-size, size) };
        [dice.within(-size, size), dice.within(-size, size), z]
    };
    (0..9)
        .map(|i| Particle {
            mass: 0.2 + 0.1 * f64::from(i),
            at: vector(0.7),
            shapes: (0..coordinates).map(|_| vector(0.8)).collect(),
        })
        .collect()
}

fn outer(a: Vec3, b: Vec3, k: f64) -> [Vec3; 3] {
    a.map(|a| b.map(|b| k * a * b))
}

fn sum(all: impl Iterator<Item = [Vec3; 3]>) -> [Vec3; 3] {
    let mut total = [[0.0; 3]; 3];
    for one in all {
        (0..3).for_each(|i| (0..3).for_each(|k| total[i][k] += one[i][k]));
    }
    total
}

fn integrals(particles: &[Particle], n: usize) -> ShapeInertia<f64> {
    let weigh = |of: &dyn Fn(&Particle) -> Vec3| {
        let mut total = [0.0; 3];
        particles.iter().for_each(|p| (0..3).for_each(|i| total[i] += p.mass * of(p)[i]));
        total
    };
    let square = |a: &dyn Fn(&Particle) -> Vec3, b: &dyn Fn(&Particle) -> Vec3| {
        sum(particles.iter().map(|p| outer(a(p), b(p), p.mass)))
    };
    ShapeInertia {
        mass: particles.iter().map(|p| p.mass).sum(),
        first: weigh(&|p| p.at),
        second: square(&|p| p.at, &|p| p.at),
        flow: (0..n).map(|e| weigh(&|p| p.shapes[e])).collect(),
        placed: (0..n).map(|e| square(&|p| p.at, &|p| p.shapes[e])).collect(),
        products: (0..n * n).map(|k| square(&|p| p.shapes[k / n], &|p| p.shapes[k % n])).collect(),
    }
}

/// Symmetric and positive: `s (B Bᵀ + 1)`.
fn positive(dice: &mut Dice, n: usize, size: f64) -> Vec<f64> {
    let b: Vec<f64> = (0..n * n).map(|_| dice.within(-0.5, 0.5)).collect();
    let entry = |i: usize, j: usize| (0..n).map(|k| b[i * n + k] * b[j * n + k]).sum::<f64>() + f64::from(i == j);
    (0..n * n).map(|k| size * entry(k / n, k % n)).collect()
}

impl Sample {
    /// With `reversed` the ground holds the interface, and the floating frame hangs on it.
    fn new(seed: u64, planar: bool, reversed: bool) -> Self {
        let mut dice = Dice::new(seed);
        let (six, modes) = (if planar { 3 } else { 6 }, 2);
        let n = six + modes;
        let particles = particles(&mut dice, planar, n);
        let point = |x: f64, y: f64, z: f64| [x, y, if planar { 0.0 } else { z }];
        let place = |body: BodyId, position: Vec3| Place { body, position, rotation: UPRIGHT };
        let axis = if planar { Z } else { [0.3, -0.4, 0.8] };
        let (held, hangs) = if reversed { (INTERFACE, FLEXIBLE) } else { (FLEXIBLE, INTERFACE) };
        let joints = vec![
            joint(
                JointKind::Revolute { axis },
                place(BodyId(0), point(0.2, 0.1, -0.3)),
                place(held, point(0.1, 0.2, 0.1)),
            ),
            joint(JointKind::Elastic, place(FLEXIBLE, point(0.5, -0.3, 0.2)), place(INTERFACE, [0.0; 3])),
            joint(JointKind::Modes { count: modes }, place(FLEXIBLE, [0.0; 3]), place(MODES, [0.0; 3])),
            joint(
                JointKind::Revolute { axis: Z },
                place(hangs, point(-0.1, 0.15, 0.05)),
                place(CHILD, point(0.2, -0.1, 0.3)),
            ),
        ];
        let child: Vec<(f64, Vec3)> = (0..5)
            .map(|i| (0.3 + 0.1 * f64::from(i), point(dice.within(-0.4, 0.4), dice.within(-0.4, 0.4), 0.3)))
            .collect();
        let massless = Body { mass: 0.0, center: [0.0; 3], inertia: [[0.0; 3]; 3] };
        let bodies = vec![massless.clone(), massless.clone(), massless, rigid(&child)];
        let gravity = if planar { [GRAVITY[0], GRAVITY[1], 0.0] } else { GRAVITY };
        let mut blueprint = blueprint(gravity, bodies, joints, Vec::new());
        blueprint.flexible = vec![Flexible {
            body: FLEXIBLE,
            interfaces: vec![JointId(1)],
            modes: Some(JointId(2)),
            inertia: integrals(&particles, n),
            stiffness: positive(&mut dice, n, 900.0),
            damping: positive(&mut dice, n, 3.0),
            shortenings: vec![Shortening { along: 0, matrix: positive(&mut dice, n, 0.7) }],
        }];
        let c = |joint: usize, index: usize| Coordinate { joint: JointId(joint), index };
        let elastic: Vec<Coordinate> = (0..six).map(|i| c(1, i)).chain((0..modes).map(|i| c(2, i))).collect();
        let all = [c(0, 0), c(3, 0)].into_iter().chain(elastic.iter().copied()).collect();
        Self { blueprint, particles, child, elastic, all }
    }

    fn engine(&self, planar: bool) -> Box<dyn Engine> {
        let mut engine = engine_for(planar, &self.blueprint).unwrap();
        engine.assemble(&[]).unwrap();
        let all = self.all.clone();
        engine.prepare(&Actuation { position: all.clone(), rate: all.clone(), effort: all }).unwrap();
        engine
    }

    /// Masses and places of all particles, world axes.
    fn places(&self, engine: &mut dyn Engine, q: &[f64]) -> Vec<(f64, Vec3)> {
        engine.move_to(0.0, q).unwrap();
        let world = |body: BodyId, at: Vec3| engine.point(body, at).position;
        let deformation: Vec<f64> = self.elastic.iter().map(|c| engine.coordinate(*c).position).collect();
        let moved = |p: &Particle| {
            std::array::from_fn(|i| p.at[i] + p.shapes.iter().zip(&deformation).map(|(s, d)| s[i] * d).sum::<f64>())
        };
        let flexible = self.particles.iter().map(|p| (p.mass, world(FLEXIBLE, moved(p))));
        flexible.chain(self.child.iter().map(|(m, at)| (*m, world(CHILD, *at)))).collect()
    }

    fn strained(&self, d: &[f64]) -> Vec<f64> {
        let (n, body) = (d.len(), &self.blueprint.flexible[0]);
        let mut strained = d.to_vec();
        for s in &body.shortenings {
            strained[s.along] += 0.5 * (0..n * n).map(|k| d[k / n] * s.matrix[k] * d[k % n]).sum::<f64>();
        }
        strained
    }

    /// Elastic energy at the coordinates `q` of [`Sample::all`].
    fn elastic_energy(&self, q: &[f64]) -> f64 {
        let e = self.strained(&q[2..]);
        let n = e.len();
        0.5 * (0..n * n).map(|k| e[k / n] * self.blueprint.flexible[0].stiffness[k] * e[k % n]).sum::<f64>()
    }
}

fn rigid(particles: &[(f64, Vec3)]) -> Body<f64> {
    let mass: f64 = particles.iter().map(|p| p.0).sum();
    let center: Vec3 = std::array::from_fn(|i| particles.iter().map(|(m, p)| m * p[i]).sum::<f64>() / mass);
    let about = |p: &Vec3| -> Vec3 { std::array::from_fn(|i| p[i] - center[i]) };
    let second = sum(particles.iter().map(|(m, p)| outer(about(p), about(p), *m)));
    let all = second[0][0] + second[1][1] + second[2][2];
    let entry = |i: usize, k: usize| if i == k { all - second[i][k] } else { -second[i][k] };
    Body { mass, center, inertia: std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k))) }
}

fn combine(q: &[f64], v: &[f64], a: &[f64], t: f64) -> Vec<f64> {
    (0..q.len()).map(|i| q[i] + v[i] * t + 0.5 * a[i] * t * t).collect()
}

fn dot(a: Vec3, b: Vec3) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// `Σ m (p̈ − g)·∂p/∂q_i + ∂V/∂q_i + (D q̇)_i` with p̈ and ∂p/∂q by differences of places.
fn particle_efforts(sample: &Sample, engine: &mut dyn Engine, q: &[f64], v: &[f64], a: &[f64]) -> Vec<f64> {
    let h = 1e-3;
    let at = |engine: &mut dyn Engine, k: f64| sample.places(engine, &combine(q, v, a, k * h));
    let five: Vec<Vec<(f64, Vec3)>> = [-2.0, -1.0, 0.0, 1.0, 2.0].iter().map(|k| at(engine, *k)).collect();
    let second = |p: usize, i: usize| {
        let [a, b, c, d, e] = [0, 1, 2, 3, 4].map(|k| five[k][p].1[i]);
        (-a + 16.0 * b - 30.0 * c + 16.0 * d - e) / (12.0 * h * h)
    };
    let gravity = sample.blueprint.gravity;
    (0..q.len())
        .map(|i| {
            let shifted =
                |k: f64| -> Vec<f64> { (0..q.len()).map(|j| q[j] + if i == j { k * h } else { 0.0 }).collect() };
            let four = [-2.0, -1.0, 1.0, 2.0].map(|k| sample.places(engine, &shifted(k)));
            let slope = |p: usize| -> Vec3 {
                std::array::from_fn(|c| {
                    let [a, b, d, e] = [0, 1, 2, 3].map(|k| four[k][p].1[c]);
                    (a - 8.0 * b + 8.0 * d - e) / (12.0 * h)
                })
            };
            let inertia: f64 = (0..five[2].len())
                .map(|p| five[2][p].0 * dot(std::array::from_fn(|c| second(p, c) - gravity[c]), slope(p)))
                .sum();
            let energy = |k: f64| sample.elastic_energy(&shifted(k));
            let elastic = (energy(-2.0) - 8.0 * energy(-1.0) + 8.0 * energy(1.0) - energy(2.0)) / (12.0 * h);
            let n = q.len() - 2;
            let damping = &sample.blueprint.flexible[0].damping;
            let damped = if i < 2 { 0.0 } else { (0..n).map(|j| damping[(i - 2) * n + j] * v[j + 2]).sum() };
            inertia + elastic + damped
        })
        .collect()
}

fn random_list(dice: &mut Dice, n: usize, size: f64) -> Vec<f64> {
    (0..n).map(|_| dice.within(-size, size)).collect()
}

#[test]
fn efforts_are_those_of_the_particles() {
    for (seed, planar, reversed) in (0..24).map(|k| (k, k % 2 == 0, k % 4 > 1)) {
        let sample = Sample::new(seed + 1, planar, reversed);
        let mut engine = sample.engine(planar);
        let mut dice = Dice::new(seed + 100);
        let n = sample.all.len();
        let mut q = random_list(&mut dice, n, 0.9);
        q[2..].iter_mut().for_each(|d| *d *= 0.4);
        let (v, a) = (random_list(&mut dice, n, 2.0), random_list(&mut dice, n, 5.0));
        let expected = particle_efforts(&sample, engine.as_mut(), &q, &v, &a);
        engine.move_to(0.0, &q).unwrap();
        engine.set_rates(&v, &a).unwrap();
        engine.solve_forces(&mut |_, _| ()).unwrap();
        let size = expected.iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        for (i, expected) in expected.iter().enumerate() {
            let found = engine.drive(i);
            assert!((found - expected).abs() < 1e-6 * size, "{seed} {planar} {reversed} {i}: {found} {expected}");
        }
        assert!(engine.checks().balance < 1e-12, "{}", engine.checks().balance);
    }
}

#[test]
fn energy_is_that_of_the_particles() {
    for (seed, planar, reversed) in (0..8).map(|k| (k, k % 2 == 0, k % 4 > 1)) {
        let sample = Sample::new(seed + 31, planar, reversed);
        let mut engine = sample.engine(planar);
        let mut dice = Dice::new(seed + 200);
        let n = sample.all.len();
        let (q, v) = (random_list(&mut dice, n, 0.5), random_list(&mut dice, n, 2.0));
        let h = 1e-4;
        let [before, here, after] =
            [-h, 0.0, h].map(|t| sample.places(engine.as_mut(), &combine(&q, &v, &vec![0.0; n], t)));
        let mut kinetic = 0.0;
        let mut potential = sample.elastic_energy(&q);
        for p in 0..here.len() {
            let speed: Vec3 = std::array::from_fn(|i| (after[p].1[i] - before[p].1[i]) / (2.0 * h));
            kinetic += 0.5 * here[p].0 * dot(speed, speed);
            potential -= here[p].0 * dot(sample.blueprint.gravity, here[p].1);
        }
        engine.move_to(0.0, &q).unwrap();
        engine.set_rates(&v, &vec![0.0; n]).unwrap();
        engine.solve_forces(&mut |_, _| ()).unwrap();
        let energy = engine.energy();
        assert!((energy.kinetic - kinetic).abs() < 1e-6 * kinetic, "{energy:?} {kinetic}");
        assert!((energy.potential - potential).abs() < 1e-9 * potential.abs(), "{energy:?} {potential}");
    }
}

/// `M` by columns from inverse dynamics, and as the composite bodies give it.
fn both_masses<S: Space<T = f64>>(sample: &Sample, q: &[f64]) -> [Vec<f64>; 2] {
    let mut machine = Machine::<S>::new(sample.blueprint.clone()).unwrap();
    let (_, n) = machine.sizes();
    let (mut m, mut still) = (vec![0.0; n * n], vec![0.0; n]);
    machine.mass_matrix(q, &mut m);
    machine.inverse_dynamics(q, &vec![0.0; n], &vec![0.0; n], &mut still);
    let mut columns = vec![0.0; n * n];
    for j in 0..n {
        let unit: Vec<f64> = (0..n).map(|i| f64::from(i == j)).collect();
        let mut tau = vec![0.0; n];
        machine.inverse_dynamics(q, &vec![0.0; n], &unit, &mut tau);
        (0..n).for_each(|i| columns[i * n + j] = tau[i] - still[i]);
    }
    [m, columns]
}

#[test]
fn masses_are_those_of_inverse_dynamics() {
    for (seed, planar, reversed) in (0..12).map(|k| (k, k % 2 == 0, k % 4 > 1)) {
        let sample = Sample::new(seed + 57, planar, reversed);
        let q = random_list(&mut Dice::new(seed + 300), sample.all.len(), 0.6);
        let [m, columns] =
            if planar { both_masses::<Planar<f64>>(&sample, &q) } else { both_masses::<Spatial<f64>>(&sample, &q) };
        for (a, b) in m.iter().zip(&columns) {
            assert!((a - b).abs() < 1e-12, "{seed} {planar} {reversed}: {a} {b}");
        }
    }
}

#[test]
fn a_flexible_machine_let_go_keeps_its_energy() {
    for (planar, reversed) in [(true, false), (false, false), (false, true)] {
        let mut sample = Sample::new(77, planar, reversed);
        sample.blueprint.flexible[0].damping.fill(0.0);
        let mut engine = engine_for(planar, &sample.blueprint).unwrap();
        let hold: Vec<_> = sample.all.iter().enumerate().map(|(i, c)| (*c, 0.03 * (i as f64 + 1.0).sin())).collect();
        engine.assemble(&hold).unwrap();
        let method = Method::Explicit;
        let dynamics = Dynamics { tolerance: 1e-10, method, ..Dynamics::free() };
        let begun = engine.begin(&dynamics, &mut Nothing).unwrap();
        assert_eq!(begun.freedom, sample.all.len());
        while engine.advance(0.5, &mut Nothing).unwrap() == Advance::Working {}
        let energy = engine.energy();
        let drift = energy.kinetic + energy.potential - begun.energy;
        assert!(energy.kinetic > 1.0 && drift.abs() < 1e-7 * energy.kinetic, "{planar} {reversed}: {energy:?} {drift}");
        assert!(engine.checks().balance < 1e-10, "{}", engine.checks().balance);
    }
}

/// Both integrators on the same damped machine: the stiffness and damping that the implicit one takes are exact.
#[test]
fn implicit_and_explicit_steps_agree() {
    for planar in [true, false] {
        let sample = Sample::new(91, planar, false);
        let run = |method: Method, tolerance: f64| {
            let mut engine = engine_for(planar, &sample.blueprint).unwrap();
            engine.assemble(&[]).unwrap();
            engine.begin(&Dynamics { tolerance, method, ..Dynamics::free() }, &mut Nothing).unwrap();
            while engine.advance(0.3, &mut Nothing).unwrap() == Advance::Working {}
            let places: Vec<f64> = sample.all.iter().map(|c| engine.coordinate(*c).position).collect();
            (places, engine.solver_effort())
        };
        let (exact, _) = run(Method::Explicit, 1e-10);
        let (found, effort) = run(Method::GeneralizedAlpha { spectral_radius: 0.8 }, 1e-7);
        for (a, b) in exact.iter().zip(&found) {
            assert!((a - b).abs() < 2e-5, "{planar}: {a} {b}");
        }
        // A wrong tangent costs iterations.
        assert!(effort.newton_iterations < 4 * effort.steps, "{effort:?}");
    }
}

fn settled(sample: &Sample, planar: bool, places: [f64; 2], v: [f64; 2], a: [f64; 2]) -> Box<dyn Engine> {
    let mut engine = engine_for(planar, &sample.blueprint).unwrap();
    engine.assemble(&[]).unwrap();
    let drives = sample.all[..2].to_vec();
    engine.prepare(&Actuation { position: drives.clone(), rate: drives.clone(), effort: drives }).unwrap();
    engine.move_to(0.0, &places).unwrap();
    engine.set_rates(&v, &a).unwrap();
    engine.solve_forces(&mut |_, _| ()).unwrap();
    engine
}

#[test]
fn driven_bodies_bend_as_in_equilibrium() {
    for (seed, planar, reversed) in (0..8).map(|k| (k, k % 2 == 0, k % 4 > 1)) {
        let sample = Sample::new(seed + 400, planar, reversed);
        let places = [0.4, -0.7];
        let engine = settled(&sample, planar, places, [0.0; 2], [0.0; 2]);
        let mut rest = engine_for(planar, &sample.blueprint).unwrap();
        let hold: Vec<_> = sample.all[..2].iter().copied().zip(places).collect();
        rest.assemble(&hold).unwrap();
        rest.equilibrium(&hold, &mut |_, _| ()).unwrap();
        for c in &sample.elastic {
            let [a, b] = [engine.coordinate(*c).position, rest.coordinate(*c).position];
            assert!((a - b).abs() < 1e-8, "{seed} {planar} {reversed} {c:?}: {a} {b}");
        }
        assert!(engine.coordinate(sample.elastic[0]).position.abs() > 1e-4);
        assert!(engine.checks().balance < 1e-12);
    }
}

#[test]
fn nothing_holds_the_shape_of_a_body_that_moves() {
    for (seed, planar) in [(1, true), (2, false), (3, true)] {
        let sample = Sample::new(seed + 500, planar, false);
        let (places, v, a) = ([0.3, 0.5], [1.1, -0.8], [3.0, 2.0]);
        let engine = settled(&sample, planar, places, v, a);
        let mut all = sample.engine(planar);
        let n = sample.all.len();
        let q: Vec<f64> = sample.all.iter().map(|c| engine.coordinate(*c).position).collect();
        let with_rest = |two: [f64; 2]| two.into_iter().chain(vec![0.0; n - 2]).collect::<Vec<_>>();
        all.move_to(0.0, &q).unwrap();
        all.set_rates(&with_rest(v), &with_rest(a)).unwrap();
        all.solve_forces(&mut |_, _| ()).unwrap();
        for i in 0..n {
            let expected = if i < 2 { engine.drive(i) } else { 0.0 };
            assert!((all.drive(i) - expected).abs() < 1e-7, "{i}: {} {expected}", all.drive(i));
        }
    }
}

/// Mass of the child, gravity, and one stiffness: exact derivatives of drives and shapes against differences.
#[test]
fn derivatives_go_through_the_shapes() {
    let change = |sample: &mut Sample, by: f64| {
        sample.blueprint.bodies[CHILD.0].mass += by;
        sample.blueprint.gravity[1] += 2.0 * by;
        sample.blueprint.flexible[0].stiffness[0] += 300.0 * by;
    };
    for planar in [true, false] {
        let (places, v, a) = ([0.3, 0.5], [1.1, -0.8], [3.0, 2.0]);
        let at = |by: f64| {
            let mut sample = Sample::new(611, planar, false);
            change(&mut sample, by);
            settled(&sample, planar, places, v, a)
        };
        let sample = Sample::new(611, planar, false);
        let mut engine = at(0.0);
        let mut seeded = sample.blueprint.map(Seeded::from_f64);
        seeded.bodies[CHILD.0].mass.eps[0] = 1.0;
        seeded.gravity[1].eps[0] = 2.0;
        seeded.flexible[0].stiffness[0].eps[0] = 300.0;
        engine.seed(&seeded).unwrap();
        let two = |x: [f64; 2]| x.map(Seeded::from_f64);
        let (p, v, a) = (two(places), two(v), two(a));
        let time = Seeded::from_f64(0.0);
        engine
            .differentiate(&Prescription { time, position: &p, velocity: &v, acceleration: &a }, &mut |_, _| ())
            .unwrap();
        let h = 1e-5;
        let [before, after] = [at(-h), at(h)];
        let found = engine.derivatives().unwrap();
        for i in 0..2 {
            let difference = (after.drive(i) - before.drive(i)) / (2.0 * h);
            assert!((found.drive(i).eps[0] - difference).abs() < 1e-5 * difference.abs().max(1.0), "{difference}");
        }
        for c in &sample.elastic {
            let difference = (after.coordinate(*c).position - before.coordinate(*c).position) / (2.0 * h);
            assert!((found.coordinate(*c).position.eps[0] - difference).abs() < 1e-7, "{c:?} {difference}");
        }
    }
}
