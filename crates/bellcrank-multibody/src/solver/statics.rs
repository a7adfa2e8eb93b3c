//! Equilibrium at rest of a mechanism that is not fully held, and its stability.
//!
//! With N spanning the motions that loops and held coordinates allow, equilibrium is `Nᵀ Q = 0` and the
//! stiffness `K = −Nᵀ ∂(Q + Jᵀλ)/∂q N`, differentiated exactly in dual numbers. Newton steps with the
//! negative curvatures turned round lead downhill, so that a stable equilibrium is found where one is near.

use super::assembly::SparseRows;
use super::machine::{Machine, Stage};
use crate::mechanism::{Mechanism, Source};
use crate::resting::Resting;
use crate::topology::Motion;
use crate::{Actuation, Coordinate, Equilibrium, JointId, MechanismError};
use bellcrank_math::linalg::dense;
use bellcrank_math::{Dual, Space};

const MOST_ITERATIONS: usize = 300;
/// Unbalanced force that counts as none, relative to the forces present.
const BALANCED: f64 = 1e-11;
/// Singular values below this part of the largest are constraints that repeat.
const RANK: f64 = 1e-9;
/// Half-width of the differences taken of force expressions, whose derivatives only their owner knows.
const DIFFERENCE: f64 = 1e-6;

type Inputs<'a> = crate::Inputs<'a, f64>;
/// A dense matrix by rows.
type Matrix = Vec<Vec<f64>>;
type Lifted<S> = <S as Space>::With<Dual<1>>;

/// The longest step, rad or machine sizes.
const FARTHEST: f64 = 0.3;
/// A step is taken back when the forces at its end oppose it more than this part of what drove it.
const OVERSHOOT: f64 = 0.9;

/// A step taken: from where, along what, and the work rate of the forces at its start.
struct Step {
    from: Vec<f64>,
    motion: Vec<f64>,
    work: f64,
}

/// Allowed motions and multipliers at one position.
struct Allowed {
    /// Orthonormal motions, nv components each.
    motions: Vec<Vec<f64>>,
    /// Multipliers of all rows, then of the held coordinates, that balance what they can.
    multipliers: Vec<f64>,
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn find_equilibrium(
        &mut self,
        hold: &[(Coordinate, f64)],
        inputs: Inputs<'_>,
    ) -> Result<Equilibrium, MechanismError> {
        let held: Vec<(Source, f64)> = hold.iter().filter_map(|(c, x)| Some((self.mech.source(*c)?, *x))).collect();
        let lifted = Mechanism::<Lifted<S>>::build(&self.blueprint.map(Dual::from_re))
            .map_err(|_| MechanismError::NotFinite("the mechanism's data"))?;
        self.close_loops(&held)?;
        let (iterations, residual) = self.descend(&lifted, &held, inputs)?;
        let stiffness = self.stiffness_at_rest(&lifted, &held, inputs)?;
        let free = self.independent(&held);
        let eigenvalues = reduced_eigenvalues(&stiffness.0, &stiffness.1, &self.velocity_indices(&free));
        self.solve_at_rest(hold, &free, inputs)?;
        let stable = eigenvalues.iter().all(|e| *e > 0.0);
        Ok(Equilibrium { iterations, residual, stiffness: eigenvalues, stable, free })
    }

    fn descend(
        &mut self,
        lifted: &Mechanism<Lifted<S>>,
        held: &[(Source, f64)],
        inputs: Inputs<'_>,
    ) -> Result<(usize, f64), MechanismError> {
        let mut reach = FARTHEST;
        let mut worst = (f64::INFINITY, 0);
        let mut last: Option<Step> = None;
        for iteration in 0..MOST_ITERATIONS {
            let mut q = self.forces_at_rest(inputs)?;
            if let Some(step) = &last {
                if dot(&step.motion, &q) < -OVERSHOOT * step.work {
                    // The forces now push back harder than they drove: the equilibrium was passed.
                    reach = 0.4 * self.extent(&step.motion);
                    self.q.copy_from_slice(&step.from);
                    self.update_positions();
                    q = self.forces_at_rest(inputs)?;
                } else {
                    reach = (reach * 2.0).min(FARTHEST);
                }
            }
            let size = q.iter().fold(1e-9, |m: f64, x| m.max(x.abs())).max(self.load_size()).max(self.bending_size());
            let allowed = self.allowed(held, &q);
            let r: Vec<f64> = allowed.motions.iter().map(|n| dot(n, &q)).collect();
            worst = r.iter().enumerate().fold((0.0, 0), |m, (k, x)| if x.abs() > m.0 { (x.abs(), k) } else { m });
            if worst.0 <= BALANCED * size {
                return Ok((iteration, worst.0));
            }
            let y = downhill(&self.curvature(lifted, held, &allowed, inputs), &r);
            self.scratch.delta.fill(0.0);
            for (n, y) in allowed.motions.iter().zip(&y) {
                self.scratch.delta.iter_mut().zip(n).for_each(|(d, n)| *d += y * n);
            }
            self.limit_rest_step(reach);
            let motion = self.scratch.delta.clone();
            last = Some(Step { from: self.q.clone(), work: dot(&motion, &q), motion });
            self.step(1.0);
            self.update_positions();
            self.close_loops(held)?;
        }
        let coordinate = self.independent(held).get(worst.1).copied();
        let coordinate = coordinate.unwrap_or(Coordinate { joint: JointId(0), index: 0 });
        Err(MechanismError::NoEquilibrium { residual: worst.0, coordinate })
    }

