//! Exact derivatives of a solved position (implicit function theorem).
//!
//! The residuals of closure, rates and balance are evaluated once in dual numbers at the solution; the `f64`
//! factorizations of the position carry what is left through the loops: `J dq = −∂g/∂p`, `J dv = −∂ġ/∂p`,
//! `J da = −∂g̈/∂p`, `Jᵀ dλ = ∂(τ − Jᵀλ)/∂p`. No matrix is factored in dual numbers, nothing is differenced.
//! Griewank & Walther (2008) §15.1.

use super::balance::{Balance, Demands};
use super::machine::{Machine, Stage};
use super::readings::Solved;
use super::system::{LinearSystem, SINGULAR};
use super::unknowns::Prescribed;
use crate::attitude::{quaternion_of, quaternion_product, spin_of_rpy};
use crate::constraint::Measure;
use crate::forces::{Element, Output, Present, apply_all, friction_direction, friction_effort, read};
use crate::kinematics;
use crate::mechanism::{Mechanism, Source};
use crate::topology::Motion;
use crate::workspace::NodeState;
use crate::{
    Blueprint, BodyId, BodyMotion, BuildError, Checks, Coordinate, Energy, ForceId, ForceOutput, Inputs, JointId,
    MechanismError, PointMotion, Prescription, Reading, Readings, SEEDS, Seeded, System, Wrench,
};
use bellcrank_math::{Real, Space, matrix_from_rpy, rpy_from_matrix};

/// Friction is settled when no derivative changes by more than this part of the largest.
const SETTLED: f64 = 1e-12;
/// Iterations before friction is said to jam.
const MOST_ITERATIONS: usize = 400;
/// Derivatives of redundant closures that remain after the solution, relative to those before it.
const CONSISTENT: f64 = 1e-7;
/// Derivatives of closures (m or rad a unit of the parameter) that are rounding.
const ROUNDING: f64 = 1e-10;

/// A machine's numbers with derivatives at one position.
#[derive(Debug)]
pub(crate) struct Tangent<D: Space<T = Seeded>> {
    mech: Mechanism<D>,
    time: Seeded,
    q: Vec<Seeded>,
    v: Vec<Seeded>,
    a: Vec<Seeded>,
    x: Vec<NodeState<D>>,
    row_wrench: Vec<(D::Vector, D::Angular)>,
    p2: Vec<D::Vector>,
    inputs: Vec<Seeded>,
    outputs: Vec<Output<D>>,
    efforts: Vec<Seeded>,
    friction: Vec<Seeded>,
    lambda: Vec<Seeded>,
    drive: Vec<Seeded>,
    wrench: Vec<(D::Vector, D::Angular)>,
    unwrapped: Vec<Vec<f64>>,
    /// Residuals, and what solves them.
    left: Vec<Seeded>,
    rhs: Vec<f64>,
    delta: Vec<f64>,
    step: Vec<Seeded>,
}

impl<D: Space<T = Seeded>> Tangent<D> {
    /// From the machine's blueprint with seeded numbers.
    pub(crate) fn new(blueprint: &Blueprint<Seeded>) -> Result<Self, BuildError> {
        let mech = Mechanism::<D>::build(blueprint)?;
        let (o, none) = (Seeded::default(), (D::Vector::default(), D::Angular::default()));
        let most = mech.rows() + mech.nv + 6;
        Ok(Self {
            time: o,
            q: vec![o; mech.nq],
            v: vec![o; mech.nv],
            a: vec![o; mech.nv],
            x: vec![NodeState::default(); mech.nodes.len()],
            row_wrench: vec![none; mech.link_rows],
            p2: vec![D::Vector::default(); mech.closing.len()],
            inputs: vec![o; mech.inputs],
            outputs: vec![Output::default(); mech.elements.len()],
            efforts: vec![o; mech.nv],
            friction: vec![o; mech.elements.len()],
            lambda: vec![o; most],
            drive: Vec::new(),
            wrench: vec![none; blueprint.joints.len()],
            unwrapped: Vec::new(),
            left: vec![o; most],
            rhs: vec![0.0; most],
            delta: vec![0.0; most],
            step: vec![o; mech.nv],
            mech,
        })
    }

