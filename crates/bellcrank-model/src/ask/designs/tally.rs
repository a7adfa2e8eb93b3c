//! What is said about all rows, gathered row by row in bounded memory.

use std::collections::{BTreeMap, BinaryHeap, HashMap};

use bellcrank_results::{Column, ColumnStatistics, DesignFailure, ParetoFront, Table, Unit};
use bellcrank_study::sampling::mix;
use bellcrank_study::statistics::{Aim, Moments, ParetoFront as Front};

use super::columns::{Columns, DESIGN};
use super::worker::Row;

/// Rows that a report shows.
const SAMPLE: usize = 5000;
/// Designs of a front that a report shows.
pub(super) const FRONT: usize = 5000;
/// Kinds of failures that are told apart.
const KINDS: usize = 200;

/// Everything that is remembered of the rows so far. Their order matters, and is that of the numbers of the designs.
pub(super) struct Tally {
    columns: Columns,
    pub(super) done: u64,
    pub(super) failed: u64,
    statistics: Vec<Statistics>,
    /// The rows with the smallest keys: a random choice that depends on the numbers of the designs alone.
    sample: BinaryHeap<(u64, u64)>,
    sampled: HashMap<u64, Vec<f64>>,
    pareto: Option<Pareto>,
    failures: BTreeMap<String, DesignFailure>,
}

#[derive(Clone, Copy, Default)]
struct Statistics {
    moments: Moments,
    min: Option<(f64, u64)>,
    max: Option<(f64, u64)>,
}

struct Pareto {
    columns: [usize; 2],
    small: [bool; 2],
    front: Front,
    /// Rows that are or were on the front.
    rows: HashMap<u64, Vec<f64>>,
}

impl Tally {
    /// `pareto`: two responses, each made small (else large).
    pub(super) fn new(columns: &Columns, pareto: Option<[(usize, bool); 2]>) -> Tally {
        let pareto = pareto.map(|two| {
            let small = two.map(|(_, small)| small);
            let aims = small.map(|small| if small { Aim::Least } else { Aim::Greatest });
            let columns = two.map(|(response, _)| columns.inputs + response);
            Pareto { columns, small, front: Front::new(aims), rows: HashMap::new() }
        });
        Tally {
            columns: columns.clone(),
            done: 0,
            failed: 0,
            statistics: vec![Statistics::default(); columns.all.len()],
            sample: BinaryHeap::new(),
            sampled: HashMap::new(),
            pareto,
            failures: BTreeMap::new(),
        }
    }

    /// The next row.
    pub(super) fn push(&mut self, row: &Row) {
        let design = self.done;
        self.done += 1;
        self.statistics.iter_mut().zip(&row.numbers).for_each(|(all, &x)| all.push(x, design));
        self.choose(design, row);
        if row.reason.is_empty() {
            if let Some(pareto) = &mut self.pareto {
                pareto.push(design, row);
            }
        } else {
            self.fail(design, &row.reason);
        }
    }

    fn choose(&mut self, design: u64, row: &Row) {
        let key = mix(design);
        if self.sample.len() == SAMPLE {
            if self.sample.peek().is_some_and(|last| key >= last.0) {
                return;
            }
            if let Some((_, design)) = self.sample.pop() {
                self.sampled.remove(&design);
            }
        }
        self.sample.push((key, design));
        self.sampled.insert(design, row.numbers.clone());
    }

    fn fail(&mut self, design: u64, reason: &str) {
        self.failed += 1;
        let mut kind = without_numbers(reason);
        if self.failures.len() >= KINDS && !self.failures.contains_key(&kind) {
            kind = String::new();
        }
        let failure = self.failures.entry(kind).or_insert_with_key(|kind| DesignFailure {
            reason: if kind.is_empty() { "other reasons".to_owned() } else { reason.to_owned() },
            count: 0,
            first: design,
        });
        failure.count += 1;
    }

    /// Most frequent first.
    pub(super) fn failures(&self) -> Vec<DesignFailure> {
        let mut all: Vec<DesignFailure> = self.failures.values().cloned().collect();
        all.sort_by_key(|failure| (std::cmp::Reverse(failure.count), failure.first));
        all
    }

    pub(super) fn statistics(&self) -> Vec<ColumnStatistics> {
        let named = self.statistics.iter().zip(&self.columns.all);
        named.map(|(all, column)| all.told(column.name.clone(), column.unit.clone())).collect()
    }

