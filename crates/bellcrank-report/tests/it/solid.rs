//! What the page carries for the solid drawing, and what a run leaves for other programs.

use bellcrank_report::{Exports, render_html, write_run};
use bellcrank_results::RunResult;
use serde_json::Value;

use crate::markup::between;
use crate::sample::{lift, stewart};

fn data(page: &str) -> Value {
    serde_json::from_str(between(page, "id=\"bellcrank-data\">", "</script>")).unwrap()
}

#[test]
fn the_script_comes_once_and_only_where_something_moves() {
    let mut run = lift::run();
    let count = |run: &RunResult| render_html(run).matches("id=\"bellcrank-solid\"").count();
    assert_eq!(count(&run), 1);
    for study in &mut run.studies {
        study.animation = None;
    }
    assert_eq!(count(&run), 0);
}

#[test]
fn the_packed_script_is_gzip_in_base64() {
    let page = render_html(&stewart::run());
    let packed = between(&page, "id=\"bellcrank-solid\">", "</script>");
    // 1f 8b 08: gzip, deflate.
    assert!(packed.starts_with("H4sI") && packed.len().is_multiple_of(4));
    assert!(packed.bytes().all(|c| c.is_ascii_alphanumeric() || b"+/=".contains(&c)));
    assert!(packed.len() < 300_000, "{}", packed.len());
}

#[test]
fn the_page_knows_what_is_up_and_what_is_solid() {
    let data = data(&render_html(&stewart::run()));
    assert_eq!(data["drawing"]["axes"], serde_json::json!([[1.0, 0.0, 0.0], [0.0, 0.0, 1.0], [0.0, -1.0, 0.0]]));
    let solids = data["studies"][0]["animation"]["solids"].as_array().unwrap();
    let bodies = data["drawing"]["bodies"].as_array().unwrap().len();
    assert!((0..bodies).all(|body| solids.iter().any(|part| part["body"] == body)));
    for kind in ["rod", "ball", "plate"] {
        assert!(solids.iter().any(|part| part["shape"].get(kind).is_some()), "{kind}");
    }
}

#[test]
fn exports_are_written_where_there_is_something_to_write() {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-exports", std::process::id()));
    let mut run = lift::run();
    run.studies[1].animation = None;
    let written = write_run(&run, &dir, Exports { gltf: true, parquet: true, vtu: false }).unwrap();
    let has = |name: &str| written.contains(&dir.join(name)) && dir.join(name).is_file();
    assert!(has("lift/motion.glb") && has("lift/series.parquet") && has("massless/series.parquet"));
    assert!(!dir.join("massless/motion.glb").exists());
    std::fs::remove_dir_all(dir).unwrap();
}
