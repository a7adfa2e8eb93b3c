//! Studies that ask: sensitivities, optima, and the improved model.

use std::fs;
use std::process::Output;

use serde_json::Value;

use crate::sandbox::{LIFT, Sandbox, text};
use crate::snapshot;

/// A slider-crank of 50 and 200 mm, its guide 10 mm above the shaft.
const SLIDER_CRANK: &str = include_str!("../../../../models/slider-crank/slider-crank.toml");

fn code(output: &Output) -> Option<i32> {
    output.status.code()
}

fn data(output: &Output, pointer: &str) -> Value {
    let printed: Value = serde_json::from_slice(&output.stdout).unwrap();
    printed.pointer(pointer).cloned().unwrap_or_else(|| panic!("no {pointer} in {printed:#}"))
}

/// A folder with a model and more studies in it.
fn with(name: &str, file: &str, base: &str, studies: &str) -> Sandbox {
    let sandbox = Sandbox::new(name);
    sandbox.write(file, format!("{base}\n{studies}"));
    sandbox
}

#[test]
fn derivatives_and_an_optimum_of_the_lift() {
    let sandbox = Sandbox::with_lift("asks-lift");
    snapshot::check("asks-sensitivity", &sandbox, &["run", "lift.toml", "influence"]);
    snapshot::check("asks-optimize", &sandbox, &["run", "lift.toml", "shorter"]);
    assert!(sandbox.exists("results/lift/influence/summary.json"));
    assert!(sandbox.exists("results/lift/shorter/summary.json"));
}

#[test]
fn iterations_are_for_people() {
    let sandbox = Sandbox::with_lift("asks-iterations");
    let said = |more: &[&str]| text(&sandbox.run(&[&["run", "lift.toml", "shorter"], more].concat()).stderr);
    assert!(said(&[]).contains("objective [N]"), "into a pipe, too");
    assert_eq!(said(&["--quiet"]), "");
    assert_eq!(said(&["--json"]), "");
}

#[test]
fn the_improved_model_is_written() {
    let sandbox = Sandbox::with_lift("asks-write");
    snapshot::check("asks-write", &sandbox, &["run", "lift.toml", "shorter", "--write", "better.toml"]);
    let values = LIFT.replacen("\"732 mm\"", "\"600 mm\"", 1).replacen("\"160 mm\"", "\"200 mm\"", 1).replacen(
        "\"950 mm\"",
        "\"800 mm\"",
        1,
    );
    assert!(sandbox.read("better.toml") == values, "only three values change");
    assert!(!sandbox.files().iter().any(|file| file.contains(".bellcrank")), "an unfinished file is left");
    let again = sandbox.run(&["run", "better.toml", "lift", "--json"]);
    let peak = data(&again, "/studies/lift/signals/drive.slide.force/max/value").as_f64().unwrap();
    assert!((peak - 4423.5).abs() < 0.05, "{peak}");
}

#[test]
fn the_result_says_where_the_model_is() {
    let sandbox = Sandbox::with_lift("asks-written");
    let output = sandbox.run(&["run", "lift.toml", "--write", "better.toml", "--json"]);
    assert_eq!(code(&output), Some(0));
    assert_eq!(data(&output, "/studies/shorter/written"), "better.toml");
    assert!(sandbox.read("results/lift/report.html").contains("better.toml"));
}

#[test]
fn nothing_is_overwritten_unasked() {
    let sandbox = Sandbox::with_lift("asks-again");
    sandbox.write("better.toml", "mine");
    snapshot::check("asks-write-again", &sandbox, &["run", "lift.toml", "shorter", "--write", "better.toml"]);
    snapshot::check("asks-write-model", &sandbox, &["run", "lift.toml", "shorter", "--write", "./lift.toml"]);
    assert!(!sandbox.exists("results"), "refused before anything is computed");
    assert_eq!(sandbox.read("better.toml"), "mine");
    let forced = sandbox.run(&["run", "lift.toml", "shorter", "--write", "lift.toml", "--force", "--quiet"]);
    assert_eq!(code(&forced), Some(0), "{}", text(&forced.stderr));
    assert!(sandbox.read("lift.toml").contains("l31 = { value = \"600 mm\""));
}

