//! The name that was probably meant.

/// The candidate nearest to `name`, if any is near: equal but for case first, then by
/// Damerau-Levenshtein distance up to a third of the length (one for short names).
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    todo!()
}
