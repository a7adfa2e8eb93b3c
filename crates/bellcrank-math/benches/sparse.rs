//! Factorization, solution and lowest modes of clamped bricks: `cargo bench -p bellcrank-math --bench sparse -- [name]`.
//! CPU seconds by one thread, wall seconds by two.

mod shared {
    pub(crate) mod brick;
}

use std::sync::Arc;
use std::time::Instant;

use bellcrank_math::linalg::sparse::{Cholesky, Plan, SymmetricMatrix};
use cpu_time::ProcessTime;
use shared::brick::brick;

const CASES: [(&str, [usize; 3]); 5] = [
    ("plate-30k", [60, 40, 3]),
    ("plate-100k", [128, 64, 3]),
    ("plate-300k", [222, 112, 3]),
    ("cube-50k", [24, 24, 24]),
    ("cube-100k", [31, 31, 31]),
];

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
    for (name, cells) in CASES {
        if arguments.iter().all(|a| name.starts_with(a.as_str())) {
            let brick = brick(cells, 0.005, true);
            println!("{name}: {} entries of K, {} of M", brick.stiffness.rows.len(), brick.mass.rows.len());
            direct(name, &brick.stiffness);
        }
    }
}

fn direct(name: &str, matrix: &SymmetricMatrix) {
    let (plan, plan_cpu, _) = timed(|| Arc::new(Plan::new(matrix)));
    println!(
        "{name}: n {}, entries of L {:.1} M in {} supernodes, {:.1} Gflop, {:.0} MiB; plan {plan_cpu:.2} CPU-s",
        matrix.size,
        plan.factor_entries() as f64 / 1e6,
        plan.supernodes(),
        plan.flops() / 1e9,
        plan.memory() as f64 / 1048576.0,
    );
    for threads in [1, 2] {
        let (factor, cpu, wall) = timed(|| Cholesky::factor(plan.clone(), matrix, threads, &go_on).expect("positive"));
        println!(
            "  {threads} thread(s): factor {cpu:.2} CPU-s, {wall:.2} s wall, {:.1} Gflop/CPU-s",
            plan.flops() / 1e9 / cpu
        );
        for count in [1, 8] {
            solve(&factor, matrix, count);
        }
    }
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
