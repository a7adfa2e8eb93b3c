//! One study of each kind that is over another study: the lift of [`super::lift`] with other dimensions.
//!
//! Closed form, quasi-static: derivatives are central differences, the optimum is the corner where it lies.

use std::f64::consts::PI;

use bellcrank_results::{
    ActivePlace, Column, ColumnStatistics, Compared, ConstraintRow, Curve, DesignFailure, Designs, Findings,
    FirstOrder, IterationRow, Objective, Optimization, ParameterSensitivity, ParetoFront, Reductions, RunResult,
    Sensitivity, StartRow, StudyResult, Table, Unit, VariableRow,
};

use super::{column, lift, unit};

/// Dimensions and masses by name, SI.
const NOMINAL: [(&str, f64, &str); 8] = [
    ("l31", 0.732, "mm"),
    ("l32", 0.160, "mm"),
    ("l5", 0.950, "mm"),
    ("m1", 19.84, "kg"),
    ("m3", 20.8, "kg"),
    ("m5", 19.4, "kg"),
    ("load", 800.0, "N"),
    ("l42", 0.1, "mm"),
];
pub const PEAK: &str = "max(abs(drive.slide.force))";
const BOUNDS: [(f64, f64); 3] = [(0.6, 0.8), (0.1, 0.2), (0.8, 1.0)];

pub type Point = [f64; 8];

pub fn nominal() -> Point {
    NOMINAL.map(|(_, value, _)| value)
}

fn with(mut point: Point, index: usize, value: f64) -> Point {
    point[index] = value;
    point
}

/// Drive force and length of the drive at one position: moments about B.
fn at([l31, l32, l5, m1, m3, m5, load, _]: Point, theta: f64) -> (f64, f64) {
    const G: f64 = 9.81;
    let (s, c) = theta.sin_cos();
    let n = [l31 * c + l32 * s, l32 + l31 * s - l32 * c];
    let length = n[0].hypot(n[1]);
    let u = [n[0] / length, n[1] / length];
    let across = m1 * G * (l31 / 2.0) * u[0] / length;
    let arm = [n[0], n[1] - l32];
    let moment = l5 * c * (load + m5 * G / 2.0) + m3 * G * (l5 / 2.0 - 0.05) * c;
    let turned = arm[0] * -u[0] * across - arm[1] * u[1] * across;
    ((moment - turned) / (arm[0] * u[1] - arm[1] * u[0]), length)
}

const ENDS: [f64; 2] = [-30.0, 30.0];

pub fn peak(point: Point) -> f64 {
    ENDS.iter().map(|end| at(point, end * PI / 180.0).0.abs()).fold(0.0, f64::max)
}

pub fn stroke(point: Point) -> f64 {
    let [low, high] = ENDS.map(|end| at(point, end * PI / 180.0).1);
    (high - low).abs()
}

/// A number of 0..1 that looks random.
pub fn random(state: &mut u64) -> f64 {
    *state = state.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
    (*state >> 11) as f64 / (1_u64 << 53) as f64
}

pub fn derivative(of: impl Fn(Point) -> f64, index: usize) -> f64 {
    let here = nominal()[index];
    let step = 1e-5 * here;
    (of(with(nominal(), index, here + step)) - of(with(nominal(), index, here - step))) / (2.0 * step)
}

fn per(numerator: &str, denominator: &str) -> Unit {
    let si = if denominator == "mm" { "m" } else { denominator };
    Unit::new(if numerator == si { String::new() } else { format!("{numerator}/{si}") }, 1.0)
}

fn study(name: &str, kind: &str, findings: Findings) -> StudyResult {
    StudyResult {
        name: name.to_owned(),
        kind: kind.to_owned(),
        findings: Some(findings),
        seconds: 0.0123,
        ..StudyResult::default()
    }
}

pub fn sensitivity() -> Sensitivity {
    let value = peak(nominal());
    let parameter = |(index, (name, here, symbol)): (usize, &(&str, f64, &str))| {
        let derivative = if *name == "l42" { 0.0 } else { derivative(peak, index) };
        let curve = BOUNDS.get(index).map(|(low, high)| {
            let parameter: Vec<f64> = (0..=40).map(|i| low + (high - low) * f64::from(i) / 40.0).collect();
            let response = parameter.iter().map(|p| peak(with(nominal(), index, *p))).collect();
            Curve { parameter, response }
        });
        ParameterSensitivity {
            name: (*name).to_owned(),
            value: *here,
            unit: unit(symbol),
            derivative,
            derivative_unit: per("N", symbol),
            relative: derivative * here / value,
            note: if *name == "l42" {
                "no effect: the parallelogram carries the moment".to_owned()
            } else {
                String::new()
            },
            curve,
        }
    };
    let place = |reduction: &str| ActivePlace {
        reduction: reduction.to_owned(),
        axis: "joint.B.position".to_owned(),
        place: -PI / 6.0,
        unit: unit("deg"),
        between_rows: false,
    };
    Sensitivity {
        of: "lift".to_owned(),
        response: PEAK.to_owned(),
        value,
        unit: unit("N"),
        at: vec![place(PEAK)],
        parameters: NOMINAL.iter().enumerate().map(parameter).collect(),
    }
}

