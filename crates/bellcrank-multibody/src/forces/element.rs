//! A blueprint's forces, resolved against the tree.

use crate::builder::frame_of;
use crate::constraint::Measure;
use crate::mechanism::{Carried, Source};
use crate::{Axes, Blueprint, BodyId, BuildError, Coordinate, Force, Joint, Place, Value};
use bellcrank_math::{Frame, Space};

/// A frame on a node.
#[derive(Clone, Copy, Debug)]
pub(crate) struct End<S: Space> {
    pub(crate) node: usize,
    pub(crate) frame: Frame<S>,
}

/// Friction law of a joint coordinate.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Friction<T> {
    pub(crate) coordinate: Coordinate,
    /// What the coordinate is on the joint: the normal force is across it.
    pub(crate) along: Measure,
    pub(crate) source: Source,
    pub(crate) coulomb: Value<T>,
    pub(crate) static_coefficient: Option<Value<T>>,
    pub(crate) stribeck_velocity: Option<Value<T>>,
    pub(crate) viscous: Value<T>,
    pub(crate) radius: Option<Value<T>>,
    pub(crate) smoothing_velocity: Option<Value<T>>,
}

/// A force element on nodes and coordinate sources.
#[derive(Clone, Debug)]
pub(crate) enum Element<S: Space> {
    Point {
        at: End<S>,
        vector: [Value<S::T>; 3],
        /// Whose axes the components are along; the world's without.
        axes: Option<End<S>>,
    },
    Torque {
        on: End<S>,
        vector: [Value<S::T>; 3],
        axes: Option<End<S>>,
    },
    Effort {
        source: Source,
        value: Value<S::T>,
    },
    Spring {
        ends: [End<S>; 2],
        stiffness: Value<S::T>,
        damping: Value<S::T>,
        free_length: Value<S::T>,
        preload: Value<S::T>,
    },
    JointSpring {
        source: Source,
        stiffness: Value<S::T>,
        damping: Value<S::T>,
        free_position: Value<S::T>,
        preload: Value<S::T>,
    },
    Friction(Friction<S::T>),
    Stop {
        source: Source,
        min: Option<Value<S::T>>,
        max: Option<Value<S::T>>,
        stiffness: Value<S::T>,
        damping: Value<S::T>,
        restitution: Option<Value<S::T>>,
    },
    Bushing {
        ends: [End<S>; 2],
        stiffness: [Value<S::T>; 6],
        damping: [Value<S::T>; 6],
    },
}

/// Resolves every force of the blueprint.
pub(crate) fn elements_of<S: Space>(
    blueprint: &Blueprint<S::T>,
    bodies: &[Carried<S>],
    sources: &[Vec<Source>],
) -> Result<Vec<Element<S>>, BuildError> {
    let resolve = Resolve { bodies, sources, joints: &blueprint.joints };
    blueprint.forces.iter().map(|f| resolve.element(f)).collect()
}

struct Resolve<'a, S: Space> {
    bodies: &'a [Carried<S>],
    sources: &'a [Vec<Source>],
    joints: &'a [Joint<S::T>],
}

impl<S: Space> Resolve<'_, S> {
    fn end(&self, place: &Place<S::T>) -> End<S> {
        let body = &self.bodies[place.body.0];
        End { node: body.node, frame: body.frame.then(&frame_of(place)) }
    }
    fn body(&self, id: BodyId) -> End<S> {
        let body = &self.bodies[id.0];
        End { node: body.node, frame: body.frame }
    }
    /// The frame whose axes a vector on the body `on` is given in; `None` for world axes. "Body" axes are the body's,
    /// whatever way the place where the vector acts is turned.
    fn axes(&self, axes: &Axes<S::T>, on: BodyId) -> Option<End<S>> {
        match axes {
            Axes::World => None,
            Axes::Body => Some(self.body(on)),
            Axes::Frame(place) => Some(self.end(place)),
        }
    }
    fn along(&self, c: &Coordinate) -> Measure {
        let joint = self.joints.get(c.joint.0);
        joint.map_or(Measure::None, |joint| Measure::of::<S>(&joint.kind, c.index))
    }
    fn source(&self, c: &Coordinate) -> Result<Source, BuildError> {
        let found = self.sources.get(c.joint.0).and_then(|s| s.get(c.index)).copied();
        match found {
            Some(Source::Measured { measure, .. }) if measure.is_attitude() => Err(BuildError::Attitude(*c)),
            Some(source) => Ok(source),
            None => Err(BuildError::NoCoordinate(*c)),
        }
    }
    fn element(&self, force: &Force<S::T>) -> Result<Element<S>, BuildError> {
        Ok(match force {
            Force::Point { at, vector, axes } => {
                Element::Point { at: self.end(at), vector: *vector, axes: self.axes(axes, at.body) }
            }
            Force::Torque { on, vector, axes } => {
                Element::Torque { on: self.body(*on), vector: *vector, axes: self.axes(axes, *on) }
            }
            Force::Effort { coordinate, value } => Element::Effort { source: self.source(coordinate)?, value: *value },
            Force::Spring { between, stiffness, damping, free_length, preload } => Element::Spring {
                ends: [self.end(&between[0]), self.end(&between[1])],
                stiffness: *stiffness,
                damping: *damping,
                free_length: *free_length,
                preload: *preload,
            },
            Force::JointSpring { coordinate, stiffness, damping, free_position, preload } => Element::JointSpring {
                source: self.source(coordinate)?,
                stiffness: *stiffness,
                damping: *damping,
                free_position: *free_position,
                preload: *preload,
            },
            Force::Friction {
                coordinate,
                coulomb,
                static_coefficient,
                stribeck_velocity,
                viscous,
                radius,
                smoothing_velocity,
            } => Element::Friction(Friction {
                coordinate: *coordinate,
                along: self.along(coordinate),
                source: self.source(coordinate)?,
                coulomb: *coulomb,
                static_coefficient: *static_coefficient,
                stribeck_velocity: *stribeck_velocity,
                viscous: *viscous,
                radius: *radius,
                smoothing_velocity: *smoothing_velocity,
            }),
            Force::Stop { coordinate, min, max, stiffness, damping, restitution } => Element::Stop {
                restitution: *restitution,
                source: self.source(coordinate)?,
                min: *min,
                max: *max,
                stiffness: *stiffness,
                damping: *damping,
            },
            Force::Bushing { between, stiffness, damping } => Element::Bushing {
                ends: [self.end(&between[0]), self.end(&between[1])],
                stiffness: *stiffness,
                damping: *damping,
            },
        })
    }
}
