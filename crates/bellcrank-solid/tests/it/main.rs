//! Solids against closed forms, other routes to the same number, and other programs.

mod counted;
mod derivatives;
mod faults;
mod gmsh;
mod moved;
mod parts;
mod random;
mod shapes;
mod shells;
