//! Runs in time, and the recursions over a tree: a six-axis arm, Andrews' squeezer, the lift's stroke, chains.
#![expect(unreachable_pub, reason = "modules shared with the tests")]

#[path = "../tests/it/arm.rs"]
mod arm;
#[path = "../tests/it/build.rs"]
mod build;
#[path = "../tests/it/machines.rs"]
#[expect(dead_code, reason = "the tests use more of it")]
mod machines;
#[path = "shared/runs.rs"]
#[expect(dead_code, reason = "the other bench uses more of it")]
mod runs;

use bellcrank_multibody::engine_for;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

/// Inverse dynamics and mass matrix of 256 random states.
fn arm(c: &mut Criterion) {
    let (mut e, states) = (arm::machine(), arm::states());
    let (mut tau, mut m) = ([0.0; arm::AXES], [0.0; arm::AXES * arm::AXES]);
    let mut group = c.benchmark_group("six-axis arm");
    group.throughput(Throughput::Elements(arm::STATES as u64));
    group.bench_function("inverse dynamics", |b| {
        b.iter(|| {
            let one = |sum: f64, [q, v, a]: &arm::State| {
                e.inverse_dynamics(q, v, a, &mut tau);
                sum + tau[0]
            };
            states.iter().fold(0.0, one)
        });
    });
    group.bench_function("mass matrix", |b| {
        b.iter(|| {
            let one = |sum: f64, state: &arm::State| {
                e.mass_matrix(&state[0], &mut m);
                sum + m[0]
            };
            states.iter().fold(0.0, one)
        });
    });
    group.finish();
}

/// To 0.03 s; the crank's angle is off by less than the tolerance there.
fn squeezer(c: &mut Criterion) {
    let mut group = c.benchmark_group("Andrews' squeezer");
    let mut e = engine_for(true, &machines::andrews()).expect("builds");
    for tolerance in [1e-4, 1e-6, 1e-8] {
        let (error, effort) = runs::squeeze(&mut *e, tolerance);
        println!("{tolerance:e}: error {error:.1e}, {effort:?}");
        group.throughput(Throughput::Elements(effort.evaluations as u64));
        group.bench_function(BenchmarkId::from_parameter(format!("{tolerance:e}")), |b| {
            b.iter(|| runs::squeeze(&mut *e, tolerance));
        });
    }
    group.finish();
}

/// 8 s at 20 mm/s to 1e-6.
fn lift(c: &mut Criterion) {
    let mut group = c.benchmark_group("driven lift");
    let mut e = engine_for(true, &machines::lift_blueprint(runs::MASSES)).expect("builds");
    let mut forces = Vec::new();
    for rows in [601, 7998] {
        group.throughput(Throughput::Elements(rows as u64));
        group.bench_function(BenchmarkId::new("rows", rows), |b| {
            b.iter(|| runs::lift_stroke(&mut *e, 1e-6, rows, &mut forces));
        });
    }
    group.finish();
}

/// A second of the fall of N four-bars; elements are evaluations times loops.
fn chains(c: &mut Criterion) {
    let mut group = c.benchmark_group("falling n-four-bar");
    group.sample_size(10);
    for n in [1, 10, 100, 1000] {
        let mut e = engine_for(true, &machines::chain(n)).expect("builds");
        runs::let_go(&mut *e, 1e-6);
        let effort = runs::fall(&mut *e, 1.0);
        group.throughput(Throughput::Elements((effort.evaluations * n) as u64));
        group.bench_function(BenchmarkId::from_parameter(n), |b| {
            b.iter_custom(|times| {
                let mut passed = std::time::Duration::ZERO;
                for _ in 0..times {
                    runs::let_go(&mut *e, 1e-6);
                    let start = std::time::Instant::now();
                    runs::fall(&mut *e, 1.0);
                    passed += start.elapsed();
                }
                passed
            });
        });
    }
    group.finish();
}

criterion_group!(benches, arm, squeezer, lift, chains);
criterion_main!(benches);
