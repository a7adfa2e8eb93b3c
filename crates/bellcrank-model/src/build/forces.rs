//! Force elements in numbers.

use bellcrank_multibody::{Axes as AxesNumbers, BodyId, Coordinate, Force as ForceNumbers, Place, Value};

use super::Numbers;
use super::forward::within;
use crate::design::{Axes, Force, ForceShape, Load, PointRef};
use crate::geometry::{Extent, Geometry};
use crate::scalar::Scalar;

type Points<T> = [Vec<Place<T>>];

/// The elements, and what the length of each is.
pub(super) fn forces<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    geometry: &mut Geometry<T>,
    forces: &mut Vec<ForceNumbers<T>>,
) {
    let design = numbers.design;
    let Geometry { points, spans, .. } = geometry;
    forces.clear();
    forces.extend(design.forces.iter().map(|force| element(numbers, force, points)));
    spans.clear();
    spans.extend(design.forces.iter().map(|force| extent(&force.shape, points)));
}

fn extent<T: Scalar>(shape: &ForceShape, points: &Points<T>) -> Option<Extent<T>> {
    match shape {
        ForceShape::Spring { between, .. } => Some(Extent::Between(between.map(|at| {
            let place = &points[at.body][at.point];
            (place.body, place.position)
        }))),
        ForceShape::JointSpring { coordinate, .. }
        | ForceShape::Friction { coordinate, .. }
        | ForceShape::Stop { coordinate, .. } => Some(Extent::Along(*coordinate)),
        _ => None,
    }
}

/// Loads of one force as values.
struct Loads<'n, 'a, T: Scalar> {
    numbers: &'n mut Numbers<'a, T>,
    name: &'n str,
}

impl<T: Scalar> Loads<'_, '_, T> {
    fn value(&mut self, load: &Load, key: &str) -> Value<T> {
        match load {
            Load::Fixed(quantity) => {
                Value::Constant(self.numbers.number(quantity, format_args!("`{key}` of force `{}`", self.name)))
            }
            Load::Input(index) => Value::Input(*index),
            Load::Absent(default) => Value::Constant(T::from_f64(*default)),
        }
    }

    /// A value that is never negative.
    fn positive(&mut self, load: &Load, key: &str) -> Value<T> {
        match load {
            Load::Fixed(quantity) => {
                Value::Constant(self.numbers.positive(quantity, format_args!("`{key}` of force `{}`", self.name)))
            }
            _ => self.value(load, key),
        }
    }

    /// A value that is above zero, where given.
    fn above_zero(&mut self, load: Option<&Load>, key: &str) -> Option<Value<T>> {
        if let Some(Load::Fixed(quantity)) = load {
            let what = format_args!("`{key}` of force `{}`", self.name);
            let number = self.numbers.number(quantity, what);
            if number.value() <= 0.0 {
                self.numbers.report("out-of-range", quantity.span(), format!("{what} must be above zero"));
            }
            return Some(Value::Constant(number));
        }
        self.optional(load, key)
    }

    /// A share, 0 to 1, where given.
    fn share(&mut self, load: Option<&Load>, key: &str) -> Option<Value<T>> {
        if let Some(Load::Fixed(quantity)) = load {
            let what = format_args!("`{key}` of force `{}`", self.name);
            return Some(Value::Constant(within(self.numbers, quantity, &(0.0..=1.0), what)));
        }
        self.optional(load, key)
    }

    /// Limits that leave no place between them are reported.
    fn in_order(&mut self, limits: [Option<Value<T>>; 2], upper: Option<&Load>) {
        let ([Some(Value::Constant(min)), Some(Value::Constant(max))], Some(Load::Fixed(at))) = (limits, upper) else {
            return;
        };
        if min.value() >= max.value() {
            let message = format!("`max` of force `{}` is not above its `min`", self.name);
            self.numbers.report("out-of-range", at.span(), message);
        }
    }

    fn optional(&mut self, load: Option<&Load>, key: &str) -> Option<Value<T>> {
        load.map(|load| self.value(load, key))
    }

    fn values<const N: usize>(&mut self, loads: &[Load; N], key: &str) -> [Value<T>; N] {
        std::array::from_fn(|i| self.value(&loads[i], key))
    }
}

