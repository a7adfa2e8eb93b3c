//! What studies over the paper's lift cost: one sweep, six sensitivities, the optimization, and designs of a sweep.

use std::hint::black_box;

use bellcrank_model::Silent;
use criterion::{Criterion, criterion_group, criterion_main};
use shared::{SIX, lift};

#[path = "shared/lift.rs"]
mod shared;

const DESIGNS: &str = r#"
[studies.designs]
kind = "sweep"
of = "lift"
responses = ["max(abs(drive.slide.force))"]
vary = ["l31", "l32", "l5"]
method = "sobol"
samples = 256
"#;

fn studies(c: &mut Criterion) {
    let model = lift(SIX, 601);
    let mut group = c.benchmark_group("lift, 601 positions");
    for study in ["lift", "six", "six_of_all_rows", "shorter"] {
        group.bench_function(study, |b| b.iter(|| black_box(model.run(study, &mut Silent).expect("runs"))));
    }
    group.finish();
}

fn designs(c: &mut Criterion) {
    let model = lift(DESIGNS, 61);
    let mut group = c.benchmark_group("lift, 61 positions");
    group.sample_size(20);
    group.bench_function("256 designs", |b| b.iter(|| black_box(model.run("designs", &mut Silent).expect("runs"))));
    group.finish();
}

criterion_group!(benches, studies, designs);
criterion_main!(benches);
