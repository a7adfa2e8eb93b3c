//! A full factorial grid whose rows are computed from their numbers.

/// Some levels in every dimension, all combinations. The last dimension turns fastest. Without dimensions there is one empty
/// row; with a dimension of no levels there is none.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Grid {
    levels: Vec<usize>,
    rows: u64,
}

impl Grid {
    /// So many levels in each dimension; `None` if the number of rows exceeds 64 bits.
    #[must_use]
    pub fn new(levels: &[usize]) -> Option<Self> {
        let rows = levels.iter().try_fold(1u64, |rows, &n| rows.checked_mul(u64::try_from(n).ok()?))?;
        Some(Self { levels: levels.to_vec(), rows })
    }

    /// The number of rows.
    #[must_use]
    pub fn rows(&self) -> u64 {
        self.rows
    }

    /// Which level each dimension has in a row; `None` beyond the last.
    #[must_use]
    pub fn row(&self, row: u64) -> Option<Vec<usize>> {
        let mut rest = (row < self.rows).then_some(row)?;
        let mut out = vec![0; self.levels.len()];
        for (place, &n) in out.iter_mut().zip(&self.levels).rev() {
            *place = (rest % n as u64) as usize;
            rest /= n as u64;
        }
        Some(out)
    }

    /// The row as points of the unit cube: the first level at 0, the last at 1, a single one at ½.
    #[must_use]
    pub fn point(&self, row: u64) -> Option<Vec<f64>> {
        let share = |(&k, &n): (&usize, &usize)| if n > 1 { k as f64 / (n - 1) as f64 } else { 0.5 };
        Some(self.row(row)?.iter().zip(&self.levels).map(share).collect())
    }

    /// All rows from one on.
    pub fn rows_from(&self, first: u64) -> impl Iterator<Item = Vec<usize>> {
        (first..self.rows).filter_map(|row| self.row(row))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_combination_comes_once_and_resuming_gives_the_same() {
        let grid = Grid::new(&[2, 3, 2]).unwrap();
        let all: Vec<_> = grid.rows_from(0).collect();
        assert_eq!((all.len(), all[0].clone(), all[11].clone()), (12, vec![0, 0, 0], vec![1, 2, 1]));
        assert!(all.windows(2).all(|pair| pair[0] < pair[1]));
        assert_eq!(grid.rows_from(7).collect::<Vec<_>>(), all[7..]);
        assert_eq!(grid.point(11), Some(vec![1.0, 1.0, 1.0]));
        assert_eq!(grid.row(12), None);
    }

    #[test]
    fn odd_grids_do_not_panic() {
        assert_eq!(Grid::new(&[]).unwrap().row(0), Some(vec![]));
        assert_eq!(Grid::new(&[3, 0]).unwrap().row(0), None);
        assert_eq!(Grid::new(&[1]).unwrap().point(0), Some(vec![0.5]));
        assert_eq!(Grid::new(&[usize::MAX, 2]), None);
    }
}
