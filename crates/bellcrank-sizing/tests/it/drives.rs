//! Electric drives against duties.

use bellcrank_sizing::electric::{Conditions, Drive, DriveCandidate, Gear, Kind, evaluate, select};
use bellcrank_sizing::{Candidate, Check, Duty, Row, SizingError, Stroke, Subject, Verdict};

use crate::near;

/// Accelerate, run, brake: 0.1 s, 0.3 s, 0.1 s; 4 rad/s; a load of 2 kg·m² and 10 N·m.
fn turntable() -> Duty {
    let row = |time: f64, position: f64, velocity: f64, acceleration: f64| {
        let effort = 10.0 + 2.0 * acceleration;
        Row { position, effort, velocity, acceleration, time: Some(time) }
    };
    let rows = vec![
        row(0.0, 0.0, 0.0, 40.0),
        row(0.1, 0.2, 4.0, 40.0),
        row(0.1, 0.2, 4.0, 0.0),
        row(0.4, 1.4, 4.0, 0.0),
        row(0.4, 1.4, 4.0, -40.0),
        row(0.5, 1.6, 0.0, -40.0),
    ];
    Duty::new(rows).unwrap()
}

fn motor() -> Drive {
    let plain = Drive::bare(Kind::Rotary, 2.39, 7.17, 523.6);
    let gear = Some(Gear { ratio: 50.0, efficiency: 0.9 });
    Drive { name: "m".into(), rated_power: Some(750.0), knee_speed: Some(314.16), gear, inertia: Some(1.6e-4), ..plain }
}

#[track_caller]
fn check(candidate: &DriveCandidate, subject: Subject) -> Check {
    candidate.checks.iter().find(|check| check.subject == subject).unwrap().clone()
}

/// By hand at the shaft: 90/50/0.9 + 1.6e-4·2000 = 2.32 N·m, 10/50/0.9 = 0.2222, −70/50·0.9 − 0.32 = −1.58 N·m.
#[test]
fn efforts_at_the_motor_shaft() {
    let candidate = evaluate(&turntable(), &motor(), &Conditions::new(1.0)).unwrap();
    let at = candidate.at_shaft;
    near(at.push.value, 2.32, 1e-12);
    // At rest the gear's loss counts against the motor: −70/50/0.9 − 0.32.
    near(at.pull.value, 70.0 / 50.0 / 0.9 + 0.32, 1e-12);
    near(at.speed.value, 200.0, 1e-14);
    near(check(&candidate, Subject::PeakEffort).needed, 2.32, 1e-12);
    assert!(candidate.passes());
}

/// Without losses: power is the same on both sides of a gear, and what the inertia takes it gives back.
#[test]
fn an_ideal_gear_keeps_the_power() {
    let ideal = Drive { gear: Some(Gear { ratio: 37.0, efficiency: 1.0 }), inertia: None, ..motor() };
    let shaft = ideal.shaft_duty(&turntable()).unwrap();
    for (a, b) in shaft.rows().iter().zip(turntable().rows()) {
        near(a.effort * a.velocity, b.effort * b.velocity, 1e-13);
    }
    let heavy = Drive { inertia: Some(3e-3), ..ideal };
    let net = |drive: &Drive| evaluate(&turntable(), drive, &Conditions::new(1.0)).unwrap().at_shaft.net_power.unwrap();
    near(net(&heavy), net(&Drive { inertia: None, ..heavy.clone() }), 1e-12);
}

#[test]
fn rest_in_the_cycle_cools_the_motor() {
    let busy = evaluate(&turntable(), &motor(), &Conditions::new(1.0)).unwrap();
    let rested = Conditions { cycle_time: Some(2.0), ..Conditions::new(1.0) };
    let rested = evaluate(&turntable(), &motor(), &rested).unwrap();
    near(rested.rms_effort, busy.rms_effort / 2.0, 1e-13);
    near(check(&rested, Subject::RatedPower).needed, check(&busy, Subject::RatedPower).needed / 4.0, 1e-13);
}

