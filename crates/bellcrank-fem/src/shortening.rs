//! Second-order displacement of an interface of a flexible body.

/// The displacement `along` counts as `d_along + ½ dᵀ C d` where it is strained: what is bent is longer than its chord. The
/// work of that against a force N along it is the geometric stiffness N·C.
#[derive(Clone, Debug, PartialEq)]
pub struct Shortening<T = f64> {
    /// Which column: 6 times the interface, and 0, 1, 2 for x, y, z.
    pub along: usize,
    /// C, n × n by rows, symmetric, in 1/m, 1 and m.
    pub matrix: Vec<T>,
}
