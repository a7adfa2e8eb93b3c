//! Derivatives of solved positions: parameters through the blueprint, the targets and the inputs into every signal.

use bellcrank_multibody::{Actuation, Coordinate, Engine, Prescription, Readings, Seeded};

use crate::build::{self, Built};
use crate::design::{Design, Over, Quantity, Study, Task, Values, moved};
use crate::motion::{Jet, Programme, Schedule};
use crate::run::inputs::{Evaluated, Inputs};
use crate::scalar::Scalar;
use crate::signals::{Level, MOST, Source, View};

/// How far through the study.
const ROW: usize = 37;
const LAST: usize = 100;

/// A study over positions or time, nothing held.
struct Asked<'a> {
    design: &'a Design,
    study: &'a Study,
    over: &'a Over,
}

/// The numbers of a model over any scalar, and what is prescribed.
struct Numbers<T: Scalar> {
    values: Values<T>,
    built: Built<T>,
    time: T,
    position: Vec<T>,
    velocity: Vec<T>,
    acceleration: Vec<T>,
}

impl Asked<'_> {
    fn actuation(&self) -> Actuation {
        match self.over {
            Over::Positions { sweep, drive, .. } => {
                Actuation { position: vec![sweep.coordinate], rate: vec![*drive], effort: vec![*drive] }
            }
            Over::Time { motions, drives, .. } => {
                let moved = moved(motions.iter().filter_map(|&i| self.design.motions.get(i)));
                let effort = drives.clone().unwrap_or_else(|| moved.clone());
                Actuation { position: moved.clone(), rate: moved, effort }
            }
        }
    }

    fn numbers<T: Scalar>(&self, fixed: &[(usize, T)]) -> Numbers<T> {
        let values = Values::with(&self.design.scopes, &self.study.parameters, fixed);
        let built = build::build(self.design, &values, &mut Vec::new()).expect("a model");
        let mut numbers = Numbers {
            values,
            built,
            time: T::zero(),
            position: Vec::new(),
            velocity: Vec::new(),
            acceleration: Vec::new(),
        };
        match self.over {
            Over::Positions { sweep, velocity, acceleration, .. } => {
                let rate = |rate: &Option<Quantity>| rate.as_ref().map_or(T::zero(), |rate| rate.eval(&numbers.values));
                let [from, to]: [T; 2] = [&sweep.from, &sweep.to].map(|end| end.eval(&numbers.values));
                let (velocity, acceleration) = (rate(velocity), rate(acceleration));
                numbers.push(position(from, to, ROW, LAST), velocity, acceleration);
            }
            Over::Time { duration, motions, .. } => {
                numbers.time = position(T::zero(), duration.eval(&numbers.values), ROW, LAST);
                let schedule = Schedule::new(self.design, &numbers.values);
                let start = |c: Coordinate| numbers.built.blueprint.joints[c.joint.0].start.get(c.index).copied();
                let from = |c| start(c).flatten().unwrap_or(T::zero());
                let programme = Programme::new(self.design, motions, &schedule, &numbers.values, &from);
                let jets: Vec<Jet<T>> = programme.tracks.iter().map(|track| track.at(numbers.time)).collect();
                jets.into_iter().for_each(|jet| numbers.push(jet.value, jet.first, jet.second));
            }
        }
        numbers
    }

    fn solved(&self, numbers: &Numbers<f64>) -> Box<dyn Engine> {
        let mut engine = build::engine(self.design, &numbers.built).expect("a mechanism");
        let actuation = self.actuation();
        let starts = actuation.position.iter().filter_map(|&c| {
            let start = &numbers.built.blueprint.joints[c.joint.0].start;
            start.get(c.index).copied().flatten().map(|start| (c, start))
        });
        let hold: Vec<(Coordinate, f64)> = starts.collect();
        engine.assemble(&hold).expect("assembled");
        engine.prepare(&actuation).expect("prepared");
        engine.move_to(numbers.time, &numbers.position).expect("moved");
        engine.set_rates(&numbers.velocity, &numbers.acceleration).expect("rates");
        let mut inputs = Inputs::new(self.design);
        engine.solve_forces(&mut |at, given| inputs.evaluate(at, numbers.of(self.design), given)).expect("forces");
        engine
    }

    /// The name of a signal by its place.
    fn signal(&self, k: usize) -> String {
        let sources = self.design.catalogue.sources().iter().filter(|source| **source != Source::Check);
        let mut columns = sources.flat_map(|&source| self.design.catalogue.columns(source));
        columns.nth(k).map_or(String::new(), |column| column.name)
    }

    /// Every signal but the checks.
    fn signals<T: Scalar>(&self, numbers: &Numbers<T>, readings: &dyn Readings<T>) -> Vec<T> {
        let (catalogue, efforts) = (&self.design.catalogue, self.actuation().effort);
        let geometry = &numbers.built.geometry;
        let view = View { readings, catalogue, geometry, efforts: &efforts, level: Level::Force };
        let mut answers = [T::zero(); MOST];
        let mut all = Vec::new();
        for &source in catalogue.sources().iter().filter(|source| **source != Source::Check) {
            view.read(source, &mut answers);
            all.extend(&answers[..catalogue.columns(source).len()]);
        }
        all
    }

    fn plain(&self, fixed: &[(usize, f64)]) -> Vec<f64> {
        let numbers = self.numbers(fixed);
        self.signals(&numbers, &*self.solved(&numbers))
    }

    fn exact(&self, i: usize, value: f64) -> Vec<f64> {
        let mut engine = self.solved(&self.numbers(&[]));
        let numbers = self.numbers(&[(i, Seeded::variable(value, 2))]);
        engine.seed(&numbers.built.blueprint).expect("the same machine");
        let Numbers { time, position, velocity, acceleration, .. } = &numbers;
        let mut inputs = Inputs::new(self.design);
        let at = Prescription { time: *time, position, velocity, acceleration };
        engine
            .differentiate(&at, &mut |at, given| inputs.evaluate(at, numbers.of(self.design), given))
            .expect("solved");
        let signals = self.signals(&numbers, engine.derivatives().expect("derivatives"));
        signals.into_iter().map(|signal| signal.eps[2]).collect()
    }
}

