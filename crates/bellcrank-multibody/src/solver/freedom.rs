//! Degrees of freedom by rank, and the choice of what is prescribed.

use super::assembly::SparseRows;
use super::machine::{Machine, Prepared};
use super::system::LinearSystem;
use crate::constraint::Measure;
use crate::mechanism::{Source, row_name};
use crate::{Actuation, Coordinate, Freedom, MechanismError, Redundancy};
use bellcrank_math::{Space, linalg::dense};

/// Singular values below this part of the largest count as zero.
pub(crate) const RANK: f64 = 1e-9;
/// Beyond this many coordinates ranks are not computed densely: the count stands for them.
pub(crate) const LARGE: usize = 500;
/// How far the neighbours lie at which a rank is confirmed, rad or machine sizes.
const NEARBY: f64 = 1e-3;

impl<S: Space<T = f64>> Machine<S> {
    /// Constraint Jacobian over all coordinates with lengths in machine sizes, by rows.
    pub(crate) fn scaled_jacobian(&mut self) -> Vec<Vec<f64>> {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        let mut a = vec![vec![0.0; self.mech.nv]; self.mech.rows()];
        self.rows.each(&self.mech, |r, v, value| a[r][v] += value);
        // A row's own size (m or rad) does not matter to its independence, but a row that is nothing beside
        // the machine is the rounding of terms that cancel, and no equation.
        let nothing = 1e-10 * self.mech.size.min(1.0);
        for row in &mut a {
            let n = row.iter().map(|x| x * x).sum::<f64>().sqrt();
            row.iter_mut().for_each(|x| *x = if n > nothing { *x / n } else { 0.0 });
        }
        a
    }

    fn rank_here(&mut self) -> usize {
        let a = self.scaled_jacobian();
        dense::rank(&a, self.mech.nv, RANK)
    }

    /// Rank here and the largest rank found at assembled neighbours: they differ at special positions.
    pub(crate) fn ranks(&mut self) -> (usize, usize) {
        let (here, q) = (self.rank_here(), self.q.clone());
        let mut best = here;
        for k in 0..3 {
            if best == self.mech.rows() || !self.move_freely(k) {
                break;
            }
            best = best.max(self.rank_here());
            self.q.copy_from_slice(&q);
            self.update_positions();
        }
        self.q.copy_from_slice(&q);
        self.update_positions();
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        (here, best)
    }

    /// A small motion within the loops, different for each `k`; false when the neighbour does not close.
    fn move_freely(&mut self, k: usize) -> bool {
        let a = self.scaled_jacobian();
        let mut motion: Vec<f64> = (0..self.mech.nv).map(|i| ((i * 7 + 3 * k + 1) as f64).sin()).collect();
        if let Some(svd) = dense::svd(&a, self.mech.nv) {
            let top = svd.values.first().copied().unwrap_or(0.0);
            for (s, right) in svd.values.iter().zip(&svd.right).filter(|(s, _)| **s > RANK * top) {
                let along: f64 = right.iter().zip(&motion).map(|(r, m)| r * m).sum();
                motion.iter_mut().zip(right).for_each(|(m, r)| *m -= along * r);
                debug_assert!(*s > 0.0);
            }
        }
        let n = motion.iter().map(|x| x * x).sum::<f64>().sqrt();
        if n < 1e-9 {
            return false;
        }
        self.scratch.delta.iter_mut().zip(&motion).for_each(|(d, m)| *d = m / n * NEARBY);
        self.step(1.0);
        self.update_positions();
        self.close_loops(&[]).is_ok()
    }

    pub(crate) fn count_freedom(&mut self) -> Freedom {
        let (nv, equations) = (self.mech.nv, self.mech.rows());
        let large = nv > LARGE;
        let (here, best) = if large { (equations, equations) } else { self.ranks() };
        let mut freedom = Freedom {
            coordinates: nv,
            equations,
            rank: best,
            counted: nv as i64 - equations as i64,
            degrees: nv.saturating_sub(best),
            loops: self.mech.closing.len(),
            closing: self.mech.closing.iter().map(|&k| self.mech.links[k].joint).collect(),
            special: here != best,
            ..Freedom::default()
        };
        if !large {
            let a = self.scaled_jacobian();
            freedom.redundant = if best < equations { self.dependent_rows(&a) } else { Vec::new() };
            freedom.mobile = self.mobile(&a, &[]);
        }
        self.leave_shapes_out(&mut freedom);
        freedom
    }

