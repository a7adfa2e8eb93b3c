//! Identities on random mechanisms, planar and spatial, open and closed, in general position.
//!
//! A random tree is placed at random coordinates; joints of random kinds are then put between random bodies
//! with their second place where it closes, so that every mechanism has an assembled position.

use crate::build::*;
use bellcrank_multibody::{
    Actuation, Axes, Blueprint, Body, BodyId, BodyMotion, Coordinate, Engine, Force, JointId, JointKind, Place, Value,
    engine_for,
};

type Vec3 = [f64; 3];
type Mat3 = [[f64; 3]; 3];

/// A linear congruential generator: the same mechanisms on every machine.
pub struct Dice(u64);

impl Dice {
    pub fn new(seed: u64) -> Self {
        Self(seed.wrapping_mul(0x5851_F42D_4C95_7F2D) ^ 0x1405_7B7E_F767_814F)
    }
    pub fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }
    pub fn within(&mut self, a: f64, b: f64) -> f64 {
        a + (b - a) * self.next()
    }
    pub fn below(&mut self, n: usize) -> usize {
        ((self.next() * n as f64) as usize).min(n - 1)
    }
    fn vector(&mut self, planar: bool, size: f64) -> Vec3 {
        let z = if planar { 0.0 } else { self.within(-size, size) };
        [self.within(-size, size), self.within(-size, size), z]
    }
    fn turn(&mut self, planar: bool) -> Mat3 {
        let rpy = if planar { [0.0, 0.0, self.within(-3.0, 3.0)] } else { self.vector(false, 1.2) };
        bellcrank_math::matrix_from_rpy(&rpy)
    }
}

fn times(a: &Mat3, b: &Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| a[i][k] * b[k][j]).sum()))
}
fn apply(a: &Mat3, v: Vec3) -> Vec3 {
    std::array::from_fn(|i| (0..3).map(|k| a[i][k] * v[k]).sum())
}
fn transpose(a: &Mat3) -> Mat3 {
    std::array::from_fn(|i| std::array::from_fn(|j| a[j][i]))
}
fn add(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] + b[i])
}
fn sub(a: Vec3, b: Vec3) -> Vec3 {
    std::array::from_fn(|i| a[i] - b[i])
}
fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}
pub fn largest(v: Vec3) -> f64 {
    v.iter().fold(0.0, |m, x| m.max(x.abs()))
}

fn random_body(dice: &mut Dice, planar: bool) -> Body<f64> {
    let mass = dice.within(0.5, 4.0);
    let d = [dice.within(0.02, 0.08), dice.within(0.02, 0.08), dice.within(0.02, 0.08)];
    let r = dice.turn(planar);
    let tensor: Mat3 = std::array::from_fn(|i| {
        std::array::from_fn(|j| (0..3).map(|k| r[i][k] * (d[0] + d[1] + d[2] - d[k]) * r[j][k]).sum())
    });
    Body { mass, center: dice.vector(planar, 0.4), inertia: tensor }
}

fn random_kind(dice: &mut Dice, planar: bool, choices: &[usize]) -> JointKind<f64> {
    let axis = if planar { Z } else { dice.vector(false, 1.0) };
    let in_plane = dice.vector(planar, 1.0);
    match choices[dice.below(choices.len())] {
        0 => JointKind::Revolute { axis },
        1 => JointKind::Prismatic { axis: in_plane },
        2 => JointKind::Cylindrical { axis },
        3 => JointKind::Screw { axis, pitch: dice.within(0.05, 0.3) },
        4 => JointKind::Universal { axis, axis2: cross(axis, dice.vector(false, 1.0)) },
        5 => JointKind::Spherical,
        6 => JointKind::Planar,
        7 => JointKind::Distance { length: None },
        8 => JointKind::PointOnLine { axis: in_plane },
        _ => JointKind::Free,
    }
}

