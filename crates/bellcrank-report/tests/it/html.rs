use bellcrank_report::render_html;
use bellcrank_results::{Findings, RunResult, StudyResult, Table};
use serde_json::Value;

use crate::markup::{assert_balanced, between};
use crate::sample::{kinds, lift, stewart};

fn without_rows() -> RunResult {
    let mut run = lift::run();
    for column in &mut run.studies[0].table.columns {
        column.values.clear();
    }
    run.studies[0].animation = None;
    run.studies[1].table = Table::default();
    run
}

fn hostile() -> RunResult {
    let mut run = lift::run();
    let evil = "</script><img src=x onerror=alert(1)>\"'&\u{1b}[2J".to_owned();
    run.model.clone_from(&evil);
    run.title.clone_from(&evil);
    run.provenance.file.clone_from(&evil);
    run.facts.push((evil.clone(), evil.clone()));
    run.warnings.push(evil.clone());
    run.parameters[0].name.clone_from(&evil);
    run.parameters[0].unit.symbol.clone_from(&evil);
    run.parameters[0].note.clone_from(&evil);
    run.drawing.joints[0].name.clone_from(&evil);
    let study = &mut run.studies[0];
    study.name.clone_from(&evil);
    study.kind.clone_from(&evil);
    study.reactions[0].joint.clone_from(&evil);
    study.warnings.push(evil.clone());
    study.effort.push((evil.clone(), 1.0));
    study.axis = vec![evil.clone()];
    for column in &mut study.table.columns {
        column.name = column.name.replace("joint.B", &format!("joint.{evil}"));
        column.unit.symbol.clone_from(&evil);
    }
    study.table.columns[0].name = evil;
    run
}

/// Every text of every finding is markup.
fn hostile_kinds() -> RunResult {
    let mut run = kinds::run();
    let evil = "</script><img src=x onerror=alert(1)>\"'&\u{1b}[2J".to_owned();
    for study in &mut run.studies {
        match study.findings.as_mut() {
            Some(Findings::Sensitivity(found)) => {
                found.response.clone_from(&evil);
                found.of.clone_from(&evil);
                found.unit.symbol.clone_from(&evil);
                found.parameters[0].name.clone_from(&evil);
                found.parameters[0].note.clone_from(&evil);
                found.parameters[0].derivative_unit.symbol.clone_from(&evil);
            }
            Some(Findings::Optimization(found)) => {
                found.status.clone_from(&evil);
                found.objective.written.clone_from(&evil);
                found.objective.unit.symbol.clone_from(&evil);
                found.variables[0].name.clone_from(&evil);
                found.variables[0].unit.symbol.clone_from(&evil);
                found.constraints[1].written.clone_from(&evil);
                found.constraints[1].unit.symbol.clone_from(&evil);
                found.starts[0].status.clone_from(&evil);
            }
            Some(Findings::Designs(found)) => {
                found.method.clone_from(&evil);
                found.failures[0].reason.clone_from(&evil);
                found.files[0].clone_from(&evil);
                found.sample.columns[1].name.clone_from(&evil);
                found.sample.columns[1].unit.symbol.clone_from(&evil);
                found.statistics[0].name.clone_from(&evil);
                found.pareto.as_mut().unwrap().front.columns[1].name.clone_from(&evil);
            }
            Some(Findings::Tolerance(found)) => {
                found.response.clone_from(&evil);
                found.inputs[0].name.clone_from(&evil);
                found.inputs[0].unit.symbol.clone_from(&evil);
            }
            Some(Findings::Sizing(found)) => {
                found.candidates[0].name.clone_from(&evil);
                found.candidates[0].checks[0].key.clone_from(&evil);
                found.candidates[0].checks[0].reason.clone_from(&evil);
                found.requirements[0].label.clone_from(&evil);
                study.table.columns[1].name.clone_from(&evil);
            }
            Some(Findings::Modes(_) | Findings::Stress(_) | Findings::BodyModes(_)) | None => {}
        }
    }
    run
}

fn runs() -> Vec<RunResult> {
    let mut empty = lift::run();
    empty.studies.clear();
    empty.parameters.clear();
    empty.facts.clear();
    vec![
        lift::run(),
        lift::troubled(),
        stewart::run(),
        without_rows(),
        hostile(),
        empty,
        kinds::run(),
        kinds::poor(),
        hostile_kinds(),
    ]
}

#[test]
fn every_element_closes() {
    for run in runs() {
        assert_balanced(&render_html(&run));
    }
}

#[test]
fn nothing_is_fetched() {
    for run in [lift::run(), lift::troubled(), stewart::run(), kinds::run()] {
        let page = render_html(&run);
        for sign in ["http://", "https://", " src=", "url(", "@import"] {
            assert!(!page.contains(sign), "{sign}");
        }
        let outside = page.match_indices("href=\"").map(|(at, sign)| &page[at + sign.len()..]);
        assert!(outside.into_iter().all(|target| target.starts_with('#') || target.starts_with("data:,")));
        assert!(page.contains("default-src 'none'"));
    }
}

