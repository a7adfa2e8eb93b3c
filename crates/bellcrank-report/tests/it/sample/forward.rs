//! A mass that falls on a hard stop, and how a double pendulum rings.

use bellcrank_results::{
    Ended, Event, EventKind, Events, Findings, ModeRow, Modes, Move, Programme, RunResult, ShapeRow, StudyResult,
    Table, Unit,
};

use super::{column, lift, unit};

fn event(time: f64, kind: EventKind, side: &'static str, numbers: Vec<(&'static str, f64, Unit)>) -> Event {
    Event { time, kind, name: "floor".to_owned(), joint: "slide".to_owned(), side, numbers }
}

/// A slide that is lifted, held and let down, and a spindle that turns on.
fn lifted() -> Programme {
    let one = |segment: &str, profile, [start, end]: [f64; 2], [from, to]: [f64; 2]| Move {
        motion: "lift<up>".to_owned(),
        joint: "lift.slide".to_owned(),
        segment: Some(segment.to_owned()),
        profile,
        start,
        end: Some(end),
        from,
        to: Some(to),
        unit: unit("mm"),
    };
    let spin = Move {
        motion: "spin".to_owned(),
        joint: "spindle".to_owned(),
        segment: None,
        end: None,
        to: None,
        unit: Unit::new("rad", 1.0),
        ..one("", "velocity", [0.2, 0.0], [0.5, 0.0])
    };
    let moves = vec![
        one("up", "poly5", [0.0, 0.2], [0.0, 0.08]),
        spin,
        one("2", "hold", [0.2, 0.3], [0.08, 0.08]),
        one("down", "cycloidal", [0.3, 0.9], [0.08, 0.02]),
    ];
    Programme { time: unit("s"), moves }
}

/// Half of the speed is left by each impact.
fn falling() -> StudyResult {
    let mut events = Events::none(unit("s"));
    for bounce in 0..10 {
        let speed = 2.0 * 0.5_f64.powi(bounce);
        let time = 0.5 - 0.3 * 0.5_f64.powi(bounce);
        let numbers = vec![("speed", speed, unit("mm/s")), ("impulse", 1.5 * speed, Unit::new("N*s", 1.0))];
        events.push(event(time, EventKind::Impact, "lower", numbers));
    }
    events.push(event(0.5, EventKind::Contact, "lower", Vec::new()));
    events.push(Event {
        time: 0.6,
        kind: EventKind::Condition,
        name: "time > 0.6 s".to_owned(),
        joint: String::new(),
        side: "",
        numbers: Vec::new(),
    });
    events.ended = Some(Ended { time: 0.6, by: "time > 0.6 s".to_owned() });
    let times: Vec<f64> = (0..7).map(|row| f64::from(row) / 10.0).collect();
    let heights = times.iter().map(|t| 0.2 - t * t / 5.0).collect();
    StudyResult {
        name: "fall".to_owned(),
        kind: "dynamics".to_owned(),
        axis: vec!["time".to_owned()],
        table: Table { columns: vec![column("time", "s", times), column("joint.slide.position", "mm", heights)] },
        programme: Some(lifted()),
        events: Some(events),
        scalars: vec![("energy.drift".to_owned(), 2.5e-9, unit("J"))],
        effort: vec![("steps".to_owned(), 120.0)],
        ..StudyResult::default()
    }
}

fn shape(amplitudes: [[f64; 2]; 2]) -> Vec<ShapeRow> {
    let row = |(name, amplitude): (&str, [f64; 2])| ShapeRow {
        coordinate: name.to_owned(),
        unit: Unit::new("rad", 1.0),
        amplitude,
    };
    ["hinge", "wrist"].into_iter().zip(amplitudes).map(row).collect()
}

fn ringing() -> StudyResult {
    let mode = |re: f64, im: f64, amplitudes| {
        let size = re.hypot(im);
        ModeRow {
            eigenvalue: [re, im],
            frequency: size / std::f64::consts::TAU,
            damping: if size > 0.0 { -re / size } else { 0.0 },
            shape: shape(amplitudes),
        }
    };
    let modes = vec![
        mode(-0.05, 4.4, [[0.4, 0.0], [1.0, 0.0]]),
        mode(0.0, 9.1, [[1.0, 0.0], [-0.2, 0.3]]),
        mode(-20.0, 0.0, [[0.0, 0.0], [1.0, 0.0]]),
    ];
    StudyResult {
        name: "ring".to_owned(),
        kind: "modes".to_owned(),
        findings: Some(Findings::Modes(Modes { freedom: 2, all: 4, at_equilibrium: true, modes })),
        ..StudyResult::default()
    }
}

pub fn run() -> RunResult {
    let mut run = lift::run();
    run.studies = vec![falling(), ringing()];
    run
}
