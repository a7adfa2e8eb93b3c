//! Rows of a symmetric matrix with the same pattern, taken together.
//!
//! The three displacements of a node have neighbours in common, so a graph of nodes has a third of the vertices and a
//! ninth of the edges of the matrix. Ordering and elimination tree are found on it. Ashcraft (1995), "Compressed graphs and
//! the minimum degree algorithm".

use super::SymmetricMatrix;

/// Lists of numbers, one after another: list `i` is `items[starts[i]..starts[i + 1]]`.
#[derive(Clone, Debug, Default)]
pub(super) struct Lists {
    pub(super) starts: Vec<usize>,
    pub(super) items: Vec<u32>,
}

impl Lists {
    /// Lists with room for the given number of items, all zero.
    pub(super) fn with_lengths(lengths: impl Iterator<Item = usize>) -> Self {
        let mut starts = vec![0];
        let mut total = 0;
        starts.extend(lengths.map(|length| {
            total += length;
            total
        }));
        Self { starts, items: vec![0; total] }
    }

    /// Items sorted into lists: `list[k]` is the list of item `k`.
    pub(super) fn by_list(list: &[u32], count: usize) -> Self {
        let mut lengths = vec![0; count];
        list.iter().for_each(|&l| lengths[l as usize] += 1);
        let mut sorted = Self::with_lengths(lengths.into_iter());
        let mut next = sorted.starts.clone();
        for (item, &l) in list.iter().enumerate() {
            sorted.items[next[l as usize]] = item as u32;
            next[l as usize] += 1;
        }
        sorted
    }

    pub(super) fn len(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn get(&self, i: usize) -> &[u32] {
        &self.items[self.starts[i]..self.starts[i + 1]]
    }
}

/// The graph of a symmetric matrix with rows of one pattern taken together.
#[derive(Clone, Debug, Default)]
pub(super) struct Quotient {
    /// Rows of the matrix in each vertex.
    pub(super) members: Lists,
    /// Neighbours of each vertex, both ways, ascending, without itself.
    pub(super) neighbours: Lists,
}

impl Quotient {
    pub(super) fn new(matrix: &SymmetricMatrix) -> Self {
        let (group, count) = same_pattern(matrix);
        let members = Lists::by_list(&group, count);
        let neighbours = both_ways(&one_way(matrix, &group, &members));
        Self { members, neighbours }
    }

    /// Rows of the matrix in a vertex.
    pub(super) fn weight(&self, vertex: usize) -> usize {
        self.members.starts[vertex + 1] - self.members.starts[vertex]
    }
}

/// A number for each row that differs where rows differ: the finalizer of `SplitMix64`.
fn scramble(row: u64) -> u64 {
    let mut z = (row + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
    z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
    z ^ (z >> 31)
}

/// Groups of rows with equal closed neighbourhoods, numbered by first appearance. Sums of scrambled row numbers are compared
/// instead of patterns: two that meet by chance would cost fill, not correctness, as edges are those of all members.
fn same_pattern(matrix: &SymmetricMatrix) -> (Vec<u32>, usize) {
    let mut sums: Vec<u64> = (0..matrix.size).map(|i| scramble(i as u64)).collect();
    for column in 0..matrix.size {
        let own = scramble(column as u64);
        let below = &matrix.rows[matrix.starts[column] + 1..matrix.starts[column + 1]];
        let mut sum = 0_u64;
        for &row in below {
            sum = sum.wrapping_add(scramble(u64::from(row)));
            sums[row as usize] = sums[row as usize].wrapping_add(own);
        }
        sums[column] = sums[column].wrapping_add(sum);
    }
    let mut numbers = std::collections::HashMap::with_capacity(matrix.size);
    let group = sums.iter().map(|sum| {
        let next = numbers.len() as u32;
        *numbers.entry(*sum).or_insert(next)
    });
    let group = group.collect();
    (group, numbers.len())
}

/// Edges between groups as the lower triangle has them, each once from the group of the column.
fn one_way(matrix: &SymmetricMatrix, group: &[u32], members: &Lists) -> Lists {
    let mut seen = vec![u32::MAX; members.len()];
    let mut edges = Lists { starts: vec![0], items: Vec::new() };
    for g in 0..members.len() {
        seen[g] = g as u32;
        for &column in members.get(g) {
            let column = column as usize;
            for &row in &matrix.rows[matrix.starts[column]..matrix.starts[column + 1]] {
                let other = group[row as usize];
                if seen[other as usize] != g as u32 {
                    seen[other as usize] = g as u32;
                    edges.items.push(other);
                }
            }
        }
        edges.starts.push(edges.items.len());
    }
    edges
}

/// Every edge in both lists, ascending, once.
fn both_ways(edges: &Lists) -> Lists {
    let count = edges.len();
    let mut lengths: Vec<usize> = (0..count).map(|i| edges.get(i).len()).collect();
    edges.items.iter().for_each(|&j| lengths[j as usize] += 1);
    let mut both = Lists::with_lengths(lengths.into_iter());
    let mut next = both.starts.clone();
    for i in 0..count {
        for &j in edges.get(i) {
            for (from, to) in [(i, j as usize), (j as usize, i)] {
                both.items[next[from]] = to as u32;
                next[from] += 1;
            }
        }
    }
    sorted_once(&both)
}

fn sorted_once(lists: &Lists) -> Lists {
    let mut out = Lists { starts: vec![0], items: Vec::with_capacity(lists.items.len()) };
    let mut list = Vec::new();
    for i in 0..lists.len() {
        list.clear();
        list.extend_from_slice(lists.get(i));
        list.sort_unstable();
        list.dedup();
        out.items.extend_from_slice(&list);
        out.starts.push(out.items.len());
    }
    out
}
