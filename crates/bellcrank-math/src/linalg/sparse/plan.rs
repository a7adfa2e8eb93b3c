//! What a factorization does, found from the pattern alone.

use std::ops::Range;

use super::quotient::{Lists, Quotient};
use super::supernodes::{self, Supernodes, triangle};
use super::tree::{self, NONE};
use super::{SymmetricMatrix, dissection};

/// The order of elimination of a symmetric matrix, its supernodes and their sizes: all that does not depend on numbers.
///
/// Rows with the same pattern are taken together, the graph of the rest is dissected, and columns of the factor with nearly
/// the same pattern become supernodes: dense blocks of `columns` columns and `rows` rows.
#[derive(Clone, Debug, Default)]
pub struct Plan {
    pub(super) size: usize,
    /// Row of the matrix at each place of the elimination.
    pub(super) order: Vec<u32>,
    /// First place of each supernode's columns; one more than there are supernodes.
    pub(super) firsts: Vec<usize>,
    /// Places of the rows below each supernode's own, ascending.
    pub(super) below: Lists,
    /// Supernode that takes each one's update, or `NONE`.
    pub(super) parent: Vec<u32>,
    /// Supernodes whose updates each one takes.
    pub(super) children: Lists,
    /// Where each supernode's block begins in the factor; one more than there are supernodes.
    pub(super) blocks: Vec<usize>,
    /// The lower triangle in elimination order: place of the row of each entry, by place of the column.
    pub(super) entries: Lists,
    /// Which value of the matrix each of `entries` is.
    pub(super) sources: Vec<u32>,
}

impl Plan {
    /// The plan of a matrix; its values do not matter.
    ///
    /// # Panics
    /// When the matrix has 2³² entries or more.
    pub fn new(matrix: &SymmetricMatrix) -> Self {
        assert!(u32::try_from(matrix.rows.len()).is_ok(), "a matrix of less than 2^32 entries");
        let graph = Quotient::new(matrix);
        let order = dissection::order(&graph.neighbours);
        Self::ordered(matrix, &graph, &order)
    }

    fn ordered(matrix: &SymmetricMatrix, graph: &Quotient, order: &[u32]) -> Self {
        let supernodes = supernodes_of(graph, order);
        let order = expand(&supernodes.vertices.items, graph);
        let place = places(&order);
        let below = rows_below(graph, &supernodes);
        let firsts = firsts(graph, &supernodes);
        let mut blocks = vec![0];
        for s in 0..supernodes.parent.len() {
            let columns = firsts[s + 1] - firsts[s];
            blocks.push(blocks[s] + columns * (columns + below.get(s).len()));
        }
        let (entries, sources) = permuted(matrix, &place);
        let (parent, (children, _)) = (supernodes.parent.clone(), tree::children(&supernodes.parent));
        Self { size: matrix.size, order, firsts, below, parent, children, blocks, entries, sources }
    }

    /// Number of rows and columns.
    pub fn size(&self) -> usize {
        self.size
    }

    /// Row of the matrix at each place of the elimination.
    pub fn order(&self) -> &[u32] {
        &self.order
    }

    /// Number of supernodes.
    pub fn supernodes(&self) -> usize {
        self.parent.len()
    }

    /// Entries of the factor that are stored.
    pub fn factor_entries(&self) -> usize {
        self.blocks.last().copied().unwrap_or(0)
    }

    /// Multiplications and additions of a factorization.
    pub fn flops(&self) -> f64 {
        (0..self.supernodes()).map(|s| self.supernode_flops(s)).sum()
    }

    /// Σ (rows left)² over the columns of a supernode.
    pub(super) fn supernode_flops(&self, s: usize) -> f64 {
        let (columns, rows) = self.shape(s);
        let sum = |n: f64| n * (n + 1.0) * (2.0 * n + 1.0) / 6.0;
        sum(rows as f64) - sum((rows - columns) as f64)
    }

    /// Bytes in use at the peak of a factorization by one thread: factor, update matrices and plan.
    pub fn memory(&self) -> usize {
        8 * (self.factor_entries() + self.waiting(0..self.supernodes()).1) + self.own_memory()
    }

    /// Bytes of the plan itself.
    pub fn own_memory(&self) -> usize {
        4 * (self.order.len() + self.below.items.len() + self.entries.items.len() + self.sources.len())
            + 8 * (self.firsts.len() + self.below.starts.len() + self.entries.starts.len() + self.blocks.len())
    }

    /// Columns and rows of a supernode's block.
    pub(super) fn shape(&self, s: usize) -> (usize, usize) {
        let columns = self.firsts[s + 1] - self.firsts[s];
        (columns, columns + self.below.get(s).len())
    }

