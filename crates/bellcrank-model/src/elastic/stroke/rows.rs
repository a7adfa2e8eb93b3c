//! Elastic coordinates and floating frames, row by row.

use bellcrank_math::quaternion_from_matrix;
use bellcrank_multibody::{BodyId, Readings};
use bellcrank_results::Pose;

use crate::build::Deforming;

/// Of one body.
#[derive(Debug, Default)]
pub(crate) struct BodyRows {
    /// Coordinates of the body.
    pub(super) width: usize,
    /// One row after another.
    pub(super) coordinates: Vec<f64>,
    pub(super) poses: Vec<Pose>,
}

impl BodyRows {
    pub(super) fn row(&self, row: usize) -> &[f64] {
        &self.coordinates[row * self.width..(row + 1) * self.width]
    }
    pub(super) fn all(&self) -> impl Iterator<Item = &[f64]> {
        (0..self.poses.len()).map(|row| self.row(row))
    }
}

/// Of all flexible bodies.
#[derive(Debug, Default)]
pub(crate) struct Shapes {
    pub(super) bodies: Vec<BodyRows>,
}

impl Shapes {
    /// Adds a row.
    pub(crate) fn record(&mut self, at: &dyn Readings<f64>, flexible: &[Deforming]) {
        self.bodies.resize_with(flexible.len(), BodyRows::default);
        for (rows, body) in self.bodies.iter_mut().zip(flexible) {
            rows.width = body.coordinates.len();
            rows.coordinates.extend(body.coordinates.iter().map(|c| at.coordinate(*c).position));
            let motion = at.body(BodyId(body.body));
            rows.poses.push(Pose { position: motion.origin, quaternion: quaternion_from_matrix(&motion.rotation) });
        }
    }

    /// Number of rows.
    pub(crate) fn count(&self) -> usize {
        self.bodies.first().map_or(0, |body| body.poses.len())
    }
}