fn corner() -> Point {
    let mut best = nominal();
    (best[0], best[1], best[2]) = (0.6, 0.2, 0.8);
    best
}

pub fn optimization() -> Optimization {
    let best = corner();
    let bound = ["lower", "upper", "lower"];
    let variable = |index: usize| {
        let (name, start, symbol) = NOMINAL[index];
        let step = 1e-6;
        let multiplier =
            (peak(with(best, index, best[index] + step)) - peak(with(best, index, best[index] - step))) / (2.0 * step);
        VariableRow {
            name: name.to_owned(),
            start,
            value: best[index],
            unit: unit(symbol),
            bounds: BOUNDS[index],
            bound: Some(bound[index]),
            multiplier,
            multiplier_unit: per("N", symbol),
        }
    };
    let constraint =
        |written: &str, left: (f64, f64), right: f64, symbol: &str, active: bool, multiplier: f64| ConstraintRow {
            written: written.to_owned(),
            left,
            right,
            unit: unit(symbol),
            active,
            violation: 0.0,
            multiplier,
            multiplier_unit: per("N", symbol),
        };
    let strokes = (stroke(nominal()), stroke(best));
    Optimization {
        of: "lift".to_owned(),
        objective: Objective {
            written: PEAK.to_owned(),
            maximize: false,
            start: peak(nominal()),
            value: peak(best),
            unit: unit("N"),
        },
        variables: (0..3).map(variable).collect(),
        constraints: vec![
            constraint("range(joint.slide.position) <= 220 mm", strokes, 0.22, "mm", false, 0.0),
            constraint("l5 - l31 >= 200 mm", (0.218, 0.2), 0.2, "mm", true, 1234.5),
        ],
        compared: vec![
            Compared { name: PEAK.to_owned(), start: peak(nominal()), value: peak(best), unit: unit("N") },
            Compared {
                name: "range(joint.slide.position)".to_owned(),
                start: strokes.0,
                value: strokes.1,
                unit: unit("mm"),
            },
            Compared { name: "l5 - l31".to_owned(), start: 0.218, value: 0.2, unit: unit("mm") },
        ],
        iterations: iterations(),
        starts: starts(),
        iteration_count: 7,
        evaluations: 31,
        failed_designs: 2,
        status: "converged".to_owned(),
        first_order: FirstOrder { stationarity: 3.1e-9, feasibility: 0.0, complementarity: 4.4e-10, holds: true },
        written: Some("lift-shorter.toml".to_owned()),
    }
}

/// A line from `from` to `to` in steps that shrink.
fn iterations() -> Vec<IterationRow> {
    let mut rows = Vec::new();
    for (start, count, from) in
        [(0_usize, 7_usize, nominal()), (1, 9, with(nominal(), 1, 0.11)), (2, 5, with(nominal(), 0, 0.79))]
    {
        for iteration in 0..=count {
            let left = 0.35_f64.powi(iteration as i32)
                - if iteration == count { 0.35_f64.powi(iteration as i32) } else { 0.0 };
            let between: Point = std::array::from_fn(|i| corner()[i] + left * (from[i] - corner()[i]));
            rows.push(IterationRow {
                start,
                iteration,
                evaluations: iteration + iteration / 3 + 1,
                objective: peak(between),
                violation: if iteration < 2 { 0.04 * left } else { 0.0 },
                optimality: 3e-9_f64.max(0.8 * left * left * left),
                step: if iteration == 0 { 0.0 } else { 0.6 * left },
            });
        }
    }
    rows
}

fn starts() -> Vec<StartRow> {
    let row = |start: usize, from: [f64; 3], point: [f64; 3], status: &str| {
        let mut end = nominal();
        end[..3].copy_from_slice(&point);
        StartRow {
            start,
            from: from.to_vec(),
            point: point.to_vec(),
            objective: peak(end),
            violation: if status == "infeasible" { 0.031 } else { 0.0 },
            status: status.to_owned(),
        }
    };
    vec![
        row(0, [0.732, 0.16, 0.95], [0.6, 0.2, 0.8], "converged"),
        row(1, [0.732, 0.11, 0.95], [0.6, 0.2, 0.8], "converged"),
        row(2, [0.79, 0.16, 0.95], [0.7613, 0.2, 0.8], "converged"),
        row(3, [0.652, 0.128, 0.981], [0.7128, 0.134, 0.8], "infeasible"),
    ]
}