    fn solved(&self) -> Solved<'_, D> {
        Solved {
            mech: &self.mech,
            q: &self.q,
            v: &self.v,
            a: &self.a,
            x: &self.x,
            lambda: &self.lambda,
            wrench: &self.wrench,
            outputs: &self.outputs,
            unwrapped: &self.unwrapped,
        }
    }

    /// Plain values of the machine, derivatives zero.
    fn begin<S: Space<T = f64>>(&mut self, machine: &Machine<S>, time: Seeded) {
        let copy = |to: &mut Vec<Seeded>, from: &[f64]| {
            to.clear();
            to.extend(from.iter().map(|&x| Seeded::from_re(x)));
        };
        copy(&mut self.q, &machine.q);
        copy(&mut self.v, &machine.v);
        copy(&mut self.a, &machine.a);
        copy(&mut self.lambda, &machine.lambda);
        copy(&mut self.friction, &machine.friction);
        copy(&mut self.drive, &machine.drive);
        self.unwrapped.clone_from(&machine.unwrapped);
        self.time = time;
    }

    /// Derivatives of the positions.
    fn carry_positions(&mut self, system: &mut LinearSystem, targets: &[Seeded]) {
        for (p, target) in system.prescribed.iter().zip(targets) {
            if let Prescribed::Node(n) = p {
                self.q[self.mech.nodes[*n].q].eps = target.eps;
            }
        }
        self.position_residuals(system, targets);
        let before = self.largest_derivatives(system.rows);
        self.solve(system);
        self.displace();
        if system.is_redundant() {
            self.position_residuals(system, targets);
            self.forget_inconsistent(&before, system.rows);
        }
        kinematics::positions(&self.mech, &self.q, &mut self.x);
        self.evaluate_wrenches();
    }

    fn position_residuals(&mut self, system: &LinearSystem, targets: &[Seeded]) {
        kinematics::positions(&self.mech, &self.q, &mut self.x);
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let pose = link.pose(&self.x);
            for (i, kind) in link.rows.iter().enumerate() {
                self.left[link.first_row + i] = link.row(*kind, &pose).value;
            }
        }
        for (i, c) in self.mech.couplings.iter().enumerate() {
            let [a, b] = [c.a, c.b].map(|s| self.place(s));
            self.left[self.mech.link_rows + i] = b - c.ratio * a - c.offset;
        }
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, Source::Measured { link, measure }) = *p {
                self.left[row] = self.target_error(link, measure, k, targets);
            }
        }
    }

    fn place(&self, source: Source) -> Seeded {
        match source {
            Source::Node(n) => self.q[self.mech.nodes[n].q],
            Source::Measured { link, measure } => {
                let link = &self.mech.links[link];
                link.measure(measure, &link.pose(&self.x)).value
            }
        }
    }

    /// Measured less asked; of an attitude the turn between them about axis `i` of the first frame.
    fn target_error(&self, link: usize, measure: Measure, k: usize, targets: &[Seeded]) -> Seeded {
        let link = &self.mech.links[link];
        let pose = link.pose(&self.x);
        let Measure::Attitude(i) = measure else { return link.measure(measure, &pose).value - targets[k] };
        let asked = matrix_from_rpy(&std::array::from_fn(|c| targets[k + c - i]));
        let is = pose.relative();
        let turn = |r: usize, c: usize| (0..3).fold(Seeded::zero(), |sum, j| sum + is[r][j] * asked[c][j]);
        let (j, l) = ((i + 1) % 3, (i + 2) % 3);
        (turn(l, j) - turn(j, l)) * Seeded::from_re(0.5)
    }

    /// Moves the positions by `step`; a ball turns about the axes before its motion.
    fn displace(&mut self) {
        for node in &self.mech.nodes[1..] {
            match node.motion {
                Motion::Fixed => {}
                Motion::Ball => {
                    let turn = quaternion_of(&std::array::from_fn(|i| self.step[node.v + i]));
                    let old = std::array::from_fn(|i| self.q[node.q + i]);
                    self.q[node.q..node.q + 4].copy_from_slice(&quaternion_product(&turn, &old));
                }
                _ => self.q[node.q] += self.step[node.v],
            }
        }
    }

    fn largest_derivatives(&self, rows: usize) -> [f64; SEEDS] {
        std::array::from_fn(|lane| self.left[..rows].iter().fold(0.0, |m: f64, l| m.max(l.eps[lane].abs())))
    }

    /// Redundant loops that a change of one number alone would tear open have no derivative.
    fn forget_inconsistent(&mut self, before: &[f64; SEEDS], rows: usize) {
        let after = self.largest_derivatives(rows);
        for lane in 0..SEEDS {
            if after[lane] > (CONSISTENT * before[lane]).max(ROUNDING) {
                self.q.iter_mut().for_each(|q| q.eps[lane] = f64::NAN);
            }
        }
    }

    /// `J step = −left` lane by lane, over the free coordinates.
    fn solve(&mut self, system: &mut LinearSystem) {
        self.step.fill(Seeded::default());
        for lane in 0..SEEDS {
            let mut any = false;
            for (rhs, left) in self.rhs.iter_mut().zip(&self.left[..system.rows]) {
                *rhs = -left.eps[lane];
                any |= *rhs != 0.0;
            }
            // Many numbers do not touch the loops at all.
            if any {
                self.delta.fill(0.0);
                system.solve(&self.rhs, &mut self.delta);
                self.step.iter_mut().zip(&self.delta).for_each(|(s, d)| s.eps[lane] = *d);
            }
        }
    }

    fn evaluate_wrenches(&mut self) {
        for (c, &k) in self.mech.closing.iter().enumerate() {
            let link = &self.mech.links[k];
            let pose = link.pose(&self.x);
            self.p2[c] = pose.p[1];
            for (i, kind) in link.rows.iter().enumerate() {
                let g = link.row(*kind, &pose);
                self.row_wrench[link.first_row + i] = (g.f, g.n);
            }
        }
    }

    /// Derivatives of velocities and accelerations.
    fn carry_rates(&mut self, system: &mut LinearSystem, velocity: &[Seeded], acceleration: &[Seeded]) {
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Node(n) = p {
                let v = self.mech.nodes[*n].v;
                (self.v[v].eps, self.a[v].eps) = (velocity[k].eps, acceleration[k].eps);
            }
        }
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        self.rate_residuals(system, velocity, acceleration, false);
        self.solve(system);
        self.v.iter_mut().zip(&self.step).for_each(|(v, s)| *v += *s);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.rate_residuals(system, velocity, acceleration, true);
        self.solve(system);
        self.a.iter_mut().zip(&self.step).for_each(|(a, s)| *a += *s);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
    }

    /// First (or second) time derivatives of all rows less what they should be.
    fn rate_residuals(&mut self, system: &LinearSystem, velocity: &[Seeded], acceleration: &[Seeded], second: bool) {
        let pick = |rates: (Seeded, Seeded)| if second { rates.1 } else { rates.0 };
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let pose = link.pose_for_rows(&self.x);
            let motion = link.motion(&self.x, &pose);
            for (i, kind) in link.rows.iter().enumerate() {
                self.left[link.first_row + i] = pick(link.row_rates(*kind, &pose, &motion));
            }
        }
        for (i, c) in self.mech.couplings.iter().enumerate() {
            let [a, b] = [c.a, c.b].map(|s| pick(self.rates_of(s)));
            self.left[self.mech.link_rows + i] = b - c.ratio * a;
        }
        for (k, p) in system.prescribed.iter().enumerate() {
            if let Prescribed::Row(row, source) = *p {
                let asked = pick(self.asked_rates(source, k, velocity, acceleration));
                self.left[row] = pick(self.rates_of(source)) - asked;
            }
        }
    }

    /// Rates of a coordinate; of an attitude those of the spin about an axis of the first frame.
    fn rates_of(&self, source: Source) -> (Seeded, Seeded) {
        match source {
            Source::Node(n) => {
                let v = self.mech.nodes[n].v;
                (self.v[v], self.a[v])
            }
            Source::Measured { link, measure } => {
                let link = &self.mech.links[link];
                let pose = link.pose(&self.x);
                let motion = link.motion(&self.x, &pose);
                match measure {
                    Measure::Attitude(i) => motion.spin_rates(&pose, i),
                    _ => link.measure_rates(measure, &pose, &motion),
                }
            }
        }
    }

    fn asked_rates(&self, source: Source, k: usize, velocity: &[Seeded], acceleration: &[Seeded]) -> (Seeded, Seeded) {
        let Source::Measured { link, measure: Measure::Attitude(i) } = source else {
            return (velocity[k], acceleration[k]);
        };
        let three = |x: &[Seeded]| -> [Seeded; 3] { std::array::from_fn(|c| x[k + c - i]) };
        let rpy = rpy_from_matrix(&self.mech.links[link].pose(&self.x).relative());
        let (w, wd) = spin_of_rpy(&rpy, &three(velocity), &three(acceleration));
        (w[i], wd[i])
    }

    /// Derivatives of multipliers, drives and joint wrenches.
    fn carry_forces(&mut self, system: &mut LinearSystem, inputs: Inputs<'_, Seeded>) -> Result<(), MechanismError> {
        self.ask_inputs(inputs)?;
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        apply_all(&now, &mut self.x, &mut self.efforts, &mut self.outputs);
        crate::dynamics::own_wrenches(&self.mech, &mut self.x);
        self.carry_multipliers(system);
        if self.mech.elements.iter().any(|e| matches!(e, Element::Friction(_))) {
            self.settle_friction(system)?;
        }
        self.read_drives(system);
        self.collect(&system.prescribed);
        self.outputs.iter_mut().zip(&self.friction).for_each(|(out, e)| out.effort += *e);
        Ok(())
    }

    fn ask_inputs(&mut self, inputs: Inputs<'_, Seeded>) -> Result<(), MechanismError> {
        if self.inputs.is_empty() {
            return Ok(());
        }
        let mut values = std::mem::take(&mut self.inputs);
        inputs(self, &mut values);
        let finite = values.iter().all(|x| x.re.is_finite());
        self.inputs = values;
        if finite { Ok(()) } else { Err(MechanismError::NotFinite("the value of a force")) }
    }

    fn passes<'a>(&'a mut self, prescribed: &'a [Prescribed]) -> (Balance<'a, D>, &'a [Seeded], &'a mut [Seeded]) {
        let passes = Balance {
            mech: &self.mech,
            x: &mut self.x,
            row_wrench: &self.row_wrench,
            p2: &self.p2,
            lambda: &self.lambda,
            friction: &self.friction,
            outputs: &self.outputs,
            prescribed,
            wrench: &mut self.wrench,
        };
        (passes, &self.efforts, &mut self.left[..self.mech.nv])
    }

    fn balance_residuals(&mut self, prescribed: &[Prescribed]) {
        let (mut passes, efforts, left) = self.passes(prescribed);
        passes.residual(efforts, left);
    }

    fn collect(&mut self, prescribed: &[Prescribed]) {
        let (mut passes, ..) = self.passes(prescribed);
        passes.gather_with_loops(Demands::All);
        passes.collect_wrenches();
    }

    /// `Jᵀ dλ` balances what is left.
    fn carry_multipliers(&mut self, system: &mut LinearSystem) {
        self.balance_residuals(&system.prescribed);
        for lane in 0..SEEDS {
            self.rhs.iter_mut().zip(&self.left[..self.mech.nv]).for_each(|(r, l)| *r = l.eps[lane]);
            system.solve_transposed(&self.rhs, &mut self.delta);
            self.lambda.iter_mut().zip(&self.delta[..system.rows]).for_each(|(l, d)| l.eps[lane] += d);
        }
    }

    /// Friction depends on the reaction it changes, and so do their derivatives.
    fn settle_friction(&mut self, system: &mut LinearSystem) -> Result<(), MechanismError> {
        let mut worst = (JointId(0), f64::INFINITY);
        for _ in 0..MOST_ITERATIONS {
            self.collect(&system.prescribed);
            worst = self.update_friction(&system.prescribed);
            self.carry_multipliers(system);
            if worst.1 <= SETTLED {
                return Ok(());
            }
        }
        Err(MechanismError::Jammed { joint: worst.0, change: worst.1 })
    }

    /// New derivatives of friction; the joint that changed most, relative to the largest.
    fn update_friction(&mut self, prescribed: &[Prescribed]) -> (JointId, f64) {
        let (mut change, mut largest) = ((JointId(0), 0.0_f64), f64::MIN_POSITIVE);
        for i in 0..self.mech.elements.len() {
            let Element::Friction(f) = self.mech.elements[i].clone() else { continue };
            let normal = self.passes(prescribed).0.normal_force(&f);
            let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
            let rate = read(&self.mech, &self.x, &self.q, &self.v, f.source).1;
            let direction = friction_direction(&now, &f, rate);
            let effort = friction_effort(&now, &f, rate, direction, normal);
            for (new, old) in effort.eps.iter().zip(&self.friction[i].eps) {
                largest = largest.max(new.abs());
                if (new - old).abs() > change.1 {
                    change = (f.coordinate.joint, (new - old).abs());
                }
            }
            self.friction[i].eps = effort.eps;
        }
        (change.0, change.1 / largest)
    }

    /// Tree drives carry what is left along their coordinates, measured ones are multipliers.
    fn read_drives(&mut self, system: &LinearSystem) {
        self.balance_residuals(&system.prescribed);
        for (k, p) in system.prescribed.iter().enumerate() {
            self.drive[k] = match p {
                Prescribed::Node(n) => self.left[self.mech.nodes[*n].v],
                Prescribed::Row(row, _) => self.lambda[*row],
            };
        }
        super::balance::turn_attitude_drives(&self.mech, &self.x, &system.prescribed, &mut self.drive);
    }
}