    /// Weights as a yardstick of force.
    fn load_size(&self) -> f64 {
        let g = S::spread(self.mech.gravity).iter().map(|x| x * x).sum::<f64>().sqrt();
        let rigid: f64 = self.mech.nodes.iter().filter_map(|n| n.inertia.as_ref()).map(|i| i.mass).sum();
        let flexible: f64 = self.mech.flexible.iter().map(|body| body.data.inertia.mass).sum();
        (rigid + flexible) * g * self.mech.size.min(1.0)
    }

    /// The largest sum of elastic forces, taken without their signs: what a body is bent by balances them to its rounding.
    fn bending_size(&self) -> f64 {
        let mut largest = 0.0_f64;
        for body in &self.mech.flexible {
            let d: Vec<f64> = body.nodes.iter().map(|&node| self.q[self.mech.nodes[node].q]).collect();
            for row in body.data.stiffness.chunks_exact(d.len().max(1)) {
                largest = largest.max(row.iter().zip(&d).map(|(k, d)| (k * d).abs()).sum());
            }
        }
        largest
    }

    /// Generalized applied forces Q (nv) at rest here; leaves the machine readable at rest.
    fn forces_at_rest(&mut self, inputs: Inputs<'_>) -> Result<Vec<f64>, MechanismError> {
        self.rest();
        self.ask_inputs(inputs)?;
        self.apply_forces();
        let mut here = Resting::new(&self.mech);
        here.q.copy_from_slice(&self.q);
        here.inputs.copy_from_slice(&self.inputs);
        here.generalized_force(&self.mech, &vec![0.0; self.mech.rows()], &[]);
        if here.force.iter().all(|x| x.is_finite()) {
            Ok(here.force)
        } else {
            Err(MechanismError::NotFinite("a force"))
        }
    }

    /// Zero velocities and accelerations, so that signals can be read.
    fn rest(&mut self) {
        self.v.fill(0.0);
        self.a.fill(0.0);
        crate::kinematics::velocities(&self.mech, &self.v, &mut self.x);
        crate::kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        self.stage = Stage::Rates;
    }

    fn allowed(&mut self, held: &[(Source, f64)], q: &[f64]) -> Allowed {
        let nv = self.mech.nv;
        let rows = self.all_rows(held);
        let padded: Vec<Vec<f64>> =
            rows.iter().cloned().chain(std::iter::repeat_n(vec![0.0; nv], nv.saturating_sub(rows.len()))).collect();
        let mut allowed = Allowed { motions: Vec::new(), multipliers: vec![0.0; rows.len()] };
        let Some(svd) = dense::svd(&padded, nv) else { return allowed };
        let top = svd.values.first().copied().unwrap_or(0.0);
        for (k, s) in svd.values.iter().enumerate() {
            if *s <= RANK * top || top == 0.0 {
                allowed.motions.push(svd.right[k].clone());
                continue;
            }
            // Jᵀ λ = −Q by the pseudo-inverse: λ = −Σ u (v·Q)/s.
            let part = -dot(&svd.right[k], q) / s;
            allowed.multipliers.iter_mut().zip(&svd.left[k]).for_each(|(l, u)| *l += part * u);
        }
        allowed
    }

    fn all_rows(&mut self, held: &[(Source, f64)]) -> Vec<Vec<f64>> {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        let mut a = vec![vec![0.0; self.mech.nv]; self.mech.rows()];
        self.rows.each(&self.mech, |r, v, value| a[r][v] += value);
        let sources: Vec<Source> = held.iter().map(|h| h.0).collect();
        a.extend(SparseRows::of_sources(&self.mech, &self.x, &sources).dense(self.mech.nv));
        a
    }

    /// `−Nᵀ ∂(Q + Jᵀλ)/∂q N`.
    fn curvature(
        &mut self,
        lifted: &Mechanism<Lifted<S>>,
        held: &[(Source, f64)],
        allowed: &Allowed,
        inputs: Inputs<'_>,
    ) -> Vec<Vec<f64>> {
        let h = self.force_derivative(lifted, held, &allowed.multipliers, inputs);
        let along = |n: &Vec<f64>| -> Vec<f64> { h.iter().map(|row| dot(row, n)).collect() };
        let columns: Vec<Vec<f64>> = allowed.motions.iter().map(along).collect();
        allowed.motions.iter().map(|m| columns.iter().map(|c| -dot(m, c)).collect()).collect()
    }

