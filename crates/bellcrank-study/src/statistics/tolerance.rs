//! From tolerances of the inputs to those of a result.

/// σ of a result whose inputs scatter independently: √Σ (gᵢ σᵢ)², gᵢ the sensitivities. The shorter list counts.
#[must_use]
pub fn linear_sigma(gradient: &[f64], sigmas: &[f64]) -> f64 {
    gradient.iter().zip(sigmas).map(|(g, s)| (g * s).powi(2)).sum::<f64>().sqrt()
}

/// Share of each input in the variance of the result, (gᵢ σᵢ)² / Σ; they sum to one. All zero if nothing scatters.
#[must_use]
pub fn variance_shares(gradient: &[f64], sigmas: &[f64]) -> Vec<f64> {
    let parts: Vec<f64> = gradient.iter().zip(sigmas).map(|(g, s)| (g * s).powi(2)).collect();
    let sum: f64 = parts.iter().sum();
    parts.iter().map(|part| if sum == 0.0 { 0.0 } else { part / sum }).collect()
}

/// Greatest deviation of a linear result: Σ |gᵢ| tᵢ for inputs within ± tᵢ.
#[must_use]
pub fn linear_worst_case(gradient: &[f64], tolerances: &[f64]) -> f64 {
    gradient.iter().zip(tolerances).map(|(g, t)| (g * t).abs()).sum()
}

/// A result at a vertex of the tolerance box.
#[derive(Clone, Debug, PartialEq)]
pub struct Extreme {
    /// The result.
    pub value: f64,
    /// Deviation of each input there, ± its tolerance.
    pub deviations: Vec<f64>,
}

/// Least and greatest result over all vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct WorstCase {
    /// The least one; `None` if no vertex has a value.
    pub least: Option<Extreme>,
    /// The greatest one.
    pub greatest: Option<Extreme>,
    /// Vertices without a value.
    pub undefined: u64,
}

/// There are 2^n vertices of n inputs with a tolerance; above n = 16 they are too many.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct TooManyVertices {
    /// n.
    pub inputs: usize,
}

impl std::fmt::Display for TooManyVertices {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "2^{} vertices are too many, 2^{MOST} are possible", self.inputs)
    }
}

impl std::error::Error for TooManyVertices {}

const MOST: usize = 16;

/// Asks `result` at every vertex of the box ± tᵢ; inputs without a tolerance stay at zero. Exact where the result is
/// monotonic in each input. `None` or NaN: no value there.
///
/// # Errors
///
/// [`TooManyVertices`] above 16 inputs with a tolerance.
pub fn vertex_worst_case(
    tolerances: &[f64],
    mut result: impl FnMut(&[f64]) -> Option<f64>,
) -> Result<WorstCase, TooManyVertices> {
    let moving: Vec<usize> = (0..tolerances.len()).filter(|&i| tolerances[i] != 0.0).collect();
    if moving.len() > MOST {
        return Err(TooManyVertices { inputs: moving.len() });
    }
    let mut worst = WorstCase { least: None, greatest: None, undefined: 0 };
    let mut deviations = vec![0.0; tolerances.len()];
    for vertex in 0..1u64 << moving.len() {
        for (bit, &i) in moving.iter().enumerate() {
            deviations[i] = if vertex >> bit & 1 == 1 { tolerances[i] } else { -tolerances[i] };
        }
        worst.note(result(&deviations), &deviations);
    }
    Ok(worst)
}

impl WorstCase {
    fn note(&mut self, value: Option<f64>, deviations: &[f64]) {
        let Some(value) = value.filter(|value| !value.is_nan()) else {
            self.undefined += 1;
            return;
        };
        let here = || Some(Extreme { value, deviations: deviations.to_vec() });
        if self.least.as_ref().is_none_or(|least| value < least.value) {
            self.least = here();
        }
        if self.greatest.as_ref().is_none_or(|greatest| value > greatest.value) {
            self.greatest = here();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_linear_result_has_the_same_worst_case_both_ways() {
        let (g, t) = ([2.0, -3.0, 0.5, 7.0], [0.1, 0.2, 0.3, 0.0]);
        let linear = |d: &[f64]| Some(g.iter().zip(d).map(|(g, d)| g * d).sum::<f64>());
        let worst = vertex_worst_case(&t, linear).unwrap();
        let greatest = worst.greatest.unwrap();
        assert!((greatest.value - linear_worst_case(&g, &t)).abs() < 1e-15);
        assert_eq!(greatest.deviations, [0.1, -0.2, 0.3, 0.0]);
        assert!((worst.least.unwrap().value + 0.95).abs() < 1e-15);
    }

    #[test]
    fn shares_sum_to_one() {
        let shares = variance_shares(&[1.0, -2.0], &[0.2, 0.1]);
        assert!((shares[0] - 0.5).abs() < 1e-15 && (shares[1] - 0.5).abs() < 1e-15);
        assert!((linear_sigma(&[1.0, -2.0], &[0.2, 0.1]) - 0.08f64.sqrt()).abs() < 1e-15);
        assert_eq!(variance_shares(&[1.0], &[0.0]), [0.0]);
    }

    #[test]
    fn odd_boxes_do_not_panic() {
        assert_eq!(vertex_worst_case(&[1.0; 17], |_| None), Err(TooManyVertices { inputs: 17 }));
        let none = vertex_worst_case(&[1.0; 2], |_| Some(f64::NAN)).unwrap();
        assert_eq!((none.least, none.undefined), (None, 4));
        assert_eq!(vertex_worst_case(&[], |_| Some(3.0)).unwrap().least.unwrap().value, 3.0);
    }
}
