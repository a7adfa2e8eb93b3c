//! Exact derivatives of the responses of the design run last.
//!
//! The derivative of a maximum is that of the curve at the active position (the envelope theorem: inside the rows the
//! curve has no slope there). Other local maxima are pieces of their own, for who follows the highest of them.

use bellcrank_doc::ReductionKind;
use bellcrank_math::Real;
use bellcrank_multibody::{Coordinate, Engine, MechanismError, Prescription, SEEDS, Seeded};

use super::extremes::Peak;
use super::machine::{Trial, Undefined, refused};
use crate::build::{self, Built};
use crate::design::{ScopeId, Task, Values};
use crate::flex;
use crate::run::{Evaluated, Inputs, Laws, Targets};
use crate::scalar::{Exact, Scalar};
use crate::signals::{Level, Probe, Signal, Source, View, reaction_components};

/// One smooth piece of a response.
#[derive(Clone, Debug)]
pub(crate) struct Piece {
    pub(crate) value: f64,
    pub(crate) gradient: Vec<f64>,
}

/// A response with its derivatives.
#[derive(Clone, Debug)]
pub(crate) struct Derived {
    /// The active piece.
    pub(crate) active: Piece,
    /// The response with one reduction at another of its local extremes.
    pub(crate) others: Vec<Piece>,
}

/// Numbers with derivatives, kept for their memory.
pub(crate) struct Tangents<'d> {
    values: Values<Seeded>,
    built: Built<Seeded>,
    inputs: Inputs<Seeded>,
    probe: Probe<Seeded>,
    laws: Laws<'d, Seeded>,
    targets: Targets<Seeded>,
    fixed: Vec<(usize, Seeded)>,
}

/// A reduction and its candidates with derivatives.
#[derive(Clone, Debug, Default)]
struct Lanes {
    value: Seeded,
    tops: Vec<Seeded>,
    bottoms: Vec<Seeded>,
}

/// Steps of the search for the place where a curve has no slope.
const POLISHING: usize = 8;
/// The search between rows has come this near, rows.
const NEAR: f64 = 1e-3;

impl<'d> Trial<'d> {
    /// Derivatives of all responses with respect to the parameters `by`, at the design run last.
    ///
    /// # Errors
    /// Where a position is singular on the way.
    pub(crate) fn gradients(&mut self, by: &[usize]) -> Result<Vec<Derived>, Undefined> {
        self.note_ambiguous();
        self.polish()?;
        let remeshed = self.remeshed(by);
        let exact: Vec<usize> = (0..by.len()).filter(|place| !remeshed.contains(place)).collect();
        let mut groups = self.independent(by, &exact);
        if groups.is_empty() {
            // Values are asked for, whatever they are derived by.
            groups.push(Vec::new());
        }
        let mut derived: Vec<Derived> = Vec::new();
        for group in groups {
            let some: Vec<usize> = group.iter().map(|&place| by[place]).collect();
            self.seed(&some)?;
            let lanes = self.lanes()?;
            for index in 0..self.asked.len() {
                let pieces = self.pieces(index, &lanes);
                if derived.len() == index {
                    derived.push(Derived::new(&pieces, by.len()));
                }
                derived[index].take(&pieces, &group);
            }
        }
        for place in remeshed {
            let slopes = self.differences(by[place])?;
            derived.iter_mut().zip(slopes).for_each(|(of, slope)| of.slope(place, slope));
        }
        Ok(derived)
    }

    /// Some places in `by`, in groups that are seeded at once: what follows another parameter is not seeded beside it, as a
    /// seed takes the place of the definition.
    fn independent(&self, by: &[usize], places: &[usize]) -> Vec<Vec<usize>> {
        let mut groups: Vec<Vec<usize>> = Vec::new();
        for &place in places {
            let index = by[place];
            let follows = |a: usize, b: usize| a == b || self.parameters.depends_on(a, b);
            let apart = |group: &&mut Vec<usize>| {
                group.len() < SEEDS && !group.iter().any(|&p| follows(by[p], index) || follows(index, by[p]))
            };
            match groups.iter_mut().find(apart) {
                Some(group) => group.push(place),
                None => groups.push(vec![place]),
            }
        }
        groups
    }

