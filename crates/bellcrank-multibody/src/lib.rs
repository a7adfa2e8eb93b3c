//! Topology, kinematics and inverse dynamics of closed-loop mechanisms.
//!
//! A [`Blueprint`] says what there is; [`Mechanism::build`] picks a spanning tree, the joints that
//! close loops, and freezes both; an [`Engine`] moves it. Numbers are SI throughout. This crate knows
//! no text, file, unit or clock: errors name entities by id.
#![expect(non_snake_case, reason = "local names follow the notation of NOTATION.md: X_WF, p_WB, R_WF")]

mod attitude;
mod blueprint;
mod builder;
mod constraint;
mod dynamics;
mod engine;
mod error;
mod flexible;
mod forces;
mod forward;
mod kinematics;
mod lifted;
mod mass_matrix;
mod mechanism;
mod recursive;
mod resting;
mod solver;
mod topology;
mod workspace;

pub use blueprint::{
    Axes, Blueprint, Body, BodyId, Coordinate, Force, ForceId, Joint, JointId, JointKind, Place, Value,
};
pub use engine::{
    Actuation, Assembled, BodyMotion, Checks, Energy, Engine, Equilibrium, ForceOutput, Freedom, Inputs, Moved,
    PointMotion, Prescription, Reading, Readings, Redundancy, SEEDS, Seeded, Wrench,
};
pub use error::{BuildError, MechanismError, System};
pub use flexible::{Flexible, ShapeInertia, Shortening};
pub use forward::{
    Advance, Begun, Dynamics, Event, EventKind, Forward, Linearized, Method, Mode, SolverEffort, Surroundings,
};
pub use mechanism::Mechanism;
pub use solver::{Machine, engine_for};
