//! The solver where something is odd: kinks, holes, contradictions, scales, interruptions.

use std::ops::ControlFlow;

use bellcrank_study::nlp::{
    Evaluation, Function, Malformed, Multistart, Options, Piece, Problem, Relation, Status, Undefined, multistart,
    multistart_parallel, solve, solve_watched,
};

use crate::cases::by_name;

type Evaluate = fn(&[f64]) -> Result<Evaluation, Undefined>;

/// A problem of plain closures.
#[derive(Clone)]
struct Plain {
    bounds: Vec<(f64, f64)>,
    relations: Vec<Relation>,
    evaluate: Evaluate,
}

impl Problem for Plain {
    fn variables(&self) -> usize {
        self.bounds.len()
    }
    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }
    fn relations(&self) -> &[Relation] {
        &self.relations
    }
    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Undefined> {
        assert!(x.iter().zip(&self.bounds).all(|(x, b)| *x >= b.0 && *x <= b.1), "{x:?} is outside");
        (self.evaluate)(x)
    }
}

const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);

fn plain(bounds: &[(f64, f64)], relations: &[Relation], evaluate: Evaluate) -> Plain {
    Plain { bounds: bounds.to_vec(), relations: relations.to_vec(), evaluate }
}

fn smooth(value: f64, gradient: &[f64]) -> Result<Evaluation, Undefined> {
    Ok(Evaluation { objective: Function::smooth(value, gradient.to_vec()), constraints: vec![] })
}

#[test]
fn a_constant_objective_converges_at_once_and_says_zero_gradient() {
    let mut problem = plain(&[(0.0, 1.0), FREE], &[], |_| smooth(5.3, &[0.0, 0.0]));
    let s = solve(&mut problem, &[0.4, 2.0], &Options::default()).unwrap();
    assert_eq!((s.status, s.iterations, s.evaluations, s.objective_gradient), (Status::Converged, 0, 1, 0.0));
    assert_eq!(s.x, [0.4, 2.0]);
}

#[test]
fn contradictory_constraints_end_at_the_least_violation() {
    // x² + y² ≤ 1 and x + y ≥ 3: the sum of violations is least where moving outward along the diagonal no longer pays.
    let mut problem = plain(&[FREE; 2], &[Relation::AtMostZero; 2], |x| {
        Ok(Evaluation {
            objective: Function::smooth(x[0], vec![1.0, 0.0]),
            constraints: vec![
                Function::smooth(x[0] * x[0] + x[1] * x[1] - 1.0, vec![2.0 * x[0], 2.0 * x[1]]),
                Function::smooth(3.0 - x[0] - x[1], vec![-1.0, -1.0]),
            ],
        })
    });
    let s = solve(&mut problem, &[0.2, -0.7], &Options::default()).unwrap();
    assert_eq!(s.status, Status::Infeasible);
    assert!((s.x[0] - s.x[1]).abs() < 1e-6, "{:?}", s.x);
    assert!(s.violation > 0.5 && s.violation < 2.0);
}

#[test]
fn an_unreachable_equality_ends_at_its_nearest_point() {
    let mut problem = plain(&[FREE], &[Relation::Zero], |x| {
        Ok(Evaluation {
            objective: Function::smooth(x[0], vec![1.0]),
            constraints: vec![Function::smooth(x[0] * x[0] + 1.0, vec![2.0 * x[0]])],
        })
    });
    let s = solve(&mut problem, &[2.3], &Options::default()).unwrap();
    assert_eq!(s.status, Status::Infeasible);
    assert!(s.x[0].abs() < 1e-6 && (s.violation - 1.0).abs() < 1e-10, "{:?}", s.x);
}

#[test]
fn the_search_steps_back_from_where_there_is_nothing() {
    // min x − ln x with a hole beyond 1.2 and no values below zero.
    let mut problem =
        plain(
            &[FREE],
            &[],
            |x| {
                if x[0] > 3.2 { Err(Undefined) } else { smooth(x[0] - x[0].ln(), &[1.0 - 1.0 / x[0]]) }
            },
        );
    for start in [0.05, 0.5, 3.0] {
        let s = solve(&mut problem, &[start], &Options::default()).unwrap();
        assert_eq!(s.status, Status::Converged);
        assert!((s.x[0] - 1.0).abs() < 1e-7);
    }
    let s = solve(&mut problem, &[-1.0], &Options::default()).unwrap();
    assert_eq!((s.status, s.evaluations, s.undefined), (Status::UndefinedStart, 1, 1));
}

