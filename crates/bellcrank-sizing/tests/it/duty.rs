//! What a duty asks, against integrals done by hand.

use bellcrank_sizing::{Basis, Duty, Requirement, Row, SizingError};
use proptest::collection::vec;
use proptest::prelude::*;

use crate::near;

fn row(position: f64, effort: f64, velocity: f64, time: Option<f64>) -> Row {
    Row { position, effort, velocity, acceleration: 0.0, time }
}

#[track_caller]
fn asked(rows: Vec<Row>) -> Requirement {
    Requirement::of(&Duty::new(rows).unwrap())
}

/// Paper lift: −79.648 … 80.283 mm, 4844.5 N at the bottom, 20 mm/s.
#[test]
fn a_lift_is_pushed_all_the_way() {
    let rows = [(-0.079648, 4844.52), (-0.04139, 4760.22), (0.0, 4750.0), (0.04143, 4741.16), (0.080283, 4680.32)];
    let duty = Duty::new(rows.map(|(x, f)| row(x, f, 0.02, None)).to_vec()).unwrap();
    let asked = Requirement::of(&duty);
    assert_eq!(duty.basis(), Basis::Speed);
    near(asked.stroke, 0.159931, 1e-12);
    near(asked.duration.unwrap(), 0.159931 / 0.02, 1e-12);
    assert_eq!((asked.push.value, asked.push.row, asked.pull.value), (4844.52, 0, 0.0));
    near(asked.power.value, 96.8904, 1e-12);
    near(asked.mean_power.unwrap(), asked.net_power.unwrap(), 1e-14);
    assert!(asked.rms_effort > 4680.0 && asked.rms_effort < 4844.52);

    // Mounted the other way round it pulls, and gives the same power.
    let turned = Requirement::of(&duty.reversed());
    assert_eq!((turned.pull.value, turned.push.value), (4844.52, 0.0));
    assert_eq!((turned.power.value, turned.rms_effort), (asked.power.value, asked.rms_effort));
    assert_eq!((turned.extending.speed.value, turned.retracting.speed.value), (0.0, 0.02));
    // Reports tell the place of the machine.
    let place = duty.reversed().machine_position(turned.pull.position);
    assert_eq!(place, asked.push.position);
}

/// A load that is lowered is still pushed against; its power comes back.
#[test]
fn lowering_a_load_needs_push_and_gives_power() {
    let asked = asked(vec![row(0.2, 1000.0, -0.5, Some(0.0)), row(0.0, 1000.0, -0.5, Some(0.4))]);
    assert_eq!((asked.push.value, asked.pull.value), (1000.0, 0.0));
    assert_eq!((asked.power.value, asked.braking_power.value), (0.0, 500.0));
    assert_eq!((asked.mean_power, asked.net_power), (Some(0.0), Some(-500.0)));
}

/// Out against 300 N, a rest under 900 N, back with a pull of 200 N that a push of 50 N follows.
#[test]
fn directions_are_told_apart() {
    let rows = [(0.0, 300.0, 0.2), (0.1, 900.0, 0.0), (0.1, -200.0, -0.3), (0.0, 50.0, -0.1)];
    let asked = asked(rows.map(|(x, f, v)| row(x, f, v, None)).to_vec());
    assert_eq!((asked.push.value, asked.pull.value), (900.0, 200.0));
    let both = [asked.extending, asked.retracting].map(|m| (m.push.value, m.pull.value, m.speed.value));
    assert_eq!(both, [(300.0, 0.0, 0.2), (50.0, 200.0, 0.3)]);
}

/// Steps in the effort are two rows of one time: 5 N·m for 0.1 s, 1 for 0.8 s, −3 for 0.1 s; √4.2 on the mean.
#[test]
fn root_mean_square_of_a_stepped_profile() {
    let steps = [(0.0, 5.0), (0.1, 5.0), (0.1, 1.0), (0.9, 1.0), (0.9, -3.0), (1.0, -3.0)];
    let asked = asked(steps.map(|(t, m)| row(t, m, 1.0, Some(t))).to_vec());
    near(asked.rms_effort, 4.2f64.sqrt(), 1e-14);
    assert_eq!((asked.push.value, asked.pull.value), (5.0, 3.0));
}

#[test]
fn root_mean_square_of_lines_and_sines() {
    near(asked(vec![row(0.0, -30.0, 0.0, None), row(1.0, 30.0, 0.0, None)]).rms_effort, 30.0 / 3f64.sqrt(), 1e-14);
    let sine = |i: i32| {
        let t = f64::from(i) / 2000.0;
        row(0.0, 7.0 * (std::f64::consts::TAU * t).sin(), 0.0, Some(t))
    };
    near(asked((0..=2000).map(sine).collect()).rms_effort, 7.0 / 2f64.sqrt(), 2e-6);
}

