//! Stiffness and mass matrices of a part.

use bellcrank_math::linalg::sparse::SymmetricMatrix;

use crate::element::{Block3, ElementMatrix, Geometry};
use crate::numbering::{Numbering, Tie};
use crate::vector::{self, V3};
use crate::{Part, Support};

/// Which matrix.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    Stiffness,
    Mass,
}

/// Which groups share an element: for each group those after it.
pub(crate) struct Pattern {
    starts: Vec<usize>,
    neighbours: Vec<u32>,
    /// Rows before each neighbour's in a column of the group.
    offsets: Vec<u32>,
    columns: Vec<usize>,
}

impl Pattern {
    pub(crate) fn new(part: &Part<'_>, numbering: &Numbering) -> Self {
        let touching = Touching::new(part, numbering);
        let groups = numbering.groups.len();
        let mut pattern = Self {
            starts: vec![0],
            neighbours: Vec::new(),
            offsets: Vec::new(),
            columns: Vec::with_capacity(numbering.equations + 1),
        };
        let (mut seen, mut found) = (vec![u32::MAX; groups], Vec::new());
        let mut entries = 0;
        for group in 0..groups {
            found.clear();
            touching.neighbours(part, numbering, group, &mut seen, &mut found);
            found.sort_unstable();
            let count = usize::from(numbering.groups[group].count);
            let mut rows = 0;
            for &other in &found {
                pattern.neighbours.push(other);
                pattern.offsets.push(rows);
                rows += u32::from(numbering.groups[other as usize].count);
            }
            for column in 0..count {
                pattern.columns.push(entries);
                entries += count - column + rows as usize;
            }
            pattern.starts.push(pattern.neighbours.len());
        }
        pattern.columns.push(entries);
        pattern
    }

    /// A matrix of zeros.
    fn matrix(&self, numbering: &Numbering) -> SymmetricMatrix {
        let entries = self.columns.last().copied().unwrap_or(0);
        let mut rows = Vec::with_capacity(entries);
        for (index, group) in numbering.groups.iter().enumerate() {
            let end = group.first + u32::from(group.count);
            for column in group.first..end {
                rows.extend(column..end);
                for &other in &self.neighbours[self.starts[index]..self.starts[index + 1]] {
                    let other = numbering.groups[other as usize];
                    rows.extend(other.first..other.first + u32::from(other.count));
                }
            }
        }
        SymmetricMatrix { size: numbering.equations, starts: self.columns.clone(), rows, values: vec![0.0; entries] }
    }
}

/// Elements of each group, as (block, element).
struct Touching {
    starts: Vec<usize>,
    elements: Vec<(u32, u32)>,
}

impl Touching {
    fn new(part: &Part<'_>, numbering: &Numbering) -> Self {
        let mut counts = vec![0_usize; numbering.groups.len() + 1];
        let each = |call: &mut dyn FnMut(usize, (u32, u32))| {
            let mut groups = Vec::new();
            for (b, block) in part.mesh.blocks.iter().enumerate() {
                for (e, element) in block.elements().enumerate() {
                    groups.clear();
                    groups.extend(element.iter().map(|&node| numbering.ties[node as usize].group));
                    groups.sort_unstable();
                    groups.dedup();
                    groups.iter().for_each(|&group| call(group as usize, (b as u32, e as u32)));
                }
            }
        };
        each(&mut |group, _| counts[group + 1] += 1);
        for group in 1..counts.len() {
            counts[group] += counts[group - 1];
        }
        let mut fill = counts.clone();
        let mut elements = vec![(0, 0); counts.last().copied().unwrap_or(0)];
        each(&mut |group, element| {
            elements[fill[group]] = element;
            fill[group] += 1;
        });
        Self { starts: counts, elements }
    }

