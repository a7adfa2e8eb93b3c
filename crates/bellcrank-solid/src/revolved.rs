//! Pins, bushes and other bodies of revolution.

/// A closed profile turned once about an axis; lengths in m.
#[derive(Clone, Debug)]
pub struct Revolved<T> {
    /// Origin of the profile's coordinates.
    pub base: [T; 3],
    /// Direction of the axis, of length one.
    pub axis: [T; 3],
    /// Corners `[r, h]`: distance from the axis (not negative) and height along it, in order, either way round.
    pub profile: Vec<[T; 2]>,
}
