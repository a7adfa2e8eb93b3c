//! Inverse dynamics and mass matrix of the tree alone, by recursions in each node's own axes.
//!
//! Recursive Newton–Euler (Featherstone 2008 §5.3) and composite rigid bodies (§6.2) for given positions, velocities
//! and accelerations. In the nodes' axes the inertias are constants and a motion's axis is a unit vector: this costs
//! half of what the passes in world axes do, which the loops need. Vectors are classical (acceleration of the node's
//! origin, not spatial acceleration); gravity is an acceleration of the ground upward.

use crate::mass_matrix::MassMatrix;
use crate::mechanism::{Mechanism, Node};
use crate::solver::Machine;
use crate::topology::Motion;
use crate::workspace::NodeState;
use crate::{dynamics, kinematics};
use bellcrank_math::{Real, Space};

#[cfg(test)]
mod tests;

/// What does not change of a node.
#[derive(Clone, Copy, Debug)]
struct Link<S: Space> {
    parent: usize,
    motion: Motion<S::T>,
    sign: S::T,
    q: usize,
    v: usize,
    /// Orientation and origin before the motion, in the parent's axes.
    rotation: S::Rotation,
    origin: S::Vector,
    carried: Rigid<S>,
}

/// Mass, first moment and inertia about the node's origin, in its axes: of a node, or of all that it carries.
#[derive(Clone, Copy, Debug)]
struct Rigid<S: Space> {
    /// kg.
    mass: S::T,
    /// Mass times place of the centre, kg·m.
    first: S::Vector,
    /// kg·m².
    second: S::Inertia,
}

/// Orientation and origin of a node in its parent's axes.
#[derive(Clone, Copy, Debug)]
struct Pose<S: Space> {
    R: S::Rotation,
    r: S::Vector,
    /// Turn of a ball alone: its velocity components are along the axes before it.
    ball: S::Rotation,
}

/// What is computed of a node, in its axes.
#[derive(Clone, Copy, Debug)]
struct Motional<S: Space> {
    w: S::Angular,
    wd: S::Angular,
    vd: S::Vector,
    f: S::Vector,
    n: S::Angular,
}

/// The recursions with their workspace; nothing is allocated after [`Recursions::new`].
#[derive(Clone, Debug)]
pub(crate) struct Recursions<S: Space> {
    links: Vec<Link<S>>,
    poses: Vec<Pose<S>>,
    x: Vec<Motional<S>>,
    composite: Vec<Rigid<S>>,
    /// Velocity components.
    nv: usize,
}

impl<S: Space> Recursions<S> {
    pub(crate) fn new(mech: &Mechanism<S>) -> Self {
        let links: Vec<Link<S>> = mech.nodes.iter().map(Link::of).collect();
        let mut rest = Motional::at_rest();
        // The ground's acceleration stays what it is: gravity.
        rest.vd = -mech.gravity;
        let composite = links.iter().map(|l| l.carried).collect();
        let poses = vec![Pose { R: S::identity(), r: S::Vector::default(), ball: S::identity() }; links.len()];
        Self { poses, x: vec![rest; links.len()], links, composite, nv: mech.nv }
    }

    /// Generalized forces `tau` (nv; N, N·m) that give the tree the accelerations `a` at `q` and `v`, weights counted.
    pub(crate) fn inverse_dynamics(&mut self, q: &[S::T], v: &[S::T], a: &[S::T], tau: &mut [S::T]) {
        for (i, (link, pose)) in self.links.iter().zip(&mut self.poses).enumerate().skip(1) {
            let (before, rest) = self.x.split_at_mut(i);
            pose.set(link, q);
            rest[0].follow(link, pose, &before[link.parent], v, a);
            rest[0].demand(&link.carried);
        }
        for (i, (link, pose)) in self.links.iter().zip(&self.poses).enumerate().skip(1).rev() {
            let (before, rest) = self.x.split_at_mut(i);
            let x = &rest[0];
            pose.each_projection(link, x.f, x.n, |k, value| tau[link.v + k] = value);
            if link.parent != 0 {
                let parent = &mut before[link.parent];
                let (f, n) = pose.carry(x.f, x.n);
                parent.f += f;
                parent.n += n;
            }
        }
    }

