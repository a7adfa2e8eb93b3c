//! What is computed at one position, a slot a node. World axes; references at the node's origin.

use bellcrank_math::{Frame, Real, Space};

/// Kinematic and force quantities of one node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct NodeState<S: Space> {
    /// `R_WN`.
    pub(crate) R: S::Rotation,
    /// Orientation before the motion, kept for balls: their velocity components are along its axes.
    pub(crate) base: S::Rotation,
    /// `p_WN`, m.
    pub(crate) p: S::Vector,
    /// From the parent's origin, m.
    pub(crate) r: S::Vector,
    /// Motion axis: angular and linear velocity a unit rate.
    pub(crate) s_w: S::Angular,
    pub(crate) s_v: S::Vector,
    /// Angular velocity, rad/s, and velocity of the origin, m/s.
    pub(crate) w: S::Angular,
    pub(crate) v: S::Vector,
    /// Angular acceleration, rad/s², and acceleration of the origin, m/s².
    pub(crate) wd: S::Angular,
    pub(crate) vd: S::Vector,
    /// Applied force, N, and moment about the origin, N·m.
    pub(crate) ext_f: S::Vector,
    pub(crate) ext_n: S::Angular,
    /// What the parent puts on this node's subtree, about the origin: N and N·m.
    pub(crate) f: S::Vector,
    pub(crate) n: S::Angular,
    /// Inertia less applied wrench of this node alone.
    pub(crate) own_f: S::Vector,
    pub(crate) own_n: S::Angular,
    /// Of a flexible body's coordinate: its value, rate and second rate, second-order displacement, and what inertia
    /// asks along it beside the wrenches. Zero of other nodes.
    pub(crate) deform: [S::T; 3],
    pub(crate) shortening: S::T,
    pub(crate) own_t: S::T,
}

impl<S: Space> Default for NodeState<S> {
    fn default() -> Self {
        let (o, a) = (S::Vector::default(), S::Angular::default());
        let I = S::identity();
        Self {
            R: I,
            base: I,
            p: o,
            r: o,
            s_w: a,
            s_v: o,
            w: a,
            v: o,
            wd: a,
            vd: o,
            ext_f: o,
            ext_n: a,
            f: o,
            n: a,
            own_f: o,
            own_n: a,
            deform: [S::T::zero(); 3],
            shortening: S::T::zero(),
            own_t: S::T::zero(),
        }
    }
}

impl<S: Space> NodeState<S> {
    /// Velocity and acceleration of the point of this node that is now at `p_W`.
    #[inline]
    pub(crate) fn at(&self, p_W: S::Vector) -> (S::Vector, S::Vector) {
        let r = p_W - self.p;
        let wr = S::cross(self.w, r);
        (self.v + wr, self.vd + S::cross(self.wd, r) + S::cross(self.w, wr))
    }
    /// Adds an applied force at a world point and a free moment.
    #[inline]
    pub(crate) fn apply(&mut self, p_W: S::Vector, f: S::Vector, n: S::Angular) {
        self.ext_f += f;
        self.ext_n += n + S::moment(p_W - self.p, f);
    }
    /// Pose of a frame fixed on this node.
    pub(crate) fn frame(&self, inner: &Frame<S>) -> Frame<S> {
        Frame { rotation: self.R, origin: self.p }.then(inner)
    }
}
