//! Accepts what the program now prints: snapshots and generated pages. A `reference.toml` says what is
//! true, not what the program does, and is never touched.

use crate::shell::{self, Outcome};

/// Tests that compare with a stored text rewrite it when this is set.
pub(crate) const SWITCH: &str = "BELLCRANK_BLESS";

/// Runs the tests that own stored texts with [`SWITCH`] set.
pub(crate) fn run(_: &[String]) -> Outcome {
    shell::run(shell::cargo_command().args(["test", "--workspace", "--quiet"]).env(SWITCH, "1"))
}
