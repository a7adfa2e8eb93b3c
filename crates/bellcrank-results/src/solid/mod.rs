//! The stick drawing as solid parts: bars, plates, pins and sleeves, each fixed on a body.
//!
//! Sizes are chosen to be looked at, not to be built: thick enough to see, thin enough not to hide. The report's
//! scene and the glTF file draw the same parts.

mod bodies;
mod joints;
mod layers;
mod scale;
mod travel;
pub(crate) mod vector;

use crate::{Animation, Drawing, SpaceKind, Surface};
use layers::Layers;
use scale::Scale;
use vector::V3;

/// A part that moves with a body.
#[derive(Clone, Debug)]
pub struct Solid {
    /// Index of the body.
    pub body: usize,
    /// Its form, body axes, m.
    pub shape: Shape,
    /// Its colour.
    pub paint: Paint,
}

/// Form of a part; places and directions in body axes, lengths in m.
#[derive(Clone, Debug)]
pub enum Shape {
    /// A round bar.
    Rod {
        /// One end.
        from: V3,
        /// The other end.
        to: V3,
        /// Radius.
        radius: f64,
        /// Half balls on the ends, beyond them.
        round: bool,
    },
    /// A ball.
    Ball {
        /// Its middle.
        center: V3,
        /// Radius.
        radius: f64,
    },
    /// A block.
    Block {
        /// Its middle.
        center: V3,
        /// Direction of its length, of length one.
        along: V3,
        /// Direction of its width, of length one, perpendicular to `along`.
        across: V3,
        /// Length, width, height.
        size: V3,
    },
    /// A flat link: what a disc covers that moves over the convex hull of some points.
    Plate {
        /// Corners of a convex outline in one plane, counter-clockwise about the normal; two for a bar.
        points: Vec<V3>,
        /// Normal of the plane, of length one.
        normal: V3,
        /// Radius of the disc.
        radius: f64,
        /// Thickness, half of it on each side of the plane.
        thickness: f64,
    },
    /// The real form of a body. Neighbouring triangles meet smoothly where they are less than 30 degrees apart.
    Surface(Surface),
}

/// What a part is painted as.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Paint {
    /// The colour of its body.
    Body,
    /// A pin, a rod, a ball.
    Steel,
    /// Where a drive sits.
    Drive,
    /// What does not move.
    Ground,
}

/// Colours of bodies, one after the other.
const BODIES: [[u8; 3]; 8] = [
    [0x0b, 0x5f, 0xa5],
    [0x12, 0x80, 0x5c],
    [0x9a, 0x5b, 0x00],
    [0x5b, 0x4a, 0xa8],
    [0xa2, 0x3a, 0x4a],
    [0x3b, 0x6f, 0x7d],
    [0x6b, 0x6b, 0x00],
    [0x7a, 0x3b, 0x10],
];

impl Paint {
    /// Red, green, blue (sRGB) of this paint on a body.
    pub fn colour(self, body: usize) -> [u8; 3] {
        match self {
            Paint::Body if body > 0 => BODIES[(body - 1) % BODIES.len()],
            Paint::Body | Paint::Ground => [0x6b, 0x76, 0x84],
            Paint::Steel => [0xb4, 0xbc, 0xc4],
            Paint::Drive => [0xf0, 0xb4, 0x29],
        }
    }
}

/// What the parts are made from.
struct Plan<'a> {
    drawing: &'a Drawing,
    animation: &'a Animation,
    scale: Scale,
    layers: Layers,
}

impl Plan<'_> {
    fn planar(&self) -> bool {
        matches!(self.drawing.space, SpaceKind::Planar)
    }

    /// The real form of a body.
    fn surface(&self, body: usize) -> Option<&Surface> {
        self.drawing.bodies.get(body)?.surface.as_ref()
    }

    /// Middle and sides of the block that stands for a body without form which hangs on one joint at most: a load, a
    /// jaw, a latch.
    fn block(&self, body: usize) -> Option<(V3, V3)> {
        let drawn = self.drawing.bodies.get(body).filter(|drawn| drawn.lines.is_empty())?;
        let joints = self.drawing.joints.iter().filter(|joint| joint.first.0 == body || joint.second.0 == body);
        if joints.count() > 1 { None } else { drawn.center.zip(drawn.block) }
    }
}

/// The parts of a drawing, sized by the room that its motion takes; none where nothing is placed.
pub fn solids(drawing: &Drawing, animation: &Animation) -> Vec<Solid> {
    let Some(scale) = Scale::of(drawing, animation) else { return Vec::new() };
    let layers = Layers::of(drawing);
    let plan = Plan { drawing, animation, scale, layers };
    let mut parts = bodies::parts(&plan);
    parts.extend(joints::parts(&plan));
    parts.retain(|part| part.body < drawing.bodies.len() && part.shape.is_finite());
    parts
}

impl Shape {
    /// Whether all its numbers are.
    fn is_finite(&self) -> bool {
        let all = |places: &[V3]| places.iter().flatten().all(|x| x.is_finite());
        match self {
            Shape::Rod { from, to, radius, .. } => all(&[*from, *to]) && radius.is_finite(),
            Shape::Ball { center, radius } => all(&[*center]) && radius.is_finite(),
            Shape::Block { center, along, across, size } => all(&[*center, *along, *across, *size]),
            Shape::Plate { points, normal, .. } => all(points) && all(&[*normal]),
            Shape::Surface(surface) => all(&surface.points),
        }
    }
}

#[cfg(test)]
pub(crate) mod sample;
#[cfg(test)]
mod tests;
