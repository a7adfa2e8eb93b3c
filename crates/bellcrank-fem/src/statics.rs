//! Displacements of a part under loads.
//!
//! One factorization serves every load case. Where the supports in the stiffness matrix leave motions of the whole
//! part free, as many components are pinned and the system is bordered: the frames of distributing couplings hold it
//! by multipliers, or inertia balances the loads (inertia relief).

use bellcrank_math::linalg::dense;

use crate::assemble::{self, Kind, Pattern};
use crate::freedom::{Counting, Freedom};
use crate::load::{self, Loaded};
use crate::numbering::{Numbering, nodes_of};
use crate::solver::System;
use crate::vector::{self, V3};
use crate::{CouplingKind, Fault, Load, Part, Settings, Support, check, field};

/// What to do with a part whose supports leave it free to move.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Free {
    /// Refuse it, naming the motions.
    Refused,
    /// Balance the loads by the inertia of the accelerations they cause (inertia relief).
    Relieved,
}

/// A factored part.
pub struct Statics<'a> {
    part: &'a Part<'a>,
    numbering: Numbering,
    system: System,
    /// Motions that the matrix leaves free.
    loose: Vec<Motion>,
    /// Motions that all supports leave free.
    relieved: Vec<Motion>,
    ties: Vec<Multiplier>,
    /// Size of the factor.
    pub effort: Effort,
}

/// Size of a solution.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Effort {
    /// Unknowns.
    pub equations: usize,
    /// Entries of the factor; 0 for conjugate gradients.
    pub factor_entries: usize,
}

/// A motion of the whole part: of its nodes and of the frames of its couplings.
struct Motion {
    field: Vec<V3>,
    frames: Vec<[f64; 6]>,
    /// Mass times the field.
    inertia: Vec<V3>,
}

/// A held component of the frame of a distributing coupling.
struct Multiplier {
    /// The nodal forces of a unit force on the component; its product with displacements is the component's motion.
    nodal: Vec<V3>,
    value: f64,
    /// Place of its coupling and component.
    at: (usize, usize),
    /// K⁻¹ times its forces on the unknowns.
    answer: Vec<f64>,
}

/// What a load case comes to; axes of the mesh, SI.
#[derive(Clone, Debug, Default)]
pub struct Solution {
    /// Displacement of every node, m.
    pub displacement: Vec<V3>,
    /// Displacement (m) and rotation (rad) of the frame of every coupling.
    pub frames: Vec<[f64; 6]>,
    /// Force of the supports on every node, N; zero where nothing holds it.
    pub reactions: Vec<V3>,
    /// Force (N) and moment (N·m) that holds the frame of every coupling.
    pub frame_reactions: Vec<[f64; 6]>,
    /// Temperature rise of every node, where there was one, K.
    pub temperature: Option<Vec<f64>>,
    /// Elastic energy, J.
    pub energy: f64,
    /// Largest force that no equation accounts for, relative to the largest nodal force.
    pub residual: f64,
    /// Resultant force and moment (about the origin) that inertia relief had to balance.
    pub relief: Option<[f64; 6]>,
}

impl<'a> Statics<'a> {
    /// Numbers, assembles and factors.
    ///
    /// # Errors
    /// Everything that is wrong with the part; which motions are free; that it does not fit into memory.
    pub fn new(part: &'a Part<'a>, free: Free, settings: &Settings<'_>) -> Result<Self, Vec<Fault>> {
        let faults = check::part(part);
        if !faults.is_empty() {
            return Err(faults);
        }
        let all = Freedom::new(part, Counting::All);
        if !all.free.is_empty() && free == Free::Refused {
            return Err(vec![Fault::UnderSupported(all.described())]);
        }
        let matrix = Freedom::new(part, Counting::Matrix);
        let pins = pins(part, &matrix);
        let numbering = Numbering::new(part, &pins)?;
        let pattern = Pattern::new(part, &numbering);
        let stiffness = assemble::matrix(part, &numbering, &pattern, Kind::Stiffness, settings.threads);
        let (system, factor_entries) =
            System::new(stiffness, settings).map_err(|failed| vec![failed.named(&numbering)])?;
        let effort = Effort { equations: numbering.equations, factor_entries };
        let loose = matrix.free.iter().map(|motion| Motion::new(part, &matrix, motion)).collect();
        let relieved = all.free.iter().map(|motion| Motion::new(part, &all, motion)).collect();
        let mut statics = Self { part, numbering, system, loose, relieved, ties: Vec::new(), effort };
        statics.ties = statics.multipliers()?;
        Ok(statics)
    }

