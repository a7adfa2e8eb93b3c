//! The drive to take: the rows of another study against everything in the catalogue.

mod electric;
mod pneumatic;
mod told;

use bellcrank_results::{Column, Findings, StudyResult, Table};
use bellcrank_sizing::{Duty, Requirement, Row, SizingError};

use super::Asking;
use crate::design::{Actuator, Sizing, Study, Values};
use crate::progress::Progress;
use crate::run;
use crate::signals::Source;
use crate::trial::Undefined;

pub(super) fn run(
    asking: &Asking<'_>,
    question: &Sizing,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), Undefined> {
    let loads = run::run(asking.design, &with_own_parameters(asking), progress);
    result.effort.clone_from(&loads.effort);
    if let Some(failure) = loads.failure {
        return Err(Undefined { message: failure.message, hints: failure.hints });
    }
    let rows = Loads::of(asking, question, &loads)?;
    result.warnings.extend(rows.warnings(asking, &loads));
    let found = match &question.actuator {
        Actuator::Pneumatic(of) => pneumatic::run(asking, question, of, &rows),
        Actuator::Electric(of) => electric::run(asking, question, of, &rows),
    };
    let Found { sizing, warnings, columns } = found.map_err(undefined)?;
    result.axis = rows.table.columns.iter().take(1).map(|column| column.name.clone()).collect();
    result.table = rows.table;
    // After the force: the report draws one chart a unit, in this order.
    result.table.columns.splice(2..2, columns);
    result.warnings.extend(warnings);
    result.findings = Some(Findings::Sizing(sizing));
    Ok(())
}

/// What an actuator's own file makes of the rows.
struct Found {
    sizing: bellcrank_results::Sizing,
    warnings: Vec<String>,
    /// For the table, behind the force.
    columns: Vec<Column>,
}

/// The study that is asked, with the parameters of this one.
fn with_own_parameters(asking: &Asking<'_>) -> Study {
    let (of, own) = (asking.of, asking.study);
    Study {
        name: of.name.clone(),
        span: of.span,
        kind: of.kind,
        task: of.task.clone(),
        flexible: own.flexible,
        parameters: own.parameters.clone(),
        changed: own.changed.clone(),
        named: Vec::new(),
        values: Values::new(&asking.design.scopes, &own.parameters),
    }
}

/// Numbers were checked when the model was read: what is left are faults of the rows.
fn undefined(error: SizingError) -> Undefined {
    Undefined { message: error.to_string(), hints: Vec::new() }
}

/// The rows of the drive.
struct Loads {
    /// Axis, force, speed, power; the rows that count.
    table: Table,
    /// As the drive sees them: reversed where it is mounted so.
    duty: Duty,
    requirement: Requirement,
    /// Rows without a result.
    dropped: usize,
}

impl Loads {
    fn of(asking: &Asking<'_>, question: &Sizing, loads: &StudyResult) -> Result<Loads, Undefined> {
        let names = |source| asking.design.catalogue.columns(source).into_iter().map(|column| column.name);
        let joint: Vec<String> = names(Source::Joint(question.drive)).collect();
        let drive: Vec<String> = names(Source::Drive(question.drive)).collect();
        let column = |names: &[String], part: usize| names.get(part).and_then(|name| loads.table.column(name));
        let (Some(position), Some(effort)) = (column(&joint, 0), column(&drive, 0)) else {
            let message = format!("study `{}` does not tell the force of the drive", loads.name);
            return Err(Undefined { message, hints: Vec::new() });
        };
        let known = |row: &usize| position.values[*row].is_finite() && effort.values[*row].is_finite();
        let rows: Vec<usize> = (0..loads.table.rows()).filter(known).collect();
        if rows.is_empty() {
            let message = format!("no row of study `{}` has a drive force", loads.name);
            return Err(Undefined { message, hints: loads.warnings.clone() });
        }
        let (velocity, acceleration, time) = (column(&joint, 1), column(&joint, 2), loads.table.column("time"));
        // Rates that are not known are those of rest.
        let at = |column: Option<&Column>, row: usize| {
            column.and_then(|column| column.values.get(row).copied()).filter(|value| value.is_finite()).unwrap_or(0.0)
        };
        let row = |&row: &usize| Row {
            position: position.values[row],
            effort: effort.values[row],
            velocity: at(velocity, row),
            acceleration: at(acceleration, row),
            time: time.map(|time| time.values[row]),
        };
        let duty = Duty::new(rows.iter().map(row).collect()).map_err(undefined)?;
        let duty = if question.reversed { duty.reversed() } else { duty };
        let kept = |column: &Column| Column {
            name: column.name.clone(),
            unit: column.unit.clone(),
            values: rows.iter().map(|&row| column.values[row]).collect(),
        };
        let shown = [Some(position), Some(effort), velocity, column(&drive, 1)];
        let table = Table { columns: shown.into_iter().flatten().map(kept).collect() };
        let dropped = loads.table.rows() - rows.len();
        Ok(Loads { table, requirement: Requirement::of(&duty), duty, dropped })
    }

    fn warnings(&self, asking: &Asking<'_>, loads: &StudyResult) -> Vec<String> {
        if self.dropped == 0 {
            return Vec::new();
        }
        let all = loads.table.rows();
        let plural = if self.dropped == 1 { "has no drive force and does" } else { "have no drive force and do" };
        let first = format!("{} of {all} rows of study `{}` {plural} not count", self.dropped, asking.of.name);
        std::iter::once(first).chain(loads.warnings.iter().cloned()).collect()
    }

    fn rows(&self) -> usize {
        self.duty.rows().len()
    }
}
