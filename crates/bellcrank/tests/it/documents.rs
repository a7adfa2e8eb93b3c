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

/// Each block of the page that begins with a command holds what the program then prints, errors and iterations first.
#[test]
fn the_page_of_studies_shows_what_the_program_prints() {
    const OPEN: &str = "```text\n$ bellcrank ";
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../docs/studies.md");
    let page = fs::read_to_string(&path).unwrap().replace("\r\n", "\n");
    let studies = page.split("```toml\n").nth(1).and_then(|rest| rest.split("```").next()).unwrap();
    let sandbox = Sandbox::new("documents-studies");
    sandbox.write("lift.toml", format!("{}\n{studies}", crate::sandbox::LIFT));
    let mut parts = page.split(OPEN);
    let mut printed = parts.next().unwrap_or_default().to_owned();
    for part in parts {
        let (block, after) = part.split_once("```\n").unwrap();
        let command = block.lines().next().unwrap();
        let output = sandbox.run(&command.split(' ').collect::<Vec<_>>());
        let seen = text(&output.stderr) + &text(&output.stdout);
        let shown = block.split_once('\n').map_or("", |(_, shown)| shown);
        // Times of the run before are as good.
        let body = if redacted(shown) == redacted(&seen) { shown } else { &seen };
        printed.push_str(&format!("{OPEN}{command}\n{body}```\n{after}"));
    }
    if std::env::var_os("BELLCRANK_BLESS").is_some() {
        fs::write(&path, &printed).unwrap();
        return;
    }
    assert!(page == printed, "`cargo xtask bless` accepts it:\n{printed}");
}