    /// One load case.
    ///
    /// # Errors
    /// Loads on nothing; conjugate gradients that do not converge.
    pub fn solve(&self, loads: &[Load]) -> Result<Solution, Vec<Fault>> {
        let faults = check::loads(self.part, loads);
        if !faults.is_empty() {
            return Err(faults);
        }
        let mut loaded = Loaded::new(self.part, loads);
        if let Some(temperature) = &loaded.temperature {
            field::thermal_forces(self.part, temperature, &mut loaded.nodal);
        }
        let relief = self.relieve(&mut loaded);
        let held = self.numbering.displacement(&vec![0.0; self.numbering.equations], 1.0);
        let mut forces = loaded.nodal.clone();
        if held.iter().flatten().any(|u| *u != 0.0) {
            let (internal, _) = field::internal(self.part, &held, None);
            forces.iter_mut().zip(internal).for_each(|(force, internal)| *force = vector::sub(*force, internal));
        }
        let mut q = vec![0.0; self.numbering.equations];
        self.numbering.gather(&forces, &loaded.frames, &mut q);
        self.answer(&mut q)?;
        let (multipliers, shares) = self.border(&q, &forces, &loaded.frames, &held);
        for (tie, multiplier) in self.ties.iter().zip(&multipliers) {
            q.iter_mut().zip(&tie.answer).for_each(|(q, answer)| *q -= answer * multiplier);
        }
        let mut displacement = self.numbering.displacement(&q, 1.0);
        for (motion, share) in self.loose.iter().zip(&shares) {
            displacement
                .iter_mut()
                .zip(&motion.field)
                .for_each(|(u, m)| vector::accumulate(u, vector::scale(*m, *share)));
        }
        self.center(&mut displacement);
        Ok(self.finish(displacement, &loaded, &multipliers, relief))
    }

    /// Takes the mean motion out of what floats: it has no displacement of its own.
    fn center(&self, displacement: &mut [V3]) {
        let count = self.relieved.len();
        if count == 0 {
            return;
        }
        let matrix: Vec<Vec<f64>> = (0..count)
            .map(|i| (0..count).map(|j| product(&self.relieved[i].inertia, &self.relieved[j].field)).collect())
            .collect();
        let wanted: Vec<f64> = self.relieved.iter().map(|motion| product(&motion.inertia, displacement)).collect();
        let Some(shares) = dense::solve(&matrix, &wanted) else { return };
        for (motion, share) in self.relieved.iter().zip(shares) {
            displacement
                .iter_mut()
                .zip(&motion.field)
                .for_each(|(u, m)| vector::accumulate(u, vector::scale(*m, -share)));
        }
    }

    /// Subtracts the inertia of the accelerations that unbalanced loads cause; their resultant about the origin.
    fn relieve(&self, loaded: &mut Loaded) -> Option<[f64; 6]> {
        let count = self.relieved.len();
        if count == 0 {
            return None;
        }
        let matrix: Vec<Vec<f64>> = (0..count)
            .map(|i| (0..count).map(|j| product(&self.relieved[i].inertia, &self.relieved[j].field)).collect())
            .collect();
        let pushed: Vec<f64> = self.relieved.iter().map(|motion| motion.work(&loaded.nodal, &loaded.frames)).collect();
        let accelerations = dense::solve(&matrix, &pushed)?;
        let mut resultant = [0.0; 6];
        for (motion, acceleration) in self.relieved.iter().zip(accelerations) {
            for (node, inertia) in motion.inertia.iter().enumerate() {
                let force = vector::scale(*inertia, acceleration);
                loaded.nodal[node] = vector::sub(loaded.nodal[node], force);
                let moment = vector::cross(self.part.mesh.nodes[node], force);
                (0..3).for_each(|i| {
                    resultant[i] += force[i];
                    resultant[3 + i] += moment[i];
                });
            }
        }
        Some(resultant)
    }

