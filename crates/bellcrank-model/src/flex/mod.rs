//! From the solid of a flexible body to its reduction, made once.
//!
//! Reading order: [`recipe`] (all that a reduction depends on, and its key), [`make`] (mesh, reduce), [`plane`] (which
//! modes a planar machine can feel), [`file`] (a reduction as bytes), [`cache`] (a folder of such), [`store`] (what is at
//! hand while a model is).

mod cache;
mod file;
mod make;
mod plane;
mod recipe;
mod store;
#[cfg(test)]
mod tests;

use bellcrank_fem::beam::BeamFault;
use bellcrank_fem::{Reduction, Shortening, Six};
use bellcrank_mesh::Mesh;
use bellcrank_multibody::Flexible;

use crate::build::{self, Built, picked, shortened};
use crate::design::{Body, Design, Flexible as Form, Study, Values};
use crate::elastic::stroke::trusted_regions;
use crate::elastic::{End, ended};
use crate::progress::{Progress, Silent};
use crate::scalar::Scalar;

pub(crate) use plane::felt;
pub(crate) use recipe::changes;
pub(crate) use store::{Found, Origin, Store};

/// A solid as a body with a few coordinates, in body axes.
#[derive(Clone, Debug)]
pub(crate) struct Reduced {
    pub(crate) mesh: Mesh,
    /// Six columns an interface in the order of the file, then those of the modes that the machine can feel.
    pub(crate) reduction: Reduction,
    /// Stress at every node of a unit of each column, Pa.
    pub(crate) stress: Vec<Vec<Six>>,
    /// How much nearer interfaces come by bending, over all columns; none unless asked.
    pub(crate) shortenings: Vec<Shortening>,
    /// Natural frequencies of the modes left out as they do not move in the plane of the machine, Hz.
    pub(crate) left_out: Vec<f64>,
    /// Nodes whose stress can be trusted: of the whole surface (`peak`), and of each bore (`bore.NAME`).
    pub(crate) regions: Vec<(String, Vec<u32>)>,
    /// What there is to say of how it was made.
    pub(crate) notes: Vec<String>,
    /// Damping matrix by rows of a damping ratio of 1.
    damping: Vec<f64>,
}

impl Reduced {
    fn new(mesh: Mesh, reduction: Reduction, stress: Vec<Vec<Six>>) -> Reduced {
        let damping = reduction.damping(1.0);
        Reduced {
            mesh,
            reduction,
            stress,
            shortenings: Vec::new(),
            left_out: Vec::new(),
            regions: Vec::new(),
            notes: Vec::new(),
            damping,
        }
    }

    /// With the regions in which stress is looked for.
    fn with_regions(self, recipe: &recipe::Recipe) -> Reduced {
        let rigid = recipe.kind == bellcrank_fem::CouplingKind::Rigid;
        let regions = trusted_regions(&recipe.solid, &self.mesh, &self.reduction.points, rigid);
        Reduced { regions, ..self }
    }

    /// The same with at most so many modes, the slowest.
    fn with_fewer(&self, modes: usize) -> Reduced {
        let modes: Vec<usize> = (0..modes.min(self.modes())).collect();
        let reduction = plane::with_modes(self.reduction.clone(), &modes);
        let stress = self.stress[..reduction.coordinates()].to_vec();
        let last = reduction.frequencies.last().copied().unwrap_or(0.0);
        let left_out = self.left_out.iter().copied().filter(|frequency| *frequency < last).collect();
        Reduced { left_out, notes: self.notes.clone(), ..Reduced::new(self.mesh.clone(), reduction, stress) }
    }

    /// Number of modes with resting interfaces.
    pub(crate) fn modes(&self) -> usize {
        self.reduction.modes
    }

    /// Numbers for the engine, of some columns; damping is that of a ratio of 1.
    pub(crate) fn numbers(&self, columns: &[usize]) -> Flexible<f64> {
        let of = &self.reduction;
        Flexible {
            shortenings: shortened(&self.shortenings, of.coordinates(), columns),
            ..picked(&of.inertia, &of.stiffness, &self.damping, columns)
        }
    }
}

/// Flexible solids of a design, with their places among the bodies.
fn solids(design: &Design) -> impl Iterator<Item = (usize, &Form)> {
    let with_solid = |(index, body): (usize, &'_ Body)| body.solid.is_some().then_some(index);
    let places = design.bodies.iter().enumerate().filter_map(with_solid);
    places.filter_map(|index| Some((index, design.bodies[index].flexible.as_ref()?)))
}

/// Whether a study runs a machine with solids that deform.
pub(crate) fn applies(design: &Design, study: &Study) -> bool {
    study.flexible && solids(design).next().is_some()
}

/// Makes the reductions that a study needs, or finds them, and says so; what there is to note of them is answered.
pub(crate) fn prepare(design: &Design, study: &Study, progress: &mut dyn Progress) -> Result<Vec<String>, End> {
    let mut notes = Vec::new();
    for (body, form) in solids(design).filter(|_| study.flexible) {
        let found = design.reductions.get(design, &study.values, body, form, progress)?;
        notes.extend(found.notes.iter().chain(&found.reduced.notes).cloned());
    }
    Ok(notes)
}

/// The reduction of one flexible solid in a study.
pub(crate) fn of_body(design: &Design, study: &Study, body: usize, progress: &mut dyn Progress) -> Result<Found, End> {
    match &design.bodies[body].flexible {
        Some(form) => design.reductions.get(design, &study.values, body, form, progress),
        None => Err(ended(format!("body `{}` is rigid", design.bodies[body].name), "")),
    }
}

/// Puts at hand what a body has that keeps fewer modes than `most` did, and is the same otherwise.
pub(crate) fn keep_fewer(design: &Design, study: &Study, body: usize, most: &Reduced) -> Result<(), End> {
    let Some(form) = &design.bodies[body].flexible else { return Ok(()) };
    design.reductions.put(design, &study.values, body, form, most.with_fewer(form.modes.count))
}

/// Makes the flexible bodies of a machine deform that was built rigid. Reductions are those of `plain`, the values
/// without derivatives.
pub(crate) fn deform<T: Scalar>(
    design: &Design,
    plain: &Values,
    values: &Values<T>,
    built: &mut Built<T>,
) -> Result<(), End> {
    let mut found = Vec::new();
    for (body, form) in solids(design) {
        found.push((body, design.reductions.get(design, plain, body, form, &mut Silent)?));
    }
    build::deform(design, values, built, &found).map_err(|(body, fault)| no_beam(&design.bodies[body].name, fault))
}

/// Numbers were checked when the model was read; parameters of a study over designs may leave what they allow.
fn no_beam(body: &str, fault: BeamFault) -> End {
    let message = match fault {
        BeamFault::Length(length) => format!("a segment of the beam of body `{body}` is {length} m long"),
        BeamFault::Stiffness(which, value) => format!("the beam of body `{body}` has {which} = {value}"),
        BeamFault::Mass(which, value) => format!("the beam of body `{body}` has {which} = {value}"),
        BeamFault::Axes(_) => format!("the section of the beam of body `{body}` has no direction"),
        BeamFault::Modes(count) => format!("{count} modes of the beam of body `{body}` are more than it has"),
    };
    ended(message, "")
}
