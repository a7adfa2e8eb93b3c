//! A model to start from.

/// A commented model file that runs; `name` becomes its title.
#[must_use]
pub fn starter(_name: &str) -> String {
    todo!()
}