    /// For a whole subtree: most entries of update matrices that wait at a time, and most with the square under work.
    pub(super) fn waiting(&self, subtree: Range<usize>) -> (usize, usize) {
        let (mut now, mut waiting, mut most, mut square) = (0_usize, 0, 0, 0);
        for s in subtree {
            let size = self.below.get(s).len();
            square = square.max(size * size);
            most = most.max(now + square);
            let children = self.children.get(s).iter();
            now -= children.map(|&c| triangle(self.below.get(c as usize).len())).sum::<usize>();
            now += triangle(size);
            waiting = waiting.max(now);
        }
        (waiting, most.max(waiting + square))
    }
}

fn supernodes_of(graph: &Quotient, order: &[u32]) -> Supernodes {
    let parent = tree::elimination_tree(&graph.neighbours, order, &places(order));
    let (children, roots) = tree::children(&parent);
    let post = tree::postorder(&children, &roots);
    let order: Vec<u32> = post.iter().map(|&j| order[j as usize]).collect();
    let number = places(&post);
    let parent: Vec<u32> =
        post.iter().map(|&j| parent[j as usize]).map(|p| if p == NONE { NONE } else { number[p as usize] }).collect();
    let counts = tree::column_counts(graph, &order, &places(&order), &parent);
    supernodes::find(graph, &order, &parent, &counts)
}

/// Place of each item of an order.
fn places(order: &[u32]) -> Vec<u32> {
    let mut place = vec![0; order.len()];
    order.iter().enumerate().for_each(|(k, &i)| place[i as usize] = k as u32);
    place
}

/// Rows of the matrix, vertex by vertex.
fn expand(vertices: &[u32], graph: &Quotient) -> Vec<u32> {
    vertices.iter().flat_map(|&v| graph.members.get(v as usize).iter().copied()).collect()
}

fn firsts(graph: &Quotient, supernodes: &Supernodes) -> Vec<usize> {
    let mut firsts = vec![0];
    for s in 0..supernodes.parent.len() {
        let columns: usize = supernodes.vertices.get(s).iter().map(|&v| graph.weight(v as usize)).sum();
        firsts.push(firsts[s] + columns);
    }
    firsts
}

/// Places of the rows below each supernode: neighbours of its vertices and rows of its children that come later.
fn rows_below(graph: &Quotient, supernodes: &Supernodes) -> Lists {
    let place = places(&supernodes.vertices.items);
    let (children, _) = tree::children(&supernodes.parent);
    let mut seen = vec![NONE; place.len()];
    let mut below = Lists { starts: vec![0], items: Vec::new() };
    for s in 0..supernodes.parent.len() {
        let end = supernodes.vertices.starts[s + 1] as u32;
        let begin = below.items.len();
        let mut add = |k: u32, items: &mut Vec<u32>| {
            if k >= end && std::mem::replace(&mut seen[k as usize], s as u32) != s as u32 {
                items.push(k);
            }
        };
        for &v in supernodes.vertices.get(s) {
            graph.neighbours.get(v as usize).iter().for_each(|&n| add(place[n as usize], &mut below.items));
        }
        for &c in children.get(s) {
            for at in below.starts[c as usize]..below.starts[c as usize + 1] {
                add(below.items[at], &mut below.items);
            }
        }
        below.items[begin..].sort_unstable();
        below.starts.push(below.items.len());
    }
    expand_rows(graph, supernodes, &below)
}

/// Places of vertices turned into places of their rows.
fn expand_rows(graph: &Quotient, supernodes: &Supernodes, below: &Lists) -> Lists {
    let order = &supernodes.vertices.items;
    let mut begin = vec![0_u32];
    order.iter().for_each(|&v| begin.push(begin[begin.len() - 1] + graph.weight(v as usize) as u32));
    let mut rows = Lists { starts: vec![0], items: Vec::new() };
    for s in 0..below.len() {
        rows.items.extend(below.get(s).iter().flat_map(|&k| begin[k as usize]..begin[k as usize + 1]));
        rows.starts.push(rows.items.len());
    }
    rows
}

/// The lower triangle in elimination order, and which value each entry is.
fn permuted(matrix: &SymmetricMatrix, place: &[u32]) -> (Lists, Vec<u32>) {
    let mut lengths = vec![0; matrix.size];
    let each = |visit: &mut dyn FnMut(usize, u32, u32)| {
        for column in 0..matrix.size {
            for entry in matrix.starts[column]..matrix.starts[column + 1] {
                let (a, b) = (place[column], place[matrix.rows[entry] as usize]);
                visit(entry, a.min(b), a.max(b));
            }
        }
    };
    each(&mut |_, column, _| lengths[column as usize] += 1);
    let mut entries = Lists::with_lengths(lengths.into_iter());
    let mut next = entries.starts.clone();
    let mut sources = vec![0; matrix.rows.len()];
    each(&mut |entry, column, row| {
        let at = next[column as usize];
        next[column as usize] += 1;
        entries.items[at] = row;
        sources[at] = entry as u32;
    });
    (entries, sources)
}
