//! Lanczos vectors, orthonormal in the product of the mass.

use faer::linalg::matmul::matmul;
use faer::{Accum, MatMut, MatRef, Par};

use super::projected::Projected;
use crate::linalg::sparse::{Cholesky, Held, SymmetricMatrix};

/// A vector that keeps less than this of its length when what is known is taken out of it is lost to rounding.
const LOST: f64 = 1e-10;

/// What images are made with: (K − σM)⁻¹, or K⁻¹ on what constraints leave.
#[derive(Clone, Copy)]
pub(super) enum Inverse<'a> {
    Free(&'a Cholesky),
    Held(&'a Held<'a>),
}

impl Inverse<'_> {
    fn solve(self, block: &mut [f64]) {
        match self {
            Inverse::Free(factor) => factor.solve(block),
            Inverse::Held(held) => drop(held.solve(block, &[])),
        }
    }

    /// Of the space that images lie in.
    pub(super) fn dimension(self, size: usize) -> usize {
        match self {
            Inverse::Free(_) => size,
            Inverse::Held(held) => held.dimension(),
        }
    }

    /// Takes a random vector into the space that images lie in.
    fn bring(self, vector: &mut [f64]) {
        if let Inverse::Held(held) = self {
            held.solve(vector, &[]);
        }
    }
}

/// Blocks of vectors Q with Qᵀ M Q = I.
pub(super) struct Basis<'a> {
    mass: &'a SymmetricMatrix,
    inverse: Inverse<'a>,
    /// Of the space that the vectors lie in.
    dimension: usize,
    /// Vectors one after another; the last block's images are not known yet.
    vectors: Vec<f64>,
    /// M times the last block.
    heavy: Vec<f64>,
    /// Width of the last block.
    width: usize,
    /// Vectors that the basis may hold.
    most: usize,
    seed: u64,
    /// Right-hand sides solved.
    pub(super) solves: usize,
}

impl<'a> Basis<'a> {
    /// One block of random vectors, sent through the operator once.
    pub(super) fn start(mass: &'a SymmetricMatrix, inverse: Inverse<'a>, width: usize, most: usize) -> Self {
        let dimension = inverse.dimension(mass.size);
        let (vectors, heavy) = (Vec::new(), Vec::new());
        let mut basis = Self { mass, inverse, dimension, vectors, heavy, width: 0, most, seed: 1, solves: 0 };
        let mut block: Vec<f64> = (0..width * mass.size).map(|_| basis.random()).collect();
        inverse.solve(&mut block);
        basis.append(block, width);
        basis
    }

