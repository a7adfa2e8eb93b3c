//! Text, spans, TOML tree, units, expressions, parameters and diagnostics of bellcrank's model files.
