//! What takes hold of a flexible body does so at one of its interfaces.

use bellcrank_doc::Diagnostic;
use bellcrank_math::Real;
use bellcrank_multibody::{Axes, BodyId, Force, Place};

use super::chain::along;
use crate::build::rods::rod_of;
use crate::build::{Built, Numbers};
use crate::design::{Design, Flexible, holds};
use crate::geometry::Extent;
use crate::scalar::Scalar;

/// Two places are one when they are this near, relative to the size of the body.
const SAME: f64 = 1e-9;

/// An interface: a place in the axes of the flexible body, and the body that stands for it, whose origin is there.
pub(super) struct Grip<T> {
    pub(super) at: [T; 3],
    pub(super) body: BodyId,
}

/// Takes hold of the interfaces in place of the body.
struct Taking<'g, T> {
    body: BodyId,
    grips: &'g [Grip<T>],
    /// m
    near: f64,
}

/// Moves everything that is at an interface of a body onto the body that stands for the interface. What is elsewhere
/// stays on the floating frame.
pub(super) fn take_hold<T: Scalar>(design: &Design, built: &mut Built<T>, body: usize, grips: &[Grip<T>]) {
    let near = SAME * size(&built.geometry.points[body]);
    let taking = Taking { body: BodyId(body), grips, near };
    let joints = &mut built.blueprint.joints[..design.joints.len()];
    joints.iter_mut().filter_map(|joint| joint.places.as_mut()).flatten().for_each(|place| taking.place(place));
    built.blueprint.forces.iter_mut().for_each(|force| taking.force(force));
    built.geometry.points[body].iter_mut().for_each(|place| taking.place(place));
    for extent in built.geometry.spans.iter_mut().flatten() {
        if let Extent::Between(ends) = extent {
            ends.iter_mut().for_each(|(body, at)| taking.end(body, at));
        }
    }
}

impl<T: Real> Taking<'_, T> {
    fn end(&self, body: &mut BodyId, at: &mut [T; 3]) {
        if *body != self.body {
            return;
        }
        let Some(grip) = self.grips.iter().find(|grip| apart(&grip.at, at) <= self.near) else { return };
        if grip.body != self.body {
            *body = grip.body;
            *at = std::array::from_fn(|i| at[i] - grip.at[i]);
        }
    }

    fn place(&self, place: &mut Place<T>) {
        self.end(&mut place.body, &mut place.position);
    }

    fn force(&self, force: &mut Force<T>) {
        match force {
            Force::Point { at, axes, .. } => {
                self.place(at);
                self.axes(axes);
            }
            Force::Torque { axes, .. } => self.axes(axes),
            Force::Spring { between, .. } | Force::Bushing { between, .. } => {
                between.iter_mut().for_each(|place| self.place(place));
            }
            Force::Effort { .. } | Force::JointSpring { .. } | Force::Friction { .. } | Force::Stop { .. } => {}
        }
    }

    fn axes(&self, axes: &mut Axes<T>) {
        if let Axes::Frame(place) = axes {
            self.place(place);
        }
    }
}

/// Reports what the numbers of flexible bodies are not fit for, and what takes hold of them where they have no interface.
pub(in crate::build) fn faults<T: Scalar>(numbers: &mut Numbers<'_, T>, points: &[Vec<Place<T>>]) {
    let design = numbers.design;
    for (index, (body, places)) in design.bodies.iter().zip(points).enumerate() {
        let Some(form) = &body.flexible else { continue };
        check(numbers, &body.name, form);
        off_axis(numbers, index, form, places);
        loose(numbers, index, form, places);
    }
}

fn check<T: Scalar>(numbers: &mut Numbers<'_, T>, name: &str, form: &Flexible) {
    if let Some(damping) = &form.damping {
        numbers.positive(damping, format_args!("`damping` of the flexible body `{name}`"));
    }
    if let Some(frequency) = &form.modes.frequency {
        numbers.above_zero(frequency, format_args!("`frequency` of the flexible body `{name}`"));
    }
    form.mesh.each_quantity(&mut |size| {
        numbers.above_zero(size, format_args!("a size in `mesh` of the flexible body `{name}`"));
    });
}

/// Interfaces of a beam lie on it.
fn off_axis<T: Scalar>(numbers: &mut Numbers<'_, T>, index: usize, form: &Flexible, places: &[Place<T>]) {
    const NEAR: f64 = 1e-6;
    let Some(rod) = rod_of(numbers.design, numbers.values, index, places) else { return };
    let (design, length) = (numbers.design, rod.length.value());
    let body = &design.bodies[index];
    for interface in &form.interfaces {
        let (share, off) = along(&rod, places[interface.value].position.map(T::value));
        if off <= NEAR * length && (-NEAR..=1.0 + NEAR).contains(&share) {
            continue;
        }
        let point = &body.points[interface.value].name;
        let message = format!("interface `{point}` of body `{}` is not on its beam", body.name);
        let report = Diagnostic::error("no-interface", interface.span, message);
        let hint = "points of a beam that are held lie on its axis; what stands off it is a body of its own, welded on";
        numbers.faults.push(report.hint(hint));
    }
}

fn loose<T: Scalar>(numbers: &mut Numbers<'_, T>, index: usize, form: &Flexible, places: &[Place<T>]) {
    let design = numbers.design;
    let body = &design.bodies[index];
    let near = SAME * size(places);
    let is_interface = |point: usize| {
        let same = |of: usize| apart(&places[of].position, &places[point].position) <= near;
        form.interfaces.iter().any(|interface| same(interface.value))
    };
    for held in holds(index, &design.joints, &design.forces, &design.bodies) {
        if is_interface(held.point) {
            continue;
        }
        let (name, point) = (&body.name, &body.points[held.point].name);
        let message =
            format!("{} takes hold of the flexible body `{name}` at `{point}`, which is no interface", held.by);
        let hint = format!("add `{point}` to its `interfaces`");
        let report = Diagnostic::error("no-interface", form.span, message).hint(hint);
        numbers.faults.push(match held.span {
            Some(span) => report.also(span, "this joint"),
            None => report,
        });
    }
}

fn apart<T: Real>(a: &[T; 3], b: &[T; 3]) -> f64 {
    (0..3).map(|i| (a[i].value() - b[i].value()).powi(2)).sum::<f64>().sqrt()
}

/// Largest distance of a point from the origin of its body.
fn size<T: Real>(places: &[Place<T>]) -> f64 {
    let origin = [T::zero(); 3];
    places.iter().map(|place| apart(&place.position, &origin)).fold(0.0, f64::max)
}