#[test]
fn an_optimum_against_a_hole_ends_without_hanging() {
    let mut problem = plain(&[FREE], &[], |x| if x[0] < 1.0 { Err(Undefined) } else { smooth(x[0], &[1.0]) });
    let s = solve(&mut problem, &[4.0], &Options::default()).unwrap();
    assert_eq!(s.status, Status::StepTooSmall);
    assert!(s.x[0] - 1.0 < 1e-9 && s.evaluations < 150, "{s:?}");
}

#[test]
fn forces_and_lengths_mix() {
    // A force of some thousand newtons over a length of some hundredths of a metre, limited by another force.
    let mut problem = plain(&[(0.05, 0.4), (0.02, 0.3)], &[Relation::AtMostZero], |x| {
        let (a, b) = (x[0], x[1]);
        Ok(Evaluation {
            objective: Function::smooth(900.0 / a + 4e4 * b, vec![-900.0 / (a * a), 4e4]),
            constraints: vec![Function::smooth(30.0 * a / b - 60.0, vec![30.0 / b, -30.0 * a / (b * b)])],
        })
    });
    let s = solve(&mut problem, &[0.16, 0.2], &Options::default()).unwrap();
    // On b = a/2: 900/a + 2e4 a, least at a = √0.045.
    assert_eq!(s.status, Status::Converged);
    assert!((s.x[0] - 0.045f64.sqrt()).abs() < 1e-8 && (s.x[1] - 0.5 * s.x[0]).abs() < 1e-9, "{:?}", s.x);
    // ∇f + λ∇c = 0 in the second variable: 4e4 = λ 30 a/b².
    let lambda = 4e4 / (30.0 * s.x[0] / (s.x[1] * s.x[1]));
    assert!((s.multipliers.constraints[0] - lambda).abs() < 1e-6 * lambda);
    assert_eq!(s.active_constraints, [0]);
}

#[test]
fn multipliers_balance_the_gradients_in_the_callers_units() {
    for name in ["HS71", "HS43", "HS65", "HS24", "TENSION_SPRING", "CB2"] {
        let mut case = by_name(name);
        let start = case.start.clone();
        let s = solve(&mut case, &start, &Options::default()).unwrap();
        let e = case.evaluate(&s.x).unwrap();
        let size = e.objective.pieces.iter().flat_map(|p| &p.gradient).fold(1e-3, |m: f64, g| m.max(g.abs()));
        for j in 0..start.len() {
            let pieces = e.objective.pieces.iter().zip(&s.multipliers.objective_pieces);
            let mut sum: f64 = pieces.map(|(p, w)| w * p.gradient[j]).sum();
            sum += e
                .constraints
                .iter()
                .zip(&s.multipliers.constraints)
                .map(|(c, l)| l * c.pieces[0].gradient[j])
                .sum::<f64>();
            sum += s.multipliers.upper[j] - s.multipliers.lower[j];
            assert!(sum.abs() < 1e-6 * size, "{name} {j}: {sum}");
        }
        assert!(s.multipliers.lower.iter().chain(&s.multipliers.upper).all(|w| *w >= 0.0));
    }
}

/// max over 601 positions of |force|, where the caller shows the local maxima near the top and their neighbours.
fn over_positions(x: &[f64]) -> Result<Evaluation, Undefined> {
    let at = |k: i32| {
        let phi = f64::from(k) / 600.0 * 2.0;
        let (s, c) = (phi + x[1]).sin_cos();
        let value = 6000.0 * (x[0] * s - 0.5 * phi * phi + x[2] * phi);
        let sign = value.signum();
        let gradient = vec![6000.0 * s * sign, 6000.0 * x[0] * c * sign, 6000.0 * phi * sign];
        Piece { value: value.abs(), gradient }
    };
    let all: Vec<Piece> = (0..=600).map(at).collect();
    let top = all.iter().map(|p| p.value).fold(0.0, f64::max);
    let is_peak = |k: usize| {
        let near = |i: usize| all[i].value <= all[k].value;
        (k == 0 || near(k - 1)) && (k == 600 || near(k + 1)) && all[k].value > 0.5 * top
    };
    let peaks: Vec<usize> = (0..=600).filter(|&k| is_peak(k)).collect();
    let mut shown: Vec<usize> = peaks.iter().flat_map(|&k| k.saturating_sub(1)..=(k + 1).min(600)).collect();
    shown.dedup();
    let pieces = shown.into_iter().map(|k| all[k].clone()).collect();
    Ok(Evaluation { objective: Function { pieces }, constraints: vec![] })
}

