//! Plane geometry of lines and arcs: outlines, where they meet, and the cells between them.

pub(crate) mod arrangement;
pub(crate) mod crossing;
pub(crate) mod faces;
pub(crate) mod outline;
pub(crate) mod segment;
pub(crate) mod tangent;
pub(crate) mod vector;
