//! Tests of linear elasticity against closed forms, published cases and identities.

mod grids;
mod convergence;
mod patch;
mod published;
mod supports;