#[test]
fn what_cannot_be_written_is_refused_before_it_is_computed() {
    let two = "[studies.again]\nlike = \"shorter\"\n";
    let sandbox = with("asks-refused", "lift.toml", LIFT, two);
    fs::create_dir(sandbox.folder.join("folder")).unwrap();
    snapshot::check("asks-write-two", &sandbox, &["run", "lift.toml", "--write", "b.toml"]);
    snapshot::check("asks-write-none", &sandbox, &["run", "lift.toml", "lift", "--write", "b.toml"]);
    snapshot::check("asks-write-folder", &sandbox, &["run", "lift.toml", "again", "--write", "folder"]);
    snapshot::check("asks-write-nowhere", &sandbox, &["run", "lift.toml", "again", "--write", "no/b.toml"]);
    assert_eq!(code(&sandbox.run(&["run", "lift.toml", "again", "--force"])), Some(2));
    assert!(!sandbox.exists("results"));
}

#[test]
fn a_model_stays_beside_the_files_that_it_names() {
    let sandbox = Sandbox::new("asks-parts");
    sandbox.write("lift.toml", LIFT);
    sandbox.write("cart.toml", CART);
    fs::create_dir(sandbox.folder.join("elsewhere")).unwrap();
    snapshot::check("asks-write-apart", &sandbox, &["run", "cart.toml", "--write", "elsewhere/cart.toml"]);
    let beside = sandbox.run(&["run", "cart.toml", "--write", "better.toml", "--json"]);
    assert_eq!(code(&beside), Some(0), "{}", text(&beside.stderr));
    assert_eq!(code(&sandbox.run(&["check", "better.toml"])), Some(0));
}

/// A lift on a cart: the parameter of the main file goes into the subsystem.
const CART: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[parameters]
arm = { value = "950 mm", min = "800 mm", max = "1 m" }
[subsystems.lift]
file = "lift.toml"
set = { l5 = "arm" }
[studies.lift]
kind = "inverse-dynamics"
sweep = { joint = "lift.B", from = "-30 deg", to = "30 deg", points = 61 }
drive = { joint = "lift.slide", velocity = "20 mm/s" }
[studies.shorter]
kind = "optimize"
of = "lift"
minimize = "max(abs(drive.lift.slide.force))"
variables = ["arm"]
"#;

#[test]
fn an_infeasible_problem_says_so() {
    let sandbox = with("asks-infeasible", "lift.toml", LIFT, INFEASIBLE);
    snapshot::check("asks-infeasible", &sandbox, &["run", "lift.toml", "short", "--write", "better.toml"]);
    assert!(!sandbox.exists("better.toml"));
    let quiet = sandbox.run(&["run", "lift.toml", "short", "--quiet"]);
    assert_eq!(code(&quiet), Some(3));
    assert!(text(&quiet.stderr).contains("least violation"));
}

const INFEASIBLE: &str = r#"
[studies.short]
kind = "optimize"
of = "lift"
minimize = "max(abs(drive.slide.force))"
variables = ["l31", "l32", "l5"]
subject_to = ["range(joint.slide.position) <= 20 mm", "max(abs(drive.slide.force)) <= 7 kN"]
"#;

#[test]
fn questions_that_cannot_be_meant() {
    let sandbox = with("asks-wrong", "lift.toml", LIFT, WRONG);
    snapshot::check("asks-wrong", &sandbox, &["run", "lift.toml"]);
    assert!(!sandbox.exists("results"));
}

const WRONG: &str = r#"
[studies.crossed]
kind = "optimize"
of = "lift"
minimize = "max(abs(drive.slide.force))"
variables = { l31 = { min = "900 mm" }, l5 = { min = "2 m", max = "1 m" } }

[studies.unknown]
kind = "optimize"
of = "lift"
minimize = "max(abs(drive.slid.force))"
variables = ["l33"]

[studies.other_words]
kind = "optimize"
of = "lift"
objective = "max(abs(drive.slide.force))"
parameters = ["l31"]
constraints = ["100 mm <= l31 <= 800 mm"]
"#;

