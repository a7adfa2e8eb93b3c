//! Counting, and what the assembled mechanism says about itself.

use bellcrank_multibody::Freedom;
use bellcrank_results::{Failure, Programme};

use super::{BodyFact, Check, JointFact, notes};
use crate::Model;
use crate::design::{Design, Joint};
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
    };
    design.bodies.iter().enumerate().skip(1).map(fact).collect()
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
