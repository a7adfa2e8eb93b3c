//! The command line as its users see it.

mod asks;
mod check;
mod converge;
mod documents;
mod dynamics;
mod interrupt;
mod other;
mod run;
mod sandbox;
mod snapshot;
mod solids;
mod sweep;
mod wrong;
