//! The Cholesky factorization of a sparse matrix, supernode by supernode.
//!
//! Duff & Reid (1983), "The multifrontal solution of indefinite sparse symmetric linear equations"; Liu (1992), "The
//! multifrontal method for sparse matrix solution: theory and practice"; Geist & Ng (1989), "Task scheduling for parallel
//! sparse Cholesky factorization".

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};

use rayon::prelude::*;

use super::front::{Crew, Small, eliminate};
use super::tree::NONE;
use super::worker::Worker;
use super::{Plan, SymmetricMatrix};

/// A pivot below this share of what the diagonal was before the elimination counts as zero. The stiffness at the tip of a
/// strip 0.5 mm thick and 1 m long is some 1e-9 of its diagonal; a solid free to move leaves, of either sign, 1e-15 to 5e-11
/// (measured on free bricks of 7,000 unknowns). Larger parts may leave more: a caller who can tell by geometry that a part
/// is loose does well to ask first.
pub const SMALLEST_PIVOT: f64 = 1e-10;

/// How often progress is told at most.
const REPORTS: f64 = 500.0;

/// A row at which the matrix shows not to be positive definite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct NotPositive {
    /// Row of the matrix.
    pub row: usize,
    /// What is left of its diagonal after the elimination of the rows before it.
    pub pivot: f64,
    /// Its diagonal in the matrix.
    pub diagonal: f64,
}

/// Why there is no factorization.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Failure {
    /// The matrix is singular or indefinite, to rounding.
    NotPositive(NotPositive),
    /// The caller's progress function asked to stop.
    Interrupted,
}

/// Told the share of work done, from 0 to 1, from any thread; returns whether to go on.
pub type Progress<'a> = &'a (dyn Fn(f64) -> bool + Sync);

/// A sparse symmetric positive definite matrix as P A Pᵀ = L Lᵀ.
#[derive(Clone, Debug)]
pub struct Cholesky {
    pub(super) plan: Arc<Plan>,
    /// Blocks of the supernodes, each by columns.
    pub(super) blocks: Vec<f64>,
}

impl Cholesky {
    /// Factors a matrix with the pattern of the plan, on `threads` threads (1: on the caller's own). The factor is the same
    /// to the last bit for any number of threads.
    ///
    /// # Errors
    /// When a pivot falls below [`SMALLEST_PIVOT`] of its diagonal, or when `progress` returns false.
    pub fn factor(
        plan: Arc<Plan>,
        matrix: &SymmetricMatrix,
        threads: usize,
        progress: Progress,
    ) -> Result<Self, Failure> {
        let mut blocks = vec![0.0; plan.factor_entries()];
        Work::new(&plan, matrix, progress).run(&mut blocks, threads)?;
        Ok(Self { plan, blocks })
    }

    /// Factors another matrix of the same pattern in the same memory.
    ///
    /// # Errors
    /// As [`Cholesky::factor`]; the factorization is of no use then.
    pub fn refactor(&mut self, matrix: &SymmetricMatrix, threads: usize, progress: Progress) -> Result<(), Failure> {
        self.blocks.fill(0.0);
        Work::new(&self.plan, matrix, progress).run(&mut self.blocks, threads)
    }

    /// The plan it follows.
    pub fn plan(&self) -> &Arc<Plan> {
        &self.plan
    }
}

/// A factorization under way.
struct Work<'a> {
    plan: &'a Plan,
    matrix: &'a SymmetricMatrix,
    /// Smallest pivot allowed at each place.
    least: Vec<f64>,
    progress: Progress<'a>,
    flops: f64,
    done: AtomicU64,
    stop: AtomicBool,
}

/// Pieces of the factor's storage and whose they are.
type Parts<'b, T> = Vec<(T, &'b mut [f64])>;

/// Supernodes `first..end`: a subtree, its root last.
#[derive(Clone, Copy, Debug)]
struct Subtree {
    first: usize,
    end: usize,
    flops: f64,
}

impl<'a> Work<'a> {
    fn new(plan: &'a Plan, matrix: &'a SymmetricMatrix, progress: Progress<'a>) -> Self {
        let diagonal = |&row: &u32| matrix.values[matrix.starts[row as usize]];
        // A diagonal that is not positive fails whatever is left of it.
        let least = plan.order.iter().map(|row| (SMALLEST_PIVOT * diagonal(row)).max(f64::MIN_POSITIVE)).collect();
        let (flops, done, stop) = (plan.flops(), AtomicU64::new(0), AtomicBool::new(false));
        Self { plan, matrix, least, progress, flops, done, stop }
    }

    fn run(&self, blocks: &mut [f64], threads: usize) -> Result<(), Failure> {
        let pool = (threads > 1).then(|| rayon::ThreadPoolBuilder::new().num_threads(threads).build().ok()).flatten();
        match pool {
            Some(pool) => pool.install(|| self.shared(blocks, threads)),
            None => self.alone(blocks),
        }
    }

    fn alone(&self, blocks: &mut [f64]) -> Result<(), Failure> {
        let all = Subtree { first: 0, end: self.plan.supernodes(), flops: self.flops };
        self.subtree(all, blocks).map(|_| ()).map_err(|(_, failure)| failure)
    }

