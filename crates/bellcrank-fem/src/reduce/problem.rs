//! What is solved for a reduction: the part with all its interfaces held.
//!
//! One factorization answers all: forces of interfaces that move, and the inertia of modes. Nodes of rigid interfaces
//! have no unknowns; distributing ones are constraints C u = q.

use std::sync::Arc;

use bellcrank_math::linalg::sparse::{Cholesky, Held, Plan, SymmetricMatrix};

use super::Interface;
use crate::assemble::{self, Kind, Pattern};
use crate::freedom::{Counting, Freedom};
use crate::numbering::{Group, Numbering, Tie, nodes_of, rigid_motions};
use crate::solver::Failed;
use crate::surface::Spread;
use crate::vector::{self, V3};
use crate::{Coupling, CouplingKind, Effort, Fault, Part, Settings, check, statics};

/// The matrices of a part, and which of its unknowns are free.
pub(super) struct Problem<'a> {
    pub(super) part: &'a Part<'a>,
    pub(super) interfaces: &'a [Interface],
    /// Of all nodes, three unknowns each.
    pub(super) stiffness: SymmetricMatrix,
    /// Of all nodes, one unknown each: the mass matrix is the same for x, y and z.
    pub(super) mass: SymmetricMatrix,
    /// Components of nodes (3 node + i) that are free, ascending.
    pub(super) free: Vec<u32>,
    /// The part with its interfaces as couplings that are held.
    held: Part<'a>,
}

/// A factored problem.
pub(super) struct Factored<'a, 'f> {
    pub(super) problem: &'f Problem<'a>,
    /// With all interfaces held but distributing ones.
    pub(super) stiffness: SymmetricMatrix,
    pub(super) mass: SymmetricMatrix,
    pub(super) factor: &'f Cholesky,
    /// Distributing interfaces, where there are any.
    pub(super) held: Option<Held<'f>>,
}

impl<'a> Problem<'a> {
    pub(super) fn new(
        part: &'a Part<'a>,
        interfaces: &'a [Interface],
        settings: &Settings<'_>,
    ) -> Result<Self, Vec<Fault>> {
        let held = held(part, interfaces);
        let faults = faults(part, &held, interfaces);
        if !faults.is_empty() {
            return Err(faults);
        }
        let all = Numbering::new(part, &[])?;
        let pattern = Pattern::new(part, &all);
        let stiffness = assemble::matrix(part, &all, &pattern, Kind::Stiffness, settings.threads);
        let one = one_a_node(part.mesh.nodes.len());
        let pattern = Pattern::new(part, &one);
        let mass = assemble::matrix(part, &one, &pattern, Kind::Mass, settings.threads);
        let free = free(part, interfaces);
        Ok(Self { part, interfaces, stiffness, mass, free, held })
    }

    /// K of the free unknowns, and with springs where distributing interfaces alone hold the part.
    pub(super) fn factor(&self, settings: &Settings<'_>) -> Result<(Cholesky, Effort), Vec<Fault>> {
        let mut stiffness = submatrix(&self.stiffness, &self.free);
        for spring in self.springs() {
            let start = stiffness.starts[spring];
            stiffness.values[start] *= 2.0;
        }
        let plan = Arc::new(Plan::new(&stiffness));
        let needed = plan.memory() + 12 * (2 * self.stiffness.values.len() + 4 * self.mass.values.len());
        settings.fits(needed).map_err(|(needed, allowed)| vec![Fault::Memory { needed, allowed }])?;
        let effort = Effort { equations: stiffness.size, factor_entries: plan.factor_entries() };
        let half = |share: f64| (settings.progress)(0.5 * share);
        let factor = Cholesky::factor(plan, &stiffness, settings.threads, &half).map_err(|failure| {
            vec![match Failed::from(failure) {
                Failed::Loose { equation } => {
                    let place = self.free[equation];
                    Fault::Loose { node: place / 3, component: place as usize % 3 }
                }
                _ => Fault::Interrupted,
            }]
        })?;
        Ok((factor, effort))
    }

