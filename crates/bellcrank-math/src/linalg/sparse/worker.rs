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
    relative: Vec<u32>,
    /// The update under construction: a square by columns, its lower triangle used.
    pub(super) update: Vec<f64>,
    /// Updates that wait for their parents: lower triangles by columns, one after another.
    pub(super) stack: Vec<f64>,
}

impl<'a> Worker<'a> {
    pub(super) fn new(plan: &'a Plan, matrix: &'a SymmetricMatrix) -> Self {
        let position = vec![0; plan.size];
        Self { plan, matrix, position, relative: Vec::new(), update: Vec::new(), stack: Vec::new() }
    }

    /// Sums the entries of the matrix and the updates of the children into a block of zeros and into `update`. The children
    /// left theirs on the stack, or in `saved` where another thread made them.
    pub(super) fn assemble(&mut self, s: usize, block: &mut [f64], saved: &mut [Vec<f64>]) {
        let (columns, rows) = self.plan.shape(s);
        self.locate(s);
        self.enter_matrix(s, rows, block);
        self.update.clear();
        self.update.resize((rows - columns) * (rows - columns), 0.0);
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
        let places = self.plan.below.get(child);
        self.relative.clear();
        self.relative.extend(places.iter().map(|&place| self.position[place as usize]));
        let below = rows - columns;
        for (j, &column) in self.relative.iter().enumerate() {
            let (values, rest) = triangle.split_at(places.len() - j);
            triangle = rest;
            let column = column as usize;
            let (target, shift) = if column < columns {
                (&mut block[column * rows..(column + 1) * rows], 0)
            } else {
                (&mut self.update[(column - columns) * below..(column - columns + 1) * below], columns)
            };
            for (value, &row) in values.iter().zip(&self.relative[j..]) {
                target[row as usize - shift] += value;
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