    pub(super) fn sample(&self) -> Table {
        let mut designs: Vec<u64> = self.sampled.keys().copied().collect();
        designs.sort_unstable();
        self.table(&designs, &self.sampled)
    }

    /// The front, evenly thinned where it is long, and how many designs are on it.
    pub(super) fn front(&self) -> Option<(ParetoFront, usize)> {
        let pareto = self.pareto.as_ref()?;
        let mut designs: Vec<u64> = pareto.front.candidates().iter().map(|candidate| candidate.row).collect();
        if !pareto.small[0] {
            // The best comes first; the table rises.
            designs.reverse();
        }
        let count = designs.len();
        if count > FRONT {
            designs = (0..FRONT).map(|i| designs[i * (count - 1) / (FRONT - 1)]).collect();
        }
        let name = |i: usize| (self.columns.all[pareto.columns[i]].name.clone(), pareto.small[i]);
        Some((ParetoFront { objectives: [name(0), name(1)], front: self.table(&designs, &pareto.rows) }, count))
    }

    /// Rows as a table, SI.
    fn table(&self, designs: &[u64], rows: &HashMap<u64, Vec<f64>>) -> Table {
        let numbers = designs.iter().map(|&design| design as f64).collect();
        let mut columns = vec![Column { name: DESIGN.to_owned(), unit: Unit::one(), values: numbers }];
        columns.extend(self.columns.all.iter().enumerate().map(|(i, column)| {
            let si = |design: &u64| rows.get(design).map_or(f64::NAN, |row| row[i] * column.unit.factor);
            let values = designs.iter().map(si).collect();
            Column { name: column.name.clone(), unit: column.unit.clone(), values }
        }));
        Table { columns }
    }
}

impl Statistics {
    fn push(&mut self, x: f64, design: u64) {
        self.moments.push(x);
        if !x.is_finite() {
            return;
        }
        if self.min.is_none_or(|(least, _)| x < least) {
            self.min = Some((x, design));
        }
        if self.max.is_none_or(|(greatest, _)| x > greatest) {
            self.max = Some((x, design));
        }
    }

    /// SI.
    fn told(&self, name: String, unit: Unit) -> ColumnStatistics {
        let si = |x: f64| x * unit.factor;
        let extreme = |at: Option<(f64, u64)>| at.map_or((f64::NAN, 0), |(x, design)| (si(x), design));
        ColumnStatistics {
            name,
            min: extreme(self.min),
            max: extreme(self.max),
            mean: si(self.moments.mean()),
            deviation: si(self.moments.sigma()),
            unit,
        }
    }
}

impl Pareto {
    fn push(&mut self, design: u64, row: &Row) {
        let values = self.columns.map(|column| row.numbers[column]);
        if !self.front.offer(design, values) {
            return;
        }
        self.rows.insert(design, row.numbers.clone());
        if self.rows.len().is_power_of_two() && self.rows.len() > FRONT {
            let on: std::collections::HashSet<u64> = self.front.candidates().iter().map(|c| c.row).collect();
            self.rows.retain(|design, _| on.contains(design));
        }
    }
}

/// A reason without what differs from design to design.
fn without_numbers(reason: &str) -> String {
    let mut kind = String::with_capacity(reason.len());
    let mut last = ' ';
    let mut inside = false;
    for c in reason.chars() {
        // A digit behind a letter belongs to a name.
        let begins = !inside && c.is_ascii_digit() && !(last.is_alphanumeric() || last == '_');
        inside = if inside { c.is_ascii_digit() || matches!(c, '.' | 'e' | '+' | '-') } else { begins };
        if begins {
            if kind.ends_with('-') {
                kind.pop();
            }
            kind.push('#');
        }
        if !inside {
            kind.push(c);
        }
        last = c;
    }
    kind
}

#[cfg(test)]
mod tests {
    use super::without_numbers;

    #[test]
    fn reasons_that_differ_in_numbers_are_one() {
        let kind = without_numbers;
        assert_eq!(kind("joint.B.position = -12.5 deg: no way"), kind("joint.B.position = 1.5e-7 deg: no way"));
        assert_eq!(kind("link3 is open by 2 mm"), "link3 is open by # mm");
        assert_ne!(kind("link3 is open by 2 mm"), kind("link4 is open by 2 mm"));
    }
}
