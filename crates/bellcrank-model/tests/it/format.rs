//! The schema and the starter.

use bellcrank_model::{load, schema, starter};

use crate::support::{Scratch, lift, model, rendered, root, run};

#[test]
fn the_starter_runs() {
    let model = model("starter", &starter("my \"machine\" \\ 1"));
    assert_eq!(model.title(), "my \"machine\" \\ 1");
    for study in model.studies() {
        let result = run(&model, &study.name);
        assert!(result.failure.is_none(), "{:?}", result.failure);
        assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    }
    assert!(model.check().notes.iter().all(|note| note.contains("center")), "{:?}", model.check().notes);
}

#[test]
fn the_schema_names_every_kind() {
    let schema = schema();
    assert_eq!(schema["$schema"], "https://json-schema.org/draft/2020-12/schema");
    let text = schema.to_string();
    for word in ["revolute", "point-on-line", "bushing", "joint-spring", "inverse-dynamics", "optimize", "s-curve"] {
        assert!(text.contains(word), "{word}");
    }
    let required = schema["required"].as_array().expect("a list");
    assert!(required.iter().any(|key| key == "gravity"));
}

/// The examples of studies that ask stand on the page one after another, over the lift.
#[test]
fn the_examples_of_the_page_are_read() {
    let page = std::fs::read_to_string(root().join("docs/model-file.md")).expect("the page");
    let section = page.split("\n## ").find(|section| section.starts_with("Studies that ask")).expect("the section");
    let blocks = section.split("```toml\n").skip(1).filter_map(|rest| rest.split("```").next());
    let (examples, catalogues): (Vec<&str>, Vec<&str>) = blocks.partition(|block| block.starts_with("[studies."));
    let examples = examples.concat();
    assert_eq!(examples.matches("[studies.").count(), 9, "{examples}");
    let lift = std::fs::read_to_string(lift()).expect("the lift");
    let machine = lift.split("[studies.influence]").next().expect("a machine");
    let scratch = Scratch::new("page");
    scratch.write("designs.csv", "l31 [mm],l5 [mm]\n700,900\n720,950\n");
    scratch.write("my-drives.toml", catalogues.concat());
    let loaded = load(&scratch.write("model.toml", format!("{machine}{examples}")), &[]);
    assert!(loaded.diagnostics.is_empty(), "{}", rendered(&loaded));
}
