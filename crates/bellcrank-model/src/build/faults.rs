//! What a mechanism refuses, in names and places of the file.

use bellcrank_doc::{Diagnostic, Span};
use bellcrank_multibody::{BuildError, Coordinate, JointId};

use crate::design::{Body, Design, Joint};

/// The report of a blueprint that makes no mechanism.
pub(super) fn report(design: &Design, error: &BuildError) -> Diagnostic {
    let joint = |id: &JointId| design.joints.get(id.0);
    let named = |id: &JointId| joint(id).map_or(String::new(), |joint| format!("joint `{}`", joint.name));
    let at = |id: &JointId| joint(id).map_or(design.gravity_span, |joint| joint.span);
    match error {
        BuildError::NotInPlane(id) => {
            Diagnostic::error("not-in-plane", at(id), format!("{} has no meaning in the plane", named(id)))
        }
        BuildError::NoAxis(id) => {
            Diagnostic::error("no-axis", at(id), format!("the axis of {} has no length", named(id)))
        }
        BuildError::AxisOutOfPlane(id) => {
            Diagnostic::error("not-in-plane", at(id), format!("the axis of {} leaves the plane", named(id)))
        }
        BuildError::NotPerpendicular { joint: id, angle } => {
            let message =
                format!("the axes of {} are not perpendicular: {:.3} deg between them", named(id), angle.to_degrees());
            Diagnostic::error("not-perpendicular", at(id), message)
                .hint("`axis` in the first point's frame and `axis2` in the second's are perpendicular at zero angles")
        }
        BuildError::Places(id) => Diagnostic::error("wrong-length", at(id), format!("{} needs two points", named(id))),
        BuildError::Dangling(id) => Diagnostic::error(
            "no-coordinate",
            at(id),
            format!("{} refers to a coordinate that is not there", named(id)),
        ),
        BuildError::NoCoordinate(c) => Diagnostic::error(
            "no-coordinate",
            at(&c.joint),
            format!("{} has no coordinate {}", named(&c.joint), c.index),
        ),
        BuildError::Attitude(c) => attitude(*c, named(&c.joint), at(&c.joint)),
        BuildError::Flexible(body) => {
            let body = design.bodies.get(body.0);
            let (name, span) = body.map_or(("", design.gravity_span), |body| (body.name.as_str(), body.span));
            Diagnostic::error("flexible", span, format!("body `{name}` cannot be flexible: its reduction does not fit"))
        }
    }
}

fn attitude(c: Coordinate, joint: String, span: Span) -> Diagnostic {
    let message = format!("coordinate {} of {joint} cannot be coupled or loaded alone", c.index);
    Diagnostic::error("attitude", span, message)
        .hint("the three angles of free turning belong together; use a `torque` on the body, or hinges in a row")
}

/// Bodies that no chain of joints leads to from the ground: a warning each. Parts in a file without joints are looked at
/// by themselves.
pub(crate) fn check_connected(design: &Design) -> Vec<Diagnostic> {
    if design.joints.is_empty() && design.bodies.iter().skip(1).all(|body| body.solid.is_some() || body.rod.is_some()) {
        return Vec::new();
    }
    let warning = |body: &Body| {
        let message = format!("body `{}` is not connected to the ground", body.name);
        let hint = "connect it by a joint; one of kind `free` lets it move any way";
        Diagnostic::warning("unconnected-body", body.span, message).hint(hint)
    };
    loose_bodies(design).into_iter().map(warning).collect()
}

/// Bodies that no chain of joints leads to from the ground.
pub(crate) fn loose_bodies(design: &Design) -> Vec<&Body> {
    let reached = reached(design.bodies.len(), &design.joints);
    design.bodies.iter().zip(reached).filter(|(_, reached)| !reached).map(|(body, _)| body).collect()
}

fn reached(bodies: usize, joints: &[Joint]) -> Vec<bool> {
    let mut neighbours = vec![Vec::new(); bodies];
    for [a, b] in joints.iter().filter_map(|joint| joint.connects) {
        neighbours[a.body].push(b.body);
        neighbours[b.body].push(a.body);
    }
    let mut reached = vec![false; bodies];
    let mut next = vec![0];
    while let Some(body) = next.pop() {
        if !std::mem::replace(&mut reached[body], true) {
            next.extend(neighbours[body].iter().copied());
        }
    }
    reached
}