    /// With a factor from [`Problem::factor`].
    pub(super) fn with<'f>(&'f self, factor: &'f Cholesky) -> Result<Factored<'a, 'f>, Vec<Fault>> {
        let stiffness = submatrix(&self.stiffness, &self.free);
        let mass = submatrix(&three_a_node(&self.mass), &self.free);
        let (constraints, places) = self.constraints();
        let held = match places.is_empty() {
            true => None,
            false => {
                let held = Held::new(factor, constraints, self.motions());
                Some(held.ok_or_else(|| vec![Fault::InterfaceOnLine(places[0])])?)
            }
        };
        Ok(Factored { problem: self, stiffness, mass, factor, held })
    }

    /// Rows of C on the free unknowns, and the interfaces they are of, each six times.
    fn constraints(&self) -> (Vec<f64>, Vec<usize>) {
        let (mut rows, mut places) = (Vec::new(), Vec::new());
        for (index, coupling) in self.held.couplings.iter().enumerate() {
            if coupling.kind == CouplingKind::Distributing {
                for component in 0..6 {
                    rows.extend(self.gather(&self.unit(coupling, component)));
                    places.push(index);
                }
            }
        }
        (rows, places)
    }

    /// Nodal forces of a unit force or moment on a frame.
    fn unit(&self, coupling: &Coupling, component: usize) -> Vec<V3> {
        let unit = |first: usize| std::array::from_fn(|i| f64::from(first + i == component));
        let mut nodal = vec![[0.0; 3]; self.part.mesh.nodes.len()];
        Spread::new(self.part.mesh, coupling).add(self.part.mesh, coupling, unit(0), unit(3), &mut nodal);
        nodal
    }

    /// What the rigid interfaces leave free of the motions of the whole.
    fn freedom(&self) -> Freedom {
        Freedom::new(&self.held, Counting::Matrix)
    }

    fn motions(&self) -> Vec<f64> {
        let freedom = self.freedom();
        let nodes = &self.part.mesh.nodes;
        let field = |motion: &[f64; 6]| nodes.iter().map(|at| freedom.displacement(motion, *at)).collect::<Vec<_>>();
        freedom.free.iter().flat_map(|motion| self.gather(&field(motion))).collect()
    }

    /// Free unknowns with springs to ground: as many as there are motions without strain.
    fn springs(&self) -> Vec<usize> {
        let pins = statics::pins(&self.held, &self.freedom());
        let place = |(node, component): (u32, usize)| self.free.binary_search(&(3 * node + component as u32)).ok();
        pins.into_iter().filter_map(place).collect()
    }

    pub(super) fn used(&self) -> Vec<bool> {
        used(self.part)
    }

    /// A field's values at the free unknowns.
    pub(super) fn gather(&self, field: &[V3]) -> Vec<f64> {
        self.free.iter().map(|&place| field[place as usize / 3][place as usize % 3]).collect()
    }

    /// The field of values of all unknowns: zero at those that are not free.
    pub(super) fn scatter(&self, values: &[f64]) -> Vec<V3> {
        let mut field = vec![[0.0; 3]; self.part.mesh.nodes.len()];
        self.free.iter().zip(values).for_each(|(&place, &u)| field[place as usize / 3][place as usize % 3] = u);
        field
    }

    /// Displacement of the nodes of a rigid interface by one of its coordinates; zero elsewhere.
    pub(super) fn moved(&self, interface: &Interface, component: usize) -> Vec<V3> {
        let mut field = vec![[0.0; 3]; self.part.mesh.nodes.len()];
        for node in nodes_of(self.part, &interface.region) {
            let arm = vector::sub(self.part.mesh.nodes[node as usize], interface.point);
            field[node as usize] = rigid_motions(arm)[component];
        }
        field
    }
}

impl Factored<'_, '_> {
    /// u with K u + Cᵀ λ = f, C u = d, in place: one right-hand side of the free unknowns after another; d is empty for zero.
    pub(super) fn solve(&self, forces: &mut [f64], wanted: &[f64]) {
        match &self.held {
            Some(held) => drop(held.solve(forces, wanted)),
            None => self.factor.solve(forces),
        }
    }

    /// How many modes there are.
    pub(super) fn dimension(&self) -> usize {
        self.held.as_ref().map_or(self.problem.free.len(), Held::dimension)
    }
}

fn held<'a>(part: &Part<'a>, interfaces: &[Interface]) -> Part<'a> {
    let coupling = |interface: &Interface| Coupling {
        region: interface.region.clone(),
        reference: interface.point,
        kind: interface.kind,
        held: [Some(0.0); 6],
    };
    let couplings = interfaces.iter().map(coupling).collect();
    Part { mesh: part.mesh, materials: part.materials.clone(), supports: Vec::new(), couplings }
}

