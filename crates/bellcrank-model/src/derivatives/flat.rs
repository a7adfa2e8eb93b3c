//! All numbers of a model in a row.

use bellcrank_multibody::{Body, Force, Joint, JointKind, Place, Value};

use crate::build::Built;
use crate::geometry::Extent;
use crate::scalar::Scalar;

pub(super) fn numbers<T: Scalar>(built: &Built<T>) -> Vec<T> {
    let mut all = built.blueprint.gravity.to_vec();
    built.blueprint.bodies.iter().for_each(|one| body(one, &mut all));
    built.blueprint.joints.iter().for_each(|one| joint(one, &mut all));
    built.blueprint.forces.iter().for_each(|one| force(one, &mut all));
    built.geometry.points.iter().flatten().for_each(|one| place(one, &mut all));
    for span in built.geometry.spans.iter().flatten() {
        if let Extent::Between(ends) = span {
            all.extend(ends.iter().flat_map(|(_, at)| at));
        }
    }
    all
}

fn body<T: Scalar>(body: &Body<T>, all: &mut Vec<T>) {
    all.push(body.mass);
    all.extend(body.center);
    all.extend(body.inertia.as_flattened());
}

fn place<T: Scalar>(place: &Place<T>, all: &mut Vec<T>) {
    all.extend(place.position);
    all.extend(place.rotation.as_flattened());
}

fn joint<T: Scalar>(joint: &Joint<T>, all: &mut Vec<T>) {
    joint.places.iter().flatten().for_each(|one| place(one, all));
    all.extend(joint.start.iter().flatten());
    match &joint.kind {
        JointKind::Revolute { axis }
        | JointKind::Prismatic { axis }
        | JointKind::Cylindrical { axis }
        | JointKind::PointOnLine { axis } => all.extend(axis),
        JointKind::Screw { axis, pitch } => all.extend(axis.iter().chain([pitch])),
        JointKind::Universal { axis, axis2 } => all.extend(axis.iter().chain(axis2)),
        JointKind::Distance { length } => all.extend(length),
        JointKind::Coupler { ratio, offset, .. } => all.extend([ratio, offset]),
        JointKind::Spherical
        | JointKind::Planar
        | JointKind::Free
        | JointKind::Elastic
        | JointKind::Modes { .. }
        | JointKind::Weld => {}
    }
}

fn force<T: Scalar>(force: &Force<T>, all: &mut Vec<T>) {
    let mut values = Vec::new();
    match force {
        Force::Point { at, vector, .. } => {
            place(at, all);
            values.extend(vector);
        }
        Force::Torque { vector, .. } => values.extend(vector),
        Force::Effort { value, .. } => values.push(value),
        Force::Spring { between, stiffness, damping, free_length, preload } => {
            between.iter().for_each(|one| place(one, all));
            values.extend([stiffness, damping, free_length, preload]);
        }
        Force::JointSpring { stiffness, damping, free_position, preload, .. } => {
            values.extend([stiffness, damping, free_position, preload]);
        }
        Force::Friction {
            coulomb, static_coefficient, stribeck_velocity, viscous, radius, smoothing_velocity, ..
        } => {
            values.extend([coulomb, viscous]);
            values.extend([static_coefficient, stribeck_velocity, radius, smoothing_velocity].into_iter().flatten());
        }
        Force::Stop { min, max, stiffness, damping, restitution, .. } => {
            values.extend([stiffness, damping]);
            values.extend([min, max, restitution].into_iter().flatten());
        }
        Force::Bushing { between, stiffness, damping } => {
            between.iter().for_each(|one| place(one, all));
            values.extend(stiffness.iter().chain(damping));
        }
    }
    all.extend(values.into_iter().filter_map(|value| match value {
        Value::Constant(number) => Some(*number),
        Value::Input(_) => None,
    }));
}
