//! Stress in every row by superposition: a few unit loads on one factorization.
//!
//! Pins are spread over their bores here, for the pressure of a pin is not linear in its force.

use bellcrank_fem::{Fault, Load, Six, Solution, Statics, Stress, von_mises};

use super::acting::{Acting, Field, RowLoads};
use super::problem::{Setup, field};
use super::regions::{Doubtful, Region};
use super::vector::V3;

/// A load of size one, and what it counts in a row.
#[derive(Clone, Copy, Debug)]
enum Unit {
    /// What the study itself puts on the body.
    Own,
    /// Force or moment at a pin.
    Pin {
        pin: usize,
        component: usize,
    },
    /// Weight less acceleration.
    Free(usize),
    Alpha(usize),
    /// Turning at one about an axis; about two at a time.
    Omega(usize),
    Omegas(usize, usize),
}

impl Unit {
    fn share(self, row: &RowLoads) -> f64 {
        let Field { free, omega, alpha } = &row.field;
        match self {
            Unit::Own => 1.0,
            Unit::Pin { pin, component } => row.wrenches[pin][component],
            Unit::Free(i) => free[i],
            Unit::Alpha(i) => alpha[i],
            // ω × (ω × r) is quadratic: what two axes have together is that of both less that of each.
            Unit::Omega(i) => omega[i] * (2.0 * omega[i] - omega.iter().sum::<f64>()),
            Unit::Omegas(i, j) => omega[i] * omega[j],
        }
    }

    fn loads(self, setup: &Setup<'_>) -> Vec<Load> {
        let unit = |axes: &[usize]| -> V3 { std::array::from_fn(|i| f64::from(axes.contains(&i))) };
        match self {
            Unit::Own => setup.own.clone(),
            Unit::Pin { pin, component } => vec![setup.unit(pin, component)],
            Unit::Free(i) => field(&Field { free: unit(&[i]), ..Field::default() }),
            Unit::Alpha(i) => field(&Field { alpha: unit(&[i]), ..Field::default() }),
            Unit::Omega(i) => field(&Field { omega: unit(&[i]), ..Field::default() }),
            Unit::Omegas(i, j) => field(&Field { omega: unit(&[i, j]), ..Field::default() }),
        }
    }
}

/// The largest von Mises stress of each region in each row, Pa; NaN where the machine has no solution.
pub(super) fn ranked(
    setup: &Setup<'_>,
    statics: &Statics<'_>,
    acting: &Acting,
    regions: &[Region],
    doubtful: &Doubtful,
    progress: &(dyn Fn(f64) -> bool + Sync),
) -> Result<Vec<Vec<f64>>, Vec<Fault>> {
    let mesh = setup.part.mesh;
    let trusted = |node: &u32| doubtful.at(mesh.nodes[*node as usize]).is_none();
    let nodes: Vec<Vec<u32>> =
        regions.iter().map(|region| region.nodes.iter().copied().filter(trusted).collect()).collect();
    let units = units(acting, !setup.own.is_empty());
    let at_nodes = |solution: &Solution| -> Vec<Six> {
        let stress = Stress::new(&setup.part, solution);
        nodes.iter().flatten().map(|&node| stress.nodal[node as usize]).collect()
    };
    // What is prescribed acts in every solution, and counts once.
    let prescribed = at_nodes(&statics.solve(&[])?);
    let mut answers: Vec<Vec<Six>> = Vec::with_capacity(units.len());
    for (done, unit) in units.iter().enumerate() {
        if !progress(done as f64 / units.len() as f64) {
            return Err(vec![Fault::Interrupted]);
        }
        let mut answer = at_nodes(&statics.solve(&unit.loads(setup))?);
        answer.iter_mut().zip(&prescribed).for_each(|(a, p)| (0..6).for_each(|i| a[i] -= p[i]));
        answers.push(answer);
    }
    let mut found = vec![vec![f64::NAN; acting.rows.len()]; regions.len()];
    for (index, row) in acting.rows.iter().enumerate() {
        let Some(row) = row else { continue };
        let shares: Vec<f64> = units.iter().map(|unit| unit.share(row)).collect();
        let mut next = 0;
        for (region, nodes) in found.iter_mut().zip(&nodes) {
            let range = next..next + nodes.len();
            next = range.end;
            region[index] =
                range.map(|at| von_mises(&summed(&answers, &shares, prescribed[at], at))).fold(0.0, f64::max);
        }
    }
    Ok(found)
}

fn summed(answers: &[Vec<Six>], shares: &[f64], prescribed: Six, at: usize) -> Six {
    let mut sum = prescribed;
    for (answer, share) in answers.iter().zip(shares) {
        (0..6).for_each(|i| sum[i] += share * answer[at][i]);
    }
    sum
}

/// The units that count in any row.
fn units(acting: &Acting, own: bool) -> Vec<Unit> {
    let mut all = Vec::new();
    for pin in 0..acting.pins.len() {
        all.extend((0..6).map(|component| Unit::Pin { pin, component }));
    }
    for i in 0..3 {
        all.extend([Unit::Free(i), Unit::Alpha(i), Unit::Omega(i)]);
        all.extend((i + 1..3).map(|j| Unit::Omegas(i, j)));
    }
    all.retain(|unit| acting.rows.iter().flatten().any(|row| unit.share(row) != 0.0));
    all.extend(own.then_some(Unit::Own));
    all
}

/// The row with the largest number of all, and that of each region.
pub(super) fn worst(ranked: &[Vec<f64>]) -> (Option<usize>, Vec<Option<usize>>) {
    let most = |values: &[f64]| {
        let known = values.iter().enumerate().filter(|(_, value)| value.is_finite());
        known.max_by(|a, b| a.1.total_cmp(b.1)).map(|(row, _)| row)
    };
    let each: Vec<Option<usize>> = ranked.iter().map(|region| most(region)).collect();
    let peak = |region: usize| each[region].map_or(f64::NEG_INFINITY, |row| ranked[region][row]);
    let first = (0..ranked.len()).max_by(|&a, &b| peak(a).total_cmp(&peak(b)));
    (first.and_then(|region| each[region]), each)
}

#[cfg(test)]
mod tests {
    use super::{Unit, units};
    use crate::elastic::acting::{Acting, Field, RowLoads};
    use crate::elastic::vector::cross;

    /// ω × (ω × r) of any ω is the sum of those of the units.
    #[test]
    fn turning_is_a_sum_of_units() {
        let omega = [0.7, -1.3, 2.1];
        let row = RowLoads { wrenches: Vec::new(), field: Field { omega, ..Field::default() } };
        let acting = Acting { rows: vec![Some(row.clone())], ..Acting::default() };
        let r = [0.3, -0.8, 1.7];
        let turned = |omega| cross(omega, cross(omega, r));
        let mut sum = [0.0; 3];
        for unit in units(&acting, false) {
            let one = match unit {
                Unit::Omega(i) => turned(std::array::from_fn(|k| f64::from(k == i))),
                Unit::Omegas(i, j) => turned(std::array::from_fn(|k| f64::from(k == i || k == j))),
                _ => continue,
            };
            (0..3).for_each(|k| sum[k] += unit.share(&row) * one[k]);
        }
        let exact = turned(omega);
        assert!((0..3).all(|k| (sum[k] - exact[k]).abs() < 1e-12), "{sum:?} {exact:?}");
    }
}