#[test]
fn what_has_no_effect_is_told() {
    let sandbox = with("asks-flat", "lift.toml", LIFT, FLAT);
    snapshot::check("asks-flat", &sandbox, &["run", "lift.toml", "constant", "flat"]);
}

const FLAT: &str = r#"
[studies.constant]
kind = "optimize"
of = "lift"
minimize = "m1/m3"
variables = ["l31", "l5"]

[studies.flat]
kind = "sensitivity"
of = "lift"
response = "max(abs(drive.slide.force))"
parameters = ["l42", "l62", "m1"]
"#;

/// A rod shorter than 60 mm does not let the crank turn: the search steps back, and ends where
/// sin(angle) = (crank + offset)/rod says.
#[test]
fn designs_that_cannot_be_assembled_are_stepped_back_from() {
    let sandbox = with("asks-holes", "crank.toml", SLIDER_CRANK, HOLES);
    let output = sandbox.run(&["run", "crank.toml", "shortest", "--json", "--write", "better.toml"]);
    assert_eq!(code(&output), Some(0), "{}", text(&output.stderr));
    let rod = data(&output, "/studies/shortest/variables/rod/value").as_f64().unwrap();
    let expected = 60.0 / 75_f64.to_radians().sin();
    assert!((rod - expected).abs() < 1e-6, "{rod} against {expected}");
    assert!(data(&output, "/studies/shortest/failed_designs").as_u64().unwrap() > 0);
    let text = sandbox.read("better.toml");
    let line = text.lines().find(|line| line.starts_with("rod ")).unwrap();
    let value = line.split('"').nth(1).unwrap();
    assert!(value.ends_with(" mm") && value.len() <= "62.1165708254 mm".len(), "{line}");
}

#[test]
fn a_search_without_a_start() {
    let sandbox = with("asks-no-start", "crank.toml", SLIDER_CRANK, HOLES);
    snapshot::check("asks-no-start", &sandbox, &["run", "crank.toml", "nowhere", "--write", "better.toml"]);
    let several = sandbox.run(&["run", "crank.toml", "somewhere", "--json"]);
    assert_eq!(code(&several), Some(0));
    assert_eq!(data(&several, "/studies/somewhere/variables/rod/bound"), "upper");
    assert!(data(&several, "/studies/somewhere/starts").as_array().unwrap().len() >= 3);
}

/// The square root of a negative number on the way is a step too far, no end.
#[test]
fn numbers_that_are_none_are_stepped_back_from() {
    let sandbox = with("asks-roots", "crank.toml", SLIDER_CRANK, HOLES);
    let output = sandbox.run(&["run", "crank.toml", "root", "--json"]);
    assert_eq!(code(&output), Some(0), "{}", text(&output.stderr));
    let crank = data(&output, "/studies/root/variables/crank/value").as_f64().unwrap();
    // Dead centres: rod 200 mm and crank in line, 10 mm beside the guide.
    let reach = |length: f64| (length * length - 100.0).sqrt();
    let range = reach(200.0 + crank) - reach(200.0 - crank);
    assert!((range - 100.0).abs() < 1e-3, "{crank} gives {range}");
}

const HOLES: &str = r#"
[studies.shortest]
kind = "optimize"
of = "turn"
minimize = "rod"
variables = { rod = { min = "20 mm", max = "300 mm" } }
subject_to = "max(abs(body.rod.angle)) <= 75 deg"

[studies.nowhere]
kind = "optimize"
of = "turn"
set = { rod = "55 mm" }
minimize = "max(abs(drive.crank.force))"
variables = { rod = { min = "20 mm", max = "300 mm" } }

[studies.somewhere]
like = "nowhere"
starts = 4

[studies.root]                       # least where the stroke is 100 mm
kind = "optimize"
of = "turn"
set = { crank = "80 mm" }
minimize = "(sqrt(range(joint.slide.position)/(80 mm) - 1) - 0.5)^2"
variables = { crank = { min = "1 mm", max = "150 mm" } }
"#;