fn faults(part: &Part<'_>, held: &Part<'_>, interfaces: &[Interface]) -> Vec<Fault> {
    let mut faults = Vec::new();
    if !part.supports.is_empty() || !part.couplings.is_empty() {
        faults.push(Fault::ReducedPartHeld);
    }
    if interfaces.is_empty() {
        faults.push(Fault::NoInterface);
    }
    let of_interface = |fault: Fault| match fault {
        Fault::EmptyCoupling(index) => Fault::EmptyInterface(index),
        Fault::CouplingOnLine(index) => Fault::InterfaceOnLine(index),
        other => other,
    };
    faults.extend(check::part(held).into_iter().map(of_interface));
    let mut owners = vec![None; part.mesh.nodes.len()];
    for (index, coupling) in held.couplings.iter().enumerate() {
        let nodes = nodes_of(part, &coupling.region);
        let told = |fault: &Fault| matches!(fault, Fault::EmptyInterface(i) | Fault::InterfaceOnLine(i) if *i == index);
        if !faults.iter().any(told) && !Spread::new(part.mesh, coupling).carries_moments() {
            faults.push(Fault::InterfaceOnLine(index));
        }
        if let Some((node, other)) = nodes.iter().find_map(|&node| Some((node, owners[node as usize]?))) {
            faults.push(Fault::InterfacesOverlap { node, interfaces: [other, index] });
        }
        nodes.iter().for_each(|&node| owners[node as usize] = Some(index));
    }
    faults
}

/// Nodes that belong to an element.
fn used(part: &Part<'_>) -> Vec<bool> {
    let mut used = vec![false; part.mesh.nodes.len()];
    for block in &part.mesh.blocks {
        block.nodes.iter().for_each(|&node| used[node as usize] = true);
    }
    used
}

/// Components of nodes of elements that no rigid interface takes.
fn free(part: &Part<'_>, interfaces: &[Interface]) -> Vec<u32> {
    let mut free = used(part);
    for interface in interfaces.iter().filter(|interface| interface.kind == CouplingKind::Rigid) {
        nodes_of(part, &interface.region).iter().for_each(|&node| free[node as usize] = false);
    }
    let nodes = (0..free.len() as u32).filter(|&node| free[node as usize]);
    nodes.flat_map(|node| 3 * node..3 * node + 3).collect()
}

/// Each node with one unknown: along x.
fn one_a_node(nodes: usize) -> Numbering {
    let tie = |node| Tie { group: node, columns: Some(Box::new([[1.0, 0.0, 0.0]])), fixed: [0.0; 3] };
    Numbering {
        ties: (0..nodes as u32).map(tie).collect(),
        groups: (0..nodes as u32).map(|first| Group { first, count: 1 }).collect(),
        frames: Vec::new(),
        equations: nodes,
    }
}

/// The same matrix for x, y and z.
fn three_a_node(one: &SymmetricMatrix) -> SymmetricMatrix {
    let mut three = SymmetricMatrix { size: 3 * one.size, starts: vec![0], ..SymmetricMatrix::default() };
    for column in 0..one.size {
        let entries = one.starts[column]..one.starts[column + 1];
        for component in 0..3 {
            three.rows.extend(one.rows[entries.clone()].iter().map(|row| 3 * row + component));
            three.values.extend_from_slice(&one.values[entries.clone()]);
            three.starts.push(three.rows.len());
        }
    }
    three
}

/// Rows and columns `kept`, ascending.
fn submatrix(matrix: &SymmetricMatrix, kept: &[u32]) -> SymmetricMatrix {
    let mut place = vec![u32::MAX; matrix.size];
    kept.iter().enumerate().for_each(|(new, &old)| place[old as usize] = new as u32);
    let mut part = SymmetricMatrix { size: kept.len(), starts: vec![0], ..SymmetricMatrix::default() };
    for &column in kept {
        for entry in matrix.starts[column as usize]..matrix.starts[column as usize + 1] {
            let row = place[matrix.rows[entry] as usize];
            if row != u32::MAX {
                part.rows.push(row);
                part.values.push(matrix.values[entry]);
            }
        }
        part.starts.push(part.rows.len());
    }
    part
}
