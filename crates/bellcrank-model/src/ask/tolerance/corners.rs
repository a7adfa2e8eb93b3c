//! The exact worst case: the response with every dimension at an end of its tolerance.

use super::linear::Linear;
use super::machines::Machines;
use super::{Input, inputs};
use crate::trial::{Trial, Undefined};

/// Up to so many dimensions every corner is tried: 4096 machines.
const ALL_CORNERS: usize = 12;
/// Beyond, the signs of the derivatives say where to look; they are looked at again there, so many times.
const LOOKS: usize = 4;

fn moving(inputs: &[Input]) -> Vec<usize> {
    (0..inputs.len()).filter(|&i| inputs[i].width > 0.0).collect()
}

/// How many machines are tried.
pub(super) fn count(inputs: &[Input]) -> u64 {
    let moving = moving(inputs).len();
    if moving == 0 || moving > ALL_CORNERS { 0 } else { 1 << moving }
}

/// Lowest and highest response at the corners; `None`, with a warning, where one of them has none.
pub(super) fn worst(
    machines: &mut Machines<'_, '_>,
    trial: &mut Trial<'_>,
    linear: &Linear,
    warnings: &mut Vec<String>,
) -> Option<(f64, f64)> {
    let moving = moving(machines.inputs);
    match moving.len() {
        0 => Some((linear.nominal, linear.nominal)),
        n if n <= ALL_CORNERS => every(machines, &moving, warnings),
        _ => by_signs(machines, trial, linear, &moving, warnings),
    }
}

fn every(machines: &mut Machines<'_, '_>, moving: &[usize], warnings: &mut Vec<String>) -> Option<(f64, f64)> {
    let inputs = machines.inputs;
    let count = 1u64 << moving.len();
    let deviations = |corner: u64| {
        let mut all = vec![0.0; inputs.len()];
        for (bit, &i) in moving.iter().enumerate() {
            all[i] = if corner >> bit & 1 == 1 { inputs[i].width } else { -inputs[i].width };
        }
        all
    };
    let (mut ends, mut failed, mut first) = ((f64::INFINITY, f64::NEG_INFINITY), 0u64, None);
    machines.each(count, "corners of the tolerances", deviations, |_, answer| match answer {
        Ok(value) => ends = (ends.0.min(value), ends.1.max(value)),
        Err(why) => {
            failed += 1;
            first.get_or_insert(why);
        }
    });
    if let Some(why) = first {
        warnings.push(format!(
            "there is no exact worst case: {failed} of the {count} machines with every dimension at an end of its \
             tolerance give no result; {}",
            why.message
        ));
        return None;
    }
    (!machines.stopped).then_some(ends)
}

/// Follows the signs of the derivatives from the nominal machine to the two worst corners, and on from there.
fn by_signs(
    machines: &mut Machines<'_, '_>,
    trial: &mut Trial<'_>,
    linear: &Linear,
    moving: &[usize],
    warnings: &mut Vec<String>,
) -> Option<(f64, f64)> {
    let mut tried = 0;
    let pieces = std::iter::once(&linear.gradient).chain(linear.others.iter().map(|piece| &piece.gradient));
    let starts: Vec<Vec<f64>> = pieces.cloned().collect();
    let mut climb = |upwards: f64| {
        let mut best: Option<f64> = None;
        for start in &starts {
            let value = from(machines.inputs, trial, start, upwards, &mut tried)?;
            best = Some(best.map_or(value, |best| if upwards * value > upwards * best { value } else { best }));
        }
        best.ok_or(None)
    };
    let ends = climb(-1.0).and_then(|low| climb(1.0).map(|high| (low, high)));
    let n = moving.len();
    match ends {
        Ok(ends) => {
            warnings.push(format!(
                "{n} dimensions have 2^{n} corners: the exact worst case was looked for at {tried} of them, where the \
                 signs of the derivatives point"
            ));
            Some(ends)
        }
        Err(why) => {
            let why: Option<Undefined> = why;
            let why = why.map_or_else(|| "there are no derivatives to follow".to_owned(), |why| why.message);
            warnings.push(format!("there is no exact worst case: {why}"));
            None
        }
    }
}

/// The best corner reached from derivatives; an error without a reason where they are not defined.
fn from(
    inputs: &[inputs::Input],
    trial: &mut Trial<'_>,
    start: &[f64],
    upwards: f64,
    tried: &mut usize,
) -> Result<f64, Option<Undefined>> {
    let by: Vec<usize> = inputs.iter().map(|input| input.parameter).collect();
    let (mut gradient, mut corner) = (start.to_vec(), Vec::new());
    let mut best = f64::NAN;
    for _ in 0..LOOKS {
        if inputs.iter().zip(&gradient).any(|(input, g)| input.width > 0.0 && g.is_nan()) {
            return if best.is_nan() { Err(None) } else { Ok(best) };
        }
        let end = |(input, g): (&inputs::Input, &f64)| input.width * if upwards * g < 0.0 { -1.0 } else { 1.0 };
        let next: Vec<f64> = inputs.iter().zip(&gradient).map(end).collect();
        if next == corner {
            break;
        }
        corner = next;
        let fixed: Vec<(usize, f64)> =
            inputs.iter().zip(&corner).map(|(input, d)| (input.parameter, input.nominal + d)).collect();
        *tried += 1;
        let value = trial.run(&fixed).map_err(Some)?[0];
        if upwards * value <= upwards * best {
            break;
        }
        best = value;
        gradient = trial.gradients(&by).map_err(Some)?.swap_remove(0).active.gradient;
    }
    Ok(best)
}
