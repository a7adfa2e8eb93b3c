//! How far results move when flexible bodies keep more modes, and when their meshes are finer.

use serde_json::{Value, json};

use crate::summary::quantity;
use crate::{Failure, Unit};

/// What was found.
#[derive(Clone, Debug)]
pub struct Convergence {
    /// The study.
    pub study: String,
    /// Its kind.
    pub kind: String,
    /// Largest change against the finest that counts as none, e.g. 0.01.
    pub tolerance: f64,
    /// What was watched.
    pub quantities: Vec<Watched>,
    /// Over the number of modes of each body, then over the size of elements.
    pub ladders: Vec<Ladder>,
    /// Sentences for the reader.
    pub notes: Vec<String>,
    /// Why nothing could be compared.
    pub failure: Option<Failure>,
}

/// A number that is watched.
#[derive(Clone, Debug, PartialEq)]
pub struct Watched {
    /// E.g. `largest drive.slide.force`.
    pub name: String,
    /// How it is shown.
    pub unit: Unit,
}

/// Finer and finer settings of one kind.
#[derive(Clone, Debug)]
pub struct Ladder {
    /// What changes.
    pub over: Over,
    /// Coarsest first.
    pub rungs: Vec<Rung>,
    /// Why there are no finer ones, where more were meant to be.
    pub ended: Option<String>,
}

/// What changes along a ladder.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Over {
    /// Modes with resting interfaces of each body.
    Modes,
    /// Sizes of elements, as multiples of those of the file.
    Mesh,
}

/// One setting.
#[derive(Clone, Debug)]
pub struct Rung {
    /// Modes of each body, or the multiple of the sizes of the file.
    pub setting: f64,
    /// Nodes of all meshes.
    pub nodes: usize,
    /// The watched numbers in their order, SI; `None` where there is none.
    pub values: Vec<Option<f64>>,
    /// Why the study stopped early.
    pub failure: Option<String>,
    /// Wall time of the study, without the reduction.
    pub seconds: f64,
}

impl Ladder {
    /// Change of a watched number against the finest, relative to it. `None` where one of them is missing.
    pub fn change(&self, rung: usize, quantity: usize) -> Option<f64> {
        let value = |rung: &Rung| *rung.values.get(quantity)?;
        let (own, finest) = (value(self.rungs.get(rung)?)?, value(self.rungs.last()?)?);
        if own == finest { Some(0.0) } else { Some((own - finest) / finest.abs()) }
    }

    /// Largest change of all watched numbers; `None` where the study stopped early here or at the finest, or a number is
    /// missing.
    pub fn largest(&self, rung: usize) -> Option<f64> {
        let whole = |rung: &Rung| rung.failure.is_none();
        if !(whole(self.rungs.get(rung)?) && whole(self.rungs.last()?)) {
            return None;
        }
        let count = self.rungs.last()?.values.len();
        let known = |quantity: &usize| self.rungs.last().is_some_and(|last| last.values[*quantity].is_some());
        (0..count).filter(known).try_fold(0.0_f64, |most, quantity| Some(most.max(self.change(rung, quantity)?.abs())))
    }

    /// The coarsest setting from which on everything stays within the tolerance of the finest. `None` where only the
    /// finest does: nothing says that it has converged.
    pub fn enough(&self, tolerance: f64) -> Option<usize> {
        let within = |rung: &usize| self.largest(*rung).is_some_and(|change| change <= tolerance);
        let last = self.rungs.len().checked_sub(1)?;
        let first = (0..=last).rev().take_while(within).last()?;
        (first < last).then_some(first)
    }
}

impl Convergence {
    /// As data.
    pub fn json(&self) -> Value {
        let failure = self.failure.as_ref().map(|why| json!({ "message": why.message, "hints": why.hints }));
        json!({
            "study": self.study,
            "kind": self.kind,
            "tolerance": self.tolerance,
            "ladders": self.ladders.iter().map(|ladder| self.ladder(ladder)).collect::<Vec<_>>(),
            "notes": self.notes,
            "failure": failure,
        })
    }

    fn ladder(&self, of: &Ladder) -> Value {
        let enough = of.enough(self.tolerance);
        json!({
            "over": match of.over { Over::Modes => "modes", Over::Mesh => "mesh" },
            "converged": enough.is_some(),
            "enough": enough.map(|rung| of.rungs[rung].setting),
            "ended": of.ended,
            "rungs": (0..of.rungs.len()).map(|rung| self.rung(of, rung)).collect::<Vec<_>>(),
        })
    }

    fn rung(&self, of: &Ladder, place: usize) -> Value {
        let rung = &of.rungs[place];
        let one = |(index, watched): (usize, &Watched)| {
            let value = rung.values.get(index).copied().flatten();
            json!({
                "name": watched.name,
                "value": value.map(|value| quantity(value, &watched.unit)),
                "change": of.change(place, index),
            })
        };
        json!({
            "setting": rung.setting,
            "nodes": rung.nodes,
            "values": self.quantities.iter().enumerate().map(one).collect::<Vec<_>>(),
            "largest_change": of.largest(place),
            "failure": rung.failure,
            "seconds": rung.seconds,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn ladder(values: &[[f64; 2]]) -> Ladder {
        let rung = |(place, values): (usize, &[f64; 2])| Rung {
            setting: place as f64,
            nodes: 100,
            values: values.iter().copied().map(Some).collect(),
            failure: None,
            seconds: 0.1,
        };
        Ladder { over: Over::Modes, rungs: values.iter().enumerate().map(rung).collect(), ended: None }
    }

    #[test]
    fn enough_is_the_first_of_those_that_stay_near_the_finest() {
        // The second is near by chance: the third is not.
        let found = ladder(&[[90.0, -4.0], [100.4, -4.0], [95.0, -4.0], [99.6, -4.02], [100.1, -4.01], [100.0, -4.0]]);
        assert_eq!(found.enough(0.01), Some(3));
        assert_eq!(found.enough(0.06), Some(1));
        assert_eq!(found.enough(0.001), None);
        assert!((found.largest(3).expect("a change") - 0.005).abs() < 1e-12);
        assert!((found.change(0, 0).expect("a change") + 0.1).abs() < 1e-12);
    }

    #[test]
    fn nothing_is_recommended_by_halves() {
        assert_eq!(ladder(&[[1.0, 2.0]]).enough(0.1), None);
        let mut found = ladder(&[[1.0, 2.0], [1.0, 2.0], [1.0, 2.0]]);
        assert_eq!(found.enough(0.1), Some(0));
        found.rungs[1].failure = Some("stopped".to_owned());
        assert_eq!(found.enough(0.1), None);
        found.rungs[1].failure = None;
        found.rungs[0].values[1] = None;
        assert_eq!(found.enough(0.1), Some(1));
        let zero = ladder(&[[0.1, 0.0], [0.0, 0.0]]);
        assert_eq!((zero.change(1, 0), zero.enough(0.1)), (Some(0.0), None));
    }
}
