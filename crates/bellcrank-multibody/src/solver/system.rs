//! The square (or redundant) linear system of a set of prescribed coordinates.
//!
//! Prescribed tree coordinates leave the unknowns; prescribed measured ones add a row. What remains is
//! `J_f δ = rhs` over the free columns, and its transpose for the forces.

use super::jacobian::{Entry, Rows, source_entries};
use super::unknowns::{OUT, Prescribed, Unknowns};
use crate::mechanism::{Mechanism, Source};
use crate::workspace::NodeState;
use bellcrank_math::Space;
use bellcrank_math::linalg::{BandLu, Qr, band_ordering};

/// Below this many unknowns a dense factorization is the fastest band.
const DENSE: usize = 48;
/// Pivot ratios below this mean singular.
pub(crate) const SINGULAR: f64 = 1e-11;

#[derive(Clone, Debug)]
enum Factor {
    Lu(BandLu),
    Qr(Qr),
}

/// A linear system with storage for its factorization and solutions.
#[derive(Clone, Debug)]
pub(crate) struct LinearSystem {
    /// In the order of the actuation.
    pub(crate) prescribed: Vec<Prescribed>,
    /// Place of each velocity component among the unknowns, or `OUT`.
    free: Vec<usize>,
    /// Velocity component of each unknown.
    pub(crate) columns: Vec<usize>,
    /// All rows: links, couplings, prescribed rows.
    pub(crate) rows: usize,
    row_place: Vec<usize>,
    column_place: Vec<usize>,
    factor: Factor,
    /// For each entry of the links' blocks its place in the factor's storage, or `OUT`.
    scatter: Vec<usize>,
    /// Entries of the links' blocks in prescribed columns: entry, row, velocity component.
    known: Vec<(usize, usize, usize)>,
    /// Entries of the prescribed rows at the last fill.
    pub(crate) extra: Vec<Entry>,
    /// Pivot ratio of the last factorization.
    pub(crate) ratio: f64,
    right: Vec<f64>,
    left: Vec<f64>,
}

impl LinearSystem {
    /// `None` when there are more unknowns than equations.
    pub(crate) fn new<S: Space<T = f64>>(mech: &Mechanism<S>, rows: &Rows<S>, sources: &[Source]) -> Option<Self> {
        let Unknowns { prescribed, free, columns, rows: count } = Unknowns::new(mech, sources);
        if count < columns.len() {
            return None;
        }
        let n = columns.len();
        let (row_place, column_place, factor) = if count > n {
            ((0..count).collect(), (0..n).collect(), Factor::Qr(Qr::new(count, n)))
        } else {
            order(mech, rows, &free, &prescribed, n)
        };
        let longest = mech.links.iter().map(|l| l.columns.len()).max().unwrap_or(1).max(1);
        let mut system = Self {
            prescribed,
            free,
            columns,
            rows: count,
            row_place,
            column_place,
            factor,
            scatter: Vec::new(),
            known: Vec::new(),
            extra: Vec::with_capacity(longest * sources.len()),
            ratio: 0.0,
            right: vec![0.0; count.max(n)],
            left: vec![0.0; count.max(n)],
        };
        system.scatter_links(mech, rows);
        Some(system)
    }

    /// Is the number of equations larger than that of unknowns?
    pub(crate) fn is_redundant(&self) -> bool {
        matches!(self.factor, Factor::Qr(_))
    }

