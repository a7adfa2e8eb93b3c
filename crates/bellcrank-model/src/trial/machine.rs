//! A machine that is tried with one design after another.

use bellcrank_doc::{ParameterSet, ReductionKind};
use bellcrank_multibody::{Coordinate, Engine, MechanismError};

use super::asked::Asked;
use super::extremes::{Peak, climb, peaks};
use super::turning::{Turning, turnings};
use crate::build::{self, Built};
use crate::design::{Design, Hold, Over, ScopeId, Study, Task, Values};
use crate::flex;
use crate::run::{Assembly, Course, Evaluated, Inputs, Laws, Namer, Path, Places, Targets, failure};
use crate::signals::{Level, Probe, Signal, Source, View};

/// Why a design has no responses.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Undefined {
    pub(crate) message: String,
    pub(crate) hints: Vec<String>,
}

/// Local maxima that are followed as candidates.
pub(super) const CANDIDATES: usize = 8;

impl From<crate::elastic::End> for Undefined {
    fn from(end: crate::elastic::End) -> Undefined {
        Undefined { message: end.message, hints: end.hints }
    }
}

/// Where a reduction takes its value.
#[derive(Clone, Debug, Default)]
pub(crate) struct Reduced {
    pub(crate) value: f64,
    /// Candidates for the maximum, and for the minimum, the active ones first.
    pub(super) tops: Vec<Peak>,
    pub(super) bottoms: Vec<Peak>,
}

/// A study, asked for some numbers.
pub(crate) struct Trial<'d> {
    pub(super) design: &'d Design,
    pub(super) of: &'d Study,
    pub(super) parameters: &'d ParameterSet,
    /// Bodies deform in it that are flexible.
    pub(super) flexible: bool,
    pub(super) asked: Asked,
    pub(super) signals: &'d [Signal],
    pub(super) level: Level,
    pub(super) values: Values,
    pub(super) built: Built,
    pub(super) engine: Option<Box<dyn Engine>>,
    pub(super) inputs: Inputs,
    pub(super) probe: Probe,
    pub(super) course: Option<Course<'d>>,
    pub(super) laws: Option<Laws<'d>>,
    pub(super) targets: Targets,
    /// Values of each curve, row by row.
    pub(super) samples: Vec<Vec<f64>>,
    pub(super) reduced: Vec<Reduced>,
    numbers: Vec<f64>,
    /// Coordinates that nothing holds at rest.
    pub(super) free: Vec<Coordinate>,
    /// Curves without derivatives.
    pub(super) ambiguous: Vec<bool>,
    pub(super) tangents: Option<Box<super::gradient::Tangents<'d>>>,
    /// What the parameters were fixed to at the last run.
    pub(super) fixed: Vec<(usize, f64)>,
    /// Reactions of joints are asked for.
    reactions: bool,
    /// The numbers are those of `fixed`.
    known: bool,
    turnings: Vec<Turning>,
    /// Positions solved so far.
    pub(crate) positions: usize,
}

