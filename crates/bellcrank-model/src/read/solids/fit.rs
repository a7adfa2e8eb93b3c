//! Which points of a body its solid is laid on.

use bellcrank_doc::Diagnostic;

use crate::design::{NamedSpot, Solid, SolidForm, Worn};
use crate::read::{Machine, PartReader};

/// Finds the points that solids name on each body that uses one; bodies and grounds are there already. A body whose
/// points are not all there has no solid then.
pub(in crate::read) fn fit(parts: &[PartReader<'_>], machine: &mut Machine) {
    let reader = parts[0].reader;
    let mut used = vec![false; machine.solids.len()];
    for body in 0..machine.bodies.len() {
        let Some(worn) = machine.bodies[body].solid.take() else { continue };
        used[worn.solid] = true;
        match points(machine, body, &worn) {
            Ok(points) => machine.bodies[body].solid = Some(Worn { points, ..worn }),
            Err(reports) => reports.into_iter().for_each(|report| reader.report(report)),
        }
    }
    let idle = |(solid, used): &(&Solid, &bool)| !**used && !matches!(solid.form, SolidForm::Faulty);
    for (solid, _) in machine.solids.iter().zip(&used).filter(idle) {
        let message = format!("no body uses solid `{}`", solid.name);
        let hint = "a body does by `solid = \"...\"`; the form of a solid is checked on the points of a body";
        reader.report(Diagnostic::warning("unused", solid.span, message).hint(hint));
    }
    weightless(machine, &used).into_iter().for_each(|report| reader.report(report));
}

fn points(machine: &Machine, body: usize, worn: &Worn) -> Result<Vec<usize>, Vec<Diagnostic>> {
    let solid = &machine.solids[worn.solid];
    let mut faults = Vec::new();
    let mut points = Vec::with_capacity(solid.points.len());
    for spot in &solid.points {
        match machine.point_names[body].get(&spot.name.value) {
            Some(point) => points.push(point),
            None => faults.push(no_point(machine, body, worn, spot)),
        }
    }
    if faults.is_empty() { Ok(points) } else { Err(faults) }
}

fn no_point(machine: &Machine, body: usize, worn: &Worn, spot: &NamedSpot) -> Diagnostic {
    let name = &spot.name.value;
    let body_name = &machine.bodies[body].name;
    let message = format!("body `{body_name}` has no point `{name}` for {}", spot.what);
    let report = Diagnostic::error("unknown-name", spot.name.span, message).also(worn.span, "used here");
    let names = &machine.point_names[body];
    match (names.nearest(name), names.listed("")) {
        (Some(near), _) => report.hint(format!("did you mean `{near}`?")),
        (None, Some(all)) => report.hint(format!(
            "points of `{body_name}`: {all}; an eye that has another name, or no point, says where it is by `at`"
        )),
        (None, None) => {
            report.hint(format!("`{body_name}` has no points; give it some: `points = {{ {name} = [0, 0] }}`"))
        }
    }
}

/// Materials without a density that a solid in use needs: each once.
fn weightless(machine: &Machine, used: &[bool]) -> Vec<Diagnostic> {
    let needs = |place: usize| {
        let of = |(solid, used): (&Solid, &bool)| (*used && solid.material == Some(place)).then(|| solid.name.clone());
        machine.solids.iter().zip(used).find_map(of)
    };
    let report = |(place, material): (usize, &crate::design::Material)| {
        let solid = needs(place).filter(|_| material.density.is_none() && !material.faulty)?;
        let message =
            format!("`density` is missing in material `{}`, which solid `{solid}` has its mass from", material.name);
        Some(Diagnostic::error("missing-key", material.span, message).hint("as `density = \"7850 kg/m^3\"`"))
    };
    machine.materials.iter().enumerate().filter_map(report).collect()
}
