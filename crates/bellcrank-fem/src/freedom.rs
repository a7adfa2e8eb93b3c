//! Motions of the whole part that its supports leave free.

use bellcrank_math::linalg::dense;

use crate::numbering::rigid_motions;
use crate::vector::{self, V3};
use crate::{CouplingKind, FreeMotion, Part, Support};

/// Rigid motions of a part: six numbers are the displacement of a centre and the rotation times a length.
#[derive(Clone, Debug)]
pub(crate) struct Freedom {
    center: V3,
    length: f64,
    /// Motions that nothing resists, orthonormal in the six numbers.
    pub(crate) free: Vec<[f64; 6]>,
}

/// Which supports count.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Counting {
    /// Those that are in the stiffness matrix: all but the frames of distributing couplings.
    Matrix,
    /// All.
    All,
}

impl Freedom {
    pub(crate) fn new(part: &Part<'_>, counting: Counting) -> Self {
        let (center, length) = extent(&part.mesh.nodes);
        let mut freedom = Self { center, length, free: Vec::new() };
        let mut gram = vec![vec![0.0; 6]; 6];
        freedom.rows(part, counting, |row| {
            for i in 0..6 {
                (0..6).for_each(|j| gram[i][j] += row[i] * row[j]);
            }
        });
        let size = (0..6).map(|i| gram[i][i]).fold(0.0, f64::max);
        if size == 0.0 {
            freedom.free = (0..6).map(|k| std::array::from_fn(|i| f64::from(i == k))).collect();
        } else if let Some((values, vectors)) = dense::symmetric_eigen(&gram) {
            let free = values.iter().zip(&vectors).filter(|(value, _)| **value < 1e-12 * size);
            freedom.free = free.map(|(_, vector)| std::array::from_fn(|i| vector[i])).collect();
        }
        freedom
    }

    /// Calls back with what each held component reads of the six motions.
    fn rows(&self, part: &Part<'_>, counting: Counting, mut call: impl FnMut([f64; 6])) {
        let mut read = |at: V3, direction: V3| call(self.motions(at).map(|u| vector::dot(u, direction)));
        for support in &part.supports {
            match support {
                Support::Fixed { nodes, axes, values } => {
                    for &node in nodes {
                        let held = axes.iter().zip(values).filter(|(_, value)| value.is_some());
                        held.for_each(|(axis, _)| read(part.mesh.nodes[node as usize], *axis));
                    }
                }
                Support::Spring { nodes, stiffness } => {
                    for &node in nodes {
                        let stiff = (0..3).filter(|&i| stiffness[i] > 0.0);
                        stiff.for_each(|i| read(part.mesh.nodes[node as usize], unit(i)));
                    }
                }
            }
        }
        for coupling in &part.couplings {
            let counts = coupling.kind == CouplingKind::Rigid || counting == Counting::All;
            for k in (0..6).filter(|&k| counts && coupling.held[k].is_some()) {
                if k < 3 {
                    call(self.motions(coupling.reference).map(|u| u[k]));
                } else {
                    call(std::array::from_fn(|i| f64::from(i == k)));
                }
            }
        }
    }

    /// Displacement at a place for each of the six motions.
    fn motions(&self, at: V3) -> [V3; 6] {
        let mut motions = rigid_motions(vector::sub(at, self.center));
        motions[3..].iter_mut().for_each(|u| *u = vector::scale(*u, 1.0 / self.length));
        motions
    }

    /// Displacement at a place in one of the free motions.
    pub(crate) fn displacement(&self, motion: &[f64; 6], at: V3) -> V3 {
        let mut u = [0.0; 3];
        self.motions(at).iter().zip(motion).for_each(|(m, s)| vector::accumulate(&mut u, vector::scale(*m, *s)));
        u
    }

    /// Displacement and rotation of a frame at a place in one of the free motions.
    pub(crate) fn frame(&self, motion: &[f64; 6], at: V3) -> [f64; 6] {
        let u = self.displacement(motion, at);
        std::array::from_fn(|i| if i < 3 { u[i] } else { motion[i] / self.length })
    }

