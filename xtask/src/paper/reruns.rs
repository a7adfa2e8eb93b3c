//! Figures that need the analysis at other parameters: the same study run again with `--set`.

use bellcrank_results::ParameterRow;

use super::figure::Figure;
use super::machine::study;

/// Relative step of the central differences: their error is its square.
const STEP: f64 = 1e-4;

/// Parameter, its SI unit, and the recomputed relative sensitivity of the peak force.
const SENSITIVITIES: [(&str, &str, &str, &str); 6] = [
    ("l32", "m", "-0.9676", "peak force by l32"),
    ("l5", "m", "0.9322", "peak force by l5"),
    ("l31", "m", "0.0459", "peak force by l31"),
    ("m5", "kg", "0.0889", "peak force by m5"),
    ("m3", "kg", "0.0853", "peak force by m3"),
    ("m1", "kg", "0.0775", "peak force by m1"),
];

/// Relative sensitivities d(ln peak)/d(ln parameter) by central differences of re-runs.
pub(crate) fn sensitivities(parameters: &[ParameterRow]) -> Result<Vec<Figure>, String> {
    let figure = |(name, unit, target, quantity)| {
        let value = sensitivity(parameters, name, unit)?;
        Ok(Figure { quantity, paper: "", target, value })
    };
    SENSITIVITIES.into_iter().map(figure).collect()
}

fn sensitivity(parameters: &[ParameterRow], name: &'static str, unit: &str) -> Result<f64, String> {
    let value = value(parameters, name)?;
    let peak =
        |factor: f64| Ok::<_, String>(study("lift", &[(name, format!("{:e} {unit}", value * factor))])?.peak()?.0);
    Ok((peak(1.0 + STEP)? - peak(1.0 - STEP)?) / (2.0 * STEP * peak(1.0)?))
}

/// A parameter's value, SI.
pub(crate) fn value(parameters: &[ParameterRow], name: &str) -> Result<f64, String> {
    let row = parameters.iter().find(|row| row.name == name);
    row.map(|row| row.value).ok_or_else(|| format!("the lift has no parameter `{name}`"))
}

/// The peak at the paper's optimum, masses held, and its change from `before`.
pub(crate) fn optimum(before: f64) -> Result<[Figure; 2], String> {
    let lengths =
        [("l31", "600 mm"), ("l32", "200 mm"), ("l5", "800 mm")].map(|(name, value)| (name, value.to_owned()));
    let peak = study("lift", &lengths)?.peak()?.0;
    Ok([
        Figure { quantity: "peak force at [600, 200, 800] mm [N]", paper: "4410", target: "4423.5", value: peak },
        Figure {
            quantity: "change of the peak force [%]",
            paper: "-31.9",
            target: "-31.7",
            value: 1e2 * (peak / before - 1.0),
        },
    ])
}
