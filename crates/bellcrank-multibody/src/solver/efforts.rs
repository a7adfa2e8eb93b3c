//! Drive efforts and reactions: `Jᵀ [λ; u] = τ`, then the inward pass with λ applied.

use super::machine::{Machine, Stage};
use super::system::{LinearSystem, Prescribed, SINGULAR};
use crate::attitude::spin_of_rpy;
use crate::constraint::Measure;
use crate::dynamics;
use crate::forces::{Element, Friction, Present, apply_all, friction_effort, read};
use crate::mechanism::Source;
use crate::workspace::NodeState;
use crate::{Engine, JointId, MechanismError, System};
use bellcrank_math::{Components, Space, rpy_from_matrix};

/// Friction is settled when no effort changes by more than this part of the largest.
const SETTLED: f64 = 1e-13;
/// Iterations before a joint is said to jam.
const MOST_ITERATIONS: usize = 400;

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn ask_inputs(&mut self, inputs: &mut dyn FnMut(&dyn Engine, &mut [f64])) -> Result<(), MechanismError> {
        if self.inputs.is_empty() {
            return Ok(());
        }
        let mut values = std::mem::take(&mut self.inputs);
        inputs(self, &mut values);
        let finite = values.iter().all(|x| x.is_finite());
        self.inputs = values;
        if finite { Ok(()) } else { Err(MechanismError::NotFinite("the value of a force")) }
    }

    pub(crate) fn solve_efforts(&mut self) -> Result<(), MechanismError> {
        self.need(Stage::Rates);
        let Some(mut prepared) = self.prepared.take() else {
            return Err(MechanismError::NotFinite("no actuation prepared"));
        };
        let result = match prepared.effort.as_mut() {
            Some(system) => {
                system.factor(&self.mech, &self.rows, &self.x);
                self.efforts_with(system)
            }
            None => self.efforts_with(prepared.rate.as_mut().unwrap_or(&mut prepared.position)),
        };
        self.prepared = Some(prepared);
        result
    }

    fn efforts_with(&mut self, system: &mut LinearSystem) -> Result<(), MechanismError> {
        if system.ratio < SINGULAR {
            let (singular_value, mobile) = self.weakest(system);
            self.void_forces();
            self.stage = Stage::Forces;
            return Err(MechanismError::Singular { system: System::Drive, singular_value, mobile });
        }
        self.apply_forces();
        dynamics::own_wrenches(&self.mech, &mut self.x);
        self.friction.fill(0.0);
        self.balance(system);
        if self.has_friction {
            self.settle_friction(system)?;
        }
        self.stage = Stage::Forces;
        Ok(())
    }

    pub(crate) fn apply_forces(&mut self) {
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        apply_all(&now, &mut self.x, &mut self.efforts, &mut self.outputs);
    }

    /// One solution of the balance with the present friction efforts.
    fn balance(&mut self, system: &mut LinearSystem) {
        self.gather_own();
        dynamics::project(&self.mech, &self.x, &mut self.tau);
        self.tau.iter_mut().zip(&self.efforts).for_each(|(t, e)| *t -= e);
        self.subtract_tree_friction();
        system.solve_transposed(&self.tau, &mut self.lambda);
        if system.nullity() > 0 {
            self.choose_least_norm(system);
        }
        self.read_drives(system);
        self.gather_with_loops(system, true);
        self.collect_wrenches(system);
    }

    /// Sums of own demands and of friction on measured coordinates.
    fn gather_own(&mut self) {
        start_from_own(&mut self.x);
        self.add_measured_friction();
        dynamics::gather(&self.mech, &mut self.x);
    }

    fn subtract_tree_friction(&mut self) {
        for (element, e) in self.mech.elements.iter().zip(&self.friction) {
            if let Element::Friction(Friction { source: Source::Node(n), .. }) = element {
                self.tau[self.mech.nodes[*n].v] -= e;
            }
        }
    }

    fn add_measured_friction(&mut self) {
        for (element, e) in self.mech.elements.iter().zip(&self.friction) {
            if let Element::Friction(Friction { source: Source::Measured { link, measure }, .. }) = element {
                demand_pair(&self.mech, &mut self.x, *link, *measure, *e);
            }
        }
    }

    fn read_drives(&mut self, system: &LinearSystem) {
        system.multiply_known_transposed(&self.rows, &self.lambda, &mut self.scratch.product[..self.mech.nv]);
        for (k, p) in system.prescribed.iter().enumerate() {
            self.drive[k] = match p {
                Prescribed::Node(n) => {
                    let v = self.mech.nodes[*n].v;
                    self.tau[v] - self.scratch.product[v]
                }
                Prescribed::Row(row, _) => self.lambda[*row],
            };
        }
        self.turn_attitude_drives(system);
    }

    /// The multipliers of an attitude are moments about the first frame's axes; the efforts along roll, pitch
    /// and yaw are their projections: `u = Eᵀ n` with `ω = E [roll̇, pitcḣ, yaẇ]`.
    fn turn_attitude_drives(&mut self, system: &LinearSystem) {
        for (k, p) in system.prescribed.iter().enumerate() {
            let Prescribed::Row(_, Source::Measured { link, measure: Measure::Attitude(0) }) = p else { continue };
            let rpy = rpy_from_matrix(&self.mech.links[*link].pose(&self.x).relative());
            let n: [f64; 3] = std::array::from_fn(|i| self.drive[k + i]);
            for i in 0..3 {
                let mut rate = [0.0; 3];
                rate[i] = 1.0;
                let (w, _) = spin_of_rpy(&rpy, &rate, &[0.0; 3]);
                self.drive[k + i] = w[0] * n[0] + w[1] * n[1] + w[2] * n[2];
            }
        }
    }

    /// The inward pass with the wrenches of loops, couplings and measured drives applied.
    /// Without own demands it gives the answer to the multipliers alone.
    pub(crate) fn gather_with_loops(&mut self, system: &LinearSystem, own: bool) {
        if own {
            start_from_own(&mut self.x);
            self.add_measured_friction();
        } else {
            for x in &mut self.x {
                (x.f, x.n) = (S::Vector::default(), S::Angular::default());
            }
        }
        for (c, &k) in self.mech.closing.iter().enumerate() {
            let (f, n) = self.link_wrench(c);
            let link = &self.mech.links[k];
            take_off(&mut self.x[link.ends[1].0], self.rows.p2[c], f, n);
            take_off(&mut self.x[link.ends[0].0], self.rows.p2[c], -f, -n);
        }
        for i in 0..self.measured_efforts_count(system) {
            if let Some((Source::Measured { link, measure }, effort)) = self.measured_effort(system, i) {
                demand_pair(&self.mech, &mut self.x, link, measure, effort);
            }
        }
        dynamics::gather(&self.mech, &mut self.x);
    }

    /// `Σ λ (f, n)` of closing link `c` at its P₂.
    fn link_wrench(&self, c: usize) -> (S::Vector, S::Angular) {
        let link = &self.mech.links[self.mech.closing[c]];
        let mut sum = (S::Vector::default(), S::Angular::default());
        for r in link.first_row..link.first_row + link.rows.len() {
            let (f, n) = self.rows.wrench[r];
            sum.0 += f * self.lambda[r];
            sum.1 += n * self.lambda[r];
        }
        sum
    }

    /// Efforts of couplings and of prescribed rows, two a coupling and one a row: coordinate and effort.
    fn measured_effort(&self, system: &LinearSystem, i: usize) -> Option<(Source, f64)> {
        if let Some(c) = self.mech.couplings.get(i / 2) {
            let l = self.lambda[self.mech.link_rows + i / 2];
            return Some(if i.is_multiple_of(2) { (c.b, l) } else { (c.a, -c.ratio * l) });
        }
        match system.prescribed[i - 2 * self.mech.couplings.len()] {
            Prescribed::Row(row, source) => Some((source, self.lambda[row])),
            Prescribed::Node(_) => None,
        }
    }
    fn measured_efforts_count(&self, system: &LinearSystem) -> usize {
        2 * self.mech.couplings.len() + system.prescribed.len()
    }

    /// Wrench of every joint on its second body about P₂.
    pub(crate) fn collect_wrenches(&mut self, system: &LinearSystem) {
        for j in 0..self.wrench.len() {
            self.wrench[j] = self.tree_wrench(j);
        }
        for c in 0..self.mech.closing.len() {
            let joint = self.mech.links[self.mech.closing[c]].joint;
            self.wrench[joint.0] = self.link_wrench(c);
        }
        for i in 0..self.measured_efforts_count(system) {
            if let Some((source, effort)) = self.measured_effort(system, i) {
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

    fn add_effort_wrench(&mut self, source: Source, effort: f64) {
        let Source::Measured { link, measure } = source else { return };
        let link = &self.mech.links[link];
        // A tree joint's wrench comes from the inward pass, whole.
        if self.mech.tree_joint[link.joint.0].is_none() {
            let g = link.measure(measure, &link.pose(&self.x));
            self.wrench[link.joint.0].0 += g.f * effort;
            self.wrench[link.joint.0].1 += g.n * effort;
        }
    }

    fn tree_wrench(&self, j: usize) -> (S::Vector, S::Angular) {
        let (Some(tree), Some(link)) = (self.mech.tree_joint[j], self.mech.link_of[j]) else {
            return (S::Vector::default(), S::Angular::default());
        };
        let x = &self.x[tree.last];
        let p2 = self.mech.links[link].points(&self.x)[1];
        let n = x.n + S::moment(x.p - p2, x.f);
        if tree.reversed { (-x.f, -n) } else { (x.f, n) }
    }

    /// Friction depends on the reaction it changes: iterate to consistency.
    fn settle_friction(&mut self, system: &mut LinearSystem) -> Result<(), MechanismError> {
        let mut worst = (JointId(0), f64::INFINITY);
        for _ in 0..MOST_ITERATIONS {
            worst = self.update_friction();
            self.balance(system);
            if worst.1 <= SETTLED {
                for (out, e) in self.outputs.iter_mut().zip(&self.friction) {
                    out.effort += e;
                }
                return Ok(());
            }
        }
        self.void_forces();
        self.stage = Stage::Forces;
        Err(MechanismError::Jammed { joint: worst.0, change: worst.1 })
    }

    /// New friction efforts from the present reactions; the joint that changed most and by how much.
    fn update_friction(&mut self) -> (JointId, f64) {
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        let mut change = (JointId(0), 0.0_f64);
        let mut largest = f64::MIN_POSITIVE;
        for i in 0..self.mech.elements.len() {
            let Element::Friction(f) = &self.mech.elements[i] else { continue };
            let rate = read(&self.mech, &self.x, &self.q, &self.v, f.source).1;
            let effort = friction_effort(&now, f, rate, self.normal_force(f));
            let step = (effort - self.friction[i]).abs();
            largest = largest.max(effort.abs());
            if step.is_nan() || step > change.1 {
                change = (f.coordinate.joint, step);
            }
            self.friction[i] = effort;
        }
        (change.0, change.1 / largest)
    }

    /// Reaction across the axis of a joint: what presses its surfaces together.
    fn normal_force(&self, f: &Friction<f64>) -> f64 {
        let j = f.coordinate.joint.0;
        let force = self.wrench[j].0;
        let Some(link) = self.mech.link_of[j] else { return 0.0 };
        let link = &self.mech.links[link];
        let pose = link.pose(&self.x);
        let axis = match Measure::of::<S>(&self.blueprint.joints[j].kind, f.coordinate.index) {
            Measure::Slide(i) => S::column(&pose.R[0], i),
            Measure::Turn(_) | Measure::Thread | Measure::Fork if S::DIM == 3 => S::column(&pose.R[0], 2),
            Measure::Yoke => S::column(&pose.R[1], 0),
            _ => S::Vector::default(),
        };
        let across = force - axis * force.dot(axis);
        across.dot(across).sqrt()
    }

    pub(crate) fn void_forces(&mut self) {
        self.drive.fill(f64::NAN);
        self.lambda.fill(f64::NAN);
        let mut nan = (S::Vector::default(), S::Angular::default());
        (0..S::DIM).for_each(|i| nan.0[i] = f64::NAN);
        (0..S::ANG).for_each(|i| nan.1[i] = f64::NAN);
        self.wrench.fill(nan);
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

fn demand_pair<S: Space<T = f64>>(
    mech: &crate::mechanism::Mechanism<S>,
    x: &mut [NodeState<S>],
    link: usize,
    measure: Measure,
    effort: f64,
) {
    let link = &mech.links[link];
    // A drive of a tree joint acts inside the joint: the inward pass carries it already.
    if mech.tree_joint[link.joint.0].is_some() {
        return;
    }
    let pose = link.pose(x);
    let g = link.measure(measure, &pose);
    take_off(&mut x[link.ends[1].0], pose.p[1], g.f * effort, g.n * effort);
    take_off(&mut x[link.ends[0].0], pose.p[1], -(g.f * effort), -(g.n * effort));
}
