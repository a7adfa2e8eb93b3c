//! One step in time: its two ends, its slopes, and what lies between.

use super::dop853::{EXTENSION, SLOPES};

/// What interpolates the step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Between {
    /// Cubic Hermite polynomials from the slopes at both ends.
    Hermite,
    /// The continuous extension; `ready` once its slopes are there.
    Extension { ready: bool },
}

/// A step over positions and velocities y = (q, v), nq + nv numbers.
#[derive(Clone, Debug)]
pub(crate) struct Step {
    /// Beginning and end, s.
    pub(crate) t0: f64,
    pub(crate) t1: f64,
    pub(crate) y0: Vec<f64>,
    pub(crate) y1: Vec<f64>,
    /// Where the next step begins: the end, or an event before it.
    pub(crate) end: f64,
    pub(crate) y_end: Vec<f64>,
    /// End before the projection on the constraints.
    pub(crate) raw: Vec<f64>,
    /// Slopes ẏ, one after another.
    pub(crate) slopes: Vec<f64>,
    extension: Vec<f64>,
    pub(crate) between: Between,
    /// Length wished for the next step, s.
    pub(crate) wished: f64,
    /// Unit of each number in the error; 0 leaves it out.
    pub(crate) unit: Vec<f64>,
    /// Argument at hand.
    pub(crate) y: Vec<f64>,
    /// Argument of the last stage, for the test of stiffness.
    pub(crate) last_argument: Vec<f64>,
    /// Successive signs of stiffness, and of none.
    pub(crate) stiff: usize,
    pub(crate) calm: usize,
    /// Slopes are taken on the constraints: near poses where these fade.
    pub(crate) projects: bool,
    /// The step at hand is to pass such a pose.
    pub(crate) over: bool,
    /// The implicit method has the word.
    pub(crate) implicit: bool,
    /// The first slope is still to be evaluated: after events and breaks.
    pub(crate) stale: bool,
    /// The function that changed its sign at the end of the step.
    pub(crate) crossing: Option<usize>,
}

impl Step {
    pub(crate) fn new(n: usize) -> Self {
        Self {
            t0: 0.0,
            t1: 0.0,
            y0: vec![0.0; n],
            y1: vec![0.0; n],
            end: 0.0,
            y_end: vec![0.0; n],
            raw: vec![0.0; n],
            slopes: vec![0.0; n * SLOPES],
            extension: vec![0.0; 7 * n],
            between: Between::Hermite,
            wished: 0.0,
            unit: vec![0.0; n],
            y: vec![0.0; n],
            last_argument: vec![0.0; n],
            stiff: 0,
            calm: 0,
            projects: false,
            over: false,
            implicit: false,
            stale: true,
            crossing: None,
        }
    }

    pub(crate) fn slope(&self, s: usize) -> &[f64] {
        let n = self.y0.len();
        &self.slopes[s * n..(s + 1) * n]
    }
    pub(crate) fn slope_mut(&mut self, s: usize) -> &mut [f64] {
        let n = self.y0.len();
        &mut self.slopes[s * n..(s + 1) * n]
    }

    /// `y = y0 + h Σ c k`.
    #[inline]
    pub(crate) fn combine(&mut self, h: f64, row: super::dop853::Row) {
        let n = self.y0.len();
        self.y.copy_from_slice(&self.y0);
        for &(s, c) in row {
            let slope = &self.slopes[s * n..(s + 1) * n];
            let hc = h * c;
            self.y.iter_mut().zip(slope).for_each(|(y, k)| *y += hc * k);
        }
    }

    /// The step ends at its end.
    pub(crate) fn end_whole(&mut self) {
        self.end = self.t1;
        self.y_end.copy_from_slice(&self.y1);
        self.crossing = None;
    }

    /// The next step begins where this one ends.
    pub(crate) fn go_on(&mut self) {
        self.t0 = self.end;
        self.y0.copy_from_slice(&self.y_end);
        let n = self.y0.len();
        self.slopes.copy_within(super::dop853::STAGES * n..(super::dop853::STAGES + 1) * n, 0);
    }

    /// Terms of the continuous extension from all slopes.
    pub(crate) fn extend(&mut self) {
        let (n, h) = (self.y0.len(), self.t1 - self.t0);
        for i in 0..n {
            let (change, first) = (self.raw[i] - self.y0[i], self.slopes[i]);
            let last = self.slopes[super::dop853::STAGES * n + i];
            self.extension[i] = change;
            self.extension[n + i] = h * first - change;
            self.extension[2 * n + i] = 2.0 * change - h * (first + last);
            for (d, row) in EXTENSION.iter().enumerate() {
                let sum: f64 = row.iter().map(|&(s, c)| c * self.slopes[s * n + i]).sum();
                self.extension[(3 + d) * n + i] = h * sum;
            }
        }
        self.between = Between::Extension { ready: true };
    }

    /// `y` at a time of the step.
    pub(crate) fn interpolate(&mut self, time: f64) {
        let h = self.t1 - self.t0;
        let x = if h > 0.0 { ((time - self.t0) / h).clamp(0.0, 1.0) } else { 1.0 };
        match self.between {
            Between::Extension { ready: true } => self.interpolate_extension(x),
            _ => self.interpolate_hermite(x, h),
        }
    }

    fn interpolate_extension(&mut self, x: f64) {
        let n = self.y0.len();
        for i in 0..n {
            let mut y = 0.0;
            for term in (0..7).rev() {
                y += self.extension[term * n + i];
                y *= if term % 2 == 0 { x } else { 1.0 - x };
            }
            self.y[i] = self.y0[i] + y;
        }
    }

    fn interpolate_hermite(&mut self, x: f64, h: f64) {
        let n = self.y0.len();
        let z = 1.0 - x;
        for i in 0..n {
            let (k0, k1) = (self.slopes[i], self.slopes[super::dop853::STAGES * n + i]);
            let (y0, y1) = (self.y0[i], self.y1[i]);
            let d = y1 - y0;
            self.y[i] = z * y0 + x * y1 + x * z * ((2.0 * x - 1.0) * d + h * (z * k0 - x * k1));
        }
    }
}
