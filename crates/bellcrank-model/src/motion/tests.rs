use bellcrank_doc::Number;
use bellcrank_math::Dual;
use bellcrank_multibody::Coordinate;

use super::*;
use crate::design::{Design, Values};
use crate::scalar::Scalar;

const PROFILES: [Profile; 5] =
    [Profile::Cycloidal, Profile::Poly5, Profile::Trapezoid, Profile::SCurve, Profile::Linear];

#[test]
fn profiles_end_exactly_and_have_the_derivatives_of_their_differences() {
    for profile in PROFILES {
        assert_eq!(profile.at(0.0).value, 0.0, "{profile:?}");
        assert_eq!(profile.at(1.0).value, 1.0, "{profile:?}");
        let h = 1e-5;
        for i in 1..50 {
            // Away from the instants where acceleration jumps.
            let t = (f64::from(i) + 0.3) / 50.0;
            let (before, now, after) = (profile.at(t - h), profile.at(t), profile.at(t + h));
            let first = (after.value - before.value) / (2.0 * h);
            let second = (after.first - before.first) / (2.0 * h);
            assert!((now.first - first).abs() < 1e-7, "{profile:?} at {t}: {} against {first}", now.first);
            assert!((now.second - second).abs() < 1e-4, "{profile:?} at {t}: {} against {second}", now.second);
        }
    }
}

#[test]
fn smooth_profiles_rest_at_both_ends() {
    for profile in [Profile::Cycloidal, Profile::Poly5, Profile::SCurve] {
        for t in [0.0, 1.0] {
            let jet = profile.at(t);
            assert!(jet.first.abs() < 1e-12 && jet.second.abs() < 1e-12, "{profile:?} at {t}: {jet:?}");
        }
    }
}

#[test]
fn a_trapezoid_reaches_one_and_a_half_times_its_mean_velocity() {
    assert!((Profile::Trapezoid.at(0.5).first - 1.5).abs() < 1e-12);
    assert!((Profile::SCurve.at(0.5).first - 1.5).abs() < 1e-12);
}

#[test]
fn every_function_of_a_jet_has_the_derivatives_of_its_differences() {
    let c = |x: f64| Jet::from(x);
    type Case = fn(Jet, fn(f64) -> Jet) -> Jet;
    let cases: [Case; 16] = [
        |x, _| x.sin(),
        |x, _| x.cos(),
        |x, _| x.tan(),
        |x, _| x.asin(),
        |x, _| x.acos(),
        |x, _| x.atan(),
        |x, c| (x * x).atan2(x - c(2.0)),
        |x, _| x.sqrt(),
        |x, c| (x - c(1.0)).abs(),
        |x, _| x.powi(3),
        |x, _| x.powi(-2),
        |x, c| x.powf(c(1.5)),
        |x, _| x.powf(x),
        |x, c| x * x.sin() / (x + c(1.0)),
        |x, c| c(1.0) / x,
        |x, _| -x * x * x,
    ];
    for (i, f) in cases.iter().enumerate() {
        let (t, h) = (0.37, 1e-5);
        let at = |t: f64| f(Jet::variable(t), Jet::from);
        let (before, now, after) = (at(t - h), at(t), at(t + h));
        let first = (after.value - before.value) / (2.0 * h);
        let second = (after.first - before.first) / (2.0 * h);
        assert!((now.first - first).abs() < 1e-6, "function {i}: {} against {first}", now.first);
        assert!((now.second - second).abs() < 1e-6, "function {i}: {} against {second}", now.second);
    }
    assert_eq!(Jet::variable(0.0).powi(2), Jet::new(0.0, 0.0, 2.0));
    assert_eq!(Jet::variable(0.0).powf(c(2.0)), Jet::new(0.0, 0.0, 2.0));
}

#[test]
fn a_spline_meets_its_points_and_reproduces_cubics() {
    let cubic = |t: f64| 0.3 * t * t * t - t * t + 2.0 * t - 1.0;
    let times = vec![0.0, 0.4, 1.0, 1.1, 2.0, 3.5];
    let spline = Spline::through(times.clone(), times.iter().map(|&t| cubic(t)).collect()).expect("increasing times");
    for i in 0..=35 {
        let t = f64::from(i) / 10.0;
        let jet = spline.at(t);
        assert!((jet.value - cubic(t)).abs() < 1e-12, "at {t}");
        assert!((jet.first - (0.9 * t * t - 2.0 * t + 2.0)).abs() < 1e-11, "at {t}");
        assert!((jet.second - (1.8 * t - 2.0)).abs() < 1e-10, "at {t}");
    }
    assert_eq!(spline.at(9.0), Jet::from(cubic(3.5)));
}

#[test]
fn short_tables_are_lines_and_parabolas() {
    let line = Spline::through(vec![0.0, 2.0], vec![1.0, 5.0]).expect("two points");
    assert_eq!(line.at(1.0), Jet::new(3.0, 2.0, 0.0));
    let parabola = Spline::through(vec![0.0, 1.0, 3.0], vec![0.0, 1.0, 9.0]).expect("three points");
    assert!((parabola.at(2.0).value - 4.0).abs() < 1e-12);
    assert!(Spline::through(vec![0.0, 0.0], vec![1.0, 1.0]).is_none());
}