    /// `∂(Q + Jᵀλ)/∂q`, nv × nv by rows.
    fn force_derivative(
        &mut self,
        lifted: &Mechanism<Lifted<S>>,
        held: &[(Source, f64)],
        multipliers: &[f64],
        inputs: Inputs<'_>,
    ) -> Vec<Vec<f64>> {
        let (lambda, efforts) = multipliers.split_at(self.mech.rows());
        let pushes: Vec<(Source, f64)> = held.iter().zip(efforts).map(|(h, e)| (h.0, *e)).collect();
        let nv = self.mech.nv;
        let mut h = vec![vec![0.0; nv]; nv];
        let mut dual = Resting::<Lifted<S>>::new(lifted);
        for k in 0..nv {
            let slopes = self.input_slopes(k, inputs);
            dual.displace(lifted, &self.q, k, Dual::variable(0.0, 0));
            for (d, (value, slope)) in dual.inputs.iter_mut().zip(self.inputs.iter().zip(&slopes)) {
                *d = Dual { re: *value, eps: [*slope] };
            }
            dual.generalized_force(lifted, lambda, &pushes);
            h.iter_mut().zip(&dual.force).for_each(|(row, f)| row[k] = f.eps[0]);
        }
        h
    }

    /// Central differences of the inputs along velocity component `k`.
    fn input_slopes(&mut self, k: usize, inputs: Inputs<'_>) -> Vec<f64> {
        if self.inputs.is_empty() {
            return Vec::new();
        }
        let (q, kept) = (self.q.clone(), self.inputs.clone());
        let mut sides = [kept.clone(), kept.clone()];
        for (side, sign) in sides.iter_mut().zip([1.0, -1.0]) {
            self.scratch.delta.fill(0.0);
            self.scratch.delta[k] = sign * DIFFERENCE;
            self.step(1.0);
            self.update_positions();
            self.rest();
            inputs(self, side);
            self.q.copy_from_slice(&q);
            self.update_positions();
            self.rest();
        }
        let [up, down] = sides;
        up.iter().zip(&down).map(|(a, b)| (a - b) / (2.0 * DIFFERENCE)).collect()
    }

    fn limit_rest_step(&mut self, reach: f64) {
        let largest = self.extent(&self.scratch.delta);
        if largest > reach {
            self.scratch.delta.iter_mut().for_each(|d| *d *= reach / largest);
        }
    }

    /// Largest part of a motion, rad or machine sizes.
    fn extent(&self, motion: &[f64]) -> f64 {
        let mut largest: f64 = 0.0;
        for node in &self.mech.nodes[1..] {
            let unit = if matches!(node.motion, Motion::Slide) { self.mech.size } else { 1.0 };
            for d in &motion[node.v..node.v + node.motion.dofs()] {
                largest = largest.max(d.abs() / unit);
            }
        }
        largest
    }

    /// Allowed motions and curvature at the equilibrium.
    fn stiffness_at_rest(
        &mut self,
        lifted: &Mechanism<Lifted<S>>,
        held: &[(Source, f64)],
        inputs: Inputs<'_>,
    ) -> Result<(Matrix, Matrix), MechanismError> {
        let q = self.forces_at_rest(inputs)?;
        let allowed = self.allowed(held, &q);
        let k = self.curvature(lifted, held, &allowed, inputs);
        Ok((k, allowed.motions))
    }

    /// Tree coordinates that describe the free motion, as many as there are.
    fn independent(&mut self, held: &[(Source, f64)]) -> Vec<Coordinate> {
        let zero = vec![0.0; self.mech.nv];
        let mut motions = self.allowed(held, &zero).motions;
        let mut chosen = Vec::new();
        let candidates = self.tree_coordinates();
        while let Some(first) = motions.first() {
            let pick = |c: &(Coordinate, usize)| motions.iter().map(|m| m[c.1].powi(2)).sum::<f64>();
            debug_assert_eq!(first.len(), self.mech.nv);
            let Some(best) = candidates.iter().max_by(|a, b| pick(a).total_cmp(&pick(b))) else { break };
            if pick(best) < 1e-16 {
                break;
            }
            chosen.push(best.0);
            motions = without(motions, best.1);
        }
        if motions.len() >= 3 {
            chosen.extend(self.attitudes());
        }
        chosen
    }