    /// Groups after `group` that share an element with it.
    fn neighbours(&self, part: &Part<'_>, numbering: &Numbering, group: usize, seen: &mut [u32], found: &mut Vec<u32>) {
        for &(block, element) in &self.elements[self.starts[group]..self.starts[group + 1]] {
            for &node in part.mesh.blocks[block as usize].element(element as usize) {
                let other = numbering.ties[node as usize].group;
                if other as usize > group && seen[other as usize] != group as u32 {
                    seen[other as usize] = group as u32;
                    found.push(other);
                }
            }
        }
    }
}

/// The stiffness or mass matrix; `threads` work on ranges of columns, so that the sum of every entry is formed in the
/// same order for any number of them.
pub(crate) fn matrix(
    part: &Part<'_>,
    numbering: &Numbering,
    pattern: &Pattern,
    kind: Kind,
    threads: usize,
) -> SymmetricMatrix {
    let mut matrix = pattern.matrix(numbering);
    let mut values = std::mem::take(&mut matrix.values);
    let bounds = ranges(pattern, numbering, threads.max(1));
    std::thread::scope(|scope| {
        let mut rest = values.as_mut_slice();
        let mut done = 0;
        for window in bounds.windows(2) {
            let end = entry(pattern, numbering, window[1]);
            let (own, after) = rest.split_at_mut(end - done);
            let slice = Slice { part, numbering, pattern, groups: window[0]..window[1], base: done, values: own };
            (rest, done) = (after, end);
            if bounds.len() == 2 {
                slice.run(kind);
            } else {
                scope.spawn(move || slice.run(kind));
            }
        }
    });
    matrix.values = values;
    matrix
}

/// Where the columns of a group begin.
fn entry(pattern: &Pattern, numbering: &Numbering, group: usize) -> usize {
    let equation = numbering.groups.get(group).map_or(numbering.equations, |group| group.first as usize);
    pattern.columns[equation]
}

/// Bounds of ranges of groups with about as many entries each.
fn ranges(pattern: &Pattern, numbering: &Numbering, count: usize) -> Vec<usize> {
    let total = pattern.columns.last().copied().unwrap_or(0);
    let groups: Vec<usize> = (0..numbering.groups.len()).collect();
    let mut bounds: Vec<usize> = (0..count)
        .map(|k| groups.partition_point(|&group| entry(pattern, numbering, group) < total * k / count))
        .collect();
    bounds.push(numbering.groups.len());
    bounds.dedup();
    bounds
}

/// The columns of a range of groups.
struct Slice<'a> {
    part: &'a Part<'a>,
    numbering: &'a Numbering,
    pattern: &'a Pattern,
    groups: std::ops::Range<usize>,
    base: usize,
    values: &'a mut [f64],
}

