//! Stress and displacement of the surface, row by row: sums of columns (modal stress recovery).

use bellcrank_fem::{Six, von_mises};

use super::Body;
use crate::build::Deforming;
use crate::design::Flexible;
use crate::elastic::regions::{Doubt, Doubtful, Region, regions};
use crate::elastic::vector::{V3, norm};
use crate::measure::Measure;

/// What was found on the surface.
pub(super) struct Recovered {
    pub(super) regions: Vec<Region>,
    /// Of each region's nodes: why their stress means nothing.
    doubts: Vec<Vec<Option<Doubt>>>,
    /// Largest von Mises stress of each node of the mesh over the rows, Pa; 0 inside.
    pub(super) envelope: Vec<f64>,
    /// The largest of each region, of what can be trusted and of the rest.
    pub(super) largest: Vec<[Option<Largest>; 2]>,
    /// Largest displacement of a node, and in which row.
    pub(super) moved: (f64, usize),
}

/// A largest stress.
#[derive(Clone, Copy, Debug)]
pub(super) struct Largest {
    pub(super) value: f64,
    pub(super) node: u32,
    pub(super) row: usize,
    pub(super) doubt: Option<Doubt>,
}

/// Columns of some nodes, node after node.
struct Columns<const N: usize> {
    /// `columns[e][node]`.
    columns: Vec<Vec<[f64; N]>>,
    sums: Vec<[f64; N]>,
}

impl<const N: usize> Columns<N> {
    fn new(deforming: &Deforming, nodes: &[u32], of: &[Vec<[f64; N]>]) -> Columns<N> {
        let pick = |column: &usize| nodes.iter().map(|node| of[*column][*node as usize]).collect();
        Columns { columns: deforming.columns.iter().map(pick).collect(), sums: vec![[0.0; N]; nodes.len()] }
    }

    /// Sums at the coordinates of a row.
    fn at(&mut self, coordinates: &[f64]) -> &[[f64; N]] {
        self.sums.fill([0.0; N]);
        for (column, d) in self.columns.iter().zip(coordinates) {
            for (sum, of) in self.sums.iter_mut().zip(column) {
                (0..N).for_each(|k| sum[k] += of[k] * d);
            }
        }
        &self.sums
    }
}

impl Recovered {
    pub(super) fn new(body: &Body<'_>, form: &Flexible) -> Recovered {
        let reduced = body.reduced;
        let mesh = &reduced.mesh;
        let length = body.design.units.of(Measure::Length);
        let regions = regions(&body.solid, mesh, &length);
        let doubtful = Doubtful::new(mesh, &held(body, form));
        let doubt = |region: &Region| region.nodes.iter().map(|&node| doubtful.at(mesh.nodes[node as usize])).collect();
        let doubts = regions.iter().map(doubt).collect();
        let largest = vec![[None; 2]; regions.len()];
        let envelope = vec![0.0; mesh.nodes.len()];
        let mut recovered = Recovered { regions, doubts, envelope, largest, moved: (0.0, 0) };
        recovered.stresses(body);
        recovered.displacements(body);
        recovered
    }

    fn stresses(&mut self, body: &Body<'_>) {
        let mesh = &body.reduced.mesh;
        let surface = mesh.nodes_of_faces(&mesh.boundary());
        let mut place = vec![usize::MAX; mesh.nodes.len()];
        surface.iter().enumerate().for_each(|(k, &node)| place[node as usize] = k);
        let mut columns = Columns::new(body.deforming, &surface, &body.reduced.stress);
        let mut values = vec![0.0; surface.len()];
        for (row, coordinates) in body.rows.all().enumerate() {
            for ((value, stress), &node) in values.iter_mut().zip(columns.at(coordinates)).zip(&surface) {
                *value = von_mises(stress);
                let most = &mut self.envelope[node as usize];
                *most = most.max(*value);
            }
            self.compare(row, |node| values.get(place[node as usize]).copied().unwrap_or(0.0));
        }
    }

    /// Takes the largest of each region in a row.
    fn compare(&mut self, row: usize, value: impl Fn(u32) -> f64) {
        for ((region, doubts), largest) in self.regions.iter().zip(&self.doubts).zip(&mut self.largest) {
            for (&node, &doubt) in region.nodes.iter().zip(doubts) {
                let slot = &mut largest[usize::from(doubt.is_some())];
                let value = value(node);
                if slot.is_none_or(|known| value > known.value) {
                    *slot = Some(Largest { value, node, row, doubt });
                }
            }
        }
    }

    /// Interfaces and modes move some node of the surface most.
    fn displacements(&mut self, body: &Body<'_>) {
        let reduced = body.reduced;
        let surface = reduced.mesh.nodes_of_faces(&reduced.mesh.boundary());
        let mut columns = Columns::new(body.deforming, &surface, &reduced.reduction.shapes);
        for (row, coordinates) in body.rows.all().enumerate() {
            let most = columns.at(coordinates).iter().map(|u| norm(*u)).fold(0.0, f64::max);
            if most > self.moved.0 {
                self.moved = (most, row);
            }
        }
    }
}

/// Nodes that interfaces hold as one rigid piece.
fn held(body: &Body<'_>, form: &Flexible) -> Vec<u32> {
    let reduced = body.reduced;
    let points = reduced.reduction.points.iter().filter(|_| form.rigid);
    let bores = points.filter_map(|at| body.solid.bore_at(&reduced.mesh, *at));
    bores.flat_map(|(faces, _)| reduced.mesh.nodes_of_faces(&faces)).collect()
}

/// Stress of a node row by row, Pa.
pub(super) fn history(body: &Body<'_>, node: u32) -> Vec<Six> {
    let mut columns = Columns::new(body.deforming, &[node], &body.reduced.stress);
    body.rows.all().map(|coordinates| columns.at(coordinates)[0]).collect()
}

/// Displacement of every node in a row, m.
pub(super) fn displacement(body: &Body<'_>, coordinates: &[f64]) -> Vec<V3> {
    let all: Vec<u32> = (0..body.reduced.mesh.nodes.len() as u32).collect();
    Columns::new(body.deforming, &all, &body.reduced.reduction.shapes).at(coordinates).to_vec()
}
