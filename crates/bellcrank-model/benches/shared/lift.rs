//! The paper's lift with studies that the benches ask of it.

use std::path::Path;

use bellcrank_model::{Model, load};

/// Six sensitivities of the peak force, and of a number that needs every row.
pub(crate) const SIX: &str = r#"
[studies.six]
kind = "sensitivity"
of = "lift"
response = "max(abs(drive.slide.force))"
parameters = ["l31", "l32", "l5", "m1", "m3", "m5"]
points = 0

[studies.six_of_all_rows]
like = "six"
response = "rms(drive.slide.force)"
"#;

/// The shipped lift with so many positions and other studies behind it.
pub(crate) fn lift(more: &str, points: usize) -> Model {
    let shipped = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models/assist-manipulator/lift.toml");
    let text = std::fs::read_to_string(shipped).expect("the shipped lift");
    let text = text.replace("points = 601", &format!("points = {points}"));
    let file = std::env::temp_dir().join(format!("bellcrank-bench-{}-{points}.toml", std::process::id()));
    std::fs::write(&file, format!("{text}\n{more}")).expect("a file in the temporary folder");
    let loaded = load(&file, &[]);
    std::fs::remove_file(&file).expect("it was there");
    loaded.model.unwrap_or_else(|| panic!("{}", loaded.diagnostics.render(&loaded.sources, false)))
}
