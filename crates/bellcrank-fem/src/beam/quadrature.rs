//! Legendre's polynomials, and Gauss points on 0 to 1.

/// P_0 to P_n at s.
pub(super) fn legendre(n: usize, s: f64) -> Vec<f64> {
    let mut p = vec![1.0, s];
    for k in 2..=n {
        let order = k as f64;
        p.push(((2.0 * order - 1.0) * s * p[k - 1] - (order - 1.0) * p[k - 2]) / order);
    }
    p.truncate(n + 1);
    p
}

/// `count` places on 0 to 1 with their weights: exact to degree 2·`count` − 1.
pub(super) fn gauss(count: usize) -> Vec<(f64, f64)> {
    (0..count).map(|k| node(count, k)).map(|(s, weight)| (0.5 * (1.0 + s), 0.5 * weight)).collect()
}

/// Root k of P_n by Newton's method from Tricomi's estimate, with its weight on −1 to 1.
fn node(n: usize, k: usize) -> (f64, f64) {
    let order = n as f64;
    let mut s = -(std::f64::consts::PI * (k as f64 + 0.75) / (order + 0.5)).cos();
    let slope = |s: f64, p: &[f64]| order * (s * p[n] - p[n - 1]) / (s * s - 1.0);
    // Quadratic from a start that is good to 1/n⁴: four steps reach the last digit, two more cost nothing.
    for _ in 0..6 {
        let p = legendre(n, s);
        s -= p[n] / slope(s, &p);
    }
    let d = slope(s, &legendre(n, s));
    (s, 2.0 / ((1.0 - s * s) * d * d))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn polynomials_up_to_the_stated_degree_are_integrated_exactly() {
        for count in 1..24 {
            let points = gauss(count);
            for degree in 0..2 * count {
                let sum: f64 = points.iter().map(|(x, w)| w * x.powi(degree as i32)).sum();
                let exact = 1.0 / (degree as f64 + 1.0);
                assert!((sum - exact).abs() < 1e-14, "{count} points, degree {degree}: {sum}");
            }
        }
    }
}
