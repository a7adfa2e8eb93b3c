//! Exact derivatives against differences.
