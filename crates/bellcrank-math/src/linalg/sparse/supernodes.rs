//! Columns of a factor with (nearly) the same pattern, taken together as dense blocks, and the tree of them.
//!
//! Ashcraft & Grimes (1989), "The influence of relaxed supernode partitions on the multifrontal method"; Liu (1992), "The
//! multifrontal method for sparse matrix solution: theory and practice".

use super::quotient::{Lists, Quotient};
use super::tree::{self, NONE};

/// A set of vertices eliminated together.
#[derive(Clone, Debug, Default)]
struct Group {
    /// Vertices in the order of elimination.
    vertices: Vec<u32>,
    /// Columns of the matrix in them.
    columns: usize,
    /// Columns and rows below them.
    rows: usize,
    /// Entries of the dense block that are structurally zero.
    zeros: usize,
}

/// The order of elimination cut into supernodes, in postorder.
#[derive(Clone, Debug, Default)]
pub(super) struct Supernodes {
    /// Vertices of each supernode; one list after another is the order of elimination.
    pub(super) vertices: Lists,
    /// Supernode in whose block the rows below begin, or `NONE`.
    pub(super) parent: Vec<u32>,
}

/// Supernodes of a graph for an order of its vertices that is a postorder of its elimination tree.
pub(super) fn find(graph: &Quotient, order: &[u32], parent: &[u32], counts: &[usize]) -> Supernodes {
    let (mut groups, mut up) = fundamental(graph, order, parent, counts);
    amalgamate(&mut groups, &mut up);
    arrange(&groups, &up)
}

/// Maximal chains of vertices with nested patterns, and the parent of each chain.
fn fundamental(graph: &Quotient, order: &[u32], parent: &[u32], counts: &[usize]) -> (Vec<Group>, Vec<u32>) {
    let mut groups: Vec<Group> = Vec::new();
    let mut of = vec![0_u32; order.len()];
    let mut last = Vec::new();
    for j in 0..order.len() {
        let weight = graph.weight(order[j] as usize);
        let nested =
            j > 0 && parent[j - 1] as usize == j && counts[j - 1] == counts[j] + graph.weight(order[j - 1] as usize);
        if !nested {
            groups.push(Group { rows: counts[j], ..Group::default() });
            last.push(j);
        }
        let own = groups.len() - 1;
        of[j] = own as u32;
        last[own] = j;
        groups[own].vertices.push(order[j]);
        groups[own].columns += weight;
    }
    let up = last.iter().map(|&j| if parent[j] == NONE { NONE } else { of[parent[j] as usize] }).collect();
    (groups, up)
}

/// Largest share of structural zeros a merged block may hold, by its number of columns: a wide block must be nearly full, a
/// narrow one costs more in overhead than in zeros.
const ZEROS: [(usize, f64); 4] = [(8, 0.9), (24, 0.3), (64, 0.12), (usize::MAX, 0.05)];

/// Merges groups into their parents, from the leaves up, cheapest child first, while the zeros stay few.
fn amalgamate(groups: &mut [Group], up: &mut [u32]) {
    let (mut children, _) = child_lists(up);
    for p in 0..groups.len() {
        let mut open = std::mem::take(&mut children[p]);
        let mut kept = Vec::new();
        while let Some(best) = (0..open.len()).min_by_key(|&k| added_zeros(&groups[open[k] as usize], &groups[p])) {
            let child = open.swap_remove(best) as usize;
            if !worth_merging(&groups[child], &groups[p]) {
                kept.push(child as u32);
                continue;
            }
            let below = std::mem::take(&mut groups[child]);
            merge(below, &mut groups[p]);
            for grandchild in std::mem::take(&mut children[child]) {
                up[grandchild as usize] = p as u32;
                kept.push(grandchild);
            }
        }
        children[p] = kept;
    }
}

fn child_lists(up: &[u32]) -> (Vec<Vec<u32>>, Vec<u32>) {
    let (lists, roots) = tree::children(up);
    ((0..up.len()).map(|p| lists.get(p).to_vec()).collect(), roots)
}

/// Zeros that a merger adds: the child's columns reach down to the parent's last row.
fn added_zeros(child: &Group, parent: &Group) -> usize {
    child.columns * (parent.rows + child.columns - child.rows)
}

fn worth_merging(child: &Group, parent: &Group) -> bool {
    let (columns, rows) = (child.columns + parent.columns, child.columns + parent.rows);
    let zeros = child.zeros + parent.zeros + added_zeros(child, parent);
    let entries = columns * rows - columns * (columns - 1) / 2;
    ZEROS.iter().any(|&(widest, share)| columns <= widest && (zeros as f64) <= share * entries as f64)
}

/// The child's columns are eliminated just before the parent's.
fn merge(mut child: Group, parent: &mut Group) {
    parent.zeros += child.zeros + added_zeros(&child, parent);
    parent.rows += child.columns;
    parent.columns += child.columns;
    child.vertices.append(&mut parent.vertices);
    parent.vertices = child.vertices;
}

/// The groups that are left in a postorder that keeps the stack of update matrices low: of the children of a node, the one
/// whose work exceeds what it leaves behind by most goes first (Liu 1986, "On the storage requirement in the out-of-core
/// multifrontal method").
fn arrange(groups: &[Group], up: &[u32]) -> Supernodes {
    let (mut children, roots) = child_lists(up);
    let alive = |g: u32| !groups[g as usize].vertices.is_empty();
    let mut peak = vec![0_usize; groups.len()];
    for g in 0..groups.len() {
        let left = |c: u32| triangle(groups[c as usize].rows - groups[c as usize].columns);
        children[g].retain(|&c| alive(c));
        children[g].sort_by_key(|&c| std::cmp::Reverse(peak[c as usize] - left(c)));
        let mut held = 0;
        for &c in &children[g] {
            peak[g] = peak[g].max(held + peak[c as usize]);
            held += left(c);
        }
        peak[g] = peak[g].max(held).max(left(g as u32));
    }
    let mut lists = Lists::with_lengths(children.iter().map(Vec::len));
    lists.items = children.into_iter().flatten().collect();
    let roots: Vec<u32> = roots.into_iter().filter(|&g| alive(g)).collect();
    numbered(groups, up, &tree::postorder(&lists, &roots))
}

/// Entries of a lower triangle.
pub(super) fn triangle(size: usize) -> usize {
    size * (size + 1) / 2
}

fn numbered(groups: &[Group], up: &[u32], order: &[u32]) -> Supernodes {
    let mut number = vec![NONE; groups.len()];
    order.iter().enumerate().for_each(|(k, &g)| number[g as usize] = k as u32);
    let mut vertices = Lists::with_lengths(order.iter().map(|&g| groups[g as usize].vertices.len()));
    vertices.items = order.iter().flat_map(|&g| groups[g as usize].vertices.iter().copied()).collect();
    let number_of = |g: u32| if g == NONE { NONE } else { number[g as usize] };
    Supernodes { vertices, parent: order.iter().map(|&g| number_of(up[g as usize])).collect() }
}
