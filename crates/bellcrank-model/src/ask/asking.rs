//! An asking study with everything around it.

use bellcrank_doc::{Dimension, Parameter};
use bellcrank_multibody::Coordinate;
use bellcrank_results::Unit;

use crate::RunOptions;
use crate::design::{Ask, Design, Study, Task};
use crate::run::Namer;
use crate::trial::{Asked, Plain, Trial};

/// An asking study, the study that it asks, and how it is run.
#[derive(Clone, Copy)]
pub(crate) struct Asking<'d> {
    pub(crate) design: &'d Design,
    pub(crate) study: &'d Study,
    /// The study that gives the numbers.
    pub(crate) of: &'d Study,
    pub(crate) ask: &'d Ask,
    pub(crate) options: &'d RunOptions,
}

impl<'d> Asking<'d> {
    /// A machine to try designs on.
    pub(crate) fn trial(&self, asked: Asked) -> Trial<'d> {
        Trial::new(self.design, self.of, &self.study.parameters, &self.ask.signals, asked)
            .deforming(self.study.flexible)
    }

    /// The same of a study that only its own run can solve.
    pub(crate) fn plain(&self, asked: Asked) -> Plain<'d> {
        Plain::new(self.design, self.of, &self.study.parameters, self.study.flexible, &self.ask.signals, asked)
    }

    /// Coordinates that rest where assembly puts them: neither the study nor a start says where.
    pub(crate) fn unplaced(&self) -> Vec<String> {
        let (Task::Motion { holds, .. } | Task::Statics { holds, .. }) = &self.of.task else { return Vec::new() };
        let start = |c: Coordinate| self.design.joints.get(c.joint.0)?.start.get(c.index)?.as_ref();
        let unplaced = holds.iter().filter(|hold| hold.at.is_none() && start(hold.coordinate).is_none());
        unplaced.map(|hold| Namer::new(self.design).coordinate(hold.coordinate)).collect()
    }

    /// Threads to use; none asked for is one a core.
    pub(crate) fn threads(&self) -> usize {
        match self.options.threads {
            0 => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            threads => threads,
        }
    }

    pub(crate) fn parameter(&self, index: usize) -> &'d Parameter {
        &self.study.parameters.all()[index]
    }

    /// SI value in this study.
    pub(crate) fn value(&self, index: usize) -> f64 {
        self.study.parameters.values()[index]
    }

    /// The unit a parameter is shown in: that of the file where it is written with one.
    pub(crate) fn parameter_unit(&self, index: usize) -> Unit {
        self.unit(self.parameter(index).dimension)
    }

    pub(crate) fn unit(&self, dimension: Dimension) -> Unit {
        self.design.units.of_dimension(dimension)
    }

    /// SI unit of the derivative of something by something, e.g. `N/m`.
    pub(crate) fn derivative_unit(of: Dimension, by: Dimension) -> Unit {
        Unit::new(quotient(&symbol(of), &symbol(by)), 1.0)
    }
}

fn symbol(of: Dimension) -> String {
    if of.is_none() { String::new() } else { of.unit() }
}

fn quotient(of: &str, by: &str) -> String {
    let wrapped = |unit: &str| if unit.contains(['*', '/']) { format!("({unit})") } else { unit.to_owned() };
    match (of, by) {
        (of, "") => of.to_owned(),
        ("", by) => format!("1/{}", wrapped(by)),
        (of, by) => format!("{}/{}", if of.contains('/') { wrapped(of) } else { of.to_owned() }, wrapped(by)),
    }
}

#[cfg(test)]
mod tests {
    use super::quotient;

    #[test]
    fn quotients_of_units_read_as_people_write_them() {
        assert_eq!(quotient("N", "m"), "N/m");
        assert_eq!(quotient("N*m", "kg"), "N*m/kg");
        assert_eq!(quotient("N", "N/m"), "N/(N/m)");
        assert_eq!(quotient("", "m"), "1/m");
        assert_eq!(quotient("m/s", "m"), "(m/s)/m");
        assert_eq!(quotient("rad", ""), "rad");
    }
}
