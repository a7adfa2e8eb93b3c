//! Tornado, table, and the response against each parameter.

use bellcrank_results::{ParameterSensitivity, Sensitivity};

use super::super::rows::{Rows, code, digits, number, symbol, words};
use super::pictures;
use crate::FigureFile;
use crate::told::by_weight;

pub(super) fn section(found: &Sensitivity, figures: &[FigureFile]) -> String {
    let curves = pictures(figures, "curve", "multiples");
    let curves =
        if curves.is_empty() { curves } else { format!("<h3>Response against each parameter</h3>\n{CURVES}{curves}") };
    format!("{}<h3>Derivatives</h3>\n{TABLE}{}{curves}", pictures(figures, "tornado", "wide"), table(found))
}

const CURVES: &str = "<p class=\"hint\">All other parameters held. The dot is the model as it is, the dashed line its \
    exact derivative. All pictures have the same vertical scale.</p>\n";
const TABLE: &str = "<p class=\"hint\">Exact derivatives with the place of the extreme held, which is the derivative of \
    the extreme itself. Relative: change of the response in % for 1 % more of the parameter.</p>\n";

/// The largest relative effect first, then those that are not defined, then those without effect.
fn table(found: &Sensitivity) -> String {
    let mut rows = Rows::new(&["Parameter", " Value", "Unit", " Derivative", "Unit", " Relative", "Note"]);
    let weighed = by_weight(found);
    let others = found.parameters.iter().filter(|row| !weighed.iter().any(|other| std::ptr::eq(*other, *row)));
    for row in weighed.iter().copied().chain(others) {
        rows.push(&cells(row));
    }
    rows.html()
}

fn cells(row: &ParameterSensitivity) -> [String; 7] {
    [
        code(&row.name),
        number(row.value, &row.unit),
        symbol(&row.unit),
        number(row.derivative, &row.derivative_unit),
        symbol(&row.derivative_unit),
        digits(row.relative, 4),
        words(&row.note),
    ]
}
