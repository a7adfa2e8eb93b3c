//! Where the points of a model are, in numbers.

use std::sync::Arc;

use bellcrank_fem::von_mises;
use bellcrank_math::Real;
use bellcrank_multibody::{BodyId, Coordinate, Place, Readings};

use crate::flex::Reduced;
use crate::scalar::length;

/// Points and force elements in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Geometry<T = f64> {
    /// Frames of the points, by body.
    pub(crate) points: Vec<Vec<Place<T>>>,
    /// What the length of each force element is, if it has one.
    pub(crate) spans: Vec<Option<Extent<T>>>,
    /// Stress of bodies that deform.
    pub(crate) stresses: Vec<Stressed>,
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

/// A solid that deforms, and where the stress in it is looked for.
#[derive(Clone, Debug)]
pub(crate) struct Stressed {
    /// Body of the design.
    pub(crate) body: usize,
    /// Its coordinates, and the column of the reduction of each.
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) columns: Vec<usize>,
    pub(crate) reduced: Arc<Reduced>,
}

impl Stressed {
    /// Largest von Mises stress, Pa, among the nodes of a region that can be trusted; NaN where there are none. Its
    /// derivatives are those at the node where it is.
    pub(crate) fn largest<T: Real>(&self, region: &str, at: &dyn Readings<T>) -> T {
        let shape: Vec<T> = self.coordinates.iter().map(|c| at.coordinate(*c).position).collect();
        let plain: Vec<f64> = shape.iter().map(|d| d.value()).collect();
        let Some(nodes) = self.reduced.regions.iter().find(|(name, _)| name == region).map(|(_, nodes)| nodes) else {
            return T::from_f64(f64::NAN);
        };
        let size = |node: &u32| von_mises(&self.sum(*node, &plain));
        let worst = nodes.iter().map(|node| (size(node), *node)).max_by(|a, b| a.0.total_cmp(&b.0));
        worst.map_or(T::from_f64(f64::NAN), |(_, node)| mises(&self.sum(node, &shape)))
    }

    /// Stress at a node, the sum of its columns.
    fn sum<T: Real>(&self, node: u32, shape: &[T]) -> [T; 6] {
        let mut total = [T::zero(); 6];
        for (column, d) in self.columns.iter().zip(shape) {
            let of = &self.reduced.stress[*column][node as usize];
            (0..6).for_each(|k| total[k] += *d * T::from_f64(of[k]));
        }
        total
    }
}

fn mises<T: Real>([xx, yy, zz, xy, yz, zx]: &[T; 6]) -> T {
    let square = |x: T| x * x;
    let normal = square(*xx - *yy) + square(*yy - *zz) + square(*zz - *xx);
    let shear = square(*xy) + square(*yz) + square(*zx);
    let square = normal * T::from_f64(0.5) + shear * T::from_f64(3.0);
    // No stress, no direction: the root has no derivative there.
    if square.value() > 0.0 { square.sqrt() } else { T::zero() }
}
