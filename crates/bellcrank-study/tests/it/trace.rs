use bellcrank_study::nlp::*;
use std::ops::ControlFlow;
#[test]
#[ignore]
fn trace() {
    let name = std::env::var("CASE").unwrap();
    let mut case = crate::cases::by_name(&name);
    let start = match std::env::var("START") {
        Ok(i) => crate::hock_schittkowski::start_of(&case, i.parse().unwrap()),
        _ => case.start.clone(),
    };
    println!("{start:?}");
    let s = solve_watched(&mut case, &start, &Options::default(), &mut |p| {
        eprintln!(
            "{:3} {:3} f {:.10e} v {:.2e} opt {:.2e} step {:.2e}",
            p.iteration, p.evaluations, p.objective, p.violation, p.optimality, p.step
        );
        ControlFlow::Continue(())
    })
    .unwrap();
    println!("{s:#?}");
}

#[test]
#[ignore]
fn scan() {
    for step in [0.05, 0.1, 0.2, 0.3, 0.5, 0.7, 1.0, 2.0] {
        let mut line = String::new();
        for case in crate::cases::all() {
            let (mut good, mut conv, mut evals) = (0, 0, 0);
            for i in 0..40 {
                let mut own = case.clone();
                let start = crate::hock_schittkowski::start_of(&case, i);
                let s = solve(&mut own, &start, &Options { first_step: step, ..Options::default() }).unwrap();
                let error = (s.objective - case.optimum).abs() / case.optimum.abs().max(1.0);
                good += (s.status == Status::Converged && error < 1e-7) as usize;
                conv += (s.status == Status::Converged) as usize;
                evals += s.evaluations;
            }
            line += &format!("{} {good}/{conv}/{} ", case.name, evals / 40);
        }
        println!("{step} {line}");
    }
}

#[test]
#[ignore]
fn failures() {
    let name = std::env::var("CASE").unwrap();
    for i in 0..40 {
        let mut case = crate::cases::by_name(&name);
        let start = crate::hock_schittkowski::start_of(&case, i);
        let s = solve(&mut case, &start, &Options::default()).unwrap();
        if s.status != Status::Converged {
            println!(
                "{name} {i} {:?} it {} ev {} f {:.9} viol {:.1e} {:?} x {:?}",
                s.status, s.iterations, s.evaluations, s.objective, s.violation, s.kkt, s.x
            );
        }
    }
}
