//! How the hinges of a body lie in the eyes of its solid: what may be a slip.

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::{Joint as JointNumbers, JointKind, Place};
use bellcrank_solid::Link;

use crate::build::frames;
use crate::design::{Design, EyeForm, LinkForm, PointRef, Solid, Spot, Worn};
use crate::measure::Measure;
use crate::run::shown;

/// Sine of the angle between a hinge and its eye that is no rounding.
const ASKEW: f64 = 1e-3;

/// A link on its body.
pub(super) struct Attached<'a> {
    pub(super) design: &'a Design,
    pub(super) solid: &'a Solid,
    pub(super) worn: &'a Worn,
    pub(super) body: usize,
    pub(super) places: &'a [Place<f64>],
    pub(super) joints: &'a [JointNumbers<f64>],
}

impl Attached<'_> {
    /// A warning for each eye whose point is beside it along the axis, and for each hinge that turns about another axis.
    pub(super) fn warnings(&self, form: &LinkForm, link: &Link<f64>) -> Vec<Diagnostic> {
        let mut found = Vec::new();
        for (eye, numbers) in form.eyes.iter().zip(&link.eyes) {
            let Spot::Point(spot) = eye.at else { continue };
            let Some(&point) = self.worn.points.get(spot) else { continue };
            found.extend(self.beside(form, eye, &numbers.layers, point));
            found.extend(self.askew(form, eye, point));
        }
        found
    }

    fn beside(&self, form: &LinkForm, eye: &EyeForm, layers: &[[f64; 2]], point: usize) -> Option<Diagnostic> {
        let height = self.places.get(point)?.position[form.plane.axes()[2]];
        let low = layers.iter().map(|layer| layer[0]).fold(f64::INFINITY, f64::min);
        let high = layers.iter().map(|layer| layer[1]).fold(f64::NEG_INFINITY, f64::max);
        let slack = 1e-9 * (high - low).abs();
        if (low - slack..=high + slack).contains(&height) {
            return None;
        }
        let long = |length: f64| shown(length, &self.design.units.of(Measure::Length));
        let name = &self.design.bodies[self.body].points[point].name;
        let message = format!(
            "point `{name}` lies beside eye `{}` of solid `{}`: it is {} out of the plane, the eye reaches from {} to {}",
            eye.name,
            self.solid.name,
            long(height),
            long(low),
            long(high)
        );
        let report = Diagnostic::warning("out-of-plane", eye.span, message).also(self.worn.span, "on this body");
        Some(report.hint("`offset` of the eye puts it where the point is"))
    }

    fn askew(&self, form: &LinkForm, eye: &EyeForm, point: usize) -> Vec<Diagnostic> {
        let at = PointRef { body: self.body, point };
        let here = |joint: &crate::design::Joint| joint.connects.is_some_and(|ends| ends.contains(&at));
        let joints = self.design.joints.iter().zip(self.joints).filter(|(joint, _)| here(joint));
        let askew = joints.filter(|(_, numbers)| self.turns_aside(form, numbers, point));
        let report = |(joint, _): (&crate::design::Joint, _)| {
            let message = format!(
                "joint `{}` does not turn about the axis of eye `{}` of solid `{}`, where it is",
                joint.name, eye.name, self.solid.name
            );
            let report = Diagnostic::warning("out-of-plane", joint.span, message).also(eye.span, "this eye");
            report.hint("`plane` of the solid says which way its eyes point; axes of points turn by `rotate`")
        };
        askew.map(report).collect()
    }

    /// Whether a hinge at a point is not along the axis of the eyes.
    fn turns_aside(&self, form: &LinkForm, joint: &JointNumbers<f64>, point: usize) -> bool {
        let (JointKind::Revolute { axis } | JointKind::Cylindrical { axis } | JointKind::Screw { axis, .. }) =
            &joint.kind
        else {
            return false;
        };
        let Some(place) = self.places.get(point) else { return false };
        let [right, up, out] = form.plane.axes();
        let axis = frames::apply(&place.rotation, *axis);
        axis[right].hypot(axis[up]) > ASKEW * axis[out].abs()
    }
}
