//! The schema and the starter.

use bellcrank_model::{schema, starter};

use crate::support::{model, run};

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
