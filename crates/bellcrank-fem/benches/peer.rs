//! A part from a deck of another program (`.inp`: nodes, C3D10, sets, BOUNDARY on FIX, CLOAD), solved and timed in
//! process CPU seconds, as JSON.
//!
//! `cargo bench -p bellcrank-fem --bench peer -- DECK static|modes [THREADS]`; without arguments it does nothing.

use bellcrank_fem::{Free, Load, Material, Modes, Part, Settings, Statics, Support, stress, von_mises};
use bellcrank_mesh::Mesh;
use cpu_time::ProcessTime;

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).filter(|argument| !argument.starts_with("--")).collect();
    let [deck, what, rest @ ..] = &arguments[..] else { return };
    let threads = rest.first().and_then(|threads| threads.parse().ok()).unwrap_or(1);
    let text = std::fs::read(deck).expect("the deck is read");
    let start = ProcessTime::now();
    let mesh = bellcrank_mesh::read_inp(&text).expect("a deck").mesh;
    let read = start.elapsed().as_secs_f64();
    let part = Part {
        mesh: &mesh,
        materials: vec![Material::isotropic(2.1e11, 0.3, 7850.0).expect("steel"); mesh.blocks.len()],
        supports: vec![Support::clamped(mesh.node_sets["FIX"].clone())],
        couplings: Vec::new(),
    };
    let settings = Settings { threads, ..Settings::default() };
    let head = format!("\"dof\": {}, \"threads\": {threads}, \"read\": {read:.4}", 3 * mesh.nodes.len());
    match what.as_str() {
        "static" => println!("{{{head}, {}}}", statics(&part, &settings, &loads(&mesh, &text))),
        _ => println!("{{{head}, {}}}", modes(&part, &settings)),
    }
}

/// The forces of the deck's CLOAD card, node by node; labels count from one.
fn loads(mesh: &Mesh, text: &[u8]) -> Vec<Load> {
    let text = String::from_utf8_lossy(text);
    let after = text.split("*CLOAD").nth(1).unwrap_or_default();
    let mut loads = Vec::new();
    for line in after.lines().skip(1).take_while(|line| !line.starts_with('*')) {
        let fields: Vec<&str> = line.split(',').collect();
        let (Ok(label), Ok(axis), Ok(value)) =
            (fields[0].parse::<u32>(), fields[1].parse::<usize>(), fields[2].parse())
        else {
            continue;
        };
        assert!((label as usize) <= mesh.nodes.len());
        let force = std::array::from_fn(|i| if i + 1 == axis { value } else { 0.0 });
        loads.push(Load::Nodal { nodes: vec![label - 1], force });
    }
    loads
}

fn statics(part: &Part<'_>, settings: &Settings<'_>, loads: &[Load]) -> String {
    let start = ProcessTime::now();
    let statics = Statics::new(part, Free::Refused, settings).expect("held");
    let factored = start.elapsed().as_secs_f64();
    let solution = statics.solve(loads).expect("loads");
    let solved = start.elapsed().as_secs_f64();
    let mut equivalent: Vec<f64> = stress::at_points(part, &solution).iter().map(von_mises).collect();
    let done = start.elapsed().as_secs_f64();
    equivalent.sort_unstable_by(f64::total_cmp);
    let largest = solution.displacement.iter().map(|u| u.iter().map(|u| u * u).sum::<f64>().sqrt()).fold(0.0, f64::max);
    let percentile = equivalent[(0.99 * (equivalent.len() - 1) as f64) as usize];
    format!(
        "\"assemble_and_factor\": {factored:.4}, \"solve\": {:.4}, \"stress\": {:.4}, \"total\": {done:.4}, \"umax_mm\": {:.8}, \
         \"vm_ip_MPa\": {:.6}, \"vm_ip_p99_MPa\": {:.6}, \"factor_entries\": {}, \"residual\": {:e}, \"peak_MB\": {}",
        solved - factored,
        done - solved,
        1e3 * largest,
        equivalent.last().copied().unwrap_or(0.0) / 1e6,
        percentile / 1e6,
        statics.effort.factor_entries,
        solution.residual,
        peak_memory(),
    )
}

fn modes(part: &Part<'_>, settings: &Settings<'_>) -> String {
    let start = ProcessTime::now();
    let modes = Modes::lowest(part, 10, settings).expect("modes");
    let total = start.elapsed().as_secs_f64();
    let list: Vec<String> = modes.frequencies.iter().map(|f| format!("{f:.6}")).collect();
    let (list, residual) = (list.join(", "), modes.residual);
    format!("\"total\": {total:.4}, \"freq_Hz\": [{list}], \"residual\": {residual:e}, \"peak_MB\": {}", peak_memory())
}

/// Largest resident set of this process in MB, where the system tells.
fn peak_memory() -> u64 {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    let line = status.lines().find(|line| line.starts_with("VmHWM")).unwrap_or_default();
    line.split_whitespace().nth(1).and_then(|kilobytes| kilobytes.parse::<u64>().ok()).unwrap_or(0) / 1024
}
