//! Cylinders against duties.

use bellcrank_sizing::pneumatic::{
    BucklingLoad, Conditions, Conductance, Cylinder, CylinderCandidate, EndCondition, Mount, Mounting, Side, Supply,
    evaluate, select,
};
use bellcrank_sizing::{Candidate, Check, Duty, Row, SizingError, Stroke, Subject, Verdict};

use crate::near;

fn duty(rows: &[(f64, f64)], velocity: f64) -> Duty {
    let row = |&(position, effort): &(f64, f64)| Row { position, effort, velocity, acceleration: 0.0, time: None };
    Duty::new(rows.iter().map(row).collect()).unwrap()
}

fn lift() -> Duty {
    duty(&[(-0.079648, 4844.52), (0.0, 4750.0), (0.080283, 4680.32)], 0.02)
}

fn cylinder(bore: f64, rod: f64) -> Cylinder {
    let strokes = vec![0.2, 0.1, 0.16, 0.025];
    Cylinder { name: format!("{}", bore * 1e3), bore, rod, strokes, max_pressure: Some(1e6), ..Cylinder::bare() }
}

fn conditions() -> Conditions {
    let mounting = Mounting { end: EndCondition::PinnedPinned, at: Mount::Rear, offset: 0.1 };
    Conditions::new(Supply::gauge(6e5), 0.7, mounting)
}

#[track_caller]
fn check(candidate: &CylinderCandidate, subject: Subject) -> Check {
    candidate.checks.iter().find(|check| check.subject == subject).unwrap().clone()
}

#[track_caller]
fn judged(duty: &Duty, cylinder: &Cylinder, conditions: &Conditions) -> CylinderCandidate {
    evaluate(duty, cylinder, conditions).unwrap()
}

#[test]
fn the_lift_gets_a_bore_of_125() {
    let sizes = [cylinder(0.16, 0.04), cylinder(0.08, 0.025), cylinder(0.125, 0.032), cylinder(0.1, 0.025)];
    let found = select(&lift(), &sizes, &conditions()).unwrap();
    let order: Vec<&str> = found.candidates.iter().map(Candidate::name).collect();
    assert_eq!(order, ["125", "160", "100", "80"]);
    let chosen = found.chosen().unwrap();
    assert_eq!(chosen.stroke, Stroke::Standard(0.16));
    assert_eq!(found.summary(), "`125` is the smallest that passes");
    // By hand: 4844.52 N on 12 271.85 mm² are 3.9477 bar, 5.6395 bar with the load factor.
    near(chosen.working_pressure, 4844.52 / (std::f64::consts::PI / 4.0 * 0.125f64.powi(2)), 1e-14);
    near(chosen.needed_supply, 5.63953e5, 1e-6);
    let reasons: Vec<String> = chosen.checks.iter().map(|check| check.reason.clone()).collect();
    assert_eq!(
        reasons,
        [
            "push 7363 N × 0.7 = 5154 N, needed 4845 N at -79.65 mm",
            "pull 6881 N × 0.7 = 4816 N, none needed",
            "standard stroke 160 mm, needed 159.9 mm",
            // π² · 2.1e11 · 5.14719e-8 / 0.42²
            "Euler's load 604770 N at 420 mm (pinned-pinned) / 5 = 120954 N, needed 4845 N",
            "pressure limit 10 bar, supply 6 bar",
            "not checked: the catalogue gives no speed limit",
            "not checked: the catalogue gives no cushion energy",
        ]
    );
}

#[test]
fn none_passes_and_the_nearest_is_told() {
    let found = select(&lift(), &[cylinder(0.08, 0.025), cylinder(0.1, 0.025)], &conditions()).unwrap();
    assert!(found.chosen().is_none());
    let said = "none passes; `100` comes nearest: push 4712 N × 0.7 = 3299 N, needed 4845 N at -79.65 mm";
    assert_eq!(found.summary(), said);
}

/// The supply at which a candidate just passes is the one it names.
#[test]
fn needed_supply_just_suffices() {
    let duty = duty(&[(0.0, 900.0), (0.05, -1100.0), (0.1, 300.0)], 0.1);
    let named = judged(&duty, &cylinder(0.063, 0.02), &conditions()).needed_supply;
    let passes = |pressure| {
        let conditions = Conditions { supply: Supply::gauge(pressure), ..conditions() };
        judged(&duty, &cylinder(0.063, 0.02), &conditions).passes()
    };
    assert!(passes(named) && passes(named * 1.001) && !passes(named * 0.999));
}

