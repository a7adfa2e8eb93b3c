//! Bodies that bend while their machine is driven: quasi-static deformation in inverse dynamics.
//!
//! The elastic coordinates d are prescribed like drives, at rest; the efforts r(d) that hold them there vanish when
//! bodies carry their loads by their own stiffness: `r(d) = 0` by Newton, with the stiffness matrix for the slope as
//! long as that contracts, with the exact one (dual numbers through the loops) where it does not. Rates of the
//! deformation itself are left out: what moves is the machine of the present shapes.

use super::machine::{Machine, Stage};
use super::tangent::Tangent;
use crate::{Actuation, Coordinate, Inputs, MechanismError, Moved, Prescription, Readings, SEEDS, Seeded};
use bellcrank_math::linalg::BandLu;
use bellcrank_math::{Real, Space};

/// Corrections below this part of the largest deformation end the iteration.
const SETTLED: f64 = 1e-11;
/// The same of the machine's size: where nothing bends.
const STRAIGHT: f64 = 1e-15;
/// Corrections that do not shrink to this part ask for the exact slope.
const CONTRACTS: f64 = 0.2;
const MOST_ITERATIONS: usize = 80;
/// Farthest step in machine sizes of displacement.
const FARTHEST: f64 = 0.05;

/// Deformation that follows the motion.
#[derive(Debug)]
pub(crate) struct Settling {
    /// Coordinates of the user's drives come first everywhere; so many in positions, rates, efforts.
    users: [usize; 3],
    /// Value of each elastic coordinate at which its displacement is 1 m.
    metre: Vec<f64>,
    slope: BandLu,
    /// The slope is that of the present position, exact.
    exact: bool,
    /// Prescribed positions, velocities and accelerations with those of the elastic coordinates.
    position: Vec<f64>,
    velocity: Vec<f64>,
    acceleration: Vec<f64>,
    correction: Vec<f64>,
}

impl Settling {
    fn bends(&self) -> usize {
        self.metre.len()
    }
    fn extend(into: &mut Vec<f64>, given: &[f64], count: usize) {
        into.clear();
        into.extend_from_slice(given);
        into.resize(given.len() + count, 0.0);
    }
    /// Largest displacement of a list, m.
    fn size(&self, list: &[f64]) -> f64 {
        list.iter().zip(&self.metre).fold(0.0, |m: f64, (d, unit)| m.max((d / unit).abs()))
    }
}

impl<S: Space<T = f64>> Machine<S> {
    /// Coordinates of the deformation of all flexible bodies.
    pub(crate) fn elastic(&self) -> Vec<Coordinate> {
        let joints = self.blueprint.flexible.iter().flat_map(|body| body.interfaces.iter().chain(&body.modes));
        joints
            .flat_map(|joint| (0..self.mech.sources[joint.0].len()).map(|index| Coordinate { joint: *joint, index }))
            .collect()
    }

    /// The given places with every deformation at its start, or none.
    pub(crate) fn hold_shapes(&self, hold: &[(Coordinate, f64)]) -> Vec<(Coordinate, f64)> {
        let start = |c: &Coordinate| self.blueprint.joints[c.joint.0].start.get(c.index).copied().flatten();
        let asked = |c: &Coordinate| hold.iter().any(|(of, _)| of == c);
        let shapes = self.elastic().into_iter().filter(|c| !asked(c));
        hold.iter().copied().chain(shapes.map(|c| (c, start(&c).unwrap_or(0.0)))).collect()
    }

    /// Prepares for drives with the elastic coordinates beside them.
    pub(crate) fn prepare_bent(&mut self, actuation: &Actuation) -> Result<(), MechanismError> {
        let elastic: Vec<Coordinate> = self.elastic().into_iter().filter(|c| !actuation.position.contains(c)).collect();
        if elastic.is_empty() {
            self.settling = None;
            return self.prepare_systems(actuation);
        }
        let with = |list: &[Coordinate]| list.iter().chain(&elastic).copied().collect::<Vec<_>>();
        let lists = [&actuation.position, &actuation.rate, &actuation.effort];
        let [position, rate, effort] = lists.map(|list| with(list));
        let users = lists.map(Vec::len);
        self.prepare_systems(&Actuation { position, rate, effort }).map_err(|error| self.without_shapes(error))?;
        let metre = elastic.iter().map(|c| self.metre_of(*c)).collect();
        let places = self.prepared.as_ref().map_or_else(Vec::new, |prepared| prepared.targets.clone());
        self.settling = Some(Box::new(Settling {
            users,
            metre,
            slope: self.stiffness_of(&elastic),
            exact: false,
            position: places,
            velocity: Vec::new(),
            acceleration: Vec::new(),
            correction: vec![0.0; elastic.len()],
        }));
        Ok(())
    }

