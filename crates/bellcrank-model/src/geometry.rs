//! Where the points of a model are, in numbers.

use bellcrank_multibody::{BodyId, Coordinate, Engine, Place};

/// Points and force elements in numbers.
#[derive(Clone, Debug)]
pub(crate) struct Geometry {
    /// Frames of the points, by body.
    pub(crate) points: Vec<Vec<Place<f64>>>,
    /// What the length of each force element is, if it has one.
    pub(crate) spans: Vec<Option<Extent>>,
}

/// What the length of a force element is.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Extent {
    /// The distance of two points, in body axes.
    Between([(BodyId, [f64; 3]); 2]),
    /// A joint coordinate.
    Along(Coordinate),
}

impl Geometry {
    /// Length and rate of a force element at the present position and velocity.
    pub(crate) fn element(&self, force: usize, engine: &dyn Engine) -> [f64; 2] {
        match self.spans.get(force) {
            Some(Some(Extent::Between(places))) => distance(places, engine),
            Some(Some(Extent::Along(c))) => {
                let at = engine.coordinate(*c);
                [at.position, at.velocity]
            }
            _ => [f64::NAN; 2],
        }
    }
}

fn distance(places: &[(BodyId, [f64; 3]); 2], engine: &dyn Engine) -> [f64; 2] {
    let [a, b] = places.map(|(body, at)| engine.point(body, at));
    let apart: [f64; 3] = std::array::from_fn(|i| b.position[i] - a.position[i]);
    let length = apart.iter().map(|x| x * x).sum::<f64>().sqrt();
    let closing: f64 = (0..3).map(|i| apart[i] * (b.velocity[i] - a.velocity[i])).sum();
    let rate = if length > 0.0 { closing / length } else { 0.0 };
    [length, rate]
}