    /// The mass matrix `m` (nv × nv, symmetric; kg, kg·m, kg·m²) at `q`.
    pub(crate) fn mass_matrix(&mut self, q: &[S::T], m: &mut [S::T]) {
        m.fill(S::T::zero());
        for ((link, pose), c) in self.links.iter().zip(&mut self.poses).zip(&mut self.composite).skip(1) {
            pose.set(link, q);
            *c = link.carried;
        }
        for i in (1..self.links.len()).rev() {
            let (link, pose, (before, rest)) = (&self.links[i], &self.poses[i], self.composite.split_at_mut(i));
            if link.parent != 0 {
                before[link.parent].join(&rest[0].seen_from(pose));
            }
            for axis in 0..link.motion.dofs() {
                self.column(i, axis, m);
            }
        }
    }

    /// One velocity component with itself and with those that it hangs on.
    #[inline(always)]
    fn column(&self, i: usize, axis: usize, m: &mut [S::T]) {
        let (link, nv) = (&self.links[i], self.nv);
        let (mut f, mut n) = self.composite[i].push(link, &self.poses[i], axis);
        let column = link.v + axis;
        let (mut at, mut pose) = (link, &self.poses[i]);
        loop {
            pose.each_projection(at, f, n, |k, value| {
                m[column * nv + at.v + k] = value;
                m[(at.v + k) * nv + column] = value;
            });
            if at.parent == 0 {
                return;
            }
            (f, n) = pose.carry(f, n);
            (at, pose) = (&self.links[at.parent], &self.poses[at.parent]);
        }
    }
}

impl<S: Space> Link<S> {
    fn of(node: &Node<S>) -> Self {
        let carried = match &node.inertia {
            None => Rigid { mass: S::T::zero(), first: S::Vector::default(), second: S::Inertia::default() },
            Some(body) => {
                let about_origin = S::moved_inertia(body.mass, S::Vector::default(), body.center);
                let second = S::add_inertia(&body.about_center, &about_origin);
                Rigid { mass: body.mass, first: body.center * body.mass, second }
            }
        };
        Self {
            parent: node.parent,
            motion: node.motion,
            sign: node.sign,
            q: node.q,
            v: node.v,
            rotation: node.place.rotation,
            origin: node.place.origin,
            carried,
        }
    }
}

impl<S: Space> Pose<S> {
    #[inline(always)]
    fn set(&mut self, link: &Link<S>, q: &[S::T]) {
        self.r = link.origin;
        match link.motion {
            Motion::Turn => self.R = S::turn(&link.rotation, (link.sign * q[link.q]).sin_cos()),
            Motion::Slide => {
                self.R = link.rotation;
                self.r += S::slide_axis(&link.rotation) * (link.sign * q[link.q]);
            }
            Motion::Screw(lead) => {
                self.R = S::turn(&link.rotation, (link.sign * q[link.q]).sin_cos());
                self.r += S::slide_axis(&link.rotation) * (link.sign * lead * q[link.q]);
            }
            Motion::Fixed => self.R = link.rotation,
            Motion::Ball => {
                let quaternion = [q[link.q], q[link.q + 1], q[link.q + 2], q[link.q + 3]];
                self.ball = S::from_quaternion(&quaternion);
                self.R = S::compose(&link.rotation, &self.ball);
            }
        }
    }

    /// A wrench about the node's origin in the axes and about the origin of the parent.
    #[inline(always)]
    fn carry(&self, f: S::Vector, n: S::Angular) -> (S::Vector, S::Angular) {
        let f = S::rotate(&self.R, f);
        (f, S::rotate_angular(&self.R, n) + S::moment(self.r, f))
    }

    /// A wrench about the origin along the axes of the node's motion.
    #[inline(always)]
    fn each_projection(&self, link: &Link<S>, f: S::Vector, n: S::Angular, mut put: impl FnMut(usize, S::T)) {
        match link.motion {
            Motion::Fixed => {}
            Motion::Turn => put(0, link.sign * S::along_turn(n)),
            Motion::Slide => put(0, link.sign * f[S::SLIDE]),
            Motion::Screw(lead) => put(0, link.sign * (S::along_turn(n) + f[S::SLIDE] * lead)),
            Motion::Ball => {
                let n = S::spread_angular(S::rotate_angular(&self.ball, n));
                n.into_iter().enumerate().for_each(|(k, value)| put(k, value));
            }
        }
    }
}