    /// Puts derivatives by up to [`SEEDS`] parameters into every number of the machine.
    fn seed(&mut self, by: &[usize]) -> Result<(), Undefined> {
        let mut tangents = self.tangents.take().unwrap_or_else(|| Box::new(Tangents::new(self)));
        let result = self.seed_into(by, &mut tangents);
        self.tangents = Some(tangents);
        result
    }

    fn seed_into(&mut self, by: &[usize], tangents: &mut Tangents<'d>) -> Result<(), Undefined> {
        let now = self.values.of(ScopeId(0));
        tangents.fixed.clear();
        tangents.fixed.extend(self.fixed.iter().map(|&(index, value)| (index, Seeded::from_f64(value))));
        let seeded = |(lane, &index): (usize, &usize)| (index, Seeded::variable(now[index], lane));
        tangents.fixed.extend(by.iter().enumerate().map(seeded));
        tangents.values.update(&self.design.scopes, self.parameters, &tangents.fixed);
        let mut faults = Vec::new();
        if !build::rebuild(self.design, &tangents.values, &mut tangents.built, &mut faults) {
            return Err(refused(faults.first()));
        }
        if self.flexible {
            flex::deform(self.design, &self.values, &tangents.values, &mut tangents.built)?;
        }
        let (Some(course), Some(engine)) = (&self.course, self.engine.as_deref_mut()) else {
            return Err(refused(None));
        };
        engine.seed(&tangents.built.blueprint).map_err(|_| refused(None))?;
        tangents.laws = course.laws(&tangents.values, &tangents.built.blueprint);
        Ok(())
    }

    /// Solves a place and the derivatives there. A seed on `place` gives derivatives along the axis.
    fn differentiate(&mut self, place: Seeded) -> Result<(), Undefined> {
        self.need_rates(place.re)?;
        let Some(mut tangents) = self.tangents.take() else { return Err(refused(None)) };
        let result = self.differentiate_with(place, &mut tangents);
        self.tangents = Some(tangents);
        result.map_err(|error| self.failed(&error, &self.named_place(place.re)))
    }

    /// Derivatives need the rates, whatever the responses need.
    fn need_rates(&mut self, place: f64) -> Result<(), Undefined> {
        let level = self.level;
        self.level = level.max(Level::Velocity);
        let solved = self.solve_at(place);
        self.level = level;
        solved
    }

    fn differentiate_with(&mut self, place: Seeded, tangents: &mut Tangents<'d>) -> Result<(), MechanismError> {
        let Tangents { values, built, inputs, probe, laws, targets, .. } = tangents;
        let Some(engine) = self.engine.as_deref_mut() else { return Ok(()) };
        let of = Evaluated { design: self.design, values: &*values, geometry: &built.geometry };
        laws.prescribe(place, targets);
        if matches!(self.of.task, Task::Statics { .. }) {
            carry_rest(engine, &self.free, targets, inputs, of)?;
        } else {
            carry(engine, targets, inputs, of)?;
        }
        let efforts = self.course.as_ref().map_or(&[][..], |course| &course.actuation.effort);
        if let Some(readings) = engine.derivatives() {
            let catalogue = &self.design.catalogue;
            probe.read(&View { readings, catalogue, geometry: &built.geometry, efforts, level: self.level });
            for (signal, angle) in self.turned() {
                probe.values[signal] = Exact(probe.values[signal].0.with_value(angle));
            }
        }
        Ok(())
    }

    /// A curve at the position differentiated last.
    fn read_lanes(&self, curve: usize) -> Seeded {
        let Some(tangents) = &self.tangents else { return Seeded::default() };
        let (values, signals) = (tangents.values.of(ScopeId(0)), &tangents.probe.values);
        let value = Seeded::of(self.asked.curves[curve].expression.eval(values, signals));
        if self.ambiguous.get(curve) == Some(&true) { Seeded { eps: [f64::NAN; SEEDS], ..value } } else { value }
    }

