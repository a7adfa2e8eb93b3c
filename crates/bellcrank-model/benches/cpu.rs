//! CPU seconds of studies over the paper's lift, as JSON: figures that stand beside the peers'. Median of several passes.

use std::path::Path;

use bellcrank_model::{Model, Silent, load};
use cpu_time::ProcessTime;

const REPEATS: usize = 15;

/// What the paper's question costs: a sweep, its sensitivities, its optimum.
const STUDIES: &str = r#"
[studies.six]
kind = "sensitivity"
of = "lift"
response = "max(abs(drive.slide.force))"
parameters = ["l31", "l32", "l5", "m1", "m3", "m5"]
points = 0

[studies.six_of_all_rows]
like = "six"
response = "rms(drive.slide.force)"
"#;

fn main() {
    let model = lift();
    let seconds = |study: &str| median(|| drop(model.run(study, &mut Silent).expect("runs")));
    let figures = [
        ("sweep", seconds("lift")),
        ("six_sensitivities", seconds("six")),
        ("six_sensitivities_of_all_rows", seconds("six_of_all_rows")),
        ("optimum", seconds("shorter")),
    ];
    let told: Vec<String> = figures.iter().map(|(name, s)| format!("\"{name}_ms\": {:.4}", s * 1e3)).collect();
    println!("{{{}}}", told.join(", "));
}

/// The shipped lift with the studies behind it.
fn lift() -> Model {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/assist-manipulator/lift.toml");
    let text = std::fs::read_to_string(shipped).expect("the shipped lift");
    let file = std::env::temp_dir().join(format!("bellcrank-cpu-{}.toml", std::process::id()));
    std::fs::write(&file, format!("{text}\n{STUDIES}")).expect("a file in the temporary folder");
    let loaded = load(&file, &[]);
    std::fs::remove_file(&file).expect("it was there");
    loaded.model.unwrap_or_else(|| panic!("{}", loaded.diagnostics.render(&loaded.sources, false)))
}

fn median(mut run: impl FnMut()) -> f64 {
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = ProcessTime::now();
            run();
            start.elapsed().as_secs_f64()
        })
        .collect();
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}
