//! Scalars, planar and spatial algebra, and small dense solves of bellcrank.
