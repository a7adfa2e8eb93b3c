//! What each element puts on the machine at the present position and velocity.

use super::element::{Element, End, Friction};
use crate::Value;
use crate::mechanism::{Mechanism, Source};
use crate::workspace::NodeState;
use bellcrank_math::{Components, Frame, Real, Space};

/// An element's own quantities.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Output<S: Space> {
    pub(crate) length: S::T,
    pub(crate) rate: S::T,
    pub(crate) effort: S::T,
    /// On the (second) point, world axes.
    pub(crate) force: S::Vector,
    pub(crate) moment: S::Angular,
    /// Stored energy, J.
    pub(crate) energy: S::T,
}

impl<S: Space> Default for Output<S> {
    fn default() -> Self {
        let o = S::T::zero();
        Self { length: o, rate: o, effort: o, force: S::Vector::default(), moment: S::Angular::default(), energy: o }
    }
}

/// Reads a coordinate's position and rate.
pub(crate) fn read<S: Space>(
    mech: &Mechanism<S>,
    x: &[NodeState<S>],
    q: &[S::T],
    v: &[S::T],
    s: Source,
) -> (S::T, S::T) {
    match s {
        Source::Node(n) => (q[mech.nodes[n].q], v[mech.nodes[n].v]),
        Source::Measured { link, measure } => {
            let link = &mech.links[link];
            let pose = link.pose(x);
            let motion = link.motion(x, &pose);
            (link.measure(measure, &pose).value, link.measure_rates(measure, &pose, &motion).0)
        }
    }
}

/// Adds an effort along a coordinate: to `efforts` for a tree coordinate, as a wrench for a measured one.
pub(crate) fn push<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>], efforts: &mut [S::T], s: Source, e: S::T) {
    match s {
        Source::Node(n) => efforts[mech.nodes[n].v] += e,
        Source::Measured { link, measure } => {
            let link = &mech.links[link];
            let pose = link.pose(x);
            let g = link.measure(measure, &pose);
            apply_pair(x, [link.ends[0].0, link.ends[1].0], pose.p[1], g.f * e, g.n * e);
        }
    }
}

/// A wrench at `p_W` on the second node and its opposite on the first.
#[inline]
pub(crate) fn apply_pair<S: Space>(
    x: &mut [NodeState<S>],
    nodes: [usize; 2],
    p_W: S::Vector,
    f: S::Vector,
    n: S::Angular,
) {
    x[nodes[1]].apply(p_W, f, n);
    x[nodes[0]].apply(p_W, -f, -n);
}

/// The state that elements read.
pub(crate) struct Present<'a, S: Space> {
    pub(crate) mech: &'a Mechanism<S>,
    pub(crate) q: &'a [S::T],
    pub(crate) v: &'a [S::T],
    pub(crate) inputs: &'a [S::T],
}

impl<S: Space> Present<'_, S> {
    pub(crate) fn value(&self, v: Value<S::T>) -> S::T {
        match v {
            Value::Constant(x) => x,
            Value::Input(i) => self.inputs[i],
        }
    }
    fn vector(&self, v: &[Value<S::T>; 3]) -> [S::T; 3] {
        [self.value(v[0]), self.value(v[1]), self.value(v[2])]
    }
}

/// Clears and applies every element but friction, which waits for the reactions. `efforts` (nv) collects
/// efforts along tree coordinates.
pub(crate) fn apply_all<S: Space>(
    now: &Present<'_, S>,
    x: &mut [NodeState<S>],
    efforts: &mut [S::T],
    outputs: &mut [Output<S>],
) {
    for x in x.iter_mut() {
        (x.ext_f, x.ext_n) = (S::Vector::default(), S::Angular::default());
    }
    efforts.fill(S::T::zero());
    for (element, out) in now.mech.elements.iter().zip(outputs) {
        *out = apply_one(now, element, x, efforts);
    }
    crate::flexible::add_efforts(now.mech, x, efforts);
}

