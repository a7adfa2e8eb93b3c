//! Where a sampled curve has its extremes, between the samples too.

/// A local maximum of a sampled curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Peak {
    /// Row; not whole between rows.
    pub(super) row: f64,
    pub(super) value: f64,
    /// The rows beside it when it lies inside; an extreme there has no slope along the rows.
    pub(super) inside: bool,
}

/// Local maxima of `sign` × samples, the highest first, at most `most`. A plateau counts once, where it begins.
pub(super) fn peaks(samples: &[f64], sign: f64, most: usize) -> Vec<Peak> {
    let at = |i: usize| sign * samples[i];
    let last = samples.len().saturating_sub(1);
    let top = |&i: &usize| (i == 0 || at(i) > at(i - 1)) && (i == last || at(i) >= at(i + 1));
    let peak = |i: usize| Peak { row: i as f64, value: samples[i], inside: i > 0 && i < last };
    let mut found: Vec<Peak> = (0..samples.len()).filter(top).map(peak).collect();
    found.sort_by(|a, b| (sign * b.value).total_cmp(&(sign * a.value)));
    found.truncate(most);
    found
}

/// Width at which the search ends, rows: the value is then right to rounding (its error is the square of it).
const FINE: f64 = 1e-7;
/// Evaluations at most.
const MOST: usize = 40;

/// Maximum of `sign` × f near the row `middle`, by successive parabolas safeguarded by golden sections (Brent 1973,
/// chapter 5). `None` when f cannot be evaluated on the way.
pub(super) fn climb(middle: f64, value: f64, sign: f64, mut f: impl FnMut(f64) -> Option<f64>) -> Option<(f64, f64)> {
    const GOLDEN: f64 = 0.381_966_011_250_105_2;
    let (mut a, mut b) = (middle - 1.0, middle + 1.0);
    // Best, second best and third best point with their values (made small).
    let (mut x, mut fx) = (middle, -sign * value);
    let (mut w, mut fw, mut v, mut fv) = (x, fx, x, fx);
    let (mut step, mut before) = (0.0_f64, 0.0_f64);
    for _ in 0..MOST {
        let centre = 0.5 * (a + b);
        if (x - centre).abs() <= 2.0 * FINE - 0.5 * (b - a) {
            break;
        }
        let (r, q) = ((x - w) * (fx - fv), (x - v) * (fx - fw));
        let (mut p, mut q2) = ((x - v) * q - (x - w) * r, 2.0 * (q - r));
        if q2 > 0.0 {
            p = -p;
        }
        q2 = q2.abs();
        let usual = before.abs() > FINE && p.abs() < (0.5 * q2 * before).abs() && p > q2 * (a - x) && p < q2 * (b - x);
        if usual {
            before = step;
            step = p / q2;
        } else {
            before = if x < centre { b - x } else { a - x };
            step = GOLDEN * before;
        }
        let u = if step.abs() >= FINE { x + step } else { x + FINE.copysign(step) };
        let fu = -sign * f(u)?;
        if fu <= fx {
            if u < x {
                b = x
            } else {
                a = x
            }
            (v, fv, w, fw, x, fx) = (w, fw, x, fx, u, fu);
        } else {
            if u < x {
                a = u
            } else {
                b = u
            }
            if fu <= fw || w == x {
                (v, fv, w, fw) = (w, fw, u, fu);
            } else if fu <= fv || v == x || v == w {
                (v, fv) = (u, fu);
            }
        }
    }
    Some((x, -sign * fx))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn peaks_are_found_at_ends_and_plateaus_once() {
        let samples = [3.0, 1.0, 2.0, 2.0, 0.0, 1.5];
        let rows: Vec<f64> = peaks(&samples, 1.0, 9).iter().map(|p| p.row).collect();
        assert_eq!(rows, [0.0, 2.0, 5.0]);
        let lows: Vec<f64> = peaks(&samples, -1.0, 9).iter().map(|p| p.row).collect();
        assert_eq!(lows, [4.0, 1.0]);
        assert_eq!(peaks(&[7.0; 4], 1.0, 9).len(), 1);
    }

    #[test]
    fn the_top_between_samples_is_found() {
        let f = |x: f64| 2.0 + (0.3 * (x - 4.37)).cos();
        let (row, value) = climb(4.0, f(4.0), 1.0, |x| Some(f(x))).expect("evaluates");
        assert!((row - 4.37).abs() < 1e-7, "{row}");
        assert!((value - 3.0).abs() < 1e-15);
        // A kink has a top as well.
        let (row, _) = climb(2.0, -0.3, 1.0, |x| Some(-(x - 2.3_f64).abs())).expect("evaluates");
        assert!((row - 2.3).abs() < 1e-6, "{row}");
    }
}
