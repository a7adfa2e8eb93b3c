//! What is said of a flexible body: how it was reduced, how far it deformed, and whether that can be trusted.

use bellcrank_results::{Deformation, FlexibleBody, KeptMode, ReductionCheck};

use super::Body;
use super::recovery::Recovered;
use super::spots::{Spot, peak};
use crate::build::DAMPING;
use crate::design::{Flexible, Quantity};
use crate::elastic::{End, material_of, meshing};

/// Displacement against the body's extent above which linear theory is doubtful: what it leaves out is about the square
/// of the turns that go with it.
const DOUBTFUL: f64 = 0.05;
/// Up to where checks of a reduction count as passed.
const EXACT: f64 = 1e-6;

/// What is said of a body.
pub(super) fn body(
    of: &Body<'_>,
    form: &Flexible,
    recovered: &Recovered,
    spots: Vec<Spot>,
    places: &[String],
) -> Result<FlexibleBody, End> {
    let design = of.design;
    let (body, reduced) = (&design.bodies[of.deforming.body], of.reduced);
    let (material, strength) = material_of(design, of.values, of.deforming.body, &of.solid)?;
    let solid = body.solid.as_ref().and_then(|worn| design.solids.get(worn.solid));
    let named = solid.and_then(|solid| design.materials.get(solid.material?));
    let damping = form.damping.as_ref().map_or(DAMPING, |damping: &Quantity| damping.eval(of.values));
    let mode = |&frequency: &f64| KeptMode { frequency, damping };
    let mut interfaces: Vec<String> =
        form.interfaces.iter().map(|point| body.points[point.value].name.clone()).collect();
    let reference = interfaces.remove(form.reference);
    interfaces.insert(0, reference);
    let density = material.density;
    Ok(FlexibleBody {
        body: body.name.clone(),
        solid: solid.map_or_else(String::new, |solid| solid.name.clone()),
        material: named.map_or_else(String::new, |material| material.name.clone()),
        strength,
        coupling: if form.rigid { "rigid" } else { "distributing" }.to_owned(),
        interfaces,
        coordinates: of.deforming.coordinates.len(),
        modes: reduced.reduction.frequencies.iter().map(mode).collect(),
        stiffening: form.stiffening,
        mesh: Some(meshing::row(&reduced.mesh)),
        mass: [reduced.reduction.inertia.mass, of.solid.mass(density)],
        checks: checks(of, density),
        cached: of.cached,
        peak: peak(&spots),
        error: "spread of the elements' stress about the smoothed one in the row of the largest stress".to_owned(),
        deformation: Some(deformation(of, recovered, places)),
        spots: spots.into_iter().map(|spot| spot.found).collect(),
    })
}

fn checks(of: &Body<'_>, density: f64) -> Vec<ReductionCheck> {
    let reduced = &of.reduced;
    let known = &reduced.reduction.checks;
    let check = |key: &str, meaning: &str, value: f64| ReductionCheck {
        key: key.to_owned(),
        meaning: meaning.to_owned(),
        value,
        limit: Some(EXACT),
    };
    vec![
        check(
            "rigid_inertia",
            "mass, its centre and inertia as a rigid body against those of the mesh",
            inertia(of, density),
        ),
        check("rigid_motion", "shapes of all interfaces moved as one against that motion", known.rigid),
        check("static_residual", "unbalanced force of a static shape", known.static_residual),
        check("mode_residual", "residual of a mode with resting interfaces", known.mode_residual),
    ]
}

/// Largest relative difference of the integrals of the reduction from those of the mesh.
fn inertia(of: &Body<'_>, density: f64) -> f64 {
    let (inertia, mesh) = (&of.reduced.reduction.inertia, &of.reduced.mesh);
    let exact = mesh.mass_properties(density);
    let all: f64 = (0..3).map(|i| inertia.second[i][i]).sum();
    let size = all.abs().max(f64::MIN_POSITIVE);
    let mut worst = (inertia.mass / exact.mass - 1.0).abs();
    for i in 0..3 {
        let arm = (size / exact.mass).sqrt();
        worst = worst.max((inertia.first[i] / exact.mass - exact.center[i]).abs() / arm);
        for k in 0..3 {
            let about_center = exact.inertia[i][k];
            let square = |a: usize, b: usize| exact.mass * exact.center[a] * exact.center[b];
            let moved = if i == k { (0..3).map(|j| square(j, j)).sum::<f64>() - square(i, i) } else { -square(i, k) };
            let ours = if i == k { all - inertia.second[i][k] } else { -inertia.second[i][k] };
            worst = worst.max((ours - about_center - moved).abs() / size);
        }
    }
    worst
}

fn deformation(of: &Body<'_>, recovered: &Recovered, places: &[String]) -> Deformation {
    let (displacement, row) = recovered.moved;
    let turn = of.rows.all().flat_map(|row| turning(of, row)).fold(0.0, f64::max);
    Deformation {
        displacement,
        share: displacement / extent(&of.reduced.mesh.nodes),
        turn,
        place: places.get(row).cloned().unwrap_or_default(),
        limit: DOUBTFUL,
    }
}

/// Sizes of the turns among the coordinates of a row, rad.
fn turning<'r>(of: &'r Body<'_>, row: &'r [f64]) -> impl Iterator<Item = f64> + 'r {
    let interfaces = 6 * of.reduced.reduction.points.len();
    let turns = move |column: usize| column < interfaces && column % 6 > 2;
    of.deforming.columns.iter().zip(row).filter(move |(column, _)| turns(**column)).map(|(_, d)| d.abs())
}

/// Longest side of the box round places.
fn extent(places: &[[f64; 3]]) -> f64 {
    let side = |axis: usize| {
        let along = places.iter().map(|at| at[axis]);
        let [low, high] = along.fold([f64::INFINITY, f64::NEG_INFINITY], |[l, h], x| [l.min(x), h.max(x)]);
        high - low
    };
    (0..3).map(side).fold(f64::MIN_POSITIVE, f64::max)
}

/// What a reader must not miss.
pub(super) fn warnings(body: &FlexibleBody) -> Vec<String> {
    let mut all = Vec::new();
    let name = &body.body;
    if let Some(far) = body.deformation.as_ref().filter(|far| far.share > far.limit || far.turn > 2.0 * far.limit) {
        all.push(format!(
            "body `{name}` leaves linear theory: it moves by {:.1} % of its size and turns by {:.1} deg at {}; errors are \
             of the order of the turn's square",
            100.0 * far.share,
            far.turn.to_degrees(),
            far.place
        ));
    }
    let failed = body.checks.iter().filter(|check| check.passed() == Some(false));
    all.extend(failed.map(|check| {
        let limit = check.limit.unwrap_or(f64::NAN);
        format!(
            "the reduction of body `{name}` is not exact: {} is {:.1e}, above {limit:.0e}",
            check.meaning, check.value
        )
    }));
    if let Some(spot) = body.peak().filter(|spot| spot.margin.is_some_and(|margin| margin < 0.0)) {
        all.push(format!("body `{name}` yields: {} is above its strength at {}", spot.region, spot.place));
    }
    all
}
