//! Rows of a sweep, computed by any thread: each depends on the number of its design alone.

use super::super::Asking;
use super::columns::Columns;
use super::plan::{Plan, Value};
use crate::design::{Designs, Task};
use crate::trial::{Asked, Plain, Trial, Undefined};

/// Designs tried as a reference where the machine of the file itself has no result.
const REFERENCES: u64 = 64;

/// A design with its responses, or why it has none: what stands in the file, bit by bit, so that it does not matter
/// whether it was computed or read back.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Row {
    /// Parameters, then responses, in display units; those are NaN where the design failed.
    pub(super) numbers: Vec<f64>,
    /// Empty, else why there is no result.
    pub(super) reason: String,
}

/// How the designs of a study are run.
enum Machine<'d> {
    /// Position by position.
    Trial(Box<Trial<'d>>),
    /// Each by a run of its own.
    Plain(Plain<'d>),
}

/// The machine of a thread.
pub(super) struct Worker<'d> {
    machine: Machine<'d>,
    of: &'d str,
    fixed: Vec<(usize, f64)>,
    values: Vec<Value>,
    /// Each design is built from nothing.
    fresh: bool,
}

impl<'d> Worker<'d> {
    /// A machine keeps the choices of its equations from design to design. They are made at the same design in every
    /// thread: the machine of the file, or the first design that has a result.
    pub(super) fn new(asking: &Asking<'d>, question: &Designs, plan: &Plan) -> Worker<'d> {
        let mut asked = Asked::default();
        for one in &question.responses {
            asked.response(&one.response);
        }
        let in_time = matches!(asking.of.task, Task::Dynamics(_));
        let machine = match in_time {
            true => Machine::Plain(asking.plain(asked)),
            false => Machine::Trial(Box::new(asking.trial(asked))),
        };
        let fresh = in_time || matches!(asking.of.task, Task::Statics { .. });
        let mut worker = Worker { machine, of: &asking.of.name, fixed: Vec::new(), values: Vec::new(), fresh };
        if !fresh {
            worker.fresh = !worker.refer(plan);
        }
        worker
    }

    /// Whether there is a reference.
    fn refer(&mut self, plan: &Plan) -> bool {
        self.machine.forget();
        if self.machine.run(&[]).is_ok() {
            return true;
        }
        (0..plan.total.min(REFERENCES)).any(|design| {
            self.take(plan, design);
            self.machine.forget();
            self.machine.run(&self.fixed).is_ok()
        })
    }

    fn take(&mut self, plan: &Plan, design: u64) {
        plan.values(design, &mut self.values);
        self.fixed.clear();
        self.fixed.extend(plan.parameters.iter().copied().zip(self.values.iter().map(|value| value.si)));
    }

    pub(super) fn row(&mut self, plan: &Plan, columns: &Columns, design: u64) -> Row {
        self.take(plan, design);
        if self.fresh {
            self.machine.forget();
        }
        let mut numbers = Vec::with_capacity(columns.all.len());
        numbers.extend(self.values.iter().map(|value| value.shown));
        let reason = match self.machine.run(&self.fixed) {
            Ok(responses) => {
                let responses = responses.iter().zip(&columns.all[columns.inputs..]);
                numbers.extend(responses.map(|(si, column)| column.unit.show(*si)));
                String::new()
            }
            Err(why) => {
                numbers.resize(columns.all.len(), f64::NAN);
                reason(&why.message, self.of)
            }
        };
        Row { numbers, reason }
    }

    /// Positions or instants solved so far.
    pub(super) fn positions(&self) -> usize {
        match &self.machine {
            Machine::Trial(trial) => trial.positions,
            Machine::Plain(plain) => plain.rows,
        }
    }
}

impl Machine<'_> {
    fn run(&mut self, fixed: &[(usize, f64)]) -> Result<&[f64], Undefined> {
        match self {
            Machine::Trial(trial) => trial.run(fixed),
            Machine::Plain(plain) => plain.run(fixed),
        }
    }

    /// The next design is built from nothing.
    fn forget(&mut self) {
        if let Machine::Trial(trial) = self {
            trial.forget();
        }
    }
}

/// One line without the name of the study, which is that of all rows.
fn reason(message: &str, of: &str) -> String {
    let own = message.strip_prefix(&format!("study `{of}`")).map(|rest| rest.trim_start_matches([',', ':', ' ']));
    let line = own.unwrap_or(message).replace(|c: char| c.is_control(), " ");
    if line.is_empty() { "no result".to_owned() } else { line }
}
