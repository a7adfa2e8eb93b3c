//! Studies over other studies: page, files and terminal text of each kind.

use std::fs;

use bellcrank_report::{Exports, Style, figures, render_html, terminal_summary, write_run};
use serde_json::Value;

use crate::markup::{assert_balanced, between};
use crate::sample::kinds;

const PLAIN: Style = Style { color: false, width: 100 };

fn section(page: &str, name: &str) -> String {
    between(page, &format!("id=\"study-{name}\""), "</section>").to_owned()
}

fn assert_all(text: &str, parts: &[&str]) {
    for part in parts {
        assert!(text.contains(part), "{part} in\n{text}");
    }
}

#[test]
fn a_sensitivity_says_what_matters() {
    let page = render_html(&kinds::run());
    let parts = [
        "is 6476.44\u{a0}N, at <code>joint.B.position</code> = −30\u{a0}deg.",
        "1\u{a0}% more <code>l32</code> makes it 0.968\u{a0}% less",
        "<title>Relative sensitivity</title>",
        "<td class=\"n\">−0.9683</td>",
        "<code>l42</code> has no effect.",
        "no effect: the parallelogram carries the moment",
    ];
    let told = section(&page, "influence");
    assert_all(&told, &parts);
    assert_eq!(told.matches("as it is</text>").count(), 3, "a curve for each parameter with a range");
    assert!(!told.contains("There are no rows to draw"));
}

#[test]
fn an_optimum_says_what_holds_it_back() {
    let page = render_html(&kinds::run());
    let parts = [
        "goes from 6476.44\u{a0}N to 4424.84\u{a0}N (−31.7\u{a0}%).",
        "<code>l31</code> at its lower bound",
        "<span class=\"loose\">at upper</span>",
        "1\u{a0}mm more on this bound: −20.9\u{a0}N",
        "1\u{a0}mm more on the right side: +1.23\u{a0}N",
        "first-order (Karush–Kuhn–Tucker) point",
        "the 4 starts lead to 3 different points",
        "<title>Progress of the search</title>",
        "<td>C</td>",
    ];
    assert_all(&section(&page, "shorter"), &parts);
}

#[test]
fn a_sweep_shows_its_designs() {
    let page = render_html(&kinds::run());
    let parts =
        ["8 failed.", "data-designs=\"3\"", "Best compromises", "Statistics of all designs", "15 of 40, evenly spread"];
    assert_all(&section(&page, "space"), &parts);
    let data: Value = serde_json::from_str(between(&page, "id=\"bellcrank-data\">", "</script>")).unwrap();
    let designs = &data["studies"][3]["designs"];
    assert_eq!((&designs["rows"], &designs["inputs"]), (&Value::from(300), &Value::from(3)));
    assert_eq!(designs["columns"].as_array().unwrap().len(), 6);
    assert_eq!(designs["front"]["xs"].as_array().unwrap().len(), 40);
    assert!(data["studies"][0]["designs"].is_null());
}

#[test]
fn a_scatter_names_yield_and_culprit() {
    let page = render_html(&kinds::run());
    let parts = [
        "97.57\u{a0}% of the samples lie between 6330\u{a0}N and 6590\u{a0}N",
        "(95\u{a0}% confidence: 97.49\u{a0}% to 97.64\u{a0}%)",
        "Cpk is 0.675 (not capable: below 1)",
        "Most of the variance comes from <code>load</code> (94.3\u{a0}%)",
        "upper limit</text>",
        "99.865 %",
    ];
    assert_all(&section(&page, "scatter"), &parts);
}

#[test]
fn a_drive_is_proposed_and_others_are_refused_with_reasons() {
    let page = render_html(&kinds::run());
    let parts = [
        "Proposed for <code>slide</code>: <code>ISO 15552 160 x 40, stroke 160</code>, the smallest of 3",
        "<span class=\"fail\">FAIL</span> push: 6474\u{a0}N is 215\u{a0}% of the 3016\u{a0}N at 6\u{a0}bar",
        "not checked</span> speed",
        "<title>working pressure</title>",
    ];
    assert_all(&section(&page, "cylinder"), &parts);
}

