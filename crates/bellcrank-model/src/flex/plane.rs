//! Modes that a machine in the x-y plane can feel.

use bellcrank_fem::{Reduction, ShapeIntegrals};

/// What a mode brings to the plane, against its own mass, below which it brings nothing.
const NOTHING: f64 = 1e-6;
/// Columns of an interface in the plane.
const IN_PLANE: [usize; 3] = [0, 1, 5];
const EACH: usize = 6;

/// Whether each mode moves what is in the plane: its momentum there, its moment of momentum, or its product with an
/// interface, relative to the mass that moves.
pub(super) fn felt(reduction: &Reduction) -> Vec<bool> {
    let first = EACH * reduction.points.len();
    (0..reduction.modes).map(|mode| share(reduction, first + mode) > NOTHING).collect()
}

fn share(reduction: &Reduction, mode: usize) -> f64 {
    let of = &reduction.inertia;
    let n = of.coordinates();
    let product = |e: usize, f: usize| of.products[e * n + f];
    let moved = |e: usize| (0..3).map(|i| product(e, e)[i][i]).sum::<f64>();
    let own = moved(mode);
    let against = |value: f64, other: f64| value.abs() / (own * other).sqrt().max(f64::MIN_POSITIVE);
    let turning = of.second[0][0] + of.second[1][1];
    let mut largest = 0.0_f64;
    for i in 0..2 {
        largest = largest.max(against(of.flow[mode][i], of.mass));
        largest = (0..2).map(|j| against(of.placed[mode][i][j], turning)).fold(largest, f64::max);
    }
    for interface in 0..reduction.points.len() {
        for column in IN_PLANE.map(|column| EACH * interface + column) {
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
