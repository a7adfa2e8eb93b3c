//! How long a search, a point and the parallel driver take besides the function itself.

#![allow(missing_docs, reason = "criterion's macros make public functions")]

use std::hint::black_box;
use std::sync::atomic::AtomicBool;

use bellcrank_study::nlp::{Evaluation, Function, Options, Piece, Problem, Relation, Undefined, solve};
use bellcrank_study::sampling::{LatinHypercube, Sobol, for_each_ordered, normal};
use criterion::{Criterion, criterion_group, criterion_main};

/// Three variables, three pieces, two constraints.
struct Small {
    bounds: [(f64, f64); 3],
    relations: [Relation; 2],
}

impl Problem for Small {
    fn variables(&self) -> usize {
        3
    }
    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }
    fn relations(&self) -> &[Relation] {
        &self.relations
    }
    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Undefined> {
        let piece = |a: f64, b: f64, c: f64| Piece {
            value: (x[0] - a).powi(2) + (x[1] - b).powi(2) + 2.0 * (x[2] - c).powi(2),
            gradient: vec![2.0 * (x[0] - a), 2.0 * (x[1] - b), 4.0 * (x[2] - c)],
        };
        let objective = Function { pieces: vec![piece(1.0, 0.0, 0.3), piece(-1.0, 0.5, 0.0), piece(0.2, -1.0, 1.0)] };
        let line = Function::smooth(0.2 - x[0] - x[1], vec![-1.0, -1.0, 0.0]);
        let ball = Function::smooth(x[1] * x[1] + x[2] * x[2] - 0.5, vec![0.0, 2.0 * x[1], 2.0 * x[2]]);
        Ok(Evaluation { objective, constraints: vec![line, ball] })
    }
}

fn searches(c: &mut Criterion) {
    let mut small = Small { bounds: [(-2.0, 2.0); 3], relations: [Relation::AtMostZero; 2] };
    let s = solve(&mut small, &[1.5, -1.0, 1.5], &Options::default()).map(|s| (s.status, s.iterations, s.evaluations));
    println!("small problem: {s:?}");
    c.bench_function("search/3 variables, 3 pieces, 2 constraints", |b| {
        b.iter(|| solve(&mut small, black_box(&[1.5, -1.0, 1.5]), &Options::default()))
    });
}

fn points(c: &mut Criterion) {
    let sobol = Sobol::new(6, 1).unwrap_or_else(|_| unreachable!("6 < 64"));
    let cube = LatinHypercube::new(100_000, 6, 1);
    let mut i = 0;
    c.bench_function("point/sobol 6", |b| {
        b.iter(|| {
            i += 1;
            sobol.point(i)
        })
    });
    c.bench_function("point/latin hypercube 6", |b| b.iter(|| cube.point(black_box(4711))));
    c.bench_function("point/normal quantile", |b| b.iter(|| normal::quantile(black_box(0.137))));
}

fn driver(c: &mut Criterion) {
    for threads in [1, 2] {
        c.bench_function(&format!("driver/100000 empty rows, {threads} threads"), |b| {
            b.iter(|| {
                let cancel = AtomicBool::new(false);
                for_each_ordered(
                    0..100_000,
                    threads,
                    &cancel,
                    || (),
                    |(), i| [i as f64; 4],
                    |_, row| black_box(row)[0] >= 0.0,
                )
            })
        });
    }
}

criterion_group!(benches, searches, points, driver);
criterion_main!(benches);
