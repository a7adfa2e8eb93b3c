//! Loads and the nodal forces that they are.

use bellcrank_mesh::{Face, Mesh};

use crate::element::Geometry;
use crate::surface::{self, SurfacePoint};
use crate::vector::{self, V3};
use crate::{Coupling, Part};

/// A load; SI, axes of the mesh.
#[derive(Clone, Debug)]
pub enum Load {
    /// Weight: the acceleration of gravity.
    Gravity(V3),
    /// The inertia forces of a part that moves as a rigid body: −ρ (a + α × r + ω × (ω × r)), r from `about`.
    Motion {
        /// Point whose acceleration is given.
        about: V3,
        /// Its acceleration, m/s².
        acceleration: V3,
        /// Angular velocity, rad/s.
        omega: V3,
        /// Angular acceleration, rad/s².
        alpha: V3,
    },
    /// Pressure, positive into the surface, Pa.
    Pressure {
        /// Faces it acts on.
        faces: Vec<Face>,
        /// Pa.
        value: f64,
    },
    /// Force an area, Pa.
    Traction {
        /// Faces it acts on.
        faces: Vec<Face>,
        /// Pa, along x, y, z.
        vector: V3,
    },
    /// The pressure of a pin on the side of a bore that it lies against: as the cosine of the angle to the force,
    /// nothing on the other side. The part of the force along the axis is spread evenly as shear.
    Bearing {
        /// Faces of the bore.
        faces: Vec<Face>,
        /// A point on its axis.
        center: V3,
        /// Direction of its axis, of length one.
        axis: V3,
        /// Force of the pin on the part, N.
        force: V3,
    },
    /// Forces at nodes.
    Nodal {
        /// Which nodes.
        nodes: Vec<u32>,
        /// N at each of them.
        force: V3,
    },
    /// On the frame of a coupling.
    Frame {
        /// Its place in [`Part::couplings`].
        coupling: usize,
        /// N.
        force: V3,
        /// N·m.
        moment: V3,
    },
    /// Temperature above that of the stress-free part, K, at each node of the mesh.
    Temperature(Vec<f64>),
}

/// What loads come to before any system is solved.
#[derive(Clone, Debug)]
pub(crate) struct Loaded {
    /// Force at each node, N; thermal loads are in it.
    pub(crate) nodal: Vec<V3>,
    /// Force and moment on the frames of rigid couplings.
    pub(crate) frames: Vec<[f64; 6]>,
    /// Temperatures at the nodes, where there are any.
    pub(crate) temperature: Option<Vec<f64>>,
}

impl Loaded {
    pub(crate) fn new(part: &Part<'_>, loads: &[Load]) -> Self {
        let nodal = vec![[0.0; 3]; part.mesh.nodes.len()];
        let mut loaded = Self { nodal, frames: vec![[0.0; 6]; part.couplings.len()], temperature: None };
        for load in loads {
            loaded.add(part, load);
        }
        loaded
    }

    fn add(&mut self, part: &Part<'_>, load: &Load) {
        let mesh = part.mesh;
        match load {
            Load::Gravity(g) => self.add_field(part, |_| *g),
            Load::Motion { about, acceleration, omega, alpha } => self.add_field(part, |x| {
                let r = vector::sub(x, *about);
                let turning = vector::cross(*omega, vector::cross(*omega, r));
                let total = vector::add(*acceleration, vector::add(vector::cross(*alpha, r), turning));
                vector::scale(total, -1.0)
            }),
            Load::Pressure { faces, value } => {
                surface::integrate(mesh, faces, &mut self.nodal, |point| vector::scale(point.normal, -value));
            }
            Load::Traction { faces, vector } => surface::integrate(mesh, faces, &mut self.nodal, |_| *vector),
            Load::Bearing { faces, center, axis, force } => self.add_bearing(mesh, faces, *center, *axis, *force),
            Load::Nodal { nodes, force } => {
                for &node in nodes {
                    vector::accumulate(&mut self.nodal[node as usize], *force);
                }
            }
            Load::Frame { coupling, force, moment } => self.add_frame(part, *coupling, *force, *moment),
            Load::Temperature(nodes) => self.add_temperature(nodes),
        }
    }

    fn add_temperature(&mut self, nodes: &[f64]) {
        match &mut self.temperature {
            None => self.temperature = Some(nodes.to_vec()),
            Some(sum) => sum.iter_mut().zip(nodes).for_each(|(sum, more)| *sum += more),
        }
    }

    /// A force on a distributing frame is a traction on its surface; on a rigid one it acts on the frame's own unknowns.
    fn add_frame(&mut self, part: &Part<'_>, coupling: usize, force: V3, moment: V3) {
        let tied = &part.couplings[coupling];
        match tied.kind {
            crate::CouplingKind::Rigid => {
                for i in 0..3 {
                    self.frames[coupling][i] += force[i];
                    self.frames[coupling][3 + i] += moment[i];
                }
            }
            crate::CouplingKind::Distributing => spread(part.mesh, tied, force, moment, &mut self.nodal),
        }
    }

    fn add_field(&mut self, part: &Part<'_>, acceleration: impl Fn(V3) -> V3) {
        let mut geometry = Geometry::default();
        for (block, material) in part.mesh.blocks.iter().zip(&part.materials) {
            for element in block.elements() {
                geometry.set(block.shape, element, &part.mesh.nodes);
                for point in block.shape.mass_points() {
                    let volume = geometry.at(point) * point.weight;
                    let field = vector::scale(acceleration(geometry.place()), material.density * volume);
                    for (n, &node) in geometry.n.iter().zip(element) {
                        vector::accumulate(&mut self.nodal[node as usize], vector::scale(field, *n));
                    }
                }
            }
        }
    }

    fn add_bearing(&mut self, mesh: &Mesh, faces: &[Face], center: V3, axis: V3, force: V3) {
        let along = vector::scale(axis, vector::dot(force, axis));
        let across = vector::sub(force, along);
        if vector::norm(across) > 0.0 {
            let direction = vector::scale(across, 1.0 / vector::norm(across));
            let press = |point: &SurfacePoint| {
                let arm = vector::sub(point.at, center);
                let radial = vector::sub(arm, vector::scale(axis, vector::dot(arm, axis)));
                let radial = vector::scale(radial, 1.0 / vector::norm(radial).max(f64::MIN_POSITIVE));
                vector::scale(radial, vector::dot(radial, direction).max(0.0))
            };
            let unit = surface::resultant(mesh, faces, press);
            let size = vector::norm(across) / vector::dot(unit, direction).max(f64::MIN_POSITIVE);
            surface::integrate(mesh, faces, &mut self.nodal, |point| vector::scale(press(point), size));
            // What a mesh without symmetry leaves across the force goes back as an even traction.
            let left = vector::sub(across, vector::scale(unit, size));
            self.add_evenly(mesh, faces, left);
        }
        self.add_evenly(mesh, faces, along);
    }

    fn add_evenly(&mut self, mesh: &Mesh, faces: &[Face], force: V3) {
        let area = surface::area(mesh, faces);
        surface::integrate(mesh, faces, &mut self.nodal, |_| vector::scale(force, 1.0 / area));
    }
}

/// The nodal forces of a force and a moment on a distributing frame: t(x) = a + b × (x − x̄), with the force and the
/// moment as its resultants.
pub(crate) fn spread(mesh: &Mesh, coupling: &Coupling, force: V3, moment: V3, nodal: &mut [V3]) {
    let spread = surface::Spread::new(mesh, coupling);
    spread.add(mesh, coupling, force, moment, nodal);
}
