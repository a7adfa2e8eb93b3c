//! CPU seconds a position of the lift, as JSON: the figure that stands beside the peers'.
//!
//! Position, velocity, acceleration, drive force and every reaction at 601 positions, −30° to 30°, median of
//! several passes on one thread.
#![expect(unreachable_pub, reason = "modules shared with the tests")]

#[path = "../tests/it/build.rs"]
mod build;
#[path = "../tests/it/machines.rs"]
#[expect(dead_code, reason = "the tests use more of it")]
mod machines;

use bellcrank_multibody::{Actuation, Engine, engine_for};
use build::coordinate;
use cpu_time::ProcessTime;

const POSITIONS: usize = 601;
const PASSES: usize = 40;
const REPEATS: usize = 11;

fn main() {
    let planar = median(true);
    let spatial = median(false);
    println!("{{\"planar_us\": {:.4}, \"spatial_us\": {:.4}}}", planar * 1e6, spatial * 1e6);
}

/// Seconds a position.
fn median(planar: bool) -> f64 {
    let mut e = engine_for(planar, &machines::lift_blueprint([19.84, 20.8, 19.4])).expect("builds");
    e.assemble(&[]).expect("assembles");
    let (lever, slide) = (coordinate(2), coordinate(1));
    e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives");
    let angle = |i: usize| (-30.0 + 60.0 * i as f64 / (POSITIONS - 1) as f64).to_radians();
    let mut sum = 0.0;
    let mut one = |e: &mut dyn Engine, i: usize| {
        e.move_to(0.0, &[angle(i)]).expect("moves");
        e.set_rates(&[0.02], &[0.0]).expect("regular");
        e.solve_forces(&mut |_, _| {}).expect("regular");
        sum += e.drive(0);
    };
    let mut times: Vec<f64> = (0..REPEATS)
        .map(|_| {
            let start = ProcessTime::now();
            for _ in 0..PASSES {
                (0..POSITIONS).for_each(|i| one(&mut *e, i));
                (0..POSITIONS).rev().for_each(|i| one(&mut *e, i));
            }
            start.elapsed().as_secs_f64() / (2 * PASSES * POSITIONS) as f64
        })
        .collect();
    assert!(sum.is_finite());
    times.sort_by(f64::total_cmp);
    times[REPEATS / 2]
}
