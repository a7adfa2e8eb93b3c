//! One position of the lift, and chains of growing length: position, rates, drive force, every reaction.
#![expect(unreachable_pub, reason = "modules shared with the tests")]

#[path = "../tests/it/build.rs"]
mod build;
#[path = "../tests/it/machines.rs"]
#[expect(dead_code, reason = "the tests use more of it")]
mod machines;

use bellcrank_math::Real;
use bellcrank_multibody::{Actuation, Engine, Prescription, Seeded, engine_for};
use build::coordinate;
use criterion::{BenchmarkId, Criterion, Throughput, criterion_group, criterion_main};

const POSITIONS: usize = 601;

fn one(e: &mut dyn Engine, target: f64, rate: f64) -> f64 {
    e.move_to(0.0, &[target]).expect("moves");
    e.set_rates(&[rate], &[0.0]).expect("regular");
    e.solve_forces(&mut |_, _| {}).expect("regular");
    e.drive(0)
}

/// The stroke of the paper, −30° to 30° at 20 mm/s, forth and back.
fn lift(c: &mut Criterion) {
    let mut e = engine_for(true, &machines::lift_blueprint([19.84, 20.8, 19.4])).expect("builds");
    e.assemble(&[]).expect("assembles");
    let (lever, slide) = (coordinate(2), coordinate(1));
    e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives");
    let angle = |i: usize| (-30.0 + 60.0 * i as f64 / (POSITIONS - 1) as f64).to_radians();
    one(&mut *e, angle(0), 0.02);
    let mut group = c.benchmark_group("lift");
    group.throughput(Throughput::Elements(2 * POSITIONS as u64));
    group.bench_function("stroke forth and back", |b| {
        b.iter(|| {
            let forth: f64 = (0..POSITIONS).map(|i| one(&mut *e, angle(i), 0.02)).sum();
            let back: f64 = (0..POSITIONS).rev().map(|i| one(&mut *e, angle(i), 0.02)).sum();
            forth + back
        });
    });
    group.finish();
}

/// Derivatives of the same stroke with respect to four numbers, beside the plain stroke.
fn derivatives(c: &mut Criterion) {
    let b = machines::lift_blueprint([19.84, 20.8, 19.4]);
    let mut e = engine_for(true, &b).expect("builds");
    e.assemble(&[]).expect("assembles");
    let (lever, slide) = (coordinate(2), coordinate(1));
    e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives");
    let mut seeded = b.map(Seeded::from_f64);
    for (i, body) in [1, 3, 5].into_iter().enumerate() {
        seeded.bodies[body].mass = Seeded::variable(seeded.bodies[body].mass.re, i);
    }
    seeded.gravity[1] = Seeded::variable(seeded.gravity[1].re, 3);
    e.seed(&seeded).expect("builds");
    let angle = |i: usize| (-30.0 + 60.0 * i as f64 / (POSITIONS - 1) as f64).to_radians();
    one(&mut *e, angle(0), 0.02);
    let mut group = c.benchmark_group("lift");
    group.throughput(Throughput::Elements(POSITIONS as u64));
    group.bench_function("stroke with four derivatives", |b| {
        b.iter(|| {
            let mut sum = 0.0;
            for i in 0..POSITIONS {
                one(&mut *e, angle(i), 0.02);
                let constant = |x: f64| [Seeded::from_f64(x)];
                let at = Prescription {
                    time: Seeded::zero(),
                    position: &constant(angle(i)),
                    velocity: &constant(0.02),
                    acceleration: &constant(0.0),
                };
                e.differentiate(&at, &mut |_, _| {}).expect("regular");
                sum += e.derivatives().expect("seeded").drive(0).eps[0];
            }
            sum
        });
    });
    group.finish();
}

/// What a new design costs before its first position: build, assemble, prepare.
fn fresh(c: &mut Criterion) {
    let b = machines::lift_blueprint([19.84, 20.8, 19.4]);
    let (lever, slide) = (coordinate(2), coordinate(1));
    let mut group = c.benchmark_group("fresh lift");
    group.bench_function("build", |bench| bench.iter(|| engine_for(true, &b).expect("builds")));
    let mut e = engine_for(true, &b).expect("builds");
    group.bench_function("renew, assemble, prepare", |bench| {
        let mut e = engine_for(true, &b).expect("builds");
        bench.iter(|| {
            e.renew(&b).expect("builds");
            e.assemble(&[(lever, -0.5)]).expect("assembles");
            e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives");
        });
    });
    group.bench_function("assemble", |bench| bench.iter(|| e.assemble(&[(lever, -0.5)]).expect("assembles")));
    group.bench_function("prepare", |bench| {
        bench.iter(|| {
            e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives")
        });
    });
    group.finish();
}

fn chains(c: &mut Criterion) {
    let mut group = c.benchmark_group("n-four-bar");
    group.sample_size(10);
    for bodies in [11, 101, 1001, 10_001] {
        let mut e = engine_for(true, &machines::chain((bodies - 1) / 2)).expect("builds");
        e.assemble(&[]).expect("assembles");
        let first = coordinate(0);
        let list = vec![first];
        e.prepare(&Actuation { position: list.clone(), rate: list.clone(), effort: list }).expect("drives");
        for i in 0..5 {
            one(&mut *e, 1.3 - 0.001 * f64::from(i), 0.7);
        }
        let mut step = 0;
        group.throughput(Throughput::Elements(bodies as u64));
        group.bench_function(BenchmarkId::from_parameter(bodies), |b| {
            b.iter(|| {
                // A zigzag between 1.3 and 1.2 rad in steps of 0.001.
                step = (step + 1) % 200;
                let k = if step < 100 { step } else { 200 - step };
                one(&mut *e, 1.3 - 0.001 * f64::from(k), 0.7)
            });
        });
    }
    group.finish();
}

criterion_group!(benches, lift, derivatives, fresh, chains);
criterion_main!(benches);