    fn multipliers(&self) -> Result<Vec<Multiplier>, Vec<Fault>> {
        let mut ties = Vec::new();
        for (index, coupling) in self.part.couplings.iter().enumerate() {
            if coupling.kind != CouplingKind::Distributing {
                continue;
            }
            for component in 0..6 {
                if let Some(value) = coupling.held[component] {
                    let nodal = self.unit(index, component);
                    let mut answer = vec![0.0; self.numbering.equations];
                    self.numbering.gather(&nodal, &[], &mut answer);
                    self.answer(&mut answer)?;
                    ties.push(Multiplier { nodal, value, at: (index, component), answer });
                }
            }
        }
        Ok(ties)
    }

    fn answer(&self, q: &mut [f64]) -> Result<(), Vec<Fault>> {
        self.system.solve(q).map_err(|failed| vec![failed.named(&self.numbering)])
    }

    /// Nodal forces of a unit force or moment on the frame of a distributing coupling.
    fn unit(&self, coupling: usize, component: usize) -> Vec<V3> {
        let unit: [f64; 6] = std::array::from_fn(|i| f64::from(i == component));
        let mut nodal = vec![[0.0; 3]; self.part.mesh.nodes.len()];
        let (force, moment) = ([unit[0], unit[1], unit[2]], [unit[3], unit[4], unit[5]]);
        load::spread(self.part.mesh, &self.part.couplings[coupling], force, moment, &mut nodal);
        nodal
    }

    /// Multipliers of the held frames and shares of the loose motions: C u = d, Zᵀ (f − Cᵀ λ) = 0 with
    /// u = K⁻¹ (f − Cᵀ λ) + Z α.
    fn border(&self, q: &[f64], forces: &[V3], frames: &[[f64; 6]], held: &[V3]) -> (Vec<f64>, Vec<f64>) {
        let (ties, loose) = (self.ties.len(), self.loose.len());
        if ties == 0 {
            return (Vec::new(), vec![0.0; loose]);
        }
        let moved = self.numbering.displacement(q, 0.0);
        let answers: Vec<Vec<V3>> = self.ties.iter().map(|tie| self.numbering.displacement(&tie.answer, 0.0)).collect();
        let size = (0..ties).map(|i| product(&self.ties[i].nodal, &answers[i])).fold(0.0, f64::max);
        let mut matrix = vec![vec![0.0; ties + loose]; ties + loose];
        let mut rhs = vec![0.0; ties + loose];
        for i in 0..ties {
            let tie = &self.ties[i];
            (0..ties).for_each(|j| matrix[i][j] = -product(&tie.nodal, &answers[j]) / size);
            rhs[i] = tie.value - product(&tie.nodal, held) - product(&tie.nodal, &moved);
            for k in 0..loose {
                let moved = product(&tie.nodal, &self.loose[k].field);
                (matrix[i][ties + k], matrix[ties + k][i]) = (moved, moved);
            }
        }
        (0..loose).for_each(|k| rhs[ties + k] = size * self.loose[k].work(forces, frames));
        let x = least_squares(&matrix, &rhs);
        (x[..ties].iter().map(|x| x / size).collect(), x[ties..].to_vec())
    }

    fn finish(
        &self,
        displacement: Vec<V3>,
        loaded: &Loaded,
        multipliers: &[f64],
        relief: Option<[f64; 6]>,
    ) -> Solution {
        let part = self.part;
        let temperature = loaded.temperature.clone();
        let (internal, energy) = field::internal(part, &displacement, temperature.as_deref());
        // The thermal part is on both sides: once in the stresses, once in the loads.
        let mut applied = loaded.nodal.clone();
        if let Some(temperature) = &temperature {
            let mut thermal = vec![[0.0; 3]; applied.len()];
            field::thermal_forces(part, temperature, &mut thermal);
            applied.iter_mut().zip(thermal).for_each(|(a, t)| *a = vector::sub(*a, t));
        }
        let mut reactions: Vec<V3> = internal.iter().zip(&applied).map(|(i, a)| vector::sub(*i, *a)).collect();
        self.springs(&displacement, &mut reactions);
        let mut frame_reactions = vec![[0.0; 6]; part.couplings.len()];
        for (tie, multiplier) in self.ties.iter().zip(multipliers) {
            frame_reactions[tie.at.0][tie.at.1] = -multiplier;
            reactions
                .iter_mut()
                .zip(&tie.nodal)
                .for_each(|(r, n)| vector::accumulate(r, vector::scale(*n, *multiplier)));
        }
        let residual = self.residual(&reactions, &internal, &loaded.frames);
        self.rigid_reactions(&mut reactions, &mut frame_reactions, &loaded.frames);
        self.clean(&mut reactions, &displacement);
        let frames = self.frame_motions(&displacement);
        let energy = energy / 2.0;
        Solution { displacement, frames, reactions, frame_reactions, temperature, energy, residual, relief }
    }

