use std::f64::consts::PI;
use std::sync::Arc;

use super::*;
use crate::linalg::dense;
use crate::linalg::sparse::tests::{Numbers, go_on, matrix};

fn lowest(stiffness: &SymmetricMatrix, mass: &SymmetricMatrix, count: usize) -> Eigenpairs {
    let plan = Arc::new(Plan::new(stiffness));
    Eigenproblem { stiffness, mass }.lowest(&plan, count, 2, &go_on).expect("eigenpairs")
}

fn diagonal(values: impl Iterator<Item = f64>) -> SymmetricMatrix {
    let entries: Vec<_> = values.enumerate().map(|(i, value)| (i, i, value)).collect();
    matrix(entries.len(), &entries)
}

/// The pairs are what they say, orthonormal, and within 1e-9 of `expected`.
fn check(stiffness: &SymmetricMatrix, mass: &SymmetricMatrix, expected: &[f64]) {
    let pairs = lowest(stiffness, mass, expected.len());
    assert_eq!(pairs.values.len(), expected.len());
    let scale = expected[expected.len() - 1];
    for (value, expected) in pairs.values.iter().zip(expected) {
        assert!((value - expected).abs() < 1e-9 * scale, "{:?} against {expected}", pairs.values);
    }
    // Rounding of 1e-16 of the largest image is 1e-7 of those 1e9 times smaller.
    assert!(pairs.residuals.iter().all(|&r| r < 1e-5), "{:?}", pairs.residuals);
    let mut heavy = vec![0.0; pairs.vectors.len()];
    mass.multiply(&pairs.vectors, &mut heavy);
    for (i, x) in pairs.vectors.chunks_exact(mass.size).enumerate() {
        for (j, y) in heavy.chunks_exact(mass.size).enumerate() {
            let product: f64 = x.iter().zip(y).map(|(x, y)| x * y).sum();
            assert!((product - f64::from(u8::from(i == j))).abs() < 1e-10, "{i} {j} {product}");
        }
    }
}

/// Springs of one stiffness between equal masses; held at one end, or free.
fn chain(size: usize, stiffness: f64, held: bool) -> SymmetricMatrix {
    let mut list: Vec<_> =
        (1..size).flat_map(|i| [(i, i, stiffness), (i - 1, i - 1, stiffness), (i, i - 1, -stiffness)]).collect();
    if held {
        list.push((0, 0, stiffness));
    }
    matrix(size, &list)
}

#[test]
fn a_chain_of_springs_held_at_one_end() {
    for (size, count) in [(1, 1), (2, 2), (7, 3), (12, 12), (20, 9), (500, 12)] {
        let (k, m) = (2.3, 0.7);
        // λⱼ = 4 k/m sin²((2j − 1) π / (2 (2n + 1)))
        let angle = |j: usize| (2 * j - 1) as f64 * PI / (2 * (2 * size + 1)) as f64;
        let expected: Vec<f64> = (1..=count).map(|j| 4.0 * k / m * angle(j).sin().powi(2)).collect();
        check(&chain(size, k, true), &diagonal((0..size).map(|_| m)), &expected);
    }
}

#[test]
fn a_free_chain_has_its_rigid_mode() {
    for (size, count) in [(2, 2), (9, 4), (400, 10)] {
        let (k, m) = (5.1e7, 0.3);
        // λⱼ = 4 k/m sin²(j π / (2 n)), j from 0
        let expected: Vec<f64> =
            (0..count).map(|j| 4.0 * k / m * (j as f64 * PI / (2 * size) as f64).sin().powi(2)).collect();
        check(&chain(size, k, false), &diagonal((0..size).map(|_| m)), &expected);
    }
}

/// Sums of the eigenvalues of held chains along each side of a grid, and its Laplacian.
fn laplacian(sides: [usize; 3]) -> (SymmetricMatrix, Vec<f64>) {
    let at = |p: [usize; 3]| (p[0] * sides[1] + p[1]) * sides[2] + p[2];
    let (mut list, mut values) = (Vec::new(), Vec::new());
    for k in 0..sides[0] * sides[1] * sides[2] {
        let p = [k / (sides[1] * sides[2]), k / sides[2] % sides[1], k % sides[2]];
        let mut value = 0.0;
        for i in (0..3).filter(|&i| sides[i] > 1) {
            list.push((k, k, 2.0));
            let mut q = p;
            q[i] += 1;
            if q[i] < sides[i] {
                list.push((k, at(q), -1.0));
            }
            value += 4.0 * (q[i] as f64 * PI / (2 * (sides[i] + 1)) as f64).sin().powi(2);
        }
        values.push(value);
    }
    values.sort_by(f64::total_cmp);
    (matrix(values.len(), &list), values)
}

#[test]
fn multiple_eigenvalues_are_all_found() {
    // A square has double eigenvalues, a cube triple and sixfold ones.
    for (sides, count) in [([40, 40, 1], 24), ([11, 11, 11], 30), ([4, 4, 4], 64)] {
        let (stiffness, expected) = laplacian(sides);
        check(&stiffness, &diagonal(expected.iter().map(|_| 1.0)), &expected[..count]);
    }
}

#[test]
fn six_bodies_apart_have_six_rigid_modes() {
    let mut list = Vec::new();
    for body in 0..6 {
        for i in 1..30 {
            let (a, b) = (body * 30 + i - 1, body * 30 + i);
            list.extend([(a, a, 3.0), (b, b, 3.0), (a, b, -3.0)]);
        }
    }
    let value = |j: usize| 12.0 / 2.0 * (j as f64 * PI / 60.0).sin().powi(2);
    let expected: Vec<f64> = (0..18).map(|k| value(k / 6)).collect();
    check(&matrix(180, &list), &diagonal((0..180).map(|_| 2.0)), &expected);
}

