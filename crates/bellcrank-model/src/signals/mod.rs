//! Signals: one name for a quantity everywhere.

mod catalogue;
mod columns;
mod probe;
mod reading;
mod resolver;

pub(crate) use catalogue::{Catalogue, ForceLayout, JointLayout, Layout, Outputs, Signal, Source};
pub(crate) use columns::{Column, Level, PLANAR_ANGLE, reaction_components};
pub(crate) use probe::Probe;
pub(crate) use reading::{MOST, View};
pub(crate) use resolver::{AllSignals, InstantSignals, TimeOnly};