fn random_place(dice: &mut Dice, planar: bool, body: usize) -> Place<f64> {
    Place { body: BodyId(body), position: dice.vector(planar, 0.8), rotation: dice.turn(planar) }
}

fn random_start(dice: &mut Dice, kind: &JointKind<f64>, planar: bool) -> Vec<f64> {
    let n = match kind {
        JointKind::Cylindrical { .. } | JointKind::Universal { .. } => 2,
        JointKind::Spherical | JointKind::Planar => 3,
        JointKind::Free => {
            if planar {
                3
            } else {
                6
            }
        }
        _ => 1,
    };
    (0..n).map(|_| dice.within(-0.9, 0.9)).collect()
}

fn random_tree(dice: &mut Dice, planar: bool, bodies: usize) -> Blueprint<f64> {
    let choices: &[usize] = if planar { &[0, 0, 0, 1, 6] } else { &[0, 0, 0, 1, 2, 3, 4, 5, 6] };
    let mut joints = Vec::new();
    for child in 1..=bodies {
        let parent = if dice.next() < 0.3 { 0 } else { dice.below(child) };
        // The first joint carries a spring along its coordinate, which a ball does not have.
        let kind = random_kind(dice, planar, if child == 1 { &[0, 1] } else { choices });
        let start = random_start(dice, &kind, planar);
        let (a, b) = (random_place(dice, planar, parent), random_place(dice, planar, child));
        let (first, second) = if dice.next() < 0.5 { (a, b) } else { (b, a) };
        joints.push(started(joint(kind, first, second), &start));
    }
    let bodies = (0..bodies).map(|_| random_body(dice, planar)).collect();
    let gravity = if planar { [1.1, -9.4, 0.0] } else { [1.1, -2.3, -9.4] };
    let mut b = blueprint(gravity, bodies, joints, Vec::new());
    b.forces = random_forces(dice, planar, b.bodies.len());
    b
}

fn random_forces(dice: &mut Dice, planar: bool, bodies: usize) -> Vec<Force<f64>> {
    let c = Value::Constant;
    let (i, j) = (1 + dice.below(bodies - 1), dice.below(bodies));
    let vector = dice.vector(planar, 20.0).map(c);
    let moment = if planar { [c(0.0), c(0.0), c(dice.within(-5.0, 5.0))] } else { dice.vector(false, 5.0).map(c) };
    let mut six = || std::array::from_fn(|_| c(dice.within(5.0, 50.0)));
    let (stiffness, damping) = (six(), six());
    vec![
        Force::Point { at: random_place(dice, planar, i), vector, axes: Axes::Body },
        Force::Torque { on: BodyId(i), vector: moment, axes: Axes::Frame(random_place(dice, planar, i / 2)) },
        Force::Spring {
            between: [random_place(dice, planar, j), random_place(dice, planar, i)],
            stiffness: c(120.0),
            damping: c(7.0),
            free_length: c(0.3),
            preload: c(4.0),
        },
        Force::JointSpring {
            coordinate: coordinate(0),
            stiffness: c(15.0),
            damping: c(2.0),
            free_position: c(0.1),
            preload: c(-3.0),
        },
        Force::Bushing { between: [random_place(dice, planar, i), random_place(dice, planar, j)], stiffness, damping },
    ]
}

/// The second place of a loop joint, where it closes at the present position.
fn closing_place(
    e: &dyn Engine,
    first: &Place<f64>,
    second: usize,
    dice: &mut Dice,
    planar: bool,
    kind: &JointKind<f64>,
) -> Place<f64> {
    let (a, b) = (e.body(first.body), e.body(BodyId(second)));
    let r1 = times(&a.rotation, &first.rotation);
    let p1 = add(a.origin, apply(&a.rotation, first.position));
    // Joints that allow it are closed away from their zero.
    let p1 = match kind {
        JointKind::Distance { .. } | JointKind::Free => add(p1, apply(&r1, dice.vector(planar, 0.5))),
        JointKind::Prismatic { axis } | JointKind::Cylindrical { axis } | JointKind::PointOnLine { axis } => {
            add(p1, apply(&r1, axis.map(|x| 0.4 * x)))
        }
        _ => p1,
    };
    let r1 = match kind {
        JointKind::Spherical | JointKind::Distance { .. } | JointKind::PointOnLine { .. } => {
            times(&r1, &dice.turn(planar))
        }
        JointKind::Revolute { .. } if planar => times(&r1, &dice.turn(true)),
        _ => r1,
    };
    let back = transpose(&b.rotation);
    Place { body: BodyId(second), position: apply(&back, sub(p1, b.origin)), rotation: times(&back, &r1) }
}