/// Power through zero: only its positive part is motor power. 4 W to −2 W in a line: 4²/(2·6) W.
#[test]
fn mean_power_counts_what_is_given() {
    let asked = asked(vec![row(0.0, 4.0, 1.0, Some(0.0)), row(1.0, -2.0, 1.0, Some(1.0))]);
    near(asked.mean_power.unwrap(), 16.0 / 12.0, 1e-14);
    near(asked.net_power.unwrap(), 1.0, 1e-14);
}

/// x = a t²/2, v = a t: dt = dx / v with the mean speed gives the times back.
#[test]
fn time_from_speed_is_exact_at_constant_acceleration() {
    let (a, times) = (1.7, [0.0, 0.13, 0.4, 0.55, 1.2]);
    let rows = |timed: bool| -> Vec<Row> {
        times.map(|t| row(a * t * t / 2.0, 100.0 * t - 20.0, a * t, timed.then_some(t))).to_vec()
    };
    let (timed, derived) = (Duty::new(rows(true)).unwrap(), Duty::new(rows(false)).unwrap());
    assert_eq!((timed.basis(), derived.basis()), (Basis::Time, Basis::Speed));
    let (timed, derived) = (Requirement::of(&timed), Requirement::of(&derived));
    near(derived.duration.unwrap(), 1.2, 1e-14);
    near(derived.rms_effort, timed.rms_effort, 1e-13);
    near(derived.mean_power.unwrap(), timed.mean_power.unwrap(), 1e-13);
}

/// Without speed there is no time; the mean is over travel, so rows that crowd do not count more.
#[test]
fn means_are_over_travel_without_speed() {
    let duty = Duty::new([0.0, 0.01, 0.02, 1.0].map(|x| row(x, 10.0 + x, 0.0, None)).to_vec()).unwrap();
    let asked = Requirement::of(&duty);
    assert_eq!((duty.basis(), asked.duration, asked.mean_power), (Basis::Travel, None, None));
    near(asked.rms_effort, ((11f64.powi(3) - 1000.0) / 3.0).sqrt(), 1e-14);
}

#[test]
fn a_single_row_asks_its_own_values() {
    let asked = asked(vec![row(0.3, -250.0, 0.0, None)]);
    assert_eq!((asked.stroke, asked.rms_effort, asked.pull.value, asked.push.value), (0.0, 250.0, 250.0, 0.0));
}

#[test]
fn what_is_no_duty_is_told() {
    let fine = row(0.0, 1.0, 1.0, None);
    let error = |rows| Duty::new(rows).unwrap_err();
    assert_eq!(error(vec![]), SizingError::NoRows);
    let value = "effort";
    assert_eq!(error(vec![fine, row(1.0, f64::NAN, 1.0, None)]), SizingError::NotFinite { row: 1, value });
    assert_eq!(error(vec![fine, row(1.0, 1.0, 1.0, Some(1.0))]), SizingError::TimeMissing { row: 0 });
    let back = vec![row(0.0, 1.0, 1.0, Some(1.0)), row(1.0, 1.0, 1.0, Some(0.9))];
    assert_eq!(error(back), SizingError::TimeGoesBack { row: 1 });
    let columns = Duty::from_columns(&[0.0, 1.0], &[1.0], &[0.0, 0.0], &[0.0, 0.0], None).unwrap_err();
    assert_eq!(columns.to_string(), "1 values of effort for 2 positions");
}

proptest! {
    /// Twice the effort: twice of all forces and powers. A row in the middle of a line changes nothing.
    #[test]
    fn scaling_and_refinement(values in vec((-5e3f64..5e3, 0.01f64..0.3), 2..12), k in 0.1f64..9.0) {
        let mut time = 0.0;
        let rows: Vec<Row> = values.iter().map(|&(f, v)| {
            time += 0.1;
            row(time * 0.2, f, v, Some(time))
        }).collect();
        let asked_of = asked(rows.clone());
        let scaled = asked(rows.iter().map(|r| Row { effort: k * r.effort, ..*r }).collect());
        near(scaled.rms_effort, k * asked_of.rms_effort, 1e-12);
        near(scaled.effort.value, k * asked_of.effort.value, 1e-12);

        let middle = |a: &Row, b: &Row| row((a.position + b.position) / 2.0, (a.effort + b.effort) / 2.0,
            (a.velocity + b.velocity) / 2.0, a.time.zip(b.time).map(|(s, t)| (s + t) / 2.0));
        let mut fine = vec![rows[0]];
        rows.windows(2).for_each(|w| fine.extend([middle(&w[0], &w[1]), w[1]]));
        near(asked(fine).rms_effort, asked_of.rms_effort, 1e-12);
    }
}
