//! Natural frequencies and mode shapes.

use std::sync::Arc;

use bellcrank_math::linalg::sparse::{EigenFailure, Eigenpairs, Eigenproblem, Plan, SymmetricMatrix};

use crate::assemble::{self, Kind, Pattern};
use crate::freedom::{Counting, Freedom};
use crate::numbering::Numbering;
use crate::solver::Failed;
use crate::vector::{self, V3};
use crate::{CouplingKind, Fault, Part, Settings, check};

/// Modes of a part in the order of their frequencies; the rigid-body modes of a free part come first, with frequency
/// zero.
#[derive(Clone, Debug)]
pub struct Modes {
    /// Natural frequencies in Hz.
    pub frequencies: Vec<f64>,
    /// Displacement of every node for each mode; modal masses are 1 kg (in kg^-1/2).
    pub shapes: Vec<Vec<V3>>,
    /// How many of them are motions as a rigid body.
    pub rigid: usize,
    /// Largest residual |K φ − λ M φ| / |λ M φ| among those that are not.
    pub residual: f64,
    /// Size of the factor.
    pub effort: crate::Effort,
}

impl Modes {
    /// The lowest `count` modes.
    ///
    /// # Errors
    /// Everything that is wrong with the part; supports through distributing couplings; no convergence; no memory.
    pub fn lowest(part: &Part<'_>, count: usize, settings: &Settings<'_>) -> Result<Self, Vec<Fault>> {
        let mut faults = check::part(part);
        let distributing = |coupling: &crate::Coupling| {
            coupling.kind == CouplingKind::Distributing && coupling.held.iter().any(Option::is_some)
        };
        faults.extend(part.couplings.iter().position(distributing).map(Fault::ModesWithDistributingSupport));
        if !faults.is_empty() {
            return Err(faults);
        }
        let numbering = Numbering::new(part, &[])?;
        let pattern = Pattern::new(part, &numbering);
        let stiffness = assemble::matrix(part, &numbering, &pattern, Kind::Stiffness, settings.threads);
        let mass = assemble::matrix(part, &numbering, &pattern, Kind::Mass, settings.threads);
        let mass = assemble::without_zeros(&mass);
        let plan = Arc::new(Plan::new(&stiffness));
        settings
            .fits(plan.memory() + 24 * stiffness.values.len())
            .map_err(|(needed, allowed)| vec![Fault::Memory { needed, allowed }])?;
        let free = Freedom::new(part, Counting::Matrix).free.len();
        let count = count.min(numbering.equations);
        let problem = Eigenproblem { stiffness: &stiffness, mass: &mass };
        let pairs = problem
            .lowest(&plan, count, settings.threads, settings.progress)
            .map_err(|failure| vec![failed(failure).named(&numbering)])?;
        let effort = crate::Effort { equations: numbering.equations, factor_entries: plan.factor_entries() };
        Ok(collect(&numbering, &stiffness, &mass, &pairs, free, effort))
    }
}

pub(crate) fn failed(failure: EigenFailure) -> Failed {
    match failure {
        EigenFailure::Factor(failure) => failure.into(),
        EigenFailure::NotConverged { found } => Failed::NotConverged { found },
    }
}

fn collect(
    numbering: &Numbering,
    stiffness: &SymmetricMatrix,
    mass: &SymmetricMatrix,
    pairs: &Eigenpairs,
    rigid: usize,
    effort: crate::Effort,
) -> Modes {
    let size = numbering.equations;
    let (mut kx, mut mx) = (vec![0.0; size], vec![0.0; size]);
    let mut modes = Modes { frequencies: Vec::new(), shapes: Vec::new(), rigid, residual: 0.0, effort };
    for (index, (value, vector)) in pairs.values.iter().zip(pairs.vectors.chunks_exact(size)).enumerate() {
        let value = if index < rigid { 0.0 } else { value.max(0.0) };
        modes.frequencies.push(value.sqrt() / (2.0 * std::f64::consts::PI));
        modes.shapes.push(oriented(numbering.displacement(vector, 0.0)));
        if index >= rigid {
            stiffness.multiply(vector, &mut kx);
            mass.multiply(vector, &mut mx);
            let norm = |of: &dyn Fn(usize) -> f64| (0..size).map(|i| of(i).powi(2)).sum::<f64>().sqrt();
            let left = norm(&|i| kx[i] - value * mx[i]) / norm(&|i| value * mx[i]);
            modes.residual = modes.residual.max(left);
        }
    }
    modes
}

/// The sign of a mode means nothing; the largest component is made positive so that it does not change from run to run.
pub(crate) fn oriented(mut shape: Vec<V3>) -> Vec<V3> {
    let largest =
        shape.iter().flatten().fold(0.0_f64, |most, &u| if u.abs() > most.abs() * 1.000_001 { u } else { most });
    if largest < 0.0 {
        shape.iter_mut().for_each(|u| *u = vector::scale(*u, -1.0));
    }
    shape
}
