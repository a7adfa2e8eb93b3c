use super::*;

type One = Exact<1>;

fn at(x: f64) -> One {
    Exact(Dual::variable(x, 0))
}

#[test]
fn every_function_has_the_slope_of_its_differences_and_the_value_of_plain_numbers() {
    /// A function over any number.
    macro_rules! cases {
        ($($f:expr),* $(,)?) => {
            [$({
                fn f<N: Number>(x: N) -> N {
                    let f: fn(N) -> N = $f;
                    f(x)
                }
                (stringify!($f), f::<One> as fn(One) -> One, f::<f64> as fn(f64) -> f64)
            }),*]
        };
    }
    let cases = cases![
        |x| N::from(1.3) + x * N::from(0.7) - x / (x + N::from(2.0)),
        |x| -x,
        |x| x.sin(),
        |x| x.cos(),
        |x| x.tan(),
        |x| x.asin(),
        |x| x.acos(),
        |x| x.atan(),
        |x| (x * x).atan2(x - N::from(2.0)),
        |x| x.sqrt(),
        |x| (x - N::from(1.0)).abs(),
        |x| x.powi(3),
        |x| x.powi(-2),
        |x| x.powi(0),
        |x| x.powf(N::from(1.5)),
        |x| x.powf(N::from(-0.4)),
        |x| N::from(1.7).powf(x),
        |x| x.powf(x),
    ];
    for (name, exact, plain) in cases {
        for x in [0.37, 0.81] {
            let h = 1e-5;
            let difference = (plain(x + h) - plain(x - h)) / (2.0 * h);
            let exact = exact(at(x)).0;
            assert_eq!(exact.re, plain(x), "{name} at {x}");
            let slope = exact.eps[0];
            assert!((slope - difference).abs() < 1e-8 * slope.abs().max(1.0), "{name}: {slope} against {difference}");
        }
    }
}

#[test]
fn what_does_not_change_has_no_derivative_even_where_a_function_is_steep() {
    let zero = One::from(0.0);
    let steep = [
        zero.sqrt(),
        One::from(1.0).asin(),
        One::from(-1.0).acos(),
        zero.atan2(zero),
        zero.powf(One::from(0.5)),
        zero.powi(2),
        at(0.0).powi(0),
        at(0.0).powi(2),
        at(0.0).powf(One::from(3.0)),
        at(0.0).powf(zero),
        zero.powf(at(2.0)),
    ];
    for (i, number) in steep.iter().enumerate() {
        assert_eq!(number.0.eps, [0.0], "function {i}");
    }
    // Where it does change, there is no number to be given.
    assert_eq!(at(0.0).sqrt().0.eps, [f64::INFINITY]);
    assert!(at(0.0).atan2(at(0.0)).0.eps[0].is_nan());
    assert_eq!(at(0.0).abs().0.eps, [1.0]);
}

#[test]
fn the_length_of_nothing_has_no_slope() {
    let x = |re: f64| Dual::<1>::variable(re, 0);
    assert_eq!(length([x(0.0); 3]), Dual::from_re(0.0));
    let length = length([x(2.0), x(-1.0), x(2.0)]);
    assert_eq!((length.re, length.eps), (3.0, [1.0]));
}