    /// The three angles of the first joint that has them.
    fn attitudes(&self) -> Vec<Coordinate> {
        let is_attitude = |s: &Source| matches!(s, Source::Measured { measure, .. } if measure.is_attitude());
        let of = |(j, sources): (usize, &Vec<Source>)| -> Option<Vec<Coordinate>> {
            let first = sources.iter().position(is_attitude)?;
            Some((first..first + 3).map(|index| Coordinate { joint: JointId(j), index }).collect())
        };
        self.mech.sources.iter().enumerate().find_map(of).unwrap_or_default()
    }

    /// Single tree coordinates with their velocity component; balls count by their attitudes and are left out.
    fn tree_coordinates(&self) -> Vec<(Coordinate, usize)> {
        let mut all = Vec::new();
        for (j, sources) in self.mech.sources.iter().enumerate() {
            for (index, s) in sources.iter().enumerate() {
                if let Source::Node(n) = s {
                    all.push((Coordinate { joint: JointId(j), index }, self.mech.nodes[*n].v));
                }
            }
        }
        all
    }

    fn velocity_indices(&self, list: &[Coordinate]) -> Vec<usize> {
        let index = |c: &Coordinate| match self.mech.source(*c) {
            Some(Source::Node(n)) => Some(self.mech.nodes[n].v),
            _ => None,
        };
        list.iter().filter_map(index).collect()
    }

    /// Reactions at the equilibrium: the free coordinates count as drives that carry nothing.
    fn solve_at_rest(
        &mut self,
        hold: &[(Coordinate, f64)],
        free: &[Coordinate],
        inputs: Inputs<'_>,
    ) -> Result<(), MechanismError> {
        let list: Vec<Coordinate> = hold.iter().map(|h| h.0).chain(free.iter().copied()).collect();
        let actuation = Actuation { position: list.clone(), rate: list.clone(), effort: list };
        self.prepare_systems(&actuation)?;
        let zeros = vec![0.0; actuation.position.len()];
        self.solve_rates(&zeros, &zeros)?;
        self.ask_inputs(inputs)?;
        self.solve_efforts()
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// The motions with component `v` taken out: one fewer.
fn without(mut motions: Vec<Vec<f64>>, v: usize) -> Vec<Vec<f64>> {
    let best = (0..motions.len()).fold(0, |b, k| if motions[k][v].abs() > motions[b][v].abs() { k } else { b });
    let pivot = motions.swap_remove(best);
    for m in &mut motions {
        let factor = m[v] / pivot[v];
        m.iter_mut().zip(&pivot).for_each(|(m, p)| *m -= factor * p);
    }
    motions
}

/// Newton step `K⁻¹ r` where K bends up; elsewhere with the curvatures turned round.
fn downhill(k: &[Vec<f64>], r: &[f64]) -> Vec<f64> {
    let n = r.len();
    let symmetric: Vec<Vec<f64>> = (0..n).map(|i| (0..n).map(|j| 0.5 * (k[i][j] + k[j][i])).collect()).collect();
    let Some((values, vectors)) = dense::symmetric_eigen(&symmetric) else { return r.to_vec() };
    let top = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    if values.iter().all(|v| *v > 1e-9 * top)
        && let Some(y) = dense::solve(k, r)
    {
        return y;
    }
    let mut y = vec![0.0; n];
    for (value, vector) in values.iter().zip(&vectors) {
        let part = dot(vector, r) / value.abs().max(1e-6 * top).max(1e-12);
        y.iter_mut().zip(vector).for_each(|(y, v)| *y += part * v);
    }
    y
}

/// Eigenvalues (real parts, ascending) of the stiffness expressed in independent coordinates.
fn reduced_eigenvalues(k: &[Vec<f64>], motions: &[Vec<f64>], independent: &[usize]) -> Vec<f64> {
    let f = motions.len();
    if independent.len() != f || f == 0 {
        return dense::eigenvalues(k).into_iter().map(|e| e.0).collect();
    }
    // Motion a unit of each independent coordinate: columns of C⁻¹ with C the motions' components there.
    let c: Vec<Vec<f64>> = independent.iter().map(|&v| motions.iter().map(|m| m[v]).collect()).collect();
    let unit = |i: usize| (0..f).map(|k| if k == i { 1.0 } else { 0.0 }).collect::<Vec<f64>>();
    let inverse: Option<Vec<Vec<f64>>> = (0..f).map(|i| dense::solve(&c, &unit(i))).collect();
    let Some(inverse) = inverse else { return dense::eigenvalues(k).into_iter().map(|e| e.0).collect() };
    let product = |a: &[f64]| -> Vec<f64> { k.iter().map(|row| dot(row, a)).collect() };
    let reduced: Vec<Vec<f64>> =
        inverse.iter().map(|a| inverse.iter().map(|b| dot(a, &product(b))).collect()).collect();
    let mut values: Vec<f64> = dense::eigenvalues(&reduced).into_iter().map(|e| e.0).collect();
    values.sort_by(f64::total_cmp);
    values
}