#[test]
fn names_from_a_file_stay_text() {
    for run in [hostile(), hostile_kinds()] {
        let page = render_html(&run);
        assert!(!page.contains("<img"));
        assert!(!page.contains('\u{1b}'));
        assert!(page.contains("&lt;/script&gt;&lt;img"));
    }
}

#[test]
fn contents_lead_to_every_study() {
    let page = render_html(&lift::troubled());
    for id in ["model", "study-lift__fast_", "study-lift", "provenance", "signature"] {
        assert!(page.contains(&format!("href=\"#{id}\"")), "{id}");
        assert!(page.contains(&format!("id=\"{id}\"")), "{id}");
    }
}

#[test]
fn key_numbers_are_told_with_their_places() {
    let page = render_html(&lift::run());
    assert!(page.contains("complete, without warnings"));
    let massless = between(&page, "id=\"study-massless\"", "</section>");
    for text in ["4844.52 N", "joint.B.position = −30 deg", "159.931 mm", "−79.648", "Instead of", "pass"] {
        assert!(massless.contains(text), "{text}");
    }
    assert!(page.contains("lever: cylinder pin below the arm"));
}

#[test]
fn trouble_is_told_first() {
    let page = render_html(&lift::troubled());
    assert!(page.find("stopped early").unwrap() < page.find("id=\"model\"").unwrap());
    let study = between(&page, "id=\"study-lift__fast_\"", "</section>");
    for text in [
        "This study stopped before its end",
        "<li>end the sweep at -8 deg</li>",
        "the 220 rows before that",
        "joints <code>O</code>",
        "not unique",
        "FAIL",
    ] {
        assert!(study.contains(text), "{text}");
    }
}

#[test]
fn a_study_without_rows_says_so() {
    let page = render_html(&without_rows());
    assert_eq!(page.matches("There are no rows to draw.").count(), 2);
}

#[test]
fn a_study_with_one_row_is_drawn() {
    let mut run = lift::run();
    for column in &mut run.studies[0].table.columns {
        column.values.truncate(1);
    }
    assert_balanced(&render_html(&run));
}

#[test]
fn an_unknown_axis_counts_rows() {
    let mut run = lift::run();
    run.studies[0].axis = vec!["nowhere".to_owned()];
    assert!(render_html(&run).contains("at row 0"));
}

/// Reads a packed column back as the browser does.
fn unpacked(bytes: &[u8], column: &Value, rows: usize) -> Vec<f64> {
    let at = column["at"].as_u64().unwrap() as usize;
    if column["double"] == true {
        let values = bytes[at..at + 8 * rows].chunks(8);
        return values.map(|b| f64::from_le_bytes(b.try_into().unwrap())).collect();
    }
    let values = bytes[at..at + 4 * rows].chunks(4);
    values.map(|b| f64::from(f32::from_le_bytes(b.try_into().unwrap()))).collect()
}

fn decoded(text: &str) -> Vec<u8> {
    let six = |c: u8| match c {
        b'A'..=b'Z' => c - b'A',
        b'a'..=b'z' => c - b'a' + 26,
        b'0'..=b'9' => c - b'0' + 52,
        b'+' => 62,
        _ => 63,
    };
    let group = |group: &[u8]| {
        let bits = group.iter().fold(0_u32, |bits, c| (bits << 6) | if *c == b'=' { 0 } else { u32::from(six(*c)) });
        let padding = group.iter().filter(|c| **c == b'=').count();
        bits.to_be_bytes()[1..4 - padding].to_vec()
    };
    text.as_bytes().chunks(4).flat_map(group).collect()
}

fn column(study: &StudyResult, name: &str) -> Vec<f64> {
    let column = study.table.column(name).unwrap();
    column.values.iter().map(|si| column.unit.show(*si)).collect()
}

#[test]
fn the_numbers_in_the_page_are_those_of_the_run() {
    let run = lift::run();
    let page = render_html(&run);
    let data: Value =
        serde_json::from_str(between(&page, "id=\"bellcrank-data\">", "</script>")).expect("the data block is JSON");
    for (index, study) in run.studies.iter().enumerate() {
        let packed = &data["studies"][index];
        let bytes = decoded(between(&page, &format!("id=\"bellcrank-blob-{index}\">"), "</script>"));
        assert_eq!(packed["rows"], 601);
        for column_of in packed["columns"].as_array().unwrap() {
            let expected = column(study, column_of["name"].as_str().unwrap());
            if let Some(constant) = column_of["constant"].as_f64() {
                assert!(expected.iter().all(|value| *value == constant));
                continue;
            }
            let found = unpacked(&bytes, column_of, 601);
            let close = |(a, b): (&f64, &f64)| (a - b).abs() <= 1e-6 * b.abs().max(1e-30);
            assert!(found.iter().zip(&expected).all(close), "{}", column_of["name"]);
        }
    }
}