    /// Springs hold with −k u; what is left of `reactions` is what other supports hold.
    fn springs(&self, displacement: &[V3], reactions: &mut [V3]) {
        for support in &self.part.supports {
            if let Support::Spring { nodes, stiffness } = support {
                for &node in nodes {
                    let u = displacement[node as usize];
                    let share: V3 = std::array::from_fn(|i| stiffness[i] * u[i] / nodes.len() as f64);
                    vector::accumulate(&mut reactions[node as usize], share);
                }
            }
        }
    }

    /// What is left over on the unknowns, relative to the largest force that the stresses put on a node.
    fn residual(&self, reactions: &[V3], internal: &[V3], frames: &[[f64; 6]]) -> f64 {
        let mut left = vec![0.0; self.numbering.equations];
        let negative: Vec<[f64; 6]> = frames.iter().map(|frame| frame.map(|f| -f)).collect();
        self.numbering.gather(reactions, &negative, &mut left);
        let size = internal.iter().flatten().fold(0.0_f64, |size, f| size.max(f.abs()));
        let most = left.iter().fold(0.0_f64, |size, f| size.max(f.abs()));
        if size > 0.0 { most / size } else { most }
    }

    /// The resultant of what holds the nodes of a rigid coupling is what holds its frame.
    fn rigid_reactions(&self, reactions: &mut [V3], held: &mut [[f64; 6]], loads: &[[f64; 6]]) {
        for (index, coupling) in self.part.couplings.iter().enumerate() {
            if coupling.kind != CouplingKind::Rigid {
                continue;
            }
            let mut sum = loads[index].map(|load| -load);
            for node in nodes_of(self.part, &coupling.region) {
                let force = std::mem::take(&mut reactions[node as usize]);
                let arm = vector::sub(self.part.mesh.nodes[node as usize], coupling.reference);
                let moment = vector::cross(arm, force);
                (0..3).for_each(|i| {
                    sum[i] += force[i];
                    sum[3 + i] += moment[i];
                });
            }
            for (k, sum) in sum.into_iter().enumerate() {
                held[index][k] = if coupling.held[k].is_some() { sum } else { 0.0 };
            }
        }
    }

    /// Nodes that nothing holds have no reaction, only rounding; springs hold with −k u.
    fn clean(&self, reactions: &mut [V3], displacement: &[V3]) {
        let mut held = vec![false; reactions.len()];
        for support in &self.part.supports {
            if let Support::Fixed { nodes, .. } = support {
                nodes.iter().for_each(|&node| held[node as usize] = true);
            }
        }
        reactions.iter_mut().zip(held).filter(|(_, held)| !held).for_each(|(reaction, _)| *reaction = [0.0; 3]);
        let mut springs = vec![[0.0; 3]; reactions.len()];
        self.springs(displacement, &mut springs);
        reactions.iter_mut().zip(springs).for_each(|(reaction, force)| *reaction = vector::sub(*reaction, force));
    }

    fn frame_motions(&self, displacement: &[V3]) -> Vec<[f64; 6]> {
        (0..self.part.couplings.len())
            .map(|index| match self.part.couplings[index].kind {
                CouplingKind::Distributing => std::array::from_fn(|component| {
                    let unit = self.unit(index, component);
                    unit.iter().zip(displacement).map(|(n, u)| vector::dot(*n, *u)).sum()
                }),
                CouplingKind::Rigid => rigid_frame(self.part, index, displacement),
            })
            .collect()
    }
}

