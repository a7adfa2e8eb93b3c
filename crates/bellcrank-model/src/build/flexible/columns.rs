//! Which columns of a reduction move a body in a machine.

use bellcrank_fem::{ShapeIntegrals, Shortening as Shape};
use bellcrank_math::Real;
use bellcrank_multibody::{BodyId, Flexible, ShapeInertia, Shortening};

/// Coordinates of an interface that move it in the plane: x, y, turn about z.
const IN_PLANE: [usize; 3] = [0, 1, 5];
const IN_SPACE: [usize; 6] = [0, 1, 2, 3, 4, 5];
/// Coordinates of an interface in a reduction.
const EACH: usize = 6;

/// The columns that stay: the floating frame goes with the reference interface, and in the plane nothing leaves it.
pub(super) fn kept(interfaces: usize, reference: usize, modes: usize, planar: bool) -> Vec<usize> {
    let of_interface: &[usize] = if planar { &IN_PLANE } else { &IN_SPACE };
    let others = (0..interfaces).filter(|&interface| interface != reference);
    let moved = others.flat_map(|interface| of_interface.iter().map(move |column| EACH * interface + column));
    moved.chain(EACH * interfaces..EACH * interfaces + modes).collect()
}

/// A reduced body with some of its columns; not in a machine yet. Matrices are by rows.
pub(crate) fn picked<T: Real>(
    inertia: &ShapeIntegrals<T>,
    stiffness: &[T],
    damping: &[T],
    columns: &[usize],
) -> Flexible<T> {
    let size = inertia.coordinates();
    Flexible {
        body: BodyId::GROUND,
        interfaces: Vec::new(),
        modes: None,
        inertia: ShapeInertia {
            mass: inertia.mass,
            first: inertia.first,
            second: inertia.second,
            flow: columns.iter().map(|&e| inertia.flow[e]).collect(),
            placed: columns.iter().map(|&e| inertia.placed[e]).collect(),
            products: columns
                .iter()
                .flat_map(|e| columns.iter().map(move |f| inertia.products[e * size + f]))
                .collect(),
        },
        stiffness: square(stiffness, size, columns),
        damping: square(damping, size, columns),
        shortenings: Vec::new(),
    }
}

/// Some rows and columns of a square matrix.
fn square<T: Copy>(matrix: &[T], size: usize, columns: &[usize]) -> Vec<T> {
    columns.iter().flat_map(|row| columns.iter().map(move |column| matrix[row * size + column])).collect()
}

/// Those along columns that are kept, by their places among these.
pub(crate) fn shortened<T: Copy>(of: &[Shape<T>], size: usize, columns: &[usize]) -> Vec<Shortening<T>> {
    let one = |one: &Shape<T>| {
        let along = columns.iter().position(|column| *column == one.along)?;
        Some(Shortening { along, matrix: square(&one.matrix, size, columns) })
    };
    of.iter().filter_map(one).collect()
}
