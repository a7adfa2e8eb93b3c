//! Tests of linear elasticity against closed forms, published cases and identities.

mod grids;
mod patch;
mod supports;
