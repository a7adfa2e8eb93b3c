//! A flexible body over the rows of a study: what a moving, deformed, coloured picture of it is drawn from.
//!
//! The displacement of a node is the sum of displacements by unit coordinates times the coordinates of the row, its
//! stress likewise; nothing else is evaluated here.

use crate::{Pose, Unit};

/// The surface of a flexible body, the columns of its reduction there, and its coordinates row by row.
#[derive(Clone, Debug)]
pub struct FlexibleMotion {
    /// Name of the body, as in the drawing.
    pub body: String,
    /// Places of the surface's nodes in the undeformed body, in the axes of its floating frame, m.
    pub nodes: Vec<[f32; 3]>,
    /// Numbers of those nodes in the mesh files that are exported; empty where there are none.
    pub numbers: Vec<u32>,
    /// Triangles between nodes, counter-clockwise seen from outside. Curved faces come already divided.
    pub triangles: Vec<[u32; 3]>,
    /// Edges of elements, to be drawn as lines: pairs of nodes.
    pub edges: Vec<[u32; 2]>,
    /// Displacement of each node by coordinate e at 1, axes of the floating frame: `displacements[e][node]`, m by the
    /// unit of the coordinate.
    pub displacements: Vec<Vec<[f32; 3]>>,
    /// Stress xx, yy, zz, xy, yz, zx at each node by coordinate e at 1, axes of the floating frame, Pa by the unit of
    /// the coordinate: `stresses[e][node]`.
    pub stresses: Vec<Vec<[f32; 6]>>,
    /// Row of the study's table that each of the following belongs to, rising.
    pub rows: Vec<usize>,
    /// Elastic coordinates, SI: `coordinates[i][e]` in row `rows[i]`.
    pub coordinates: Vec<Vec<f64>>,
    /// Floating frame in the world in row `rows[i]`.
    pub poses: Vec<Pose>,
    /// Largest von Mises stress of each node over the rows, Pa.
    pub envelope: Vec<f32>,
    /// Place in `rows` of the largest stress that can be trusted.
    pub worst: usize,
    /// Stress that colours end at, Pa, where the largest is not to be trusted (a singular edge).
    pub ceiling: Option<f32>,
    /// Hot spots to point at.
    pub marks: Vec<MotionMark>,
    /// Unit that stresses are shown in.
    pub unit: Unit,
    /// Unit that displacements are shown in.
    pub length: Unit,
}

/// A hot spot that moves with the body.
#[derive(Clone, Debug)]
pub struct MotionMark {
    /// E.g. `bore B`.
    pub label: String,
    /// Its node, among those of the surface.
    pub node: u32,
    /// Von Mises stress there, Pa, in each of the rows of the motion.
    pub history: Vec<f64>,
    /// Whether the value is not to be trusted.
    pub doubtful: bool,
}

impl FlexibleMotion {
    /// Displacement of a node against the floating frame, in its axes, m; `at` counts the motion's own rows.
    pub fn displacement(&self, at: usize, node: usize) -> [f64; 3] {
        sum(&self.displacements, self.row(at), node)
    }

    /// Stress xx, yy, zz, xy, yz, zx at a node, axes of the floating frame, Pa.
    pub fn stress(&self, at: usize, node: usize) -> [f64; 6] {
        sum(&self.stresses, self.row(at), node)
    }

    /// Von Mises stress at a node, Pa.
    pub fn von_mises(&self, at: usize, node: usize) -> f64 {
        von_mises(self.stress(at, node))
    }

    /// The stress that colours end at, Pa: the same for all rows, so that colours can be compared.
    pub fn limit(&self) -> f64 {
        let largest = self.envelope.iter().copied().filter(|s| s.is_finite()).fold(0.0, f32::max);
        f64::from(self.ceiling.map_or(largest, |ceiling| ceiling.min(largest)))
    }

    /// Whether it can be drawn: every list as long as the others say, every corner a node.
    pub fn is_whole(&self) -> bool {
        let (nodes, count) = (self.nodes.len(), self.displacements.len());
        let known = |node: &u32| (*node as usize) < nodes;
        !self.rows.is_empty()
            && !self.triangles.is_empty()
            && self.rows.len() == self.coordinates.len()
            && self.rows.len() == self.poses.len()
            && self.stresses.len() == count
            && self.coordinates.iter().all(|row| row.len() == count)
            && self.displacements.iter().all(|of| of.len() == nodes)
            && self.stresses.iter().all(|of| of.len() == nodes)
            && self.triangles.as_flattened().iter().chain(self.edges.as_flattened()).all(known)
            && self.marks.iter().all(|mark| known(&mark.node))
    }

