//! Rainflow counting: which closed loops of stress a history holds.
//!
//! Source: ASTM E1049-85 (2017), 5.4.4 and 5.4.5; the four-point form: C. Amzallag et al., Int. J. Fatigue 16 (1994) 287.

/// A counted cycle.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cycle {
    /// Highest less lowest value.
    pub range: f64,
    /// Middle of them.
    pub mean: f64,
    /// 1 for a closed cycle, ½ for a half of one.
    pub count: f64,
}

/// What becomes of the ranges that the history leaves open.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Residue {
    /// Each is half a cycle (ASTM E1049-85, 5.4.4).
    Half,
    /// The history repeats without end, so that they close: what one more repeat closes is counted
    /// (ASTM E1049-85, 5.4.5).
    Repeated,
}

/// Counts as values come. Memory: the open ranges only.
#[derive(Clone, Debug, Default)]
pub struct Rainflow {
    /// Turning points that no closed cycle has used; the last one may still move on.
    open: Vec<f64>,
}

impl Cycle {
    fn between(a: f64, b: f64, count: f64) -> Self {
        Self { range: (a - b).abs(), mean: 0.5 * (a + b), count }
    }

    /// Half the range.
    pub fn amplitude(&self) -> f64 {
        0.5 * self.range
    }

    /// Highest value.
    pub fn highest(&self) -> f64 {
        self.mean + self.amplitude()
    }

    /// Lowest value.
    pub fn lowest(&self) -> f64 {
        self.mean - self.amplitude()
    }
}

impl Rainflow {
    /// Nothing counted yet.
    pub fn new() -> Self {
        Self::default()
    }

    /// All cycles of a history that is finite numbers, in the order in which they close.
    pub fn count(history: impl IntoIterator<Item = f64>, residue: Residue) -> Vec<Cycle> {
        let (mut rainflow, mut cycles) = (Self::new(), Vec::new());
        history.into_iter().for_each(|value| rainflow.push(value, |cycle| cycles.push(cycle)));
        rainflow.finish(residue, |cycle| cycles.push(cycle));
        cycles
    }

    /// The next value; `closed` takes the cycles that it closes.
    pub fn push(&mut self, value: f64, mut closed: impl FnMut(Cycle)) {
        self.turn(value);
        // The inner of three ranges is closed when neither neighbour is smaller.
        while let [.., a, b, c, d] = self.open[..] {
            let inner = (c - b).abs();
            if inner > (d - c).abs() || inner > (b - a).abs() {
                break;
            }
            closed(Cycle::between(b, c, 1.0));
            let last = self.open.len() - 1;
            self.open.drain(last - 2..last);
        }
    }

    /// Extends the last range or begins another one.
    fn turn(&mut self, value: f64) {
        match self.open[..] {
            [.., last] if last == value => {}
            [.., before, last] if (last > before) == (value > last) => {
                let end = self.open.len() - 1;
                self.open[end] = value;
            }
            _ => self.open.push(value),
        }
    }

    /// End of the history: what is open is counted as said, and the next history may begin.
    pub fn finish(&mut self, residue: Residue, mut cycles: impl FnMut(Cycle)) {
        match residue {
            Residue::Half => self.open.windows(2).for_each(|pair| cycles(Cycle::between(pair[0], pair[1], 0.5))),
            Residue::Repeated => {
                let again = self.open.clone();
                again.into_iter().for_each(|value| self.push(value, &mut cycles));
            }
        }
        self.open.clear();
    }
}

/// Counts by amplitude in `classes` of equal width up to the largest: upper end of each class and the cycles in it.
pub fn spectrum(cycles: &[Cycle], classes: usize) -> Vec<(f64, f64)> {
    let largest = cycles.iter().map(Cycle::amplitude).fold(0.0, f64::max);
    let width = largest / classes.max(1) as f64;
    let mut bins: Vec<(f64, f64)> = (1..=classes).map(|k| (width * k as f64, 0.0)).collect();
    for cycle in cycles.iter().filter(|cycle| cycle.range > 0.0) {
        // An amplitude on the border belongs to the class below it.
        let class = (cycle.amplitude() / width).ceil() as usize;
        if let Some(bin) = bins.get_mut(class.clamp(1, classes.max(1)) - 1) {
            bin.1 += cycle.count;
        }
    }
    bins
}
