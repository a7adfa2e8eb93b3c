//! No input makes it panic, and what comes back is in order.

use bellcrank_sizing::electric::{self, Drive, Gear, Kind};
use bellcrank_sizing::pneumatic::{self, Conductance, Cylinder, EndCondition, Mount, Mounting, Supply};
use bellcrank_sizing::{Candidate, Duty, Row, Selection, Verdict};
use proptest::array::{uniform4, uniform8, uniform10};
use proptest::option;
use proptest::prelude::*;

/// Numbers of every kind, plain ones most often.
fn number() -> impl Strategy<Value = f64> {
    let odd = [0.0, -0.0, f64::NAN, f64::INFINITY, 1e308, -1e308, 5e-324, -1.0, 1.0];
    prop_oneof![60 => 1e-3f64..1e3, 2 => proptest::sample::select(odd.to_vec()), 1 => any::<f64>()]
}

fn rows() -> impl Strategy<Value = Vec<Row>> {
    let row = (number(), number(), number(), number(), option::of(number()));
    let row = row.prop_map(|(position, effort, velocity, acceleration, time)| Row {
        position,
        effort,
        velocity,
        acceleration,
        time,
    });
    proptest::collection::vec(row, 0..5)
}

fn in_order<C: Candidate>(found: &Selection<C>) {
    let passing: Vec<bool> = found.candidates.iter().map(Candidate::passes).collect();
    assert!(passing.is_sorted_by(|a, b| a >= b));
    assert_eq!(found.chosen().is_some(), passing.contains(&true));
    assert_eq!(found.nearest().is_some(), passing.contains(&false));
    assert!(!found.summary().is_empty());
    for check in found.candidates.iter().flat_map(|candidate| candidate.checks()) {
        assert!(!check.reason.is_empty());
        match check.verdict {
            Verdict::Passes => assert!(check.utilization() <= 1.0 + 1e-6, "{check:?}"),
            Verdict::Fails => assert!(check.utilization().is_nan() || check.utilization() > 1.0, "{check:?}"),
            Verdict::NotChecked => assert_eq!(check.passes(), None),
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn cylinders(rows in rows(), n in uniform10(number()), some in uniform4(option::of(number()))) {
        let Ok(duty) = Duty::new(rows) else { return Ok(()) };
        let cylinder = |bore, rod| Cylinder {
            bore, rod, strokes: vec![n[2], n[3]], max_stroke: some[0], max_speed: some[1], cushion_energy: some[2],
            moving_mass: some[3], ..Cylinder::bare()
        };
        let mounting = Mounting { end: EndCondition::FixedFree, at: Mount::Centre, offset: n[4] };
        let conditions = pneumatic::Conditions {
            moved_mass: some[0], stroke_reserve: n[5], dead_volume: n[6],
            valve: some[1].map(|sonic| Conductance::new(sonic, n[7].fract())),
            ..pneumatic::Conditions::new(Supply { pressure: n[8], atmosphere: n[9] }, 0.7, mounting)
        };
        if let Ok(found) = pneumatic::select(&duty, &[cylinder(n[0], n[1]), cylinder(n[0] * 2.0, n[1])], &conditions) {
            in_order(&found);
        }
    }

    #[test]
    fn drives(rows in rows(), n in uniform8(number()), some in uniform4(option::of(number()))) {
        let Ok(duty) = Duty::new(rows) else { return Ok(()) };
        let drive = |kind| Drive {
            knee_speed: some[0], rated_power: some[1], peak_power: some[2], max_stroke: some[3], strokes: vec![n[3]],
            inertia: some[1], gear: some[2].map(|ratio| Gear { ratio, efficiency: n[4] }),
            ..Drive::bare(kind, n[0], n[0] + n[1], n[2])
        };
        let conditions = electric::Conditions { safety: n[5], stroke_reserve: n[6], cycle_time: some[0] };
        for kind in [Kind::Linear, Kind::Rotary] {
            if let Ok(found) = electric::select(&duty, kind, &[drive(kind), drive(Kind::Rotary)], &conditions) {
                in_order(&found);
            }
        }
    }
}
