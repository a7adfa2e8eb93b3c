//! The values of signals at the present position.

use bellcrank_math::{Real, rpy_from_matrix};
use bellcrank_multibody::{BodyId, Coordinate, ForceId, JointId, PointMotion, Readings};

use super::columns::reaction_components;
use super::{Catalogue, Level, Outputs, Source};
use crate::geometry::Geometry;
use crate::scalar::length;

/// Most signals that one source has.
pub(crate) const MOST: usize = 18;

/// A solved position and what is needed to name its numbers.
pub(crate) struct View<'a, T = f64> {
    pub(crate) readings: &'a dyn Readings<T>,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) geometry: &'a Geometry<T>,
    /// Coordinates that carry efforts, in the order of [`Readings::drive`].
    pub(crate) efforts: &'a [Coordinate],
    /// How far the position is solved; what lies beyond reads NaN.
    pub(crate) level: Level,
}

/// Fills a slice from its front.
struct Out<'a, T> {
    values: &'a mut [T],
    next: usize,
}

impl<T: Real> Out<'_, T> {
    fn push(&mut self, value: T) {
        if let Some(place) = self.values.get_mut(self.next) {
            *place = value;
        }
        self.next += 1;
    }

    fn extend(&mut self, values: &[T]) {
        values.iter().for_each(|&value| self.push(value));
    }
}

impl<T: Real> View<'_, T> {
    /// Values of the source's signals, SI, in the order of its columns.
    pub(crate) fn read(&self, source: Source, values: &mut [T]) {
        values.fill(T::from_f64(f64::NAN));
        let mut out = Out { values, next: 0 };
        match source {
            Source::Time => out.push(self.readings.time()),
            Source::Joint(c) => {
                let at = self.readings.coordinate(c);
                out.extend(&[at.position, at.velocity, at.acceleration]);
            }
            Source::Drive(c) => self.drive(c, &mut out),
            Source::Reaction(joint) => self.reaction(joint, &mut out),
            Source::Point { body, point } => {
                let at = self.geometry.points.get(body).and_then(|points| points.get(point));
                let (on, at) = at.map_or((BodyId(body), [T::zero(); 3]), |place| (place.body, place.position));
                self.point(&self.readings.point(on, at), &mut out);
            }
            Source::Body(body) => self.body(BodyId(body), &mut out),
            Source::Force(force) => self.force(force, &mut out),
            Source::Stress(body) => self.stress(body, &mut out),
            Source::Energy => {
                let energy = self.readings.energy();
                out.extend(&[energy.kinetic, energy.potential, energy.kinetic + energy.potential]);
            }
            Source::Check => {
                let checks = self.readings.checks();
                out.extend(&[checks.closure, checks.balance].map(T::from_f64));
            }
        }
    }

    fn planar(&self) -> bool {
        self.catalogue.layout().planar
    }

    fn solved(&self) -> bool {
        self.level >= Level::Force
    }

    fn drive(&self, c: Coordinate, out: &mut Out<'_, T>) {
        let place = self.efforts.iter().position(|&effort| effort == c);
        if let Some(place) = place.filter(|_| self.solved()) {
            let effort = self.readings.drive(place);
            out.extend(&[effort, effort * self.readings.coordinate(c).velocity]);
        }
    }

    fn stress(&self, body: usize, out: &mut Out<'_, T>) {
        let layout = self.catalogue.layout().stresses.iter().find(|(of, _)| *of == body);
        let found = self.geometry.stresses.iter().find(|stressed| stressed.body == body);
        let (Some((_, regions)), Some(found)) = (layout, found.filter(|_| self.solved())) else { return };
        regions.iter().for_each(|region| out.push(found.largest(region, self.readings)));
    }

    fn reaction(&self, joint: usize, out: &mut Out<'_, T>) {
        if !self.solved() {
            return;
        }
        let wrench = self.readings.reaction(JointId(joint));
        if self.catalogue.layout().joints.get(joint).is_some_and(|joint| joint.coupler) {
            out.push(wrench.force[0]);
            return;
        }
        for &(_, place) in reaction_components(self.planar()) {
            out.push(if place < 3 { wrench.force[place] } else { wrench.moment[place - 3] });
        }
        out.extend(&[length(wrench.force), length(wrench.moment)]);
    }

    fn point(&self, motion: &PointMotion<T>, out: &mut Out<'_, T>) {
        let axes = if self.planar() { 2 } else { 3 };
        for vector in [motion.position, motion.velocity, motion.acceleration] {
            out.extend(&vector[..axes]);
        }
    }

    fn body(&self, body: BodyId, out: &mut Out<'_, T>) {
        let motion = self.readings.body(body);
        self.point(&motion.center, out);
        if self.planar() {
            let angle = motion.rotation[1][0].atan2(motion.rotation[0][0]);
            out.extend(&[angle, motion.omega[2], motion.alpha[2]]);
        } else {
            out.extend(&rpy_from_matrix(&motion.rotation));
            out.extend(&motion.omega);
            out.extend(&motion.alpha);
        }
    }

    fn force(&self, force: usize, out: &mut Out<'_, T>) {
        let outputs = self.catalogue.layout().forces.get(force).map(|force| force.outputs);
        if let Some(Outputs::Element(_)) = outputs {
            out.extend(&self.geometry.element(force, self.readings));
        }
        if !self.solved() {
            return;
        }
        let of = self.readings.force(ForceId(force));
        match outputs {
            Some(Outputs::Force) => out.extend(if self.planar() { &of.vector[..2] } else { &of.vector }),
            Some(Outputs::Torque) => out.extend(if self.planar() { &of.vector[2..] } else { &of.vector }),
            _ => {}
        }
        out.push(of.effort);
    }
}
