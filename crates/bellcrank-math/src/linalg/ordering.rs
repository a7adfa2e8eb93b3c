//! An order of rows and columns that keeps a sparse square matrix near its diagonal.

use std::collections::VecDeque;

/// A permutation of rows and columns and the band it gives.
#[derive(Clone, Debug, Default)]
pub struct Ordering {
    /// `row[i]`: place of row `i` in the band.
    pub row: Vec<usize>,
    /// `column[j]`: place of column `j` in the band.
    pub column: Vec<usize>,
    /// Off-diagonals below.
    pub below: usize,
    /// Off-diagonals above.
    pub above: usize,
}

/// Reverse Cuthill–McKee on the graph of columns that share a row; rows then follow the mean place
/// of their columns. `rows[i]` lists the columns of row `i`. Cuthill & McKee (1969), George (1971).
pub fn band_ordering(rows: &[Vec<usize>], columns: usize) -> Ordering {
    let column = places(&cuthill_mckee(rows, columns), columns);
    let mut order: Vec<usize> = (0..rows.len()).collect();
    let key = |i: &usize| -> (usize, usize) {
        let sum: usize = rows[*i].iter().map(|&j| column[j]).sum();
        let first = rows[*i].iter().map(|&j| column[j]).min().unwrap_or(columns);
        (2 * sum / rows[*i].len().max(1), first)
    };
    order.sort_by_key(key);
    let row = places(&order, rows.len());
    let (mut below, mut above) = (0, 0);
    for (i, cols) in rows.iter().enumerate() {
        for &j in cols {
            below = below.max(row[i].saturating_sub(column[j]));
            above = above.max(column[j].saturating_sub(row[i]));
        }
    }
    Ordering { row, column, below, above }
}

fn places(order: &[usize], n: usize) -> Vec<usize> {
    let mut place = vec![0; n];
    order.iter().enumerate().for_each(|(k, &i)| place[i] = k);
    place
}

fn cuthill_mckee(rows: &[Vec<usize>], columns: usize) -> Vec<usize> {
    let graph = Graph::new(rows, columns);
    let mut seen = vec![false; columns];
    let mut order = Vec::with_capacity(columns);
    for j in 0..columns {
        if !seen[j] {
            let start = graph.far_from(j);
            graph.breadth_first(start, &mut seen, &mut order);
        }
    }
    order.reverse();
    order
}

/// Columns that share a row, least connected first.
struct Graph {
    near: Vec<Vec<usize>>,
}

impl Graph {
    fn new(rows: &[Vec<usize>], columns: usize) -> Self {
        let mut near = vec![Vec::new(); columns];
        for cols in rows {
            for &j in cols {
                near[j].extend(cols.iter().copied().filter(|&k| k != j));
            }
        }
        near.iter_mut().for_each(|n| {
            n.sort_unstable();
            n.dedup();
        });
        let degree: Vec<usize> = near.iter().map(Vec::len).collect();
        near.iter_mut().for_each(|n| n.sort_by_key(|&k| (degree[k], k)));
        Self { near }
    }
    /// A column at the far end of the component of `j`: two sweeps are enough to be near the rim.
    fn far_from(&self, j: usize) -> usize {
        let mut at = j;
        for _ in 0..2 {
            let (mut seen, mut order) = (vec![false; self.near.len()], Vec::new());
            self.breadth_first(at, &mut seen, &mut order);
            at = order.last().copied().unwrap_or(at);
        }
        at
    }
    fn breadth_first(&self, start: usize, seen: &mut [bool], order: &mut Vec<usize>) {
        let mut queue = VecDeque::from([start]);
        seen[start] = true;
        while let Some(j) = queue.pop_front() {
            order.push(j);
            for &k in &self.near[j] {
                if !std::mem::replace(&mut seen[k], true) {
                    queue.push_back(k);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_shuffled_chain_gets_a_narrow_band() {
        let n = 400;
        let shuffle = |k: usize| (k * 171 + 13) % n;
        let rows: Vec<Vec<usize>> =
            (0..n).map(|i| (i.saturating_sub(1)..(i + 2).min(n)).map(shuffle).collect()).collect();
        let order = band_ordering(&rows, n);
        assert!(order.below <= 3 && order.above <= 3, "{} {}", order.below, order.above);
    }
}