#[test]
fn restarts_come_to_the_same_answer() {
    // A long chain with masses over six decades converges slowly: the basis fills up.
    let mut numbers = Numbers(5);
    let size = 3000;
    let stiffness = chain(size, 1.0, true);
    let mass = diagonal((0..size).map(|_| 10.0_f64.powf(3.0 * numbers.next())));
    let pairs = lowest(&stiffness, &mass, 40);
    assert!(pairs.residuals.iter().all(|&r| r < 1e-6), "{:?}", pairs.residuals);
    assert!(pairs.values.windows(2).all(|w| w[0] < w[1]));
}

#[test]
fn the_search_stops_when_asked() {
    let (stiffness, _) = laplacian([12, 12, 1]);
    let mass = diagonal((0..144).map(|_| 1.0));
    let plan = Arc::new(Plan::new(&stiffness));
    let problem = Eigenproblem { stiffness: &stiffness, mass: &mass };
    let result = problem.lowest(&plan, 20, 1, &|share| share < 0.51);
    assert_eq!(result, Err(EigenFailure::Factor(Failure::Interrupted)));
}

/// Under constraints, the eigenpairs are those of the matrices in a basis of what the constraints leave; a chain that
/// nothing else holds, held by three sums of its places.
#[test]
fn constraints_leave_the_eigenpairs_of_what_they_leave() {
    let size = 40;
    let mut numbers = Numbers(11);
    let (k, m) = (chain(size, 3.1, false), diagonal((0..size).map(|i| 0.5 + 0.02 * i as f64)));
    let constraints: Vec<f64> = (0..3 * size).map(|_| numbers.next()).collect();
    let sprung = k.plus(1.0, &matrix(size, &[(7, 7, 2.0)]));
    let factor = Cholesky::factor(Arc::new(Plan::new(&sprung)), &sprung, 1, &go_on).expect("held by a spring");
    let held = Held::new(&factor, constraints.clone(), vec![1.0; size]).expect("independent");
    assert_eq!(held.dimension(), size - 3);
    let rows: Vec<Vec<f64>> = constraints.chunks(size).map(<[f64]>::to_vec).collect();
    let unit: Vec<Vec<f64>> = (0..size).map(|i| (0..size).map(|j| f64::from(u8::from(i == j))).collect()).collect();
    let basis = dense::complement(&unit, &rows);
    let projected = |a: &SymmetricMatrix| -> Vec<Vec<f64>> {
        let image = |x: &Vec<f64>| {
            let mut y = vec![0.0; size];
            a.multiply(x, &mut y);
            basis.iter().map(|b| b.iter().zip(&y).map(|(b, y)| b * y).sum()).collect()
        };
        basis.iter().map(image).collect()
    };
    let (expected, _) = dense::generalized_eigen(&projected(&k), &projected(&m)).expect("definite");
    let problem = Eigenproblem { stiffness: &k, mass: &m };
    for count in [1, 5, 37, 99] {
        let pairs = problem.lowest_held(&held, count, &go_on).expect("eigenpairs");
        assert_eq!(pairs.values.len(), count.min(37));
        for (value, expected) in pairs.values.iter().zip(&expected) {
            assert!((value / expected - 1.0).abs() < 1e-9, "{value} {expected}");
        }
        assert!(pairs.residuals.iter().all(|&r| r < 1e-7), "{:?}", pairs.residuals);
        for x in pairs.vectors.chunks_exact(size) {
            assert!(rows.iter().all(|c| c.iter().zip(x).map(|(c, x)| c * x).sum::<f64>().abs() < 1e-9));
        }
    }
    assert!(Held::new(&factor, [&constraints[..size], &constraints[..size]].concat(), vec![1.0; size]).is_none());
}

/// A system under constraints, with displacements that are wanted and forces that are not in balance.
#[test]
fn constraints_are_met_and_their_forces_balance() {
    let size = 25;
    let mut numbers = Numbers(5);
    let k = chain(size, 1.7, false);
    let sprung = k.plus(1.0, &matrix(size, &[(0, 0, 1.3)]));
    let factor = Cholesky::factor(Arc::new(Plan::new(&sprung)), &sprung, 1, &go_on).expect("held by a spring");
    let c: Vec<f64> = (0..2 * size).map(|_| numbers.next()).collect();
    let held = Held::new(&factor, c.clone(), vec![1.0; size]).expect("independent");
    let forces: Vec<f64> = (0..2 * size).map(|_| numbers.next()).collect();
    let wanted = [0.3, -0.7, 1.1, 0.2];
    let mut u = forces.clone();
    let multipliers = held.solve(&mut u, &wanted);
    let mut balance = vec![0.0; u.len()];
    k.multiply(&u, &mut balance);
    for case in 0..2 {
        let own = case * size..(case + 1) * size;
        for (i, row) in c.chunks(size).enumerate() {
            let moved: f64 = row.iter().zip(&u[own.clone()]).map(|(c, u)| c * u).sum();
            assert!((moved - wanted[2 * case + i]).abs() < 1e-12);
        }
        for (k, at) in own.enumerate() {
            let tied = c[k] * multipliers[2 * case] + c[size + k] * multipliers[2 * case + 1];
            assert!((balance[at] + tied - forces[at]).abs() < 1e-11, "{case} {k}");
        }
    }
}
