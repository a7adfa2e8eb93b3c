//! Consistent beginnings: velocities that constraints and drives allow, then accelerations and multipliers.

use super::articulated::Articulated;
use super::door::{Begun, Dynamics, Method, SolverEffort, Surroundings};
use super::flight::{Flight, Storm};
use super::implicit::Alpha;
use super::locks::Act;
use super::mixing::Mixing;
use super::saddle::Saddle;
use super::step::Step;
use super::stiffness::Jacobian;
use crate::forces::Element;
use crate::mass_matrix::MassMatrix;
use crate::mechanism::Source;
use crate::solver::{LARGE, Machine, RANK};
use crate::{Coordinate, MechanismError, Reading, Redundancy, kinematics};
use bellcrank_math::{Space, linalg::dense};

/// Beyond so many coordinates a tree is solved body by body.
const LONG: usize = 24;
/// Given velocities may miss by this much (relative, and absolute in machine sizes or rad a second).
const MISSED: f64 = 1e-8;

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn take_off(
        &mut self,
        dynamics: &Dynamics,
        around: &mut dyn Surroundings,
    ) -> Result<(Flight<S>, Begun), MechanismError> {
        self.check_list(&dynamics.driven)?;
        self.check_list(&dynamics.velocities.iter().map(|v| v.0).collect::<Vec<_>>())?;
        self.time = 0.0;
        self.reset_unwrapped();
        let (freedom, redundant) = self.freedom_beside(&dynamics.driven)?;
        let mut f = self.new_flight(dynamics, !redundant.is_empty());
        self.rebuild(&mut f);
        self.friction.fill(0.0);
        self.first_velocities(&mut f, around)?;
        f.watching = self.watches(dynamics.switches);
        self.first_locks(&mut f, around)?;
        self.accelerate(&mut f, around)?;
        self.answer_forces(&mut f);
        let energy = self.solved().energy();
        f.step.end = 0.0;
        f.step.wished = 0.0;
        f.step.implicit = matches!(dynamics.method, Method::GeneralizedAlpha { .. });
        self.begin_anew(&mut f, around, &[])?;
        f.step.t0 = 0.0;
        f.step.t1 = 0.0;
        f.effort = SolverEffort::default();
        Ok((f, Begun { freedom, redundant, energy: energy.kinetic + energy.potential }))
    }

    pub(crate) fn new_flight(&mut self, dynamics: &Dynamics, redundant: bool) -> Flight<S> {
        let driven: Vec<Source> = dynamics.driven.iter().filter_map(|c| self.mech.source(*c)).collect();
        let tree = self.long_tree(&driven);
        let mass = if tree.is_some() { MassMatrix::empty() } else { MassMatrix::new(&self.mech) };
        let saddle = Saddle::new(&self.mech, &self.rows, &mass, &driven, redundant);
        let movable = self.movable_elements(&dynamics.driven);
        Flight {
            drive: vec![Reading::default(); driven.len()],
            target: Vec::new(),
            velocity: Vec::new(),
            acceleration: Vec::new(),
            gamma: Vec::new(),
            mu: Vec::new(),
            load: vec![0.0; self.mech.nv],
            step: Step::new(self.mech.nq + self.mech.nv),
            mixing: Mixing::new(self.mech.elements.len()),
            before: vec![0.0; self.mech.elements.len()],
            pending: Vec::new(),
            effort: SolverEffort::default(),
            modes: Vec::new(),
            locks: Vec::new(),
            acts: vec![Act::Passive; self.mech.elements.len()],
            movable,
            watching: super::watch::Watching::default(),
            storm: Storm::default(),
            jacobian: Jacobian::new(),
            alpha: Alpha::default(),
            dynamics: dynamics.clone(),
            mass,
            saddle,
            tree,
            redundant,
            driven,
        }
    }

    /// Articulated bodies where nothing constrains a long tree, now or at an event.
    fn long_tree(&self, driven: &[Source]) -> Option<Articulated> {
        let locks = self.mech.elements.iter().any(|e| source_of(e).is_some());
        let measured = driven.iter().any(|s| matches!(s, Source::Measured { .. }));
        let deforms = !self.mech.flexible.is_empty();
        if self.mech.nv <= LONG || self.mech.rows() > 0 || locks || measured || deforms {
            return None;
        }
        let prescribed: Vec<usize> = driven.iter().filter_map(|s| self.component_of(*s)).collect();
        Some(Articulated::new(&self.mech, |v| prescribed.contains(&v)))
    }

    /// Masses as a matrix from now on.
    pub(crate) fn use_masses(&mut self, f: &mut Flight<S>) {
        if f.tree.take().is_some() {
            f.mass = MassMatrix::new(&self.mech);
            self.rebuild(f);
        }
    }

    fn component_of(&self, source: Source) -> Option<usize> {
        match source {
            Source::Node(n) => Some(self.mech.nodes[n].v),
            Source::Measured { .. } => None,
        }
    }

    /// Degrees of freedom that the driven coordinates leave, and equations that depend on others.
    pub(crate) fn freedom_beside(&mut self, driven: &[Coordinate]) -> Result<(usize, Vec<Redundancy>), MechanismError> {
        let nv = self.mech.nv;
        if nv > LARGE {
            return Ok((nv.saturating_sub(self.mech.rows() + driven.len()), Vec::new()));
        }
        let rank = self.ranks().1;
        let a = self.scaled_jacobian();
        let redundant = if rank < a.len() { self.dependent_rows(&a) } else { Vec::new() };
        let rows = self.prescribed_rows(driven);
        let both = dense::rank(&[a, rows].concat(), nv, RANK);
        if both < rank + driven.len() && driven.len() > nv - rank || both < self.rank_here_and(driven.len()) {
            let conflicting = self.conflicting(driven);
            return Err(MechanismError::OverDriven { freedom: nv - rank, driven: driven.len(), conflicting });
        }
        Ok((nv - rank - driven.len(), redundant))
    }

    /// Rank that the constraints here and so many independent drives would have.
    fn rank_here_and(&mut self, driven: usize) -> usize {
        let a = self.scaled_jacobian();
        dense::rank(&a, self.mech.nv, RANK) + driven
    }

    /// For each element with a coordinate, whether that coordinate can move beside the driven ones.
    fn movable_elements(&mut self, driven: &[Coordinate]) -> Vec<bool> {
        let sources: Vec<Option<Source>> = self.mech.elements.iter().map(source_of).collect();
        let any = sources.iter().any(Option::is_some);
        if !any || self.mech.nv > LARGE {
            return vec![true; sources.len()];
        }
        let mut rows = self.scaled_jacobian();
        rows.extend(self.prescribed_rows(driven));
        let rank = dense::rank(&rows, self.mech.nv, RANK);
        let moves = |source: &Option<Source>| match source {
            None => true,
            Some(source) => {
                let one = crate::solver::SparseRows::of_sources(&self.mech, &self.x, &[*source]).dense(self.mech.nv);
                dense::rank(&[rows.clone(), one].concat(), self.mech.nv, RANK) > rank
            }
        };
        sources.iter().map(moves).collect()
    }

    /// Velocities that meet drives and given ones; the rest is as near to zero as the masses let it be.
    fn first_velocities(&mut self, f: &mut Flight<S>, around: &mut dyn Surroundings) -> Result<(), MechanismError> {
        self.v.fill(0.0);
        self.a.fill(0.0);
        self.take_drives(f, around)?;
        self.refactor(f)?;
        if self.project_positions(f).is_none() {
            return Err(self.not_closed(f));
        }
        self.take_drives(f, around)?;
        let given: Vec<(Source, f64)> =
            f.dynamics.velocities.iter().filter_map(|&(c, v)| Some((self.mech.source(c)?, v))).collect();
        if f.tree.is_some() && given.iter().all(|(source, _)| self.component_of(*source).is_some()) {
            // Nothing constrains a tree: its coordinates take their velocities as they are.
            for (source, velocity) in given {
                if let Some(v) = self.component_of(source) {
                    self.v[v] = velocity;
                }
            }
            return Ok(());
        }
        self.impose_velocities(f, &given)
    }

    /// Factors at the present position.
    pub(crate) fn refactor(&mut self, f: &mut Flight<S>) -> Result<(), MechanismError> {
        self.update_positions();
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        self.factor_masses(f)
    }

    fn not_closed(&mut self, f: &Flight<S>) -> MechanismError {
        let coordinate = f.dynamics.driven.first().copied();
        let coordinate = coordinate.unwrap_or(Coordinate { joint: crate::JointId(0), index: 0 });
        let reached = self.solved().coordinate(coordinate).position;
        let asked = f.target.first().copied().unwrap_or(reached);
        MechanismError::Stopped { coordinate, reached, asked, singular_value: 0.0, mobile: Vec::new() }
    }

    /// The smallest velocities (rad/s, machine sizes a second) that meet constraints, drives and the given ones.
    fn impose_velocities(&mut self, f: &mut Flight<S>, given: &[(Source, f64)]) -> Result<(), MechanismError> {
        self.use_masses(f);
        self.refactor(f)?;
        let mut saddle = f.saddle.clone();
        for (source, _) in given {
            saddle = saddle.with_row(&self.mech, &self.rows, &f.mass, *source);
        }
        saddle.fill(&self.mech, &self.rows, &f.mass, &self.x);
        saddle.take_unit_masses();
        if !saddle.factor() {
            return Err(self.missing_mass(f));
        }
        let (mut gamma, mut mu) = (vec![0.0; saddle.rows], vec![0.0; saddle.rows]);
        for _ in 0..3 {
            self.fill_rates(f);
            gamma[..f.saddle.rows].copy_from_slice(&f.gamma);
            for (k, (source, wanted)) in given.iter().enumerate() {
                gamma[f.saddle.rows + k] = wanted - self.rate_of_source(*source);
            }
            f.load.fill(0.0);
            self.scratch.delta.fill(0.0);
            saddle.solve(&f.load, &gamma, &mut self.scratch.delta, &mut mu);
            self.v.iter_mut().zip(&self.scratch.delta).for_each(|(v, d)| *v += d);
        }
        // What the constraints do not allow is taken back.
        self.project_velocities(f, 2);
        kinematics::velocities(&self.mech, &self.v, &mut self.x);
        let missed = |k: usize, (source, wanted): &(Source, f64)| {
            let is = self.rate_of_source(*source);
            let misses = (is - wanted).abs() > MISSED * (wanted.abs() + self.unit_of(*source));
            misses.then(|| (f.dynamics.velocities[k].0, *wanted, is))
        };
        let conflicting: Vec<_> = given.iter().enumerate().filter_map(|(k, g)| missed(k, g)).collect();
        if conflicting.is_empty() { Ok(()) } else { Err(MechanismError::VelocityConflict { conflicting }) }
    }
}

fn source_of<S: Space>(element: &Element<S>) -> Option<Source> {
    match element {
        Element::Friction(f) => Some(f.source),
        Element::Stop { source, .. } => Some(*source),
        _ => None,
    }
}
