//! CPU seconds of runs in time, as JSON: the figures that stand beside the peers'.
//!
//! Process CPU time on one thread, least and median of several runs. `dynamics_cpu andrews` and the like run one part
//! over and over, for a profiler.
#![expect(unreachable_pub, reason = "modules shared with the tests")]

#[path = "../tests/it/arm.rs"]
mod arm;
#[path = "../tests/it/build.rs"]
mod build;
#[path = "../tests/it/machines.rs"]
#[expect(dead_code, reason = "the tests use more of it")]
mod machines;
#[path = "shared/runs.rs"]
mod runs;

use bellcrank_multibody::{SolverEffort, engine_for};
use cpu_time::ProcessTime;

fn main() {
    let parts: Vec<String> = std::env::args().skip(1).filter(|a| !a.starts_with('-')).collect();
    let wanted = |name: &str| parts.is_empty() || parts.iter().any(|p| p == name);
    if parts.iter().any(|p| p == "print") {
        return print();
    }
    let mut fields = Vec::new();
    if wanted("arm") {
        fields.push(arm());
    }
    if wanted("andrews") {
        fields.push(andrews());
    }
    if wanted("lift") {
        fields.push(lift());
    }
    if wanted("chains") {
        fields.push(chains());
    }
    println!("{{{}}}", fields.join(", "));
}

/// Least and median milliseconds of so many runs.
fn times(runs: usize, mut run: impl FnMut()) -> [f64; 2] {
    let mut ms: Vec<f64> = (0..runs)
        .map(|_| {
            let start = ProcessTime::now();
            run();
            start.elapsed().as_secs_f64() * 1e3
        })
        .collect();
    ms.sort_by(f64::total_cmp);
    [ms[0], ms[runs / 2]]
}

/// Microseconds a call, the arm's states in turn.
fn calls(mut call: impl FnMut(usize)) -> String {
    const CALLS: usize = 20_000;
    let [least, median] = times(31, || (0..CALLS).for_each(|i| call(i % arm::STATES)));
    format!("[{:.5}, {:.5}]", least * 1e3 / CALLS as f64, median * 1e3 / CALLS as f64)
}

fn arm() -> String {
    let (mut e, states) = (arm::machine(), arm::states());
    let (mut tau, mut m, mut sum) = ([0.0; arm::AXES], [0.0; arm::AXES * arm::AXES], 0.0);
    let inverse = calls(|i| {
        let [q, v, a] = &states[i];
        e.inverse_dynamics(q, v, a, &mut tau);
        sum += tau[0];
    });
    let mass = calls(|i| {
        e.mass_matrix(&states[i][0], &mut m);
        sum += m[0];
    });
    assert!(f64::is_finite(sum));
    format!("\"rnea_us\": {inverse}, \"crba_us\": {mass}")
}

/// Torques and lower triangles of the mass matrix of the arm's first states.
fn print() {
    let mut e = arm::machine();
    let (mut tau, mut m) = ([0.0; arm::AXES], [0.0; arm::AXES * arm::AXES]);
    for [q, v, a] in &arm::states()[..16] {
        e.inverse_dynamics(q, v, a, &mut tau);
        e.mass_matrix(q, &mut m);
        tau.iter().for_each(|t| print!("{t:.17e} "));
        (0..arm::AXES).for_each(|i| (0..=i).for_each(|j| print!("{:.17e} ", m[i * arm::AXES + j])));
        println!();
    }
}

fn andrews() -> String {
    let mut e = engine_for(true, &machines::andrews()).expect("builds");
    let mut parts = Vec::new();
    for tolerance in [1e-4, 1e-5, 1e-6, 1e-7, 1e-8] {
        let mut last = runs::squeeze(&mut *e, tolerance);
        let [least, median] = times(41, || last = runs::squeeze(&mut *e, tolerance));
        let (error, effort) = last;
        parts.push(format!(
            "{{\"tolerance\": {tolerance:e}, \"ms\": [{least:.3}, {median:.3}], \"error\": {error:.2e}, \"steps\": {}, \
             \"rejected\": {}, \"evaluations\": {}, \"projections\": {}}}",
            effort.steps, effort.rejected, effort.evaluations, effort.projections
        ));
    }
    format!("\"andrews\": [{}]", parts.join(", "))
}

fn lift() -> String {
    let mut e = engine_for(true, &machines::lift_blueprint(runs::MASSES)).expect("builds");
    let (mut parts, mut forces) = (Vec::new(), Vec::new());
    for rows in [2, 601, 7998] {
        let mut effort = runs::lift_stroke(&mut *e, 1e-6, rows, &mut forces);
        let [least, median] = times(21, || effort = runs::lift_stroke(&mut *e, 1e-6, rows, &mut forces));
        let known = runs::lift_forces(rows);
        let error = forces.iter().zip(&known).fold(0.0_f64, |m, (a, b)| m.max((a - b).abs()));
        parts.push(format!(
            "{{\"rows\": {rows}, \"ms\": [{least:.3}, {median:.3}], \"force_error_N\": {error:.2e}, \"steps\": {}, \
             \"evaluations\": {}}}",
            effort.steps, effort.evaluations
        ));
    }
    format!("\"lift\": [{}]", parts.join(", "))
}

/// One second of the fall of N four-bars, without the beginning.
fn chains() -> String {
    let mut parts = Vec::new();
    for n in [1, 3, 10, 30, 100, 300, 1000] {
        let mut e = engine_for(true, &machines::chain(n)).expect("builds");
        let (mut ms, mut begin, mut effort) = (Vec::new(), f64::INFINITY, SolverEffort::default());
        for _ in 0..5 {
            let start = ProcessTime::now();
            runs::let_go(&mut *e, 1e-6);
            begin = begin.min(start.elapsed().as_secs_f64() * 1e3);
            let start = ProcessTime::now();
            effort = runs::fall(&mut *e, 1.0);
            ms.push(start.elapsed().as_secs_f64() * 1e3);
        }
        ms.sort_by(f64::total_cmp);
        parts.push(format!(
            "{{\"loops\": {n}, \"ms\": [{:.3}, {:.3}], \"begin_ms\": {begin:.3}, \"evaluations\": {}, \
             \"us_evaluation_loop\": {:.4}}}",
            ms[0],
            ms[2],
            effort.evaluations,
            ms[0] * 1e3 / (effort.evaluations * n) as f64
        ));
    }
    format!("\"chains\": [{}]", parts.join(", "))
}
