//! Solids of bodies as parts for other programs, and as what is drawn.

mod files;
mod turned;

use bellcrank_math::quaternion_from_matrix;
use bellcrank_mesh::Mesh;
use bellcrank_multibody::BodyId;
use bellcrank_results::{Failure, Pose, StudyResult, Surface};
use bellcrank_solid::{Shell, Surface as Triangles};

use crate::build::{Form, solid_of};
use crate::check::solid_fact;
use crate::design::{Design, Values};
use crate::run::{Namer, failure};
use crate::{Model, SolidFact, provenance};

pub use files::{PartFile, PartFormat};
use files::{of_assembly, of_parts};

/// How far triangles may be from the true surface, by the size of the solid.
const CHORD: f64 = 2e-4;

impl Form {
    /// The exact boundary in body axes; a mesh has none.
    pub(crate) fn shell(&self) -> Option<Shell> {
        match self {
            Form::Stack { stack, plane } => Some(turned::shell(stack.shell(), *plane)),
            Form::Revolved(revolved) => revolved.shell().ok(),
            Form::Mesh(_) => None,
        }
    }

    /// Triangles on the boundary, body axes.
    pub(crate) fn triangles(&self) -> Triangles {
        match (self, self.shell()) {
            (_, Some(shell)) => shell.surface(CHORD * extent(&shell)),
            (Form::Mesh(mesh), None) => of_mesh(mesh),
            (_, None) => Triangles::default(),
        }
    }
}

fn of_mesh(mesh: &Mesh) -> Triangles {
    let surface = mesh.surface(&mesh.boundary());
    let nodes = surface.nodes.iter().map(|&node| mesh.nodes[node as usize]).collect();
    Triangles { nodes, triangles: surface.triangles, edges: Vec::new() }
}

/// The drawn surface of the solid of a body, body axes.
pub(crate) fn surface(design: &Design, values: &Values, body: usize) -> Option<Surface> {
    let surface = solid_of(design, values, body, &mut Vec::new())?.triangles();
    Some(Surface { points: surface.nodes, triangles: surface.triangles })
}

/// Diagonal of the box around the vertices, m.
fn extent(shell: &Shell) -> f64 {
    let side = |k: usize| {
        let along = |pick: fn(f64, f64) -> f64, from| shell.vertices.iter().map(|p| p[k]).fold(from, pick);
        along(f64::max, f64::NEG_INFINITY) - along(f64::min, f64::INFINITY)
    };
    (0..3).map(|k| side(k).powi(2)).sum::<f64>().sqrt()
}

impl Model {
    /// Bodies that have a solid, with what comes of it.
    #[must_use]
    pub fn solids(&self) -> Vec<SolidFact> {
        (0..self.design().bodies.len()).filter_map(|body| solid_fact(self, body)).collect()
    }

    /// A file of each format for each body that has a solid, in body axes, named after the body.
    #[must_use]
    pub fn part_files(&self, formats: PartFormat) -> Vec<PartFile> {
        of_parts(self.design(), &self.own_values(), &provenance::now(), formats)
    }

    /// The solids as a STEP assembly where the starts put them; nothing where there are none.
    ///
    /// # Errors
    /// A mechanism that cannot be assembled.
    pub fn assembly(&self) -> Result<Option<Vec<u8>>, Failure> {
        let design = self.design();
        let named = |error| failure(&Namer::new(design), &error, "the mechanism at its starts", "");
        let Ok(mut engine) = self.engine() else { return Ok(None) };
        engine.assemble(&[]).map_err(named)?;
        let pose = |body| {
            let motion = engine.body(BodyId(body));
            Pose { position: motion.origin, quaternion: quaternion_from_matrix(&motion.rotation) }
        };
        let poses: Vec<Pose> = (0..design.bodies.len()).map(pose).collect();
        Ok(of_assembly(design, &self.own_values(), self.name(), &provenance::now(), &poses))
    }

    /// The solids as a STEP assembly at the first row of a study, with the parameters of that study; nothing where there
    /// are no solids or no motion.
    #[must_use]
    pub fn assembly_of(&self, result: &StudyResult) -> Option<Vec<u8>> {
        let study = self.study_list().iter().find(|study| study.name == result.name)?;
        let poses = result.animation.as_ref()?.frames.first()?;
        let name = format!("{} {}", self.name(), study.name);
        of_assembly(self.design(), &study.values, &name, &provenance::now(), poses)
    }

    pub(crate) fn own_values(&self) -> Values {
        let scopes = &self.design().scopes;
        Values::new(scopes, &scopes[0].parameters)
    }
}
