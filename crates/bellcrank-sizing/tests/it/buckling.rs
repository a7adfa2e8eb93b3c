//! Buckling: by hand, from the characteristic equations, and why Euler suffices for standard rods.

use std::f64::consts::PI;

use bellcrank_sizing::pneumatic::buckling::{critical_load, longest_column, second_moment};
use bellcrank_sizing::pneumatic::{EndCondition, Mount, Mounting};

use crate::near;

/// d = 20 mm, L = 1000 mm, E = 210 000 N/mm², hinged: I = 7854.0 mm⁴, F = π² E I / L² = 16 278 N.
#[test]
fn a_rod_by_hand() {
    near(second_moment(0.02) * 1e12, 7853.98, 1e-6);
    near(critical_load(0.02, 1.0, EndCondition::PinnedPinned, 2.1e11), 16278.3, 1e-5);
    // Twice as long: a quarter. Twice as thick: sixteen times.
    near(critical_load(0.02, 2.0, EndCondition::PinnedPinned, 2.1e11), 16278.3 / 4.0, 1e-5);
    near(critical_load(0.04, 1.0, EndCondition::PinnedPinned, 2.1e11), 16278.3 * 16.0, 1e-5);
    // Clamped and free: as a hinged column of twice the length.
    near(critical_load(0.02, 1.0, EndCondition::FixedFree, 2.1e11), 16278.3 / 4.0, 1e-5);
}

/// Smallest k L with: cos = 0; sin = 0; tan = k L; cos = 1. The factor is π / (k L).
#[test]
fn end_factors_solve_the_characteristic_equations() {
    let tangent = bisect(|x| x.sin() - x * x.cos(), PI, 1.5 * PI);
    let exact = [PI / (PI / 2.0), PI / PI, PI / tangent, PI / (2.0 * PI)];
    for (end, exact) in EndCondition::ALL.into_iter().zip(exact) {
        near(end.factor(), exact, 1.3e-3);
    }
    near(PI / tangent, 0.6992, 1e-4);
}

fn bisect(f: impl Fn(f64) -> f64, mut low: f64, mut high: f64) -> f64 {
    for _ in 0..60 {
        let middle = (low + high) / 2.0;
        if (f(low) > 0.0) == (f(middle) > 0.0) { low = middle } else { high = middle }
    }
    low
}

/// E I y'' = -F y over a hinged column in finite differences, by inverse iteration: another way to Euler's load.
#[test]
fn eulers_load_is_the_lowest_eigenvalue_of_the_column() {
    let (d, length, n) = (0.025, 0.8, 400);
    let h = length / n as f64;
    let mut y = vec![1.0; n - 1];
    let mut inverse = 0.0;
    for _ in 0..20 {
        let z = solve_laplace(&y);
        inverse = z.iter().zip(&y).map(|(a, b)| a * b).sum::<f64>() / y.iter().map(|b| b * b).sum::<f64>();
        y = z;
        let size = y.iter().fold(0.0f64, |m, v| m.max(v.abs()));
        y.iter_mut().for_each(|v| *v /= size);
    }
    let force = 2.1e11 * second_moment(d) / (inverse * h * h);
    near(critical_load(d, length, EndCondition::PinnedPinned, 2.1e11), force, 1e-5);
}

/// Solves the tridiagonal system (-1, 2, -1) z = y.
fn solve_laplace(y: &[f64]) -> Vec<f64> {
    let n = y.len();
    let (mut diagonal, mut z) = (vec![2.0; n], y.to_vec());
    for i in 1..n {
        let factor = 1.0 / diagonal[i - 1];
        diagonal[i] -= factor;
        z[i] += factor * z[i - 1];
    }
    z[n - 1] /= diagonal[n - 1];
    for i in (0..n - 1).rev() {
        z[i] = (z[i] + z[i + 1]) / diagonal[i];
    }
    z
}

#[test]
fn the_longest_column_just_carries_the_force() {
    for end in EndCondition::ALL {
        let length = longest_column(0.025, 3016.0, 5.0, end, 2.1e11);
        near(critical_load(0.025, length, end, 2.1e11), 5.0 * 3016.0, 1e-13);
    }
    assert_eq!(longest_column(0.025, 0.0, 5.0, EndCondition::PinnedPinned, 2.1e11), f64::INFINITY);
}

#[test]
fn the_column_counts_body_and_rod() {
    let column = |at| Mounting { end: EndCondition::PinnedPinned, at, offset: 0.03 }.column(0.16, Some(0.12));
    near(column(Mount::Rear), 0.16 + 0.12 + 0.16 + 0.03, 1e-15);
    near(column(Mount::Centre), 0.24 + 0.06 + 0.03, 1e-15);
    near(column(Mount::Front), 0.16 + 0.03, 1e-15);
}
