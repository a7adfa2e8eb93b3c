//! Many starts, all distinct optima.

use std::ops::ControlFlow;
use std::sync::Mutex;

use super::problem::{Malformed, Problem};
use super::solution::{Options, Progress, Solution, Status};
use super::solver::solve_watched;
use crate::sampling::{LatinHypercube, random_point};

/// From where to start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Multistart {
    /// Number of starts, at least one: the first is the caller's, the others are a Latin hypercube in the bounds.
    pub starts: usize,
    /// Two seeds give two hypercubes.
    pub seed: u64,
    /// Where a variable has no bound, starts lie within this many times its magnitude (at least one) from the first.
    pub spread: f64,
    /// Optima nearer than this in every variable, over the range of the starts, are one.
    pub distinct: f64,
}

impl Multistart {
    /// So many starts with a spread of two and optima told apart at 1e-4.
    #[must_use]
    pub fn new(starts: usize, seed: u64) -> Self {
        Self { starts, seed, spread: 2.0, distinct: 1e-4 }
    }
}

/// One of the optima.
#[derive(Clone, Debug, PartialEq)]
pub struct Optimum {
    /// The best solution of its kind.
    pub solution: Solution,
    /// The starts that led here, from 0, ascending.
    pub starts: Vec<usize>,
    /// Where the best of them began.
    pub from: Vec<f64>,
    /// All searches that led here, the best first.
    pub searches: Vec<Search>,
}

impl Optimum {
    /// Of answers that rounding alone tells apart the first start's is kept, on every machine.
    fn settle(&mut self, options: &Options) {
        const ROUNDING: f64 = 1e-9;
        self.starts.sort_unstable();
        let feasible = |s: &Solution| s.is_feasible(&options.tolerances);
        let best = &self.solution;
        let slack = ROUNDING * best.objective.abs().max(1e-12);
        let as_good = |s: &Solution| {
            s.status == best.status && feasible(s) == feasible(best) && s.objective - best.objective <= slack
        };
        let ties = self.searches.iter().enumerate().filter(|(_, search)| as_good(&search.solution));
        if let Some((place, _)) = ties.min_by_key(|(_, search)| search.start) {
            let first = self.searches.remove(place);
            (self.solution, self.from) = (first.solution.clone(), first.from.clone());
            self.searches.insert(0, first);
        }
    }
}

/// A start and where it led.
#[derive(Clone, Debug, PartialEq)]
pub struct Search {
    /// Its number, from 0.
    pub start: usize,
    /// Where it began.
    pub from: Vec<f64>,
    /// Where it ended.
    pub solution: Solution,
}

