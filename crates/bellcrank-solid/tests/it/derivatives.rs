//! Exact derivatives against closed forms and differences, also where outlines touch and layers coincide.

use bellcrank_math::{Dual, Real};
use bellcrank_solid::{Cut, CutShape, Eye, Link, Profile, Stack};
use std::f64::consts::PI;

use crate::parts::{bar, eye, link, plate};

/// Every number that mass properties are made of.
fn numbers<T: Real>(stack: &Stack<T>) -> Vec<T> {
    let of = stack.mass_properties(T::from_f64(7850.0));
    [vec![of.volume], of.center.to_vec(), of.inertia.concat()].concat()
}

type Twelve = Dual<12>;

/// Compares derivatives of all mass properties by all parameters with central differences.
fn compare<const N: usize>(
    at: [f64; N],
    plain: impl Fn([f64; N]) -> Link<f64>,
    dual: impl Fn([Dual<N>; N]) -> Link<Dual<N>>,
    step: f64,
    tolerance: f64,
) {
    let exact = numbers(&dual(std::array::from_fn(|i| Dual::variable(at[i], i))).build().expect("a sound link"));
    for i in 0..N {
        let side = |by: f64| {
            let mut there = at;
            there[i] += by;
            numbers(&plain(there).build().expect("a sound link"))
        };
        let (low, high) = (side(-step), side(step));
        let differences: Vec<f64> = low.iter().zip(&high).map(|(l, h)| (h - l) / (2.0 * step)).collect();
        let largest = |numbers: &[f64]| numbers.iter().fold(0.0, |a: f64, x| a.max(x.abs()));
        let size = |r: std::ops::Range<usize>| largest(&differences[r.clone()]).max(1e-3 * largest(&low[r]));
        for (k, difference) in differences.iter().enumerate() {
            let scale = if k == 0 {
                size(0..1)
            } else if k < 4 {
                size(1..4)
            } else {
                size(4..13)
            };
            let derivative = exact[k].eps[i];
            assert!(
                (derivative - difference).abs() <= tolerance * scale,
                "number {k} by parameter {i}: {derivative} exactly, {difference} by differences"
            );
        }
    }
}

/// A bell-crank in general position: three eyes, a tapered bar, a box, a plate, a slot, fillets.
fn general<T: Real>(p: [T; 12], fillet: f64) -> Link<T> {
    let n = T::from_f64;
    let z = [n(-0.011) - p[9], n(0.013) + p[9]];
    let third = Eye {
        layers: vec![[-p[10], -p[11]], [p[11], p[10]]],
        clearance: Some(p[5] * n(1.1)),
        ..eye([p[3], n(0.31)], p[4], p[5], z)
    };
    Link {
        eyes: vec![
            eye([n(0.02), n(-0.01)], p[0], p[1], [n(-0.02), n(0.022)]),
            eye([p[2], n(0.07)], n(0.03), n(0.08), z),
            third,
        ],
        webs: vec![
            bar([0, 1], [p[6], p[7]], z, Profile::Flat),
            bar([1, 2], [n(0.06), n(0.055)], z, Profile::Box { wall: p[8], skin: n(0.003) }),
        ],
        plates: vec![plate(
            &[
                ([n(0.0), n(-0.1)], n(0.01)),
                ([n(0.05), n(-0.09)], p[8]),
                ([n(0.06), n(0.02)], n(0.004)),
                ([n(-0.02), n(0.0)], n(0.0)),
            ],
            [n(-0.004), n(0.006)],
        )],
        cuts: vec![Cut {
            shape: CutShape::Slot { from: [n(0.14), n(0.025)], to: [n(0.2), n(0.045)], width: p[8] },
            layers: None,
        }],
        fillet: Some(p[8] * n(fillet)),
    }
}

#[test]
fn derivatives_of_a_bell_crank_are_those_of_differences() {
    let at = [0.04, 0.1, 0.31, 0.25, 0.03, 0.07, 0.07, 0.05, 0.011, 0.0, 0.0115, 0.0043];
    // The larger fillets have no room on the curves between two bars and span them.
    for fillet in [0.2, 0.4] {
        compare(at, |p| general::<f64>(p, fillet), |p| general::<Twelve>(p, fillet), 1e-6, 2e-6);
    }
}

/// A bar as wide as the eyes it joins, everything as thick.
fn tangent<T: Real>([width, outer, thickness, length]: [T; 4]) -> Link<T> {
    let (c, s) = (T::from_f64(0.3_f64.cos()), T::from_f64(0.3_f64.sin()));
    let half = thickness * T::from_f64(0.5);
    let layer = [-half, half];
    let none = T::zero();
    Link {
        eyes: vec![eye([none, none], none, outer, layer), eye([length * c, length * s], none, outer, layer)],
        webs: vec![bar([0, 1], [width, width], layer, Profile::Flat)],
        ..link()
    }
}

#[test]
fn derivatives_where_a_bar_is_as_wide_as_its_eyes_are_exact() {
    let (d, t, l) = (0.12, 0.02, 0.5);
    let seeds = [d, d, t, l];
    let stack = tangent(std::array::from_fn(|i| Dual::<4>::variable(seeds[i], i))).build().expect("a sound link");
    let area = l * d + PI * d * d / 4.0;
    let expected = [l * t, PI * d / 2.0 * t, area, d * t];
    for (exact, expected) in stack.moments.volume.eps.iter().zip(expected) {
        assert!((exact / expected - 1.0).abs() < 1e-12, "{exact} for {expected}");
    }
    assert!((stack.moments.volume.re / (area * t) - 1.0).abs() < 1e-14);
    // The second derivative is infinite here: differences come near with the root of the step.
    compare(seeds, tangent::<f64>, tangent::<Dual<4>>, 1e-6, 3e-3);
}

/// Two bars in line with widths and thicknesses of their own that have the same values.
fn in_line<T: Real>([a, b, fork, tongue]: [T; 4]) -> Link<T> {
    let n = T::from_f64;
    let [x, y] = [fork, tongue].map(|t| [-t * n(0.5), t * n(0.5)]);
    let outer = n(0.12);
    Link {
        eyes: vec![
            eye([n(0.0), n(0.0)], n(0.04), outer, x),
            eye([n(0.3), n(0.1)], n(0.04), outer, x),
            eye([n(0.6), n(0.2)], n(0.04), outer, y),
        ],
        webs: vec![bar([0, 1], [a, a], x, Profile::Flat), bar([1, 2], [b, b], y, Profile::Flat)],
        ..link()
    }
}

#[test]
fn parts_that_coincide_keep_derivatives_of_their_own() {
    let seeds = [0.12, 0.12, 0.02, 0.02];
    let stack = in_line(std::array::from_fn(|i| Dual::<4>::variable(seeds[i], i))).build().expect("a sound link");
    assert_eq!(stack.cells.len(), 1, "one cell for what is filled alike");
    let length = 0.1_f64.sqrt();
    let [a, b, x, y] = stack.moments.volume.eps;
    assert!((a / (length * 0.02) - 1.0).abs() < 1e-12 && (b / (length * 0.02) - 1.0).abs() < 1e-12, "{a} {b}");
    // Where both bars lie on each other either may be the thicker one.
    let area = stack.moments.volume.re / 0.02;
    assert!(((x + y) / area - 1.0).abs() < 1e-12, "{x} + {y} for {area}");
    assert!(x > 0.4 * area && y > 0.4 * area - 0.12 * 0.12, "{x} {y} {area}");
}
