use super::*;
use crate::{Drawing, SpaceKind, Table};

fn column(name: &str, unit: Unit, values: &[f64]) -> Column {
    Column { name: name.to_owned(), unit, values: values.to_vec() }
}

fn study() -> StudyResult {
    let degree = std::f64::consts::PI / 180.0;
    StudyResult {
        name: "lift".to_owned(),
        kind: "inverse-dynamics".to_owned(),
        axis: vec!["joint.B.position".to_owned()],
        table: Table {
            columns: vec![
                column("joint.B.position", Unit::new("deg", degree), &[-30.0 * degree, 30.0 * degree]),
                column("drive.slide.force", Unit::new("N", 1.0), &[6473.5, 6175.5]),
                column("nowhere", Unit::one(), &[f64::NAN, f64::NAN]),
            ],
        },
        reactions: vec![Reaction {
            joint: "B".to_owned(),
            kind: "revolute".to_owned(),
            unique: vec![("fx".to_owned(), true), ("fy".to_owned(), false)],
        }],
        scalars: vec![("stiffness".to_owned(), 1200.0, Unit::new("kN/m", 1000.0))],
        warnings: vec!["look out".to_owned()],
        effort: vec![("newton_iterations".to_owned(), 12.0)],
        seconds: 0.25,
        ..StudyResult::default()
    }
}

fn arm() -> ParameterRow {
    ParameterRow {
        name: "l5".to_owned(),
        written: "950 mm".to_owned(),
        value: 0.95,
        unit: Unit::new("mm", 0.001),
        bounds: (Some(0.8), None),
        note: "arm".to_owned(),
    }
}

fn run(studies: Vec<StudyResult>) -> RunResult {
    RunResult {
        model: "lift".to_owned(),
        title: "A lift".to_owned(),
        provenance: Provenance {
            version: "0.1.0".to_owned(),
            file: "models/lift.toml".to_owned(),
            hash: "ab12".to_owned(),
            date: "2026-01-02T03:04:05Z".to_owned(),
        },
        parameters: vec![arm()],
        facts: vec![("bodies".to_owned(), "5".to_owned())],
        drawing: Drawing {
            space: SpaceKind::Planar,
            up: [0.0, 1.0, 0.0],
            bodies: Vec::new(),
            joints: Vec::new(),
            arrows: Vec::new(),
        },
        studies,
        warnings: Vec::new(),
    }
}

#[test]
fn a_study_has_exactly_this_shape() {
    let expected = r#"{"kind":"inverse-dynamics","rows":2,"seconds":0.25,"warnings":["look out"],"effort":{"newton_iterations":12},"axis":[{"name":"joint.B.position","unit":"deg"}],"signals":{"joint.B.position":{"unit":"deg","min":{"value":-30.0,"at":{"joint.B.position":-30.0}},"max":{"value":30.0,"at":{"joint.B.position":30.0}},"range":60.0,"rms":30.0,"mean":0.0,"first":-30.0,"last":30.0},"drive.slide.force":{"unit":"N","min":{"value":6175.5,"at":{"joint.B.position":30.0}},"max":{"value":6473.5,"at":{"joint.B.position":-30.0}},"range":298.0,"rms":6326.254915034645,"mean":6324.5,"first":6473.5,"last":6175.5},"nowhere":{"unit":""}},"scalars":{"stiffness":{"value":1.2,"unit":"kN/m"}},"reactions":{"B":{"kind":"revolute","unique":{"fx":true,"fy":false}}}}"#;
    assert_eq!(study_summary(&study()).to_string(), expected);
}

#[test]
fn a_failure_is_told_with_its_hints() {
    let mut study = study();
    study.failure = Some(Failure { message: "stuck".to_owned(), hints: vec!["push".to_owned()] });
    let summary = study_summary(&study);
    assert_eq!(summary["failure"], json!({ "message": "stuck", "hints": ["push"] }));
}

#[test]
fn overridden_parameters_are_named() {
    let mut study = study();
    study.changed = vec![arm()];
    assert_eq!(study_summary(&study)["set"]["l5"]["value"], 950.0);
}

#[test]
fn a_run_names_everything() {
    let summary = run_summary(&run(vec![study()]));
    assert_eq!(summary["bellcrank"], "0.1.0");
    assert_eq!(summary["studies"]["lift"]["rows"], 2);
    assert_eq!(
        summary["parameters"]["l5"].to_string(),
        r#"{"value":950.0,"unit":"mm","written":"950 mm","min":800.0,"max":null,"note":"arm"}"#
    );
    assert_eq!(summary["facts"]["bodies"], "5");
}

#[test]
fn an_empty_run_and_an_empty_table_are_fine() {
    let mut empty = study();
    empty.table = Table::default();
    let summary = run_summary(&run(vec![empty]));
    assert_eq!(summary["studies"]["lift"]["rows"], 0);
    assert_eq!(summary["studies"]["lift"]["axis"][0]["unit"], Value::Null);
    assert_eq!(run_summary(&run(Vec::new()))["studies"], json!({}));
}

#[test]
fn undefined_numbers_are_null() {
    let mut study = study();
    study.scalars = vec![("gap".to_owned(), f64::NAN, Unit::one())];
    study.table.columns[0].values[1] = f64::INFINITY;
    let summary = study_summary(&study);
    assert_eq!(summary["scalars"]["gap"]["value"], Value::Null);
    let at = &summary["signals"]["drive.slide.force"]["min"]["at"]["joint.B.position"];
    assert_eq!(*at, Value::Null);
}