impl<'d> Trial<'d> {
    /// `parameters` are those of the asking study, on top of which each run fixes some.
    pub(crate) fn new(
        design: &'d Design,
        of: &'d Study,
        parameters: &'d ParameterSet,
        signals: &'d [Signal],
        asked: Asked,
    ) -> Trial<'d> {
        let level = |signal| design.catalogue.column(signal).map_or(Level::Position, |column| column.level);
        // Statics solves forces in any case.
        let least = if matches!(of.task, Task::Statics { .. }) { Level::Force } else { Level::Position };
        let level = asked.level(signals, level).max(least);
        let values = Values::new(&design.scopes, parameters);
        let used = asked.signals();
        let probe = Probe::new(signals, &used);
        let curves = asked.curves.len();
        Trial {
            design,
            of,
            parameters,
            flexible: of.flexible,
            asked,
            signals,
            level,
            values,
            built: Built::empty(),
            engine: None,
            inputs: Inputs::new(design),
            probe,
            course: None,
            laws: None,
            targets: Targets::default(),
            samples: vec![Vec::new(); curves],
            reduced: vec![Reduced::default(); curves],
            numbers: Vec::new(),
            free: Vec::new(),
            ambiguous: Vec::new(),
            tangents: None,
            fixed: Vec::new(),
            reactions: used.iter().any(|&i| matches!(signals.get(i).map(|s| s.source), Some(Source::Reaction(_)))),
            known: false,
            turnings: turnings(design, signals, &used),
            positions: 0,
        }
    }

    /// With all bodies rigid, whatever the study says, or not.
    pub(crate) fn deforming(self, flexible: bool) -> Trial<'d> {
        Trial { flexible, ..self }
    }

    /// The responses of one design, in the order they were asked: the parameters of `fixed` have those values (SI),
    /// what depends on them follows.
    ///
    /// # Errors
    /// When the numbers make no machine, it cannot be assembled or moved, or a curve is not finite somewhere.
    pub(crate) fn run(&mut self, fixed: &[(usize, f64)]) -> Result<&[f64], Undefined> {
        if self.known && self.fixed == fixed {
            return Ok(&self.numbers);
        }
        self.known = false;
        self.fixed.clear();
        self.fixed.extend_from_slice(fixed);
        self.begin()?;
        self.sample()?;
        for curve in 0..self.asked.curves.len() {
            self.reduced[curve] = self.reduce(curve)?;
        }
        self.answer()?;
        self.known = true;
        Ok(&self.numbers)
    }

    /// The next design is built from nothing: what was chosen at designs before it has no part in it.
    pub(crate) fn forget(&mut self) {
        self.engine = None;
        self.known = false;
    }

    /// Numbers, machine, assembly.
    fn begin(&mut self) -> Result<(), Undefined> {
        self.values.update(&self.design.scopes, self.parameters, &self.fixed);
        let mut faults = Vec::new();
        if !build::rebuild(self.design, &self.values, &mut self.built, &mut faults) {
            return Err(refused(faults.first()));
        }
        if self.flexible {
            flex::deform(self.design, &self.values, &self.values, &mut self.built)?;
        }
        self.renew()?;
        self.begin_course()
    }

    fn renew(&mut self) -> Result<(), Undefined> {
        if let Some(engine) = &mut self.engine
            && engine.renew(&self.built.blueprint).is_ok()
        {
            return Ok(());
        }
        self.engine = Some(build::engine(self.design, &self.built).map_err(|fault| refused(Some(&fault)))?);
        Ok(())
    }

    fn begin_course(&mut self) -> Result<(), Undefined> {
        let (path, holds, motions) = path_of(&self.of.task);
        if let Some(fault) = build::programme_faults(self.design, &self.values, motions).first() {
            return Err(refused(Some(fault)));
        }
        let (design, values, built) = (self.design, &self.values, &self.built);
        let Some(engine) = self.engine.as_deref_mut() else { return Err(refused(None)) };
        let begun = Course::begin(&mut Assembly { design, values, built, engine }, path, holds, motions);
        let course = begun.map_err(|error| self.failed(&error, "before the first position"))?;
        if let (Path::Motion(_), Some(engine)) = (path, self.engine.as_deref_mut()) {
            engine.only_drives(!self.reactions);
            let prepared = engine.prepare(&course.actuation);
            prepared.map_err(|error| self.failed(&error, ""))?;
        }
        self.laws = Some(course.laws(&self.values, &self.built.blueprint));
        self.course = Some(course);
        Ok(())
    }

    /// All curves at all rows.
    fn sample(&mut self) -> Result<(), Undefined> {
        self.samples.iter_mut().for_each(Vec::clear);
        self.turnings.iter_mut().for_each(|turning| turning.rows.clear());
        if self.asked.curves.is_empty() {
            return Ok(());
        }
        for row in 0..self.rows() {
            self.solve(row as f64)?;
            self.turnings.iter_mut().for_each(|turning| turning.rows.push(self.probe.values[turning.signal]));
            for curve in 0..self.asked.curves.len() {
                let value = self.read(curve, row as f64)?;
                self.samples[curve].push(value);
            }
        }
        Ok(())
    }

    pub(super) fn rows(&self) -> usize {
        self.course.as_ref().map_or(0, |course| course.rows)
    }

    /// Place on the axis of a row, SI.
    pub(crate) fn place(&self, row: f64) -> f64 {
        self.laws.as_ref().map_or(f64::NAN, |laws| laws.axis(row))
    }

    /// Solves the position of a row, which need not be whole, as far as the curves need it.
    pub(super) fn solve(&mut self, row: f64) -> Result<(), Undefined> {
        let place = self.place(row);
        self.solve_at(place)
    }

    pub(super) fn solve_at(&mut self, place: f64) -> Result<(), Undefined> {
        self.positions += 1;
        if let (Some(laws), Some(engine)) = (&self.laws, self.engine.as_deref_mut()) {
            laws.prescribe(place, &mut self.targets);
            let of = Evaluated { design: self.design, values: &self.values, geometry: &self.built.geometry };
            let solved = match &self.of.task {
                Task::Statics { .. } => {
                    let list = self.course.as_ref().map_or(&[][..], |course| &course.actuation.position);
                    settle(engine, list, &self.targets, &mut self.inputs, of).map(|free| self.free = free)
                }
                _ => solve_motion(engine, &self.targets, self.level, &mut self.inputs, of),
            };
            solved.map_err(|error| self.failed(&error, &self.named_place(place)))?;
        }
        self.read_signals(place);
        Ok(())
    }

    fn read_signals(&mut self, place: f64) {
        let Some(engine) = self.engine.as_deref() else { return };
        let efforts = self.course.as_ref().map_or(&[][..], |course| &course.actuation.effort);
        let view = View {
            readings: engine,
            catalogue: &self.design.catalogue,
            geometry: &self.built.geometry,
            efforts,
            level: self.level,
        };
        self.probe.read(&view);
        if !self.turnings.is_empty() {
            let row = self.laws.as_ref().map_or(0.0, |laws| laws.row_of(place));
            for turning in &self.turnings {
                let angle = &mut self.probe.values[turning.signal];
                *angle = turning.near(row, *angle);
            }
        }
    }

    /// Signals that differ from what a position alone says, and their values at the position solved last.
    pub(super) fn turned(&self) -> impl Iterator<Item = (usize, f64)> + '_ {
        self.turnings.iter().map(|turning| (turning.signal, self.probe.values[turning.signal]))
    }

    /// The value of a curve at the position solved last.
    pub(super) fn read(&self, curve: usize, row: f64) -> Result<f64, Undefined> {
        let value: f64 = self.asked.curves[curve].expression.eval(self.values.of(ScopeId(0)), &self.probe.values);
        if value.is_finite() {
            return Ok(value);
        }
        let message = format!("a response is not a finite number at {}", self.named_place(self.place(row)));
        Err(Undefined { message, hints: Vec::new() })
    }

    fn reduce(&mut self, curve: usize) -> Result<Reduced, Undefined> {
        let samples = &self.samples[curve];
        let single = |value: f64| Ok(Reduced { value, ..Reduced::default() });
        let first = samples.first().copied().unwrap_or(f64::NAN);
        match self.asked.curves[curve].kind {
            ReductionKind::First => single(first),
            ReductionKind::Last => single(samples.last().copied().unwrap_or(f64::NAN)),
            // Differences to the first keep the digits of large, nearly equal numbers.
            ReductionKind::Mean => {
                single(first + samples.iter().map(|x| x - first).sum::<f64>() / samples.len() as f64)
            }
            ReductionKind::Rms => {
                single(bellcrank_results::Reductions::of(samples).map_or(f64::NAN, |found| found.rms))
            }
            ReductionKind::At => self.value_at(curve).and_then(single),
            ReductionKind::Max => {
                let tops = self.climb(curve, 1.0)?;
                Ok(Reduced { value: tops[0].value, tops, bottoms: Vec::new() })
            }
            ReductionKind::Min => {
                let bottoms = self.climb(curve, -1.0)?;
                Ok(Reduced { value: bottoms[0].value, tops: Vec::new(), bottoms })
            }
            ReductionKind::Range => {
                let (tops, bottoms) = (self.climb(curve, 1.0)?, self.climb(curve, -1.0)?);
                Ok(Reduced { value: tops[0].value - bottoms[0].value, tops, bottoms })
            }
        }
    }

    /// Candidates for the extreme, the active one first and found between the rows; others, too, where they might
    /// be higher between theirs.
    fn climb(&mut self, curve: usize, sign: f64) -> Result<Vec<Peak>, Undefined> {
        let mut found = peaks(&self.samples[curve], sign, CANDIDATES);
        let highest = found.first().map_or(0.0, |p| sign * p.value);
        for peak in &mut found {
            let (row, samples) = (peak.row as usize, &self.samples[curve]);
            // A parabola through its neighbours rises this much above the sample at most.
            let rise = |i: usize| (sign * (peak.value - samples[i])).max(0.0);
            let possible = peak.inside && sign * peak.value + rise(row - 1).max(rise(row + 1)) >= highest;
            if possible {
                let evaluate = |row: f64| self.solve(row).and_then(|()| self.read(curve, row)).ok();
                if let Some((row, value)) = climb(peak.row, peak.value, sign, evaluate) {
                    (peak.row, peak.value) = (row, value);
                }
            }
        }
        found.sort_by(|a, b| (sign * b.value).total_cmp(&(sign * a.value)));
        Ok(found)
    }

    /// Where `at` is asked, SI.
    pub(super) fn asked_place(&self, curve: usize) -> f64 {
        let place = self.asked.curves[curve].place.as_ref();
        place.map_or(f64::NAN, |place| place.eval(self.values.of(ScopeId(0)), &[]))
    }

    fn value_at(&mut self, curve: usize) -> Result<f64, Undefined> {
        let place = self.asked_place(curve);
        let row = self.laws.as_ref().map_or(f64::NAN, |laws| laws.row_of(place));
        let last = self.rows().saturating_sub(1) as f64;
        if !(-1e-9..=last + 1e-9).contains(&row) {
            let (from, to) = (self.named_place(self.place(0.0)), self.named_place(self.place(last)));
            let message = format!("`at` asks for {}, beyond the study: {from} to {to}", self.named_place(place));
            return Err(Undefined { message, hints: vec!["widen the study, or ask for a place within".to_owned()] });
        }
        self.solve_at(place)?;
        self.read(curve, row)
    }

    fn answer(&mut self) -> Result<(), Undefined> {
        self.numbers.clear();
        for index in 0..self.asked.len() {
            let reductions: Vec<f64> = self.asked.reductions(index).map(|c| self.reduced[c].value).collect();
            let value: f64 = self.asked.value(index).eval(self.values.of(ScopeId(0)), &reductions);
            if !value.is_finite() {
                let message = format!("`{}` is not a finite number", self.asked.value(index).written());
                return Err(Undefined { message, hints: Vec::new() });
            }
            self.numbers.push(value);
        }
        Ok(())
    }

    /// The reductions of a response that are extremes, as written, with the rows (not whole between rows) where they lie.
    pub(crate) fn active_rows(&self, index: usize) -> Vec<(String, f64)> {
        let mut rows = Vec::new();
        for curve in self.asked.reductions(index) {
            let (text, reduced) = (&self.asked.curves[curve].text, &self.reduced[curve]);
            let firsts = [reduced.tops.first(), reduced.bottoms.first()];
            rows.extend(firsts.into_iter().flatten().map(|peak| (text.clone(), peak.row)));
        }
        rows
    }

    /// `joint.B.position = 12 deg`.
    pub(crate) fn named_place(&self, place: f64) -> String {
        Places::new(self.design, self.of).at(place)
    }

    pub(super) fn failed(&self, error: &MechanismError, place: &str) -> Undefined {
        let namer = Namer::new(self.design);
        let failure = failure(&namer, error, &format!("study `{}`", self.of.name), place);
        Undefined { message: failure.message, hints: failure.hints }
    }
}