    /// What bodies bend by is told apart from what the machine moves by.
    fn leave_shapes_out(&self, freedom: &mut Freedom) {
        let elastic = self.elastic();
        freedom.shapes = elastic.len();
        freedom.coordinates -= elastic.len();
        freedom.counted -= elastic.len() as i64;
        freedom.degrees = freedom.degrees.saturating_sub(elastic.len());
        freedom.mobile.retain(|c| !elastic.contains(c));
    }

    /// Rows with a part in the left null space, by name.
    pub(crate) fn dependent_rows(&self, a: &[Vec<f64>]) -> Vec<Redundancy> {
        let m = a.len();
        // A square left basis: pad the columns so that U holds m vectors.
        let wide = self.mech.nv.max(m);
        let padded: Vec<Vec<f64>> =
            a.iter().map(|r| r.iter().copied().chain(std::iter::repeat(0.0)).take(wide).collect()).collect();
        let Some(svd) = dense::svd(&padded, wide) else { return Vec::new() };
        let top = svd.values.first().copied().unwrap_or(0.0);
        let null: Vec<&Vec<f64>> =
            svd.values.iter().zip(&svd.left).filter(|(s, _)| **s <= RANK * top).map(|(_, u)| u).collect();
        (0..m).filter(|&r| null.iter().any(|u| u[r].abs() > 1e-6)).map(|r| self.name_row(r)).collect()
    }