/// A mechanism with up to `loops` loops that still moves.
pub fn random_mechanism(seed: u64, planar: bool, bodies: usize, loops: usize) -> Blueprint<f64> {
    let mut dice = Dice::new(seed);
    let mut b = random_tree(&mut dice, planar, bodies);
    let mut e = engine_for(planar, &b).expect("tree builds");
    e.assemble(&[]).expect("a tree is assembled");
    let mut degrees = e.freedom().degrees as i64;
    let choices: &[usize] = if planar { &[0, 0, 1, 7, 8] } else { &[0, 1, 2, 4, 5, 5, 5, 6, 7, 8] };
    for _ in 0..loops {
        let kind = random_kind(&mut dice, planar, choices);
        let lost = match (&kind, planar) {
            (JointKind::Distance { .. }, _) => 0,
            (JointKind::PointOnLine { .. }, p) => {
                if p {
                    1
                } else {
                    2
                }
            }
            (JointKind::Spherical | JointKind::Planar, _) => 3,
            (JointKind::Cylindrical { .. } | JointKind::Universal { .. }, _) => 4,
            (_, p) => {
                if p {
                    2
                } else {
                    5
                }
            }
        };
        if degrees - lost < 1 {
            continue;
        }
        degrees -= lost;
        let (i, j) = (dice.below(bodies + 1), 1 + dice.below(bodies));
        if i == j {
            continue;
        }
        let first = random_place(&mut dice, planar, i);
        let second = closing_place(&*e, &first, j, &mut dice, planar, &kind);
        b.joints.push(joint(kind, first, second));
    }
    b
}

/// An assembled engine with coordinates that take all freedom, or `None` for a mechanism that is stuck.
pub fn prepared(b: &Blueprint<f64>, planar: bool) -> Option<(Box<dyn Engine>, Vec<Coordinate>)> {
    let mut e = engine_for(planar, b).expect("builds");
    e.assemble(&[]).expect("it was put together");
    let freedom = e.freedom();
    let all: Vec<Coordinate> = (0..b.joints.len())
        .flat_map(|j| (0..e.coordinates_of(JointId(j))).map(move |index| Coordinate { joint: JointId(j), index }))
        .collect();
    let mut list = Vec::new();
    choose(&mut *e, &all, 0, freedom.degrees, &mut list, &mut 0).then_some((e, list))
}

/// Depth-first search for a set of coordinates that [`Engine::prepare`] accepts.
fn choose(
    e: &mut dyn Engine,
    all: &[Coordinate],
    from: usize,
    more: usize,
    list: &mut Vec<Coordinate>,
    tries: &mut usize,
) -> bool {
    *tries += 1;
    if *tries > 3000 {
        return false;
    }
    if more == 0 {
        let a = Actuation { position: list.clone(), rate: list.clone(), effort: list.clone() };
        return e.prepare(&a).is_ok();
    }
    for k in from..all.len() {
        // Angles of a ball come in threes.
        let triple =
            (0..3).all(|i| all.get(k + i).is_some_and(|c| c.joint == all[k].joint && c.index == all[k].index + i));
        for take in if triple && more >= 3 { [1, 3] } else { [1, 1] } {
            list.extend_from_slice(&all[k..k + take]);
            if choose(e, all, k + take, more - take, list, tries) {
                return true;
            }
            list.truncate(list.len() - take);
        }
    }
    false
}