    /// Numbers between -1 and 1, the same in each run.
    fn random(&mut self) -> f64 {
        self.seed = self.seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.seed >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn count(&self) -> usize {
        self.vectors.len() / self.mass.size
    }

    /// No next block: the basis spans all there is.
    pub(super) fn complete(&self) -> bool {
        self.width == 0
    }

    /// No room for another block; a basis that may span everything is never full.
    pub(super) fn full(&self) -> bool {
        self.most < self.dimension && self.count() + self.width > self.most
    }

    /// Applies the operator to the last block and appends what is new in the images as the next one.
    pub(super) fn extend(&mut self, projected: &mut Projected) {
        let mut images = std::mem::take(&mut self.heavy);
        self.inverse.solve(&mut images);
        let width = self.width;
        self.solves += width;
        let (inside, outside) = self.append(images, width);
        projected.extend(inside, outside);
    }

    /// Appends the part of a block outside the basis; returns its coefficients inside and in the new block, by columns.
    ///
    /// Twice, since what is left after the first time may be small, and then is neither orthogonal nor normal.
    fn append(&mut self, mut block: Vec<f64>, width: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (size, known) = (self.mass.size, self.count());
        let room = width.min(self.dimension - known);
        let (mut inside, mut outside) = self.part(&mut block, width, room);
        block.truncate(room * size);
        let (correction, change) = self.part(&mut block, room, room);
        for (inside, outside) in inside.iter_mut().zip(&mut outside) {
            add_combination(inside, &correction, outside);
            let old = std::mem::replace(outside, vec![0.0; room]);
            add_combination(outside, &change, &old);
        }
        self.vectors.extend_from_slice(&block);
        self.width = room;
        (inside, outside)
    }

    /// Takes the basis out of a block and makes the first `room` vectors of it orthonormal; leaves M times them in `heavy`.
    fn part(&mut self, block: &mut [f64], width: usize, room: usize) -> (Vec<Vec<f64>>, Vec<Vec<f64>>) {
        let (size, known) = (self.mass.size, self.count());
        let mut heavy = vec![0.0; block.len()];
        self.mass.multiply(block, &mut heavy);
        let before: Vec<f64> = columns(block, size).zip(columns(&heavy, size)).map(|(x, mx)| length(x, mx)).collect();
        let inside = self.take_out(block, &heavy, width);
        self.mass.multiply(block, &mut heavy);
        let outside = self.orthonormalize(block, &mut heavy, &before, room);
        heavy.truncate(room * size);
        self.heavy = heavy;
        let inside = (0..width).map(|k| inside[k * known..(k + 1) * known].to_vec()).collect();
        (inside, outside)
    }

    /// B ← B − Q (Qᵀ M B); returns the coefficients by columns.
    fn take_out(&self, block: &mut [f64], heavy: &[f64], width: usize) -> Vec<f64> {
        let (size, known) = (self.mass.size, self.count());
        let basis = MatRef::from_column_major_slice(&self.vectors, size, known);
        let mut part = vec![0.0; known * width];
        let coefficients = MatMut::from_column_major_slice_mut(&mut part, known, width);
        let heavy = MatRef::from_column_major_slice(heavy, size, width);
        matmul(coefficients, Accum::Replace, basis.transpose(), heavy, 1.0, Par::Seq);
        let coefficients = MatRef::from_column_major_slice(&part, known, width);
        let block = MatMut::from_column_major_slice_mut(block, size, width);
        matmul(block, Accum::Add, basis, coefficients, -1.0, Par::Seq);
        part
    }

    /// Makes the first `room` vectors of a block orthonormal, and M times them along; returns the coefficients of the old
    /// vectors in the new ones. A vector without a part of its own gives way to a random one.
    fn orthonormalize(&mut self, block: &mut [f64], heavy: &mut [f64], before: &[f64], room: usize) -> Vec<Vec<f64>> {
        let size = self.mass.size;
        let mut coefficients = vec![vec![0.0; room]; before.len()];
        for k in 0..before.len() {
            let (done, own) = block.split_at_mut(k * size);
            let (done_heavy, own_heavy) = heavy.split_at_mut(k * size);
            let (own, own_heavy) = (&mut own[..size], &mut own_heavy[..size]);
            let earlier = k.min(room) * size;
            for _ in 0..2 {
                for (i, (q, mq)) in
                    columns(&done[..earlier], size).zip(columns(&done_heavy[..earlier], size)).enumerate()
                {
                    let along = dot(mq, own);
                    coefficients[k][i] += along;
                    subtract(own, along, q);
                    subtract(own_heavy, along, mq);
                }
            }
            if k >= room {
                continue;
            }
            let length = length(own, own_heavy);
            if length > LOST * before[k] {
                coefficients[k][k] = length;
                scale(own, 1.0 / length);
                scale(own_heavy, 1.0 / length);
            } else {
                self.replace(own, own_heavy, &done[..earlier], &done_heavy[..earlier]);
            }
        }
        coefficients
    }

    /// A random unit vector orthogonal to the basis and to what there is of the next block.
    fn replace(&mut self, own: &mut [f64], heavy: &mut [f64], done: &[f64], done_heavy: &[f64]) {
        let size = self.mass.size;
        own.iter_mut().for_each(|x| *x = self.random());
        self.inverse.bring(own);
        for _ in 0..3 {
            self.mass.multiply(own, heavy);
            self.take_out(own, heavy, 1);
            for (q, mq) in columns(done, size).zip(columns(done_heavy, size)) {
                let along = dot(mq, own);
                subtract(own, along, q);
            }
            self.mass.multiply(own, heavy);
            let length = length(own, heavy).max(f64::MIN_POSITIVE);
            scale(own, 1.0 / length);
            scale(heavy, 1.0 / length);
        }
    }

    /// Sums of basis vectors (without the last block) by coefficients, one after another.
    pub(super) fn combine(&self, coefficients: &[f64], count: usize) -> Vec<f64> {
        let (size, known) = (self.mass.size, self.count() - self.width);
        let mut sums = vec![0.0; size * count];
        let basis = MatRef::from_column_major_slice(&self.vectors[..size * known], size, known);
        let coefficients = MatRef::from_column_major_slice(coefficients, known, count);
        let target = MatMut::from_column_major_slice_mut(&mut sums, size, count);
        matmul(target, Accum::Replace, basis, coefficients, 1.0, Par::Seq);
        sums
    }

    /// Keeps the leading eigenvectors of the projected operator and the last block.
    pub(super) fn restart(&mut self, projected: &mut Projected, keep: usize) {
        let size = self.mass.size;
        let kept = self.combine(&projected.leading(keep), keep);
        let last = self.vectors.split_off(self.vectors.len() - self.width * size);
        self.vectors = kept;
        self.vectors.extend(last);
        projected.restart(keep);
    }
}

fn columns(block: &[f64], size: usize) -> std::slice::ChunksExact<'_, f64> {
    block.chunks_exact(size)
}

fn length(x: &[f64], heavy: &[f64]) -> f64 {
    dot(x, heavy).max(0.0).sqrt()
}

/// target ← target + Σ columnₖ factorₖ
fn add_combination(target: &mut [f64], columns: &[Vec<f64>], factors: &[f64]) {
    for (column, factor) in columns.iter().zip(factors) {
        target.iter_mut().zip(column).for_each(|(t, c)| *t += factor * c);
    }
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    // Eight sums at a time, for the processor's vectors.
    let mut sums = [0.0; 8];
    let (a8, b8) = (a.chunks_exact(8), b.chunks_exact(8));
    let rest: f64 = a8.remainder().iter().zip(b8.remainder()).map(|(a, b)| a * b).sum();
    for (a, b) in a8.zip(b8) {
        for k in 0..8 {
            sums[k] += a[k] * b[k];
        }
    }
    rest + sums.iter().sum::<f64>()
}

fn subtract(target: &mut [f64], factor: f64, other: &[f64]) {
    target.iter_mut().zip(other).for_each(|(t, o)| *t -= factor * o);
}

fn scale(target: &mut [f64], factor: f64) {
    target.iter_mut().for_each(|t| *t *= factor);
}
