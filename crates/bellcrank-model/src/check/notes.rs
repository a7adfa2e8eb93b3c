//! What is missing or suspicious in a model that can be used.

use std::collections::HashSet;

use bellcrank_multibody::Freedom;

use crate::Model;
use crate::design::{Body, Design, ForceShape, Load, Quantity, ScopeId};

pub(super) fn notes(model: &Model, freedom: &Freedom) -> Vec<String> {
    let design = model.design();
    let mut notes = Vec::new();
    if design.bodies.len() == 1 {
        notes.push("the model has no bodies".to_owned());
    }
    if freedom.special {
        let note = "the assembled position is special: near it the mechanism can move in fewer or more ways; start \
                    studies elsewhere";
        notes.push(note.to_owned());
    }
    notes.extend(loose_ends(model));
    notes.extend(still_masses(model));
    notes.extend(round_discs(model));
    let unused = unused_parameters(model);
    if !unused.is_empty() {
        notes.push(format!("parameters that nothing uses: {}", unused.join(", ")));
    }
    notes
}

/// Massless bodies at one joint that nothing loads: they carry no force and swing by nothing. What is welded does not.
fn loose_ends(model: &Model) -> Vec<String> {
    let design = model.design();
    let mut joints_at = vec![0; design.bodies.len()];
    for (joint, end) in
        design.joints.iter().flat_map(|joint| joint.connects.into_iter().flatten().map(move |end| (joint, end)))
    {
        joints_at[end.body] += if joint.kind == "weld" { 2 } else { 1 };
    }
    let loaded = loaded_bodies(design);
    let loose = |&(index, _): &(usize, &Body)| {
        index > 0
            && joints_at[index] == 1
            && model.built().blueprint.bodies[index].mass == 0.0
            && !loaded.contains(&index)
    };
    let note = |(_, body): (usize, &Body)| {
        format!("body `{}` is massless, at one joint, and nothing loads it: is it meant to move?", body.name)
    };
    design.bodies.iter().enumerate().filter(loose).map(note).collect()
}

fn loaded_bodies(design: &Design) -> HashSet<usize> {
    let mut loaded = HashSet::new();
    for force in &design.forces {
        match &force.shape {
            ForceShape::Point { at, .. } => {
                loaded.insert(at.body);
            }
            ForceShape::Torque { on, .. } => {
                loaded.insert(*on);
            }
            ForceShape::Spring { between, .. } | ForceShape::Bushing { between, .. } => {
                loaded.extend(between.iter().map(|at| at.body));
            }
            _ => {}
        }
    }
    loaded
}

/// Massive bodies whose centre of mass is at their origin for want of a `center`.
fn still_masses(model: &Model) -> Vec<String> {
    let design = model.design();
    let masses = &model.built().blueprint.bodies;
    let without = |(body, numbers): &(&Body, &bellcrank_multibody::Body<f64>)| {
        numbers.mass > 0.0
            && body.center.is_none()
            && body.solid.is_none()
            && body.rod.is_none()
            && body.points.len() > 1
    };
    let names: Vec<&str> =
        design.bodies.iter().zip(masses).skip(1).filter(without).map(|(body, _)| body.name.as_str()).collect();
    if names.is_empty() {
        return Vec::new();
    }
    vec![format!("no `center` given, so the centre of mass is at the origin: {}", names.join(", "))]
}

/// Bodies of planar files in space whose moments about the axes of the plane are not given.
fn round_discs(model: &Model) -> Option<String> {
    let design = model.design();
    let one_moment = |(body, numbers): &(&Body, &bellcrank_multibody::Body<f64>)| {
        body.planar && body.inertia.as_ref().is_some_and(|values| values.len() == 1) && numbers.inertia[2][2] > 0.0
    };
    let bodies = design.bodies.iter().zip(&model.built().blueprint.bodies).filter(one_moment);
    let names: Vec<&str> = bodies.map(|(body, _)| body.name.as_str()).collect();
    (!design.planar && !names.is_empty()).then(|| {
        format!(
            "of planar files, with one moment of inertia: half of it counts about each axis of the plane, as of a round \
             disc; `[Ixx, Iyy, Izz]` says otherwise: {}",
            names.join(", ")
        )
    })
}

/// Parameters of the main file that no value, motion or other parameter uses. Those of a subsystem may be there for its
/// own studies.
fn unused_parameters(model: &Model) -> Vec<String> {
    let design = model.design();
    let mut used = Used::default();
    used.design(design);
    for study in model.study_list() {
        used.study(study);
    }
    used.parameters(design);
    let own = design.scopes.first().map_or(&[][..], |of| of.parameters.all());
    let loose = own.iter().enumerate().filter(|(index, _)| !used.pairs.contains(&(0, *index)));
    loose.map(|(_, parameter)| parameter.name.clone()).collect()
}

/// Parameters in use: scope and index.
#[derive(Default)]
struct Used {
    pairs: HashSet<(usize, usize)>,
}

impl Used {
    fn expression(&mut self, scope: ScopeId, expression: &bellcrank_doc::Expression) {
        self.pairs.extend(expression.parameters().into_iter().map(|index| (scope.0, index)));
    }

    fn quantity(&mut self, quantity: &Quantity) {
        self.expression(quantity.scope, &quantity.expression);
    }

    fn quantities<'q>(&mut self, quantities: impl IntoIterator<Item = &'q Quantity>) {
        quantities.into_iter().for_each(|quantity| self.quantity(quantity));
    }

    fn design(&mut self, design: &Design) {
        self.quantities(&design.gravity);
        for body in &design.bodies {
            self.quantities(&body.mass);
            self.quantities(body.center.iter().flatten());
            self.quantities(body.inertia.iter().flatten());
            for point in &body.points {
                self.quantities(&point.at);
                point.rotation.each_quantity(&mut |quantity| self.quantity(quantity));
            }
            if let Some(flexible) = &body.flexible {
                flexible.each_quantity(&mut |quantity| self.quantity(quantity));
            }
        }
        for material in &design.materials {
            material.each_quantity(&mut |quantity| self.quantity(quantity));
        }
        for solid in &design.solids {
            solid.form.each_quantity(&mut |quantity| self.quantity(quantity));
        }
        for beam in &design.beams {
            beam.each_quantity(&mut |quantity| self.quantity(quantity));
        }
        for joint in &design.joints {
            self.quantities(joint.start.iter().flatten());
            self.quantities(joint.start_velocity.iter().flatten());
            joint.shape.each_quantity(&mut |quantity| self.quantity(quantity));
        }
        for force in &design.forces {
            force.shape.each_load(&mut |load| {
                if let Load::Fixed(quantity) = load {
                    self.quantity(quantity);
                }
            });
        }
        for input in &design.inputs {
            self.expression(input.scope, &input.expression);
        }
        for motion in &design.motions {
            motion.each_quantity(&mut |quantity| self.quantity(quantity));
        }
    }

    fn study(&mut self, study: &crate::design::Study) {
        study.task.each_quantity(&mut |quantity| self.quantity(quantity));
        // A parameter that a later kind of study varies is there for a purpose.
        self.pairs.extend(study.named.iter().map(|&index| (0, index)));
    }

    /// Parameters that other parameters in use are made of.
    fn parameters(&mut self, design: &Design) {
        for (scope, of) in design.scopes.iter().enumerate().rev() {
            if let Some((parent, given)) = &of.parent {
                for (_, expression) in given {
                    self.expression(*parent, expression);
                }
            }
            for parameter in of.parameters.all() {
                self.expression(ScopeId(scope), &parameter.expression);
            }
        }
    }
}