    /// What the user drives, in what went wrong. Loops that close only by bending cannot be moved shape by shape.
    fn without_shapes(&self, error: MechanismError) -> MechanismError {
        let elastic = self.elastic();
        let bends = |c: &Coordinate| elastic.contains(c);
        match error {
            MechanismError::OverDriven { conflicting, .. } if conflicting.iter().any(bends) => {
                MechanismError::BendsToClose { equations: conflicting.iter().filter(|c| bends(c)).count() }
            }
            MechanismError::OverDriven { freedom, driven, conflicting } => {
                let [freedom, driven] = [freedom, driven].map(|count| count.saturating_sub(elastic.len()));
                MechanismError::OverDriven { freedom, driven, conflicting }
            }
            MechanismError::UnderDriven { freedom, driven, mut free } => {
                free.retain(|c| !bends(c));
                let [freedom, driven] = [freedom, driven].map(|count| count.saturating_sub(elastic.len()));
                MechanismError::UnderDriven { freedom, driven, free }
            }
            other => other,
        }
    }

    fn metre_of(&self, c: Coordinate) -> f64 {
        let Some(crate::mechanism::Source::Node(node)) = self.mech.source(c) else { return 1.0 };
        let find =
            |body: &crate::flexible::Deforming<S>| body.nodes.iter().position(|n| *n == node).map(|e| body.metre[e]);
        self.mech.flexible.iter().find_map(find).unwrap_or(1.0)
    }

    /// Stiffness over the elastic coordinates, factored.
    fn stiffness_of(&self, elastic: &[Coordinate]) -> BandLu {
        let n = elastic.len();
        let mut lu = BandLu::new(n, n, n);
        let place = |node: usize| {
            elastic.iter().position(|c| self.mech.source(*c) == Some(crate::mechanism::Source::Node(node)))
        };
        for body in &self.mech.flexible {
            let places: Vec<Option<usize>> = body.nodes.iter().map(|node| place(*node)).collect();
            for (i, to) in places.iter().enumerate() {
                for (j, from) in places.iter().enumerate() {
                    if let (Some(to), Some(from)) = (to, from) {
                        lu.add(*to, *from, body.data.stiffness[i * places.len() + j]);
                    }
                }
            }
        }
        lu.factor();
        lu
    }

    /// Moves the user's drives; the shapes stay as they are.
    pub(crate) fn move_bent(&mut self, time: f64, targets: &[f64]) -> Result<Moved, MechanismError> {
        let Some(mut settling) = self.settling.take() else { return self.continue_to(time, targets) };
        settling.position[..targets.len()].copy_from_slice(targets);
        let moved = self.continue_to(time, &settling.position);
        self.settling = Some(settling);
        moved
    }

    /// Rates of the user's drives; shapes rest.
    pub(crate) fn rates_bent(&mut self, velocity: &[f64], acceleration: &[f64]) -> Result<Moved, MechanismError> {
        let Some(mut settling) = self.settling.take() else { return self.solve_rates(velocity, acceleration) };
        let count = settling.bends();
        Settling::extend(&mut settling.velocity, velocity, count);
        Settling::extend(&mut settling.acceleration, acceleration, count);
        let moved = self.solve_rates(&settling.velocity, &settling.acceleration);
        self.settling = Some(settling);
        moved
    }

    /// Efforts of the drives, with every body bent by what it carries.
    pub(crate) fn efforts_bent(&mut self, inputs: Inputs<'_, f64>) -> Result<(), MechanismError> {
        let Some(mut settling) = self.settling.take() else {
            self.ask_inputs(inputs)?;
            return self.solve_efforts();
        };
        settling.exact = false;
        let result = self.settle_shapes(&mut settling, inputs);
        self.settling = Some(settling);
        result
    }

    fn settle_shapes(&mut self, s: &mut Settling, inputs: Inputs<'_, f64>) -> Result<(), MechanismError> {
        let mut before = f64::INFINITY;
        for _ in 0..MOST_ITERATIONS {
            self.ask_inputs(inputs)?;
            self.solve_efforts()?;
            let mut size = self.correct_shapes(s);
            if size > CONTRACTS * before && !s.exact {
                s.slope = self.exact_slope(s)?;
                s.exact = true;
                size = self.correct_shapes(s);
            }
            if !size.is_finite() {
                return Err(MechanismError::NotFinite("the deformation of a body"));
            }
            let bent = s.size(&s.position[s.users[0]..]);
            if size <= SETTLED * bent + STRAIGHT * self.mech.size {
                return Ok(());
            }
            // An exact slope of far away is none of here.
            s.exact &= size < CONTRACTS * before;
            before = size;
            self.bend(s, (FARTHEST * self.mech.size / size).min(1.0))?;
        }
        Err(MechanismError::NotSettled { part: before / self.mech.size })
    }

    /// The next correction of the shapes; its size, m.
    fn correct_shapes(&self, s: &mut Settling) -> f64 {
        let held = &self.drive[s.users[2]..];
        s.correction.iter_mut().zip(held).for_each(|(c, r)| *c = -r);
        s.slope.solve(&mut s.correction);
        s.size(&s.correction)
    }

