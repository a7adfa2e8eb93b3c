//! The validation page of the assist manipulator: every number that its paper states, or that was recomputed from the
//! paper's own equations, beside the one that the program computes now.

mod errors;
mod figure;
mod machine;
mod page;
mod positions;
mod questions;

use crate::shell::{Outcome, root};

const PAGE: &str = "docs/validation/assist-manipulator.md";

/// Writes the page.
pub(crate) fn run(_: &[String]) -> Outcome {
    std::fs::write(root().join(PAGE), page::page()?).map_err(|error| format!("{PAGE}: {error}"))?;
    println!("wrote {PAGE}");
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_page_is_what_the_program_computes() {
        let computed = page::page().unwrap_or_else(|error| panic!("{error}"));
        if std::env::var_os(crate::bless::SWITCH).is_some() {
            run(&[]).unwrap_or_else(|error| panic!("{error}"));
        }
        let kept = std::fs::read_to_string(root().join(PAGE)).unwrap_or_default();
        assert!(
            kept == computed,
            "{PAGE} is not what the program computes now: `cargo xtask paper`, and read the diff"
        );
        assert!(!computed.contains(figure::DEVIATES), "the page says that a figure is not reproduced");
    }
}