pub struct Motion {
    pub at: Vec<f64>,
    pub rate: Vec<f64>,
    pub accel: Vec<f64>,
}

impl Motion {
    pub fn position(&self, t: f64) -> Vec<f64> {
        (0..self.at.len()).map(|i| self.at[i] + self.rate[i] * t + 0.5 * self.accel[i] * t * t).collect()
    }
    pub fn velocity(&self, t: f64) -> Vec<f64> {
        (0..self.at.len()).map(|i| self.rate[i] + self.accel[i] * t).collect()
    }
}

pub fn solve(e: &mut dyn Engine, m: &Motion, t: f64) -> bool {
    e.move_to(t, &m.position(t)).is_ok()
        && e.set_rates(&m.velocity(t), &m.accel).is_ok()
        && e.solve_forces(&mut |_, _| {}).is_ok()
}

fn snapshot(e: &dyn Engine, bodies: usize) -> (Vec<BodyMotion>, f64) {
    ((0..bodies).map(|b| e.body(BodyId(b))).collect(), e.energy().kinetic)
}

fn check_mechanism(seed: u64, planar: bool, bodies: usize, loops: usize) -> bool {
    let b = random_mechanism(seed, planar, bodies, loops);
    let Some((mut e, list)) = prepared(&b, planar) else { return false };
    let mut dice = Dice::new(seed + 77);
    let m = Motion {
        at: list.iter().map(|c| e.coordinate(*c).position).collect(),
        rate: list.iter().map(|_| dice.within(-1.0, 1.0)).collect(),
        accel: list.iter().map(|_| dice.within(-1.0, 1.0)).collect(),
    };
    let h = 2e-5;
    let n = b.bodies.len();
    let mut samples = Vec::new();
    for t in [-h, h, 0.0] {
        if !solve(&mut *e, &m, t) {
            return false;
        }
        samples.push(snapshot(&*e, n));
    }
    let speed = samples[2].0.iter().fold(1.0, |s: f64, x| s.max(largest(x.omega)).max(largest(x.center.velocity)));
    // Near-singular draws amplify everything; the identities are tested where numbers are of ordinary size.
    let accel = samples[2].0.iter().fold(1.0, |s: f64, x| s.max(largest(x.alpha)).max(largest(x.center.acceleration)));
    if speed > 30.0 || accel > 300.0 {
        return false;
    }
    let what = format!("seed {seed} planar {planar} bodies {bodies} joints {}", b.joints.len());
    check_rates(&samples, h, speed, &what);
    check_free_bodies(&b, &*e, &what);
    check_power(&b, &*e, &list, &samples, h, &m, &what);
    let checks = e.checks();
    assert!(checks.closure < 1e-12, "{what}: closure {}", checks.closure);
    assert!(checks.balance < 1e-9, "{what}: balance {}", checks.balance);
    true
}

fn check_rates(s: &[(Vec<BodyMotion>, f64)], h: f64, speed: f64, what: &str) {
    let tolerance = 2e-6 * speed.powi(3);
    for ((down, up), now) in s[0].0.iter().zip(&s[1].0).zip(&s[2].0) {
        let (p0, p1) = (down.center, up.center);
        for i in 0..3 {
            let v = (p1.position[i] - p0.position[i]) / (2.0 * h);
            let a = (p1.velocity[i] - p0.velocity[i]) / (2.0 * h);
            let alpha = (up.omega[i] - down.omega[i]) / (2.0 * h);
            assert!((v - now.center.velocity[i]).abs() < tolerance, "{what}: velocity {v} {}", now.center.velocity[i]);
            assert!(
                (a - now.center.acceleration[i]).abs() < 10.0 * tolerance,
                "{what}: acceleration {a} {}",
                now.center.acceleration[i]
            );
            assert!((alpha - now.alpha[i]).abs() < 10.0 * tolerance, "{what}: alpha {alpha} {}", now.alpha[i]);
        }
    }
}

