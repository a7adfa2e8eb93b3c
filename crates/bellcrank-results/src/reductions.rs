//! A column as a few numbers.

/// A value (SI) and the row where it occurs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Extreme {
    /// SI value.
    pub value: f64,
    /// Row of the table, counted from 0; the first one where several are equal.
    pub row: usize,
}

/// What a column comes to over its rows; rows that are not finite do not count.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Reductions {
    /// Smallest value.
    pub min: Extreme,
    /// Largest value.
    pub max: Extreme,
    /// Largest less smallest, SI.
    pub range: f64,
    /// Root of the mean square over the rows, SI.
    pub rms: f64,
    /// Mean over the rows, SI.
    pub mean: f64,
    /// First finite value, SI.
    pub first: f64,
    /// Last finite value, SI.
    pub last: f64,
}

impl Reductions {
    /// The reductions of `values` (SI), or nothing when no value is finite.
    pub fn of(values: &[f64]) -> Option<Self> {
        let mut finite = values.iter().copied().enumerate().filter(|(_, value)| value.is_finite());
        let (row, value) = finite.next()?;
        let mut running = Running::start(row, value);
        finite.for_each(|(row, value)| running.add(row, value));
        Some(running.finish())
    }

    /// The extreme of the largest magnitude.
    pub fn peak(&self) -> Extreme {
        if self.min.value.abs() > self.max.value.abs() { self.min } else { self.max }
    }
}

struct Running {
    first: f64,
    last: f64,
    min: Extreme,
    max: Extreme,
    count: f64,
    /// Sum of the differences to `first`: a mean of large, nearly equal numbers keeps its digits.
    offset: f64,
    /// Largest magnitude so far and the sum of squares over its square: squares of huge or tiny
    /// numbers neither overflow nor vanish.
    scale: f64,
    squares: f64,
}

impl Running {
    fn start(row: usize, value: f64) -> Self {
        let here = Extreme { value, row };
        let squares = if value == 0.0 { 0.0 } else { 1.0 };
        let (first, last, min, max) = (value, value, here, here);
        Self { first, last, min, max, count: 1.0, offset: 0.0, scale: value.abs(), squares }
    }

    fn add(&mut self, row: usize, value: f64) {
        self.last = value;
        self.count += 1.0;
        self.offset += value - self.first;
        self.add_square(value.abs());
        if value < self.min.value {
            self.min = Extreme { value, row };
        }
        if value > self.max.value {
            self.max = Extreme { value, row };
        }
    }

    fn add_square(&mut self, size: f64) {
        if size > self.scale {
            let ratio = self.scale / size;
            self.squares = 1.0 + self.squares * ratio * ratio;
            self.scale = size;
        } else if size > 0.0 {
            let ratio = size / self.scale;
            self.squares += ratio * ratio;
        }
    }

    fn finish(self) -> Reductions {
        Reductions {
            min: self.min,
            max: self.max,
            range: self.max.value - self.min.value,
            rms: self.scale * (self.squares / self.count).sqrt(),
            mean: self.first + self.offset / self.count,
            first: self.first,
            last: self.last,
        }
    }
}

#[cfg(test)]
mod tests;
