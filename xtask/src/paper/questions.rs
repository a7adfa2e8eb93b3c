//! What the lift's own studies find: the optimum of `shorter`, the sensitivities of `influence`.

use bellcrank_results::{Findings, Optimization, ParameterRow, Sensitivity};

use super::figure::Figure;
use super::machine;

/// Parameter, the recomputed relative sensitivity of the peak force, and what the figure is called.
const SENSITIVITIES: [(&str, &str, &str); 6] = [
    ("l32", "-0.9676", "peak force by l32"),
    ("l5", "0.9322", "peak force by l5"),
    ("l31", "0.0459", "peak force by l31"),
    ("m5", "0.0889", "peak force by m5"),
    ("m3", "0.0853", "peak force by m3"),
    ("m1", "0.0775", "peak force by m1"),
];

/// Variable, its optimum in the paper in mm, and what the figure is called.
const OPTIMUM: [(&str, &str, &str); 3] =
    [("l31", "600", "l31 [mm]"), ("l32", "200", "l32 [mm]"), ("l5", "800", "l5 [mm]")];

/// Relative sensitivities d(ln peak)/d(ln parameter), exact, of the study `influence`.
pub(crate) fn sensitivities() -> Result<Vec<Figure>, String> {
    let found = influence()?;
    let figure = |(name, target, quantity): (&str, &'static str, &'static str)| {
        let row = found.parameters.iter().find(|row| row.name == name);
        let value = row.map(|row| row.relative).ok_or_else(|| format!("`influence` does not vary `{name}`"))?;
        Ok(Figure { quantity, paper: "", target, value })
    };
    SENSITIVITIES.into_iter().map(figure).collect()
}

/// The optimum of the study `shorter`, the peak force there, and its change.
pub(crate) fn optimum() -> Result<Vec<Figure>, String> {
    let found = shorter()?;
    let variable = |(name, printed, quantity): (&str, &'static str, &'static str)| {
        let row = found.variables.iter().find(|row| row.name == name);
        let value = row.map(|row| 1e3 * row.value).ok_or_else(|| format!("`shorter` has no variable `{name}`"))?;
        Ok(Figure { quantity, paper: printed, target: printed, value })
    };
    let mut figures: Vec<Figure> = OPTIMUM.into_iter().map(variable).collect::<Result<_, String>>()?;
    let (start, value) = (found.objective.start, found.objective.value);
    figures.push(Figure { quantity: "peak force there [N]", paper: "4410", target: "4423.5", value });
    figures.push(Figure {
        quantity: "change of the peak force [%]",
        paper: "-31.9",
        target: "-31.7",
        value: 1e2 * (value / start - 1.0),
    });
    Ok(figures)
}

/// How the search went, in a sentence.
pub(crate) fn search() -> Result<String, String> {
    let found = shorter()?;
    let [stroke] = found.constraints.as_slice() else { return Err("`shorter` has one constraint".to_owned()) };
    let proof = if found.first_order.holds { "a first-order (Karush–Kuhn–Tucker) point" } else { "no optimum" };
    Ok(format!(
        "The search {} after {} iterations and {} designs, at {proof}: all three lengths are at a bound, and the constraint \
         `{}` holds with {:.1} mm.",
        found.status,
        found.iteration_count,
        found.evaluations,
        stroke.written,
        1e3 * stroke.left.1
    ))
}

fn shorter() -> Result<Optimization, String> {
    match machine::findings("shorter")? {
        Findings::Optimization(found) => Ok(found),
        _ => Err("`shorter` is no optimization".to_owned()),
    }
}

fn influence() -> Result<Sensitivity, String> {
    match machine::findings("influence")? {
        Findings::Sensitivity(found) => Ok(found),
        _ => Err("`influence` is no sensitivity study".to_owned()),
    }
}

/// A parameter's value, SI.
pub(crate) fn value(parameters: &[ParameterRow], name: &str) -> Result<f64, String> {
    let row = parameters.iter().find(|row| row.name == name);
    row.map(|row| row.value).ok_or_else(|| format!("the lift has no parameter `{name}`"))
}
