//! How good the elements of a mesh are.

use crate::boundary::dot;
use crate::element::{Element, Tabulated, determinant};
use crate::{Mesh, Shape};

/// Report on the elements of a mesh.
///
/// The scaled Jacobian of an element is the smallest, over its corners and integration points, of the determinant of
/// the tangents along the element's edges over the product of their lengths, times the factor that makes it 1 for the
/// regular element (√2 for tetrahedra, 2/√3 for wedges, 1 for hexahedra). Of the triples of edges that a corner may
/// have, the longest counts (Knupp, 2000; Verdict). Curved sides count as they are. It is 0 where an
/// element degenerates and negative where it is inverted; above 0.2 is usual, above 0.5 good.
#[derive(Clone, Debug, PartialEq)]
pub struct Quality {
    /// Number of elements.
    pub elements: usize,
    /// Number of nodes.
    pub nodes: usize,
    /// Smallest scaled Jacobian; 1 for a mesh without elements.
    pub worst: f64,
    /// Block and element that has it.
    pub worst_element: Option<(u32, u32)>,
    /// Middle of that element's corners in m.
    pub worst_place: [f64; 3],
    /// Elements by scaled Jacobian: below 0, then by tenths from 0 to 1.
    pub histogram: [usize; 11],
    /// Block and element where the determinant is not positive at an integration point.
    pub inverted: Vec<(u32, u32)>,
    /// Volume in m³.
    pub volume: f64,
}

/// What is measured of one element.
struct Measured {
    scaled: f64,
    inverted: bool,
    volume: f64,
}

impl Mesh {
    /// Measures every element.
    pub fn quality(&self) -> Quality {
        let mut quality = Quality {
            elements: self.element_count(),
            nodes: self.nodes.len(),
            worst: 1.0,
            worst_element: None,
            worst_place: [0.0; 3],
            histogram: [0; 11],
            inverted: Vec::new(),
            volume: 0.0,
        };
        for (block, contents) in self.blocks.iter().enumerate() {
            let rule = Rule::of(contents.shape);
            for (element, nodes) in contents.elements().enumerate() {
                let measured = rule.measure(&Element::new(nodes, &self.nodes));
                quality.enter((block as u32, element as u32), &measured);
            }
        }
        if let Some((block, element)) = quality.worst_element {
            quality.worst_place = self.center_of((block, element));
        }
        quality
    }

    /// Mean of the corners of an element, in m.
    pub fn center_of(&self, (block, element): (u32, u32)) -> [f64; 3] {
        let block = &self.blocks[block as usize];
        let corners = &block.element(element as usize)[..block.shape.corners()];
        let sum = |i: usize| corners.iter().map(|&node| self.nodes[node as usize][i]).sum::<f64>();
        std::array::from_fn(|i| sum(i) / corners.len() as f64)
    }
}

impl Quality {
    fn enter(&mut self, element: (u32, u32), measured: &Measured) {
        if self.worst_element.is_none() || measured.scaled < self.worst {
            self.worst = measured.scaled;
            self.worst_element = Some(element);
        }
        let class = if measured.scaled < 0.0 { 0 } else { 1 + (measured.scaled * 10.0).clamp(0.0, 9.0) as usize };
        self.histogram[class] += 1;
        if measured.inverted {
            self.inverted.push(element);
        }
        self.volume += measured.volume;
    }
}

/// Points of an element where it is measured: integration points, whose weights are not zero, then corners.
struct Rule {
    shape: Shape,
    points: Vec<Tabulated>,
}

impl Rule {
    fn of(shape: Shape) -> Rule {
        let inner = shape.mass_points().iter().map(|point| Tabulated::at(shape, point.at, point.weight));
        let stiff = shape.stiffness_points().iter().map(|point| Tabulated::at(shape, point.at, 0.0));
        let corners = shape.corner_coordinates().iter().map(|&at| Tabulated::at(shape, at, f64::NAN));
        Rule { shape, points: inner.chain(stiff).chain(corners).collect() }
    }

    fn measure(&self, element: &Element) -> Measured {
        let mut measured = Measured { scaled: f64::INFINITY, inverted: false, volume: 0.0 };
        for point in &self.points {
            let tangents = element.combine(&point.n, &point.d).1;
            let det = determinant(tangents);
            measured.scaled = measured.scaled.min(scaled(self.shape, tangents, det));
            if !point.weight.is_nan() {
                // Not a number counts as inverted, too.
                measured.inverted |= !matches!(det.partial_cmp(&0.0), Some(std::cmp::Ordering::Greater));
                measured.volume += det * point.weight;
            }
        }
        measured
    }
}

/// The scaled Jacobian at one place.
fn scaled(shape: Shape, [r, s, t]: [[f64; 3]; 3], det: f64) -> f64 {
    let length = |a: [f64; 3]| dot(a, a).sqrt();
    let less = |a: [f64; 3], b: [f64; 3]| length(std::array::from_fn(|i| a[i] - b[i]));
    let (factor, longest) = match shape.corners() {
        4 => {
            let (a, b, c) = (length(r), length(s), length(t));
            let (ab, bc, ca) = (less(r, s), less(s, t), less(t, r));
            let triples = [a * b * c, a * ab * ca, b * bc * ab, c * ca * bc];
            (2.0_f64.sqrt(), triples.into_iter().fold(0.0, f64::max))
        }
        6 => {
            let (a, b, ab) = (length(r), length(s), less(r, s));
            (2.0 / 3.0_f64.sqrt(), length(t) * (a * b).max(b * ab).max(ab * a))
        }
        _ => (1.0, length(r) * length(s) * length(t)),
    };
    if longest > 0.0 { factor * det / longest } else { 0.0 }
}
