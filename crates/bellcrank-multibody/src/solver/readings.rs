//! Answers of a solved position, over any scalar.

use crate::constraint::Measure;
use crate::flexible::Deforming;
use crate::forces::{Element, Output};
use crate::mechanism::{Mechanism, Source};
use crate::workspace::NodeState;
use crate::{BodyId, BodyMotion, Coordinate, Energy, ForceId, ForceOutput, JointId, PointMotion, Reading, Wrench};
use bellcrank_math::{Components, Real, Space};

/// A solved position: what answers are read from.
#[derive(Clone, Copy)]
pub(crate) struct Solved<'a, S: Space> {
    pub(crate) mech: &'a Mechanism<S>,
    pub(crate) q: &'a [S::T],
    pub(crate) v: &'a [S::T],
    pub(crate) a: &'a [S::T],
    pub(crate) x: &'a [NodeState<S>],
    pub(crate) lambda: &'a [S::T],
    pub(crate) wrench: &'a [(S::Vector, S::Angular)],
    pub(crate) outputs: &'a [Output<S>],
    /// Measured angles with the turns they have made.
    pub(crate) unwrapped: &'a [Vec<f64>],
}

impl<S: Space> Solved<'_, S> {
    pub(crate) fn coordinate(&self, c: Coordinate) -> Reading<S::T> {
        match self.mech.source(c) {
            None => {
                let nan = S::T::from_f64(f64::NAN);
                Reading { position: nan, velocity: nan, acceleration: nan }
            }
            Some(Source::Node(n)) => {
                let node = &self.mech.nodes[n];
                Reading { position: self.q[node.q], velocity: self.v[node.v], acceleration: self.a[node.v] }
            }
            Some(Source::Measured { link, measure }) => self.measured(c, link, measure),
        }
    }

    fn measured(&self, c: Coordinate, link: usize, measure: Measure) -> Reading<S::T> {
        let link = &self.mech.links[link];
        let pose = link.pose(self.x);
        let (velocity, acceleration) = link.measure_rates(measure, &pose, &link.motion(self.x, &pose));
        let mut position = link.measure(measure, &pose).value;
        if measure.is_angle() {
            position = position.with_value(self.unwrapped[c.joint.0][c.index]);
        }
        Reading { position, velocity, acceleration }
    }

    pub(crate) fn point(&self, body: BodyId, at: [S::T; 3]) -> PointMotion<S::T> {
        let carried = &self.mech.bodies[body.0];
        let x = &self.x[carried.node];
        let p = x.p + S::rotate(&x.R, carried.frame.at(S::vector(&at)));
        motion_of::<S>(p, x.at(p))
    }

    pub(crate) fn body(&self, body: BodyId) -> BodyMotion<S::T> {
        let carried = &self.mech.bodies[body.0];
        let x = &self.x[carried.node];
        let (origin, rotation) = x.frame(&carried.frame).to_spatial();
        let p = x.p + S::rotate(&x.R, carried.center);
        let deforming = self.mech.flexible.iter().find(|flexible| flexible.data.body == body);
        let center = deforming.map_or_else(|| motion_of::<S>(p, x.at(p)), |body| self.deformed_center(body));
        BodyMotion { origin, rotation, omega: S::spread_angular(x.w), alpha: S::spread_angular(x.wd), center }
    }

    /// Motion of the centre of mass of a flexible body.
    fn deformed_center(&self, body: &Deforming<S>) -> PointMotion<S::T> {
        let x = &self.x[body.node];
        let frame = x.frame(&body.frame);
        let per_mass = S::T::one() / body.data.inertia.mass;
        let [place, rate, second] =
            body.flowed(self.x).map(|sum| S::rotate(&frame.rotation, S::vector(&sum)) * per_mass);
        let p = frame.origin + place;
        let (v, a) = x.at(p);
        let coriolis = S::cross(x.w, rate) * S::T::from_f64(2.0);
        motion_of::<S>(p, (v + rate, a + second + coriolis))
    }

    pub(crate) fn reaction(&self, joint: JointId) -> Wrench<S::T> {
        if let Some(i) = self.mech.couplings.iter().position(|c| c.joint == joint) {
            let (effort, zero) = (self.lambda[self.mech.link_rows + i], S::T::zero());
            return Wrench { force: [effort, zero, zero], moment: [zero; 3] };
        }
        let (f, n) = self.wrench[joint.0];
        Wrench { force: S::spread(f), moment: S::spread_angular(n) }
    }

    pub(crate) fn force(&self, force: ForceId) -> ForceOutput<S::T> {
        let Some(out) = self.outputs.get(force.0) else { return ForceOutput::default() };
        let torque = matches!(self.mech.elements[force.0], Element::Torque { .. });
        let vector = if torque { S::spread_angular(out.moment) } else { S::spread(out.force) };
        ForceOutput { length: out.length, rate: out.rate, effort: out.effort, vector }
    }

    pub(crate) fn energy(&self) -> Energy<S::T> {
        let half = S::T::from_f64(0.5);
        let potential = self.outputs.iter().fold(S::T::zero(), |sum, o| sum + o.energy);
        let mut energy = Energy { kinetic: S::T::zero(), potential };
        for (node, x) in self.mech.nodes.iter().zip(self.x) {
            if let Some(body) = &node.inertia {
                let p = x.p + S::rotate(&x.R, body.center);
                let v = x.at(p).0;
                let h = S::apply_inertia(&body.about_center, &x.R, x.w);
                energy.kinetic += half * (body.mass * v.dot(v) + x.w.dot(h));
                energy.potential -= body.mass * self.mech.gravity.dot(p);
            }
        }
        for body in &self.mech.flexible {
            let frame = self.x[body.node].frame(&body.frame);
            let first = S::rotate(&frame.rotation, S::vector(&body.rigid(self.x).0));
            let raised = frame.origin * body.data.inertia.mass + first;
            energy.kinetic += body.kinetic(self.x);
            energy.potential += body.elastic(self.x) - self.mech.gravity.dot(raised);
        }
        energy
    }
}

fn motion_of<S: Space>(p: S::Vector, (v, a): (S::Vector, S::Vector)) -> PointMotion<S::T> {
    PointMotion { position: S::spread(p), velocity: S::spread(v), acceleration: S::spread(a) }
}
