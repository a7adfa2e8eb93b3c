//! Modes that a machine in the x-y plane can feel.

use bellcrank_fem::{Reduction, ShapeIntegrals};
use bellcrank_math::Real;

/// What a mode brings to the plane, against its own mass, below which it brings nothing.
const NOTHING: f64 = 1e-6;
/// Columns of an interface in the plane.
const IN_PLANE: [usize; 3] = [0, 1, 5];
const EACH: usize = 6;

/// Whether the machine can feel each mode: in the plane one that brings momentum there, moment of momentum, or a product
/// with an interface, relative to the mass that moves. The columns of interfaces come first.
pub(crate) fn felt<T: Real>(inertia: &ShapeIntegrals<T>, interfaces: usize, planar: bool) -> Vec<bool> {
    let first = EACH * interfaces;
    (first..inertia.coordinates()).map(|mode| !planar || share(inertia, first, mode) > NOTHING).collect()
}

fn share<T: Real>(of: &ShapeIntegrals<T>, first: usize, mode: usize) -> f64 {
    let n = of.coordinates();
    let product = |e: usize, f: usize| of.products[e * n + f].map(|row| row.map(T::value));
    let moved = |e: usize| (0..3).map(|i| product(e, e)[i][i]).sum::<f64>();
    let own = moved(mode);
    let against = |value: f64, other: f64| value.abs() / (own * other).sqrt().max(f64::MIN_POSITIVE);
    let turning = of.second[0][0].value() + of.second[1][1].value();
    let mut largest = 0.0_f64;
    for i in 0..2 {
        largest = largest.max(against(of.flow[mode][i].value(), of.mass.value()));
        largest = (0..2).map(|j| against(of.placed[mode][i][j].value(), turning)).fold(largest, f64::max);
    }
    for interface in (0..first).step_by(EACH) {
        for column in IN_PLANE.map(|column| interface + column) {
            let with = product(mode, column);
            largest = largest.max(against(with[0][0] + with[1][1], moved(column)));
        }
    }
    largest
}

/// Keeps some of the modes: ascending places among them.
pub(super) fn with_modes(reduction: Reduction, modes: &[usize]) -> Reduction {
    let first = EACH * reduction.points.len();
    let columns: Vec<usize> = (0..first).chain(modes.iter().map(|mode| first + mode)).collect();
    let size = reduction.coordinates();
    let square = |matrix: &[f64]| -> Vec<f64> {
        columns.iter().flat_map(|row| columns.iter().map(move |column| matrix[row * size + column])).collect()
    };
    Reduction {
        modes: modes.len(),
        frequencies: modes.iter().map(|&mode| reduction.frequencies[mode]).collect(),
        stiffness: square(&reduction.stiffness),
        inertia: integrals(&reduction.inertia, &columns),
        shapes: columns.iter().map(|&column| reduction.shapes[column].clone()).collect(),
        ..reduction
    }
}

fn integrals(of: &ShapeIntegrals, columns: &[usize]) -> ShapeIntegrals {
    let n = of.coordinates();
    ShapeIntegrals {
        flow: columns.iter().map(|&e| of.flow[e]).collect(),
        placed: columns.iter().map(|&e| of.placed[e]).collect(),
        products: columns.iter().flat_map(|e| columns.iter().map(move |f| of.products[e * n + f])).collect(),
        ..of.clone()
    }
}
