//! Flexible bodies over the rows of a study: how far they deform, and the stress in them.
//!
//! Reading order: [`rows`] (what is kept while the machine moves), [`recovery`] (stress at nodes, row by row),
//! [`spots`] (the largest of each region, with its history), [`life`] (what repeats of it do), [`told`] (what is said of a
//! body), [`picture`].

mod life;
mod picture;
mod recovery;
mod rows;
mod spots;
mod told;

use bellcrank_results::{Column, FlexibleBodies, FlexibleBody, StudyResult};

use crate::build::{Built, Deforming, ShapesOf};
use crate::design::{Design, Study, Values};
use crate::elastic::End;
use crate::elastic::meshing::Solid;
use crate::elastic::pictures::Picture;
use crate::flex::{Origin, Reduced};
use crate::measure::Measure;
use crate::run::Places;

pub(crate) use recovery::{PEAK, trusted_regions};
pub(crate) use rows::Shapes;

/// One flexible body and what is known of it.
struct Body<'a> {
    design: &'a Design,
    values: &'a Values,
    deforming: &'a Deforming,
    reduced: &'a Reduced,
    /// The reduction was taken from the cache.
    cached: bool,
    solid: Solid,
    rows: &'a rows::BodyRows,
}

/// Adds what the flexible bodies of a study did to its result, whose table and animation are there.
pub(crate) fn tell(design: &Design, study: &Study, built: &Built, shapes: &Shapes, result: &mut StudyResult) {
    if built.flexible.is_empty() || shapes.count() == 0 {
        return;
    }
    let units = [Measure::Stress, Measure::Length].map(|measure| design.units.of(measure));
    let mut found = FlexibleBodies {
        bodies: Vec::new(),
        assumptions: Vec::new(),
        unit: units[0].clone(),
        length: units[1].clone(),
    };
    for (deforming, rows) in built.flexible.iter().zip(&shapes.bodies) {
        match one(design, study, (deforming, rows), result, &mut found.assumptions) {
            Ok(body) => found.bodies.extend(body),
            Err(end) => result.warnings.push(end.message),
        }
    }
    result.flexible = (!found.bodies.is_empty()).then_some(found);
}

fn one(
    design: &Design,
    study: &Study,
    (deforming, rows): (&Deforming, &rows::BodyRows),
    result: &mut StudyResult,
    assumptions: &mut Vec<String>,
) -> Result<Option<FlexibleBody>, End> {
    let values = &study.values;
    let (Some(form), ShapesOf::Solid { reduced, origin }) =
        (&design.bodies[deforming.body].flexible, &deforming.shapes)
    else {
        return Ok(None);
    };
    let solid = Solid::of(design, values, &form.mesh, deforming.body)?;
    let cached = *origin == Origin::Cache;
    let body = Body { design, values, deforming, reduced, cached, solid, rows };
    let places = places(design, study, result);
    let recovered = recovery::Recovered::new(&body, form);
    let mut spots = spots::spots(&body, &recovered, &places)?;
    if let Some(life) = life::Life::of(design, values, deforming.body) {
        life.tell(&mut spots);
        life.assume(design, assumptions);
    }
    let name = &design.bodies[deforming.body].name;
    columns(design, name, &recovered, &mut spots, result);
    let picture = Picture::new(&reduced.mesh);
    result.motions.extend(picture::motion(&body, &picture, &recovered, &spots, result.animation.as_ref()));
    let told = told::body(&body, form, &recovered, spots, &places)?;
    result.warnings.extend(told::warnings(&told));
    Ok(Some(told))
}

/// Where the machine was, row by row, in words.
fn places(design: &Design, study: &Study, result: &StudyResult) -> Vec<String> {
    let places = Places::new(design, study);
    let axis = result.axis.first().and_then(|name| result.table.column(name));
    axis.map_or_else(Vec::new, |axis| axis.values.iter().map(|at| places.at(*at)).collect())
}

/// The largest stress of all and of each region as signals of the table.
fn columns(
    design: &Design,
    body: &str,
    recovered: &recovery::Recovered,
    spots: &mut [spots::Spot],
    result: &mut StudyResult,
) {
    let unit = design.units.of(Measure::Stress);
    let name = |key: &str| format!("stress.{body}.{key}");
    let mut add = |key: &str, values: Vec<f64>| {
        result.table.columns.push(Column { name: name(key), unit: unit.clone(), values });
    };
    add(recovery::PEAK, recovered.peaks());
    for (region, curve) in recovered.regions.iter().zip(&recovered.curves) {
        add(&region.key, curve.clone());
    }
    for spot in spots.iter_mut().filter(|spot| spot.found.singular.is_none()) {
        spot.found.signal = name(&recovered.regions[spot.region].key);
    }
}
