//! What the documents show is what the program does.

use crate::sandbox::{Sandbox, text};

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
