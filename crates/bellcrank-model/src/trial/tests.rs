use std::path::{Path, PathBuf};

use bellcrank_doc::{Reader, ValueKind};

use super::{Asked, Trial};
use crate::design::Study;
use crate::signals::{AllSignals, Signal};
use crate::{Model, load};

fn machine(file: &str) -> Model {
    let path: PathBuf = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models").join(file);
    let loaded = load(&path, &[]);
    loaded.model.unwrap_or_else(|| panic!("{}", loaded.diagnostics.render(&loaded.sources, false)))
}

/// Responses given as text, and the signals they use.
fn asked(model: &Model, study: &Study, texts: &[&str]) -> (Asked, Vec<Signal>) {
    let reader = Reader::new(&study.parameters);
    let mut signals = AllSignals { catalogue: &model.design().catalogue, used: Vec::new() };
    let mut asked = Asked::default();
    for text in texts {
        let value = value(text);
        let response = reader.response(&value, "the response", &mut signals).expect("reads");
        asked.response(&response);
    }
    (asked, signals.used)
}

fn value(text: &str) -> bellcrank_doc::Value {
    let mut sources = bellcrank_doc::Sources::new();
    let mut diagnostics = bellcrank_doc::Diagnostics::new();
    let id = sources.add("response", &format!("r = '{text}'"));
    let table = bellcrank_doc::parse(&sources, id, &mut diagnostics);
    let value = table.get("r").map(|entry| entry.value.clone()).expect("a value");
    assert!(matches!(value.kind, ValueKind::String(_)));
    value
}

fn study<'m>(model: &'m Model, name: &str) -> &'m Study {
    model.study_list().iter().find(|study| study.name == name).expect("a study")
}

fn indices(study: &Study, names: &[&str]) -> Vec<usize> {
    names.iter().map(|name| study.parameters.index(name).expect("a parameter")).collect()
}

#[test]
fn the_papers_sensitivities() {
    let model = machine("assist-manipulator/lift.toml");
    let lift = study(&model, "lift");
    let (asked, signals) = asked(&model, lift, &["max(abs(drive.slide.force))"]);
    let mut trial = Trial::new(model.design(), lift, &lift.parameters, &signals, asked);
    let peak = trial.run(&[]).expect("runs")[0];
    assert!((peak - 6473.6).abs() < 0.05, "{peak}");
    let by = indices(lift, &["l32", "l5", "l31", "m5", "m3", "m1"]);
    let derived = trial.gradients(&by).expect("differentiates");
    let relative: Vec<f64> =
        derived[0].active.gradient.iter().zip(&by).map(|(d, &p)| d * lift.parameters.values()[p] / peak).collect();
    for (found, wanted) in relative.iter().zip([-0.9676, 0.9322, 0.0459, 0.0889, 0.0853, 0.0775]) {
        assert!((found - wanted).abs() < 5e-5, "{relative:?}");
    }
}
