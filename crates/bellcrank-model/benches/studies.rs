//! What studies over the paper's lift cost: one sweep, six sensitivities, the optimization, and one design of a sweep.

use std::hint::black_box;
use std::path::{Path, PathBuf};

use bellcrank_model::{Model, Silent, load};
use criterion::{Criterion, criterion_group, criterion_main};

/// The shipped lift with other studies behind it.
fn lift(more: &str, points: usize) -> Model {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/assist-manipulator/lift.toml");
    let text = std::fs::read_to_string(shipped).expect("the shipped lift");
    let text = text.replace("points = 601", &format!("points = {points}"));
    let file: PathBuf = std::env::temp_dir().join(format!("bellcrank-bench-{}-{points}.toml", std::process::id()));
    std::fs::write(&file, format!("{text}\n{more}")).expect("a file in the temporary folder");
    let loaded = load(&file, &[]);
    std::fs::remove_file(&file).expect("it was there");
    loaded.model.unwrap_or_else(|| panic!("{}", loaded.diagnostics.render(&loaded.sources, false)))
}

const SIX: &str = r#"
[studies.six]
kind = "sensitivity"
of = "lift"
response = "max(abs(drive.slide.force))"
parameters = ["l31", "l32", "l5", "m1", "m3", "m5"]
points = 0

[studies.six_of_all_rows]
like = "six"
response = "rms(drive.slide.force)"

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
    let model = lift(SIX, 61);
    let mut group = c.benchmark_group("lift, 61 positions");
    group.sample_size(20);
    group.bench_function("256 designs", |b| b.iter(|| black_box(model.run("designs", &mut Silent).expect("runs"))));
    group.finish();
}

criterion_group!(benches, studies, designs);
criterion_main!(benches);
