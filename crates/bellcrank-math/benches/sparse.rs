//! Factorization, solution and lowest modes of clamped bricks: `cargo bench -p bellcrank-math --bench sparse -- [name]…`.
//! CPU seconds by one thread, CPU and wall seconds by two.

mod shared {
    pub(crate) mod brick;
    pub(crate) mod tets;
}

use std::sync::Arc;
use std::time::Instant;

use bellcrank_math::linalg::sparse::{Cholesky, Eigenproblem, Plan, SymmetricMatrix};
use cpu_time::ProcessTime;
use shared::brick::brick;
use shared::tets::tets;

/// Bricks of eight-node elements.
const BRICKS: [(&str, [usize; 3]); 5] = [
    ("plate-30k", [60, 40, 3]),
    ("plate-100k", [128, 64, 3]),
    ("plate-300k", [222, 112, 3]),
    ("cube-50k", [24, 24, 24]),
    ("cube-100k", [31, 31, 31]),
];

/// Plates of ten-node tetrahedra.
const TETS: [(&str, [usize; 3]); 3] =
    [("tets-100k", [48, 24, 3]), ("tets-170k", [64, 31, 3]), ("tets-300k", [87, 40, 3])];

fn go_on(_: f64) -> bool {
    true
}

/// CPU and wall seconds.
fn timed<T>(work: impl FnOnce() -> T) -> (T, f64, f64) {
    let (cpu, wall) = (ProcessTime::now(), Instant::now());
    let value = work();
    (value, cpu.elapsed().as_secs_f64(), wall.elapsed().as_secs_f64())
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with("--")).collect();
    let asked = |name: &str| arguments.is_empty() || arguments.iter().any(|a| name.starts_with(a.as_str()));
    for (name, cells) in TETS.into_iter().filter(|(name, _)| asked(name)) {
        direct(name, &tets(cells));
    }
    for (name, cells) in BRICKS.into_iter().filter(|(name, _)| asked(name)) {
        let brick = brick(cells, 0.005, true);
        let plan = direct(name, &brick.stiffness);
        modes(&plan, &brick.stiffness, &brick.mass);
    }
}

fn direct(name: &str, matrix: &SymmetricMatrix) -> Arc<Plan> {
    let (plan, plan_cpu, _) = timed(|| Arc::new(Plan::new(matrix)));
    println!(
        "{name}: n {}, {:.2} M entries, {:.1} M of L in {} supernodes, {:.1} G products, {:.0} MiB; plan {plan_cpu:.2} CPU-s",
        matrix.size,
        matrix.rows.len() as f64 / 1e6,
        plan.factor_entries() as f64 / 1e6,
        plan.supernodes(),
        plan.flops() / 1e9,
        plan.memory() as f64 / 1_048_576.0,
    );
    for threads in [1, 2] {
        let (factor, cpu, wall) = timed(|| Cholesky::factor(plan.clone(), matrix, threads, &go_on).expect("positive"));
        let rate = plan.flops() / 1e9 / cpu;
        println!("  {threads} thread(s): factor {cpu:.2} CPU-s, {wall:.2} s wall, {rate:.1} G/CPU-s");
        [1, 8].into_iter().for_each(|count| solve(&factor, matrix, count));
    }
    plan
}

fn solve(factor: &Cholesky, matrix: &SymmetricMatrix, count: usize) {
    let b: Vec<f64> = (0..matrix.size * count).map(|i| ((i * 7919) % 1009) as f64 - 504.0).collect();
    let mut x = b.clone();
    let ((), cpu, _) = timed(|| factor.solve(&mut x));
    let mut product = vec![0.0; b.len()];
    matrix.multiply(&x, &mut product);
    let worst = product.iter().zip(&b).fold(0.0_f64, |most, (p, b)| most.max((p - b).abs())) / 504.0;
    println!("    solve of {count}: {cpu:.3} CPU-s, residual {worst:.1e}");
}

fn modes(plan: &Arc<Plan>, stiffness: &SymmetricMatrix, mass: &SymmetricMatrix) {
    let problem = Eigenproblem { stiffness, mass };
    let factor = Cholesky::factor(plan.clone(), stiffness, 1, &go_on).expect("positive");
    let (pairs, cpu, _) = timed(|| problem.lowest_with(&factor, 0.0, 10, &go_on).expect("eigenpairs"));
    let hertz: Vec<String> = pairs.values.iter().map(|v| format!("{:.1}", v.sqrt() / std::f64::consts::TAU)).collect();
    let worst = pairs.residuals.iter().fold(0.0_f64, |most, r| most.max(*r));
    println!("  10 modes: {cpu:.2} CPU-s after the factorization, {} solves, residual {worst:.1e}", pairs.solves);
    println!("    Hz: {}", hertz.join(" "));
}
