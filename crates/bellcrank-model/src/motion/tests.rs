use bellcrank_doc::Number;
use bellcrank_math::Dual;

use super::*;

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
