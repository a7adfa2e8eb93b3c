//! The columns of a sweep: parameters, then responses.

use bellcrank_results::{RowColumn, RowKind, Unit};

use super::super::Asking;
use crate::design::Designs;

/// The column of the number of a design.
pub(super) const DESIGN: &str = "design";
/// The column that says why a design has no result.
pub(super) const REASON: &str = "reason";

/// A column of numbers.
#[derive(Clone, Debug)]
pub(super) struct Named {
    pub(super) name: String,
    pub(super) unit: Unit,
}

/// The columns of parameters and responses.
#[derive(Clone, Debug)]
pub(super) struct Columns {
    pub(super) all: Vec<Named>,
    /// How many are parameters.
    pub(super) inputs: usize,
}

impl Columns {
    pub(super) fn new(asking: &Asking<'_>, question: &Designs) -> Columns {
        let input =
            |index: usize| Named { name: asking.parameter(index).name.clone(), unit: asking.parameter_unit(index) };
        let mut all: Vec<Named> = question.vary.iter().map(|varied| input(varied.parameter)).collect();
        let inputs = all.len();
        all.extend(
            question
                .responses
                .iter()
                .map(|one| Named { name: one.name.clone(), unit: asking.unit(one.response.value.dimension()) }),
        );
        Columns { all, inputs }
    }

    /// Columns of a file whose numbers are in display units already.
    pub(super) fn of_file(&self) -> Vec<RowColumn> {
        let number = |column: &Named| RowColumn {
            name: column.name.clone(),
            kind: RowKind::Number(Unit::new(column.unit.symbol.clone(), 1.0)),
        };
        let design = RowColumn { name: DESIGN.to_owned(), kind: RowKind::Count };
        std::iter::once(design).chain(self.all.iter().map(number)).collect()
    }
}

/// A number that somebody gave, in its unit: 950 mm are 0.95 m, and not 949.9999999999999 mm.
pub(super) fn tidy(shown: f64) -> f64 {
    format!("{shown:.14e}").parse().unwrap_or(shown)
}

#[cfg(test)]
mod tests {
    use super::tidy;

    #[test]
    fn given_numbers_are_shown_as_given() {
        assert_eq!((0.95 / 1e-3 == 950.0, tidy(0.95 / 1e-3)), (false, 950.0));
        assert!(tidy(f64::NAN).is_nan());
        assert_eq!([0.0, 1e300, -2.5e-7].map(tidy), [0.0, 1e300, -2.5e-7]);
    }
}
