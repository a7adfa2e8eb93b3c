//! What surrounds a machine that is let go: forces with expressions, drives, conditions.

use bellcrank_multibody::{Coordinate, Reading, Readings, Seeded, Surroundings};

use super::course::{Laws, Targets};
use super::inputs::{Evaluated, Inputs};
use crate::build;
use crate::design::{Design, Quantity, ScopeId, StopWhen, Study, Values};
use crate::flex;
use crate::geometry::Geometry;
use crate::signals::{Level, Probe, Signal, View};

/// A force value this many times larger than in the rows before is suspected of growing without bound.
const OUTGROWN: f64 = 1e6;

/// What the engine asks for while it steps.
pub(super) struct Around<'d> {
    design: &'d Design,
    study: &'d Study,
    geometry: Geometry,
    inputs: Inputs,
    /// Made when derivatives are asked for.
    exact: Option<Box<Exact>>,
    laws: Laws<'d>,
    targets: Targets,
    driven: Vec<Coordinate>,
    conditions: Conditions<'d>,
    watch: Watch,
}

/// Numbers with derivatives.
struct Exact {
    values: Values<Seeded>,
    geometry: Geometry<Seeded>,
    inputs: Inputs<Seeded>,
}

/// Comparisons that end a study.
struct Conditions<'d> {
    all: &'d [StopWhen],
    probe: Probe,
}

/// Looks for force values that are not finite, or grow without bound.
#[derive(Default)]
struct Watch {
    /// Largest sizes up to the last row, and since.
    usual: Vec<f64>,
    since: Vec<f64>,
    not_finite: Option<Suspect>,
}

/// A force value that a step may have failed of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Suspect {
    /// Its place in [`Design::inputs`].
    pub(super) input: usize,
    pub(super) value: f64,
    /// s.
    pub(super) time: f64,
}

impl<'d> Around<'d> {
    /// `driven` in the order of `laws`; `conditions` with the signals they use.
    pub(super) fn new(
        design: &'d Design,
        study: &'d Study,
        geometry: Geometry,
        (laws, driven): (Laws<'d>, Vec<Coordinate>),
        (conditions, signals): (&'d [StopWhen], &[Signal]),
    ) -> Around<'d> {
        let sides = conditions.iter().flat_map(|stop| [&stop.left, &stop.right]);
        let used: Vec<usize> = sides.flat_map(|side| side.expression.signals()).collect();
        Around {
            design,
            study,
            geometry,
            inputs: Inputs::new(design),
            exact: None,
            laws,
            targets: Targets::default(),
            driven,
            conditions: Conditions { all: conditions, probe: Probe::new(signals, &used) },
            watch: Watch::default(),
        }
    }

    /// Place of row `row` on the axis.
    pub(super) fn time_of(&self, row: usize) -> f64 {
        self.laws.axis(row as f64)
    }

    /// Both sides of each condition at the present state.
    fn sides<'a>(&'a mut self, at: &dyn Readings<f64>) -> impl Iterator<Item = (&'d StopWhen, [f64; 2])> + 'a {
        let (design, geometry, efforts) = (self.design, &self.geometry, &self.driven);
        let view = View { readings: at, catalogue: &design.catalogue, geometry, efforts, level: Level::Force };
        self.conditions.probe.read(&view);
        let (values, probe) = (&self.study.values, &self.conditions.probe.values);
        let side = |side: &Quantity| side.expression.eval(values.of(side.scope), probe);
        self.conditions.all.iter().map(move |stop| (stop, [side(&stop.left), side(&stop.right)]))
    }

    /// Which conditions hold at the present state.
    pub(super) fn held(&mut self, at: &dyn Readings<f64>) -> Vec<bool> {
        self.sides(at).map(|(stop, [left, right])| stop.comparison.holds(left, right)).collect()
    }

    /// A row was reached: what was watched until here was no cause of failure.
    pub(super) fn settle(&mut self) {
        let Watch { usual, since, not_finite } = &mut self.watch;
        *not_finite = None;
        usual.resize(since.len(), 0.0);
        for (usual, since) in usual.iter_mut().zip(since) {
            *usual = usual.max(*since);
            *since = 0.0;
        }
    }

    /// The force value that a failed step may be due to; `time` is that of the failure.
    pub(super) fn suspect(&self, time: f64) -> Option<Suspect> {
        let Watch { usual, since, not_finite } = &self.watch;
        let outgrown = |(input, (usual, since)): (usize, (&f64, &f64))| {
            let value = *since;
            (*usual > 0.0 && value > OUTGROWN * usual).then_some(Suspect { input, value, time })
        };
        not_finite.or_else(|| usual.iter().zip(since).enumerate().find_map(outgrown))
    }
}

impl Watch {
    fn look(&mut self, values: &[f64], time: f64) {
        self.since.resize(values.len(), 0.0);
        for (input, (value, since)) in values.iter().zip(&mut self.since).enumerate() {
            if value.is_finite() {
                *since = since.max(value.abs());
            } else {
                // Steps that fail are tried shorter: the earliest is nearest to the cause.
                let earlier = self.not_finite.is_none_or(|known| time < known.time);
                self.not_finite = if earlier { Some(Suspect { input, value: *value, time }) } else { self.not_finite };
            }
        }
    }
}

impl Exact {
    fn new(design: &Design, study: &Study) -> Option<Exact> {
        // Those of the study, whatever they were made from.
        let fixed =
            study.values.of(ScopeId(0)).iter().enumerate().map(|(index, &value)| (index, Seeded::from_re(value)));
        let fixed: Vec<(usize, Seeded)> = fixed.collect();
        let values = Values::with(&design.scopes, &study.parameters, &fixed);
        let mut built = build::build(design, &values, &mut Vec::new())?;
        if study.flexible {
            flex::deform(design, &study.values, &values, &mut built).ok()?;
        }
        Some(Exact { geometry: built.geometry, values, inputs: Inputs::new(design) })
    }
}

impl Surroundings for Around<'_> {
    fn inputs(&mut self, at: &dyn Readings<f64>, values: &mut [f64]) {
        let of = Evaluated { design: self.design, values: &self.study.values, geometry: &self.geometry };
        self.inputs.evaluate(at, of, values);
        self.watch.look(values, at.time());
    }

    fn exact_inputs(&mut self, at: &dyn Readings<Seeded>, values: &mut [Seeded]) {
        if self.exact.is_none() {
            self.exact = Exact::new(self.design, self.study).map(Box::new);
        }
        // Numbers were checked when the model was read.
        let Some(exact) = &mut self.exact else { return };
        let of = Evaluated { design: self.design, values: &exact.values, geometry: &exact.geometry };
        exact.inputs.evaluate(at, of, values);
    }

    fn drives(&mut self, time: f64, motion: &mut [Reading]) {
        self.laws.prescribe(time, &mut self.targets);
        let Targets { position, velocity, acceleration, .. } = &self.targets;
        for (i, reading) in motion.iter_mut().enumerate() {
            let of = |list: &[f64]| list.get(i).copied().unwrap_or(0.0);
            *reading = Reading { position: of(position), velocity: of(velocity), acceleration: of(acceleration) };
        }
    }

    fn switches(&mut self, at: &dyn Readings<f64>, values: &mut [f64]) {
        for (value, (_, [left, right])) in values.iter_mut().zip(self.sides(at)) {
            *value = left - right;
        }
    }
}
