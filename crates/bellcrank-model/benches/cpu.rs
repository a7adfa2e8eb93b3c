//! CPU seconds of studies over the paper's lift, as JSON: figures that stand beside the peers'. Median of several passes.

use bellcrank_model::Silent;
use cpu_time::ProcessTime;
use shared::{SIX, lift};

const REPEATS: usize = 15;

#[path = "shared/lift.rs"]
mod shared;

fn main() {
    let model = lift(SIX, 601);
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
