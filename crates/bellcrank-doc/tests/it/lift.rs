//! The example of the format's page, read as a schema would.

use bellcrank_doc::{Diagnostics, Dimension, Fields, NoSignals, Override, ParameterSet, Reader, Sources, load, parse};

pub(crate) const LIFT: &str = include_str!("lift.toml");

#[test]
fn the_lift_is_read_without_a_word() {
    let mut sources = Sources::new();
    let mut diagnostics = Diagnostics::new();
    let id = load(&mut sources, "lift.toml", LIFT.as_bytes(), &mut diagnostics).unwrap();
    let tree = parse(&sources, id, &mut diagnostics);
    let parameters = ParameterSet::read(tree.get("parameters").unwrap().value.as_table().unwrap(), &mut diagnostics);
    assert_eq!(parameters.all().len(), 11);

    let reader = Reader::new(&parameters);
    let model = Fields::new(&reader, &tree, "the model");
    let bodies = model.entries("bodies");
    assert_eq!(bodies.len(), 5);
    let link3 = bodies.iter().find(|b| b.key == "link3").unwrap();
    let body = reader.fields(&link3.value, "body `link3`").unwrap();
    let inertia = body.quantity("inertia", Dimension::INERTIA).unwrap();
    let center = body.vector("center", &[Dimension::LENGTH; 2]).unwrap();
    let value = |e: &bellcrank_doc::Expression| e.eval::<f64>(parameters.values(), &[]);
    assert!((value(&inertia) - 20.8 * 0.425 * 0.425).abs() < 1e-14);
    assert!((value(&center[0]) - 0.425).abs() < 1e-15);

    let massless = model.entries("studies").iter().find(|s| s.key == "massless").unwrap();
    let set = massless.value.as_table().unwrap().get("set").unwrap().value.as_table().unwrap();
    let overrides = Override::from_table(set, &mut diagnostics);
    let (other, _) = parameters.with_overrides(&overrides).unwrap();
    // Compiled against the file's parameters, evaluated with the study's.
    assert_eq!(inertia.eval(other.values(), &[]), 0.0);

    let influence = model.entries("studies").iter().find(|s| s.key == "influence").unwrap();
    let response = &influence.value.as_table().unwrap().get("response").unwrap().value;
    assert!(reader.response(response, "`response`", &mut NoSignals).is_none());
    drop((body, model));
    assert_eq!(reader.finish().errors(), 1);
    assert!(!diagnostics.has_errors());
}
