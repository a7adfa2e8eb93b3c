//! What may be said about the size of elements, and why a mesh is refused.

use std::fmt;

use crate::Shape;

/// How finely an arc is divided.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Division {
    /// Edges of that length in m.
    Length(f64),
    /// Elements on a full turn.
    PerTurn(f64),
}

impl Division {
    /// Length of an element's edge on a circle.
    pub(super) fn on(self, radius: f64) -> f64 {
        match self {
            Division::Length(length) => length,
            Division::PerTurn(count) => std::f64::consts::TAU * radius / count,
        }
    }

    /// Edges of so many times the length.
    fn scaled(self, by: f64) -> Division {
        match self {
            Division::Length(length) => Division::Length(length * by),
            Division::PerTurn(count) => Division::PerTurn(count / by),
        }
    }

    fn value(self) -> f64 {
        match self {
            Division::Length(value) | Division::PerTurn(value) => value,
        }
    }
}

/// Sizes that a mesh is to have; lengths in m.
#[derive(Clone, Copy)]
pub struct Sizes<'a> {
    /// Length of an element's edge far from everything; `None` takes two fifths of the usual wall.
    pub size: Option<f64>,
    /// Multiplies `size`, also the one that is taken where none is given.
    pub scale: f64,
    /// On bores.
    pub at_bores: Division,
    /// On fillets, holes and the ends of slots: every other arc that is concave seen from the material.
    pub at_fillets: Division,
    /// Elements across a wall in plan; two quadratic elements carry bending well.
    pub across_walls: f64,
    /// Largest ratio of the sizes of neighbours; above 1.
    pub growth: f64,
    /// Fewest layers through any thickness.
    pub layers_across: usize,
    /// Size wanted at a place, for example from an estimate of the error; the smaller one counts. Layers are made no
    /// thinner than four times it.
    pub background: Option<&'a dyn Fn([f64; 3]) -> f64>,
    /// A mesh of more nodes is refused before it is made.
    pub most_nodes: usize,
}

impl Default for Sizes<'_> {
    fn default() -> Self {
        Sizes {
            size: None,
            scale: 1.0,
            at_bores: Division::PerTurn(24.0),
            at_fillets: Division::PerTurn(24.0),
            across_walls: 2.0,
            growth: 1.3,
            layers_across: 2,
            background: None,
            most_nodes: 500_000,
        }
    }
}

impl Sizes<'_> {
    /// All sizes times a factor; layers and elements across walls accordingly.
    #[must_use]
    pub fn scaled(self, by: f64) -> Self {
        Sizes {
            scale: self.scale * by,
            at_bores: self.at_bores.scaled(by),
            at_fillets: self.at_fillets.scaled(by),
            across_walls: self.across_walls / by,
            layers_across: (self.layers_across as f64 / by).ceil() as usize,
            ..self
        }
    }
}

impl fmt::Debug for Sizes<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("Sizes")
            .field("size", &self.size)
            .field("scale", &self.scale)
            .field("at_bores", &self.at_bores)
            .field("at_fillets", &self.at_fillets)
            .field("across_walls", &self.across_walls)
            .field("growth", &self.growth)
            .field("layers_across", &self.layers_across)
            .field("background", &self.background.map(|_| "…"))
            .field("most_nodes", &self.most_nodes)
            .finish()
    }
}

/// Why no mesh was made.
#[derive(Clone, Debug, PartialEq)]
pub enum MesherError {
    /// Nothing is filled.
    Empty,
    /// A size is not a positive number, or the growth not above 1.
    Size {
        /// Name of the field of [`Sizes`].
        what: &'static str,
        /// What was given.
        value: f64,
    },
    /// The mesher makes tetrahedra and wedges only.
    Shape(Shape),
    /// Too many nodes.
    TooLarge {
        /// About how many the mesh would have.
        estimate: usize,
        /// How many are allowed.
        limit: usize,
    },
    /// Edges of the arrangement cross or vertices coincide, near this place in plan.
    Crossing([f64; 2]),
    /// A profile goes to the other side of its axis, or encloses nothing.
    Profile,
}

impl fmt::Display for MesherError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            MesherError::Empty => write!(f, "the solid is empty"),
            MesherError::Size { what, value } => write!(f, "`{what}` is {value}; expected a larger number"),
            MesherError::Shape(shape) => {
                write!(f, "the mesher makes tetrahedra and wedges; expected C3D10 or C3D15, found {}", shape.abaqus())
            }
            MesherError::TooLarge { estimate, limit } => {
                write!(f, "the mesh would have about {estimate} nodes; at most {limit} are allowed")
            }
            MesherError::Crossing([x, y]) => write!(f, "edges of the plan cross near x = {x} m, y = {y} m"),
            MesherError::Profile => write!(f, "the profile crosses its axis, crosses itself, or encloses nothing"),
        }
    }
}

impl std::error::Error for MesherError {}

pub(super) fn check(sizes: &Sizes, shape: Shape) -> Result<(), MesherError> {
    let positive = [
        ("size", sizes.size.unwrap_or(1.0)),
        ("scale", sizes.scale),
        ("at_bores", sizes.at_bores.value()),
        ("at_fillets", sizes.at_fillets.value()),
        ("across_walls", sizes.across_walls),
        ("growth", sizes.growth - 1.0),
    ];
    for (what, value) in positive {
        if !(value.is_finite() && value > 0.0) {
            let value = if what == "growth" { sizes.growth } else { value };
            return Err(MesherError::Size { what, value });
        }
    }
    match shape {
        Shape::Hex8 | Shape::Hex20 => Err(MesherError::Shape(shape)),
        _ => Ok(()),
    }
}
