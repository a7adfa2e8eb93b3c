//! Flexible bodies in words.

use bellcrank_results::{Fatigue, FlexibleBodies, FlexibleBody, SpotHistory};

use super::{about, code, listed, shown};
use crate::number;

/// The stress first, then what it comes from.
pub(crate) fn sentences(found: &FlexibleBodies) -> Vec<String> {
    let of = |body: &FlexibleBody| {
        let parts = [largest(found, body), life(body), Some(reduced(found, body))];
        parts.into_iter().flatten().collect::<Vec<_>>()
    };
    found.bodies.iter().flat_map(of).collect()
}

fn largest(found: &FlexibleBodies, body: &FlexibleBody) -> Option<String> {
    if body.spots.is_empty() {
        return None;
    }
    let name = code(&body.body);
    let Some(peak) = body.peak() else { return Some(format!("Of {name} there is no stress that can be trusted.")) };
    let place = if peak.place.is_empty() { String::new() } else { format!(", at {}", peak.place) };
    let margin = match (peak.margin, body.strength) {
        (Some(margin), Some(strength)) => {
            let word = if margin < 0.0 { "ABOVE" } else { "below" };
            let far = number::percent((1.0 - peak.value / strength).abs());
            format!("; {far} {word} yield at {}", shown(strength, &found.unit))
        }
        _ => String::new(),
    };
    let stress = with_error(peak, found);
    Some(format!("The largest stress of {name} over all rows is {stress} at {}{place}{margin}.", peak.region))
}

/// `148.2 MPa ± 1.9 %`, without the error where there is none.
pub(crate) fn with_error(spot: &SpotHistory, found: &FlexibleBodies) -> String {
    let stress = about(spot.value, &found.unit, 4);
    match spot.relative_error().filter(|_| spot.singular.is_none()) {
        Some(error) => format!("{stress} ± {} %", number::significant(100.0 * error, 2)),
        None => stress,
    }
}

/// What one repeat of the study costs, at the spot where it costs most.
fn life(body: &FlexibleBody) -> Option<String> {
    let all = body.spots.iter().filter_map(|spot| Some((spot, spot.fatigue?)));
    let (spot, worst) = all.max_by(|a, b| a.1.damage.total_cmp(&b.1.damage))?;
    let name = code(&body.body);
    Some(match worst.life {
        Some(_) => {
            format!("{name} lives for {} of this study; its weakest region is {}.", repeats(&worst), spot.region)
        }
        None => format!("Repeats of this study do not tire {name}: every cycle is below its endurance limit."),
    })
}

/// `31000 repeats`, or that there is no end.
pub(crate) fn repeats(of: &Fatigue) -> String {
    of.life.map_or_else(|| "no end".to_owned(), |life| format!("{} repeats", number::significant(life, 2)))
}

/// What stands for the body, and how far it was deformed.
fn reduced(found: &FlexibleBodies, body: &FlexibleBody) -> String {
    let held = match body.modes.as_slice() {
        [] => "no modes".to_owned(),
        [one] => format!("one mode with its interfaces held, at {}", hertz(one.frequency)),
        [first, .., last] => format!(
            "{} modes with its interfaces held, from {} to {}",
            body.modes.len(),
            hertz(first.frequency),
            hertz(last.frequency)
        ),
    };
    let interfaces: Vec<String> = body.interfaces.iter().map(|name| code(name)).collect();
    let coupling = if body.coupling.is_empty() { String::new() } else { format!(" by {} couplings", body.coupling) };
    let deformed = body.deformation.as_ref().map_or_else(String::new, |of| {
        let place = if of.place.is_empty() { String::new() } else { format!(" at {}", of.place) };
        let share = number::percent(of.share);
        format!(" It is deformed by up to {} ({share} of its size){place}.", about(of.displacement, &found.length, 3))
    });
    let count = body.coordinates;
    let plural = if count == 1 { "" } else { "s" };
    format!(
        "{} has {count} elastic coordinate{plural}: it is held at {}{coupling}, and {held}.{deformed}",
        code(&body.body),
        listed(&interfaces)
    )
}

fn hertz(frequency: f64) -> String {
    number::with_unit(&number::significant(frequency, 4), "Hz")
}
