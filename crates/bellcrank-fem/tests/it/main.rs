//! Tests of linear elasticity against closed forms, published cases and identities.

mod calculix;
mod convergence;
mod grids;
mod patch;
mod published;
mod reduction;
mod supports;
mod vibration;
