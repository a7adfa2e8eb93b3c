//! Every published case from its given start, and from random ones.

use bellcrank_study::nlp::{Options, Status, solve};

use crate::cases::{all, by_name};

#[test]
fn every_case_converges_from_its_start() {
    let mut wrong = Vec::new();
    for mut case in all() {
        let start = case.start.clone();
        let s = solve(&mut case, &start, &Options::default()).unwrap();
        let error = (s.objective - case.optimum).abs() / case.optimum.abs().max(1.0);
        println!(
            "{:15} {:?} it {:3} ev {:3} grad {:3} f {:.12} err {:.1e} viol {:.1e} kkt {:.1e} {:.1e} {:.1e}",
            case.name,
            s.status,
            s.iterations,
            s.evaluations,
            s.gradient_evaluations,
            s.objective,
            error,
            s.violation,
            s.kkt.stationarity,
            s.kkt.feasibility,
            s.kkt.complementarity
        );
        if s.status != Status::Converged || error > 2e-9 || s.kkt.worst() > 1e-7 {
            wrong.push(case.name);
        }
    }
    assert!(wrong.is_empty(), "{wrong:?}");
}

#[test]
fn random_starts_reach_the_published_optimum() {
    for (name, least) in [("HS71", 18), ("HS100", 18), ("HS43", 18), ("CB2", 18), ("HS65", 18)] {
        let case = by_name(name);
        let reached = (0..20).filter(|&i| from_random_start(case.clone(), i)).count();
        println!("{name}: {reached}/20");
        assert!(reached >= least, "{name}: {reached}/20");
    }
}

fn from_random_start(mut case: crate::cases::Case, index: u64) -> bool {
    let start = start_of(&case, index);
    let s = solve(&mut case, &start, &Options::default()).unwrap();
    let error = (s.objective - case.optimum).abs() / case.optimum.abs().max(1.0);
    let good = s.status == Status::Converged && error < 1e-7;
    if !good {
        println!(
            "  {} start {index}: {:?} f {} it {} ev {} {:?}",
            case.name, s.status, s.objective, s.iterations, s.evaluations, s.kkt
        );
    }
    good
}

pub fn start_of(case: &crate::cases::Case, index: u64) -> Vec<f64> {
    (0..case.start.len()).map(|j| random(case, index, j)).collect()
}

fn random(case: &crate::cases::Case, index: u64, j: usize) -> f64 {
    let u = bellcrank_study::sampling::unit(20_240, index, j as u64);
    match case.bounds[j] {
        (l, h) if l.is_finite() && h.is_finite() => l + (h - l) * u,
        _ => case.start[j] + 3.0 * (2.0 * u - 1.0),
    }
}
