//! The linear system of forward dynamics: masses, and the constraints that they move under.
//!
//! `[M Jᵀ; J 0] [a; μ] = [τ; γ]` over the coordinates that nothing prescribes, with lengths in machine sizes, masses
//! in the machine's largest, and rows of J of size one, so that pivots can be compared. Where equations depend on each
//! other (over-constrained machines, special positions) `−ε` stands in the lower block and the solution is refined
//! against the system without it (method of multipliers): the motion is that of the constraints, the multipliers are
//! those of least size.

use crate::mass_matrix::MassMatrix;
use crate::mechanism::{Mechanism, Source};
use crate::solver::{Entry, LARGE, OUT, Prescribed, RANK, Rows, Unknowns, source_entries};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::Space;
use bellcrank_math::linalg::dense::svd;
use bellcrank_math::linalg::{BandLu, band_ordering};

/// Below this many unknowns a dense factorization is the fastest band.
const DENSE: usize = 32;
/// Pivot ratios below this mean that a mass is missing, or an equation depends on others.
const SINGULAR: f64 = 1e-14;
/// Below this the regularized system is taken, and no sooner: constraints that fade near a stretched pose must hold
/// on to the machine all the way, or it goes over to another branch.
const WEAK: f64 = 1e-13;
/// Compliance of equations that depend on others by structure, scaled; and of those that do so for an instant.
const COMPLIANCE: f64 = 1e-7;
const PASSING: f64 = 1e-12;
/// Refinements of a regularized solution.
const REFINEMENTS: usize = 4;

/// The system with storage for its factorization and solutions.
#[derive(Clone, Debug)]
pub(crate) struct Saddle {
    /// In the order of the driven coordinates, then what is locked.
    pub(crate) prescribed: Vec<Prescribed>,
    /// Place of each velocity component among the unknowns, or `OUT`.
    free: Vec<usize>,
    /// Velocity component of each unknown.
    pub(crate) columns: Vec<usize>,
    /// All rows: links, couplings, prescribed rows.
    pub(crate) rows: usize,
    /// Place of each unknown (columns, then rows) in the band.
    place: Vec<usize>,
    lu: BandLu,
    /// Where everything is driven J is square: motion follows from it alone, multipliers from its transpose.
    square: Option<BandLu>,
    /// The last factorization is that of `square`.
    by_square: bool,
    /// Unknowns of each mass entry (`OUT` where prescribed).
    mass: Vec<(usize, usize)>,
    /// Row and unknown of each entry of the links' blocks.
    blocks: Vec<(usize, usize)>,
    /// Entries of prescribed rows at the last fill.
    pub(crate) extra: Vec<Entry>,
    /// Scaled entries over unknowns: (row, column, value) of M's lower triangle and of J.
    masses: Vec<(usize, usize, f64)>,
    jacobian: Vec<(usize, usize, f64)>,
    /// Scale of each velocity component and row.
    column_scale: Vec<f64>,
    row_scale: Vec<f64>,
    mass_scale: f64,
    /// Equations depend on others by structure.
    pub(crate) redundant: bool,
    /// The last factorization is a regularized one.
    regularized: bool,
    /// Pivot ratio of the last factorization, and the least since [`Saddle::watch_weakness`].
    pub(crate) ratio: f64,
    pub(crate) weakest: f64,
    right: Vec<f64>,
    solution: Vec<f64>,
    residual: Vec<f64>,
}

impl Saddle {
    pub(crate) fn new<S: Space<T = f64>>(
        mech: &Mechanism<S>,
        rows: &Rows<S>,
        mass: &MassMatrix<S>,
        sources: &[Source],
        redundant: bool,
    ) -> Self {
        Self::over(mech, rows, mass, Unknowns::new(mech, sources), redundant)
    }

    /// This system with one coordinate more as a row, whether it is one of the tree or not: for impulses along it.
    pub(crate) fn with_row<S: Space<T = f64>>(
        &self,
        mech: &Mechanism<S>,
        rows: &Rows<S>,
        mass: &MassMatrix<S>,
        source: Source,
    ) -> Self {
        let (free, columns, count) = (self.free.clone(), self.columns.clone(), self.rows + 1);
        let prescribed = self.prescribed.iter().copied().chain([Prescribed::Row(self.rows, source)]).collect();
        let mut system =
            Self::over(mech, rows, mass, Unknowns { prescribed, free, columns, rows: count }, self.redundant);
        system.mass_scale = self.mass_scale;
        system.row_scale[..self.rows].copy_from_slice(&self.row_scale);
        system
    }

