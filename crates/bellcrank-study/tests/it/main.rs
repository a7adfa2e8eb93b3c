//! The crate as its users see it, against published optima, indices and tables.

mod cases;
mod fuzz;
mod hock_schittkowski;
mod jet;
mod solver;
