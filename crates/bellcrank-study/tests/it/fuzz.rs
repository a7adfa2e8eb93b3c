//! Random problems: what converges is an optimum, what is nonsense ends without a panic.

use bellcrank_study::nlp::{Evaluation, Function, Options, Piece, Problem, Relation, Status, Undefined, solve};
use bellcrank_study::sampling::unit;

/// Convex: quadratic pieces, linear and quadratic constraints that hold at zero, some bounds, some equalities.
struct Convex {
    seed: u64,
    n: usize,
    pieces: usize,
    bounds: Vec<(f64, f64)>,
    relations: Vec<Relation>,
}

impl Convex {
    fn new(seed: u64) -> Self {
        let pick = |j, below: usize| (unit(seed, 1, j) * below as f64) as usize;
        let n = 1 + pick(0, 6);
        let bound = |j: usize| {
            let (l, u) = (-unit(seed, 2, j as u64), unit(seed, 3, j as u64) * 2.0);
            match pick(10 + j as u64, 4) {
                0 => (l, u),
                1 => (l, f64::INFINITY),
                2 => (f64::NEG_INFINITY, u),
                _ => (f64::NEG_INFINITY, f64::INFINITY),
            }
        };
        let mut relations = vec![Relation::AtMostZero; pick(1, 5)];
        if n > 2 && pick(2, 2) == 0 {
            relations.push(Relation::Zero);
        }
        Self { seed, n, pieces: 1 + pick(3, 4), bounds: (0..n).map(bound).collect(), relations }
    }

    fn random(&self, row: u64, j: usize) -> f64 {
        2.0 * unit(self.seed, row, j as u64) - 1.0
    }

    /// offset + b·x + Σ w (x − m)², convex for w ≥ 0.
    fn quadratic(&self, row: u64, x: &[f64], offset: f64, curved: f64) -> Piece {
        let terms = (0..self.n).map(|j| {
            let (b, m) = (self.random(row, j), self.random(row + 1, j));
            let w = curved * (0.05 + unit(self.seed, row + 2, j as u64));
            (b * x[j] + w * ((x[j] - m).powi(2) - m * m), b + 2.0 * w * (x[j] - m))
        });
        let (values, gradient): (Vec<f64>, Vec<f64>) = terms.unzip();
        Piece { value: offset + values.iter().sum::<f64>(), gradient }
    }
}

impl Problem for Convex {
    fn variables(&self) -> usize {
        self.n
    }
    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }
    fn relations(&self) -> &[Relation] {
        &self.relations
    }
    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Undefined> {
        assert!(x.iter().zip(&self.bounds).all(|(x, b)| *x >= b.0 && *x <= b.1));
        let pieces =
            (0..self.pieces).map(|k| self.quadratic(100 + 10 * k as u64, x, self.random(50, k), 1.0)).collect();
        let constraint = |(i, r): (usize, &Relation)| {
            let row = 1000 + 10 * i as u64;
            let one = |k: u64| match r {
                Relation::Zero => self.quadratic(row, x, 0.0, 0.0),
                Relation::AtMostZero => self.quadratic(row + k, x, -0.3 * unit(self.seed, row, 99), (i % 2) as f64),
            };
            let count = if *r == Relation::Zero { 1 } else { 1 + i as u64 % 2 };
            Function { pieces: (0..count).map(|k| one(5 * k)).collect() }
        };
        let constraints = self.relations.iter().enumerate().map(constraint).collect();
        Ok(Evaluation { objective: Function { pieces }, constraints })
    }
}

#[test]
fn convex_problems_converge_to_one_optimum_from_everywhere() {
    let (mut evaluations, mut wrong) = (0, Vec::new());
    for seed in 0..400 {
        let mut problem = Convex::new(seed);
        let mut optimum = f64::NAN;
        for start in 0..3 {
            let x: Vec<f64> = (0..problem.n).map(|j| 3.0 * problem.random(9000 + start, j)).collect();
            let s = solve(&mut problem, &x, &Options::default()).unwrap();
            evaluations += s.evaluations;
            let other = (s.objective - optimum).abs() > 1e-7 * (1.0 + s.objective.abs());
            if s.status != Status::Converged || s.kkt.worst() > 1e-7 || other {
                wrong.push((seed, start, s.status, s.evaluations, s.kkt.worst(), s.objective - optimum));
            }
            optimum = s.objective;
        }
    }
    println!("{:.1} evaluations in the mean, wrong: {wrong:?}", f64::from(evaluations as u32) / 1200.0);
    assert!(wrong.is_empty());
}

/// Answers whatever comes to mind.
struct Nonsense {
    seed: u64,
    calls: u64,
    bounds: Vec<(f64, f64)>,
    relations: Vec<Relation>,
}

impl Nonsense {
    fn number(&self, place: u64) -> f64 {
        let odd = [f64::NAN, f64::INFINITY, 1e300, -1e300, 1e-300, 0.0, -0.0, 1e17];
        let u = unit(self.seed ^ (self.calls << 20), place, 0);
        let k = (u * 100.0) as usize;
        if self.seed.is_multiple_of(3) && k < odd.len() {
            odd[k]
        } else {
            (u - 0.5) * 10f64.powi((place % 7) as i32 - 3)
        }
    }
}

impl Problem for Nonsense {
    fn variables(&self) -> usize {
        self.bounds.len()
    }
    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }
    fn relations(&self) -> &[Relation] {
        &self.relations
    }
    fn evaluate(&mut self, _: &[f64]) -> Result<Evaluation, Undefined> {
        self.calls += 1;
        let n = self.bounds.len();
        let count = |place: u64| 1 + (unit(self.seed, self.calls, place) * 3.0) as u64;
        let function = |place: u64, single: bool| {
            let piece = |k: u64| Piece {
                value: self.number(place + 31 * k),
                gradient: (0..n as u64).map(|j| self.number(place + 31 * k + j + 1)).collect(),
            };
            Function { pieces: (0..if single { 1 } else { count(place) }).map(piece).collect() }
        };
        let constraints = self.relations.iter().enumerate();
        let constraints = constraints.map(|(i, r)| function(1000 * (i as u64 + 1), *r == Relation::Zero)).collect();
        Ok(Evaluation { objective: function(0, false), constraints })
    }
}

#[test]
fn nonsense_ends_without_a_panic() {
    for seed in 0..150 {
        let n = 1 + seed as usize % 4;
        let bound =
            |j: u64| [(-1.0, 1.0), (0.0, f64::INFINITY), (-1e300, 1e300), (2.0, 2.0)][((seed / 4 + j) % 4) as usize];
        let relations = [Relation::AtMostZero, Relation::Zero, Relation::AtMostZero];
        let mut problem = Nonsense {
            seed,
            calls: 0,
            bounds: (0..n as u64).map(bound).collect(),
            relations: relations[..seed as usize % 4].to_vec(),
        };
        let s = solve(&mut problem, &vec![0.3; n], &Options { iterations: 50, ..Options::default() }).unwrap();
        assert!(s.x.iter().all(|x| x.is_finite()) && s.evaluations < 5000, "{seed}: {s:?}");
    }
}