#[test]
fn what_was_not_reached_is_told() {
    let run = kinds::poor();
    let page = render_html(&run);
    assert!(page.contains("complete, but 3 studies did not reach the goal"));
    for (name, why) in [
        ("shorter", "no design was found that meets all constraints"),
        ("space", "every design failed"),
        ("cylinder", "no drive passes every check"),
    ] {
        assert!(section(&page, name).contains(&format!("<b>Goal not reached:</b> {why}")), "{name}");
        assert!(terminal_summary(&run, &PLAIN).contains(&format!("goal not reached: {why}")), "{name}");
    }
    assert!(section(&page, "shorter").contains("VIOLATED"));
    assert!(page.contains("the model as it is gives no value"));
    assert!(page.contains("It is NOT shown to be a first-order"));
    assert!(!section(&page, "influence").contains("Relative sensitivity</title>"));
}

#[test]
fn pictures_hold_numbers_only() {
    for run in [kinds::run(), kinds::poor()] {
        for figure in run.studies.iter().flat_map(figures) {
            assert_balanced(&figure.svg);
            assert!(figure.svg.len() < 60_000, "{}: {}", figure.stem, figure.svg.len());
            assert!(!figure.svg.contains("NaN") && !figure.svg.contains("inf"), "{}", figure.stem);
        }
    }
}

#[test]
fn each_kind_leaves_its_files() {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-kinds", std::process::id()));
    let _ = fs::remove_dir_all(&dir);
    write_run(&kinds::run(), &dir, Exports::default()).unwrap();
    for name in [
        "influence/sensitivity.csv",
        "influence/curves.csv",
        "influence/plots/tornado.svg",
        "influence/plots/curve-l32.svg",
        "shorter/variables.csv",
        "shorter/constraints.csv",
        "shorter/iterations.csv",
        "shorter/starts.csv",
        "shorter/plots/progress.svg",
        "space/plots/parallel.svg",
        "space/plots/scatter.svg",
        "scatter/tolerances.csv",
        "scatter/histogram.csv",
        "scatter/plots/contributions.svg",
        "cylinder/candidates.csv",
        "cylinder/series.csv",
        "cylinder/plots/stroke-bar.svg",
    ] {
        assert!(dir.join(name).is_file(), "{name}");
    }
    assert!(!dir.join("influence/series.csv").exists(), "no rows, no series");
    let table = fs::read_to_string(dir.join("influence/sensitivity.csv")).unwrap();
    assert!(table.starts_with("parameter,value,unit,derivative,derivative unit,relative,note\nl31,732,mm,"), "{table}");
    fs::remove_dir_all(dir).unwrap();
}

#[test]
fn the_terminal_tells_each_kind() {
    let mut run = kinds::run();
    run.studies.remove(0);
    let expected = "\
influence  sensitivity, 12.3 ms
  `max(abs(drive.slide.force))` of study `lift` is 6476.44 N, at `joint.B.position` = -30 deg.
  `l32`, `l5` and `load` matter most: 1 % more `l32` makes it 0.968 % less, 1 % more `l5` makes it
    0.932 % more and 1 % more `load` makes it 0.748 % more.
  `l42` has no effect.
  parameter     value  relative                          derivative
  l32          160 mm   -0.9683  --------------------  -39195.9 N/m
  l5           950 mm    0.9324  +++++++++++++++++++     6356.4 N/m
";
    let text = terminal_summary(&run, &PLAIN);
    assert_all(
        &text,
        &[
            expected,
            "  l32       160 mm  200 mm    +25 %  at upper\n",
            "  l5 - l31 >= 200 mm                         200 mm  200 mm  active\n",
            "  1 of 40              88  max(abs(drive.slide.force)) 4591.2 N ",
            "  l32         160 mm        1 mm    5.42 %  +                         79.9 %\n",
            "  ISO 15552 80 x 25, stroke 160   FAILS   push, buckling: 6474 N is 215 % of the 3016 N",
        ],
    );
}