/// Along which components of the state forces are differentiated.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Along {
    Positions,
    Velocities,
}

/// Friction whose normal force is held: direction (`None` where the law says it) and normal force.
pub(crate) type Slip = (Option<f64>, f64);

impl<D: Space<T = Seeded>> Tangent<D> {
    /// Derivatives of what is unbalanced, `τ − Jᵀλ − Q` (nv), with respect to up to [`SEEDS`] components from `first`
    /// on, at the machine's present state, accelerations and multipliers; normal forces of friction are held.
    pub(crate) fn unbalanced<S: Space<T = f64>>(
        &mut self,
        machine: &Machine<S>,
        along: Along,
        first: usize,
        prescribed: &[Prescribed],
        slips: &[Option<Slip>],
        inputs: Inputs<'_, Seeded>,
    ) -> Result<&[Seeded], MechanismError> {
        self.begin(machine, Seeded::from_re(machine.time));
        let lanes = (0..SEEDS).filter(|lane| first + lane < self.mech.nv);
        self.step.fill(Seeded::default());
        for lane in lanes {
            match along {
                Along::Positions => self.step[first + lane].eps[lane] = 1.0,
                Along::Velocities => self.v[first + lane].eps[lane] = 1.0,
            }
        }
        self.displace();
        kinematics::positions(&self.mech, &self.q, &mut self.x);
        self.evaluate_wrenches();
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.ask_inputs(inputs)?;
        let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
        apply_all(&now, &mut self.x, &mut self.efforts, &mut self.outputs);
        crate::dynamics::own_wrenches(&self.mech, &mut self.x);
        self.slip(slips);
        self.balance_residuals(prescribed);
        Ok(&self.left[..self.mech.nv])
    }

