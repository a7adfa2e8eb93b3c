//! Geometric stiffness: what stress that is there does to small deflections across it.
//!
//! A stress σ resists displacements φ with ∫ ∇φ_i : σ ∇φ_j dV (summed over the components of the displacement; the
//! initial-stress matrix of Zienkiewicz & Taylor). It is linear in σ, so unit forces and unit rates say all.

use bellcrank_math::linalg::dense;

use super::problem::Problem;
use super::{Interface, Reduction, free, share};
use crate::element::Geometry;
use crate::field::stress_at;
use crate::load::Loaded;
use crate::material::Six;
use crate::vector::{V3, accumulate, scale, sub};
use crate::{Fault, Load, Part, Settings, Shortening};

/// Pairs of axes in the order of [`spin_stiffness`].
pub const SPIN_PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]];

/// For every displacement of every interface but `reference`: the geometric stiffness of the part under a unit force along
/// it, held at the reference interface. By the principle of virtual work that is also how far the interface comes nearer:
/// its strain is that of d_along + ½ dᵀ C d.
///
/// Empty when `reference` is no interface.
pub fn shortenings(part: &Part<'_>, reduction: &Reduction, reference: usize, threads: usize) -> Vec<Shortening> {
    let others = (0..reduction.points.len()).filter(|&i| i != reference && reference < reduction.points.len());
    let along: Vec<usize> = others.flat_map(|i| 6 * i..6 * i + 3).collect();
    let fields: Vec<Vec<V3>> = along
        .iter()
        .map(|&along| {
            let mut forces = vec![0.0; reduction.coordinates()];
            forces[along] = 1.0;
            reduction.deflected(reference, &forces)
        })
        .collect();
    let matrices = geometric(part, reduction, &fields, threads);
    along.into_iter().zip(matrices).map(|(along, matrix)| Shortening { along, matrix }).collect()
}

/// Geometric stiffness, n × n by rows, of the part that is held at the reference interface and turns about it: K(ω) = Σ ω_i ω_j
/// K_ij over [`SPIN_PAIRS`], each pair once, ω in rad/s; the force of it is −K(ω) d.
///
/// # Errors
/// As [`Reduction::craig_bampton`], for the same part and interfaces.
///
/// # Panics
/// When `reference` is no interface.
pub fn spin_stiffness(
    part: &Part<'_>,
    interfaces: &[Interface],
    reduction: &Reduction,
    reference: usize,
    settings: &Settings<'_>,
) -> Result<[Vec<f64>; 6], Vec<Fault>> {
    let problem = Problem::new(part, interfaces, settings)?;
    let (factor, _) = problem.factor(settings)?;
    let factored = problem.with(&factor)?;
    let about = reduction.points[reference];
    let loads: Vec<Vec<V3>> = SPIN_PAIRS.iter().map(|pair| centrifugal(part, about, *pair)).collect();
    let mut answers: Vec<f64> = loads.iter().flat_map(|load| problem.gather(load)).collect();
    factored.solve(&mut answers, &[]);
    let mut fields = Vec::new();
    for (load, answer) in loads.iter().zip(answers.chunks_exact(problem.free.len().max(1))) {
        // Its interfaces held, then let go: as the columns of interfaces do no work on what is left over, the forces on them are
        // those of the load alone.
        let own = problem.scatter(answer);
        let forces = reduction.work_of(load);
        let boundary = reduction.deflected(reference, &forces);
        fields.push(own.iter().zip(boundary).map(|(a, b)| crate::vector::add(*a, b)).collect());
    }
    let matrices = geometric(part, reduction, &fields, settings.threads);
    let mut matrices = matrices.into_iter();
    Ok(std::array::from_fn(|_| matrices.next().unwrap_or_default()))
}

/// Nodal forces of the centrifugal acceleration by the product ω_i ω_j of a pair.
fn centrifugal(part: &Part<'_>, about: V3, [i, j]: [usize; 2]) -> Vec<V3> {
    let of = |omega: V3| {
        let none = [0.0; 3];
        Loaded::new(part, &[Load::Motion { about, acceleration: none, omega, alpha: none }]).nodal
    };
    let unit = |i: usize| -> V3 { std::array::from_fn(|k| f64::from(k == i)) };
    if i == j {
        return of(unit(i));
    }
    let mut both = of(crate::vector::add(unit(i), unit(j)));
    for own in [of(unit(i)), of(unit(j))] {
        both.iter_mut().zip(own).for_each(|(sum, own)| *sum = sub(*sum, own));
    }
    both
}

impl Reduction {
    /// Displacement of every node under forces on the coordinates of interfaces, statically, with one interface held.
    fn deflected(&self, reference: usize, forces: &[f64]) -> Vec<V3> {
        let boundary = 6 * self.points.len();
        let loose: Vec<usize> = (0..boundary).filter(|i| i / 6 != reference).collect();
        let rows = free::rows(&self.stiffness);
        let matrix: Vec<Vec<f64>> = loose.iter().map(|&i| loose.iter().map(|&j| rows[i][j]).collect()).collect();
        let rhs: Vec<f64> = loose.iter().map(|&i| forces[i]).collect();
        let mut field = vec![[0.0; 3]; self.shapes.first().map_or(0, Vec::len)];
        let d = if loose.is_empty() { None } else { dense::solve(&matrix, &rhs) };
        for (&i, share) in loose.iter().zip(d.unwrap_or_default()) {
            field.iter_mut().zip(&self.shapes[i]).for_each(|(u, shape)| accumulate(u, scale(*shape, share)));
        }
        field
    }

