//! Tests of linear elasticity against closed forms, published cases and identities.

mod beams;
mod calculix;
mod chains;
mod convergence;
mod fatigue;
mod grids;
mod patch;
mod published;
mod reduction;
mod sections;
mod stiffening;
mod supports;
mod vibration;
