//! Forward dynamics on every machine of `models/`: the drive efforts of a known motion, put on with nothing driven, give
//! the motion back. (The whole assist manipulator is left out: its latches are expressions, answered by a run alone.)

use bellcrank_model::Model;
use bellcrank_multibody::{
    Actuation, Advance, Coordinate, Dynamics, Engine, Force, JointId, Reading, Readings, Seeded, Surroundings, Value,
    engine_for,
};
use bellcrank_results::SpaceKind;

use crate::support::{model_of, root};

/// How long each motion takes, s. Efforts without feedback do not hold a machine where it falls over: long motions would
/// test how errors grow there.
const TIME: f64 = 0.2;

/// A machine, the coordinates that are moved, how far (SI), and those whose efforts move them.
struct Ride {
    file: &'static str,
    moved: &'static [(&'static str, usize, f64)],
    pushed: &'static [&'static str],
}

const RIDES: [Ride; 12] = [
    one("assist-manipulator/lift", &[("slide", 0, -0.05)], &["slide"]),
    one("bennett/bennett", &[("q1", 0, 1.5)], &["q1"]),
    one("four-bar/four-bar", &[("crank", 0, 6.0)], &["crank"]),
    one("four-bar-spatial/four-bar-spatial", &[("crank", 0, 6.0)], &["crank"]),
    one("jansen/jansen", &[("crank", 0, 6.0)], &["crank"]),
    one("lamp/lamp", &[("hinge", 0, 0.6)], &["hinge"]),
    one("peaucellier/peaucellier", &[("crank", 0, 1.2)], &["crank"]),
    one("slider-crank/slider-crank", &[("crank", 0, 6.0)], &["crank"]),
    one("stephenson/stephenson", &[("O2", 0, 6.0)], &["O2"]),
    one("toggle-press/toggle-press", &[("ram", 0, -0.004)], &["ram"]),
    one("robot-arm/robot-arm", &ARM, &["axis1", "axis2", "axis3", "axis4", "axis5", "axis6"]),
    one("stewart/stewart", &POSE, &["leg1", "leg2", "leg3", "leg4", "leg5", "leg6"]),
];
const ARM: [(&str, usize, f64); 6] = [
    ("axis1", 0, 1.2),
    ("axis2", 0, -0.5),
    ("axis3", 0, 0.7),
    ("axis4", 0, -0.9),
    ("axis5", 0, 0.6),
    ("axis6", 0, 2.0),
];
const POSE: [(&str, usize, f64); 6] =
    [("pose", 0, 0.06), ("pose", 1, -0.04), ("pose", 2, 0.05), ("pose", 3, 0.1), ("pose", 4, -0.08), ("pose", 5, 0.15)];

const fn one(
    file: &'static str,
    moved: &'static [(&'static str, usize, f64)],
    pushed: &'static [&'static str],
) -> Ride {
    Ride { file, moved, pushed }
}

/// The known motion, from rest to rest, and the efforts that it takes.
struct Known {
    engine: Box<dyn Engine>,
    from: Vec<f64>,
    by: Vec<f64>,
}

impl Known {
    /// Positions, velocities and accelerations of the moved coordinates: polynomials of the fifth degree.
    fn motion(&self, time: f64) -> [Vec<f64>; 3] {
        let u = (time / TIME).clamp(0.0, 1.0);
        let way = u.powi(3) * (10.0 - 15.0 * u + 6.0 * u * u);
        let speed = 30.0 * (u * (1.0 - u)).powi(2) / TIME;
        let rise = 60.0 * u * (1.0 - u) * (1.0 - 2.0 * u) / (TIME * TIME);
        let of = |share: f64| self.by.iter().map(|by| by * share).collect::<Vec<f64>>();
        [self.from.iter().zip(&self.by).map(|(from, by)| from + by * way).collect(), of(speed), of(rise)]
    }

    fn solve(&mut self, time: f64) {
        let [position, velocity, acceleration] = self.motion(time);
        self.engine.move_to(time, &position).expect("the motion stays within reach");
        self.engine.set_rates(&velocity, &acceleration).expect("rates");
        self.engine.solve_forces(&mut |_, _| {}).expect("forces");
    }
}

impl Surroundings for Known {
    fn inputs(&mut self, at: &dyn Readings<f64>, values: &mut [f64]) {
        self.solve(at.time());
        values.iter_mut().enumerate().for_each(|(k, value)| *value = self.engine.drive(k));
    }
    fn exact_inputs(&mut self, at: &dyn Readings<Seeded>, values: &mut [Seeded]) {
        self.solve(at.time().re);
        values.iter_mut().enumerate().for_each(|(k, value)| *value = Seeded::from_re(self.engine.drive(k)));
    }
    fn drives(&mut self, _: f64, _: &mut [Reading]) {}
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

fn coordinate(model: &Model, joint: &str, index: usize) -> Coordinate {
    let place = model.joints().iter().position(|name| *name == joint);
    Coordinate { joint: JointId(place.unwrap_or_else(|| panic!("there is no joint {joint}"))), index }
}

/// Largest difference of a moved coordinate from where it was meant to be, over its way.
fn off_course(ride: &Ride) -> f64 {
    let model = model_of(&root().join(format!("models/{}.toml", ride.file)));
    let moved: Vec<Coordinate> = ride.moved.iter().map(|(joint, index, _)| coordinate(&model, joint, *index)).collect();
    let pushed: Vec<Coordinate> = ride.pushed.iter().map(|joint| coordinate(&model, joint, 0)).collect();
    let mut engine = model.engine().expect("builds");
    engine.assemble(&[]).expect("assembles");
    let actuation = Actuation { position: moved.clone(), rate: moved.clone(), effort: pushed.clone() };
    engine.prepare(&actuation).expect("the drives take every freedom");
    let from: Vec<f64> = moved.iter().map(|c| engine.coordinate(*c).position).collect();
    let mut known = Known { engine, from, by: ride.moved.iter().map(|(_, _, by)| *by).collect() };

    let mut blueprint = model.blueprint().clone();
    assert_eq!(blueprint.inputs, 0, "{}: expressions would have to be answered here, too", ride.file);
    blueprint.inputs = pushed.len();
    let efforts = pushed.iter().enumerate();
    blueprint.forces.extend(efforts.map(|(k, &coordinate)| Force::Effort { coordinate, value: Value::Input(k) }));
    let mut machine = engine_for(model.space() == SpaceKind::Planar, &blueprint).expect("builds");
    let hold: Vec<(Coordinate, f64)> = moved.iter().copied().zip(known.from.iter().copied()).collect();
    machine.assemble(&hold).expect("assembles");
    machine.begin(&Dynamics { tolerance: 1e-11, ..Dynamics::free() }, &mut known).expect("begins");
    let mut off = 0.0_f64;
    for tenth in 1..=10 {
        let time = TIME * f64::from(tenth) / 10.0;
        while machine.advance(time, &mut known).expect("goes on") != Advance::Reached {}
        let [meant, _, _] = known.motion(time);
        for ((c, meant), by) in moved.iter().zip(&meant).zip(&known.by) {
            off = off.max((machine.coordinate(*c).position - meant).abs() / by.abs());
        }
    }
    off
}

#[test]
fn the_drive_efforts_of_every_machine_give_its_motion_back() {
    let off: Vec<(&str, f64)> = RIDES.iter().map(|ride| (ride.file, off_course(ride))).collect();
    assert!(off.iter().all(|(_, off)| *off < 1e-6), "off course, as a part of the way: {off:?}");
}
