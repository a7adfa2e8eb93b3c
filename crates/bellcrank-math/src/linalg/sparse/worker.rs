//! The assembly of a supernode from the matrix and from what its children pass on.

use super::supernodes::triangle;
use super::{Plan, SymmetricMatrix};

/// The memory of one thread at work.
pub(super) struct Worker<'a> {
    plan: &'a Plan,
    matrix: &'a SymmetricMatrix,
    /// Row of the block under construction, by place.
    position: Vec<u32>,
    /// Rows of a child in its parent's block.
    runs: Vec<Run>,
    /// The update under construction: a square by columns at the beginning, its lower triangle used.
    pub(super) update: Vec<f64>,
    /// Updates that wait for their parents: lower triangles by columns, one after another.
    pub(super) stack: Vec<f64>,
}

/// Rows that follow each other in a child and in its parent's block.
#[derive(Clone, Copy)]
struct Run {
    /// First row in the parent's block.
    parent: usize,
    length: usize,
}

/// Adds the first numbers of a list to a column from a row on; returns the rest of the list.
fn add<'b>(column: &mut [f64], row: usize, list: &'b [f64], length: usize) -> &'b [f64] {
    let (now, rest) = list.split_at(length);
    column[row..row + length].iter_mut().zip(now).for_each(|(target, value)| *target += value);
    rest
}

impl<'a> Worker<'a> {
    /// A worker with room for `stack` numbers of updates that wait.
    pub(super) fn new(plan: &'a Plan, matrix: &'a SymmetricMatrix, stack: usize) -> Self {
        let position = vec![0; plan.size];
        Self { plan, matrix, position, runs: Vec::new(), update: Vec::new(), stack: Vec::with_capacity(stack) }
    }

    /// Sums the entries of the matrix and the updates of the children into a block of zeros and into `update`. The children
    /// left theirs on the stack, or in `saved` where another thread made them.
    pub(super) fn assemble(&mut self, s: usize, block: &mut [f64], saved: &mut [Vec<f64>]) {
        let (columns, rows) = self.plan.shape(s);
        self.locate(s);
        self.enter_matrix(s, rows, block);
        self.clear_update(rows - columns);
        for &child in self.plan.children.get(s).iter().rev() {
            let child = child as usize;
            match saved.get_mut(child).map(std::mem::take).filter(|update| !update.is_empty()) {
                Some(update) => self.extend_add(child, &update, columns, rows, block),
                None => self.pop_child(child, columns, rows, block),
            }
        }
    }

    fn locate(&mut self, s: usize) {
        let own = self.plan.firsts[s] as u32..self.plan.firsts[s + 1] as u32;
        for (row, place) in own.chain(self.plan.below.get(s).iter().copied()).enumerate() {
            self.position[place as usize] = row as u32;
        }
    }

    /// Zeros in the lower triangle of the update. The memory only grows: what is new is zero as it comes.
    fn clear_update(&mut self, size: usize) {
        let old = self.update.len().min(size * size);
        self.update.resize(self.update.len().max(size * size), 0.0);
        for (j, column) in self.update[..old].chunks_mut(size.max(1)).enumerate() {
            let from = j.min(column.len());
            column[from..].fill(0.0);
        }
    }

    fn enter_matrix(&self, s: usize, rows: usize, block: &mut [f64]) {
        let first = self.plan.firsts[s];
        for (place, column) in (first..self.plan.firsts[s + 1]).zip(block.chunks_exact_mut(rows)) {
            let entries = self.plan.entries.starts[place]..self.plan.entries.starts[place + 1];
            for (&row, &source) in self.plan.entries.items[entries.clone()].iter().zip(&self.plan.sources[entries]) {
                column[self.position[row as usize] as usize] = self.matrix.values[source as usize];
            }
        }
    }

    fn pop_child(&mut self, child: usize, columns: usize, rows: usize, block: &mut [f64]) {
        let start = self.stack.len() - triangle(self.plan.below.get(child).len());
        let stack = std::mem::take(&mut self.stack);
        self.extend_add(child, &stack[start..], columns, rows, block);
        self.stack = stack;
        self.stack.truncate(start);
    }

    /// Adds a child's lower triangle where its rows are in the block and the update.
    fn extend_add(&mut self, child: usize, mut triangle: &[f64], columns: usize, rows: usize, block: &mut [f64]) {
        self.find_runs(child);
        let below = rows - columns;
        for (k, run) in self.runs.iter().enumerate() {
            for j in 0..run.length {
                let column = run.parent + j;
                let (target, shift) = if column < columns {
                    (&mut block[column * rows..(column + 1) * rows], 0)
                } else {
                    (&mut self.update[(column - columns) * below..(column - columns + 1) * below], columns)
                };
                // Of this run the rows from the diagonal down, then all of those after it.
                triangle = add(target, column - shift, triangle, run.length - j);
                for later in &self.runs[k + 1..] {
                    triangle = add(target, later.parent - shift, triangle, later.length);
                }
            }
        }
    }

    /// Rows of a child that stand together in its parent's block.
    fn find_runs(&mut self, child: usize) {
        self.runs.clear();
        for &place in self.plan.below.get(child) {
            let parent = self.position[place as usize] as usize;
            match self.runs.last_mut() {
                Some(run) if run.parent + run.length == parent => run.length += 1,
                _ => self.runs.push(Run { parent, length: 1 }),
            }
        }
    }

    /// Puts the update on the stack.
    pub(super) fn pass_on(&mut self, s: usize) {
        let size = self.plan.below.get(s).len();
        for j in 0..size {
            self.stack.extend_from_slice(&self.update[j * size + j..(j + 1) * size]);
        }
    }
}
