//! Solids against closed forms, other routes to the same number, and other programs.

mod derivatives;
mod parts;
mod random;
mod shapes;