    /// Fills and factors at the present rows. The pivot ratio is returned: below [`SINGULAR`] is singular.
    #[inline]
    pub(crate) fn factor<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, rows: &Rows<S>, x: &[NodeState<S>]) -> f64 {
        self.fill_extra(mech, x);
        let storage = match &mut self.factor {
            Factor::Lu(lu) => lu.entries(),
            Factor::Qr(qr) => qr.entries(),
        };
        storage.fill(0.0);
        for (place, value) in self.scatter.iter().zip(&rows.block) {
            if let Some(x) = storage.get_mut(*place) {
                *x += value;
            }
        }
        for i in 0..rows.coupling.len() + self.extra.len() {
            let (r, v, value) = self.single_entry(rows, i);
            if self.free[v] != OUT {
                let place = self.place(r, self.free[v]);
                match &mut self.factor {
                    Factor::Lu(lu) => lu.entries()[place] += value,
                    Factor::Qr(qr) => qr.entries()[place] += value,
                }
            }
        }
        self.ratio = match &mut self.factor {
            Factor::Lu(lu) => lu.factor(),
            Factor::Qr(qr) => qr.factor(SINGULAR),
        };
        self.ratio
    }

    /// Entries of couplings, then of prescribed rows.
    #[inline]
    fn single_entry<S: Space<T = f64>>(&self, rows: &Rows<S>, i: usize) -> Entry {
        rows.coupling.get(i).copied().unwrap_or_else(|| self.extra[i - rows.coupling.len()])
    }

    fn place(&self, row: usize, column: usize) -> usize {
        match &self.factor {
            Factor::Lu(lu) => lu.place(self.row_place[row], self.column_place[column]),
            Factor::Qr(qr) => qr.place(row, column),
        }
    }

    /// Works out where the links' entries go.
    fn scatter_links<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, rows: &Rows<S>) {
        let (mut scatter, mut known) = (Vec::with_capacity(rows.block.len()), Vec::new());
        rows.each_of_links(mech, |row, v, _| {
            if self.free[v] == OUT {
                known.push((scatter.len(), row, v));
                scatter.push(OUT);
            } else {
                scatter.push(self.place(row, self.free[v]));
            }
        });
        (self.scatter, self.known) = (scatter, known);
    }

    fn fill_extra<S: Space<T = f64>>(&mut self, mech: &Mechanism<S>, x: &[NodeState<S>]) {
        self.extra.clear();
        for p in &self.prescribed {
            if let Prescribed::Row(row, source) = p {
                source_entries(mech, x, *source, 1.0, *row, &mut self.extra);
            }
        }
    }

    /// Solves `J_f δ = rhs` (rows) and writes δ into the free components of `out` (nv).
    pub(crate) fn solve(&mut self, rhs: &[f64], out: &mut [f64]) {
        match &mut self.factor {
            Factor::Lu(lu) => {
                for (r, b) in rhs.iter().enumerate().take(self.rows) {
                    self.right[self.row_place[r]] = *b;
                }
                lu.solve(&mut self.right[..self.rows]);
                for (c, v) in self.columns.iter().enumerate() {
                    out[*v] = self.right[self.column_place[c]];
                }
            }
            Factor::Qr(qr) => {
                self.right[..self.rows].copy_from_slice(&rhs[..self.rows]);
                let n = self.columns.len();
                qr.solve(&mut self.right[..self.rows], &mut self.left[..n]);
                for (c, v) in self.columns.iter().enumerate() {
                    out[*v] = self.left[c];
                }
            }
        }
    }

    /// Solves `J_fᵀ λ = τ_f` (least norm where redundant); `tau` has nv components, `lambda` one a row.
    pub(crate) fn solve_transposed(&mut self, tau: &[f64], lambda: &mut [f64]) {
        let n = self.columns.len();
        match &mut self.factor {
            Factor::Lu(lu) => {
                for (c, v) in self.columns.iter().enumerate() {
                    self.right[self.column_place[c]] = tau[*v];
                }
                lu.solve_transposed(&mut self.right[..n]);
                for (r, l) in lambda.iter_mut().enumerate().take(self.rows) {
                    *l = self.right[self.row_place[r]];
                }
            }
            Factor::Qr(qr) => {
                for (c, v) in self.columns.iter().enumerate() {
                    self.right[c] = tau[*v];
                }
                qr.solve_transposed(&self.right[..n], &mut lambda[..self.rows]);
            }
        }
    }

    /// Dimension of the null space of `J_fᵀ`: how many multipliers are free.
    pub(crate) fn nullity(&self) -> usize {
        match &self.factor {
            Factor::Lu(_) => 0,
            Factor::Qr(qr) => self.rows - qr.rank(),
        }
    }
    /// An orthonormal basis of that null space, one number a row.
    pub(crate) fn null_vectors(&self) -> Vec<Vec<f64>> {
        let vector = |i: usize| {
            let mut lambda = vec![0.0; self.rows];
            if let Factor::Qr(qr) = &self.factor {
                qr.null_transposed(i, &mut lambda);
            }
            lambda
        };
        (0..self.nullity()).map(vector).collect()
    }

    /// `J u` over the prescribed columns (the others of `u` do not count).
    pub(crate) fn multiply_known<S: Space<T = f64>>(&self, rows: &Rows<S>, u: &[f64], out: &mut [f64]) {
        out[..self.rows].fill(0.0);
        for &(entry, row, v) in &self.known {
            out[row] += rows.block[entry] * u[v];
        }
        for i in 0..rows.coupling.len() + self.extra.len() {
            let (r, v, value) = self.single_entry(rows, i);
            if self.free[v] == OUT {
                out[r] += value * u[v];
            }
        }
    }

    /// `Jᵀ λ` in the prescribed columns, into those components of `out` (nv).
    pub(crate) fn multiply_known_transposed<S: Space<T = f64>>(&self, rows: &Rows<S>, lambda: &[f64], out: &mut [f64]) {
        out.fill(0.0);
        for &(entry, row, v) in &self.known {
            out[v] += rows.block[entry] * lambda[row];
        }
        for i in 0..rows.coupling.len() + self.extra.len() {
            let (r, v, value) = self.single_entry(rows, i);
            if self.free[v] == OUT {
                out[v] += value * lambda[r];
            }
        }
    }

    /// Sign of the determinant, up to a constant of the system; 1 where redundant.
    pub(crate) fn determinant_sign(&self) -> f64 {
        match &self.factor {
            Factor::Lu(lu) => lu.determinant_sign(),
            Factor::Qr(_) => 1.0,
        }
    }

    /// The matrix over free columns, by rows, for singular values.
    pub(crate) fn dense<S: Space<T = f64>>(&self, mech: &Mechanism<S>, rows: &Rows<S>) -> Vec<Vec<f64>> {
        let mut a = vec![vec![0.0; self.columns.len()]; self.rows];
        let mut put = |r: usize, v: usize, value: f64| {
            if self.free[v] != OUT {
                a[r][self.free[v]] += value;
            }
        };
        rows.each(mech, &mut put);
        self.extra.iter().for_each(|&(r, v, value)| put(r, v, value));
        a
    }
}

type Ordered = (Vec<usize>, Vec<usize>, Factor);

fn order<S: Space<T = f64>>(
    mech: &Mechanism<S>,
    rows: &Rows<S>,
    free: &[usize],
    prescribed: &[Prescribed],
    n: usize,
) -> Ordered {
    if n <= DENSE {
        return ((0..n).collect(), (0..n).collect(), Factor::Lu(BandLu::new(n, n, n)));
    }
    let mut pattern = vec![Vec::new(); n];
    let mut put = |r: usize, v: usize| {
        if free[v] != OUT {
            pattern[r].push(free[v]);
        }
    };
    rows.each(mech, |r, v, _| put(r, v));
    for p in prescribed {
        if let Prescribed::Row(row, Source::Measured { link, .. }) = p {
            mech.links[*link].columns.iter().for_each(|&v| put(*row, v));
        }
    }
    let o = band_ordering(&pattern, n);
    (o.row, o.column, Factor::Lu(BandLu::new(n, o.below, o.above)))
}