/// Wrench that the force elements put on each body, about the world origin, from their data and the motion.
fn applied(b: &Blueprint<f64>, e: &dyn Engine, wrenches: &mut [(Vec3, Vec3)]) {
    let mut put = |body: usize, p: Vec3, f: Vec3, n: Vec3| {
        wrenches[body].0 = add(wrenches[body].0, f);
        wrenches[body].1 = add(wrenches[body].1, add(n, cross(p, f)));
    };
    for (k, force) in b.forces.iter().enumerate() {
        let out = e.force(bellcrank_multibody::ForceId(k));
        let world = |p: &Place<f64>| e.point(p.body, p.position).position;
        match force {
            Force::Point { at, .. } => put(at.body.0, world(at), out.vector, [0.0; 3]),
            Force::Torque { on, vector, axes } => {
                let n = vector.map(|v| if let Value::Constant(x) = v { x } else { 0.0 });
                let n = match axes {
                    Axes::Frame(at) => apply(&times(&e.body(at.body).rotation, &at.rotation), n),
                    _ => n,
                };
                put(on.0, [0.0; 3], [0.0; 3], n);
            }
            Force::Spring { between, .. } => {
                put(between[1].body.0, world(&between[1]), out.vector, [0.0; 3]);
                put(between[0].body.0, world(&between[1]), out.vector.map(|x| -x), [0.0; 3]);
            }
            Force::Bushing { between, stiffness, damping } => {
                let (f, n) = bushing_wrench(e, between, stiffness, damping);
                put(between[1].body.0, world(&between[1]), f, n);
                put(between[0].body.0, world(&between[1]), f.map(|x| -x), n.map(|x| -x));
            }
            _ => {}
        }
    }
}

