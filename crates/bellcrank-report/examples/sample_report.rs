//! Writes reports of made-up results and says how long that took: `cargo run --release -p
//! bellcrank-report --example sample_report -- DIR`.

#![allow(missing_docs, unreachable_pub, reason = "shares the samples of the tests")]

use std::path::Path;
use std::time::Instant;

use bellcrank_report::{Exports, ReportError, Style, render_html, terminal_summary, write_report};
use bellcrank_results::{Column, RunResult, study_summary, write_csv};

#[path = "../tests/it/sample/mod.rs"]
mod sample;

fn main() -> Result<(), ReportError> {
    let dir = std::env::args().nth(1).unwrap_or_else(|| "results/samples".to_owned());
    let runs = [
        sample::lift::run(),
        sample::lift::troubled(),
        sample::stewart::run(),
        wide(),
        sample::kinds::run(),
        sample::kinds::poor(),
        sample::forward::run(),
        sample::stress::run(),
        sample::flexible::run(),
    ];
    for (run, name) in
        runs.iter().zip(["lift", "troubled", "stewart", "wide", "kinds", "poor", "forward", "parts", "flexible"])
    {
        print!("{}", terminal_summary(run, &Style { color: false, width: 100 }));
        let columns = run.studies.first().map_or(0, |study| study.table.columns.len());
        println!("\n{name}: {columns} columns");
        timings(run, &Path::new(&dir).join(name))?;
    }
    Ok(())
}

/// The lift with 200 columns of which none is constant.
fn wide() -> RunResult {
    let mut run = sample::lift::run();
    for study in &mut run.studies {
        study.table.columns.retain(|column| column.values.first() != column.values.last());
        let given = study.table.columns.clone();
        let more = (0..)
            .zip(given.iter().cycle())
            .map(|(index, column)| Column { name: format!("extra.{index}"), ..column.clone() });
        study.table.columns.extend(more.take(200 - given.len()));
    }
    run
}

/// Best of twenty, ms.
fn best(mut work: impl FnMut()) -> f64 {
    let once = |_| {
        let start = Instant::now();
        work();
        start.elapsed().as_secs_f64() * 1e3
    };
    (0..20).map(once).fold(f64::INFINITY, f64::min)
}

fn timings(run: &RunResult, dir: &Path) -> Result<(), ReportError> {
    let page = render_html(run);
    let csv = best(|| {
        for study in &run.studies {
            let mut out = Vec::new();
            let _ = write_csv(&study.table, &mut out);
            std::hint::black_box(out);
        }
    });
    let json = best(|| {
        for study in &run.studies {
            std::hint::black_box(study_summary(study).to_string());
        }
    });
    let figures = best(|| {
        for study in &run.studies {
            std::hint::black_box(bellcrank_report::figures(study));
        }
    });
    let html = best(|| {
        std::hint::black_box(render_html(run));
    });
    let write = best(|| {
        let _ = write_report(run, dir);
    });
    let text = best(|| {
        std::hint::black_box(terminal_summary(run, &Style::default()));
    });
    bellcrank_report::write_run(run, dir, Exports { gltf: true, parquet: true, vtu: true })?;
    println!(
        "  csv {csv:.2} ms, json {json:.2} ms, figures {figures:.2} ms, html {html:.2} ms ({} kB)",
        page.len() / 1000
    );
    println!("  report written {write:.2} ms, terminal {text:.2} ms\n");
    Ok(())
}
