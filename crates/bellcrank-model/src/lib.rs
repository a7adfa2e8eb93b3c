//! From a model file to a mechanism, and from a study to results.