impl Motion {
    fn new(part: &Part<'_>, freedom: &Freedom, motion: &[f64; 6]) -> Self {
        let field = field_of(part, freedom, motion);
        let inertia = field::inertia(part, &field);
        let frames = part.couplings.iter().map(|coupling| freedom.frame(motion, coupling.reference)).collect();
        Self { field, frames, inertia }
    }

    /// Work of forces on nodes and on the frames of rigid couplings.
    fn work(&self, nodal: &[V3], frames: &[[f64; 6]]) -> f64 {
        let on_frames: f64 = self.frames.iter().flatten().zip(frames.iter().flatten()).map(|(u, f)| u * f).sum();
        product(&self.field, nodal) + on_frames
    }
}

fn product(a: &[V3], b: &[V3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| vector::dot(*a, *b)).sum()
}

fn field_of(part: &Part<'_>, freedom: &Freedom, motion: &[f64; 6]) -> Vec<V3> {
    part.mesh.nodes.iter().map(|&node| freedom.displacement(motion, node)).collect()
}

/// Components to pin, of nodes that are free.
pub(crate) fn pins(part: &Part<'_>, freedom: &Freedom) -> Vec<(u32, usize)> {
    if freedom.free.is_empty() {
        return Vec::new();
    }
    let mut usable = vec![false; part.mesh.nodes.len()];
    for block in &part.mesh.blocks {
        block.nodes.iter().for_each(|&node| usable[node as usize] = true);
    }
    for support in &part.supports {
        let (Support::Fixed { nodes, .. } | Support::Spring { nodes, .. }) = support;
        nodes.iter().for_each(|&node| usable[node as usize] = false);
    }
    for coupling in part.couplings.iter().filter(|coupling| coupling.kind == CouplingKind::Rigid) {
        nodes_of(part, &coupling.region).iter().for_each(|&node| usable[node as usize] = false);
    }
    freedom.pins(&part.mesh.nodes, |node| usable[node])
}

/// The shortest solution of a small symmetric system that may be singular.
fn least_squares(matrix: &[Vec<f64>], rhs: &[f64]) -> Vec<f64> {
    let size = rhs.len();
    let Some(svd) = dense::svd(matrix, size) else { return vec![f64::NAN; size] };
    let largest = svd.values.first().copied().unwrap_or(0.0);
    let mut x = vec![0.0; size];
    for ((value, left), right) in svd.values.iter().zip(&svd.left).zip(&svd.right) {
        if *value > 1e-11 * largest {
            let share = left.iter().zip(rhs).map(|(l, b)| l * b).sum::<f64>() / value;
            x.iter_mut().zip(right).for_each(|(x, r)| *x += share * r);
        }
    }
    x
}

/// Displacement and rotation of the frame of a rigid coupling, from its nodes.
fn rigid_frame(part: &Part<'_>, coupling: usize, displacement: &[V3]) -> [f64; 6] {
    let coupling = &part.couplings[coupling];
    let nodes = nodes_of(part, &coupling.region);
    let count = nodes.len() as f64;
    let mean = |of: &dyn Fn(usize) -> V3| {
        let sum = nodes.iter().fold([0.0; 3], |sum, &node| vector::add(sum, of(node as usize)));
        vector::scale(sum, 1.0 / count)
    };
    let (center, shift) = (mean(&|node| part.mesh.nodes[node]), mean(&|node| displacement[node]));
    let (mut moments, mut turned) = ([[0.0; 3]; 3], [0.0; 3]);
    for &node in &nodes {
        let r = vector::sub(part.mesh.nodes[node as usize], center);
        vector::accumulate(&mut turned, vector::cross(r, displacement[node as usize]));
        for i in 0..3 {
            moments[i][i] += vector::dot(r, r);
            (0..3).for_each(|j| moments[i][j] -= r[i] * r[j]);
        }
    }
    let turn = vector::solve(&moments, turned).unwrap_or([0.0; 3]);
    let at = vector::add(shift, vector::cross(turn, vector::sub(coupling.reference, center)));
    [at[0], at[1], at[2], turn[0], turn[1], turn[2]]
}
