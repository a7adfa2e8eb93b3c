//! The command line as its users see it.

mod asks;
mod check;
mod documents;
mod dynamics;
mod interrupt;
mod other;
mod run;
mod sandbox;
mod snapshot;
mod sweep;
mod wrong;
