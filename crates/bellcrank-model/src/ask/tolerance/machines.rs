//! Machines with deviating dimensions, on several threads.

use std::sync::atomic::AtomicBool;

use bellcrank_doc::Response;
use bellcrank_study::sampling::for_each_ordered;

use super::inputs::Input;
use crate::ask::Asking;
use crate::progress::Progress;
use crate::trial::{Asked, Undefined};

/// How often progress is told over a study.
const TOLD: u64 = 200;
/// Fewer machines than these are not worth a second thread.
const FEW: u64 = 64;

/// Tries machines, counts them, and tells how far it is.
pub(super) struct Machines<'a, 'd> {
    pub(super) asking: &'a Asking<'d>,
    pub(super) inputs: &'a [Input],
    response: &'a Response,
    progress: &'a mut dyn Progress,
    /// All machines there will be.
    total: u64,
    /// Machines tried so far.
    pub(super) designs: u64,
    /// Positions solved for them.
    pub(super) positions: usize,
    /// Whether the user has had enough.
    pub(super) stopped: bool,
}

impl<'a, 'd> Machines<'a, 'd> {
    pub(super) fn new(
        asking: &'a Asking<'d>,
        response: &'a Response,
        inputs: &'a [Input],
        total: u64,
        progress: &'a mut dyn Progress,
    ) -> Machines<'a, 'd> {
        Machines { asking, inputs, response, progress, total, designs: 0, positions: 0, stopped: false }
    }

    /// The responses of so many machines with the deviations of each, in order: on any number of threads the same.
    /// Ends early when the user stops it.
    pub(super) fn each(
        &mut self,
        count: u64,
        doing: &str,
        deviations: impl Fn(u64) -> Vec<f64> + Sync,
        mut sink: impl FnMut(u64, Result<f64, Undefined>),
    ) {
        if self.stopped {
            return;
        }
        let (asking, inputs, response) = (self.asking, self.inputs, self.response);
        let worker = || {
            let mut asked = Asked::default();
            asked.response(response);
            (asking.trial(asked), Vec::with_capacity(inputs.len()))
        };
        let evaluate = |(trial, fixed): &mut (crate::trial::Trial<'d>, Vec<(usize, f64)>), row: u64| {
            let before = trial.positions;
            fixed.clear();
            let pairs = inputs.iter().zip(deviations(row));
            fixed.extend(pairs.map(|(input, deviation)| (input.parameter, input.nominal + deviation)));
            let answer = trial.run(fixed).map(|numbers| numbers[0]);
            (answer, trial.positions - before)
        };
        let threads = if count <= FEW { 1 } else { asking.threads() };
        let every = (self.total / TOLD).max(1);
        let deliver = |row: u64, (answer, positions): (Result<f64, Undefined>, usize)| {
            sink(row, answer);
            self.designs += 1;
            self.positions += positions;
            if self.designs.is_multiple_of(every) {
                self.progress.at(self.designs as f64 / self.total as f64, doing);
            }
            self.stopped = self.progress.cancelled();
            !self.stopped
        };
        for_each_ordered(0..count, threads, &AtomicBool::new(false), worker, evaluate, deliver);
    }
}
