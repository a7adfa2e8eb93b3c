//! Responses over many designs: a grid, points spread over ranges, or the lines of a table.
//!
//! Rows are computed by any number of threads, each from the number of its design alone, and come here in order: to the
//! file, and into what is said about all of them.

mod columns;
mod display;
mod inputs;
mod journal;
mod lock;
mod plan;
mod stored;
mod tally;
mod worker;

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};
use std::time::{Duration, Instant};

use bellcrank_results::{Designs as Found, Findings, StudyResult};
use bellcrank_study::sampling::for_each_in_chunks;

use super::{Asking, cancelled};
use crate::design::{Designs, Method};
use crate::progress::Progress;
use crate::trial::Undefined;
use columns::Columns;
use display::Display;
use inputs::Inputs;
use journal::Journal;
use plan::Plan;
use tally::Tally;
use worker::{Row, Worker};

/// Rows that a thread computes together take about so long.
const CHUNK: Duration = Duration::from_millis(20);
const MOST_IN_CHUNK: u64 = 64;

pub(super) fn run(
    asking: &Asking<'_>,
    question: &Designs,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), Undefined> {
    progress.at(0.0, "preparing the designs");
    let plan = Plan::new(asking, question)?;
    let columns = Columns::new(asking, question);
    let mut tally = Tally::new(&columns, question.pareto);
    let mut journal = None;
    if let Some(folder) = &asking.options.folder {
        let inputs = Inputs::new(asking, question, &plan, &columns);
        let mut taken = |row: &Row| tally.push(row);
        journal = Some(Journal::open(folder, &columns, inputs, asking.options.fresh, plan.total, &mut taken)?);
    }
    let sweep = Sweep { asking, question, plan: &plan, columns: &columns, resumed: tally.done };
    let ended = sweep.compute(&mut tally, &mut journal, result, progress);
    let files = if journal.is_some() { sweep.files(ended.is_ok()) } else { Vec::new() };
    sweep.tell(&tally, files, result);
    ended
}

/// A sweep with all that is fixed about it.
#[derive(Clone, Copy)]
struct Sweep<'a, 'd> {
    asking: &'a Asking<'d>,
    question: &'a Designs,
    plan: &'a Plan,
    columns: &'a Columns,
    /// Rows of an earlier run.
    resumed: u64,
}

impl Sweep<'_, '_> {
    /// The rows that are missing.
    fn compute(
        &self,
        tally: &mut Tally,
        journal: &mut Option<Journal>,
        result: &mut StudyResult,
        progress: &mut dyn Progress,
    ) -> Result<(), Undefined> {
        let (plan, columns) = (self.plan, self.columns);
        let mut display = Display::new(self.resumed, plan.total);
        let (stop, positions) = (AtomicBool::new(false), AtomicUsize::new(0));
        let mut fault = None;
        let sink = |design, row: Option<Row>| {
            if let Some(row) = row {
                tally.push(&row);
                fault = journal.as_mut().and_then(|journal| journal.push(design, &row).err());
            }
            display.row(progress);
            let go_on = fault.is_none() && !progress.cancelled();
            stop.store(!go_on, Ordering::Relaxed);
            go_on
        };
        let row = |worker: &mut Worker<'_>, design| {
            // Nobody takes what is computed after the end.
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            let before = worker.positions();
            let row = worker.row(plan, columns, design);
            positions.fetch_add(worker.positions() - before, Ordering::Relaxed);
            Some(row)
        };
        let worker = || Worker::new(self.asking, self.question, plan);
        let missing = self.resumed..plan.total;
        if !missing.is_empty() {
            for_each_in_chunks(
                missing,
                self.asking.threads(),
                self.chunk(),
                &AtomicBool::new(false),
                worker,
                row,
                sink,
            );
        }
        let count = |name: &str, value: f64| (name.to_owned(), value);
        let positions = positions.into_inner() as f64;
        result.effort = vec![count("designs", (tally.done - self.resumed) as f64), count("positions", positions)];
        if let Some(fault) = fault {
            return Err(fault);
        }
        self.end(tally.done, journal, progress)
    }

    /// So many that Ctrl-C is heard soon, and that few are lost when the program is killed.
    fn chunk(&self) -> u64 {
        let mut worker = Worker::new(self.asking, self.question, self.plan);
        let begun = Instant::now();
        worker.row(self.plan, self.columns, self.resumed);
        let each = begun.elapsed().as_nanos().max(1);
        u64::try_from(CHUNK.as_nanos() / each).map_or(MOST_IN_CHUNK, |rows| rows.clamp(1, MOST_IN_CHUNK))
    }

    fn end(&self, done: u64, journal: &mut Option<Journal>, progress: &mut dyn Progress) -> Result<(), Undefined> {
        let total = self.plan.total;
        if done == total {
            progress.at(1.0, "writing files");
            return journal.as_mut().map_or(Ok(()), Journal::finish);
        }
        let Some(journal) = journal else { return Err(cancelled(&format!("after {done} of {total} designs"))) };
        journal.pause()?;
        let stopped = cancelled(&format!("after {done} of {total} designs, which are kept"));
        Err(Undefined { hints: vec!["the same command goes on behind the last of them".to_owned()], ..stopped })
    }

    fn files(&self, finished: bool) -> Vec<String> {
        let names = if finished { &[journal::CSV, journal::PARQUET][..] } else { &[journal::CSV] };
        names.iter().map(|name| (*name).to_owned()).collect()
    }

    fn tell(&self, tally: &Tally, files: Vec<String>, result: &mut StudyResult) {
        let front = tally.front();
        if let Some((_, count)) = &front
            && *count > tally::FRONT
        {
            result.warnings.push(format!(
                "{count} designs are best compromises; {} of them, evenly spread, are listed here",
                tally::FRONT
            ));
        }
        let failures = tally.failures();
        if let Some(failure) = failures.first().filter(|_| tally.failed == tally.done) {
            result.warnings.push(format!("no design has a result: {}", failure.reason));
        }
        let random = matches!(self.question.method, Method::LatinHypercube | Method::Sobol);
        result.findings = Some(Findings::Designs(Found {
            of: self.asking.of.name.clone(),
            method: self.question.method.name().to_owned(),
            seed: random.then_some(self.question.seed),
            total: self.plan.total,
            done: tally.done,
            resumed: self.resumed,
            failed: tally.failed,
            failures,
            inputs: self.columns.inputs,
            sample: tally.sample(),
            statistics: tally.statistics(),
            pareto: front.map(|(front, _)| front),
            files,
            threads: self.asking.threads(),
        }));
    }
}