    fn over<S: Space<T = f64>>(
        mech: &Mechanism<S>,
        rows: &Rows<S>,
        mass: &MassMatrix<S>,
        Unknowns { free, columns, prescribed, rows: count }: Unknowns,
        redundant: bool,
    ) -> Self {
        let (n, size) = (columns.len(), columns.len() + count);
        let mut system = Self {
            prescribed,
            free,
            columns,
            rows: count,
            place: (0..size).collect(),
            lu: BandLu::new(0, 0, 0),
            square: (n == count && n <= DENSE && !redundant).then(|| BandLu::new(n, n, n)),
            by_square: false,
            mass: Vec::new(),
            blocks: Vec::new(),
            extra: Vec::new(),
            masses: Vec::new(),
            jacobian: Vec::new(),
            column_scale: vec![1.0; mech.nv],
            row_scale: vec![1.0; count],
            mass_scale: 1.0,
            redundant,
            regularized: false,
            ratio: 1.0,
            weakest: 1.0,
            right: vec![0.0; size],
            solution: vec![0.0; size],
            residual: vec![0.0; size],
        };
        let length = mech.size.max(1e-9);
        for node in mech.nodes.iter().filter(|n| matches!(n.motion, Motion::Slide)) {
            system.column_scale[node.v] = length;
        }
        for body in &mech.flexible {
            for (&node, metre) in body.nodes.iter().zip(&body.metre) {
                system.column_scale[mech.nodes[node].v] = length * metre;
            }
        }
        system.mass = mass.entries.iter().map(|&(i, j)| (system.free[i], system.free[j])).collect();
        rows.each_of_links(mech, |row, v, _| system.blocks.push((row, v)));
        system.arrange(mech, rows, n, size);
        system
    }

