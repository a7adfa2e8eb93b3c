//! Linear elasticity on a mesh.
