//! Stress and displacement of the surface, row by row: sums of columns (modal stress recovery).

use bellcrank_fem::{Six, von_mises};
use bellcrank_mesh::Mesh;
use bellcrank_results::Unit;

use super::Body;
use crate::build::Deforming;
use crate::design::Flexible;
use crate::elastic::meshing::Solid;
use crate::elastic::regions::{Doubt, Doubtful, Region, regions};
use crate::elastic::vector::{V3, norm};
use crate::measure::Measure;

/// Key of the largest of all regions.
pub(crate) const PEAK: &str = "peak";

/// What was found on the surface.
pub(super) struct Recovered {
    pub(super) regions: Vec<Region>,
    /// Of each region's nodes: why their stress means nothing.
    doubts: Vec<Vec<Option<Doubt>>>,
    /// Largest von Mises stress of each node of the mesh over the rows, Pa; 0 inside.
    pub(super) envelope: Vec<f64>,
    /// The largest of each region, of what can be trusted and of the rest.
    pub(super) largest: Vec<[Option<Largest>; 2]>,
    /// The largest of each region that can be trusted, row by row, Pa: `curves[region][row]`; NaN where there is none.
    pub(super) curves: Vec<Vec<f64>>,
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
        let points = &reduced.reduction.points;
        let doubtful = Doubtful::new(mesh, &held(&body.solid, mesh, points, form.rigid));
        let doubt = |region: &Region| region.nodes.iter().map(|&node| doubtful.at(mesh.nodes[node as usize])).collect();
        let doubts = regions.iter().map(doubt).collect();
        let largest = vec![[None; 2]; regions.len()];
        let envelope = vec![0.0; mesh.nodes.len()];
        let mut recovered =
            Recovered { curves: vec![Vec::new(); regions.len()], regions, doubts, envelope, largest, moved: (0.0, 0) };
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
        let all = self.regions.iter().zip(&self.doubts).zip(&mut self.largest).zip(&mut self.curves);
        for (((region, doubts), largest), curve) in all {
            curve.push(f64::NAN);
            for (&node, &doubt) in region.nodes.iter().zip(doubts) {
                let slot = &mut largest[usize::from(doubt.is_some())];
                let value = value(node);
                if doubt.is_none() {
                    curve[row] = curve[row].max(value);
                }
                if slot.is_none_or(|known| value > known.value) {
                    *slot = Some(Largest { value, node, row, doubt });
                }
            }
        }
    }

    /// The largest of all regions row by row.
    pub(super) fn peaks(&self) -> Vec<f64> {
        let rows = self.curves.first().map_or(0, Vec::len);
        (0..rows).map(|row| self.curves.iter().fold(f64::NAN, |most: f64, curve| most.max(curve[row]))).collect()
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

/// Nodes that interfaces at these points hold as one rigid piece.
fn held(solid: &Solid, mesh: &Mesh, points: &[V3], rigid: bool) -> Vec<u32> {
    let bores = points.iter().filter(|_| rigid).filter_map(|at| solid.bore_at(mesh, *at));
    bores.flat_map(|(faces, _)| mesh.nodes_of_faces(&faces)).collect()
}

/// Nodes whose stress can be trusted: of the whole surface (`peak`), and of each bore.
pub(crate) fn trusted_regions(solid: &Solid, mesh: &Mesh, points: &[V3], rigid: bool) -> Vec<(String, Vec<u32>)> {
    let doubtful = Doubtful::new(mesh, &held(solid, mesh, points, rigid));
    let sure = |nodes: &[u32]| -> Vec<u32> {
        nodes.iter().copied().filter(|&node| doubtful.at(mesh.nodes[node as usize]).is_none()).collect()
    };
    let regions = regions(solid, mesh, &Unit::one());
    let mut all: Vec<u32> = regions.iter().flat_map(|region| sure(&region.nodes)).collect();
    all.sort_unstable();
    all.dedup();
    let bores = regions.iter().filter(|region| region.key.starts_with("bore."));
    let bores = bores.map(|region| (region.key.clone(), sure(&region.nodes)));
    std::iter::once((PEAK.to_owned(), all)).chain(bores).collect()
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
