//! The crate from outside: diagnostics, runs, random files.

mod asks;
mod cases;
mod designs;
mod dynamics;
mod files;
mod flexible;
mod format;
mod improve;
mod lever;
mod lift;
mod modes;
mod planar_in_space;
mod programme;
mod random;
mod residuals;
mod sizing;
mod solids;
mod stress;
mod studies;
mod subsystems;
mod suite;
mod support;
mod there_and_back;
mod tolerance;