impl<T: Scalar> Numbers<T> {
    fn push(&mut self, position: T, velocity: T, acceleration: T) {
        self.position.push(position);
        self.velocity.push(velocity);
        self.acceleration.push(acceleration);
    }

    fn of<'a>(&'a self, design: &'a Design) -> Evaluated<'a, T> {
        Evaluated { design, values: &self.values, geometry: &self.built.geometry }
    }
}

/// Asserts for every parameter, and counts the derivatives that are not zero. A mass of 0 can only grow: it is left out.
fn check(name: &str, asked: &Asked<'_>) -> usize {
    let plain = asked.plain(&[]);
    let parameters = &asked.study.parameters;
    let mut found = 0;
    for (i, &value) in parameters.values().iter().enumerate().filter(|(_, value)| **value != 0.0) {
        let of = &parameters.all()[i].name;
        let h = 1e-3 * value.abs();
        let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| asked.plain(&[(i, value + k * h)]));
        for (k, exact) in asked.exact(i, value).into_iter().enumerate().filter(|(k, _)| told(plain[*k])) {
            let difference = (8.0 * (c[k] - b[k]) - (d[k] - a[k])) / (12.0 * h);
            // Loops close to a tolerance, which the step divides.
            let slack = 1e-7 * exact.abs() + 1e-12 * (1.0 + plain[k].abs()) / h;
            let name = || format!("{name}, {of}, {}", asked.signal(k));
            assert!((exact - difference).abs() <= slack, "{}: {exact} against {difference}", name());
            found += usize::from(exact != 0.0);
        }
    }
    found
}

/// A signal that is known; and the magnitude of a force that is not there has no slope.
fn told(value: f64) -> bool {
    value.is_finite() && value != 0.0
}

/// Loops that close for related lengths only, or that share a load as they like: what one parameter does to them
/// is not determined.
const REDUNDANT: [&str; 3] = ["models/bennett/", "cases/bennett-k6/", "cases/screw-jack/"];

#[test]
fn every_signal_of_a_solved_position_has_the_derivatives_of_its_differences() {
    let mut found = 0;
    for path in ["models", "verify/cases"].into_iter().flat_map(super::models) {
        let (name, model) = (path.display().to_string(), super::loaded(&path));
        if REDUNDANT.iter().any(|redundant| name.contains(redundant)) {
            continue;
        }
        let design = model.design();
        for study in model.study_list() {
            if let Task::Motion { over, holds, .. } = &study.task
                && holds.is_empty()
            {
                found += check(&format!("{name}: {}", study.name), &Asked { design, study, over });
            }
        }
    }
    assert!(found > 10_000, "{found} derivatives");
}

/// A place among equal steps.
fn position<T: Scalar>(from: T, to: T, row: usize, last: usize) -> T {
    let share = row as f64 / last as f64;
    from * T::from_f64(1.0 - share) + to * T::from_f64(share)
}
