use std::path::{Path, PathBuf};

use bellcrank_doc::{Reader, ValueKind};

use super::{Asked, Trial};
use crate::design::{Study, Task};
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
    let id = sources.add("response", format!("r = '{text}'"));
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

/// Every shipped machine with its studies over positions, over time and at rest.
fn machines() -> Vec<String> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../models");
    let mut files = Vec::new();
    for folder in std::fs::read_dir(root).expect("models").filter_map(Result::ok) {
        let inside = std::fs::read_dir(folder.path()).into_iter().flatten().filter_map(Result::ok);
        let toml = |path: &PathBuf| {
            path.file_name().is_some_and(|name| {
                let name = name.to_string_lossy();
                name.ends_with(".toml") && !name.ends_with("expected.toml")
            })
        };
        files.extend(inside.map(|entry| entry.path()).filter(toml));
    }
    files.sort();
    files.into_iter().map(|file| file.display().to_string()).collect()
}

/// Responses over a spread of a study's signals.
fn responses(model: &Model, study: &Study) -> Vec<String> {
    let forces = !matches!(study.task, crate::design::Task::Motion { forces: false, .. });
    let names: Vec<String> = model.design().catalogue.names().collect();
    let kinds = ["max", "mean", "rms", "min", "range", "first", "last"];
    let usable = |name: &&String| {
        let force = name.starts_with("drive.") || name.contains(".reaction.") || name.starts_with("force.");
        !name.starts_with("check.") && name.as_str() != "time" && (forces || !force) && !name.starts_with("drive.")
    };
    let stride = (names.len() / 14).max(1);
    let some = names.iter().filter(usable).step_by(stride).enumerate();
    some.map(|(i, name)| format!("{}({name})", kinds[i % kinds.len()])).collect()
}

/// Richardson's extrapolation of central differences and its uncertainty.
fn difference(trial: &mut Trial<'_>, parameter: usize, value: f64, size: f64) -> Option<Vec<(f64, f64)>> {
    let mut levels: Vec<Vec<f64>> = Vec::new();
    for level in 0..3 {
        let h = size * 1e-3 / f64::from(1 << level);
        let up = trial.run(&[(parameter, value + h)]).ok()?.to_vec();
        let down = trial.run(&[(parameter, value - h)]).ok()?.to_vec();
        levels.push(up.iter().zip(&down).map(|(a, b)| (a - b) / (2.0 * h)).collect());
    }
    let better = |a: &[f64], b: &[f64], k: f64| -> Vec<f64> { a.iter().zip(b).map(|(a, b)| b + (b - a) / k).collect() };
    let (one, two) = (better(&levels[0], &levels[1], 3.0), better(&levels[1], &levels[2], 3.0));
    let best = better(&one, &two, 15.0);
    Some(best.iter().zip(&two).map(|(a, b)| (*a, (a - b).abs())).collect())
}

#[test]
fn derivatives_of_responses_on_every_shipped_machine() {
    let (mut compared, mut uncertain) = (0, 0);
    for file in machines() {
        let model = load(Path::new(&file), &[]).model.expect("a model");
        // By what makes another mesh of a flexible body they are differences themselves.
        let meshed = model.design().bodies.iter().any(|body| body.flexible.is_some());
        let rigid = |study: &&Study| !(matches!(study.task, Task::Later | Task::Parts(_)) || meshed && study.flexible);
        for study in model.study_list().iter().filter(rigid) {
            let texts = responses(&model, study);
            let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
            let (asked, signals) = asked(&model, study, &texts);
            let mut trial = Trial::new(model.design(), study, &study.parameters, &signals, asked);
            let what = format!("{file} {}", study.name);
            let Ok(values) = trial.run(&[]).map(<[f64]>::to_vec) else { continue };
            let by: Vec<usize> = (0..study.parameters.all().len()).step_by(3).take(5).collect();
            let derived = match trial.gradients(&by) {
                Ok(derived) => derived,
                Err(why) => panic!("{what}: {}", why.message),
            };
            for (lane, &p) in by.iter().enumerate() {
                let value = study.parameters.values()[p];
                let size = if value == 0.0 { 1.0 } else { value.abs() };
                let Some(differences) = difference(&mut trial, p, value, size) else { continue };
                for (i, (d, error)) in differences.iter().enumerate() {
                    let exact = derived[i].active.gradient[lane];
                    // Redundant loops that one length alone would tear open have no derivative.
                    if exact.is_nan() || *error > 1e-6 * d.abs().max(values[i].abs() / size) {
                        uncertain += 1;
                        continue;
                    }
                    compared += 1;
                    let scale = d.abs().max(values[i].abs() / size).max(1e-5);
                    let name = &study.parameters.all()[p].name;
                    assert!(
                        (exact - d).abs() <= 2e-6 * scale,
                        "{what} {} by {name}: {exact} and {d} ± {error}",
                        texts[i]
                    );
                }
            }
        }
    }
    assert!(compared > 10 * uncertain && compared > 400, "{compared} compared, {uncertain} uncertain");
}

#[test]
fn the_angle_of_a_turning_body_runs_on() {
    let model = machine("four-bar/four-bar.toml");
    let turns =
        |s: &&Study| matches!(&s.task, crate::design::Task::Motion { over: crate::design::Over::Positions { .. }, .. });
    let turn = model.study_list().iter().find(turns).expect("a sweep");
    let crank = model.design().bodies.iter().skip(1).map(|body| format!("range(body.{}.angle)", body.name));
    let texts: Vec<String> = crank.chain(["range(joint.A.position)".to_owned()]).take(1).collect();
    let texts: Vec<&str> = texts.iter().map(String::as_str).collect();
    let (asked, signals) = asked(&model, turn, &texts);
    let mut trial = Trial::new(model.design(), turn, &turn.parameters, &signals, asked);
    let range = trial.run(&[]).expect("runs")[0];
    let table = crate::run::run(model.design(), turn, &mut crate::Silent).table;
    let name = texts[0].trim_start_matches("range(").trim_end_matches(')');
    let values = &table.column(name).expect("a column").values;
    let wanted = values.iter().fold(f64::MIN, |m, x| m.max(*x)) - values.iter().fold(f64::MAX, |m, x| m.min(*x));
    assert!(wanted > 3.2, "a crank that turns: {wanted}");
    assert!((range - wanted).abs() < 1e-3 * wanted && range >= wanted - 1e-12, "{range} and {wanted}");
}
