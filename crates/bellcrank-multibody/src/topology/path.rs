//! The motions between two nodes of the tree.

/// A node on the way from one body to another, and the sign with which its motion enters the relative
/// motion of the second against the first.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct PathEntry {
    pub(crate) node: usize,
    pub(crate) sign: f64,
}

/// Nodes between `first` and `second`, common ancestors left out. `parents[i] < i`, node 0 is the root.
pub(crate) fn path_between(parents: &[usize], first: usize, second: usize) -> Vec<PathEntry> {
    let (mut a, mut b) = (first, second);
    let mut path = Vec::new();
    while a != b {
        if a > b {
            path.push(PathEntry { node: a, sign: -1.0 });
            a = parents[a];
        } else {
            path.push(PathEntry { node: b, sign: 1.0 });
            b = parents[b];
        }
    }
    path
}
