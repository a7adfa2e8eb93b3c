//! What the documents show is what the program does.

use std::fs;
use std::path::Path;

use crate::sandbox::{Sandbox, text};
use crate::snapshot::redacted;

#[test]
fn the_example_of_the_format_page_runs() {
    let page = include_str!("../../../../docs/model-file.md");
    let example = page.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let sandbox = Sandbox::new("documents-format");
    sandbox.write("example.toml", example);
    let output = sandbox.run(&["run", "example.toml"]);
    assert_eq!(text(&output.stderr), "");
    assert_eq!(output.status.code(), Some(0));
}

/// The command of the README with what it prints, times and rounding errors aside.
#[test]
fn the_readme_shows_what_the_program_prints() {
    let sandbox = Sandbox::with_lift("documents-readme");
    let printed = text(&sandbox.run(&["run", "lift.toml"]).stdout);
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../README.md");
    let page = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
    let (before, rest) = page.split_once("A summary in the terminal:\n\n```\n").unwrap();
    let (shown, after) = rest.split_once("```\n").unwrap();
    if std::env::var_os("BELLCRANK_BLESS").is_some() && redacted(shown) != redacted(&printed) {
        fs::write(&path, format!("{before}A summary in the terminal:\n\n```\n{printed}```\n{after}")).unwrap();
        return;
    }
    assert_eq!(redacted(shown), redacted(&printed), "`cargo xtask bless` accepts it");
}
