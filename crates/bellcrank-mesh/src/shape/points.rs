//! Integration points: place in natural coordinates and weight.
//!
//! Gauss–Legendre products on hexahedra; on triangles and tetrahedra the symmetric rules of Hammer, Marlowe & Stroud
//! (1956), Radon (1948) and Keast (1986), whose published digits are restored here by their moment equations.

use std::sync::LazyLock;

use super::Shape;

/// An integration point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// Natural coordinates.
    pub at: [f64; 3],
    /// Weight: the weights of a rule add up to the volume of the natural domain.
    pub weight: f64,
}

fn gauss(count: usize) -> Vec<(f64, f64)> {
    match count {
        1 => vec![(0.0, 2.0)],
        2 => {
            let x = (1.0_f64 / 3.0).sqrt();
            vec![(-x, 1.0), (x, 1.0)]
        }
        _ => {
            let x = 0.6_f64.sqrt();
            vec![(-x, 5.0 / 9.0), (0.0, 8.0 / 9.0), (x, 5.0 / 9.0)]
        }
    }
}

/// Natural coordinates and weight on the triangle; weights add up to 1/2.
type OnTriangle = ([f64; 2], f64);

fn triangle1() -> Vec<OnTriangle> {
    vec![([1.0 / 3.0, 1.0 / 3.0], 0.5)]
}

/// Degree 2, in the order of CalculiX's C3D15.
fn triangle3() -> Vec<OnTriangle> {
    let (a, b) = (1.0 / 6.0, 2.0 / 3.0);
    [[a, a], [b, a], [a, b]].map(|at| (at, 1.0 / 6.0)).to_vec()
}

/// Degree 5, seven points (Radon).
fn triangle7() -> Vec<OnTriangle> {
    let root = 15.0_f64.sqrt();
    let mut rule = vec![([1.0 / 3.0, 1.0 / 3.0], 9.0 / 80.0)];
    for sign in [-1.0, 1.0] {
        let a = (6.0 + sign * root) / 21.0;
        let weight = (155.0 + sign * root) / 2400.0;
        rule.extend([[a, a], [1.0 - 2.0 * a, a], [a, 1.0 - 2.0 * a]].map(|at| (at, weight)));
    }
    rule
}

fn tetrahedron4() -> Vec<Point> {
    let a = (5.0 - 5.0_f64.sqrt()) / 20.0;
    let b = 1.0 - 3.0 * a;
    [[a, a, a], [b, a, a], [a, b, a], [a, a, b]].map(|at| Point { at, weight: 1.0 / 24.0 }).to_vec()
}

/// Degree 5, fifteen points (Walkington's form of the rule of Keast).
fn tetrahedron15() -> Vec<Point> {
    let root = 15.0_f64.sqrt();
    let mut rule = vec![Point { at: [0.25; 3], weight: 16.0 / 135.0 / 6.0 }];
    for sign in [-1.0, 1.0] {
        let a = (7.0 + sign * root) / 34.0;
        let b = 1.0 - 3.0 * a;
        let weight = (2665.0 - sign * 14.0 * root) / 37800.0 / 6.0;
        rule.extend([[a, a, a], [b, a, a], [a, b, a], [a, a, b]].map(|at| Point { at, weight }));
    }
    let a = (10.0 - 2.0 * root) / 40.0;
    let b = 0.5 - a;
    let weight = 20.0 / 378.0 / 6.0;
    let places = [[a, a, b], [a, b, a], [b, a, a], [a, b, b], [b, a, b], [b, b, a]];
    rule.extend(places.map(|at| Point { at, weight }));
    rule
}

fn wedge(triangle: &[OnTriangle], height: usize) -> Vec<Point> {
    let layer = |(z, w): (f64, f64)| {
        let point = move |&([r, s], weight): &OnTriangle| Point { at: [r, s, z], weight: weight * w };
        triangle.iter().map(point).collect::<Vec<_>>()
    };
    gauss(height).into_iter().flat_map(layer).collect()
}

fn hexahedron(count: usize) -> Vec<Point> {
    let line = gauss(count);
    let mut rule = Vec::with_capacity(count * count * count);
    for &(z, c) in &line {
        for &(y, b) in &line {
            rule.extend(line.iter().map(|&(x, a)| Point { at: [x, y, z], weight: a * b * c }));
        }
    }
    rule
}

static TET1: LazyLock<Vec<Point>> = LazyLock::new(|| vec![Point { at: [0.25; 3], weight: 1.0 / 6.0 }]);
static TET4: LazyLock<Vec<Point>> = LazyLock::new(tetrahedron4);
static TET15: LazyLock<Vec<Point>> = LazyLock::new(tetrahedron15);
static WEDGE2: LazyLock<Vec<Point>> = LazyLock::new(|| wedge(&triangle1(), 2));
static WEDGE6: LazyLock<Vec<Point>> = LazyLock::new(|| wedge(&triangle3(), 2));
static WEDGE9: LazyLock<Vec<Point>> = LazyLock::new(|| wedge(&triangle3(), 3));
static WEDGE21: LazyLock<Vec<Point>> = LazyLock::new(|| wedge(&triangle7(), 3));
static HEX8: LazyLock<Vec<Point>> = LazyLock::new(|| hexahedron(2));
static HEX27: LazyLock<Vec<Point>> = LazyLock::new(|| hexahedron(3));
static TRIANGLE7: LazyLock<Vec<Point>> =
    LazyLock::new(|| triangle7().into_iter().map(|([r, s], weight)| Point { at: [r, s, 0.0], weight }).collect());
static SQUARE9: LazyLock<Vec<Point>> = LazyLock::new(|| {
    let line = gauss(3);
    let row = |&(y, b): &(f64, f64)| line.iter().map(move |&(x, a)| Point { at: [x, y, 0.0], weight: a * b });
    line.iter().flat_map(row).collect()
});

pub(super) fn stiffness(shape: Shape) -> &'static [Point] {
    match shape {
        Shape::Tet4 => &TET1,
        Shape::Tet10 => &TET4,
        Shape::Wedge6 => &WEDGE2,
        Shape::Wedge15 => &WEDGE9,
        Shape::Hex8 => &HEX8,
        Shape::Hex20 => &HEX27,
    }
}

pub(super) fn mass(shape: Shape) -> &'static [Point] {
    match shape {
        Shape::Tet4 => &TET4,
        Shape::Tet10 => &TET15,
        Shape::Wedge6 => &WEDGE6,
        Shape::Wedge15 => &WEDGE21,
        Shape::Hex8 => &HEX8,
        Shape::Hex20 => &HEX27,
    }
}

pub(super) fn triangle() -> &'static [Point] {
    &TRIANGLE7
}

pub(super) fn square() -> &'static [Point] {
    &SQUARE9
}
