//! Values of all parameters when some are given, and which follow which.

use super::ParameterSet;
use crate::Number;

impl ParameterSet {
    /// All values, with those of `fixed` (index, value) in place of their definitions and all that
    /// depend on them following. Derivatives: seed the chosen ones in `fixed`.
    #[must_use]
    pub fn evaluate<N: Number>(&self, fixed: &[(usize, N)]) -> Vec<N> {
        let mut values = Vec::new();
        self.evaluate_into(fixed, &mut values);
        values
    }

    /// The same into `values`, whatever it holds before. Allocates only while the capacity of
    /// `values` is below twice the number of parameters: the first time.
    pub fn evaluate_into<N: Number>(&self, fixed: &[(usize, N)], values: &mut Vec<N>) {
        let count = self.all.len();
        values.clear();
        values.resize(2 * count, N::from(f64::NAN));
        // The second half marks what is given: a value that is given may be NaN, a mark is not.
        for &(i, value) in fixed.iter().filter(|(i, _)| *i < count) {
            values[i] = value;
            values[count + i] = N::from(0.0);
        }
        for &i in &self.order {
            if values[count + i].value().is_nan() {
                values[i] = self.all[i].expression.eval(&values[..count], &[]);
            }
        }
        values.truncate(count);
    }

    /// Indices of the parameters whose values change with that of `index`, ascending, without itself.
    #[must_use]
    pub fn dependents(&self, index: usize) -> Vec<usize> {
        let mut changes = vec![false; self.all.len()];
        for &i in &self.order {
            changes[i] = i == index || self.all[i].expression.parameters().iter().any(|&used| changes[used]);
        }
        marked(&changes, index)
    }

    /// Indices of the parameters that the value of `index` is made of, ascending, without itself.
    #[must_use]
    pub fn dependencies(&self, index: usize) -> Vec<usize> {
        let mut used = vec![false; self.all.len()];
        for &i in self.order.iter().rev() {
            if i == index || used[i] {
                self.all[i].expression.parameters().into_iter().for_each(|below| used[below] = true);
            }
        }
        marked(&used, index)
    }

    /// Whether the value of `index` changes with that of `on`; not with itself.
    #[must_use]
    pub fn depends_on(&self, index: usize, on: usize) -> bool {
        self.dependencies(index).binary_search(&on).is_ok()
    }
}

fn marked(marks: &[bool], without: usize) -> Vec<usize> {
    (0..marks.len()).filter(|&i| marks[i] && i != without).collect()
}
