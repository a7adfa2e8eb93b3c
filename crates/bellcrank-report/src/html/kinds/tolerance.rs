//! Histogram, contributions, and the numbers behind them.

use bellcrank_results::{MonteCarlo, Tolerance, ToleranceInput, Unit};

use super::super::Escaped;
use super::super::rows::{Rows, code, digits, number, symbol};
use super::pictures;
use crate::FigureFile;
use crate::number::{estimate, part, percent, typeset};

pub(super) fn section(found: &Tolerance, figures: &[FigureFile]) -> String {
    let quantiles = found.monte_carlo.as_ref().map_or_else(String::new, |run| quantiles(run, &found.unit));
    [
        pictures(figures, "histogram", "wide"),
        pictures(figures, "contributions", "wide"),
        format!("<h3>Tolerances</h3>\n{}", inputs(found)),
        quantiles,
    ]
    .concat()
}

fn inputs(found: &Tolerance) -> String {
    let sobol = found.inputs.iter().any(|input| input.sobol.is_some());
    let mut heads = vec![
        "Parameter",
        " Nominal",
        " Half width",
        " Deviation",
        "Unit",
        "Distribution",
        " Derivative",
        "Unit",
        " Variance",
        " Worst case",
    ];
    if sobol {
        heads.extend([" Sobol’ first", " Sobol’ total"]);
    }
    let mut rows = Rows::new(&heads);
    for input in &found.inputs {
        rows.push(&cells(input));
    }
    let hint = if sobol { SOBOL } else { "" };
    format!("<p class=\"hint\">The largest contribution first.{hint}</p>\n{}", rows.html())
}

const SOBOL: &str = " Sobol’ indices are shares of the variance that hold for any response, not only a linear one: alone \
    (first), and with all interactions (total); ± is one standard error.";

/// Without indices the last two are not asked for.
fn cells(input: &ToleranceInput) -> [String; 12] {
    let index =
        |of: Option<(f64, f64)>| of.map_or_else(|| "–".to_owned(), |(value, error)| typeset(&estimate(value, error)));
    [
        code(&input.name),
        number(input.nominal, &input.unit),
        if input.half_width.is_finite() {
            format!("± {}", number(input.half_width, &input.unit))
        } else {
            "–".to_owned()
        },
        digits(input.unit.show(input.deviation), 4),
        symbol(&input.unit),
        Escaped(input.distribution).to_string(),
        digits(input.derivative_unit.show(input.derivative), 5),
        symbol(&input.derivative_unit),
        Escaped(&part(input.variance_share)).to_string(),
        Escaped(&part(input.worst_share)).to_string(),
        index(input.sobol.map(|of| of.first)),
        index(input.sobol.map(|of| of.total)),
    ]
}

fn quantiles(run: &MonteCarlo, unit: &Unit) -> String {
    let mut rows = Rows::new(&["Samples below", " Response", "Unit"]);
    let quantiles = run.quantiles.iter().map(|(share, si)| (percent(*share), *si));
    let ends = [("none".to_owned(), run.range.0), ("all".to_owned(), run.range.1)];
    let [none, all] = ends;
    for (share, si) in [none].into_iter().chain(quantiles).chain([all]) {
        rows.push(&[share, number(si, unit), symbol(unit)]);
    }
    format!("<h3>Quantiles</h3>\n{}", rows.html())
}