impl Slice<'_> {
    fn run(mut self, kind: Kind) {
        let (mut geometry, mut own) = (Geometry::default(), ElementMatrix::new());
        let part = self.part;
        for (block, material) in part.mesh.blocks.iter().zip(&part.materials) {
            for element in block.elements() {
                if !self.touches(element) {
                    continue;
                }
                geometry.set(block.shape, element, &part.mesh.nodes);
                match kind {
                    Kind::Stiffness => own.stiffness(&mut geometry, &material.stiffness),
                    Kind::Mass => own.mass(&mut geometry, material.density),
                }
                self.scatter(element, &own);
            }
        }
        if kind == Kind::Stiffness {
            self.springs();
        }
    }

    fn tie(&self, node: u32) -> &Tie {
        &self.numbering.ties[node as usize]
    }

    /// The column of a pair is that of its lower group.
    fn touches(&self, element: &[u32]) -> bool {
        element.iter().any(|&node| self.groups.contains(&(self.tie(node).group as usize)))
    }

    fn scatter(&mut self, element: &[u32], own: &ElementMatrix) {
        let mut place = 0;
        for (a, &na) in element.iter().enumerate() {
            for (b, &nb) in element.iter().enumerate().skip(a) {
                self.add(na, nb, &own.blocks[place], a == b);
                place += 1;
            }
        }
    }

    fn springs(&mut self) {
        let part = self.part;
        for support in &part.supports {
            if let Support::Spring { nodes, stiffness } = support {
                for &node in nodes {
                    let mut block = [[0.0; 3]; 3];
                    (0..3).for_each(|i| block[i][i] = stiffness[i] / nodes.len() as f64);
                    self.add(node, node, &block, true);
                }
            }
        }
    }

    /// Adds the block of two nodes, rows of the first and columns of the second, to the lower triangle.
    fn add(&mut self, a: u32, b: u32, block: &Block3, diagonal: bool) {
        let numbering = self.numbering;
        let (ta, tb) = (&numbering.ties[a as usize], &numbering.ties[b as usize]);
        let column = ta.group.min(tb.group) as usize;
        if !self.groups.contains(&column) {
            return;
        }
        let (low, high, turned) = if ta.group <= tb.group { (ta, tb, true) } else { (tb, ta, false) };
        // `turned`: rows belong to the second node, so the block is read transposed.
        let at = |row: usize, column: usize| if turned { block[column][row] } else { block[row][column] };
        if low.group == high.group {
            self.add_own(low, high, &at, diagonal);
        } else {
            self.add_pair(low, high, &at);
        }
    }

    fn add_pair(&mut self, low: &Tie, high: &Tie, at: &impl Fn(usize, usize) -> f64) {
        let (group, pattern) = (low.group as usize, self.pattern);
        let list = &pattern.neighbours[pattern.starts[group]..pattern.starts[group + 1]];
        let Ok(found) = list.binary_search(&high.group) else { return };
        let offset = pattern.offsets[pattern.starts[group] + found] as usize;
        let (columns, first) = (self.count(low), self.numbering.groups[group].first as usize);
        for column in 0..columns {
            let start = pattern.columns[first + column] - self.base + (columns - column) + offset;
            if let (None, None) = (&low.columns, &high.columns) {
                (0..3).for_each(|row| self.values[start + row] += at(row, column));
                continue;
            }
            for row in 0..self.count(high) {
                self.values[start + row] += project(high, row, low, column, at);
            }
        }
    }

    /// A pair within one group: one node with itself, or two nodes of one frame (then both orders).
    fn add_own(&mut self, a: &Tie, b: &Tie, at: &impl Fn(usize, usize) -> f64, diagonal: bool) {
        let first = self.numbering.groups[a.group as usize].first as usize;
        let count = self.count(a);
        for column in 0..count {
            let start = self.pattern.columns[first + column] - self.base;
            for row in column..count {
                let mut value = project(b, row, a, column, at);
                if !diagonal {
                    value += project(b, column, a, row, at);
                }
                self.values[start + row - column] += value;
            }
        }
    }

    fn count(&self, tie: &Tie) -> usize {
        usize::from(self.numbering.groups[tie.group as usize].count)
    }
}

/// Column `row` of one tie, transposed, times a block, times column `column` of the other.
fn project(high: &Tie, row: usize, low: &Tie, column: usize, at: &impl Fn(usize, usize) -> f64) -> f64 {
    let (left, right) = (direction(high, row), direction(low, column));
    let times: V3 = std::array::from_fn(|i| (0..3).map(|j| at(i, j) * right[j]).sum());
    vector::dot(left, times)
}

fn direction(tie: &Tie, component: usize) -> V3 {
    match &tie.columns {
        None => std::array::from_fn(|i| f64::from(i == component)),
        Some(columns) => columns[component],
    }
}

/// Without the entries that are zero everywhere but on the diagonal: mass matrices couple like components only.
pub(crate) fn without_zeros(matrix: &SymmetricMatrix) -> SymmetricMatrix {
    let mut lean = SymmetricMatrix { size: matrix.size, starts: vec![0], ..SymmetricMatrix::default() };
    for column in 0..matrix.size {
        for entry in matrix.starts[column]..matrix.starts[column + 1] {
            if matrix.values[entry] != 0.0 || matrix.rows[entry] as usize == column {
                lean.rows.push(matrix.rows[entry]);
                lean.values.push(matrix.values[entry]);
            }
        }
        lean.starts.push(lean.rows.len());
    }
    lean
}