fn apply_one<S: Space>(
    now: &Present<'_, S>,
    element: &Element<S>,
    x: &mut [NodeState<S>],
    efforts: &mut [S::T],
) -> Output<S> {
    match element {
        Element::Point { at, vector, axes } => point(now, at, vector, axes.as_ref(), x),
        Element::Torque { on, vector, axes } => torque(now, on, vector, axes.as_ref(), x),
        Element::Effort { source, value } => {
            let (length, rate) = read(now.mech, x, now.q, now.v, *source);
            let effort = now.value(*value);
            push(now.mech, x, efforts, *source, effort);
            Output { length, rate, effort, ..Output::default() }
        }
        Element::Spring { ends, stiffness, damping, free_length, preload } => {
            let law = Law {
                k: now.value(*stiffness),
                c: now.value(*damping),
                rest: now.value(*free_length),
                preload: now.value(*preload),
            };
            spring(ends, &law, x)
        }
        Element::JointSpring { source, stiffness, damping, free_position, preload } => {
            let law = Law {
                k: now.value(*stiffness),
                c: now.value(*damping),
                rest: now.value(*free_position),
                preload: now.value(*preload),
            };
            let (length, rate) = read(now.mech, x, now.q, now.v, *source);
            let out = law.output(length, rate);
            push(now.mech, x, efforts, *source, out.effort);
            out
        }
        Element::Friction(f) => {
            let (length, rate) = read(now.mech, x, now.q, now.v, f.source);
            Output { length, rate, ..Output::default() }
        }
        Element::Stop { source, restitution: Some(_), .. } => {
            // It acts by impacts and as a constraint, in forward dynamics only.
            let (length, rate) = read(now.mech, x, now.q, now.v, *source);
            Output { length, rate, ..Output::default() }
        }
        Element::Stop { source, min, max, stiffness, damping, .. } => {
            let (length, rate) = read(now.mech, x, now.q, now.v, *source);
            let (k, c) = (now.value(*stiffness), now.value(*damping));
            let limits = [min.map(|m| now.value(m)), max.map(|m| now.value(m))];
            let out = stop(length, rate, k, c, limits);
            push(now.mech, x, efforts, *source, out.effort);
            out
        }
        Element::Bushing { ends, stiffness, damping } => {
            let k = stiffness.map(|s| now.value(s));
            let c = damping.map(|s| now.value(s));
            bushing(ends, &k, &c, x)
        }
    }
}

fn point<S: Space>(
    now: &Present<'_, S>,
    at: &End<S>,
    v: &[Value<S::T>; 3],
    axes: Option<&End<S>>,
    x: &mut [NodeState<S>],
) -> Output<S> {
    let X = x[at.node].frame(&at.frame);
    let mut f = S::vector(&now.vector(v));
    if let Some(axes) = axes {
        f = S::rotate(&x[axes.node].frame(&axes.frame).rotation, f);
    }
    x[at.node].apply(X.origin, f, S::Angular::default());
    Output { length: nan::<S>(), rate: nan::<S>(), effort: magnitude(f.dot(f)), force: f, ..Output::default() }
}

fn torque<S: Space>(
    now: &Present<'_, S>,
    on: &End<S>,
    v: &[Value<S::T>; 3],
    axes: Option<&End<S>>,
    x: &mut [NodeState<S>],
) -> Output<S> {
    let X = x[on.node].frame(&on.frame);
    let mut n = S::angular(&now.vector(v));
    if let Some(axes) = axes {
        n = S::rotate_angular(&x[axes.node].frame(&axes.frame).rotation, n);
    }
    x[on.node].apply(X.origin, S::Vector::default(), n);
    // A plane's moment has a sign worth showing; space has a magnitude.
    let effort = if S::ANG == 1 { n[0] } else { magnitude(n.dot(n)) };
    Output { length: nan::<S>(), rate: nan::<S>(), effort, moment: n, ..Output::default() }
}

/// Root of a sum of squares; that of nothing grows in no direction more than in another: its derivative counts as 0.
fn magnitude<T: Real>(square: T) -> T {
    if square.value() > 0.0 { square.sqrt() } else { T::zero() }
}

fn nan<S: Space>() -> S::T {
    S::T::from_f64(f64::NAN)
}

/// Spring and damper on one length.
struct Law<T> {
    k: T,
    c: T,
    rest: T,
    preload: T,
}

impl<T: Real> Law<T> {
    fn output<S: Space<T = T>>(&self, length: T, rate: T) -> Output<S> {
        let stretch = length - self.rest;
        let effort = self.preload - self.k * stretch - self.c * rate;
        let energy = self.k * stretch * stretch * T::from_f64(0.5) - self.preload * stretch;
        Output { length, rate, effort, energy, ..Output::default() }
    }
}

fn spring<S: Space>(ends: &[End<S>; 2], law: &Law<S::T>, x: &mut [NodeState<S>]) -> Output<S> {
    let p = [0, 1].map(|i| x[ends[i].node].frame(&ends[i].frame).origin);
    let v = [0, 1].map(|i| x[ends[i].node].at(p[i]).0);
    let d = p[1] - p[0];
    let l = d.dot(d).sqrt();
    // Ends in one place have no direction to push along.
    let u = if l.value() > 0.0 { d * (S::T::one() / l) } else { S::Vector::default() };
    let mut out = law.output::<S>(l, u.dot(v[1] - v[0]));
    out.force = u * out.effort;
    apply_pair(x, [ends[0].node, ends[1].node], p[1], out.force, S::Angular::default());
    out
}

