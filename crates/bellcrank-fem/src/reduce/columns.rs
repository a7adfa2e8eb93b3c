//! The columns of a reduction: constraint modes of the interfaces and fixed-interface modes.

use bellcrank_math::linalg::sparse::Eigenproblem;

use super::problem::Factored;
use super::{Interface, Keep};
use crate::modes;
use crate::solver::Failed;
use crate::vector::{V3, accumulate};
use crate::{CouplingKind, Fault, Settings};

/// Displacement of every node by each coordinate of each interface.
pub(super) fn of_interfaces(factored: &Factored<'_, '_>) -> Vec<Vec<V3>> {
    let problem = factored.problem;
    let prescribed: Vec<Vec<V3>> = problem
        .interfaces
        .iter()
        .flat_map(|interface| (0..6).map(move |component| (interface, component)))
        .map(|(interface, component)| match interface.kind {
            CouplingKind::Rigid => problem.moved(interface, component),
            CouplingKind::Distributing => vec![[0.0; 3]; problem.part.mesh.nodes.len()],
        })
        .collect();
    let pulled = problem.times_stiffness(&prescribed);
    let mut answers: Vec<f64> = pulled.iter().flat_map(|forces| problem.gather(forces)).map(|force| -force).collect();
    factored.solve(&mut answers, &wanted(problem.interfaces));
    let mut columns = prescribed;
    for (column, answer) in columns.iter_mut().zip(answers.chunks_exact(problem.free.len().max(1))) {
        column.iter_mut().zip(problem.scatter(answer)).for_each(|(u, own)| accumulate(u, own));
    }
    columns
}

/// d of the distributing interfaces, for each coordinate of each interface.
fn wanted(interfaces: &[Interface]) -> Vec<f64> {
    let distributing = |index: &usize| interfaces[*index].kind == CouplingKind::Distributing;
    let rows: Vec<usize> = (0..interfaces.len()).filter(distributing).collect();
    let mut wanted = Vec::new();
    for coordinate in 0..6 * interfaces.len() {
        let places = rows.iter().flat_map(|index| 6 * index..6 * index + 6);
        wanted.extend(places.map(|place| f64::from(u8::from(place == coordinate))));
    }
    wanted
}

/// The fixed-interface modes that are kept.
pub(super) struct FixedModes {
    /// (2πf)², ascending.
    pub(super) eigenvalues: Vec<f64>,
    /// Displacement of every node.
    pub(super) shapes: Vec<Vec<V3>>,
    /// Largest relative residual.
    pub(super) residual: f64,
}

/// Modes asked for at first where a frequency says how many.
const FIRST: usize = 16;

impl FixedModes {
    pub(super) fn new(factored: &Factored<'_, '_>, keep: &Keep, settings: &Settings<'_>) -> Result<Self, Vec<Fault>> {
        let available = factored.dimension();
        let most = match (keep.count, keep.frequency) {
            (Some(asked), _) if asked > available => return Err(vec![Fault::TooManyModes { asked, available }]),
            (Some(count), _) => count,
            (None, Some(_)) => available,
            (None, None) => 0,
        };
        let limit = keep.frequency.map_or(f64::INFINITY, |f| (2.0 * std::f64::consts::PI * f).powi(2));
        let mut asked = if keep.frequency.is_some() { FIRST.min(most) } else { most };
        loop {
            let found = Self::lowest(factored, asked, settings)?;
            if asked == most || found.eigenvalues.last().is_none_or(|last| *last > limit) {
                return Ok(found.up_to(limit));
            }
            asked = (2 * asked).min(most);
        }
    }

    fn lowest(factored: &Factored<'_, '_>, count: usize, settings: &Settings<'_>) -> Result<Self, Vec<Fault>> {
        let problem = Eigenproblem { stiffness: &factored.stiffness, mass: &factored.mass };
        let half = |share: f64| (settings.progress)(0.5 + 0.5 * share);
        let pairs = match &factored.held {
            Some(held) => problem.lowest_held(held, count, &half),
            None => problem.lowest_with(factored.factor, 0.0, count, &half),
        };
        let pairs = pairs.map_err(|failure| match modes::failed(failure) {
            Failed::NotConverged { found } => vec![Fault::NotConverged { found }],
            _ => vec![Fault::Interrupted],
        })?;
        let size = factored.problem.free.len().max(1);
        let shape = |vector| modes::oriented(factored.problem.scatter(vector));
        let shapes = pairs.vectors.chunks_exact(size).map(shape).collect();
        let residual = pairs.residuals.iter().copied().fold(0.0, f64::max);
        Ok(Self { eigenvalues: pairs.values, shapes, residual })
    }

    fn up_to(mut self, limit: f64) -> Self {
        let count = self.eigenvalues.partition_point(|value| *value <= limit);
        self.eigenvalues.truncate(count);
        self.shapes.truncate(count);
        self
    }
}