/// Three components of a ball's velocity.
#[inline(always)]
fn three<S: Space>(v: &[S::T], at: usize) -> S::Angular {
    S::angular(&[v[at], v[at + 1], v[at + 2]])
}

impl<S: Space> Motional<S> {
    fn at_rest() -> Self {
        let (o, w) = (S::Vector::default(), S::Angular::default());
        Self { w, wd: w, vd: o, f: o, n: w }
    }

    /// Angular velocity and accelerations from the parent's and those of the motion between.
    #[inline(always)]
    fn follow(&mut self, link: &Link<S>, pose: &Pose<S>, parent: &Self, v: &[S::T], a: &[S::T]) {
        let wr = S::cross(parent.w, pose.r);
        let w = S::rotate_angular_back(&pose.R, parent.w);
        let mut wd = S::rotate_angular_back(&pose.R, parent.wd);
        let mut vd = S::rotate_back(&pose.R, parent.vd + S::cross(parent.wd, pose.r) + S::cross(parent.w, wr));
        let (rate, change) = match link.motion {
            Motion::Turn | Motion::Slide | Motion::Screw(_) => (link.sign * v[link.v], link.sign * a[link.v]),
            Motion::Fixed | Motion::Ball => (S::T::zero(), S::T::zero()),
        };
        self.w = w;
        if matches!(link.motion, Motion::Turn | Motion::Screw(_)) {
            S::add_along_turn(&mut self.w, rate);
            wd += S::cross_turn(w, rate);
            S::add_along_turn(&mut wd, change);
        }
        let advance = match link.motion {
            Motion::Slide => Some(S::T::one()),
            Motion::Screw(lead) => Some(lead),
            _ => None,
        };
        if let Some(lead) = advance {
            let s = S::slide_axis(&S::identity()) * lead;
            vd += S::cross(w, s) * (rate + rate) + s * change;
        }
        if matches!(link.motion, Motion::Ball) {
            let spin = S::rotate_angular_back(&pose.ball, three::<S>(v, link.v));
            self.w += spin;
            wd += S::cross_angular(w, spin) + S::rotate_angular_back(&pose.ball, three::<S>(a, link.v));
        }
        (self.wd, self.vd) = (wd, vd);
    }

    /// Force and moment about the origin that the node's own mass asks for.
    #[inline(always)]
    fn demand(&mut self, body: &Rigid<S>) {
        let wh = S::cross(self.w, body.first);
        self.f = self.vd * body.mass + S::cross(self.wd, body.first) + S::cross(self.w, wh);
        let turning = S::inertia_times(&body.second, self.w);
        self.n = S::inertia_times(&body.second, self.wd)
            + S::cross_angular(self.w, turning)
            + S::moment(body.first, self.vd);
    }
}

impl<S: Space> Rigid<S> {
    /// Force and moment about the origin that give the body the unit acceleration of the motion's component `axis`
    /// from rest.
    #[inline(always)]
    fn push(&self, link: &Link<S>, pose: &Pose<S>, axis: usize) -> (S::Vector, S::Angular) {
        match link.motion {
            Motion::Fixed => (S::Vector::default(), S::Angular::default()),
            Motion::Turn => (S::turn_cross(link.sign, self.first), S::inertia_turn(&self.second, link.sign)),
            Motion::Slide => self.push_along(link.sign),
            Motion::Screw(lead) => {
                let (f, n) = self.push_along(link.sign * lead);
                let (turning, turned) =
                    (S::turn_cross(link.sign, self.first), S::inertia_turn(&self.second, link.sign));
                (f + turning, n + turned)
            }
            Motion::Ball => {
                let mut e = [S::T::zero(); 3];
                e[axis] = S::T::one();
                let s = S::rotate_angular_back(&pose.ball, S::angular(&e));
                (S::cross(s, self.first), S::inertia_times(&self.second, s))
            }
        }
    }

    /// The same for an acceleration along the slide's axis.
    #[inline(always)]
    fn push_along(&self, k: S::T) -> (S::Vector, S::Angular) {
        let mut s = S::Vector::default();
        s[S::SLIDE] = k;
        (s * self.mass, S::moment(self.first, s))
    }

