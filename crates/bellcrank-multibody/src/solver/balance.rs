//! The inward pass with the wrenches of loops, couplings, drives and friction, over any scalar.

use super::unknowns::Prescribed;
use crate::attitude::spin_of_rpy;
use crate::constraint::Measure;
use crate::dynamics;
use crate::forces::{Element, Friction, Output};
use crate::mechanism::{Mechanism, Source};
use crate::workspace::NodeState;
use bellcrank_math::{Components, Real, Space, rpy_from_matrix};

/// Everything that acts at a position, and where the joint wrenches go.
pub(crate) struct Balance<'a, S: Space> {
    pub(crate) mech: &'a Mechanism<S>,
    pub(crate) x: &'a mut [NodeState<S>],
    /// Wrench of each link row at the link's P₂, and P₂ of each closing link.
    pub(crate) row_wrench: &'a [(S::Vector, S::Angular)],
    pub(crate) p2: &'a [S::Vector],
    pub(crate) lambda: &'a [S::T],
    pub(crate) friction: &'a [S::T],
    pub(crate) outputs: &'a [Output<S>],
    pub(crate) prescribed: &'a [Prescribed],
    /// Wrench of every joint on its second body about P₂.
    pub(crate) wrench: &'a mut [(S::Vector, S::Angular)],
}

/// Which demands a pass starts from.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Demands {
    /// Inertia, weights, applied forces, friction.
    All,
    /// None: the answer to the multipliers alone.
    None,
}

impl<S: Space> Balance<'_, S> {
    /// Sums of own demands and of friction on measured coordinates.
    pub(crate) fn gather_own(&mut self) {
        start_from_own(self.x);
        self.add_measured_friction();
        dynamics::gather(self.mech, self.x);
    }

    /// The inward pass with the wrenches of loops, couplings and measured drives applied.
    pub(crate) fn gather_with_loops(&mut self, demands: Demands) {
        self.start(demands);
        self.apply_loops();
        for i in 0..self.measured_efforts_count() {
            if let Some((Source::Measured { link, measure }, effort)) = self.measured_effort(i) {
                demand_pair(self.mech, self.x, link, measure, effort);
            }
        }
        dynamics::gather(self.mech, self.x);
    }

    /// Generalized forces that are left (nv): own demands less everything that loops, couplings, measured drives
    /// and friction put against them, `τ − Jᵀλ`. Zero along the free coordinates of a solved position.
    pub(crate) fn residual(&mut self, efforts: &[S::T], left: &mut [S::T]) {
        start_from_own(self.x);
        self.apply_loops();
        self.each_effort(|passes, source, effort| {
            if let Source::Measured { link, measure } = source {
                take_off_pair(passes.mech, passes.x, link, measure, effort);
            }
        });
        dynamics::gather(self.mech, self.x);
        dynamics::project(self.mech, self.x, left);
        left.iter_mut().zip(efforts).for_each(|(l, e)| *l -= *e);
        self.each_effort(|passes, source, effort| {
            if let Source::Node(n) = source {
                left[passes.mech.nodes[n].v] -= effort;
            }
        });
    }

    /// Every effort of a coupling, a measured drive or friction, in joints of the tree or not.
    fn each_effort(&mut self, mut act: impl FnMut(&mut Self, Source, S::T)) {
        for i in 0..self.measured_efforts_count() {
            if let Some((source, effort)) = self.measured_effort(i) {
                act(self, source, effort);
            }
        }
        for i in 0..self.mech.elements.len() {
            if let Element::Friction(Friction { source, .. }) = &self.mech.elements[i] {
                act(self, *source, self.friction[i]);
            }
        }
    }

    fn start(&mut self, demands: Demands) {
        if demands == Demands::All {
            start_from_own(self.x);
            self.add_measured_friction();
        } else {
            for x in self.x.iter_mut() {
                (x.f, x.n) = (S::Vector::default(), S::Angular::default());
            }
        }
    }

    fn apply_loops(&mut self) {
        for (c, &k) in self.mech.closing.iter().enumerate() {
            let (f, n) = self.link_wrench(c);
            let link = &self.mech.links[k];
            take_off(&mut self.x[link.ends[1].0], self.p2[c], f, n);
            take_off(&mut self.x[link.ends[0].0], self.p2[c], -f, -n);
        }
    }

    fn add_measured_friction(&mut self) {
        for (element, e) in self.mech.elements.iter().zip(self.friction) {
            if let Element::Friction(Friction { source: Source::Measured { link, measure }, .. }) = element {
                demand_pair(self.mech, self.x, *link, *measure, *e);
            }
        }
    }

    /// `Σ λ (f, n)` of closing link `c` at its P₂.
    fn link_wrench(&self, c: usize) -> (S::Vector, S::Angular) {
        let link = &self.mech.links[self.mech.closing[c]];
        let mut sum = (S::Vector::default(), S::Angular::default());
        for r in link.first_row..link.first_row + link.rows.len() {
            let (f, n) = self.row_wrench[r];
            sum.0 += f * self.lambda[r];
            sum.1 += n * self.lambda[r];
        }
        sum
    }

    /// Efforts of couplings and of prescribed rows, two a coupling and one a row: coordinate and effort.
    fn measured_effort(&self, i: usize) -> Option<(Source, S::T)> {
        if let Some(c) = self.mech.couplings.get(i / 2) {
            let l = self.lambda[self.mech.link_rows + i / 2];
            return Some(if i.is_multiple_of(2) { (c.b, l) } else { (c.a, -(c.ratio * l)) });
        }
        match self.prescribed[i - 2 * self.mech.couplings.len()] {
            Prescribed::Row(row, source) => Some((source, self.lambda[row])),
            Prescribed::Node(_) => None,
        }
    }

    fn measured_efforts_count(&self) -> usize {
        2 * self.mech.couplings.len() + self.prescribed.len()
    }

    /// Wrench of every joint on its second body about P₂, after [`Balance::gather_with_loops`].
    pub(crate) fn collect_wrenches(&mut self) {
        for j in 0..self.wrench.len() {
            self.wrench[j] = self.tree_wrench(j);
        }
        for c in 0..self.mech.closing.len() {
            let joint = self.mech.links[self.mech.closing[c]].joint;
            self.wrench[joint.0] = self.link_wrench(c);
        }
        for i in 0..self.measured_efforts_count() {
            if let Some((source, effort)) = self.measured_effort(i) {
                self.add_effort_wrench(source, effort);
            }
        }
        for i in 0..self.mech.elements.len() {
            let (source, effort) = match &self.mech.elements[i] {
                Element::Effort { source, .. } | Element::JointSpring { source, .. } | Element::Stop { source, .. } => {
                    (*source, self.outputs[i].effort)
                }
                Element::Friction(f) => (f.source, self.friction[i]),
                _ => continue,
            };
            self.add_effort_wrench(source, effort);
        }
    }

    fn add_effort_wrench(&mut self, source: Source, effort: S::T) {
        let Source::Measured { link, measure } = source else { return };
        let link = &self.mech.links[link];
        // A tree joint's wrench comes from the inward pass, whole.
        if self.mech.tree_joint[link.joint.0].is_none() {
            let g = link.measure(measure, &link.pose(self.x));
            self.wrench[link.joint.0].0 += g.f * effort;
            self.wrench[link.joint.0].1 += g.n * effort;
        }
    }

    fn tree_wrench(&self, j: usize) -> (S::Vector, S::Angular) {
        let (Some(tree), Some(link)) = (self.mech.tree_joint[j], self.mech.link_of[j]) else {
            return (S::Vector::default(), S::Angular::default());
        };
        let x = &self.x[tree.last];
        let p2 = self.mech.links[link].points(self.x)[1];
        let n = x.n + S::moment(x.p - p2, x.f);
        if tree.reversed { (-x.f, -n) } else { (x.f, n) }
    }

    /// Reaction across the axis of a joint: what presses its surfaces together.
    pub(crate) fn normal_force(&self, f: &Friction<S::T>) -> S::T {
        let j = f.coordinate.joint.0;
        let force = self.wrench[j].0;
        let Some(link) = self.mech.link_of[j] else { return S::T::zero() };
        let link = &self.mech.links[link];
        let pose = link.pose(self.x);
        let axis = match f.along {
            Measure::Slide(i) => S::column(&pose.R[0], i),
            Measure::Turn(_) | Measure::Thread | Measure::Fork if S::DIM == 3 => S::column(&pose.R[0], 2),
            Measure::Yoke => S::column(&pose.R[1], 0),
            _ => S::Vector::default(),
        };
        let across = force - axis * force.dot(axis);
        let square = across.dot(across);
        // No force, no direction: the root has no derivative there.
        if square.value() > 0.0 { square.sqrt() } else { S::T::zero() }
    }
}

