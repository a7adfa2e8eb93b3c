//! Geometry of one element: places, Jacobian matrix and its determinant.

use crate::boundary::{cross, dot};
use crate::{MOST_NODES, Shape};

/// An element's nodes in space.
pub(crate) struct Element<'a> {
    places: [[f64; 3]; MOST_NODES],
    nodes: &'a [u32],
}

impl<'a> Element<'a> {
    pub(crate) fn new(nodes: &'a [u32], all: &[[f64; 3]]) -> Element<'a> {
        let mut places = [[0.0; 3]; MOST_NODES];
        for (place, &node) in places.iter_mut().zip(nodes) {
            *place = all[node as usize];
        }
        Element { places, nodes }
    }

    /// Place and tangents (derivatives of the place by each natural coordinate).
    pub(crate) fn combine(&self, n: &[f64; MOST_NODES], d: &[[f64; 3]; MOST_NODES]) -> ([f64; 3], [[f64; 3]; 3]) {
        let (mut place, mut tangents) = ([0.0; 3], [[0.0; 3]; 3]);
        for k in 0..self.nodes.len() {
            for i in 0..3 {
                place[i] += n[k] * self.places[k][i];
                for c in 0..3 {
                    tangents[c][i] += d[k][c] * self.places[k][i];
                }
            }
        }
        (place, tangents)
    }
}

/// Shape functions and derivatives at the points of a rule.
pub(crate) struct Tabulated {
    pub(crate) n: [f64; MOST_NODES],
    pub(crate) d: [[f64; 3]; MOST_NODES],
    pub(crate) weight: f64,
}

impl Tabulated {
    pub(crate) fn at(shape: Shape, natural: [f64; 3], weight: f64) -> Tabulated {
        let (mut n, mut d) = ([0.0; MOST_NODES], [[0.0; 3]; MOST_NODES]);
        shape.evaluate(natural, &mut n, &mut d);
        Tabulated { n, d, weight }
    }
}

pub(crate) fn determinant([a, b, c]: [[f64; 3]; 3]) -> f64 {
    dot(a, cross(b, c))
}
