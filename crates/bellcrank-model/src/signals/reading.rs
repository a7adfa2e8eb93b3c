//! The values of signals at the present position.

use bellcrank_math::rpy_from_matrix;
use bellcrank_multibody::{BodyId, Coordinate, Engine, ForceId, JointId, PointMotion};

use super::columns::reaction_components;
use super::{Catalogue, Level, Outputs, Source};
use crate::geometry::Geometry;

/// Most signals that one source has.
pub(crate) const MOST: usize = 18;

/// A solved position and what is needed to name its numbers.
pub(crate) struct View<'a> {
    pub(crate) engine: &'a dyn Engine,
    pub(crate) catalogue: &'a Catalogue,
    pub(crate) geometry: &'a Geometry,
    /// Coordinates that carry efforts, in the order of [`Engine::drive`].
    pub(crate) efforts: &'a [Coordinate],
    /// How far the position is solved; what lies beyond reads NaN.
    pub(crate) level: Level,
}

/// Fills a slice from its front.
struct Out<'a> {
    values: &'a mut [f64],
    next: usize,
}

impl Out<'_> {
    fn push(&mut self, value: f64) {
        if let Some(place) = self.values.get_mut(self.next) {
            *place = value;
        }
        self.next += 1;
    }

    fn extend(&mut self, values: &[f64]) {
        values.iter().for_each(|&value| self.push(value));
    }
}

impl View<'_> {
    /// Values of the source's signals, SI, in the order of its columns.
    pub(crate) fn read(&self, source: Source, values: &mut [f64]) {
        values.fill(f64::NAN);
        let mut out = Out { values, next: 0 };
        match source {
            Source::Time => out.push(self.engine.time()),
            Source::Joint(c) => {
                let at = self.engine.coordinate(c);
                out.extend(&[at.position, at.velocity, at.acceleration]);
            }
            Source::Drive(c) => self.drive(c, &mut out),
            Source::Reaction(joint) => self.reaction(joint, &mut out),
            Source::Point { body, point } => {
                let at = self.geometry.points.get(body).and_then(|points| points.get(point));
                self.point(&self.engine.point(BodyId(body), at.map_or([0.0; 3], |place| place.position)), &mut out);
            }
            Source::Body(body) => self.body(BodyId(body), &mut out),
            Source::Force(force) => self.force(force, &mut out),
            Source::Energy => {
                let energy = self.engine.energy();
                out.extend(&[energy.kinetic, energy.potential, energy.kinetic + energy.potential]);
            }
            Source::Check => {
                let checks = self.engine.checks();
                out.extend(&[checks.closure, checks.balance]);
            }
        }
    }

    fn planar(&self) -> bool {
        self.catalogue.layout().planar
    }

    fn solved(&self) -> bool {
        self.level >= Level::Force
    }

    fn drive(&self, c: Coordinate, out: &mut Out<'_>) {
        let place = self.efforts.iter().position(|&effort| effort == c);
        if let Some(place) = place.filter(|_| self.solved()) {
            let effort = self.engine.drive(place);
            out.extend(&[effort, effort * self.engine.coordinate(c).velocity]);
        }
    }

    fn reaction(&self, joint: usize, out: &mut Out<'_>) {
        if !self.solved() {
            return;
        }
        let wrench = self.engine.reaction(JointId(joint));
        if self.catalogue.layout().joints.get(joint).is_some_and(|joint| joint.coupler) {
            out.push(wrench.force[0]);
            return;
        }
        for &(_, place) in reaction_components(self.planar()) {
            out.push(if place < 3 { wrench.force[place] } else { wrench.moment[place - 3] });
        }
        out.extend(&[length(wrench.force), length(wrench.moment)]);
    }

    fn point(&self, motion: &PointMotion, out: &mut Out<'_>) {
        let axes = if self.planar() { 2 } else { 3 };
        for vector in [motion.position, motion.velocity, motion.acceleration] {
            out.extend(&vector[..axes]);
        }
    }

    fn body(&self, body: BodyId, out: &mut Out<'_>) {
        let motion = self.engine.body(body);
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

    fn force(&self, force: usize, out: &mut Out<'_>) {
        let outputs = self.catalogue.layout().forces.get(force).map(|force| force.outputs);
        if let Some(Outputs::Element(_)) = outputs {
            out.extend(&self.geometry.element(force, self.engine));
        }
        if !self.solved() {
            return;
        }
        let of = self.engine.force(ForceId(force));
        match outputs {
            Some(Outputs::Force) => out.extend(if self.planar() { &of.vector[..2] } else { &of.vector }),
            Some(Outputs::Torque) => out.extend(if self.planar() { &of.vector[2..] } else { &of.vector }),
            _ => {}
        }
        out.push(of.effort);
    }
}

fn length(vector: [f64; 3]) -> f64 {
    vector.iter().map(|x| x * x).sum::<f64>().sqrt()
}