#[test]
fn pull_works_on_the_ring() {
    let duty = duty(&[(0.0, 100.0), (0.1, -1200.0)], 0.1);
    let candidate = judged(&duty, &cylinder(0.063, 0.02), &conditions());
    let pull = check(&candidate, Subject::Pull);
    assert_eq!(pull.verdict, Verdict::Fails);
    assert_eq!(pull.reason, "pull 1682 N × 0.7 = 1177 N, needed 1200 N at 100 mm");
    near(pull.utilization(), 1200.0 / (1681.8516270992957 * 0.7), 1e-14);
    near(pull.margin(), 1681.8516270992957 * 0.7 / 1200.0 - 1.0, 1e-12);
    let curve = candidate.working_pressures(&duty, 1.0);
    assert_eq!((curve[0].side, curve[1].side), (Side::Piston, Side::Rod));
    near(curve[1].pressure, 1200.0 / 1681.8516270992957 * 6e5, 1e-14);
}

#[test]
fn efficiency_takes_its_share_of_force_and_pressure() {
    let with = Conditions { efficiency: 0.9, ..conditions() };
    let candidate = judged(&lift(), &cylinder(0.125, 0.032), &with);
    let said = "push 7363 N × 0.7 × 0.9 = 4639 N, needed 4845 N at -79.65 mm";
    assert_eq!(check(&candidate, Subject::Push).reason, said);
    let plain = judged(&lift(), &cylinder(0.125, 0.032), &conditions());
    near(candidate.working_pressure * 0.9, plain.working_pressure, 1e-14);
}

#[test]
fn strokes_are_rounded_up() {
    let stroke = |needed: f64, max_stroke| {
        let one = Cylinder { max_stroke, ..cylinder(0.1, 0.025) };
        let candidate = judged(&duty(&[(0.0, 1.0), (needed, 1.0)], 0.1), &one, &conditions());
        (candidate.stroke, check(&candidate, Subject::Stroke).verdict)
    };
    assert_eq!(stroke(0.16, None), (Stroke::Standard(0.16), Verdict::Passes));
    assert_eq!(stroke(0.16 + 1e-12, None), (Stroke::Standard(0.16), Verdict::Passes));
    assert_eq!(stroke(0.1601, None), (Stroke::Standard(0.2), Verdict::Passes));
    assert_eq!(stroke(0.2341, Some(0.5)), (Stroke::Special(0.235), Verdict::Passes));
    assert_eq!(stroke(0.6, Some(0.5)), (Stroke::TooShort(0.5), Verdict::Fails));
    assert_eq!(stroke(0.3, None), (Stroke::TooShort(0.2), Verdict::Fails));
}

#[test]
fn reserve_is_kept_at_each_end() {
    let with = Conditions { stroke_reserve: 0.005, ..conditions() };
    let candidate = judged(&lift(), &cylinder(0.125, 0.032), &with);
    assert_eq!(candidate.stroke, Stroke::Standard(0.2));
    let said = "standard stroke 200 mm, needed 169.9 mm (159.9 mm and 5 mm at each end)";
    assert_eq!(check(&candidate, Subject::Stroke).reason, said);
}

#[test]
fn a_long_thin_rod_buckles() {
    let long = Cylinder { strokes: vec![0.8], ..cylinder(0.1, 0.025) };
    let duty = duty(&[(0.0, 3000.0), (0.7, 2000.0)], 0.1);
    let candidate = judged(&duty, &long, &conditions());
    let said = "Euler's load 13752 N at 1700 mm (pinned-pinned) / 5 = 2750 N, needed 3000 N";
    assert_eq!(check(&candidate, Subject::Buckling).reason, said);
    assert!(!candidate.passes());
    near(candidate.critical_load, 13752.0, 1e-4);

    // A column that lacks a part is told.
    let bare = Mounting { offset: 0.0, ..conditions().mounting };
    let judged_bare = judged(&duty, &long, &Conditions { mounting: bare, ..conditions() });
    let said =
        "Euler's load 15524 N at 1600 mm (pinned-pinned, without the body's base length) / 5 = 3105 N, needed 3000 N";
    assert_eq!(check(&judged_bare, Subject::Buckling).reason, said);

    let front = Mounting { at: Mount::Front, ..conditions().mounting };
    assert!(judged(&duty, &long, &Conditions { mounting: front, ..conditions() }).passes());

    // Stopped on its way it pushes with all it has.
    let stopped = Conditions { buckling_load: BucklingLoad::Supply, ..conditions() };
    near(check(&judged(&duty, &long, &stopped), Subject::Buckling).needed, 4712.38898038469, 1e-14);
}

