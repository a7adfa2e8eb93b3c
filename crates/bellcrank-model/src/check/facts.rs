//! Counting, and what the assembled mechanism says about itself.

use bellcrank_multibody::Freedom;
use bellcrank_results::{Failure, Programme};

use super::{BodyFact, Check, JointFact, SolidFact, notes};
use crate::Model;
use crate::build::{self, ElasticNumbers, MaterialNumbers};
use crate::design::{Design, Joint};
use crate::measure::Measure;
use crate::run::{Namer, failure, programme};

/// All there is to say before anything runs.
pub(crate) fn check(model: &Model) -> Check {
    Check { programmes: programmes(model), ..counted(model) }
}

/// The programmes of studies, each once.
fn programmes(model: &Model) -> Vec<(Vec<String>, Programme)> {
    let mut all: Vec<(Vec<String>, Programme)> = Vec::new();
    for study in model.study_list() {
        let Some(found) = programme(model.design(), study) else { continue };
        match all.iter_mut().find(|(_, known)| *known == found) {
            Some((names, _)) => names.push(study.name.clone()),
            None => all.push((vec![study.name.clone()], found)),
        }
    }
    all
}

/// The same without the programmes of studies, which have to be assembled for them.
pub(crate) fn counted(model: &Model) -> Check {
    let design = model.design();
    let (freedom, failure) = assembled(model);
    let assembled = failure.is_none();
    let namer = Namer::new(design);
    let closing: Vec<&str> = freedom.closing.iter().map(|&joint| namer.joint(joint)).collect();
    let redundant = freedom.redundant.iter().map(|one| format!("`{}` {}", namer.joint(one.joint), one.equation));
    Check {
        model: model.name().to_owned(),
        title: model.title().to_owned(),
        space: model.space(),
        bodies: bodies(model),
        joints: design.joints.iter().map(|joint| joint_fact(design, joint, &closing)).collect(),
        forces: model.forces().into_iter().map(str::to_owned).collect(),
        studies: model.studies(),
        coordinates: freedom.coordinates,
        equations: freedom.equations,
        rank: assembled.then_some(freedom.rank),
        counted: freedom.counted,
        degrees: assembled.then_some(freedom.degrees),
        loops: freedom.loops,
        redundant: redundant.collect(),
        mobile: freedom.mobile.iter().map(|&c| namer.coordinate(c)).collect(),
        special: freedom.special,
        notes: notes::notes(model, &freedom),
        programmes: Vec::new(),
        failure,
    }
}

/// The mechanism where its starts put it; the loops are counted even when they cannot be closed.
fn assembled(model: &Model) -> (Freedom, Option<Failure>) {
    let Ok(mut engine) = model.engine() else { return (Freedom::default(), None) };
    let outcome = engine.assemble(&[]);
    let freedom = engine.freedom();
    let namer = Namer::new(model.design());
    (freedom, outcome.err().map(|error| failure(&namer, &error, "the mechanism at its starts", "")))
}

fn bodies(model: &Model) -> Vec<BodyFact> {
    let design = model.design();
    let joints_at = |body: usize| {
        let at = |joint: &&Joint| joint.connects.is_some_and(|ends| ends.iter().any(|end| end.body == body));
        design.joints.iter().filter(at).map(|joint| joint.name.clone()).collect()
    };
    let numbers = &model.built().blueprint.bodies;
    let fact = |(index, body): (usize, &crate::design::Body)| BodyFact {
        name: body.name.clone(),
        mass: numbers.get(index).map_or(0.0, |body| body.mass),
        joints: joints_at(index),
        solid: solid_fact(model, index),
    };
    design.bodies.iter().enumerate().skip(1).map(fact).collect()
}

fn properties(of: &MaterialNumbers) -> Vec<(&'static str, Vec<f64>, &'static str)> {
    let mut told = Vec::new();
    let mut tell = |key, values: &[f64], unit| told.push((key, values.to_vec(), unit));
    if let Some(density) = of.density {
        tell("density", &[density], "kg/m^3");
    }
    match of.elastic {
        Some(ElasticNumbers::Isotropic { young, poisson }) => {
            tell("young", &[young], "Pa");
            tell("poisson", &[poisson], "");
        }
        Some(ElasticNumbers::Orthotropic { young, poisson, shear }) => {
            tell("young", &young, "Pa");
            tell("poisson", &poisson, "");
            tell("shear", &shear, "Pa");
        }
        None => {}
    }
    if let Some(strength) = of.strength {
        tell("yield", &[strength], "Pa");
    }
    if let Some(tensile) = of.tensile {
        tell("tensile", &[tensile], "Pa");
    }
    if let Some(fatigue) = &of.fatigue {
        tell("fatigue.amplitude", &[fatigue.line.amplitude], "Pa");
    }
    if let Some(expansion) = of.expansion {
        tell("expansion", &expansion, "1/K");
    }
    told
}

/// The solid of a body in numbers.
pub(crate) fn solid_fact(model: &Model, body: usize) -> Option<SolidFact> {
    let (design, built) = (model.design(), model.built());
    let of = design.bodies.get(body)?;
    let solid = design.solids.get(of.solid.as_ref()?.solid)?;
    let numbers = built.blueprint.bodies.get(body)?;
    let material = solid.material?;
    Some(SolidFact {
        body: of.name.clone(),
        solid: solid.name.clone(),
        material: design.materials.get(material)?.name.clone(),
        properties: properties(&build::material(design, &model.own_values(), material, &mut Vec::new())?),
        volume: built.volume(body)?,
        mass: numbers.mass,
        center: numbers.center,
        inertia: numbers.inertia,
        length: design.units.of(Measure::Length),
    })
}

fn joint_fact(design: &Design, joint: &Joint, closing: &[&str]) -> JointFact {
    let name = |end: &crate::design::PointRef| design.bodies[end.body].name.clone();
    JointFact {
        name: joint.name.clone(),
        kind: joint.kind.to_owned(),
        bodies: joint.connects.iter().flatten().map(name).collect(),
        closes: closing.contains(&joint.name.as_str()),
    }
}