    /// The band, from the pattern of all that may stand in the matrix.
    fn arrange<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, rows: &Rows<S>, n: usize, size: usize) {
        if size <= DENSE {
            self.lu = BandLu::new(size, size, size);
            return;
        }
        let mut pattern = vec![Vec::new(); size];
        let mut put = |i: usize, j: usize| {
            pattern[i].push(j);
            if i != j {
                pattern[j].push(i);
            }
        };
        self.mass.iter().filter(|m| m.0 != OUT && m.1 != OUT).for_each(|m| put(m.0, m.1));
        (0..size).for_each(|i| put(i, i));
        let free = &self.free;
        rows.each(mech, |r, v, _| {
            if free[v] != OUT {
                put(n + r, free[v]);
            }
        });
        for p in &self.prescribed {
            match p {
                Prescribed::Row(row, Source::Measured { link, .. }) => {
                    mech.links[*link].columns.iter().filter(|&&v| free[v] != OUT).for_each(|&v| put(n + row, free[v]));
                }
                Prescribed::Row(row, Source::Node(node)) => put(n + row, free[mech.nodes[*node].v]),
                Prescribed::Node(_) => {}
            }
        }
        pattern.iter_mut().for_each(|row| {
            row.sort_unstable();
            row.dedup();
        });
        let order = band_ordering(&pattern, size);
        // One order for rows and columns keeps the matrix symmetric.
        let place = order.column;
        let mut reach = 0;
        for (i, row) in pattern.iter().enumerate() {
            row.iter().for_each(|&j| reach = reach.max(place[i].abs_diff(place[j])));
        }
        self.place = place;
        self.lu = BandLu::new(size, reach, reach);
    }

    /// Scales from the machine as it stands: call once after the first [`Saddle::fill`] of a new system.
    pub(crate) fn rescale(&mut self) {
        let mut largest = vec![0.0_f64; self.rows];
        for &(r, _, value) in &self.jacobian {
            largest[r] = largest[r].max((value / self.row_scale[r]).abs());
        }
        for (scale, l) in self.row_scale.iter_mut().zip(&largest) {
            *scale = if *l > 1e-9 { 1.0 / l } else { 1.0 };
        }
        let top = self.masses.iter().fold(0.0, |m: f64, e| if e.0 == e.1 { m.max(e.2 * self.mass_scale) } else { m });
        self.mass_scale = if top > 0.0 { top } else { 1.0 };
    }

    /// Takes over masses and the Jacobian at the present position.
    #[inline]
    pub(crate) fn fill<S: Space<T = f64>>(
        &mut self,
        mech: &Mechanism<S>,
        rows: &Rows<S>,
        mass: &MassMatrix<S>,
        x: &[NodeState<S>],
    ) {
        self.masses.clear();
        for (&(i, j), ((v, u), value)) in self.mass.iter().zip(mass.entries.iter().zip(&mass.values)) {
            if i != OUT && j != OUT {
                let scale = self.column_scale[*v] * self.column_scale[*u] / self.mass_scale;
                self.masses.push((i, j, value * scale));
            }
        }
        self.fill_rows(mech, rows, x);
    }

    #[inline]
    fn fill_rows<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, rows: &Rows<S>, x: &[NodeState<S>]) {
        self.extra.clear();
        for p in &self.prescribed {
            if let Prescribed::Row(row, source) = p {
                source_entries(mech, x, *source, 1.0, *row, &mut self.extra);
            }
        }
        self.jacobian.clear();
        let links = self.blocks.iter().zip(&rows.block).map(|(&(r, v), value)| (r, v, *value));
        for (r, v, value) in links.chain(rows.coupling.iter().copied()).chain(self.extra.iter().copied()) {
            let c = self.free[v];
            if c != OUT {
                self.jacobian.push((r, c, value * self.row_scale[r] * self.column_scale[v]));
            }
        }
    }

    /// Every unknown weighs the same: the solution is the shortest one.
    pub(crate) fn take_unit_masses(&mut self) {
        self.redundant = true;
        self.square = None;
        self.masses.clear();
        self.masses.extend((0..self.columns.len()).map(|i| (i, i, 1.0)));
    }

    /// Factors what was filled in. `false` where even the regularized system is singular: a mass is missing.
    #[inline]
    pub(crate) fn factor(&mut self) -> bool {
        let regular = self.factor_as_needed();
        self.weakest = self.weakest.min(self.ratio);
        regular
    }

    /// The least pivot ratio is taken from here on.
    pub(crate) fn watch_weakness(&mut self) {
        self.weakest = 1.0;
    }

    fn factor_as_needed(&mut self) -> bool {
        self.ratio = self.factor_square();
        self.by_square = self.ratio > WEAK;
        if self.by_square {
            self.regularized = false;
            return true;
        }
        if !self.redundant {
            self.ratio = self.factor_with(0.0);
            if self.ratio > WEAK {
                return true;
            }
        }
        let compliance = if self.redundant { COMPLIANCE } else { PASSING };
        self.ratio = self.factor_with(compliance);
        self.ratio > SINGULAR
    }

    /// J alone, where it is square; 0 where it is not.
    #[inline]
    fn factor_square(&mut self) -> f64 {
        let Some(lu) = &mut self.square else { return 0.0 };
        lu.clear();
        self.jacobian.iter().for_each(|&(r, c, value)| lu.add(r, c, value));
        lu.factor()
    }

    fn factor_with(&mut self, compliance: f64) -> f64 {
        self.regularized = compliance > 0.0;
        let n = self.columns.len();
        self.lu.clear();
        for &(i, j, value) in &self.masses {
            let (p, q) = (self.place[i], self.place[j]);
            self.lu.add(p, q, value);
            if i != j {
                self.lu.add(q, p, value);
            }
        }
        for &(r, c, value) in &self.jacobian {
            let (p, q) = (self.place[n + r], self.place[c]);
            self.lu.add(p, q, value);
            self.lu.add(q, p, value);
        }
        if self.regularized {
            (0..self.rows).for_each(|r| self.lu.add(self.place[n + r], self.place[n + r], -compliance));
        }
        self.lu.factor()
    }

    /// The motion that meets `J u = γ` without any force: the least by kinetic energy (`out` as in [`Saddle::solve`]).
    #[inline]
    pub(crate) fn least_motion(&mut self, gamma: &[f64], out: &mut [f64]) {
        let n = self.columns.len();
        self.right[..n].fill(0.0);
        for ((right, gamma), scale) in self.right[n..].iter_mut().zip(gamma).zip(&self.row_scale) {
            *right = gamma * scale;
        }
        if self.by_square {
            self.solution[..n].copy_from_slice(&self.right[n..]);
            self.square.iter().for_each(|lu| lu.solve(&mut self.solution[..n]));
        } else {
            self.solve_right();
        }
        for (i, &v) in self.columns.iter().enumerate() {
            out[v] = self.solution[i] * self.column_scale[v];
        }
    }

    /// Solves `M a + Jᵀ μ = τ`, `J a = γ`: `tau` and `out` have nv components (prescribed ones of `out` stay), `gamma`
    /// and `mu` one a row.
    pub(crate) fn solve(&mut self, tau: &[f64], gamma: &[f64], out: &mut [f64], mu: &mut [f64]) {
        let n = self.columns.len();
        for (i, &v) in self.columns.iter().enumerate() {
            self.right[i] = tau[v] * self.column_scale[v] / self.mass_scale;
        }
        for ((right, gamma), scale) in self.right[n..].iter_mut().zip(gamma).zip(&self.row_scale) {
            *right = gamma * scale;
        }
        self.solve_right();
        for (i, &v) in self.columns.iter().enumerate() {
            out[v] = self.solution[i] * self.column_scale[v];
        }
        for (r, mu) in mu.iter_mut().enumerate().take(self.rows) {
            *mu = self.solution[n + r] * self.row_scale[r] * self.mass_scale;
        }
    }

    /// Factors the system with a tangent added to the masses (both over velocity components, SI), dense.
    pub(crate) fn factor_with_tangent(
        &mut self,
        matrix: Option<BandLu>,
        tangent: impl Fn(usize, usize) -> f64,
    ) -> (BandLu, f64) {
        let (n, size) = (self.columns.len(), self.right.len());
        let mut lu = matrix.filter(|m| m.size() == size).unwrap_or_else(|| BandLu::new(size, size, size));
        lu.clear();
        for (i, &v) in self.columns.iter().enumerate() {
            for (j, &u) in self.columns.iter().enumerate() {
                let scale = self.column_scale[v] * self.column_scale[u] / self.mass_scale;
                lu.add(i, j, tangent(v, u) * scale);
            }
        }
        for &(i, j, value) in &self.masses {
            lu.add(i, j, value);
            if i != j {
                lu.add(j, i, value);
            }
        }
        for &(r, c, value) in &self.jacobian {
            lu.add(n + r, c, value);
            lu.add(c, n + r, value);
        }
        if self.redundant {
            (0..self.rows).for_each(|r| lu.add(n + r, n + r, -COMPLIANCE));
        }
        let ratio = lu.factor();
        (lu, ratio)
    }

    /// Like [`Saddle::solve`] with a matrix of [`Saddle::factor_with_tangent`]; `room` holds the unknowns.
    pub(crate) fn solve_with(
        &self,
        matrix: &BandLu,
        room: &mut Vec<f64>,
        tau: &[f64],
        gamma: &[f64],
        out: &mut [f64],
        mu: &mut [f64],
    ) {
        let n = self.columns.len();
        room.resize(n + self.rows, 0.0);
        for (i, &v) in self.columns.iter().enumerate() {
            room[i] = tau[v] * self.column_scale[v] / self.mass_scale;
        }
        for ((right, gamma), scale) in room[n..].iter_mut().zip(gamma).zip(&self.row_scale) {
            *right = gamma * scale;
        }
        matrix.solve(room);
        for (i, &v) in self.columns.iter().enumerate() {
            out[v] = room[i] * self.column_scale[v];
        }
        for (r, mu) in mu.iter_mut().enumerate().take(self.rows) {
            *mu = room[n + r] * self.row_scale[r] * self.mass_scale;
        }
    }

    #[inline]
    fn solve_right(&mut self) {
        if self.by_square {
            self.solve_square();
        } else if self.regularized {
            self.solve_refined();
        } else {
            self.solve_once();
        }
    }

    /// `a = J⁻¹ γ`, then `μ = J⁻ᵀ (τ − M a)`.
    #[inline]
    fn solve_square(&mut self) {
        let Some(lu) = &self.square else { return };
        let n = self.columns.len();
        let (motion, mu) = self.solution.split_at_mut(n);
        motion.copy_from_slice(&self.right[n..]);
        lu.solve(motion);
        mu.copy_from_slice(&self.right[..n]);
        for &(i, j, value) in &self.masses {
            mu[i] -= value * motion[j];
            if i != j {
                mu[j] -= value * motion[i];
            }
        }
        lu.solve_transposed(mu);
    }

    fn solve_once(&mut self) {
        for (i, p) in self.place.iter().enumerate() {
            self.residual[*p] = self.right[i];
        }
        self.lu.solve(&mut self.residual);
        for (i, p) in self.place.iter().enumerate() {
            self.solution[i] = self.residual[*p];
        }
    }

    fn solve_refined(&mut self) {
        self.solution.fill(0.0);
        for _ in 0..REFINEMENTS {
            self.leave_residual();
            self.lu.solve(&mut self.residual);
            for (x, p) in self.solution.iter_mut().zip(&self.place) {
                *x += self.residual[*p];
            }
        }
    }

    /// What the present solution leaves of the right side, in the order of the band.
    fn leave_residual(&mut self) {
        let n = self.columns.len();
        for (i, p) in self.place.iter().enumerate() {
            self.residual[*p] = self.right[i];
        }
        for &(i, j, value) in &self.masses {
            self.residual[self.place[i]] -= value * self.solution[j];
            if i != j {
                self.residual[self.place[j]] -= value * self.solution[i];
            }
        }
        for &(r, c, value) in &self.jacobian {
            self.residual[self.place[n + r]] -= value * self.solution[c];
            self.residual[self.place[c]] -= value * self.solution[n + r];
        }
    }

    /// `J u` over all unknown columns, unscaled, one a row.
    pub(crate) fn times(&self, u: &[f64], out: &mut [f64]) {
        out[..self.rows].fill(0.0);
        for &(r, c, value) in &self.jacobian {
            let v = self.columns[c];
            out[r] += value / (self.row_scale[r] * self.column_scale[v]) * u[v];
        }
    }

    /// The scaled Jacobian over unknowns, dense, by rows.
    pub(crate) fn dense_jacobian(&self) -> Vec<Vec<f64>> {
        let mut a = vec![vec![0.0; self.columns.len()]; self.rows];
        self.jacobian.iter().for_each(|&(r, c, value)| a[r][c] += value);
        a
    }

    /// Multipliers that move nothing, one number a row: a basis of the null space of Jᵀ.
    pub(crate) fn self_stresses(&self) -> Vec<Vec<f64>> {
        if !self.regularized || self.rows > LARGE {
            return Vec::new();
        }
        // A square left basis: as many columns as rows at least.
        let wide = self.columns.len().max(self.rows);
        let mut a = self.dense_jacobian();
        a.iter_mut().for_each(|row| row.resize(wide, 0.0));
        let Some(svd) = svd(&a, wide) else { return Vec::new() };
        let top = svd.values.first().copied().unwrap_or(0.0);
        let null = svd.values.iter().zip(&svd.left).filter(|(s, _)| **s <= RANK * top);
        null.map(|(_, left)| left.iter().zip(&self.row_scale).map(|(l, d)| l * d).collect()).collect()
    }

    /// The scaled mass matrix over unknowns, dense.
    pub(crate) fn dense_masses(&self) -> Vec<Vec<f64>> {
        let n = self.columns.len();
        let mut a = vec![vec![0.0; n]; n];
        for &(i, j, value) in &self.masses {
            a[i][j] += value;
            if i != j {
                a[j][i] += value;
            }
        }
        a
    }

    /// What the scaled masses are measured in, kg or kg·m².
    pub(crate) fn mass_scale(&self) -> f64 {
        self.mass_scale
    }

    /// Scale of the unknown `i`: what one of its units is in SI.
    pub(crate) fn unit(&self, i: usize) -> f64 {
        self.column_scale[self.columns[i]]
    }
}
