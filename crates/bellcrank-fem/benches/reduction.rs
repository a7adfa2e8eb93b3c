//! Reduction of a plate of 950 × 120 × 20 mm with three rigid interfaces and eight modes, about 16,000 unknowns, step by step in
//! process CPU seconds, as JSON.
//!
//! `cargo bench -p bellcrank-fem --bench reduction -- go [THREADS [CELLS]]`; without arguments it does nothing.

use bellcrank_fem::{CouplingKind, Interface, Keep, Material, Part, Reduction, Region, Settings, reduce};
use bellcrank_mesh::{Face, Mesh, Shape};
use cpu_time::ProcessTime;

#[path = "../tests/it/grids.rs"]
#[expect(dead_code, reason = "tests need more of it")]
mod grids;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let [_, rest @ ..] = &arguments[..] else { return };
    let number = |at: usize, default| rest.get(at).and_then(|text| text.parse().ok()).unwrap_or(default);
    let (threads, cells) = (number(0, 1), number(1, 48));
    let mesh = grids::grid(Shape::Wedge15, [cells, cells / 6, 2], |[x, y, z]| {
        [0.95 * x, 0.12 * (y - 0.5) + 0.03 * x * x, 0.02 * (z - 0.5)]
    });
    let part = Part {
        mesh: &mesh,
        materials: vec![Material::isotropic(2.1e11, 0.3, 7850.0).expect("steel")],
        supports: Vec::new(),
        couplings: Vec::new(),
    };
    for kind in [CouplingKind::Rigid, CouplingKind::Distributing] {
        run(&part, kind, threads);
    }
}

/// The two ends, and the top near three quarters of the length.
fn interfaces(mesh: &Mesh, kind: CouplingKind) -> Vec<Interface> {
    let faces = |test: &dyn Fn([f64; 3]) -> bool| -> Vec<Face> { grids::faces_where(mesh, test) };
    let regions = [
        (faces(&|at| at[0].abs() < 1e-9), [0.0; 3]),
        (faces(&|at| (at[0] - 0.95).abs() < 1e-9), [0.95, 0.03, 0.0]),
        (faces(&|at| (at[2] - 0.01).abs() < 1e-9 && (0.69..0.78).contains(&at[0])), [0.732, -0.05, 0.0]),
    ];
    regions.into_iter().map(|(faces, point)| Interface { region: Region::Faces(faces), point, kind }).collect()
}

fn run(part: &Part<'_>, kind: CouplingKind, threads: usize) {
    let settings = Settings { threads, ..Settings::default() };
    let (interfaces, keep) = (interfaces(part.mesh, kind), Keep { count: Some(8), frequency: None });
    let start = ProcessTime::now();
    let reduction = Reduction::craig_bampton(part, &interfaces, &keep, &settings).expect("a plate");
    let reduced = start.elapsed().as_secs_f64();
    let stress = reduce::stress(part, &reduction, threads);
    let stressed = start.elapsed().as_secs_f64();
    let shortenings = reduce::shortenings(part, &reduction, 0, threads);
    let done = start.elapsed().as_secs_f64();
    println!(
        "{{\"kind\": \"{kind:?}\", \"unknowns\": {}, \"threads\": {threads}, \"columns\": {}, \"reduce\": {reduced:.3}, \
         \"stress\": {:.3}, \"shortenings\": {:.3}, \"total\": {done:.3}, \"frequencies\": {:.2?}, \"rigid\": {:.1e}, \
         \"mode_residual\": {:.1e}}}",
        3 * part.mesh.nodes.len(),
        stress.len(),
        stressed - reduced,
        done - stressed,
        reduction.frequencies,
        reduction.checks.rigid,
        reduction.checks.mode_residual,
    );
    assert_eq!(shortenings.len(), 6);
}