    fn slip(&mut self, slips: &[Option<Slip>]) {
        for (i, slip) in slips.iter().enumerate() {
            let (Some((direction, normal)), Element::Friction(f)) = (slip, self.mech.elements[i].clone()) else {
                continue;
            };
            let now = Present { mech: &self.mech, q: &self.q, v: &self.v, inputs: &self.inputs };
            let rate = read(&self.mech, &self.x, &self.q, &self.v, f.source).1;
            let direction = direction.map_or_else(|| friction_direction(&now, &f, rate), Seeded::from_re);
            self.friction[i] = friction_effort(&now, &f, rate, direction, Seeded::from_re(*normal));
        }
    }
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn carry_derivatives(
        &mut self,
        at: &Prescription<'_>,
        inputs: Inputs<'_, Seeded>,
    ) -> Result<(), MechanismError> {
        self.need(Stage::Rates);
        let (Some(mut tangent), Some(mut prepared)) = (self.tangent.take(), self.prepared.take()) else {
            return Err(MechanismError::NotFinite("derivatives that were not seeded"));
        };
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        tangent.begin(self, at.time);
        let result = self.carry(&mut tangent, &mut prepared, at, inputs);
        (self.tangent, self.prepared) = (Some(tangent), Some(prepared));
        result
    }

