//! STEP and STL: one file a body, and an assembly.

use std::path::PathBuf;

use bellcrank_math::matrix_from_quaternion;
use bellcrank_results::{Paint, Pose, file_stems};
use bellcrank_solid::step::{self, Placement, StepPart};
use bellcrank_solid::stl;

use crate::build::{Form, solid_of};
use crate::design::{Design, Values};

/// Formats of parts.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct PartFormat {
    /// Exact boundaries, ISO 10303-214, mm.
    pub step: bool,
    /// Triangles, binary, mm.
    pub stl: bool,
}

/// A file for another program.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct PartFile {
    /// Relative to the folder of results.
    pub path: PathBuf,
    /// What stands in it.
    pub bytes: Vec<u8>,
}

const MILLIMETRES: f64 = 1000.0;

/// A file of each format for each body that has a solid, in body axes.
pub(super) fn of_parts(design: &Design, values: &Values, time: &str, formats: PartFormat) -> Vec<PartFile> {
    let mut files = Vec::new();
    let bodies = bodies(design);
    let stems = file_stems(bodies.iter().map(|&body| design.bodies[body].name.as_str()));
    for (&body, stem) in bodies.iter().zip(stems) {
        let Some(form) = solid_of(design, values, body, &mut Vec::new()) else { continue };
        if formats.stl {
            let bytes = stl::write(&form.triangles(), MILLIMETRES);
            files.push(PartFile { path: format!("{stem}.stl").into(), bytes });
        }
        if formats.step
            && let Some(part) = part(design, &form, body, vec![Placement::IDENTITY])
        {
            let text = step::write(&part.name.clone(), time, &[part]);
            files.push(PartFile { path: format!("{stem}.step").into(), bytes: text.into_bytes() });
        }
    }
    files
}

/// All bodies that have a solid, each where its pose says; nothing where there is none.
pub(super) fn of_assembly(design: &Design, values: &Values, name: &str, time: &str, poses: &[Pose]) -> Option<Vec<u8>> {
    let placed = bodies(design).into_iter().filter_map(|body| {
        let pose = poses.get(body)?;
        let form = solid_of(design, values, body, &mut Vec::new())?;
        part(design, &form, body, vec![placement(pose)])
    });
    let parts: Vec<StepPart> = placed.collect();
    (!parts.is_empty()).then(|| step::write(name, time, &parts).into_bytes())
}

fn bodies(design: &Design) -> Vec<usize> {
    (0..design.bodies.len()).filter(|&body| design.bodies[body].solid.is_some()).collect()
}

/// Nothing for a mesh, which has no exact surfaces.
fn part(design: &Design, form: &Form, body: usize, instances: Vec<Placement>) -> Option<StepPart> {
    let shell = form.shell()?;
    let of = &design.bodies[body];
    let material = design.solids.get(of.solid.as_ref()?.solid)?.material;
    Some(StepPart {
        name: of.name.clone(),
        shell,
        color: Some(Paint::Body.colour(body).map(|byte| f64::from(byte) / 255.0)),
        material: material.map(|material| design.materials[material].name.clone()),
        instances,
    })
}

fn placement(pose: &Pose) -> Placement {
    Placement { rotation: matrix_from_quaternion(&pose.quaternion), translation: pose.position }
}
