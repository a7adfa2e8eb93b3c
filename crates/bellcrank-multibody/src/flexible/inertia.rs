//! Inertia of a flexible body: what its motion asks of its floating frame and of its coordinates.
//!
//! A particle at r = x + Σ φ_e d_e (body axes) has the acceleration
//! `a + ω̇×r + ω×(ω×r) + 2 ω×u̇ + ü`, u̇ = Σ φ_e ḋ_e. With S = ∫ r dm, J = ∫ r rᵀ dm, I = tr(J) 1 − J and
//! H_e = ∫ r φ_eᵀ dm its demands are
//!
//! force `m a + ω̇×S + ω×(ω×S) + Σ (2 ω×f_e ḋ_e + f_e d̈_e)`, f_e = ∫ φ_e dm,
//! moment `S×a + I ω̇ + ω×I ω + Σ (2 ḋ_e (tr(H_e) ω − H_eᵀ ω) + d̈_e ax(H_e))`,
//! along e `f_e·a + ω̇·ax(H_e) + ωᵀ H_e ω − ω² tr H_e + Σ_l (2 ω·ax(P_le) ḋ_l + m_le d̈_l)`,
//!
//! where P_le = ∫ φ_l φ_eᵀ dm and ax(∫ a bᵀ) = ∫ a×b. Shabana, Dynamics of Multibody Systems, ch. 5; Zwölfer &
//! Gerstmayr (2021) for what of it the finite elements' own mass matrix gives. Weight counts as acceleration upward.

use super::Deforming;
use super::deforming::add;
use crate::mechanism::Mechanism;
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Components, Real, Space};

type Three<T> = [T; 3];
type Nine<T> = [[T; 3]; 3];

/// Motion of the floating frame, in its own axes.
pub(crate) struct Carriage<S: Space> {
    rotation: S::Rotation,
    /// Of the frame's origin from the node's, world axes.
    arm: S::Vector,
    /// Of the origin, less gravity.
    a: Three<S::T>,
    w: Three<S::T>,
    wd: Three<S::T>,
    /// `∫ r dm` and `∫ r rᵀ dm` so far.
    first: Three<S::T>,
    second: Nine<S::T>,
    force: Three<S::T>,
    moment: Three<S::T>,
}

impl<S: Space> Carriage<S> {
    /// From the motion of the node.
    #[inline]
    pub(crate) fn new(mech: &Mechanism<S>, body: &Deforming<S>, x: &[NodeState<S>]) -> Self {
        let node = &x[body.node];
        let frame = node.frame(&body.frame);
        let a = node.at(frame.origin).1 - mech.gravity;
        let turning = |w: S::Angular| S::spread_angular(S::rotate_angular_back(&frame.rotation, w));
        let inertia = &body.data.inertia;
        Self {
            a: S::spread(S::rotate_back(&frame.rotation, a)),
            w: turning(node.w),
            wd: turning(node.wd),
            rotation: frame.rotation,
            arm: frame.origin - node.p,
            first: inertia.first,
            second: inertia.second,
            force: [S::T::zero(); 3],
            moment: [S::T::zero(); 3],
        }
    }

    /// What the motion asks along coordinate `e`; its part in the wrench is kept.
    #[inline]
    pub(crate) fn take(&mut self, body: &Deforming<S>, x: &[NodeState<S>], e: usize) -> S::T {
        let (n, inertia) = (body.count(), &body.data.inertia);
        let zero = S::T::zero();
        let (mut h, mut p, mut pushed) = (inertia.placed[e], [[zero; 3]; 3], zero);
        for l in 0..n {
            let [d, rate, second] = body.motion(x, l);
            add(&mut h, &inertia.products[l * n + e], d);
            add(&mut p, &inertia.products[l * n + e], rate);
            pushed += body.mass[l * n + e] * second;
        }
        self.keep(&inertia.flow[e], &inertia.placed[e], &h, body.motion(x, e));
        let two = S::T::from_f64(2.0);
        let spin = dot(&self.w, &times(&h, &self.w)) - dot(&self.w, &self.w) * trace(&h);
        let carried = dot(&inertia.flow[e], &self.a) + dot(&self.wd, &axial(&h));
        carried + spin + two * dot(&self.w, &axial(&p)) + pushed
    }