/// Moves a machine to what is prescribed, and solves as far as is asked.
fn solve_motion(
    engine: &mut dyn Engine,
    targets: &Targets,
    level: Level,
    inputs: &mut Inputs,
    of: Evaluated<'_>,
) -> Result<(), MechanismError> {
    engine.move_to(targets.time, &targets.position)?;
    if level > Level::Position {
        engine.set_rates(&targets.velocity, &targets.acceleration)?;
    }
    if level >= Level::Force {
        engine.solve_forces(&mut |readings, values| inputs.evaluate(readings, of, values))?;
    }
    Ok(())
}

/// Finds equilibrium with what is prescribed held; answers the coordinates that were free.
fn settle(
    engine: &mut dyn Engine,
    list: &[Coordinate],
    targets: &Targets,
    inputs: &mut Inputs,
    of: Evaluated<'_>,
) -> Result<Vec<Coordinate>, MechanismError> {
    let hold: Vec<(Coordinate, f64)> = list.iter().copied().zip(targets.position.iter().copied()).collect();
    let found = engine.equilibrium(&hold, &mut |readings, values| inputs.evaluate(readings, of, values))?;
    Ok(found.free)
}

/// What a study's rows run over, what it holds, and the motions that act.
fn path_of(task: &Task) -> (Path<'_>, &[Hold], &[usize]) {
    match task {
        Task::Motion { over: over @ Over::Positions { .. }, holds, .. } => (Path::Motion(over), holds, &[]),
        Task::Motion { over: over @ Over::Time { motions, .. }, holds, .. } => (Path::Motion(over), holds, motions),
        Task::Statics { sweep, holds, motions } => (Path::Rest(sweep.as_ref()), holds, motions),
        _ => (Path::Rest(None), &[], &[]),
    }
}

pub(super) fn refused(fault: Option<&bellcrank_doc::Diagnostic>) -> Undefined {
    let message = fault.map_or_else(|| "the numbers make no machine".to_owned(), |fault| fault.message.clone());
    Undefined { message, hints: fault.map_or_else(Vec::new, |fault| fault.hints.clone()) }
}
