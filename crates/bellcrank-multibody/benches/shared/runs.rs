//! Runs in time that the benches share.

use crate::build::coordinate;
use crate::machines;
use bellcrank_multibody::{
    Advance, Dynamics, Engine, Reading, Readings, Seeded, SolverEffort, Surroundings, engine_for,
};

/// No inputs, no switches; what is driven moves at a constant speed from where it starts.
pub struct Steady {
    pub start: f64,
    pub speed: f64,
}

impl Surroundings for Steady {
    fn inputs(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, time: f64, motion: &mut [Reading]) {
        for m in motion {
            *m = Reading { position: self.start + self.speed * time, velocity: self.speed, acceleration: 0.0 };
        }
    }
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// On to a time.
pub fn run_to(e: &mut dyn Engine, time: f64, around: &mut dyn Surroundings) {
    while e.advance(time, around).expect("goes on") == Advance::Working {}
}

/// Where Andrews' crank is at 0.03 s (quad precision, two models).
pub const ANDREWS: f64 = 15.810_771_195_353_707;

/// Andrews' squeezer to 0.03 s: error of the crank's angle, rad, and the work.
pub fn squeeze(e: &mut dyn Engine, tolerance: f64) -> (f64, SolverEffort) {
    let mut around = AT_REST;
    e.assemble(&[(coordinate(0), -0.061_713_890_014_276_5)]).expect("assembles");
    e.begin(&Dynamics { tolerance, breaks: vec![0.03], ..Dynamics::free() }, &mut around).expect("begins");
    run_to(e, 0.03, &mut around);
    (e.coordinate(coordinate(0)).position - ANDREWS, e.solver_effort())
}

/// The lift's masses as the peers have them, kg.
pub const MASSES: [f64; 3] = [19.73, 20.8, 19.4];

/// The lift's stroke: barrel length at −30° and 30° of the lever, m, and its time at 20 mm/s, s.
pub fn stroke() -> (f64, f64) {
    let length = |degrees: f64| {
        let (s, c) = degrees.to_radians().sin_cos();
        (0.732 * c + 0.16 * s).hypot(0.16 + 0.732 * s - 0.16 * c)
    };
    (length(-30.0), (length(30.0) - length(-30.0)) / 0.02)
}

/// The lift driven through its stroke with so many rows: forces of the slide, N, and the work.
pub fn lift_stroke(e: &mut dyn Engine, tolerance: f64, rows: usize, forces: &mut Vec<f64>) -> SolverEffort {
    let (start, time) = stroke();
    let mut around = Steady { start, speed: 0.02 };
    forces.clear();
    e.assemble(&[(coordinate(1), start), (coordinate(2), -30.0_f64.to_radians())]).expect("assembles");
    let dynamics = Dynamics { driven: vec![coordinate(1)], tolerance, breaks: vec![time], ..Dynamics::free() };
    e.begin(&dynamics, &mut around).expect("begins");
    for i in 0..rows {
        run_to(e, time * i as f64 / (rows - 1) as f64, &mut around);
        forces.push(e.drive(0));
    }
    e.solver_effort()
}

/// The same forces by inverse dynamics.
pub fn lift_forces(rows: usize) -> Vec<f64> {
    let (start, time) = stroke();
    let mut e = engine_for(true, &machines::lift_blueprint(MASSES)).expect("builds");
    let slide = vec![coordinate(1)];
    e.assemble(&[(coordinate(1), start)]).expect("assembles");
    let all = bellcrank_multibody::Actuation { position: slide.clone(), rate: slide.clone(), effort: slide };
    e.prepare(&all).expect("drives");
    (0..rows)
        .map(|i| {
            let t = time * i as f64 / (rows - 1) as f64;
            e.move_to(t, &[start + 0.02 * t]).expect("moves");
            e.set_rates(&[0.02], &[0.0]).expect("regular");
            e.solve_forces(&mut |_, _| {}).expect("regular");
            e.drive(0)
        })
        .collect()
}

/// N four-bars at 1.3 rad, let go: [`fall`] goes on from here.
pub fn let_go(e: &mut dyn Engine, tolerance: f64) {
    e.assemble(&[]).expect("assembles");
    e.begin(&Dynamics { tolerance, ..Dynamics::free() }, &mut { AT_REST }).expect("begins");
}

/// Nothing is driven.
const AT_REST: Steady = Steady { start: 0.0, speed: 0.0 };

/// The chain's fall to a time: the work.
pub fn fall(e: &mut dyn Engine, time: f64) -> SolverEffort {
    run_to(e, time, &mut { AT_REST });
    e.solver_effort()
}