fn element<T: Scalar>(numbers: &mut Numbers<'_, T>, force: &Force, points: &Points<T>) -> ForceNumbers<T> {
    let place = |at: &PointRef| points[at.body][at.point].clone();
    let mut loads = Loads { numbers, name: &force.name };
    match &force.shape {
        ForceShape::Point { at, vector, axes } => ForceNumbers::Point {
            at: place(at),
            vector: loads.values(vector, "vector"),
            axes: directions(*axes, points),
        },
        ForceShape::Torque { on, vector, axes } => {
            let axes = directions(*axes, points);
            ForceNumbers::Torque { on: BodyId(*on), vector: loads.values(vector, "vector"), axes }
        }
        ForceShape::Spring { between: [a, b], stiffness, damping, free_length, preload } => ForceNumbers::Spring {
            between: [place(a), place(b)],
            stiffness: loads.value(stiffness, "stiffness"),
            damping: loads.value(damping, "damping"),
            free_length: loads.positive(free_length, "free_length"),
            preload: loads.value(preload, "preload"),
        },
        ForceShape::Bushing { between: [a, b], stiffness, damping } => ForceNumbers::Bushing {
            between: [place(a), place(b)],
            stiffness: loads.values(stiffness, "stiffness"),
            damping: loads.values(damping, "damping"),
        },
        along => along_coordinate(&mut loads, along),
    }
}

fn directions<T: Scalar>(axes: Axes, points: &Points<T>) -> AxesNumbers<T> {
    match axes {
        Axes::World => AxesNumbers::World,
        Axes::Body => AxesNumbers::Body,
        Axes::Point(at) => AxesNumbers::Frame(points[at.body][at.point].clone()),
    }
}

fn along_coordinate<T: Scalar>(loads: &mut Loads<'_, '_, T>, shape: &ForceShape) -> ForceNumbers<T> {
    match shape {
        ForceShape::JointSpring { coordinate, stiffness, damping, free_position, preload } => {
            ForceNumbers::JointSpring {
                coordinate: *coordinate,
                stiffness: loads.value(stiffness, "stiffness"),
                damping: loads.value(damping, "damping"),
                free_position: loads.value(free_position, "free_position"),
                preload: loads.value(preload, "preload"),
            }
        }
        ForceShape::Friction {
            coordinate,
            coulomb,
            static_coefficient,
            stribeck_velocity,
            viscous,
            radius,
            smoothing_velocity,
        } => ForceNumbers::Friction {
            coordinate: *coordinate,
            coulomb: loads.positive(coulomb, "coulomb"),
            static_coefficient: loads.optional(static_coefficient.as_ref(), "static"),
            stribeck_velocity: loads.optional(stribeck_velocity.as_ref(), "stribeck_velocity"),
            viscous: loads.positive(viscous, "viscous"),
            radius: loads.optional(radius.as_ref(), "radius"),
            smoothing_velocity: loads.above_zero(smoothing_velocity.as_ref(), "smoothing_velocity"),
        },
        ForceShape::Stop { coordinate, min, max, stiffness, damping, restitution } => {
            let limits = [loads.optional(min.as_ref(), "min"), loads.optional(max.as_ref(), "max")];
            loads.in_order(limits, max.as_ref());
            let [min, max] = limits;
            ForceNumbers::Stop {
                coordinate: *coordinate,
                min,
                max,
                stiffness: loads.positive(stiffness, "stiffness"),
                damping: loads.positive(damping, "damping"),
                restitution: loads.share(restitution.as_ref(), "restitution"),
            }
        }
        ForceShape::Effort { coordinate, value } => {
            ForceNumbers::Effort { coordinate: *coordinate, value: loads.value(value, "value") }
        }
        _ => nothing(),
    }
}

/// Never made: the kinds without a coordinate are told apart before.
fn nothing<T: Scalar>() -> ForceNumbers<T> {
    let coordinate = Coordinate { joint: bellcrank_multibody::JointId(0), index: 0 };
    ForceNumbers::Effort { coordinate, value: Value::Constant(T::zero()) }
}
