//! A study that only its own run can solve, asked for a few numbers: reductions of the rows it leaves.

use bellcrank_doc::{ParameterSet, ReductionKind};
use bellcrank_results::{Reductions, StudyResult};

use super::machine::refused;
use super::{Asked, Undefined};
use crate::design::{Design, ScopeId, Study, Values};
use crate::progress::Silent;
use crate::run::{self, Places};
use crate::signals::Signal;

/// A study of dynamics, asked for some numbers: run anew for each design. Extremes are those of the rows.
pub(crate) struct Plain<'d> {
    design: &'d Design,
    of: &'d Study,
    parameters: &'d ParameterSet,
    flexible: bool,
    signals: &'d [Signal],
    asked: Asked,
    numbers: Vec<f64>,
    /// Rows computed so far.
    pub(crate) rows: usize,
}

impl<'d> Plain<'d> {
    /// `parameters` are those of the asking study, on top of which each run fixes some.
    pub(crate) fn new(
        design: &'d Design,
        of: &'d Study,
        parameters: &'d ParameterSet,
        flexible: bool,
        signals: &'d [Signal],
        asked: Asked,
    ) -> Plain<'d> {
        Plain { design, flexible, of, parameters, signals, asked, numbers: Vec::new(), rows: 0 }
    }

    /// The responses of one design, in the order they were asked: the parameters of `fixed` have those values (SI),
    /// what depends on them follows.
    ///
    /// # Errors
    /// When the numbers make no machine, the study fails, or a response is not finite.
    pub(crate) fn run(&mut self, fixed: &[(usize, f64)]) -> Result<&[f64], Undefined> {
        let study = Study {
            name: self.of.name.clone(),
            span: self.of.span,
            kind: self.of.kind,
            task: self.of.task.clone(),
            flexible: self.flexible,
            parameters: self.parameters.clone(),
            changed: Vec::new(),
            named: Vec::new(),
            values: Values::with(&self.design.scopes, self.parameters, fixed),
        };
        if let Some(fault) = study.faults(self.design).first() {
            return Err(refused(Some(fault)));
        }
        let result = run::run(self.design, &study, &mut Silent);
        self.rows += result.table.rows();
        if let Some(failure) = result.failure {
            return Err(Undefined { message: failure.message, hints: failure.hints });
        }
        self.answer(&study.values, &result)?;
        Ok(&self.numbers)
    }

    fn answer(&mut self, values: &Values, result: &StudyResult) -> Result<(), Undefined> {
        let reduced: Vec<f64> =
            (0..self.asked.curves.len()).map(|curve| self.reduce(curve, values, result)).collect::<Result<_, _>>()?;
        self.numbers.clear();
        for index in 0..self.asked.len() {
            let value: f64 =
                self.asked.value(index).eval(values.of(ScopeId(0)), &reduced[self.asked.reductions(index)]);
            if !value.is_finite() {
                let message = format!("`{}` is not a finite number", self.asked.value(index).written());
                return Err(Undefined { message, hints: Vec::new() });
            }
            self.numbers.push(value);
        }
        Ok(())
    }

    /// The number that a curve becomes.
    fn reduce(&self, curve: usize, values: &Values, result: &StudyResult) -> Result<f64, Undefined> {
        let samples = self.samples(curve, values, result)?;
        let Some(found) = Reductions::of(&samples) else { return Err(refused(None)) };
        Ok(match self.asked.curves[curve].kind {
            ReductionKind::Min => found.min.value,
            ReductionKind::Max => found.max.value,
            ReductionKind::Mean => found.mean,
            ReductionKind::Rms => found.rms,
            ReductionKind::Range => found.range,
            ReductionKind::First => found.first,
            ReductionKind::Last => found.last,
            ReductionKind::At => {
                let place = self.asked.curves[curve].place.as_ref();
                let place = place.map_or(f64::NAN, |place| place.eval(values.of(ScopeId(0)), &[]));
                self.between(times(result), &samples, place)?
            }
        })
    }

    /// The curve, a value a row.
    fn samples(&self, curve: usize, values: &Values, result: &StudyResult) -> Result<Vec<f64>, Undefined> {
        let expression = &self.asked.curves[curve].expression;
        let column = |index: usize| {
            let name = self.design.catalogue.column(*self.signals.get(index)?)?.name;
            Some((index, &result.table.column(&name)?.values))
        };
        let columns: Vec<(usize, &Vec<f64>)> = expression.signals().into_iter().filter_map(column).collect();
        let mut row = vec![f64::NAN; self.signals.len()];
        let mut samples = Vec::with_capacity(result.table.rows());
        for i in 0..result.table.rows() {
            columns.iter().for_each(|(index, values)| row[*index] = values[i]);
            let value: f64 = expression.eval(values.of(ScopeId(0)), &row);
            if !value.is_finite() {
                let place = Places::new(self.design, self.of).at(times(result).get(i).copied().unwrap_or(f64::NAN));
                let message = format!("a response is not a finite number at {place}");
                return Err(Undefined { message, hints: Vec::new() });
            }
            samples.push(value);
        }
        Ok(samples)
    }

    /// The curve at a time, on a straight line between two rows.
    fn between(&self, times: &[f64], samples: &[f64], place: f64) -> Result<f64, Undefined> {
        let says = Places::new(self.design, self.of);
        let [from, to] = [times.first(), times.last()].map(|end| end.copied().unwrap_or(f64::NAN));
        let slack = 1e-9 * (to - from);
        if !(from - slack..=to + slack).contains(&place) {
            let (place, from, to) = (says.at(place), says.at(from), says.at(to));
            let message = format!("`at` asks for {place}, beyond the study: {from} to {to}");
            return Err(Undefined { message, hints: vec!["widen the study, or ask for a place within".to_owned()] });
        }
        let next = times.partition_point(|time| *time < place).clamp(1, times.len() - 1);
        let share = ((place - times[next - 1]) / (times[next] - times[next - 1])).clamp(0.0, 1.0);
        Ok(samples[next - 1] * (1.0 - share) + samples[next] * share)
    }
}

fn times(result: &StudyResult) -> &[f64] {
    result.table.column("time").map_or(&[], |column| &column.values)
}
