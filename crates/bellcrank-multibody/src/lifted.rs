//! A blueprint over another scalar, for exact derivatives.

use crate::{Axes, Blueprint, Body, Force, Joint, JointKind, Place, Value};
use bellcrank_math::Real;

impl<T: Real> Blueprint<T> {
    /// The same machine with every number passed through `f`.
    pub fn map<U: Real>(&self, f: impl Fn(T) -> U + Copy) -> Blueprint<U> {
        Blueprint {
            gravity: self.gravity.map(f),
            bodies: self.bodies.iter().map(|b| map_body(b, f)).collect(),
            joints: self.joints.iter().map(|j| map_joint(j, f)).collect(),
            forces: self.forces.iter().map(|e| map_force(e, f)).collect(),
            flexible: self.flexible.iter().map(|b| b.map(f)).collect(),
            inputs: self.inputs,
        }
    }
}

fn map_body<T: Real, U: Real>(b: &Body<T>, f: impl Fn(T) -> U + Copy) -> Body<U> {
    Body { mass: f(b.mass), center: b.center.map(f), inertia: b.inertia.map(|r| r.map(f)) }
}

fn map_place<T: Real, U: Real>(p: &Place<T>, f: impl Fn(T) -> U + Copy) -> Place<U> {
    Place { body: p.body, position: p.position.map(f), rotation: p.rotation.map(|r| r.map(f)) }
}

fn map_places<T: Real, U: Real>(p: &[Place<T>; 2], f: impl Fn(T) -> U + Copy) -> [Place<U>; 2] {
    [map_place(&p[0], f), map_place(&p[1], f)]
}

fn map_joint<T: Real, U: Real>(j: &Joint<T>, f: impl Fn(T) -> U + Copy) -> Joint<U> {
    Joint {
        kind: map_kind(&j.kind, f),
        places: j.places.as_ref().map(|p| map_places(p, f)),
        start: j.start.iter().map(|s| s.map(f)).collect(),
        at_start: j.at_start,
    }
}

fn map_kind<T: Real, U: Real>(kind: &JointKind<T>, f: impl Fn(T) -> U + Copy) -> JointKind<U> {
    use JointKind as K;
    match kind {
        K::Revolute { axis } => K::Revolute { axis: axis.map(f) },
        K::Prismatic { axis } => K::Prismatic { axis: axis.map(f) },
        K::Cylindrical { axis } => K::Cylindrical { axis: axis.map(f) },
        K::Screw { axis, pitch } => K::Screw { axis: axis.map(f), pitch: f(*pitch) },
        K::Universal { axis, axis2 } => K::Universal { axis: axis.map(f), axis2: axis2.map(f) },
        K::Spherical => K::Spherical,
        K::Planar => K::Planar,
        K::Free => K::Free,
        K::Elastic => K::Elastic,
        K::Modes { count } => K::Modes { count: *count },
        K::Weld => K::Weld,
        K::Distance { length } => K::Distance { length: length.map(f) },
        K::PointOnLine { axis } => K::PointOnLine { axis: axis.map(f) },
        K::Coupler { a, b, ratio, offset } => K::Coupler { a: *a, b: *b, ratio: f(*ratio), offset: f(*offset) },
    }
}

fn map_value<T: Real, U: Real>(v: Value<T>, f: impl Fn(T) -> U) -> Value<U> {
    match v {
        Value::Constant(x) => Value::Constant(f(x)),
        Value::Input(i) => Value::Input(i),
    }
}

fn map_axes<T: Real, U: Real>(axes: &Axes<T>, f: impl Fn(T) -> U + Copy) -> Axes<U> {
    match axes {
        Axes::World => Axes::World,
        Axes::Body => Axes::Body,
        Axes::Frame(place) => Axes::Frame(map_place(place, f)),
    }
}

fn map_force<T: Real, U: Real>(force: &Force<T>, f: impl Fn(T) -> U + Copy) -> Force<U> {
    use Force as F;
    let v = |x: &Value<T>| map_value(*x, f);
    match force {
        F::Point { at, vector, axes } => {
            F::Point { at: map_place(at, f), vector: vector.each_ref().map(v), axes: map_axes(axes, f) }
        }
        F::Torque { on, vector, axes } => {
            F::Torque { on: *on, vector: vector.each_ref().map(v), axes: map_axes(axes, f) }
        }
        F::Effort { coordinate, value } => F::Effort { coordinate: *coordinate, value: v(value) },
        F::Spring { between, stiffness, damping, free_length, preload } => F::Spring {
            between: map_places(between, f),
            stiffness: v(stiffness),
            damping: v(damping),
            free_length: v(free_length),
            preload: v(preload),
        },
        F::JointSpring { coordinate, stiffness, damping, free_position, preload } => F::JointSpring {
            coordinate: *coordinate,
            stiffness: v(stiffness),
            damping: v(damping),
            free_position: v(free_position),
            preload: v(preload),
        },
        F::Friction {
            coordinate,
            coulomb,
            static_coefficient,
            stribeck_velocity,
            viscous,
            radius,
            smoothing_velocity,
        } => F::Friction {
            coordinate: *coordinate,
            coulomb: v(coulomb),
            static_coefficient: static_coefficient.as_ref().map(v),
            stribeck_velocity: stribeck_velocity.as_ref().map(v),
            viscous: v(viscous),
            radius: radius.as_ref().map(v),
            smoothing_velocity: smoothing_velocity.as_ref().map(v),
        },
        F::Stop { coordinate, min, max, stiffness, damping, restitution } => F::Stop {
            restitution: restitution.as_ref().map(v),
            coordinate: *coordinate,
            min: min.as_ref().map(v),
            max: max.as_ref().map(v),
            stiffness: v(stiffness),
            damping: v(damping),
        },
        F::Bushing { between, stiffness, damping } => F::Bushing {
            between: map_places(between, f),
            stiffness: stiffness.each_ref().map(v),
            damping: damping.each_ref().map(v),
        },
    }
}
