//! Dense steps of a supernode: its columns are eliminated from its own block and from the update it passes on.
//!
//! All work is cut into tiles of fixed size, whoever does them: the numbers do not depend on how many threads there are.

use faer::linalg::cholesky::llt::factor::{LltError, LltParams, cholesky_in_place, cholesky_in_place_scratch};
use faer::linalg::matmul::triangular::{self, BlockStructure};
use faer::linalg::{matmul, triangular_solve};
use faer::prelude::{Reborrow, ReborrowMut};
use faer::{Accum, MatMut, MatRef, Par, Spec};
use rayon::prelude::*;

/// Columns eliminated at a time.
const BLOCK: usize = 128;
/// Columns of a tile of a trailing matrix.
const STRIP: usize = 256;
/// Rows of a tile below a diagonal block.
const ROWS: usize = 512;

/// A pivot that is too small, by its column within the supernode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Small {
    pub(super) column: usize,
    pub(super) pivot: f64,
}

/// What the dense steps ask of their surroundings.
pub(super) struct Crew {
    /// Tiles go to all threads of the pool, or stay with this one.
    pub(super) shared: bool,
}

impl Crew {
    fn each<T: Send>(&self, tiles: Vec<T>, work: impl Fn(T) + Send + Sync) {
        if self.shared && tiles.len() > 1 {
            tiles.into_par_iter().for_each(work);
        } else {
            tiles.into_iter().for_each(work);
        }
    }
}

/// Factors the leading `columns` of a block of `rows` rows, stored by columns, and takes their products from `update`, the
/// lower triangle of a square of the `rows - columns` rows below. `least[j]` is the smallest pivot that column `j` may have.
pub(super) fn eliminate(
    block: &mut [f64],
    rows: usize,
    least: &[f64],
    update: &mut [f64],
    crew: &Crew,
) -> Result<(), Small> {
    let columns = least.len();
    for first in (0..columns).step_by(BLOCK) {
        let width = BLOCK.min(columns - first);
        let (done, ahead) = block.split_at_mut((first + width) * rows);
        let strip = MatMut::from_column_major_slice_mut(&mut done[first * rows..], rows, width);
        let (mut diagonal, mut below) = strip.submatrix_mut(first, 0, rows - first, width).split_at_row_mut(width);
        factor(diagonal.rb_mut(), &least[first..first + width])
            .map_err(|small| Small { column: first + small.column, ..small })?;
        solve_rows(diagonal.rb(), below.rb_mut(), crew);
        if !ahead.is_empty() {
            let ahead = MatMut::from_column_major_slice_mut(ahead, rows, columns - first - width);
            let ahead = ahead.split_at_row_mut(first + width).1;
            subtract_products(ahead, below.rb(), crew);
        }
    }
    let below = rows - columns;
    if below > 0 {
        let block = MatRef::from_column_major_slice(block, rows, columns);
        subtract_products(
            MatMut::from_column_major_slice_mut(update, below, below),
            block.split_at_row(columns).1,
            crew,
        );
    }
    Ok(())
}

/// A = L Lᵀ in place of the lower triangle.
fn factor(mut diagonal: MatMut<'_, f64>, least: &[f64]) -> Result<(), Small> {
    let params = Spec::<LltParams, f64>::default();
    let mut memory = faer::dyn_stack::MemBuffer::new(cholesky_in_place_scratch::<f64>(least.len(), Par::Seq, params));
    let stack = faer::dyn_stack::MemStack::new(&mut memory);
    let result = cholesky_in_place(diagonal.rb_mut(), Default::default(), Par::Seq, stack, params);
    let done = match result {
        Ok(_) => least.len(),
        Err(LltError::NonPositivePivot { index }) => index,
    };
    let pivot = |j: usize| diagonal[(j, j)] * diagonal[(j, j)];
    if let Some(column) = (0..done).find(|&j| pivot(j) < least[j] || pivot(j).is_nan()) {
        return Err(Small { column, pivot: pivot(column) });
    }
    // The failing pivot is left where it stood.
    if done < least.len() { Err(Small { column: done, pivot: diagonal[(done, done)] }) } else { Ok(()) }
}

/// B ← B L⁻ᵀ.
fn solve_rows(lower: MatRef<'_, f64>, below: MatMut<'_, f64>, crew: &Crew) {
    let solve = |tile: MatMut<'_, f64>| {
        triangular_solve::solve_lower_triangular_in_place(lower, tile.transpose_mut(), Par::Seq);
    };
    crew.each(row_tiles(below), solve);
}

fn row_tiles(mut matrix: MatMut<'_, f64>) -> Vec<MatMut<'_, f64>> {
    let mut tiles = Vec::new();
    while matrix.nrows() > ROWS {
        let (tile, rest) = matrix.split_at_row_mut(ROWS);
        tiles.push(tile);
        matrix = rest;
    }
    tiles.push(matrix);
    tiles
}

/// C ← C − B Bᵀ in the lower triangle of the leading columns of C, as many as it has.
fn subtract_products(target: MatMut<'_, f64>, factor: MatRef<'_, f64>, crew: &Crew) {
    crew.each(strips(target), |(first, strip)| {
        let width = strip.ncols();
        let (diagonal, below) = strip.split_at_row_mut(width);
        let (own, rest) = factor.split_at_row(first).1.split_at_row(width);
        let (lower, full) = (BlockStructure::TriangularLower, BlockStructure::Rectangular);
        triangular::matmul(diagonal, lower, Accum::Add, own, full, own.transpose(), full, -1.0, Par::Seq);
        matmul::matmul(below, Accum::Add, rest, own.transpose(), -1.0, Par::Seq);
    });
}

/// Strips of columns from their diagonals down, with their first column.
fn strips(mut matrix: MatMut<'_, f64>) -> Vec<(usize, MatMut<'_, f64>)> {
    let mut strips = Vec::new();
    let mut first = 0;
    while matrix.ncols() > 0 {
        let width = STRIP.min(matrix.ncols());
        let (strip, rest) = matrix.split_at_col_mut(width);
        strips.push((first, strip));
        matrix = rest.split_at_row_mut(width).1;
        first += width;
    }
    strips
}
