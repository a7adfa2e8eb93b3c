//! Draws made-up contours and says how much CPU time that took: `cargo run --release -p bellcrank-report --example
//! sample_pictures -- DIR`.

#![allow(missing_docs, unreachable_pub, dead_code, reason = "shares the samples of the tests")]

use cpu_time::ProcessTime;
use std::path::Path;

use bellcrank_report::{ReportError, pictures, render_html, write_report};
use bellcrank_results::{Contour, StudyResult};

#[path = "../tests/it/sample/mod.rs"]
mod sample;

fn main() -> Result<(), ReportError> {
    let dir = std::env::args().nth(1).unwrap_or_else(|| "results/pictures".to_owned());
    let mut run = sample::stress::run();
    let fine = sample::stress::strip(400, 60, 4);
    run.studies.push(StudyResult { name: "fine".to_owned(), contours: vec![fine], ..StudyResult::default() });
    // Drawings of both kinds in one page.
    let mut machine = sample::stewart::run();
    machine.studies[0].contours = vec![sample::stress::bar()];
    write_report(&machine, &Path::new(&dir).join("machine"))?;
    for study in &run.studies {
        let start = ProcessTime::now();
        let drawn = pictures(study);
        let seconds = start.elapsed().as_secs_f64();
        let triangles: Vec<usize> = study.contours.iter().map(|contour: &Contour| contour.triangles.len()).collect();
        let sizes: Vec<usize> = drawn.iter().flatten().map(|picture| picture.png.len() / 1000).collect();
        println!("{}: {triangles:?} triangles, {:.0} ms, {sizes:?} kB", study.name, 1e3 * seconds);
    }
    let start = ProcessTime::now();
    let page = render_html(&run);
    println!("page: {:.0} ms, {} kB", 1e3 * start.elapsed().as_secs_f64(), page.len() / 1000);
    write_report(&run, Path::new(&dir)).map(|_| ())
}
