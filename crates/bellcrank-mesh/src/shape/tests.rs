//! Identities that any set of shape functions and integration points has to meet.

use super::{FaceShape, MOST_NODES, Shape};

/// ∫ x^i y^j z^k over the natural domain, closed form.
fn moment(shape: Shape, [i, j, k]: [u32; 3]) -> f64 {
    let factorial = |n: u32| (1..=n).map(f64::from).product::<f64>();
    let line = |n: u32| if n % 2 == 1 { 0.0 } else { 2.0 / f64::from(n + 1) };
    match shape.corners() {
        4 => factorial(i) * factorial(j) * factorial(k) / factorial(i + j + k + 3),
        6 => factorial(i) * factorial(j) / factorial(i + j + 2) * line(k),
        _ => line(i) * line(j) * line(k),
    }
}

fn powers(degree: u32) -> impl Iterator<Item = [u32; 3]> {
    (0..=degree).flat_map(move |i| (0..=degree - i).flat_map(move |j| (0..=degree - i - j).map(move |k| [i, j, k])))
}

#[test]
fn rules_integrate_polynomials_of_their_degree() {
    for (shape, stiff, mass) in [
        (Shape::Tet4, 1, 2),
        (Shape::Tet10, 2, 5),
        (Shape::Wedge6, 1, 2),
        (Shape::Wedge15, 2, 5),
        (Shape::Hex8, 3, 3),
        (Shape::Hex20, 5, 5),
    ] {
        for (rule, degree) in [(shape.stiffness_points(), stiff), (shape.mass_points(), mass)] {
            for power in powers(degree) {
                let term = |at: [f64; 3]| (0..3).map(|c| at[c].powi(power[c] as i32)).product::<f64>();
                let sum: f64 = rule.iter().map(|point| point.weight * term(point.at)).sum();
                assert!((sum - moment(shape, power)).abs() < 1e-14, "{shape:?} {power:?}: {sum}");
            }
        }
    }
}

#[test]
fn shape_functions_are_one_at_their_node_and_reproduce_linear_fields() {
    for shape in Shape::ALL {
        let (mut n, mut d) = ([0.0; MOST_NODES], [[0.0; 3]; MOST_NODES]);
        for node in 0..shape.nodes() {
            shape.evaluate(shape.node_coordinates(node), &mut n, &mut d);
            for (other, value) in n[..shape.nodes()].iter().enumerate() {
                assert!((value - f64::from(other == node)).abs() < 1e-14, "{shape:?} {node} {other}");
            }
        }
        let at = [0.21, 0.34, 0.27];
        shape.evaluate(at, &mut n, &mut d);
        for (c, expected) in at.into_iter().enumerate() {
            let place: f64 = (0..shape.nodes()).map(|k| n[k] * shape.node_coordinates(k)[c]).sum();
            assert!((place - expected).abs() < 1e-14);
        }
    }
}

#[test]
fn derivatives_agree_with_differences() {
    let h = 1e-6;
    for shape in Shape::ALL {
        let at = [0.21, 0.34, -0.17];
        let (mut n, mut d) = ([0.0; MOST_NODES], [[0.0; 3]; MOST_NODES]);
        let (mut up, mut down, mut unused) = (n, n, d);
        shape.evaluate(at, &mut n, &mut d);
        for c in 0..3 {
            let moved = |by: f64| std::array::from_fn(|i| at[i] + if i == c { by } else { 0.0 });
            shape.evaluate(moved(h), &mut up, &mut unused);
            shape.evaluate(moved(-h), &mut down, &mut unused);
            for (k, exact) in d[..shape.nodes()].iter().enumerate() {
                assert!(((up[k] - down[k]) / (2.0 * h) - exact[c]).abs() < 1e-9, "{shape:?} {k} {c}");
            }
        }
    }
}

#[test]
fn faces_close_the_element_and_point_outward() {
    for shape in Shape::ALL {
        let (mut volume, mut sum) = (0.0, [0.0; 3]);
        for face in shape.faces() {
            let form = FaceShape::with_nodes(face.len());
            let places: Vec<_> = face.iter().map(|&node| shape.node_coordinates(usize::from(node))).collect();
            for point in form.points() {
                let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
                form.evaluate([point.at[0], point.at[1]], &mut n, &mut d);
                let along = |c: usize| -> [f64; 3] {
                    std::array::from_fn(|i| places.iter().zip(&d).map(|(p, d)| p[i] * d[c]).sum())
                };
                let (a, b) = (along(0), along(1));
                let normal = [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let at: [f64; 3] = std::array::from_fn(|i| places.iter().zip(&n).map(|(p, n)| p[i] * n).sum());
                volume += point.weight * (0..3).map(|i| at[i] * normal[i]).sum::<f64>() / 3.0;
                (0..3).for_each(|i| sum[i] += point.weight * normal[i]);
            }
        }
        assert!((volume - moment(shape, [0; 3])).abs() < 1e-13, "{shape:?}: {volume}");
        assert!(sum.iter().all(|s| s.abs() < 1e-13), "{shape:?}: {sum:?}");
    }
}
