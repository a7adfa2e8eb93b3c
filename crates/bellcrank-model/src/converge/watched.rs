//! The numbers of a run that are watched: the largest effort of each drive, the largest stress of each body.

use bellcrank_results::{FlexibleBody, Rung, StudyResult, Unit, Watched};

/// An effort below this share of the largest of its kind is rounding.
const ROUNDING: f64 = 1e-9;

/// What a run says; names that are new are added to the watched ones.
pub(super) fn rung(setting: f64, result: &StudyResult, watched: &mut Vec<Watched>) -> Rung {
    let mut values = vec![None; watched.len()];
    for (name, unit, value) in efforts(result).into_iter().chain(stresses(result)) {
        let place = watched.iter().position(|known| known.name == name).unwrap_or_else(|| {
            watched.push(Watched { name, unit });
            values.push(None);
            watched.len() - 1
        });
        values[place] = Some(value);
    }
    let meshes = bodies(result).iter().filter_map(|body| body.mesh.as_ref());
    Rung {
        setting,
        nodes: meshes.map(|mesh| mesh.nodes).sum(),
        values,
        failure: result.failure.as_ref().map(|failure| failure.message.clone()),
        seconds: result.seconds,
    }
}

fn bodies(result: &StudyResult) -> &[FlexibleBody] {
    result.flexible.as_ref().map_or(&[], |found| &found.bodies)
}

type Found = (String, Unit, f64);

fn efforts(result: &StudyResult) -> Vec<Found> {
    let of_drive = |name: &str| name.starts_with("drive.") && !name.contains(".power");
    let columns = result.table.columns.iter().filter(|column| of_drive(&column.name));
    let all: Vec<Found> = columns
        .map(|column| {
            let largest = column.values.iter().copied().filter(|x| x.is_finite()).map(f64::abs).fold(0.0, f64::max);
            (format!("largest {}", column.name), column.unit.clone(), largest)
        })
        .collect();
    let most = |unit: &Unit| all.iter().filter(|one| one.1 == *unit).map(|one| one.2).fold(0.0, f64::max);
    all.iter().filter(|one| one.2 > ROUNDING * most(&one.1)).cloned().collect()
}

fn stresses(result: &StudyResult) -> Vec<Found> {
    let Some(found) = &result.flexible else { return Vec::new() };
    let peak = |body: &FlexibleBody| {
        let value = body.peak()?.value;
        Some((format!("largest stress of {}", body.body), found.unit.clone(), value))
    };
    found.bodies.iter().filter_map(peak).collect()
}