    /// The free motions in words: pure displacements first, then turns.
    pub(crate) fn described(&self) -> Vec<FreeMotion> {
        let turning: Vec<Vec<f64>> = (3..6).map(|i| self.free.iter().map(|motion| motion[i]).collect()).collect();
        let Some(svd) = dense::svd(&turning, self.free.len()) else { return Vec::new() };
        let mut found: Vec<FreeMotion> = Vec::new();
        let null = complement(&svd.right, &svd.values, self.free.len());
        let mix = |weights: &[f64]| -> [f64; 6] {
            std::array::from_fn(|i| self.free.iter().zip(weights).map(|(motion, w)| motion[i] * w).sum())
        };
        found.extend(null.iter().map(|weights| self.describe(mix(weights))));
        let turns = svd.right.iter().zip(&svd.values).filter(|(_, value)| **value > 1e-8);
        found.extend(turns.map(|(weights, _)| self.describe(mix(weights))));
        found
    }

    fn describe(&self, motion: [f64; 6]) -> FreeMotion {
        let t: V3 = std::array::from_fn(|i| motion[i]);
        let w: V3 = std::array::from_fn(|i| motion[3 + i] / self.length);
        let (turn, shift) = (vector::norm(w) * self.length, vector::norm(t));
        if turn < 1e-8 * shift {
            return FreeMotion::Along(vector::scale(t, 1.0 / shift));
        }
        let square = vector::dot(w, w);
        FreeMotion::About {
            axis: vector::scale(w, 1.0 / square.sqrt()),
            point: vector::add(self.center, vector::scale(vector::cross(w, t), 1.0 / square)),
            pitch: vector::dot(w, t) / square,
        }
    }

    /// As many single components of nodes as there are free motions, chosen so that holding them resists every one.
    /// Only nodes that `usable` names.
    pub(crate) fn pins(&self, nodes: &[V3], usable: impl Fn(usize) -> bool) -> Vec<(u32, usize)> {
        let mut basis: Vec<Vec<f64>> = Vec::new();
        let mut pins = Vec::new();
        for _ in 0..self.free.len() {
            let mut best = (0.0, (0, 0), Vec::new());
            for node in (0..nodes.len()).filter(|&node| usable(node)) {
                let moved: Vec<V3> = self.free.iter().map(|motion| self.displacement(motion, nodes[node])).collect();
                for component in 0..3 {
                    let mut row: Vec<f64> = moved.iter().map(|u| u[component]).collect();
                    for e in &basis {
                        let part: f64 = row.iter().zip(e).map(|(a, b)| a * b).sum();
                        row.iter_mut().zip(e).for_each(|(a, b)| *a -= part * b);
                    }
                    let size = row.iter().map(|x| x * x).sum::<f64>().sqrt();
                    if size > best.0 {
                        best = (size, (node as u32, component), row);
                    }
                }
            }
            let (size, pin, row) = best;
            basis.push(row.iter().map(|x| x / size).collect());
            pins.push(pin);
        }
        pins
    }
}

/// Vectors of the nullspace: what is perpendicular to the right vectors with a value.
fn complement(right: &[Vec<f64>], values: &[f64], size: usize) -> Vec<Vec<f64>> {
    let mut taken: Vec<Vec<f64>> =
        right.iter().zip(values).filter(|(_, value)| **value > 1e-8).map(|(vector, _)| vector.clone()).collect();
    let mut found = Vec::new();
    for k in 0..size {
        let mut left: Vec<f64> = (0..size).map(|i| f64::from(i == k)).collect();
        for e in &taken {
            let part = left.iter().zip(e).map(|(a, b)| a * b).sum::<f64>();
            left.iter_mut().zip(e).for_each(|(a, b)| *a -= part * b);
        }
        let norm = left.iter().map(|x| x * x).sum::<f64>().sqrt();
        if norm > 1e-6 && taken.len() < size {
            left.iter_mut().for_each(|x| *x /= norm);
            taken.push(left.clone());
            found.push(left);
        }
    }
    found
}

fn unit(i: usize) -> V3 {
    std::array::from_fn(|k| f64::from(k == i))
}

/// Middle and half diagonal of the box round some places.
fn extent(nodes: &[V3]) -> (V3, f64) {
    let (mut low, mut high) = ([f64::INFINITY; 3], [f64::NEG_INFINITY; 3]);
    for node in nodes {
        for i in 0..3 {
            low[i] = low[i].min(node[i]);
            high[i] = high[i].max(node[i]);
        }
    }
    let length = vector::norm(vector::sub(high, low)) / 2.0;
    (std::array::from_fn(|i| f64::midpoint(low[i], high[i])), if length > 0.0 { length } else { 1.0 })
}