    /// Curves over reactions that equilibrium does not determine: the least of many has a value, and no derivative.
    fn note_ambiguous(&mut self) {
        let reaction = |signal: &Signal| matches!(signal.source, Source::Reaction(_));
        self.ambiguous = vec![false; self.asked.curves.len()];
        let Some(engine) = self.engine.as_deref_mut().filter(|_| self.signals.iter().any(reaction)) else { return };
        if self.level < Level::Force {
            return;
        }
        let unique = engine.uniqueness();
        let components = reaction_components(self.design.planar);
        let certain = |signal: &Signal| match signal.source {
            Source::Reaction(joint) => match components.get(signal.part) {
                Some((_, place)) => unique[joint][*place],
                // Magnitudes are certain when all components are.
                None => unique[joint].iter().all(|unique| *unique),
            },
            _ => true,
        };
        for (curve, ambiguous) in self.asked.curves.iter().zip(&mut self.ambiguous) {
            *ambiguous = curve.expression.signals().iter().any(|&i| self.signals.get(i).is_some_and(|s| !certain(s)));
        }
    }

    /// Whether a response depends on reactions that equilibrium does not determine; known after
    /// [`Trial::gradients`].
    pub(crate) fn is_ambiguous(&self, index: usize) -> bool {
        self.asked.reductions(index).any(|curve| self.ambiguous.get(curve) == Some(&true))
    }

    /// Extremes between rows, to where the curve has no slope.
    fn polish(&mut self) -> Result<(), Undefined> {
        let inside = |peaks: &[Peak]| peaks.iter().any(|p| p.inside);
        if !self.reduced.iter().any(|r| inside(&r.tops) || inside(&r.bottoms)) {
            return Ok(());
        }
        self.seed(&[])?;
        for curve in 0..self.reduced.len() {
            for index in 0..self.reduced[curve].tops.len() {
                self.reduced[curve].tops[index].row = self.polished(curve, self.reduced[curve].tops[index])?;
            }
            for index in 0..self.reduced[curve].bottoms.len() {
                self.reduced[curve].bottoms[index].row = self.polished(curve, self.reduced[curve].bottoms[index])?;
            }
        }
        Ok(())
    }

    /// The row near a peak where the slope of the curve vanishes, by secants; the peak's own where it has a kink.
    fn polished(&mut self, curve: usize, peak: Peak) -> Result<f64, Undefined> {
        if !peak.inside {
            return Ok(peak.row);
        }
        let (mut a, mut b) = (peak.row, peak.row + 0.1 * NEAR);
        let (mut slope_a, mut slope_b) = (self.slope(curve, a)?, self.slope(curve, b)?);
        for _ in 0..POLISHING {
            let step = -slope_b * (b - a) / (slope_b - slope_a);
            if !step.is_finite() || (b + step - peak.row).abs() > NEAR {
                return Ok(peak.row);
            }
            (a, slope_a, b) = (b, slope_b, b + step);
            if step.abs() <= 1e-14 * peak.row.abs().max(1.0) {
                break;
            }
            slope_b = self.slope(curve, b)?;
        }
        Ok(b)
    }

    /// Slope of a curve along the rows.
    fn slope(&mut self, curve: usize, row: f64) -> Result<f64, Undefined> {
        let place = self.axis(Seeded::variable(row, 0));
        self.differentiate(place)?;
        Ok(self.read_lanes(curve).eps[0])
    }

    fn axis(&self, row: Seeded) -> Seeded {
        self.tangents.as_ref().map_or(Seeded::default(), |tangents| tangents.laws.axis(row))
    }

    /// All reductions with the derivatives by the present seeds.
    fn lanes(&mut self) -> Result<Vec<Lanes>, Undefined> {
        let mut lanes = vec![Lanes::default(); self.reduced.len()];
        self.sum_rows(&mut lanes)?;
        for (curve, lanes) in lanes.iter_mut().enumerate() {
            let rows = |peaks: &[Peak]| peaks.iter().map(|peak| peak.row).collect::<Vec<f64>>();
            let (tops, bottoms) = (rows(&self.reduced[curve].tops), rows(&self.reduced[curve].bottoms));
            let last = self.rows().saturating_sub(1) as f64;
            match self.asked.curves[curve].kind {
                ReductionKind::First => lanes.value = self.at_row(curve, 0.0)?,
                ReductionKind::Last => lanes.value = self.at_row(curve, last)?,
                ReductionKind::At => lanes.value = self.at_place(curve)?,
                ReductionKind::Mean | ReductionKind::Rms => {}
                ReductionKind::Max | ReductionKind::Min | ReductionKind::Range => {
                    lanes.tops = tops.iter().map(|&row| self.at_row(curve, row)).collect::<Result<_, _>>()?;
                    lanes.bottoms = bottoms.iter().map(|&row| self.at_row(curve, row)).collect::<Result<_, _>>()?;
                    lanes.value = match (lanes.tops.first(), lanes.bottoms.first()) {
                        (Some(&top), Some(&bottom)) => top - bottom,
                        (Some(&one), None) | (None, Some(&one)) => one,
                        (None, None) => Seeded::default(),
                    };
                }
            }
        }
        Ok(lanes)
    }

