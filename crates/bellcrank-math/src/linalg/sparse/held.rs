//! Systems under linear constraints: K u + Cᵀ λ = f, C u = d.

use nalgebra::{DMatrix, DVector, Dyn, FullPivLU};

use super::Cholesky;

/// A factored matrix, bordered with constraints; exact, no penalty.
///
/// K itself may be singular where the constraints hold what it leaves free. What is factored then is K + S, with S as many
/// springs to ground as K has motions Z without strain: forces in balance do not feel them. With u = (K + S)⁻¹ (f − Cᵀ λ) + Z α
/// it remains to find λ and α from C u = d and Zᵀ (f − Cᵀ λ) = 0, which is small and dense.
pub struct Held<'a> {
    factor: &'a Cholesky,
    size: usize,
    /// Columns of Cᵀ, one after another.
    constraints: Vec<f64>,
    /// (K + S)⁻¹ Cᵀ.
    answers: Vec<f64>,
    /// Z, one motion after another.
    motions: Vec<f64>,
    /// Orthonormal vectors that span the columns of Cᵀ.
    directions: Vec<Vec<f64>>,
    /// The border's matrix, its rows and columns times `scale`.
    border: FullPivLU<f64, Dyn, Dyn>,
    scale: Vec<f64>,
}

impl<'a> Held<'a> {
    /// `constraints` are rows of C, `motions` the vectors Z that K does not resist (none where it was factored as it is), each
    /// of the matrix's size, one after another; there is at least one constraint. `None` when constraints depend on each other, or do not hold the motions.
    pub fn new(factor: &'a Cholesky, constraints: Vec<f64>, motions: Vec<f64>) -> Option<Self> {
        let size = factor.plan().size();
        let mut answers = constraints.clone();
        factor.solve(&mut answers);
        let (rows, free) = (constraints.len() / size, motions.len() / size);
        let mut border = DMatrix::zeros(rows + free, rows + free);
        for (i, c) in constraints.chunks_exact(size).enumerate() {
            for (j, answer) in answers.chunks_exact(size).enumerate() {
                border[(i, j)] = dot(c, answer);
            }
            for (k, z) in motions.chunks_exact(size).enumerate() {
                (border[(i, rows + k)], border[(rows + k, i)]) = (-dot(c, z), -dot(c, z));
            }
        }
        let mut scale: Vec<f64> = (0..rows).map(|i| 1.0 / border[(i, i)].sqrt()).collect();
        for k in rows..rows + free {
            let moved = (0..rows).map(|i| (scale[i] * border[(i, k)]).powi(2)).sum::<f64>();
            scale.push(1.0 / moved.sqrt());
        }
        let scaled = DMatrix::from_fn(rows + free, rows + free, |i, j| border[(i, j)] * scale[i] * scale[j]);
        let border = scaled.full_piv_lu();
        let pivots = border.u().diagonal();
        let (least, most) = (pivots.iter().fold(f64::INFINITY, |m, p| m.min(p.abs())), pivots.amax());
        let directions = span(&constraints, size);
        let sound = rows == 0 || least > 1e-12 * most && directions.len() == rows;
        sound.then_some(Self { factor, size, constraints, answers, motions, directions, border, scale })
    }

    /// How many vectors the constraints leave.
    pub fn dimension(&self) -> usize {
        self.size - self.directions.len()
    }

    /// Solves in place; `rhs` holds right-hand sides f one after another, `wanted` their d (empty: all zero). The multipliers
    /// λ, as many for each right-hand side as there are constraints.
    ///
    /// # Panics
    /// When the length of `rhs` is no multiple of the matrix's size.
    pub fn solve(&self, rhs: &mut [f64], wanted: &[f64]) -> Vec<f64> {
        let (size, rows) = (self.size, self.directions.len());
        let pushed: Vec<Vec<f64>> =
            rhs.chunks_exact(size).map(|f| self.motions.chunks_exact(size).map(|z| -dot(z, f)).collect()).collect();
        self.factor.solve(rhs);
        let mut multipliers = Vec::with_capacity(rows * pushed.len());
        for (case, (u, pushed)) in rhs.chunks_exact_mut(size).zip(pushed).enumerate() {
            let wanted = |i: usize| wanted.get(case * rows + i).copied().unwrap_or(0.0);
            let moved = self.constraints.chunks_exact(size).enumerate().map(|(i, c)| dot(c, u) - wanted(i));
            let unknowns = self.bordered(moved.chain(pushed));
            self.add(u, &unknowns);
            multipliers.extend_from_slice(&unknowns[..rows]);
        }
        multipliers
    }

    fn bordered(&self, rhs: impl Iterator<Item = f64>) -> Vec<f64> {
        let rhs: Vec<f64> = rhs.zip(&self.scale).map(|(b, s)| b * s).collect();
        let Some(x) = self.border.solve(&DVector::from_vec(rhs)) else { return vec![f64::NAN; self.scale.len()] };
        x.iter().zip(&self.scale).map(|(x, s)| x * s).collect()
    }

    /// u ← u − (K + S)⁻¹ Cᵀ λ + Z α
    fn add(&self, u: &mut [f64], unknowns: &[f64]) {
        let (multipliers, shares) = unknowns.split_at(self.directions.len());
        for (answer, multiplier) in self.answers.chunks_exact(self.size).zip(multipliers) {
            u.iter_mut().zip(answer).for_each(|(u, a)| *u -= multiplier * a);
        }
        for (motion, share) in self.motions.chunks_exact(self.size).zip(shares) {
            u.iter_mut().zip(motion).for_each(|(u, z)| *u += share * z);
        }
    }

    /// Takes out of forces what constraints can hold.
    pub fn without_held(&self, forces: &mut [f64]) {
        for direction in &self.directions {
            let part = dot(direction, forces);
            forces.iter_mut().zip(direction).for_each(|(f, d)| *f -= part * d);
        }
    }
}

/// Orthonormal vectors with the same span (Gram and Schmidt, twice); those that depend on others are left out.
fn span(columns: &[f64], size: usize) -> Vec<Vec<f64>> {
    let mut found: Vec<Vec<f64>> = Vec::new();
    for column in columns.chunks_exact(size) {
        let mut own = column.to_vec();
        let before = dot(&own, &own).sqrt();
        for _ in 0..2 {
            for other in &found {
                let part = dot(other, &own);
                own.iter_mut().zip(other).for_each(|(x, o)| *x -= part * o);
            }
        }
        let left = dot(&own, &own).sqrt();
        if left > 1e-10 * before {
            own.iter_mut().for_each(|x| *x /= left);
            found.push(own);
        }
    }
    found
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}
