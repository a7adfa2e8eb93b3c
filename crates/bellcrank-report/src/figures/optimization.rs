//! How an optimization went.

use bellcrank_results::{IterationRow, Optimization};

use super::FigureFile;
use crate::plot::{Axis, Course, Progress};

/// Starts in one plot, the best first.
const MOST_STARTS: usize = 40;

pub(super) fn figures(found: &Optimization) -> Vec<FigureFile> {
    let best = found.starts.first().map_or(0, |row| row.start);
    let mut starts: Vec<usize> = found.iterations.iter().map(|row| row.start).collect();
    starts.dedup();
    starts.sort_unstable();
    starts.dedup();
    starts.sort_by_key(|start| *start != best);
    let courses: Vec<Course> = starts.iter().take(MOST_STARTS).map(|start| course(found, *start)).collect();
    if courses.first().is_none_or(|course| course.objective.len() < 2) {
        return Vec::new();
    }
    let objective = Axis { name: "objective".to_owned(), unit: found.objective.unit.symbol.clone() };
    let title = "Progress of the search".to_owned();
    let svg = Progress { title: title.clone(), objective, courses }.svg();
    vec![FigureFile::of_finding("progress", "progress".to_owned(), title, svg)]
}

fn course(found: &Optimization, start: usize) -> Course {
    let rows = || found.iterations.iter().filter(move |row| row.start == start);
    let of = |value: fn(&IterationRow) -> f64| rows().map(value).collect::<Vec<f64>>();
    Course {
        objective: rows().map(|row| found.objective.unit.show(row.objective)).collect(),
        violation: of(|row| row.violation),
        optimality: of(|row| row.optimality),
    }
}