    fn carry(
        &mut self,
        tangent: &mut Tangent<S::With<Seeded>>,
        prepared: &mut super::machine::Prepared,
        at: &Prescription<'_>,
        inputs: Inputs<'_, Seeded>,
    ) -> Result<(), MechanismError> {
        self.factor_here(&mut prepared.position, System::Position)?;
        tangent.carry_positions(&mut prepared.position, at.position);
        let super::machine::Prepared { position, rate, effort, .. } = prepared;
        if let Some(rate) = rate {
            self.factor_here(rate, System::Drive)?;
        }
        let rate = rate.as_mut().unwrap_or(position);
        tangent.carry_rates(rate, at.velocity, at.acceleration);
        if self.stage < Stage::Forces {
            return Ok(());
        }
        match effort {
            Some(effort) => {
                self.factor_here(effort, System::Drive)?;
                tangent.carry_forces(effort, inputs)
            }
            None => tangent.carry_forces(rate, inputs),
        }
    }

    fn factor_here(&mut self, system: &mut LinearSystem, which: System) -> Result<(), MechanismError> {
        if system.factor(&self.mech, &self.rows, &self.x) >= SINGULAR {
            return Ok(());
        }
        let (singular_value, mobile) = self.weakest(system);
        Err(MechanismError::Singular { system: which, singular_value, mobile })
    }
}