#[test]
fn peak_effort_falls_beyond_the_knee() {
    let drive = Drive { knee_speed: Some(300.0), ..Drive::bare(Kind::Rotary, 2.0, 6.0, 500.0) };
    let at = |speed| drive.effort_at(speed);
    assert_eq!([at(0.0), at(300.0), at(-400.0), at(500.0), at(900.0)], [6.0, 6.0, 4.0, 2.0, 2.0]);
    assert_eq!(Drive { knee_speed: None, ..drive.clone() }.effort_at(500.0), 6.0);
    assert_eq!(Drive { knee_speed: Some(700.0), ..drive.clone() }.effort_at(500.0), 6.0);
    // The row that is worst is the fast one, not the strong one.
    let row = |effort, velocity| Row { position: 0.0, effort, velocity, acceleration: 0.0, time: None };
    let duty = Duty::new(vec![row(5.0, 0.0), row(4.5, 400.0)]).unwrap();
    let peak = check(&evaluate(&duty, &drive, &Conditions::new(1.0)).unwrap(), Subject::PeakEffort);
    assert_eq!(peak.reason, "peak 4 N·m at 3820 rpm, needed 4.5 N·m");
    assert_eq!(peak.verdict, Verdict::Fails);
}

fn lift() -> Duty {
    let row = |position, effort| Row { position, effort, velocity: 0.02, acceleration: 0.0, time: None };
    Duty::new(vec![row(-0.08, 4844.52), row(0.08, 4680.3)]).unwrap()
}

fn actuator(force: f64) -> Drive {
    let strokes = vec![0.1, 0.2];
    let plain = Drive::bare(Kind::Linear, force, 2.0 * force, 0.25);
    Drive { name: format!("{force}"), strokes, rated_power: Some(force * 0.25), ..plain }
}

#[test]
fn the_smallest_actuator_that_holds_the_lift() {
    let drives = [actuator(6300.0), actuator(4000.0), actuator(10000.0), motor()];
    let found = select(&lift(), Kind::Linear, &drives, &Conditions::new(1.0)).unwrap();
    let order: Vec<&str> = found.candidates.iter().map(Candidate::name).collect();
    assert_eq!(order, ["6300", "10000", "4000"]);
    assert_eq!(found.chosen().unwrap().stroke, Some(Stroke::Standard(0.2)));
    let reasons: Vec<&str> = found.candidates[2].checks.iter().map(|check| check.reason.as_str()).collect();
    assert_eq!(
        reasons,
        [
            "rated 4000 N, root mean square 4763 N",
            "peak 8000 N at 20 mm/s, needed 4845 N",
            "speed limit 250 mm/s, needed 20 mm/s",
            "rated power 1000 W, mean 95.25 W",
            "not checked: the catalogue gives no peak power; peak effort and speed limit it",
            "standard stroke 200 mm, needed 160 mm",
        ]
    );
}

#[test]
fn safety_raises_what_is_needed() {
    let found = select(&lift(), Kind::Linear, &[actuator(6300.0)], &Conditions::new(1.5)).unwrap();
    let said = "none passes; `6300` comes nearest: rated 6300 N, root mean square 7144 N with safety 1.5";
    assert_eq!(found.summary(), said);
}

#[test]
fn a_duty_without_time_has_no_power() {
    let row = |position| Row { position, effort: 5.0, velocity: 0.0, acceleration: 0.0, time: None };
    let duty = Duty::new(vec![row(0.0), row(1.0)]).unwrap();
    let power = check(&evaluate(&duty, &motor(), &Conditions::new(1.0)).unwrap(), Subject::RatedPower);
    assert_eq!((power.passes(), power.reason.as_str()), (None, "not checked: the duty has no time"));
}

#[test]
fn what_is_no_drive_is_told() {
    let weak = Drive { peak_effort: 1.0, ..motor() };
    let said = "`m`: peak_effort is 1 in SI units, it must be the rated effort or above";
    assert_eq!(evaluate(&lift(), &weak, &Conditions::new(1.0)).unwrap_err().to_string(), said);
    let none = select(&lift(), Kind::Linear, &[motor()], &Conditions::new(1.0));
    assert_eq!(none.unwrap_err(), SizingError::NoCandidates);
}