#[test]
fn a_peak_over_many_positions_is_flattened_in_few_evaluations() {
    let mut problem = plain(&[(0.1, 3.0), (-1.0, 1.0), (-2.0, 2.0)], &[], over_positions);
    let s = solve(&mut problem, &[1.0, 0.3, 0.2], &Options::default()).unwrap();
    println!(
        "{:?} it {} ev {} f {:.9} x {:?} kkt {:?}",
        s.status, s.iterations, s.evaluations, s.objective, s.x, s.kkt
    );
    assert_eq!(s.status, Status::Converged);
    assert!(s.kkt.worst() < 1e-7 && s.evaluations <= 40);
    assert!(s.multipliers.objective_pieces.iter().filter(|w| **w > 1e-6).count() >= 3);
}

#[test]
fn an_interrupted_search_keeps_its_best_point() {
    let mut case = by_name("HS100");
    let start = case.start.clone();
    let mut seen = Vec::new();
    let s = solve_watched(&mut case, &start, &Options::default(), &mut |p| {
        seen.push(*p);
        if p.iteration == 5 { ControlFlow::Break(()) } else { ControlFlow::Continue(()) }
    });
    let s = s.unwrap();
    assert_eq!((s.status, s.iterations, seen.len()), (Status::Interrupted, 5, 6));
    assert!(s.objective <= seen[0].objective);
}

#[test]
fn fixed_variables_stay_and_no_variables_are_no_problem() {
    let f: Evaluate = |x| smooth((x[0] - x[1]).powi(2), &[2.0 * (x[0] - x[1]), -2.0 * (x[0] - x[1])]);
    let mut problem = plain(&[(2.0, 2.0), (0.0, 9.0)], &[], f);
    let s = solve(&mut problem, &[7.0, 7.0], &Options::default()).unwrap();
    assert!(s.x[0] == 2.0 && (s.x[1] - 2.0).abs() < 1e-7 && s.status == Status::Converged);
    let mut nothing = plain(&[], &[], |_| smooth(1.0, &[]));
    assert_eq!(solve(&mut nothing, &[], &Options::default()).unwrap().status, Status::Converged);
}

#[test]
fn questions_without_sense_are_refused() {
    let mut problem = plain(&[(0.0, 1.0)], &[], |x| smooth(x[0], &[1.0]));
    let options = Options::default();
    assert_eq!(solve(&mut problem, &[], &options), Err(Malformed::Start { found: 0, variables: 1 }));
    assert_eq!(solve(&mut problem, &[f64::NAN], &options), Err(Malformed::StartNotFinite { variable: 0 }));
    problem.bounds = vec![(1.0, 0.0)];
    assert_eq!(solve(&mut problem, &[0.5], &options), Err(Malformed::EmptyBound { variable: 0 }));
    problem.bounds = vec![(f64::NAN, 0.0)];
    assert_eq!(solve(&mut problem, &[0.5], &options), Err(Malformed::EmptyBound { variable: 0 }));
}

#[test]
fn several_starts_find_all_minima_whatever_the_number_of_threads() {
    // sin has minima −1 at −π/2 and 3π/2, a slope tells them apart.
    let mut problem = plain(&[(-4.0, 8.0)], &[], |x| smooth(x[0].sin() + 0.01 * x[0], &[x[0].cos() + 0.01]));
    let (plan, options) = (Multistart::new(12, 3), Options::default());
    let found = multistart(&mut problem, &[4.0], &plan, &options, &|| false).unwrap();
    assert!(found.len() >= 2 && found[0].solution.objective < found[1].solution.objective);
    assert!((found[0].solution.x[0] + std::f64::consts::FRAC_PI_2).abs() < 0.02);
    assert!(found[1].starts.contains(&0));
    for threads in [1, 2, 5] {
        assert_eq!(multistart_parallel(&problem, &[4.0], &plan, &options, threads, &|| false).unwrap(), found);
    }
    let case = by_name("HS71");
    let best = multistart_parallel(&case, &case.start, &Multistart::new(8, 1), &options, 2, &|| false).unwrap();
    assert!((best[0].solution.objective - case.optimum).abs() < 1e-7 * case.optimum);
}