    /// Adds what coordinate `e` has in the sums.
    #[inline]
    fn keep(&mut self, flow: &Three<S::T>, placed: &Nine<S::T>, h: &Nine<S::T>, [d, rate, second]: Three<S::T>) {
        let two = S::T::from_f64(2.0);
        let (turned, along, ax) = (times_back(h, &self.w), trace(h), axial(h));
        let swung = cross(&self.w, flow);
        for i in 0..3 {
            self.first[i] += flow[i] * d;
            for k in 0..3 {
                self.second[i][k] += (placed[k][i] + h[i][k]) * d;
            }
            self.force[i] += two * rate * swung[i] + second * flow[i];
            self.moment[i] += two * rate * (along * self.w[i] - turned[i]) + second * ax[i];
        }
    }

    /// Force and moment about the node's origin that the motion asks of the node, after every coordinate was taken.
    #[inline]
    pub(crate) fn demand(&self, body: &Deforming<S>) -> (S::Vector, S::Angular) {
        let mass = body.data.inertia.mass;
        let spun = self.inertia_times(&self.w);
        let (swung, turned) = (cross(&self.wd, &self.first), cross(&self.w, &cross(&self.w, &self.first)));
        let (lifted, driven, whirled) =
            (cross(&self.first, &self.a), self.inertia_times(&self.wd), cross(&self.w, &spun));
        let force = std::array::from_fn(|i| mass * self.a[i] + swung[i] + turned[i] + self.force[i]);
        let moment = std::array::from_fn(|i| lifted[i] + driven[i] + whirled[i] + self.moment[i]);
        self.to_world(&force, &moment)
    }

    fn to_world(&self, force: &Three<S::T>, moment: &Three<S::T>) -> (S::Vector, S::Angular) {
        let f = S::rotate(&self.rotation, S::vector(force));
        (f, S::rotate_angular(&self.rotation, S::angular(moment)) + S::moment(self.arm, f))
    }

    /// `(tr(J) 1 − J) w`.
    #[inline]
    fn inertia_times(&self, w: &Three<S::T>) -> Three<S::T> {
        let (all, image) = (trace(&self.second), times(&self.second, w));
        std::array::from_fn(|i| all * w[i] - image[i])
    }
}

impl<S: Space> Deforming<S> {
    /// Force and moment about the node's origin that a unit acceleration of coordinate `e` asks of the node.
    #[inline]
    pub(crate) fn push(&self, x: &[NodeState<S>], e: usize) -> (S::Vector, S::Angular) {
        let node = &x[self.node];
        let frame = node.frame(&self.frame);
        let f = S::rotate(&frame.rotation, S::vector(&self.data.inertia.flow[e]));
        let n = S::rotate_angular(&frame.rotation, S::angular(&axial(&self.placed(x, e))));
        (f, n + S::moment(frame.origin - node.p, f))
    }

    /// First moment (kg·m) about the frame's origin and inertia tensor (kg·m²) there, body axes, deformed as it is.
    pub(crate) fn rigid(&self, x: &[NodeState<S>]) -> (Three<S::T>, Nine<S::T>) {
        let inertia = &self.data.inertia;
        let (mut first, mut second) = (inertia.first, inertia.second);
        for e in 0..self.count() {
            let (d, h) = (self.motion(x, e)[0], self.placed(x, e));
            for i in 0..3 {
                first[i] += inertia.flow[e][i] * d;
                for k in 0..3 {
                    second[i][k] += (inertia.placed[e][k][i] + h[i][k]) * d;
                }
            }
        }
        let all = trace(&second);
        let entry = |i: usize, k: usize| if i == k { all - second[i][k] } else { -second[i][k] };
        (first, std::array::from_fn(|i| std::array::from_fn(|k| entry(i, k))))
    }

