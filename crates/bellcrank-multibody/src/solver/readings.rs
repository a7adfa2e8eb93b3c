//! Answers in plain numbers.

use super::machine::{Machine, Stage};
use crate::forces::Element;
use crate::mechanism::Source;
use crate::{BodyId, BodyMotion, Coordinate, Energy, ForceId, ForceOutput, JointId, PointMotion, Reading, Wrench};
use bellcrank_math::{Components, Space};

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn read_coordinate(&self, c: Coordinate) -> Reading {
        match self.mech.source(c) {
            None => Reading { position: f64::NAN, velocity: f64::NAN, acceleration: f64::NAN },
            Some(Source::Node(n)) => {
                let node = &self.mech.nodes[n];
                Reading { position: self.q[node.q], velocity: self.v[node.v], acceleration: self.a[node.v] }
            }
            Some(Source::Measured { link, measure }) => {
                let link = &self.mech.links[link];
                let pose = link.pose(&self.x);
                let (velocity, acceleration) = link.measure_rates(measure, &pose, &link.motion(&self.x, &pose));
                let position = if measure.is_angle() {
                    self.unwrapped[c.joint.0][c.index]
                } else {
                    link.measure(measure, &pose).value
                };
                Reading { position, velocity, acceleration }
            }
        }
    }

    pub(crate) fn read_point(&self, body: BodyId, at: [f64; 3]) -> PointMotion {
        let carried = &self.mech.bodies[body.0];
        let x = &self.x[carried.node];
        let p = x.p + S::rotate(&x.R, carried.frame.at(S::vector(&at)));
        motion_of::<S>(p, x.at(p))
    }

    pub(crate) fn read_body(&self, body: BodyId) -> BodyMotion {
        let carried = &self.mech.bodies[body.0];
        let x = &self.x[carried.node];
        let (origin, rotation) = x.frame(&carried.frame).to_spatial();
        let p = x.p + S::rotate(&x.R, carried.center);
        BodyMotion {
            origin,
            rotation,
            omega: S::spread_angular(x.w),
            alpha: S::spread_angular(x.wd),
            center: motion_of::<S>(p, x.at(p)),
        }
    }

    pub(crate) fn read_reaction(&self, joint: JointId) -> Wrench {
        self.need(Stage::Forces);
        if let Some(i) = self.mech.couplings.iter().position(|c| c.joint == joint) {
            let effort = self.lambda[self.mech.link_rows + i];
            return Wrench { force: [effort, 0.0, 0.0], moment: [0.0; 3] };
        }
        let (f, n) = self.wrench[joint.0];
        Wrench { force: S::spread(f), moment: S::spread_angular(n) }
    }

    pub(crate) fn read_force(&self, force: ForceId) -> ForceOutput {
        let Some(out) = self.outputs.get(force.0) else { return ForceOutput::default() };
        let torque = matches!(self.mech.elements[force.0], Element::Torque { .. });
        let vector = if torque { S::spread_angular(out.moment) } else { S::spread(out.force) };
        ForceOutput { length: out.length, rate: out.rate, effort: out.effort, vector }
    }

    pub(crate) fn read_energy(&self) -> Energy {
        let half = 0.5;
        let mut energy = Energy { kinetic: 0.0, potential: self.outputs.iter().map(|o| o.energy).sum() };
        for (node, x) in self.mech.nodes.iter().zip(&self.x) {
            if let Some(body) = &node.inertia {
                let p = x.p + S::rotate(&x.R, body.center);
                let v = x.at(p).0;
                let h = S::apply_inertia(&body.about_center, &x.R, x.w);
                energy.kinetic += half * (body.mass * v.dot(v) + x.w.dot(h));
                energy.potential -= body.mass * self.mech.gravity.dot(p);
            }
        }
        energy
    }
}

fn motion_of<S: Space<T = f64>>(p: S::Vector, (v, a): (S::Vector, S::Vector)) -> PointMotion {
    PointMotion { position: S::spread(p), velocity: S::spread(v), acceleration: S::spread(a) }
}
