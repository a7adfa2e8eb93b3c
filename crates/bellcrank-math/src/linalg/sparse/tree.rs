//! The elimination tree of a symmetric pattern and the lengths of the columns of its factor.
//!
//! Liu (1990), "The role of elimination trees in sparse factorization"; Gilbert, Ng & Peyton (1994), "An efficient algorithm
//! to compute row and column counts for sparse Cholesky factorization", as told by Davis (2006), "Direct Methods for Sparse
//! Linear Systems", chapter 4.

use super::quotient::{Lists, Quotient};

/// No parent, no child, not yet.
pub(super) const NONE: u32 = u32::MAX;

/// Parent of each vertex in the elimination tree, vertices numbered by `place` (place of each vertex in the order `order`).
pub(super) fn elimination_tree(neighbours: &Lists, order: &[u32], place: &[u32]) -> Vec<u32> {
    let mut parent = vec![NONE; order.len()];
    let mut ancestor = vec![NONE; order.len()];
    for i in 0..order.len() as u32 {
        for &neighbour in neighbours.get(order[i as usize] as usize) {
            let mut k = place[neighbour as usize];
            while k != NONE && k < i {
                let next = ancestor[k as usize];
                ancestor[k as usize] = i;
                if next == NONE {
                    parent[k as usize] = i;
                }
                k = next;
            }
        }
    }
    parent
}

/// Children of each vertex, ascending, and the roots.
pub(super) fn children(parent: &[u32]) -> (Lists, Vec<u32>) {
    let mut lengths = vec![0; parent.len()];
    parent.iter().filter(|&&p| p != NONE).for_each(|&p| lengths[p as usize] += 1);
    let mut lists = Lists::with_lengths(lengths.into_iter());
    let mut next = lists.starts.clone();
    let mut roots = Vec::new();
    for (child, &p) in parent.iter().enumerate() {
        if p == NONE {
            roots.push(child as u32);
        } else {
            lists.items[next[p as usize]] = child as u32;
            next[p as usize] += 1;
        }
    }
    (lists, roots)
}

/// Vertices in an order where children stand before their parents and subtrees together.
pub(super) fn postorder(children: &Lists, roots: &[u32]) -> Vec<u32> {
    let mut order = Vec::with_capacity(children.len());
    let mut stack: Vec<u32> = roots.iter().rev().copied().collect();
    let mut entered = vec![false; children.len()];
    while let Some(&vertex) = stack.last() {
        if std::mem::replace(&mut entered[vertex as usize], true) {
            order.push(vertex);
            stack.pop();
        } else {
            stack.extend(children.get(vertex as usize).iter().rev());
        }
    }
    order
}

/// Rows in each column of the factor, the diagonal's own among them, in rows of the matrix (vertices count by their weight).
/// Vertices are numbered in postorder.
pub(super) fn column_counts(graph: &Quotient, order: &[u32], place: &[u32], parent: &[u32]) -> Vec<usize> {
    let count = order.len();
    let first = first_descendants(parent);
    let weight = |j: usize| graph.weight(order[j] as usize) as i64;
    let leaf = |j: usize| first[j] as usize == j;
    let mut delta: Vec<i64> = (0..count).map(|j| if leaf(j) { weight(j) } else { 0 }).collect();
    let mut deepest = vec![NONE; count]; // largest first descendant among the neighbours of each row so far
    let mut previous = vec![NONE; count]; // last leaf of each row's subtree so far
    let mut ancestor: Vec<u32> = (0..count as u32).collect();
    for j in 0..count {
        if parent[j] != NONE {
            delta[parent[j] as usize] -= weight(j);
        }
        for &neighbour in graph.neighbours.get(order[j] as usize) {
            let i = place[neighbour as usize] as usize;
            if i <= j || (deepest[i] != NONE && first[j] <= deepest[i]) {
                continue;
            }
            deepest[i] = first[j];
            delta[j] += weight(i);
            let last = std::mem::replace(&mut previous[i], j as u32);
            if last != NONE {
                delta[find(&mut ancestor, last) as usize] -= weight(i);
            }
        }
        if parent[j] != NONE {
            ancestor[j] = parent[j];
        }
    }
    for j in 0..count {
        if parent[j] != NONE {
            delta[parent[j] as usize] += delta[j];
        }
    }
    delta.into_iter().map(|d| d as usize).collect()
}

/// The first vertex of each subtree, vertices numbered in postorder.
fn first_descendants(parent: &[u32]) -> Vec<u32> {
    let mut first: Vec<u32> = (0..parent.len() as u32).collect();
    for j in 0..parent.len() {
        if parent[j] != NONE {
            let p = parent[j] as usize;
            first[p] = first[p].min(first[j]);
        }
    }
    first
}

/// Root of the set of a vertex, with path compression.
fn find(ancestor: &mut [u32], vertex: u32) -> u32 {
    let mut root = vertex;
    while ancestor[root as usize] != root {
        root = ancestor[root as usize];
    }
    let mut k = vertex;
    while k != root {
        k = std::mem::replace(&mut ancestor[k as usize], root);
    }
    root
}