/// Pushes back beyond a limit; never pulls.
fn stop<S: Space>(q: S::T, rate: S::T, k: S::T, c: S::T, [min, max]: [Option<S::T>; 2]) -> Output<S> {
    let mut out = Output { length: q, rate, ..Output::default() };
    let half = S::T::from_f64(0.5);
    if let Some(over) = min.map(|m| m - q).filter(|o| o.value() > 0.0) {
        let e = k * over - c * rate;
        out.effort = if e.value() > 0.0 { e } else { S::T::zero() };
        out.energy = k * over * over * half;
    }
    if let Some(over) = max.map(|m| q - m).filter(|o| o.value() > 0.0) {
        let e = k * over + c * rate;
        out.effort = if e.value() > 0.0 { -e } else { S::T::zero() };
        out.energy = k * over * over * half;
    }
    out
}

/// Six springs in the first frame. The turn is the rotation vector of the second frame in the first.
fn bushing<S: Space>(ends: &[End<S>; 2], k: &[S::T; 6], c: &[S::T; 6], x: &mut [NodeState<S>]) -> Output<S> {
    let X: [Frame<S>; 2] = [0, 1].map(|i| x[ends[i].node].frame(&ends[i].frame));
    let back = S::transpose(&X[0].rotation);
    let (d, turn) = (X[1].origin - X[0].origin, S::to_matrix(&S::compose(&back, &X[1].rotation)));
    let first = &x[ends[0].node];
    let slip = x[ends[1].node].at(X[1].origin).0 - first.at(X[1].origin).0;
    let spin = x[ends[1].node].w - first.w;
    let (d_1, v_1) = (S::spread(S::rotate(&back, d)), S::spread(S::rotate(&back, slip)));
    let (t_1, w_1) = (rotation_vector(&turn), S::spread_angular(S::rotate_angular(&back, spin)));
    let f: [S::T; 3] = std::array::from_fn(|i| -(k[i] * d_1[i]) - c[i] * v_1[i]);
    let n: [S::T; 3] = std::array::from_fn(|i| -(k[i + 3] * t_1[i]) - c[i + 3] * w_1[i]);
    let (force, moment) = (S::rotate(&X[0].rotation, S::vector(&f)), S::rotate_angular(&X[0].rotation, S::angular(&n)));
    apply_pair(x, [ends[0].node, ends[1].node], X[1].origin, force, moment);
    let half = S::T::from_f64(0.5);
    let energy = (0..3).fold(S::T::zero(), |e, i| e + (k[i] * d_1[i] * d_1[i] + k[i + 3] * t_1[i] * t_1[i]) * half);
    let length = magnitude(d.dot(d));
    let rate = if length.value() > 0.0 { d.dot(slip) / length } else { S::T::zero() };
    Output { length, rate, effort: magnitude(force.dot(force)), force, moment, energy }
}

/// Rotation vector of a rotation matrix (rows), rad, below a half turn.
fn rotation_vector<T: Real>(r: &[[T; 3]; 3]) -> [T; 3] {
    let half = T::from_f64(0.5);
    let a = [(r[2][1] - r[1][2]) * half, (r[0][2] - r[2][0]) * half, (r[1][0] - r[0][1]) * half];
    let s2 = a[0] * a[0] + a[1] * a[1] + a[2] * a[2];
    if s2.value() < 1e-24 {
        return a;
    }
    let s = s2.sqrt();
    let c = (r[0][0] + r[1][1] + r[2][2] - T::one()) * half;
    let k = s.atan2(c) / s;
    a.map(|x| x * k)
}

/// Which way friction looks at the slip: its sign, or smoothly through zero.
pub(crate) fn friction_direction<S: Space>(now: &Present<'_, S>, f: &Friction<S::T>, rate: S::T) -> S::T {
    match f.smoothing_velocity {
        Some(v) => (rate / now.value(v)).tanh(),
        None => S::T::from_f64(rate.value().partial_cmp(&0.0).map_or(0.0, |o| f64::from(o as i8))),
    }
}

/// Friction effort from rate, its direction, and normal force.
pub(crate) fn friction_effort<S: Space>(
    now: &Present<'_, S>,
    f: &Friction<S::T>,
    rate: S::T,
    direction: S::T,
    normal: S::T,
) -> S::T {
    let mu_c = now.value(f.coulomb);
    let mu = match (f.static_coefficient, f.stribeck_velocity) {
        (Some(mu_s), Some(v_s)) => {
            let z = rate / now.value(v_s);
            mu_c + (now.value(mu_s) - mu_c) * (-(z * z)).exp()
        }
        _ => mu_c,
    };
    -(mu * normal * lever(now, f) * direction) - now.value(f.viscous) * rate
}

/// Largest effort with which friction holds still.
pub(crate) fn holding_effort<S: Space>(now: &Present<'_, S>, f: &Friction<S::T>, normal: S::T) -> S::T {
    let mu_c = now.value(f.coulomb);
    let mu_s = f.static_coefficient.map_or(mu_c, |s| now.value(s));
    let mu = if mu_s.value() > mu_c.value() { mu_s } else { mu_c };
    mu * normal * lever(now, f)
}

fn lever<S: Space>(now: &Present<'_, S>, f: &Friction<S::T>) -> S::T {
    f.radius.map_or(S::T::one(), |r| now.value(r))
}