    fn row(&self, at: usize) -> &[f64] {
        self.coordinates.get(at).map_or(&[], Vec::as_slice)
    }
}

/// `Σ columns[e][node] coordinates[e]`.
fn sum<const N: usize>(columns: &[Vec<[f32; N]>], coordinates: &[f64], node: usize) -> [f64; N] {
    let mut total = [0.0; N];
    for (column, d) in columns.iter().zip(coordinates) {
        let of = column.get(node).copied().unwrap_or([f32::NAN; N]);
        (0..N).for_each(|k| total[k] += f64::from(of[k]) * d);
    }
    total
}

fn von_mises([xx, yy, zz, xy, yz, zx]: [f64; 6]) -> f64 {
    let normal = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    let shear = xy * xy + yz * yz + zx * zx;
    (0.5 * normal + 3.0 * shear).sqrt()
}

#[cfg(test)]
pub(crate) mod tests {
    use super::*;

    pub(crate) fn motion() -> FlexibleMotion {
        FlexibleMotion {
            body: "bar".to_owned(),
            nodes: vec![[0.1, 0.2, 0.3], [1.1, 0.2, 0.3], [0.6, 0.9, 0.3]],
            numbers: Vec::new(),
            triangles: vec![[0, 1, 2]],
            edges: vec![[0, 1]],
            displacements: vec![vec![[1.0, -2.0, 0.5]; 3], vec![[0.25, 3.0, -1.5]; 3]],
            stresses: vec![vec![[3.0, -1.0, 2.0, 0.5, -0.25, 1.0]; 3], vec![[-2.0, 5.0, 1.0, 2.0, 0.75, -4.0]; 3]],
            rows: vec![0, 4],
            coordinates: vec![vec![0.0, 0.0], vec![2.0, -0.5]],
            poses: vec![Pose { position: [0.0; 3], quaternion: [1.0, 0.0, 0.0, 0.0] }; 2],
            envelope: vec![7.0, 9.0, f32::NAN],
            worst: 1,
            ceiling: None,
            marks: Vec::new(),
            unit: Unit::new("MPa", 1e6),
            length: Unit::new("mm", 1e-3),
        }
    }

    #[test]
    fn nodes_move_by_the_sum_of_their_columns() {
        let found = motion();
        assert_eq!(found.displacement(1, 2), [1.875, -5.5, 1.75]);
        assert_eq!(found.stress(1, 0), [7.0, -4.5, 3.5, 0.0, -0.875, 4.0]);
        assert_eq!(found.displacement(0, 1), [0.0; 3]);
    }

    /// Against the deviator: `√(3/2 s : s)`.
    #[test]
    fn von_mises_is_that_of_the_deviator() {
        let [xx, yy, zz, xy, yz, zx] = motion().stress(1, 0);
        let mean = (xx + yy + zz) / 3.0;
        let normal: f64 = [xx, yy, zz].iter().map(|s| (s - mean).powi(2)).sum();
        let shear: f64 = [xy, yz, zx].iter().map(|s| 2.0 * s * s).sum();
        let expected = (1.5 * (normal + shear)).sqrt();
        assert!((motion().von_mises(1, 0) - expected).abs() < 1e-12 * expected);
    }

    #[test]
    fn colours_end_at_what_can_be_trusted() {
        assert!((motion().limit() - 9.0).abs() < 1e-12);
        assert!((FlexibleMotion { ceiling: Some(8.0), ..motion() }.limit() - 8.0).abs() < 1e-12);
    }

    #[test]
    fn what_lacks_numbers_is_not_drawn() {
        assert!(motion().is_whole());
        assert!(!FlexibleMotion { triangles: vec![[0, 1, 3]], ..motion() }.is_whole());
        assert!(!FlexibleMotion { coordinates: vec![vec![0.0], vec![1.0]], ..motion() }.is_whole());
        assert!(!FlexibleMotion { rows: Vec::new(), ..motion() }.is_whole());
    }
}