    fn at_row(&mut self, curve: usize, row: f64) -> Result<Seeded, Undefined> {
        let place = self.axis(Seeded::from_f64(row));
        self.differentiate(place)?;
        Ok(self.read_lanes(curve))
    }

    fn at_place(&mut self, curve: usize) -> Result<Seeded, Undefined> {
        let Some(tangents) = &self.tangents else { return Ok(Seeded::default()) };
        let place = self.asked.curves[curve].place.as_ref();
        let place = place.map(|place| Seeded::of(place.eval(tangents.values.of(ScopeId(0)), &[])));
        self.differentiate(place.unwrap_or_default())?;
        Ok(self.read_lanes(curve))
    }

    /// Means and root mean squares need every row.
    fn sum_rows(&mut self, lanes: &mut [Lanes]) -> Result<(), Undefined> {
        let summed = |kind| matches!(kind, ReductionKind::Mean | ReductionKind::Rms);
        let curves: Vec<usize> = (0..lanes.len()).filter(|&c| summed(self.asked.curves[c].kind)).collect();
        if curves.is_empty() {
            return Ok(());
        }
        let rows = self.rows();
        for row in 0..rows {
            let place = self.axis(Seeded::from_f64(row as f64));
            self.differentiate(place)?;
            for &curve in &curves {
                let x = self.read_lanes(curve);
                let square = self.asked.curves[curve].kind == ReductionKind::Rms;
                lanes[curve].value += if square { x * x } else { x };
            }
        }
        for &curve in &curves {
            let mean = lanes[curve].value / Seeded::from_f64(rows as f64);
            let square = self.asked.curves[curve].kind == ReductionKind::Rms;
            let value = if square && mean.re > 0.0 { mean.sqrt() } else { mean };
            lanes[curve].value = value.with_value(self.reduced[curve].value);
        }
        Ok(())
    }

    /// A response's active piece first, then those with one reduction at another extreme.
    fn pieces(&self, index: usize, lanes: &[Lanes]) -> Vec<Seeded> {
        let range = self.asked.reductions(index);
        let mut numbers: Vec<Exact<SEEDS>> = lanes[range.clone()].iter().map(|lanes| lanes.value.number()).collect();
        let mut pieces = vec![self.outer(index, &numbers)];
        for (place, lanes) in lanes[range].iter().enumerate() {
            let kept = numbers[place];
            for other in lanes.others() {
                numbers[place] = other.number();
                pieces.push(self.outer(index, &numbers));
            }
            numbers[place] = kept;
        }
        pieces
    }

    fn outer(&self, index: usize, reductions: &[Exact<SEEDS>]) -> Seeded {
        let Some(tangents) = &self.tangents else { return Seeded::default() };
        Seeded::of(self.asked.value(index).eval(tangents.values.of(ScopeId(0)), reductions))
    }
}

impl Lanes {
    /// The reduction at its other local extremes.
    fn others(&self) -> Vec<Seeded> {
        let rest = |of: &[Seeded]| of.iter().skip(1).copied().collect::<Vec<_>>();
        match (self.tops.first(), self.bottoms.first()) {
            (Some(&top), Some(&bottom)) => {
                let lower = rest(&self.tops).into_iter().map(|other| other - bottom);
                lower.chain(rest(&self.bottoms).into_iter().map(|other| top - other)).collect()
            }
            _ => rest(if self.tops.is_empty() { &self.bottoms } else { &self.tops }),
        }
    }
}