    fn name_row(&self, r: usize) -> Redundancy {
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            if (link.first_row..link.first_row + link.rows.len()).contains(&r) {
                return Redundancy { joint: link.joint, equation: row_name(link, r - link.first_row) };
            }
        }
        Redundancy { joint: self.mech.couplings[r - self.mech.link_rows].joint, equation: "coupling" }
    }

    /// Coordinates that can move while `rows` (constraints and prescribed) hold.
    fn mobile(&self, rows: &[Vec<f64>], prescribed: &[Vec<f64>]) -> Vec<Coordinate> {
        let all: Vec<Vec<f64>> = rows.iter().chain(prescribed).cloned().collect();
        let nv = self.mech.nv;
        let mut motion = vec![0.0; nv];
        if all.is_empty() {
            motion.fill(1.0);
            return self.coordinates_by_motion(&motion);
        }
        let padded: Vec<Vec<f64>> =
            all.iter().cloned().chain(std::iter::repeat_n(vec![0.0; nv], nv.saturating_sub(all.len()))).collect();
        if let Some(svd) = dense::svd(&padded, nv) {
            let top = svd.values.first().copied().unwrap_or(0.0);
            for right in svd.values.iter().zip(&svd.right).filter(|(s, _)| **s <= RANK * top).map(|(_, r)| r) {
                motion.iter_mut().zip(right).for_each(|(m, r)| *m += r * r);
            }
        }
        motion.iter_mut().for_each(|m| *m = m.sqrt());
        if motion.iter().all(|m| *m < 1e-6) { Vec::new() } else { self.coordinates_by_motion(&motion) }
    }

    pub(crate) fn prepare_systems(&mut self, actuation: &Actuation) -> Result<(), MechanismError> {
        if let Some(mut kept) = self.kept.take()
            && kept.actuation == *actuation
        {
            self.rows.evaluate(&self.mech, &self.q, &self.x);
            (kept.position_sign, kept.rate_sign) = (0.0, 0.0);
            self.begin_at_present(kept);
            return Ok(());
        }
        for list in [&actuation.position, &actuation.rate, &actuation.effort] {
            self.check_list(list)?;
        }
        let freedom = if self.mech.nv > LARGE {
            self.mech.nv.saturating_sub(self.mech.rows())
        } else {
            self.mech.nv - self.ranks().1
        };
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        let position = self.system_for(&actuation.position, freedom)?;
        let rate =
            (actuation.rate != actuation.position).then(|| self.system_for(&actuation.rate, freedom)).transpose()?;
        let effort =
            (actuation.effort != actuation.rate).then(|| self.system_for(&actuation.effort, freedom)).transpose()?;
        self.begin_at_present(Box::new(Prepared {
            actuation: actuation.clone(),
            position,
            rate,
            effort,
            position_sign: 0.0,
            rate_sign: 0.0,
            targets: Vec::new(),
        }));
        Ok(())
    }

    fn begin_at_present(&mut self, mut prepared: Box<Prepared>) {
        self.reset_unwrapped();
        prepared.targets.clear();
        let places = prepared.actuation.position.iter().map(|c| self.solved().coordinate(*c).position);
        prepared.targets.extend(places);
        self.drive.clear();
        self.drive.resize(prepared.actuation.effort.len(), 0.0);
        self.history.clear();
        self.prepared = Some(prepared);
    }

    pub(crate) fn check_list(&self, list: &[Coordinate]) -> Result<(), MechanismError> {
        for (k, c) in list.iter().enumerate() {
            if list[..k].contains(c) {
                return Err(MechanismError::DrivenTwice(*c));
            }
            let Some(source) = self.mech.source(*c) else { return Err(MechanismError::AttitudeAlone(*c)) };
            if let Source::Measured { measure: Measure::Attitude(i), .. } = source {
                let whole = (0..3).all(|j| {
                    let other = Coordinate { joint: c.joint, index: c.index + j - i };
                    (k + j).checked_sub(i).and_then(|p| list.get(p)) == Some(&other)
                });
                if !whole {
                    return Err(MechanismError::AttitudeAlone(*c));
                }
            }
        }
        Ok(())
    }

    fn system_for(&mut self, list: &[Coordinate], freedom: usize) -> Result<LinearSystem, MechanismError> {
        let sources: Vec<Source> = list.iter().filter_map(|c| self.mech.source(*c)).collect();
        let system = LinearSystem::new(&self.mech, &self.rows, &sources);
        if list.len() > freedom {
            let conflicting = if self.mech.nv > LARGE { list.to_vec() } else { self.conflicting(list) };
            return Err(MechanismError::OverDriven { freedom, driven: list.len(), conflicting });
        }
        let under = |free| MechanismError::UnderDriven { freedom, driven: list.len(), free };
        let Some(system) = system else { return Err(under(self.free_beside(list))) };
        if list.len() < freedom {
            return Err(under(self.free_beside(list)));
        }
        if self.mech.nv <= LARGE && !self.is_regular_somewhere(list, freedom) {
            return Err(under(self.free_beside(list)));
        }
        Ok(system)
    }

    pub(crate) fn prescribed_rows(&mut self, list: &[Coordinate]) -> Vec<Vec<f64>> {
        let sources: Vec<Source> = list.iter().filter_map(|c| self.mech.source(*c)).collect();
        let rows = SparseRows::of_sources(&self.mech, &self.x, &sources);
        rows.dense(self.mech.nv)
    }

    /// Do constraints and prescribed coordinates take all freedom, here or at a neighbour?
    fn is_regular_somewhere(&mut self, list: &[Coordinate], freedom: usize) -> bool {
        let q = self.q.clone();
        let mut regular = false;
        for k in 0..4 {
            let mut a = self.scaled_jacobian();
            a.extend(self.prescribed_rows(list));
            let constraints = self.mech.nv - freedom;
            regular = dense::rank(&a, self.mech.nv, RANK) >= constraints + list.len();
            if regular {
                break;
            }
            self.q.copy_from_slice(&q);
            self.update_positions();
            if !self.move_freely(k) {
                break;
            }
        }
        self.q.copy_from_slice(&q);
        self.update_positions();
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        regular
    }

    fn free_beside(&mut self, list: &[Coordinate]) -> Vec<Coordinate> {
        if self.mech.nv > LARGE {
            return Vec::new();
        }
        let a = self.scaled_jacobian();
        let p = self.prescribed_rows(list);
        self.mobile(&a, &p)
    }

    /// Drives that take part in a dependency.
    pub(crate) fn conflicting(&mut self, list: &[Coordinate]) -> Vec<Coordinate> {
        let a = self.scaled_jacobian();
        let p = self.prescribed_rows(list);
        let full = dense::rank(&[a.clone(), p.clone()].concat(), self.mech.nv, RANK);
        let without = |k: usize| {
            let rest: Vec<Vec<f64>> = p.iter().enumerate().filter(|(i, _)| *i != k).map(|(_, r)| r.clone()).collect();
            dense::rank(&[a.clone(), rest].concat(), self.mech.nv, RANK)
        };
        (0..list.len()).filter(|&k| without(k) == full).map(|k| list[k]).collect()
    }
}
