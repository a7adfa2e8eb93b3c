//! The designs that no other beats in both of two objectives.

use std::collections::BTreeMap;

/// What is wanted of an objective.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Aim {
    /// The smaller the better.
    Least,
    /// The greater the better.
    Greatest,
}

/// A design on the front.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Candidate {
    /// The caller's number of the design.
    pub row: u64,
    /// Its two objectives.
    pub values: [f64; 2],
}

/// The non-dominated designs of all that were seen; only these are kept. A design is dominated if another is at least as
/// good in both objectives; of equals the one with the smallest row number stays, so the front does not depend on the order.
#[derive(Clone, Debug)]
pub struct ParetoFront {
    aims: [Aim; 2],
    /// By the first objective, the best first; the second then improves strictly.
    front: BTreeMap<u64, Candidate>,
}

impl ParetoFront {
    /// An empty front.
    #[must_use]
    pub fn new(aims: [Aim; 2]) -> Self {
        Self { aims, front: BTreeMap::new() }
    }

    /// Offers a design; returns whether it is on the front now. Values that are NaN are refused. Takes O(log n), and what
    /// it removes.
    pub fn offer(&mut self, row: u64, values: [f64; 2]) -> bool {
        if values.iter().any(|x| x.is_nan()) {
            return false;
        }
        let (key, second) = (cost(self.aims[0], values[0]), cost(self.aims[1], values[1]));
        let second_of = |c: &Candidate, aims: [Aim; 2]| cost(aims[1], c.values[1]);
        if let Some((&at, better)) = self.front.range(..=key).next_back() {
            let theirs = second_of(better, self.aims);
            let equal = at == key && theirs == second;
            if theirs <= second && !(equal && row < better.row) {
                return false;
            }
        }
        while let Some((&at, worse)) = self.front.range(key..).next() {
            if second_of(worse, self.aims) < second {
                break;
            }
            self.front.remove(&at);
        }
        self.front.insert(key, Candidate { row, values });
        true
    }

    /// Offers all designs of another front.
    pub fn merge(&mut self, other: &Self) {
        for candidate in other.front.values() {
            self.offer(candidate.row, candidate.values);
        }
    }

    /// The front, best in the first objective first.
    #[must_use]
    pub fn candidates(&self) -> Vec<Candidate> {
        self.front.values().copied().collect()
    }
}

/// An integer that orders numbers from best to worst.
fn cost(aim: Aim, x: f64) -> u64 {
    // Adding zero makes -0 and 0 equal.
    let bits = (x + 0.0).to_bits();
    let ascending = if bits >> 63 == 1 { !bits } else { bits | 1 << 63 };
    if aim == Aim::Least { ascending } else { !ascending }
}

/// Numbers of the non-dominated points, best in the first objective first. O(n log n).
#[must_use]
pub fn pareto_front(points: &[[f64; 2]], aims: [Aim; 2]) -> Vec<usize> {
    let mut front = ParetoFront::new(aims);
    for (row, point) in points.iter().enumerate() {
        front.offer(row as u64, *point);
    }
    front.candidates().iter().map(|c| c.row as usize).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::sampling::unit;

    fn dominated(points: &[[f64; 2]], i: usize, sign: [f64; 2]) -> bool {
        let p = points[i];
        points.iter().enumerate().any(|(j, q)| {
            let (a, b) = (sign[0] * (q[0] - p[0]), sign[1] * (q[1] - p[1]));
            a <= 0.0 && b <= 0.0 && (a < 0.0 || b < 0.0 || j < i)
        })
    }

    #[test]
    fn the_front_is_what_comparing_all_pairs_gives() {
        for (aims, sign) in [
            ([Aim::Least, Aim::Least], [1.0, 1.0]),
            ([Aim::Least, Aim::Greatest], [1.0, -1.0]),
            ([Aim::Greatest, Aim::Least], [-1.0, 1.0]),
            ([Aim::Greatest, Aim::Greatest], [-1.0, -1.0]),
        ] {
            for seed in 0..20 {
                // Coarse values, so that there are equals.
                let coarse = |i, j| (unit(seed, i, j) * 12.0).floor() - 6.0;
                let points: Vec<[f64; 2]> = (0..60).map(|i| [coarse(i, 0), coarse(i, 1)]).collect();
                let mut found = pareto_front(&points, aims);
                let mut mirrored = ParetoFront::new(aims);
                for i in (0..60).rev() {
                    mirrored.offer(i as u64, points[i]);
                }
                assert_eq!(mirrored.candidates().iter().map(|c| c.row as usize).collect::<Vec<_>>(), found);
                found.sort_unstable();
                let expected: Vec<usize> = (0..60).filter(|&i| !dominated(&points, i, sign)).collect();
                assert_eq!(found, expected);
            }
        }
    }

    #[test]
    fn odd_numbers_do_not_panic() {
        assert!(pareto_front(&[], [Aim::Least; 2]).is_empty());
        let points = [[f64::NAN, 1.0], [f64::INFINITY, 0.0], [0.0, -0.0], [-0.0, 0.0]];
        assert_eq!(pareto_front(&points, [Aim::Least; 2]), [2]);
    }
}