    /// Shapes by a part of their correction, loops closed, rates and all that follows.
    fn bend(&mut self, s: &mut Settling, part: f64) -> Result<(), MechanismError> {
        let first = s.users[0];
        s.position[first..].iter_mut().zip(&s.correction).for_each(|(d, c)| *d += part * c);
        self.close_bent(s)?;
        self.solve_rates(&s.velocity, &s.acceleration).map(|_| ())
    }

    fn close_bent(&mut self, s: &Settling) -> Result<(), MechanismError> {
        let Some(mut prepared) = self.prepared.take() else {
            return Err(MechanismError::NotFinite("no actuation prepared"));
        };
        let near = self.correct_to(&mut prepared.position, &s.position);
        if near {
            prepared.targets.copy_from_slice(&s.position);
        }
        self.prepared = Some(prepared);
        if near { Ok(()) } else { self.continue_to(self.time, &s.position).map(|_| ()) }
    }

    /// `∂r/∂d` at the present position, inputs held, factored.
    fn exact_slope(&mut self, s: &Settling) -> Result<BandLu, MechanismError> {
        let seeded = self.blueprint.map(Seeded::from_f64);
        let plain = Tangent::new(&seeded).map_err(|_| MechanismError::NotFinite("the machine's numbers"))?;
        let kept = self.tangent.replace(Box::new(plain));
        let slope = self.slope_by_lanes(s);
        self.tangent = kept;
        slope
    }

    fn slope_by_lanes(&mut self, s: &Settling) -> Result<BandLu, MechanismError> {
        let n = s.bends();
        let mut lu = BandLu::new(n, n, n);
        let values: Vec<Seeded> = self.inputs.iter().map(|x| Seeded::from_re(*x)).collect();
        for first in (0..n).step_by(SEEDS) {
            let mut position = constants(&s.position);
            for lane in 0..SEEDS.min(n - first) {
                position[s.users[0] + first + lane].eps[lane] = 1.0;
            }
            let inputs = &mut |_: &dyn Readings<Seeded>, into: &mut [Seeded]| into.copy_from_slice(&values);
            self.carry_bent(s, Seeded::from_re(self.time), &position, None, inputs)?;
            let held = self.seeded_drives(s);
            for lane in 0..SEEDS.min(n - first) {
                held.iter().enumerate().for_each(|(row, r)| lu.add(row, first + lane, r.eps[lane]));
            }
        }
        lu.factor();
        Ok(lu)
    }

    fn seeded_drives(&self, s: &Settling) -> Vec<Seeded> {
        let count = s.users[2]..s.users[2] + s.bends();
        self.derivatives_now().map_or_else(Vec::new, |at| count.map(|i| at.drive(i)).collect())
    }

    /// Derivatives with these positions; rates are the settled ones unless given.
    fn carry_bent(
        &mut self,
        s: &Settling,
        time: Seeded,
        position: &[Seeded],
        rates: Option<(&[Seeded], &[Seeded])>,
        inputs: Inputs<'_, Seeded>,
    ) -> Result<(), MechanismError> {
        let (mut velocity, mut acceleration) = (constants(&s.velocity), constants(&s.acceleration));
        if let Some((v, a)) = rates {
            velocity[..v.len()].copy_from_slice(v);
            acceleration[..a.len()].copy_from_slice(a);
        }
        let at = Prescription { time, position, velocity: &velocity, acceleration: &acceleration };
        self.carry_derivatives(&at, inputs)
    }

    /// Derivatives at a settled position: of the shapes first, from `dr = 0`.
    pub(crate) fn derivatives_bent(
        &mut self,
        at: &Prescription<'_>,
        inputs: Inputs<'_, Seeded>,
    ) -> Result<(), MechanismError> {
        let Some(s) = self.settling.take() else { return self.carry_derivatives(at, inputs) };
        let result = self.carry_through_shapes(&s, at, inputs);
        self.settling = Some(s);
        result
    }

    fn carry_through_shapes(
        &mut self,
        s: &Settling,
        at: &Prescription<'_>,
        inputs: Inputs<'_, Seeded>,
    ) -> Result<(), MechanismError> {
        let mut position = constants(&s.position);
        position[..at.position.len()].copy_from_slice(at.position);
        let rates = Some((at.velocity, at.acceleration));
        self.carry_bent(s, at.time, &position, rates, inputs)?;
        if self.stage < Stage::Forces {
            return Ok(());
        }
        let left = self.seeded_drives(s);
        let slope = self.exact_slope(s)?;
        for lane in 0..SEEDS {
            let mut change: Vec<f64> = left.iter().map(|r| -r.eps[lane]).collect();
            slope.solve(&mut change);
            position[s.users[0]..].iter_mut().zip(&change).for_each(|(d, c)| d.eps[lane] = *c);
        }
        self.carry_bent(s, at.time, &position, rates, inputs)
    }
}

fn constants(list: &[f64]) -> Vec<Seeded> {
    list.iter().map(|x| Seeded::from_re(*x)).collect()
}