/// Solves from every start, one after the other, until `stop` says so. Distinct answers, best first: feasible before
/// infeasible, then by objective (infeasible ones by violation). Starts without values are replaced, up to eight times each.
/// Never empty.
///
/// # Errors
///
/// [`Malformed`] if bounds and start do not fit the problem.
pub fn multistart<P: Problem + ?Sized>(
    problem: &mut P,
    start: &[f64],
    plan: &Multistart,
    options: &Options,
    stop: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<Optimum>, Malformed> {
    let watch = &mut |_: usize, _: &Progress| stopping(stop);
    multistart_watched(problem, start, plan, options, watch)
}

/// [`multistart`] that tells the number of the start and where its search stands, once an iteration; who is told may
/// break off.
///
/// # Errors
///
/// [`Malformed`] if bounds and start do not fit the problem.
pub fn multistart_watched<P: Problem + ?Sized>(
    problem: &mut P,
    start: &[f64],
    plan: &Multistart,
    options: &Options,
    watch: &mut dyn FnMut(usize, &Progress) -> ControlFlow<()>,
) -> Result<Vec<Optimum>, Malformed> {
    let ranges = ranges(problem, start, plan.spread)?;
    let mut found = Vec::new();
    let mut stopped = false;
    for index in 0..plan.starts.max(1) {
        if stopped {
            break;
        }
        let watch = &mut |at: &Progress| {
            let flow = watch(index, at);
            stopped |= flow.is_break();
            flow
        };
        found.push((index, solve_one(problem, start, &ranges, plan, options, index, watch)?));
    }
    Ok(distinct(found, &ranges, plan, options))
}

fn stopping(stop: &(dyn Fn() -> bool + Sync)) -> ControlFlow<()> {
    if stop() { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
}

/// [`multistart`] on several threads, each start on a clone of the problem of its own: the answers are the same for any
/// number of threads.
///
/// # Errors
///
/// [`Malformed`] if bounds and start do not fit the problem.
pub fn multistart_parallel<P: Problem + Clone + Send>(
    problem: &P,
    start: &[f64],
    plan: &Multistart,
    options: &Options,
    threads: usize,
    stop: &(dyn Fn() -> bool + Sync),
) -> Result<Vec<Optimum>, Malformed> {
    let ranges = ranges(problem, start, plan.spread)?;
    let count = plan.starts.max(1);
    let jobs: Mutex<Vec<(usize, P)>> = Mutex::new((0..count).rev().map(|i| (i, problem.clone())).collect());
    let found = Mutex::new(Vec::new());
    let work = || {
        while let Some((index, mut own)) = take(&jobs) {
            if index == 0 || !stop() {
                let watch = &mut |_: &Progress| stopping(stop);
                let solution = solve_one(&mut own, start, &ranges, plan, options, index, watch);
                found.lock().unwrap_or_else(std::sync::PoisonError::into_inner).push((index, solution));
            }
        }
    };
    std::thread::scope(|scope| {
        (1..threads.clamp(1, count)).for_each(|_| drop(scope.spawn(work)));
        work();
    });
    let mut found = found.into_inner().unwrap_or_else(std::sync::PoisonError::into_inner);
    found.sort_by_key(|(index, _)| *index);
    let found = found.into_iter().map(|(index, solution)| Ok((index, solution?)));
    Ok(distinct(found.collect::<Result<_, Malformed>>()?, &ranges, plan, options))
}

fn take<T>(jobs: &Mutex<Vec<T>>) -> Option<T> {
    jobs.lock().unwrap_or_else(std::sync::PoisonError::into_inner).pop()
}

/// The interval of the starts for each variable.
fn ranges<P: Problem + ?Sized>(problem: &P, start: &[f64], spread: f64) -> Result<Vec<(f64, f64)>, Malformed> {
    let (bounds, variables) = (problem.bounds(), problem.variables());
    if bounds.len() != variables {
        return Err(Malformed::Bounds { found: bounds.len(), variables });
    }
    if start.len() != variables {
        return Err(Malformed::Start { found: start.len(), variables });
    }
    let range = |(x, &(l, u)): (&f64, &(f64, f64))| {
        let reach = spread * x.abs().max(1.0);
        (if l.is_finite() { l } else { x.min(u) - reach }, if u.is_finite() { u } else { x.max(l) + reach })
    };
    Ok(start.iter().zip(bounds).map(range).collect())
}

type Started = (Vec<f64>, Solution);

fn solve_one<P: Problem + ?Sized>(
    problem: &mut P,
    start: &[f64],
    ranges: &[(f64, f64)],
    plan: &Multistart,
    options: &Options,
    index: usize,
    watch: &mut dyn FnMut(&Progress) -> ControlFlow<()>,
) -> Result<Started, Malformed> {
    let mut from = place(start, ranges, plan, index, 0);
    let mut solution = solve_watched(problem, &from, options, watch)?;
    for attempt in 1..=8 {
        if index == 0 || solution.status != Status::UndefinedStart {
            break;
        }
        let evaluations = solution.evaluations;
        from = place(start, ranges, plan, index, attempt);
        solution = solve_watched(problem, &from, options, watch)?;
        solution.evaluations += evaluations;
    }
    Ok((from, solution))
}

/// Start `index`: a row of the hypercube; replacements are random.
fn place(start: &[f64], ranges: &[(f64, f64)], plan: &Multistart, index: usize, attempt: u64) -> Vec<f64> {
    let Some(row) = index.checked_sub(1) else { return start.to_vec() };
    let cube = LatinHypercube::new(plan.starts as u64 - 1, ranges.len(), plan.seed);
    let first = if attempt == 0 { cube.point(row as u64) } else { None };
    let shares = first.unwrap_or_else(|| random_point(plan.seed ^ attempt, index as u64, ranges.len()));
    ranges.iter().zip(shares).map(|(&(l, u), share)| l + (u - l) * share).collect()
}

/// Groups equal answers and sorts the groups.
fn distinct(
    mut found: Vec<(usize, Started)>,
    ranges: &[(f64, f64)],
    plan: &Multistart,
    options: &Options,
) -> Vec<Optimum> {
    if found.iter().any(|(_, (_, s))| s.status != Status::UndefinedStart) {
        found.retain(|(_, (_, s))| s.status != Status::UndefinedStart);
    }
    let rank = |s: &Solution| {
        let feasible = s.is_feasible(&options.tolerances);
        (!feasible, if feasible { s.objective } else { s.violation })
    };
    found.sort_by(|(i, (_, a)), (j, (_, b))| {
        let (a, b) = (rank(a), rank(b));
        a.0.cmp(&b.0).then(a.1.total_cmp(&b.1)).then(i.cmp(j))
    });
    let mut optima: Vec<Optimum> = Vec::new();
    for (index, (from, solution)) in found {
        let search = Search { start: index, from, solution };
        match optima.iter_mut().find(|o| is_same(&o.solution, &search.solution, ranges, plan)) {
            Some(optimum) => {
                optimum.starts.push(index);
                optimum.searches.push(search);
            }
            None => optima.push(Optimum {
                solution: search.solution.clone(),
                starts: vec![index],
                from: search.from.clone(),
                searches: vec![search],
            }),
        }
    }
    optima.iter_mut().for_each(|optimum| optimum.settle(options));
    optima
}

fn is_same(a: &Solution, b: &Solution, ranges: &[(f64, f64)], plan: &Multistart) -> bool {
    let near = |((a, b), (l, u)): ((&f64, &f64), &(f64, f64))| (a - b).abs() <= plan.distinct * (u - l);
    a.x.iter().zip(&b.x).zip(ranges).all(near)
}