#[test]
fn time_with_a_derivative_gives_the_jerk_and_at_the_end_that_of_the_way_there() {
    let time = |t: f64| Dual::<1>::variable(t, 0);
    for profile in PROFILES {
        let (here, plain) = (profile.at(time(0.4)), profile.at(0.4));
        let difference = (here.value.eps[0] - plain.first).abs() + (here.first.eps[0] - plain.second).abs();
        assert!(difference < 1e-13, "{profile:?}: {difference}");
        let h = 1e-5;
        let jerk = (profile.at(0.4 + h).second - profile.at(0.4 - h).second) / (2.0 * h);
        assert!((here.second.eps[0] - jerk).abs() < 1e-6 * (1.0 + jerk.abs()), "{profile:?}");
        let end = profile.at(time(1.0));
        assert_eq!(end.value.re, 1.0, "{profile:?}");
        assert!((end.value.eps[0] - profile.at(1.0).first).abs() < 1e-13, "{profile:?}");
    }
    let spline = Spline::through(vec![0.0, 0.4, 1.0, 1.1], vec![0.3, 0.1, 0.7, 0.2]).expect("increasing times");
    let (here, plain) = (spline.at(time(0.7)), spline.at(0.7));
    let difference = (here.value.eps[0] - plain.first).abs() + (here.first.eps[0] - plain.second).abs();
    assert!(difference < 1e-13, "{difference}");
}

#[test]
fn jets_of_constants_have_no_rates_where_a_function_is_steep() {
    let c = Jet::<f64>::from;
    for jet in [c(0.0).sqrt(), c(1.0).asin(), c(0.0).powf(c(0.5))] {
        assert_eq!([jet.first, jet.second], [0.0; 2]);
    }
}

/// Two motions of one slide, and one of a hinge that waits for a segment.
fn sequence() -> crate::Model {
    let folder = std::env::temp_dir().join(format!("bellcrank-programme-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a scratch folder");
    let path = folder.join("sequence.toml");
    let text = r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]
[parameters]
t_up = "2 s"
pause = "0.5 s"
way = "0.3 m"
[ground.points]
O = [0, 0]
[bodies.car]
points = { O = [0, 0] }
[bodies.arm]
points = { O = [0, 0] }
[joints]
slide = { kind = "prismatic", connects = ["ground.O", "car.O"], axis = "x", start = "way/3" }
hinge = { kind = "revolute", connects = ["car.O", "arm.O"], start = "0 deg" }
[motions.back]
joint = "slide"
start = "after turn"
delay = "pause"
segments = [{ by = "-way", over = "1 s", profile = "trapezoid" }]
[motions.out]
joint = "slide"
segments = [{ by = "way", over = "t_up" }, { hold = "pause", name = "rest" }]
[motions.turn]
joint = "hinge"
start = "with out.rest"
segments = [{ to = "1 rad", over = "1 s", profile = "poly5" }]
"#;
    std::fs::write(&path, text).expect("a scratch file");
    let loaded = crate::load(&path, &[]);
    let _ = std::fs::remove_dir_all(&folder);
    loaded.model.expect("a model")
}

fn programme<'d, T: Scalar>(design: &'d Design, fixed: &[(usize, T)]) -> Programme<'d, T> {
    let values = Values::with(&design.scopes, &design.scopes[0].parameters, fixed);
    let schedule = Schedule::new(design, &values);
    let from = |c: Coordinate| {
        let start = design.joints[c.joint.0].start[0].as_ref();
        start.map_or(T::zero(), |start| start.eval(&values))
    };
    Programme::new(design, &[0, 1, 2], &schedule, &values, &from)
}

#[test]
fn motions_follow_each_other_and_rest_between() {
    let model = sequence();
    let programme = programme::<f64>(model.design(), &[]);
    let [slide, hinge] = programme.tracks.as_slice() else { panic!("{} tracks", programme.tracks.len()) };
    let times: Vec<(f64, Option<f64>)> = slide.turns.iter().map(|turn| (turn.begins, turn.ends)).collect();
    assert_eq!(times, [(0.0, Some(2.5)), (3.5, Some(4.5))]);
    let from = 0.3 / 3.0;
    assert_eq!([slide.at(0.0).value, hinge.at(1.9).value, hinge.at(9.0).value], [from, 0.0, 1.0]);
    let out = from + 0.3;
    assert_eq!([slide.at(2.2), slide.at(3.0)], [Jet::from(out); 2]);
    assert!((slide.at(4.0).value - (out - 0.15)).abs() < 1e-15 && (slide.at(4.6).value - 0.1).abs() < 1e-15);
    assert!((slide.at(4.0).first + 0.45).abs() < 1e-12);
    let breaks: Vec<f64> = programme.breaks().iter().map(|time| (time * 1e6).round() / 1e6).collect();
    assert_eq!(breaks, [0.0, 2.0, 2.5, 3.0, 3.5, 3.833_333, 4.166_667, 4.5]);
}

#[test]
fn a_schedule_has_the_derivatives_of_its_differences() {
    let model = sequence();
    let design = model.design();
    let at = |i: usize, value: f64, time: f64| programme::<f64>(design, &[(i, value)]).tracks[0].at(time);
    let mut found = 0;
    for (i, &value) in design.scopes[0].parameters.values().iter().enumerate() {
        for time in [0.7, 2.2, 3.6, 4.0, 4.2, 7.0] {
            let exact = programme(design, &[(i, Dual::<1>::variable(value, 0))]).tracks[0].at(Dual::from_re(time));
            let h = 1e-5;
            let (before, after) = (at(i, value - h, time), at(i, value + h, time));
            for (exact, [a, b]) in
                [(exact.value, [before.value, after.value]), (exact.first, [before.first, after.first])]
            {
                assert!((exact.eps[0] - (b - a) / (2.0 * h)).abs() < 1e-8, "parameter {i} at {time}: {exact:?}");
                found += usize::from(exact.eps[0] != 0.0);
            }
        }
    }
    assert!(found > 15, "{found}");
}