/// The multipliers of an attitude are moments about the first frame's axes; the efforts along roll, pitch
/// and yaw are their projections: `u = Eᵀ n` with `ω = E [roll̇, pitcḣ, yaẇ]`.
pub(crate) fn turn_attitude_drives<S: Space>(
    mech: &Mechanism<S>,
    x: &[NodeState<S>],
    prescribed: &[Prescribed],
    drive: &mut [S::T],
) {
    for (k, p) in prescribed.iter().enumerate() {
        let Prescribed::Row(_, Source::Measured { link, measure: Measure::Attitude(0) }) = p else { continue };
        let rpy = rpy_from_matrix(&mech.links[*link].pose(x).relative());
        let n: [S::T; 3] = std::array::from_fn(|i| drive[k + i]);
        for i in 0..3 {
            let mut rate = [S::T::zero(); 3];
            rate[i] = S::T::one();
            let (w, _) = spin_of_rpy(&rpy, &rate, &[S::T::zero(); 3]);
            drive[k + i] = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
        }
    }
}

fn start_from_own<S: Space>(x: &mut [NodeState<S>]) {
    for x in x {
        (x.f, x.n) = (x.own_f, x.own_n);
    }
}

/// A wrench at `p_W` that is applied to a node lessens what the node asks of its parent.
#[inline]
fn take_off<S: Space>(x: &mut NodeState<S>, p_W: S::Vector, f: S::Vector, n: S::Angular) {
    x.f -= f;
    x.n -= n + S::moment(p_W - x.p, f);
}

/// An effort between the two ends of a link that closes a loop.
fn demand_pair<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>], link: usize, measure: Measure, effort: S::T) {
    // A drive of a tree joint acts inside the joint: the inward pass carries it already.
    if mech.tree_joint[mech.links[link].joint.0].is_none() {
        take_off_pair(mech, x, link, measure, effort);
    }
}

fn take_off_pair<S: Space>(mech: &Mechanism<S>, x: &mut [NodeState<S>], link: usize, measure: Measure, effort: S::T) {
    let link = &mech.links[link];
    let pose = link.pose(x);
    let g = link.measure(measure, &pose);
    take_off(&mut x[link.ends[1].0], pose.p[1], g.f * effort, g.n * effort);
    take_off(&mut x[link.ends[0].0], pose.p[1], -(g.f * effort), -(g.n * effort));
}