impl Derived {
    fn new(pieces: &[Seeded], count: usize) -> Derived {
        let piece = |x: &Seeded| Piece { value: x.re, gradient: vec![0.0; count] };
        Derived { active: piece(&pieces[0]), others: pieces[1..].iter().map(piece).collect() }
    }

    /// The slope by one parameter that is known of the response alone: its other extremes are taken to go along.
    fn slope(&mut self, place: usize, slope: f64) {
        std::iter::once(&mut self.active).chain(&mut self.others).for_each(|piece| piece.gradient[place] = slope);
    }

    /// Derivatives of a group of parameters, lane by lane to their places.
    fn take(&mut self, pieces: &[Seeded], group: &[usize]) {
        let all = std::iter::once(&mut self.active).chain(&mut self.others);
        for (piece, x) in all.zip(pieces) {
            group.iter().zip(x.eps).for_each(|(&place, eps)| piece.gradient[place] = eps);
        }
    }
}

impl<'d> Tangents<'d> {
    fn new(trial: &Trial<'d>) -> Tangents<'d> {
        let values = Values::new(&trial.design.scopes, trial.parameters);
        let rests = Vec::new();
        let zero = Seeded::default();
        Tangents {
            values,
            built: Built::empty(),
            inputs: Inputs::new(trial.design),
            probe: Probe::new(trial.signals, &trial.asked.signals()),
            laws: Laws::Positions { swept: None, velocity: zero, acceleration: zero, last: 0, rests },
            targets: Targets::default(),
            fixed: Vec::new(),
        }
    }
}

fn carry(
    engine: &mut dyn Engine,
    targets: &Targets<Seeded>,
    inputs: &mut Inputs<Seeded>,
    of: Evaluated<'_, Seeded>,
) -> Result<(), MechanismError> {
    let at = Prescription {
        time: targets.time,
        position: &targets.position,
        velocity: &targets.velocity,
        acceleration: &targets.acceleration,
    };
    engine.differentiate(&at, &mut |readings, values| inputs.evaluate(readings, of, values))
}

/// At rest the free coordinates follow so that their efforts stay zero: with u(s, p) = 0,
/// `ds/dp = −(∂u/∂s)⁻¹ ∂u/∂p`.
fn carry_rest(
    engine: &mut dyn Engine,
    free: &[Coordinate],
    targets: &mut Targets<Seeded>,
    inputs: &mut Inputs<Seeded>,
    of: Evaluated<'_, Seeded>,
) -> Result<(), MechanismError> {
    let held = targets.position.len();
    targets.position.extend(free.iter().map(|&c| Seeded::from_f64(engine.coordinate(c).position)));
    targets.velocity.resize(targets.position.len(), Seeded::default());
    targets.acceleration.resize(targets.position.len(), Seeded::default());
    carry(engine, targets, inputs, of)?;
    if free.is_empty() {
        return Ok(());
    }
    let by_parameters = efforts_of(engine, held, free.len());
    let mut stiffness = vec![vec![0.0; free.len()]; free.len()];
    for first in (0..free.len()).step_by(SEEDS) {
        let lanes = first..(first + SEEDS).min(free.len());
        lanes.clone().for_each(|k| targets.position[held + k].eps[k - first] = 1.0);
        carry(engine, targets, inputs, of)?;
        let moved = efforts_of(engine, held, free.len());
        for k in lanes {
            targets.position[held + k].eps = [0.0; SEEDS];
            (0..free.len()).for_each(|i| stiffness[i][k] = moved[i].eps[k - first] - by_parameters[i].eps[k - first]);
        }
    }
    for lane in 0..SEEDS {
        let right: Vec<f64> = by_parameters.iter().map(|u| -u.eps[lane]).collect();
        let step = bellcrank_math::linalg::dense::solve(&stiffness, &right);
        let step = step.unwrap_or_else(|| vec![f64::NAN; free.len()]);
        step.iter().enumerate().for_each(|(k, s)| targets.position[held + k].eps[lane] = *s);
    }
    carry(engine, targets, inputs, of)
}

fn efforts_of(engine: &dyn Engine, held: usize, free: usize) -> Vec<Seeded> {
    let readings = engine.derivatives();
    (held..held + free).map(|i| readings.map_or(Seeded::default(), |readings| readings.drive(i))).collect()
}
