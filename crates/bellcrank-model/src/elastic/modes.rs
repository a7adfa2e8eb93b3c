//! Natural frequencies of a body.

use std::time::Instant;

use bellcrank_fem::{Fault, Modes, Settings, Support};
use bellcrank_mesh::Mesh;
use bellcrank_results::{BodyModeRow, BodyModes as Told, Findings, PartEffort, StudyResult, Unit};

use super::acting::Acting;
use super::meshing::{self, Solid};
use super::pictures::Picture;
use super::problem::{self, Problem};
use super::vector::{V3, norm};
use super::watched::watched;
use super::{Asked, End, cancelled, files, memory};
use crate::design::{BodyModes, Hinges};
use crate::progress::Progress;

/// Motions of a body that nothing holds.
const RIGID: usize = 6;

pub(super) fn run(
    asked: &Asked<'_>,
    form: &BodyModes,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), End> {
    let mut found = Told { bodies: Vec::new() };
    for &body in &asked.parts.bodies {
        let row = one(asked, form, body, result, progress)?;
        found.bodies.push(row);
    }
    result.findings = Some(Findings::BodyModes(found));
    progress.at(1.0, "done");
    Ok(())
}

fn one(
    asked: &Asked<'_>,
    form: &BodyModes,
    body: usize,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<BodyModeRow, End> {
    let begun = Instant::now();
    progress.at(0.0, "meshing");
    let solid = Solid::new(asked, body)?;
    let (material, _) = problem::material(asked, body, &solid)?;
    let acting = Acting::default();
    let problem =
        Problem { asked, body, solid: &solid, material: &material, acting: &acting, supports: &[], loads: &[] };
    let mesh = solid.mesh(None, memory::most_nodes())?;
    let mut setup = problem.on(&mesh, Hinges::Distributing)?;
    for name in &form.fixed {
        setup.part.supports.push(Support::clamped(problem.nodes(&mesh, &name.value)?));
    }
    // What turns out rigid is not among those asked for.
    let wanted = form.count + if form.fixed.is_empty() { RIGID } else { 0 };
    let threads = asked.threads;
    let modes = watched(progress, [0.1, 1.0], "looking for the lowest modes", |tell| {
        Modes::lowest(&setup.part, wanted, &Settings { threads, memory: memory::allowed(), progress: &tell })
    });
    let modes = modes.map_err(|faults| match faults.as_slice() {
        [Fault::Interrupted] => cancelled("before the modes were found"),
        _ => problem.refused(&mesh, &faults),
    })?;
    result.contours.extend(contour(&problem, &mesh, &modes));
    let elastic: Vec<(f64, &[V3])> = modes
        .frequencies
        .iter()
        .zip(&modes.shapes)
        .skip(modes.rigid)
        .map(|(f, shape)| (*f, shape.as_slice()))
        .collect();
    let deck = || files::modes_deck(problem.name(), &setup.part, wanted);
    result.attachments.extend(files::of_modes(problem.name(), &mesh, &elastic, asked.meshes, deck));
    let mass = mesh.mass_properties(material.density);
    let (solid_name, material_name) = problem.names();
    Ok(BodyModeRow {
        body: problem.name().to_owned(),
        solid: solid_name,
        material: material_name,
        fixed: form.fixed.iter().map(|name| name.value.clone()).collect(),
        rigid: modes.rigid,
        frequencies: modes.frequencies.iter().skip(modes.rigid).copied().collect(),
        residual: modes.residual,
        mesh: meshing::row(&mesh),
        mass: [mass.mass, solid.mass(material.density)],
        effort: PartEffort {
            equations: modes.effort.equations,
            factor_entries: modes.effort.factor_entries,
            seconds: begun.elapsed().as_secs_f64(),
        },
    })
}

/// A picture with a shape a mode; nothing where there is none.
fn contour(problem: &Problem<'_>, mesh: &Mesh, modes: &Modes) -> Option<bellcrank_results::Contour> {
    let picture = Picture::new(mesh);
    let mut contour = picture.contour(format!("{}: natural modes", problem.name()));
    let elastic = modes.frequencies.iter().zip(&modes.shapes).skip(modes.rigid);
    for (index, (frequency, shape)) in elastic.enumerate() {
        let rounded: f64 = format!("{frequency:.4e}").parse().unwrap_or(*frequency);
        let mut one = picture.shape(format!("mode {}, {rounded} Hz", index + 1), shape, true);
        let largest = shape.iter().map(|u| norm(*u)).fold(f64::MIN_POSITIVE, f64::max);
        one.fields.push(picture.field("amplitude", &Unit::one(), |node| norm(shape[node]) / largest));
        contour.shapes.push(one);
    }
    (!contour.shapes.is_empty()).then_some(contour)
}