    /// The same body in the axes and about the origin of the parent.
    #[inline(always)]
    fn seen_from(&self, pose: &Pose<S>) -> Self {
        let first = S::rotate(&pose.R, self.first);
        let turned = S::turn_inertia(&self.second, &pose.R);
        let second = S::add_inertia(&turned, &S::moved_inertia(self.mass, first, pose.r));
        Self { mass: self.mass, first: first + pose.r * self.mass, second }
    }

    #[inline(always)]
    fn join(&mut self, o: &Self) {
        self.mass += o.mass;
        self.first += o.first;
        self.second = S::add_inertia(&self.second, &o.second);
    }
}

/// The tree alone: the joints that close loops, and all force elements, are left out. Positions `q` are as many as
/// [`Machine::sizes`] tells, in m, rad and unit quaternions (w, x, y, z); velocity components are m/s and rad/s, those
/// of a ball along the axes before its turn. Nodes come in the order in which the spanning tree was grown: of an open
/// chain that of its joints.
impl<S: Space<T = f64>> Machine<S> {
    /// Numbers of a position and of a velocity of the tree.
    pub fn sizes(&self) -> (usize, usize) {
        (self.mech.nq, self.mech.nv)
    }

    /// Generalized forces `tau` (nv; N, N·m) along the tree's velocity components that give it the accelerations `a`
    /// (nv) at positions `q` (nq) and velocities `v` (nv), weights counted: `M(q) a + h(q, v)`.
    ///
    /// Recursive Newton–Euler, Featherstone (2008) §5.3. The machine's own position does not change; the first call
    /// allocates, later ones do not.
    ///
    /// # Panics
    /// Where a slice is shorter than it has to be.
    pub fn inverse_dynamics(&mut self, q: &[f64], v: &[f64], a: &[f64], tau: &mut [f64]) {
        if self.mech.flexible.is_empty() {
            self.recursions().inverse_dynamics(q, v, a, tau);
        } else {
            self.inverse_dynamics_in_world(q, v, a, tau);
        }
    }

    /// Mass matrix `m` (nv × nv, symmetric; kg, kg·m, kg·m²) over the tree's velocity components at `q` (nq): twice
    /// the kinetic energy is `vᵀ M v`.
    ///
    /// Composite rigid bodies, Featherstone (2008) §6.2. As [`Machine::inverse_dynamics`] otherwise.
    ///
    /// # Panics
    /// Where a slice is shorter than it has to be.
    pub fn mass_matrix(&mut self, q: &[f64], m: &mut [f64]) {
        if self.mech.flexible.is_empty() {
            self.recursions().mass_matrix(q, m);
        } else {
            self.masses_in_world(q, m);
        }
    }

    /// The same with flexible bodies, which only the passes in world axes know; elastic forces are not counted.
    fn inverse_dynamics_in_world(&self, q: &[f64], v: &[f64], a: &[f64], tau: &mut [f64]) {
        let mut x = vec![NodeState::default(); self.mech.nodes.len()];
        kinematics::positions(&self.mech, q, &mut x);
        kinematics::velocities(&self.mech, v, &mut x);
        kinematics::accelerations(&self.mech, v, Some(a), &mut x);
        dynamics::own_wrenches(&self.mech, &mut x);
        x.iter_mut().for_each(|x| (x.f, x.n) = (x.own_f, x.own_n));
        dynamics::gather(&self.mech, &mut x);
        dynamics::project(&self.mech, &x, tau);
    }

    fn masses_in_world(&self, q: &[f64], m: &mut [f64]) {
        let mut x = vec![NodeState::default(); self.mech.nodes.len()];
        kinematics::positions(&self.mech, q, &mut x);
        let mut masses = MassMatrix::new(&self.mech);
        masses.evaluate(&self.mech, &x);
        m.fill(0.0);
        let nv = self.mech.nv;
        for (&(i, j), value) in masses.entries.iter().zip(&masses.values) {
            m[i * nv + j] += value;
            if i != j {
                m[j * nv + i] += value;
            }
        }
    }

    fn recursions(&mut self) -> &mut Recursions<S> {
        self.recursions.get_or_insert_with(|| Box::new(Recursions::new(&self.mech)))
    }
}
