//! The format as data.

/// JSON Schema (draft 2020-12) of the model file.
#[must_use]
pub fn schema() -> serde_json::Value {
    todo!()
}
