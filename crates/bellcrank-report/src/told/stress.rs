//! Stress and natural frequencies of bodies, in words.

use bellcrank_results::{BodyModeRow, BodyModes, HotSpot, Stress, StressBody};

use super::{about, code, listed, shown};
use crate::number;

pub(super) fn sentences(found: &Stress) -> Vec<String> {
    found.bodies.iter().flat_map(|body| [largest(found, body), trust(body)]).collect()
}

fn largest(found: &Stress, body: &StressBody) -> String {
    let name = code(&body.body);
    let Some(peak) = body.peak() else {
        return format!("Of {name} there is no stress that can be trusted.");
    };
    let place = if peak.place.is_empty() { &body.place } else { &peak.place };
    let place = if place.is_empty() { String::new() } else { format!(", at {place}") };
    let margin = match (peak.margin, body.strength) {
        (Some(margin), Some(strength)) => {
            let word = if margin < 0.0 { "ABOVE" } else { "below" };
            format!(
                "; {} {word} yield at {}",
                number::percent((1.0 - peak.value / strength).abs()),
                shown(strength, &found.unit)
            )
        }
        _ => String::new(),
    };
    let stress = with_error(peak, found);
    format!("The largest stress of {name} is {stress} at {}{place}{margin}.", peak.region)
}

/// `148.2 MPa ± 1.9 %`.
pub(crate) fn with_error(spot: &HotSpot, found: &Stress) -> String {
    let error = number::significant(100.0 * spot.relative_error(), 2);
    format!("{} ± {error} %", about(spot.value, &found.unit, 4))
}

/// Its coordinates; what is nothing but rounding reads 0.
pub(crate) fn place(spot: &HotSpot, found: &Stress) -> String {
    let range = found.length.show(spot.at.iter().fold(0.0, |most: f64, x| most.max(x.abs())));
    let rounded = |x: f64| number::significant(found.length.show(x), 4);
    spot.at.map(|x| if found.length.show(x.abs()) < 1e-9 * range { "0".to_owned() } else { rounded(x) }).join(", ")
}

/// What stands against the numbers.
fn trust(body: &StressBody) -> String {
    let mesh = body.meshes.last().map_or_else(String::new, |mesh| {
        let plural =
            if body.meshes.len() == 1 { String::new() } else { format!(", the last of {}", body.meshes.len()) };
        format!("{} nodes and {} elements {}{plural}", mesh.nodes, mesh.elements, mesh.element)
    });
    let unbalance = body.unbalance.map(|share| format!("loads in balance to {}", tiny(share)));
    let mass = body.mass[0] / body.mass[1] - 1.0;
    let parts: Vec<String> =
        [Some(format!("mass of the mesh off by {}", tiny(mass.abs()))), unbalance].into_iter().flatten().collect();
    format!("Mesh of {}: {mesh}; {}.", code(&body.body), listed(&parts))
}

fn tiny(share: f64) -> String {
    if share < 1e-14 { "nothing".to_owned() } else { number::significant(share, 2) }
}

/// The error that was asked for was not reached, or the material yields.
pub(super) fn unmet(found: &Stress) -> Option<String> {
    let asked = found.accuracy.map_or(f64::NAN, |accuracy| accuracy);
    let missed = found.bodies.iter().filter(|body| body.reached == Some(false));
    let words = |body: &StressBody| {
        let error = body.meshes.last().map_or(f64::NAN, |mesh| mesh.error);
        format!("{}: {}", code(&body.body), number::percent(error))
    };
    let missed: Vec<String> = missed.map(words).collect();
    (!missed.is_empty())
        .then(|| format!("the stress is not as exact as asked ({}): {}", number::percent(asked), listed(&missed)))
}

pub(super) fn mode_sentences(found: &BodyModes) -> Vec<String> {
    found.bodies.iter().map(modes).collect()
}

fn modes(body: &BodyModeRow) -> String {
    let name = code(&body.body);
    let held = if body.fixed.is_empty() { "free".to_owned() } else { format!("clamped at {}", listed(&body.fixed)) };
    let rigid = match body.rigid {
        0 => String::new(),
        count => format!(", beside {count} motions as a rigid body"),
    };
    match body.frequencies.first() {
        Some(first) => {
            let first = number::with_unit(&number::alone(*first), "Hz");
            format!("The lowest natural frequency of {name}, {held}, is {first}{rigid}.")
        }
        None => format!("Of {name} no natural frequency was found."),
    }
}