    /// `∫ r dm`, `∫ u̇ dm` and `∫ ü dm` in body axes, kg·m and its rates.
    pub(crate) fn flowed(&self, x: &[NodeState<S>]) -> [Three<S::T>; 3] {
        let mut sums = [self.data.inertia.first, [S::T::zero(); 3], [S::T::zero(); 3]];
        for e in 0..self.count() {
            for (sum, motion) in sums.iter_mut().zip(self.motion(x, e)) {
                (0..3).for_each(|i| sum[i] += self.data.inertia.flow[e][i] * motion);
            }
        }
        sums
    }

    /// Kinetic energy, J.
    pub(crate) fn kinetic(&self, x: &[NodeState<S>]) -> S::T {
        let n = self.count();
        let node = &x[self.node];
        let frame = node.frame(&self.frame);
        let v = S::spread(S::rotate_back(&frame.rotation, node.at(frame.origin).0));
        let w = S::spread_angular(S::rotate_angular_back(&frame.rotation, node.w));
        let (first, tensor) = self.rigid(x);
        let mut twice = self.data.inertia.mass * dot(&v, &v) + dot(&w, &times(&tensor, &w));
        let two = S::T::from_f64(2.0);
        twice += two * dot(&v, &cross(&w, &first));
        for e in 0..n {
            let rate = self.motion(x, e)[1];
            let carried = dot(&self.data.inertia.flow[e], &v) + dot(&w, &axial(&self.placed(x, e)));
            let own = (0..n).fold(S::T::zero(), |sum, l| sum + self.mass[l * n + e] * self.motion(x, l)[1]);
            twice += rate * (two * carried + own);
        }
        twice * S::T::from_f64(0.5)
    }
}

/// Adds the demands of flexible bodies to those of the nodes.
#[inline]
pub(crate) fn add_demands<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>]) {
    for body in &mech.flexible {
        let mut carriage = Carriage::new(mech, body, x);
        for e in 0..body.count() {
            x[body.nodes[e]].own_t = carriage.take(body, x, e);
        }
        let (f, n) = carriage.demand(body);
        x[body.node].own_f += f;
        x[body.node].own_n += n;
    }
}

/// Projections of a wrench about a node's origin on the motions that the node hangs on, its own first: velocity
/// component and value.
#[inline]
pub(crate) fn each_projection<S: Space>(
    mech: &Mechanism<S>,
    x: &[NodeState<S>],
    node: usize,
    (f, mut n): (S::Vector, S::Angular),
    mut put: impl FnMut(usize, S::T),
) {
    let mut at = node;
    while at != 0 {
        let (here, up) = (&mech.nodes[at], &x[at]);
        match here.motion {
            Motion::Fixed => {}
            Motion::Turn => put(here.v, up.s_w.dot(n)),
            Motion::Slide => put(here.v, up.s_v.dot(f)),
            Motion::Screw(_) => put(here.v, up.s_v.dot(f) + up.s_w.dot(n)),
            Motion::Ball => (0..3).for_each(|k| put(here.v + k, crate::mass_matrix::ball_axis(up, k).dot(n))),
        }
        n += S::moment(up.r, f);
        at = here.parent;
    }
}

#[inline(always)]
fn dot<T: Real>(a: &Three<T>, b: &Three<T>) -> T {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[inline(always)]
fn cross<T: Real>(a: &Three<T>, b: &Three<T>) -> Three<T> {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

/// `∫ a×b` of `∫ a bᵀ`.
#[inline(always)]
fn axial<T: Real>(h: &Nine<T>) -> Three<T> {
    [h[1][2] - h[2][1], h[2][0] - h[0][2], h[0][1] - h[1][0]]
}

#[inline(always)]
fn trace<T: Real>(h: &Nine<T>) -> T {
    h[0][0] + h[1][1] + h[2][2]
}

#[inline(always)]
fn times<T: Real>(h: &Nine<T>, w: &Three<T>) -> Three<T> {
    h.map(|row| dot(&row, w))
}

/// `hᵀ w`.
#[inline(always)]
fn times_back<T: Real>(h: &Nine<T>, w: &Three<T>) -> Three<T> {
    std::array::from_fn(|i| h[0][i] * w[0] + h[1][i] * w[1] + h[2][i] * w[2])
}