    /// Subtrees side by side, then what is above them one after another with shared tiles.
    fn shared(&self, blocks: &mut [f64], threads: usize) -> Result<(), Failure> {
        let mut subtrees = self.subtrees(threads);
        subtrees.sort_by_key(|subtree| subtree.first);
        let (mut parts, mut tops) = self.cut(blocks, &subtrees);
        let mut saved = vec![Vec::new(); self.plan.supernodes()];
        parts.sort_by(|a, b| b.0.flops.total_cmp(&a.0.flops));
        let updates: Vec<_> = parts
            .into_par_iter()
            .with_max_len(1)
            .map(|(subtree, blocks)| (subtree.end - 1, self.subtree(subtree, blocks)))
            .collect();
        let mut failure = None;
        for (root, update) in updates {
            match update {
                Ok(update) => saved[root] = update,
                Err(new) => failure = Some(first_of(failure, new)),
            }
        }
        let mut worker = Worker::new(self.plan, self.matrix, 0);
        for (s, block) in &mut tops {
            if failure.is_some_and(|(at, _)| at < *s) {
                break;
            }
            self.supernode(&mut worker, *s, block, &mut saved, &Crew { shared: true })?;
        }
        failure.map_or(Ok(()), |(_, failure)| Err(failure))
    }

    /// Blocks of each subtree, and of each supernode above them.
    fn cut<'b>(&self, blocks: &'b mut [f64], subtrees: &[Subtree]) -> (Parts<'b, Subtree>, Parts<'b, usize>) {
        let (mut parts, mut tops) = (Vec::new(), Vec::new());
        let (mut rest, mut next, mut s) = (blocks, subtrees.iter().peekable(), 0);
        while s < self.plan.supernodes() {
            let subtree = next.next_if(|subtree| subtree.first == s);
            let end = subtree.map_or(s + 1, |subtree| subtree.end);
            let (own, after) = rest.split_at_mut(self.plan.blocks[end] - self.plan.blocks[s]);
            match subtree {
                Some(&subtree) => parts.push((subtree, own)),
                None => tops.push((s, own)),
            }
            (rest, s) = (after, end);
        }
        (parts, tops)
    }

    /// Disjoint subtrees, heaviest split until no one holds a large share of the work.
    fn subtrees(&self, threads: usize) -> Vec<Subtree> {
        let all = self.all_subtrees();
        let roots = (0..all.len()).filter(|&s| self.plan.parent[s] == NONE);
        let mut open: Vec<Subtree> = roots.map(|s| all[s]).collect();
        let total: f64 = open.iter().map(|subtree| subtree.flops).sum();
        while let Some(k) = (0..open.len()).max_by(|&a, &b| open[a].flops.total_cmp(&open[b].flops)) {
            if open[k].flops * (4 * threads) as f64 <= total || open.len() > 64 * threads {
                break;
            }
            let split = open.swap_remove(k);
            open.extend(self.plan.children.get(split.end - 1).iter().map(|&c| all[c as usize]));
        }
        open
    }

    fn all_subtrees(&self) -> Vec<Subtree> {
        let count = self.plan.supernodes();
        let own = |s: usize| Subtree { first: s, end: s + 1, flops: self.plan.supernode_flops(s) };
        let mut all: Vec<Subtree> = (0..count).map(own).collect();
        for s in 0..count {
            let below = all[s];
            if self.plan.parent[s] != NONE {
                let above = &mut all[self.plan.parent[s] as usize];
                above.first = above.first.min(below.first);
                above.flops += below.flops;
            }
        }
        all
    }

    /// Factors a subtree and returns what its root passes on.
    fn subtree(&self, subtree: Subtree, blocks: &mut [f64]) -> Result<Vec<f64>, (usize, Failure)> {
        let mut worker = Worker::new(self.plan, self.matrix, self.plan.waiting(subtree.first..subtree.end).0);
        let mut rest = blocks;
        for s in subtree.first..subtree.end {
            let (block, after) = rest.split_at_mut(self.plan.blocks[s + 1] - self.plan.blocks[s]);
            rest = after;
            self.supernode(&mut worker, s, block, &mut [], &Crew { shared: false }).map_err(|failure| (s, failure))?;
        }
        Ok(worker.stack)
    }

    fn supernode(
        &self,
        worker: &mut Worker,
        s: usize,
        block: &mut [f64],
        saved: &mut [Vec<f64>],
        crew: &Crew,
    ) -> Result<(), Failure> {
        self.go_on()?;
        let places = self.plan.firsts[s]..self.plan.firsts[s + 1];
        worker.assemble(s, block, saved);
        let (columns, rows) = self.plan.shape(s);
        let below = rows - columns;
        eliminate(block, rows, &self.least[places.clone()], &mut worker.update[..below * below], crew)
            .map_err(|small| self.not_positive(places.start + small.column, small))?;
        worker.pass_on(s);
        self.report(s);
        Ok(())
    }

    fn go_on(&self) -> Result<(), Failure> {
        if self.stop.load(Ordering::Relaxed) { Err(Failure::Interrupted) } else { Ok(()) }
    }

    /// Tells the caller when another part of the work is done.
    fn report(&self, s: usize) {
        let own = self.plan.supernode_flops(s);
        let before = self.done.fetch_add(own as u64, Ordering::Relaxed) as f64;
        let part = |flops: f64| (flops * REPORTS / self.flops).floor();
        if part(before) < part(before + own) && !(self.progress)(((before + own) / self.flops).min(1.0)) {
            self.stop.store(true, Ordering::Relaxed);
        }
    }

    fn not_positive(&self, place: usize, small: Small) -> Failure {
        let row = self.plan.order[place] as usize;
        let diagonal = self.matrix.values[self.matrix.starts[row]];
        Failure::NotPositive(NotPositive { row, pivot: small.pivot, diagonal })
    }
}

/// The failure that comes first in the elimination, so that all numbers of threads tell the same.
fn first_of(known: Option<(usize, Failure)>, new: (usize, Failure)) -> (usize, Failure) {
    match known {
        Some(known) if known.0 <= new.0 => known,
        _ => new,
    }
}
