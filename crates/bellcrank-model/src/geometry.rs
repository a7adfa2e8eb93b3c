//! Where the points of a model are, in numbers.

use bellcrank_math::Real;
use bellcrank_multibody::{BodyId, Coordinate, Place, Readings};

use crate::scalar::length;

/// Points and force elements in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Geometry<T = f64> {
    /// Frames of the points, by body.
    pub(crate) points: Vec<Vec<Place<T>>>,
    /// What the length of each force element is, if it has one.
    pub(crate) spans: Vec<Option<Extent<T>>>,
}

/// What the length of a force element is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent<T = f64> {
    /// The distance of two points, in body axes.
    Between([(BodyId, [T; 3]); 2]),
    /// A joint coordinate.
    Along(Coordinate),
}

impl<T: Real> Geometry<T> {
    /// Length and rate of a force element at the present position and velocity.
    pub(crate) fn element(&self, force: usize, at: &dyn Readings<T>) -> [T; 2] {
        match self.spans.get(force) {
            Some(Some(Extent::Between(places))) => distance(places, at),
            Some(Some(Extent::Along(c))) => {
                let at = at.coordinate(*c);
                [at.position, at.velocity]
            }
            _ => [T::from_f64(f64::NAN); 2],
        }
    }
}

fn distance<T: Real>(places: &[(BodyId, [T; 3]); 2], at: &dyn Readings<T>) -> [T; 2] {
    let [a, b] = places.map(|(body, place)| at.point(body, place));
    let apart: [T; 3] = std::array::from_fn(|i| b.position[i] - a.position[i]);
    let length = length(apart);
    let closing = (0..3).fold(T::zero(), |sum, i| sum + apart[i] * (b.velocity[i] - a.velocity[i]));
    let rate = if length.value() > 0.0 { closing / length } else { T::zero() };
    [length, rate]
}