impl<D: Space<T = Seeded>> Readings<Seeded> for Tangent<D> {
    fn time(&self) -> Seeded {
        self.time
    }
    fn coordinates_of(&self, joint: JointId) -> usize {
        self.mech.sources.get(joint.0).map_or(0, Vec::len)
    }
    fn coordinate(&self, c: Coordinate) -> Reading<Seeded> {
        self.solved().coordinate(c)
    }
    fn point(&self, body: BodyId, at: [Seeded; 3]) -> PointMotion<Seeded> {
        self.solved().point(body, at)
    }
    fn body(&self, body: BodyId) -> BodyMotion<Seeded> {
        self.solved().body(body)
    }
    fn reaction(&self, joint: JointId) -> Wrench<Seeded> {
        self.solved().reaction(joint)
    }
    fn drive(&self, i: usize) -> Seeded {
        self.drive.get(i).copied().unwrap_or(Seeded::from_re(f64::NAN))
    }
    fn force(&self, force: ForceId) -> ForceOutput<Seeded> {
        self.solved().force(force)
    }
    fn energy(&self) -> Energy<Seeded> {
        self.solved().energy()
    }
    /// Rounding has no derivative.
    fn checks(&self) -> Checks {
        Checks { closure: f64::NAN, balance: f64::NAN }
    }
}
