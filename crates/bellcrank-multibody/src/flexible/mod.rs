//! What a body that changes its shape brings: its reduced masses, stiffness and shapes.
//!
//! The displacement of a particle that is at x in the undeformed body is `u(x) = Σ φ_e(x) d_e`, in the axes of the
//! floating frame, which is the frame of [`Flexible::body`]. The coordinates d are those of the tree: of the
//! [`crate::JointKind::Elastic`] joints between the floating frame and the interfaces (displacement along x, y, z, then
//! turns about x, y, z; in the plane x, y and the turn about z), in their order, then those of the
//! [`crate::JointKind::Modes`]. A shape of an interface moves that interface by 1 and no other one; a mode moves none.
//!
//! All that motion needs are integrals of products of places and shapes over the mass (the nodal-based mass coupling
//! of Zwölfer & Gerstmayr 2021 written with integrals that are taken once).

mod deforming;
mod inertia;
mod strain;

use crate::{BodyId, JointId};

pub(crate) use deforming::{Deforming, deforming_of};
pub(crate) use inertia::{Carriage, add_demands, each_projection};
pub(crate) use strain::add_efforts;

/// A flexible body; n coordinates.
#[derive(Clone, Debug, PartialEq)]
pub struct Flexible<T> {
    /// Carries the floating frame; no mass of its own.
    pub body: BodyId,
    /// Joints ([`crate::JointKind::Elastic`]) from the body to bodies that stand for the interfaces.
    pub interfaces: Vec<JointId>,
    /// Joint ([`crate::JointKind::Modes`]) from the body to a massless one.
    pub modes: Option<JointId>,
    /// How its mass lies and moves.
    pub inertia: ShapeInertia<T>,
    /// n × n by rows, N/m, N or N·m by the units of the coordinates.
    pub stiffness: Vec<T>,
    /// n × n by rows: force a rate.
    pub damping: Vec<T>,
    /// How much nearer an interface comes by bending alone: makes tension stiffen and compression soften.
    pub shortenings: Vec<Shortening<T>>,
}

/// Integrals over the mass of a body, about the origin of its frame and in its axes. x is the place in the undeformed
/// body, φ_e the displacement by coordinate e.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShapeInertia<T> {
    /// `∫ dm`, kg.
    pub mass: T,
    /// `∫ x dm`, kg·m.
    pub first: [T; 3],
    /// `∫ x xᵀ dm`, kg·m² (not the inertia tensor, which is its trace times 1 less it).
    pub second: [[T; 3]; 3],
    /// `∫ φ_e dm`, n of them.
    pub flow: Vec<[T; 3]>,
    /// `∫ x φ_eᵀ dm`, n of them: row by x, column by φ.
    pub placed: Vec<[[T; 3]; 3]>,
    /// `∫ φ_e φ_fᵀ dm` at e·n + f.
    pub products: Vec<[[T; 3]; 3]>,
}

/// Second-order displacement of an interface: coordinate `along` counts as `d_along + ½ dᵀ C d` where it is strained.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortening<T> {
    /// Which coordinate, 0 to n − 1.
    pub along: usize,
    /// C, n × n by rows, symmetric.
    pub matrix: Vec<T>,
}

impl<T: Copy> Flexible<T> {
    /// Number of coordinates.
    pub fn coordinates(&self) -> usize {
        self.inertia.flow.len()
    }

    /// The same body with every number passed through `f`.
    pub fn map<U>(&self, f: impl Fn(T) -> U + Copy) -> Flexible<U> {
        let three = |v: &[[T; 3]]| v.iter().map(|v| v.map(f)).collect();
        let nine = |v: &[[[T; 3]; 3]]| v.iter().map(|m| m.map(|r| r.map(f))).collect();
        let all = |v: &[T]| v.iter().map(|x| f(*x)).collect();
        let inertia = &self.inertia;
        Flexible {
            body: self.body,
            interfaces: self.interfaces.clone(),
            modes: self.modes,
            inertia: ShapeInertia {
                mass: f(inertia.mass),
                first: inertia.first.map(f),
                second: inertia.second.map(|r| r.map(f)),
                flow: three(&inertia.flow),
                placed: nine(&inertia.placed),
                products: nine(&inertia.products),
            },
            stiffness: all(&self.stiffness),
            damping: all(&self.damping),
            shortenings: self
                .shortenings
                .iter()
                .map(|s| Shortening { along: s.along, matrix: all(&s.matrix) })
                .collect(),
        }
    }
}