fn bushing_wrench(e: &dyn Engine, between: &[Place<f64>; 2], k: &[Value<f64>; 6], c: &[Value<f64>; 6]) -> (Vec3, Vec3) {
    let number = |v: &Value<f64>| if let Value::Constant(x) = v { *x } else { 0.0 };
    let (a, b) = (e.body(between[0].body), e.body(between[1].body));
    let r1 = times(&a.rotation, &between[0].rotation);
    let r2 = times(&b.rotation, &between[1].rotation);
    let (p1, p2) = (e.point(between[0].body, between[0].position), e.point(between[1].body, between[1].position));
    let back = transpose(&r1);
    let d = sub(p2.position, p1.position);
    let slip = sub(sub(p2.velocity, p1.velocity), cross(a.omega, d));
    let spin = sub(b.omega, a.omega);
    let q = bellcrank_math::quaternion_from_matrix(&times(&back, &r2));
    let s = (q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    let angle = 2.0 * s.atan2(q[0].abs()) * q[0].signum();
    let turn = [q[1], q[2], q[3]].map(|x| if s > 0.0 { x / s * angle } else { 0.0 });
    let (d, slip, spin) = (apply(&back, d), apply(&back, slip), apply(&back, spin));
    let f = std::array::from_fn(|i| -number(&k[i]) * d[i] - number(&c[i]) * slip[i]);
    let n = std::array::from_fn(|i| -number(&k[i + 3]) * turn[i] - number(&c[i + 3]) * spin[i]);
    (apply(&r1, f), apply(&r1, n))
}

/// Every body taken free: reactions, weight and applied forces make its mass times acceleration.
fn check_free_bodies(b: &Blueprint<f64>, e: &dyn Engine, what: &str) {
    let mut total = vec![([0.0; 3], [0.0; 3]); b.bodies.len()];
    applied(b, e, &mut total);
    for (j, joint) in b.joints.iter().enumerate() {
        let Some([first, second]) = &joint.places else { continue };
        let w = e.reaction(JointId(j));
        let p = e.point(second.body, second.position).position;
        for (body, sign) in [(second.body.0, 1.0), (first.body.0, -1.0)] {
            let (f, n) = (w.force.map(|x| sign * x), w.moment.map(|x| sign * x));
            total[body].0 = add(total[body].0, f);
            total[body].1 = add(total[body].1, add(n, cross(p, f)));
        }
    }
    let size = total.iter().fold(1.0, |m: f64, t| m.max(largest(t.0)).max(largest(t.1)));
    let scale = (0..b.joints.len()).fold(size, |m, j| m.max(largest(e.reaction(JointId(j)).force)));
    for (i, body) in b.bodies.iter().enumerate().skip(1) {
        let x = e.body(BodyId(i));
        let weight = b.gravity.map(|g| g * body.mass);
        let ma = x.center.acceleration.map(|a| a * body.mass);
        let f = sub(add(total[i].0, weight), ma);
        let inertia = times(&times(&x.rotation, &body.inertia), &transpose(&x.rotation));
        let spin = add(apply(&inertia, x.alpha), cross(x.omega, apply(&inertia, x.omega)));
        let about_origin = cross(x.center.position, sub(weight, ma));
        let n = sub(add(total[i].1, about_origin), spin);
        let planar_n = if b.joints.is_empty() { 0.0 } else { n[2].abs() };
        let moment =
            if x.rotation[2][2] == 1.0 && x.origin[2] == 0.0 && body.center[2] == 0.0 { planar_n } else { largest(n) };
        assert!(
            largest(f) < 1e-9 * scale && moment < 1e-9 * scale,
            "{what}: body {i} force {f:?} moment {n:?} scale {scale}"
        );
    }
}

/// Power of drives, weights and applied forces against the rate of kinetic energy, by differences.
fn check_power(
    b: &Blueprint<f64>,
    e: &dyn Engine,
    list: &[Coordinate],
    s: &[(Vec<BodyMotion>, f64)],
    h: f64,
    m: &Motion,
    what: &str,
) {
    if list.iter().any(|c| matches!(b.joints[c.joint.0].kind, JointKind::Spherical)) {
        // The effort of an attitude drive is a moment about an axis, not conjugate to an angle's rate.
        return;
    }
    let mut total = vec![([0.0; 3], [0.0; 3]); b.bodies.len()];
    applied(b, e, &mut total);
    let dot = |a: Vec3, b: Vec3| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let mut power: f64 = list.iter().enumerate().map(|(k, _)| e.drive(k) * m.velocity(0.0)[k]).sum();
    for (i, body) in b.bodies.iter().enumerate().skip(1) {
        let x = e.body(BodyId(i));
        power += body.mass * dot(b.gravity, x.center.velocity);
        let v_at_origin = sub(x.center.velocity, cross(x.omega, x.center.position));
        power += dot(total[i].0, v_at_origin) + dot(total[i].1, x.omega);
    }
    let spring = e.force(bellcrank_multibody::ForceId(3));
    power += spring.effort * e.coordinate(coordinate(0)).velocity;
    let rate = (s[1].1 - s[0].1) / (2.0 * h);
    let scale = 1.0 + power.abs() + rate.abs() + s[2].1;
    assert!((power - rate).abs() < 3e-5 * scale, "{what}: power {power} against {rate}");
}

#[test]
fn planar_mechanisms() {
    let tested =
        (0..120).filter(|&seed| check_mechanism(seed, true, 2 + (seed as usize) % 6, (seed as usize) % 4)).count();
    assert!(tested > 60, "only {tested} of 120 mechanisms could be tested");
}

#[test]
fn spatial_mechanisms() {
    let tested = (0..120)
        .filter(|&seed| check_mechanism(seed + 1000, false, 2 + (seed as usize) % 5, (seed as usize) % 3))
        .count();
    assert!(tested > 60, "only {tested} of 120 mechanisms could be tested");
}

/// A planar mechanism written in space is redundant, moves the same, and asks the same of its drives.
#[test]
fn the_plane_in_space_is_the_plane() {
    let mut tested = 0;
    for seed in 0..40 {
        let b = random_mechanism(seed, true, 2 + (seed as usize) % 5, (seed as usize) % 4);
        let Some((mut flat, list)) = prepared(&b, true) else { continue };
        let mut space = engine_for(false, &b).expect("builds in space");
        space.assemble(&[]).expect("assembles in space");
        let a = Actuation { position: list.clone(), rate: list.clone(), effort: list.clone() };
        let m = Motion {
            at: list.iter().map(|c| flat.coordinate(*c).position).collect(),
            rate: list.iter().map(|_| 0.4).collect(),
            accel: list.iter().map(|_| -0.3).collect(),
        };
        // A ball of mobility out of the plane (a distance or a line does not hold it) is not the same machine.
        if space.prepare(&a).is_err() || !solve(&mut *flat, &m, 0.0) || !solve(&mut *space, &m, 0.0) {
            continue;
        }
        compare(&b, &*flat, &mut *space, list.len(), &format!("seed {seed}"));
        tested += 1;
    }
    assert!(tested > 20, "only {tested} of 40 could be compared");
}

fn compare(b: &Blueprint<f64>, flat: &dyn Engine, space: &mut dyn Engine, drives: usize, what: &str) {
    let unique = space.uniqueness();
    let size = (0..b.joints.len()).fold(1.0, |s: f64, j| s.max(largest(flat.reaction(JointId(j)).force)));
    for k in 0..drives {
        assert!((flat.drive(k) - space.drive(k)).abs() < 1e-8 * size, "{what}: drive {k}");
    }
    for (j, unique) in unique.iter().enumerate() {
        let (p, s) = (flat.reaction(JointId(j)), space.reaction(JointId(j)));
        let pairs = [
            (p.force[0], s.force[0], unique[0]),
            (p.force[1], s.force[1], unique[1]),
            (p.moment[2], s.moment[2], unique[5]),
        ];
        for (k, (p, s, unique)) in pairs.into_iter().enumerate() {
            assert!(!unique || (p - s).abs() < 1e-8 * size, "{what}: joint {j} component {k}: {p} against {s}");
        }
    }
    assert!(space.checks().balance < 1e-9 && space.checks().closure < 1e-12, "{what}: {:?}", space.checks());
}

/// A vertical slider-crank in a frame turned about x: its out-of-plane equations are pure rounding, not rank.
#[test]
fn rounding_is_no_equation() {
    for degrees in [0.0_f64, 30.0, 45.0, 60.0, 90.0, 120.0, 270.0] {
        let turn = bellcrank_math::matrix_from_rpy(&[degrees.to_radians(), 0.0, 0.0]);
        let on = |body: usize, p: Vec3| Place { body: BodyId(body), position: apply(&turn, p), rotation: turn };
        let axis = Z;
        let joints = vec![
            started(joint(JointKind::Revolute { axis }, on(0, [0.0; 3]), on(1, [0.0; 3])), &[0.7]),
            joint(JointKind::Revolute { axis }, on(1, [0.1, 0.0, 0.0]), on(2, [0.0; 3])),
            joint(JointKind::Revolute { axis }, on(2, [0.3, 0.0, 0.0]), on(3, [0.0; 3])),
            started(joint(JointKind::Prismatic { axis: X }, on(0, [0.0; 3]), on(3, [0.0; 3])), &[0.35]),
        ];
        let bodies = (0..3).map(|_| body(1.0, [0.05, 0.0], 0.01)).collect();
        let mut e = engine_for(false, &blueprint([0.0, 0.0, -9.81], bodies, joints, Vec::new())).expect("builds");
        e.assemble(&[]).expect("assembles");
        let freedom = e.freedom();
        assert_eq!((freedom.degrees, freedom.equations - freedom.rank), (1, 3), "turned by {degrees}");
    }
}