#[test]
fn cushions_take_mass_and_piston() {
    let known = Cylinder {
        cushion_energy: Some(2.0),
        moving_mass: Some(0.4),
        moving_mass_per_stroke: Some(2.5),
        max_speed: Some(0.5),
        ..cylinder(0.063, 0.02)
    };
    let duty = duty(&[(0.0, 100.0), (0.1, 100.0)], 0.4);
    let loaded = |moved_mass| {
        let candidate = judged(&duty, &known, &Conditions { moved_mass, ..conditions() });
        (check(&candidate, Subject::Cushion), check(&candidate, Subject::Speed))
    };
    let (cushion, speed) = loaded(Some(24.0));
    assert_eq!(cushion.reason, "cushion 2 J, 24.65 kg at 400 mm/s bring 1.972 J");
    assert_eq!((cushion.passes(), speed.passes()), (Some(true), Some(true)));
    assert_eq!(loaded(Some(30.0)).0.passes(), Some(false));
    assert_eq!(loaded(None).0.reason, "not checked: the moved mass is not given");
}

/// The valve is checked where the cylinder drives, against the pressure it needs there.
#[test]
fn a_small_valve_makes_it_slow() {
    let at = |velocity, sonic| {
        let with = Conditions { valve: Some(Conductance::new(sonic, 0.3)), ..conditions() };
        check(&judged(&duty(&[(0.0, 3000.0), (0.1, 3000.0)], velocity), &cylinder(0.1, 0.025), &with), Subject::Valve)
    };
    let valve = at(0.5, 2e-8);
    // C p1 = 2e-8 × 7.013e5; p2/p1 = 0.6891, share √(1 − (0.3891/0.7)²) = 0.8313.
    // Chamber: 3000 N / 7854 mm² + 1.013 bar = 4.8327 bar; 7854 mm² × 0.5 m/s × 4.8327.
    near(valve.needed, 1.8978e-2, 1e-4);
    assert_eq!(valve.reason, "valve 699.6 l/min ANR, needed 1139 l/min ANR at 0 mm");
    assert_eq!(at(0.3, 2e-8).verdict, Verdict::Passes);
    assert_eq!(at(-0.5, 2e-8).verdict, Verdict::NotChecked);
}

#[test]
fn air_is_counted_with_the_rate() {
    let with = Conditions { cycle_rate: Some(0.5), dead_volume: 1e-4, ..conditions() };
    let air = judged(&lift(), &cylinder(0.125, 0.032), &with).air;
    // (12271.8 + 11467.6) mm² × 160 mm × 7.013 + 0.1 l × 6.
    near(air.per_double_stroke, 27.2377e-3, 1e-5);
    near(air.mean_flow.unwrap(), air.per_double_stroke / 2.0, 1e-15);
    near(air.peak_flow, 0.0122718 * 0.02 * 7.013, 1e-5);
    assert_eq!(judged(&lift(), &cylinder(0.125, 0.032), &conditions()).air.mean_flow, None);
}

#[test]
fn what_is_no_cylinder_is_told() {
    let error = |cylinder: Cylinder| select(&lift(), &[cylinder], &conditions()).unwrap_err().to_string();
    assert_eq!(error(cylinder(0.0, 0.02)), "`0`: bore is 0 in SI units, it must be above 0");
    let thick = "`50`: rod is 0.05 in SI units, it must be 0 or above, smaller than the bore";
    assert_eq!(error(cylinder(0.05, 0.05)), thick);
    let none = Cylinder { strokes: vec![f64::NAN], ..cylinder(0.05, 0.02) };
    assert_eq!(error(none), "`50`: strokes is NaN in SI units, it must be above 0");
    assert_eq!(select(&lift(), &[], &conditions()), Err(SizingError::NoCandidates));
    let greedy = Conditions { load_factor: 1.1, ..conditions() };
    let said = "`conditions`: load_factor is 1.1 in SI units, it must be above 0, 1 at most";
    assert_eq!(evaluate(&lift(), &cylinder(0.1, 0.02), &greedy).unwrap_err().to_string(), said);
}
