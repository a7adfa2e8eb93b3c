//! The engine against theory: closed forms, and identities on random mechanisms.

#![expect(unreachable_pub, reason = "a test binary has no outside")]

mod arm;
mod build;
mod chain;
mod events;
mod flexible;
mod forward;
mod lift;
mod machines;
mod modes;
mod random;
mod recursive;
mod renewed;
mod statics;
mod tangent;
mod there_and_back;