/// 300 designs at random; where the lever is short and the pin low, they pretend to fail.
pub fn designs() -> Designs {
    const COUNT: usize = 300;
    let mut state = 20_260_314;
    let points: Vec<Point> = (0..COUNT)
        .map(|_| {
            let mut point = nominal();
            for (value, (low, high)) in point.iter_mut().zip(BOUNDS) {
                *value = low + (high - low) * random(&mut state);
            }
            point
        })
        .collect();
    let failed = |p: &Point| p[0] < 0.65 && p[1] > 0.19;
    let input = |index: usize| points.iter().map(|p| p[index]).collect::<Vec<_>>();
    let response = |of: fn(Point) -> f64| points.iter().map(|p| if failed(p) { f64::NAN } else { of(*p) }).collect();
    let columns = vec![
        column("design", "", (0..COUNT).map(|row| row as f64).collect()),
        column("l31", "mm", input(0)),
        column("l32", "mm", input(1)),
        column("l5", "mm", input(2)),
        column(PEAK, "N", response(peak)),
        column("range(joint.slide.position)", "mm", response(stroke)),
    ];
    let failures = points.iter().filter(|p| failed(p)).count() as u64;
    let first = points.iter().position(failed).unwrap_or(0) as u64;
    Designs {
        of: "lift".to_owned(),
        method: "lhs".to_owned(),
        seed: Some(20_260_314),
        total: COUNT as u64,
        done: COUNT as u64,
        resumed: 120,
        failed: failures,
        failures: vec![DesignFailure {
            reason: "the mechanism cannot be assembled at `joint.B.position` = 30 deg".to_owned(),
            count: failures,
            first,
        }],
        inputs: 3,
        statistics: columns[1..].iter().map(statistics).collect(),
        pareto: Some(front(&columns)),
        sample: Table { columns },
        files: vec!["designs.csv".to_owned()],
        threads: 2,
    }
}

fn statistics(column: &Column) -> ColumnStatistics {
    let found = Reductions::of(&column.values).unwrap();
    ColumnStatistics {
        name: column.name.clone(),
        unit: column.unit.clone(),
        min: (found.min.value, found.min.row as u64),
        max: (found.max.value, found.max.row as u64),
        mean: found.mean,
        deviation: (found.rms * found.rms - found.mean * found.mean).max(0.0).sqrt(),
    }
}

fn front(columns: &[Column]) -> ParetoFront {
    let (a, b) = (&columns[4].values, &columns[5].values);
    let beaten = |i: usize| (0..a.len()).any(|j| a[j] <= a[i] && b[j] <= b[i] && (a[j] < a[i] || b[j] < b[i]));
    let mut rows: Vec<usize> = (0..a.len()).filter(|i| a[*i].is_finite() && !beaten(*i)).collect();
    rows.sort_by(|i, j| a[*i].total_cmp(&a[*j]));
    let pick =
        |column: &Column| Column { values: rows.iter().map(|row| column.values[*row]).collect(), ..column.clone() };
    ParetoFront {
        objectives: [(PEAK.to_owned(), true), ("range(joint.slide.position)".to_owned(), true)],
        front: Table { columns: columns.iter().map(pick).collect() },
    }
}

/// The lift and a study of each kind over it.
pub fn run() -> RunResult {
    let mut run = lift::run();
    run.studies.truncate(1);
    run.studies.extend([
        study("influence", "sensitivity", Findings::Sensitivity(sensitivity())),
        study("shorter", "optimize", Findings::Optimization(optimization())),
        study("space", "sweep", Findings::Designs(designs())),
        study("scatter", "tolerance", Findings::Tolerance(super::drive::tolerance())),
        StudyResult {
            axis: vec!["joint.slide.position".to_owned()],
            table: super::drive::pressure(),
            ..study("cylinder", "sizing", Findings::Sizing(super::drive::sizing()))
        },
    ]);
    run
}

/// As [`run`], but nothing succeeds: no feasible design, no design of the sweep, no drive, no effect.
pub fn poor() -> RunResult {
    let mut run = run();
    for study in &mut run.studies {
        match &mut study.findings {
            Some(Findings::Sensitivity(found)) => {
                found.value = 0.0;
                for row in &mut found.parameters {
                    (row.relative, row.derivative, row.curve) = (f64::NAN, f64::NAN, None);
                    row.note = "not defined: two rows have the same maximum".to_owned();
                }
            }
            Some(Findings::Optimization(found)) => {
                found.status = "infeasible".to_owned();
                found.objective.start = f64::NAN;
                found.first_order.holds = false;
                found.constraints[0].violation = 0.0123;
                found.starts.clear();
                found.iterations.truncate(1);
                found.written = None;
            }
            Some(Findings::Designs(found)) => {
                found.failed = found.total;
                found.pareto = None;
                found.statistics.truncate(3);
                found.sample.columns[4].values.fill(f64::NAN);
                found.sample.columns[5].values.fill(f64::NAN);
            }
            Some(Findings::Tolerance(found)) => {
                found.monte_carlo = None;
                found.limits = (None, None);
                (found.linear_yield, found.capability) = (f64::NAN, (f64::NAN, f64::NAN));
                found.worst_case_exact = None;
            }
            Some(Findings::Sizing(found)) => {
                found.candidates.retain(|candidate| !candidate.passes);
                found.chosen = None;
            }
            Some(Findings::Modes(_) | Findings::Stress(_) | Findings::BodyModes(_)) | None => {}
        }
    }
    run.studies.last_mut().unwrap().table = Table::default();
    run
}
