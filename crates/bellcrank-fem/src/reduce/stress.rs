//! Stress of the columns of a reduction.

use super::{Reduction, share};
use crate::element::Geometry;
use crate::field::stress_at;
use crate::material::Six;
use crate::vector::V3;
use crate::{Part, recovery};

/// Smoothed stress at every node by each coordinate (as [`crate::Stress`] has it), Pa a unit of the coordinate; components xx,
/// yy, zz, xy, yz, zx in the axes of the mesh. n × nodes. The stress of the body is their sum times the coordinates.
pub fn stress(part: &Part<'_>, reduction: &Reduction, threads: usize) -> Vec<Vec<Six>> {
    let n = reduction.shapes.len();
    let pieces = threads.clamp(1, n.max(1));
    let own = |piece: usize| of_columns(part, &reduction.shapes[n * piece / pieces..n * (piece + 1) / pieces]);
    share::each(pieces, threads, own).into_iter().flatten().collect()
}

fn of_columns(part: &Part<'_>, columns: &[Vec<V3>]) -> Vec<Vec<Six>> {
    let sample = |geometry: &Geometry, block: usize, element: &[u32], here: &mut [Six]| {
        for (stress, column) in here.iter_mut().zip(columns) {
            *stress = stress_at(geometry, &part.materials[block], element, column, None);
        }
    };
    let nodal = recovery::nodal(part, columns.len(), &sample);
    (0..columns.len()).map(|case| nodal.iter().skip(case).step_by(columns.len()).copied().collect()).collect()
}