    /// Work of nodal forces on each column.
    fn work_of(&self, forces: &[V3]) -> Vec<f64> {
        let work = |shape: &Vec<V3>| shape.iter().zip(forces).map(|(u, f)| crate::vector::dot(*u, *f)).sum();
        self.shapes.iter().map(work).collect()
    }
}

/// Pieces that the elements are cut into, so that sums do not depend on the number of threads.
const PIECES: usize = 16;
/// Integration points taken together.
const POINTS: usize = 64;

/// ∫ ∇φ_i : σ ∇φ_j dV for the stresses of some displacement fields; n × n by rows each.
fn geometric(part: &Part<'_>, reduction: &Reduction, fields: &[Vec<V3>], threads: usize) -> Vec<Vec<f64>> {
    let n = reduction.coordinates();
    let pieces = share::each(PIECES, threads, |piece| {
        let mut sum = Sum { n, gradients: Vec::new(), pulled: vec![Vec::new(); fields.len()], sums: Vec::new() };
        sum.sums.resize(fields.len(), vec![0.0; n * n]);
        sum.piece(part, &reduction.shapes, fields, piece);
        sum.sums
    });
    let mut sums = vec![vec![0.0; n * n]; fields.len()];
    for piece in pieces {
        for (sum, own) in sums.iter_mut().zip(piece) {
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
        }
    }
    sums.iter().map(|sum| symmetric(sum, n)).collect()
}

fn symmetric(matrix: &[f64], n: usize) -> Vec<f64> {
    (0..n * n).map(|at| f64::midpoint(matrix[at], matrix[at % n * n + at / n])).collect()
}

/// Sums over a piece of the elements.
struct Sum {
    n: usize,
    /// ∇φ of all columns, row after row: nine an integration point.
    gradients: Vec<f64>,
    /// For each stress, the same times stress and volume.
    pulled: Vec<Vec<f64>>,
    sums: Vec<Vec<f64>>,
}

impl Sum {
    fn piece(&mut self, part: &Part<'_>, shapes: &[Vec<V3>], fields: &[Vec<V3>], piece: usize) {
        let mut geometry = Geometry::default();
        for (block, material) in part.mesh.blocks.iter().zip(&part.materials) {
            let range = block.len() * piece / PIECES..block.len() * (piece + 1) / PIECES;
            for element in range.map(|element| block.element(element)) {
                geometry.set(block.shape, element, &part.mesh.nodes);
                for point in block.shape.stiffness_points() {
                    let volume = geometry.at(point) * point.weight;
                    let slopes: Vec<[V3; 3]> = shapes.iter().map(|shape| slopes(&geometry, element, shape)).collect();
                    self.rows(&slopes, |slope| slope, None);
                    for (case, field) in fields.iter().enumerate() {
                        let stress = stress_at(&geometry, material, element, field, None).map(|s| s * volume);
                        self.rows(&slopes, |slope| times(&stress, slope), Some(case));
                    }
                    if self.gradients.len() >= 9 * POINTS * self.n {
                        self.flush();
                    }
                }
            }
        }
        self.flush();
    }

    /// Appends rows for each component of the displacement and each direction.
    fn rows(&mut self, slopes: &[[V3; 3]], of: impl Fn(V3) -> V3, case: Option<usize>) {
        let target = case.map_or(&mut self.gradients, |case| &mut self.pulled[case]);
        for component in 0..3 {
            let start = target.len();
            target.resize(start + 3 * self.n, 0.0);
            for (column, slope) in slopes.iter().enumerate() {
                let values = of(slope[component]);
                (0..3).for_each(|k| target[start + k * self.n + column] = values[k]);
            }
        }
    }

    fn flush(&mut self) {
        for (pulled, sum) in self.pulled.iter_mut().zip(&mut self.sums) {
            let own = dense::row_product(&self.gradients, pulled, self.n);
            sum.iter_mut().zip(own).for_each(|(sum, own)| *sum += own);
            pulled.clear();
        }
        self.gradients.clear();
    }
}

/// Gradients of the components of a displacement where the geometry was last evaluated.
fn slopes(geometry: &Geometry, element: &[u32], shape: &[V3]) -> [V3; 3] {
    let mut slopes = [[0.0; 3]; 3];
    for (g, &node) in geometry.gradients().iter().zip(element) {
        let u = shape[node as usize];
        (0..3).for_each(|c| accumulate(&mut slopes[c], scale(*g, u[c])));
    }
    slopes
}

/// σ v.
fn times(s: &Six, v: V3) -> V3 {
    [
        s[0] * v[0] + s[3] * v[1] + s[5] * v[2],
        s[3] * v[0] + s[1] * v[1] + s[4] * v[2],
        s[5] * v[0] + s[4] * v[1] + s[2] * v[2],
    ]
}
