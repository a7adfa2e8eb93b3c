//! Sweeps over designs: every method, any number of threads, and going on after any kind of end.

use std::fs;
use std::path::{Path, PathBuf};

use bellcrank_model::{Model, Progress, RunOptions, Silent, load};
use bellcrank_results::{Designs, Findings, StudyResult};

const LIFT: &str = include_str!("../../../../models/assist-manipulator/lift.toml");

/// A sweep with some designs that cannot be assembled: the rod is far too short for the largest lever.
const STUDIES: &str = r#"
[studies.few]
kind = "inverse-dynamics"
sweep = { joint = "B", from = "-30 deg", to = "30 deg", points = 9 }
drive = { joint = "slide", velocity = "20 mm/s" }

[studies.designs]
kind = "sweep"
of = "few"
responses = { peak = "max(abs(drive.slide.force))", stroke = "range(joint.slide.position)" }
vary = { l31 = 4, l32 = ["120 mm", "160 mm"], l5 = { from = "800 mm", to = "1 m", points = 5 } }
pareto = { peak = "min", stroke = "max" }

[studies.cube]
like = "designs"
method = "lhs"
samples = 30
vary = { l31 = {}, load = ["600 N", "700 N", "800 N"] }

[studies.net]
like = "cube"
method = "sobol"
samples = 300
seed = 7

[studies.tried]
like = "designs"
table = "tried.csv"

[studies.torn]
kind = "sweep"
of = "few"
vary = { l42 = ["100 mm", "200 mm"], l62 = ["200 mm", "0 mm"] }
responses = ["max(abs(joint.A.reaction.fx))", "1 m - l62"]
"#;

/// A folder of its own for each test.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(format!("designs-{name}"));
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).unwrap();
    folder
}

fn model_with(folder: &Path, text: &str, set: &[(&str, &str)]) -> Model {
    fs::write(folder.join("tried.csv"), "l5 [m],l31 [mm]\n0.9,650\n0.95,700\n").unwrap();
    fs::write(folder.join("m.toml"), text).unwrap();
    let set: Vec<(String, String)> = set.iter().map(|(name, value)| ((*name).into(), (*value).into())).collect();
    let loaded = load(&folder.join("m.toml"), &set);
    loaded.model.unwrap_or_else(|| panic!("{}", loaded.diagnostics.render(&loaded.sources, false)))
}

fn model(folder: &Path) -> Model {
    model_with(folder, &format!("{LIFT}{STUDIES}"), &[])
}

fn run(model: &Model, study: &str, out: &Path, options: RunOptions) -> StudyResult {
    let options = RunOptions { folder: Some(out.to_owned()), ..options };
    model.run_all(&[study.to_owned()], &options, &mut Silent).unwrap().studies.remove(0)
}

fn found(result: &StudyResult) -> &Designs {
    let Some(Findings::Designs(found)) = &result.findings else { panic!("{:?}", result.failure) };
    found
}

fn csv(out: &Path, study: &str) -> String {
    fs::read_to_string(out.join(study).join("designs.csv")).unwrap()
}

fn threads(threads: usize) -> RunOptions {
    RunOptions { threads, ..RunOptions::default() }
}

#[test]
fn every_method_gives_the_same_rows_on_any_number_of_threads() {
    let folder = folder("threads");
    let model = model(&folder);
    for (study, rows) in [("designs", 40), ("cube", 30), ("net", 300), ("tried", 2), ("torn", 4)] {
        let out = |threads: usize| folder.join(format!("{threads}"));
        for count in 1..=3 {
            let result = run(&model, study, &out(count), threads(count));
            assert!(result.failure.is_none(), "{study}: {:?}", result.failure);
            assert_eq!((found(&result).done, found(&result).threads), (rows, count));
            assert_eq!(csv(&out(count), study).lines().count() as u64, rows + 1);
            for file in ["designs.csv", "designs.parquet", "designs.state.json"] {
                let bytes = |count: usize| fs::read(out(count).join(study).join(file)).unwrap();
                assert_eq!(bytes(1), bytes(count), "{study} {file} on {count} threads");
            }
            assert!(!out(count).join(study).join("designs.lock").exists());
        }
    }
}

#[test]
fn a_grid_has_every_combination_of_round_numbers() {
    let folder = folder("grid");
    let result = run(&model(&folder), "designs", &folder, threads(1));
    let text = csv(&folder, "designs");
    let mut lines = text.lines();
    assert_eq!(lines.next(), Some("design,l31 [mm],l32 [mm],l5 [mm],peak [N],stroke [mm],reason"));
    assert!(lines.next().is_some_and(|line| line.starts_with("0,600,120,800,")));
    assert!(lines.next().is_some_and(|line| line.starts_with("1,600,120,850,")), "{text}");
    assert!(text.lines().last().is_some_and(|line| line.starts_with("39,800,160,1000,") && line.ends_with(',')));
    let found = found(&result);
    assert_eq!((found.method.as_str(), found.inputs, found.seed), ("grid", 3, None));
    assert_eq!((found.sample.rows(), found.statistics.len()), (40, 5));
    assert_eq!(found.files, ["designs.csv", "designs.parquet"]);
    // The statistics are those of the rows.
    let peaks: Vec<f64> = text.lines().skip(1).map(|line| line.split(',').nth(4).unwrap().parse().unwrap()).collect();
    let least = peaks.iter().copied().fold(f64::INFINITY, f64::min);
    let peak = &found.statistics[3];
    assert_eq!((peak.min.0, peaks[peak.min.1 as usize]), (least, least));
    // No design beats one of the front in both.
    let front = &found.pareto.as_ref().unwrap().front;
    let column = |name: &str| &front.column(name).unwrap().values;
    assert!(front.rows() > 1 && column("peak").windows(2).all(|two| two[0] < two[1]));
    assert!(column("stroke").windows(2).all(|two| two[0] < two[1]));
}

#[test]
fn the_lines_of_a_table_are_designs() {
    let folder = folder("table");
    run(&model(&folder), "tried", &folder, threads(1));
    let text = csv(&folder, "tried");
    let starts: Vec<&str> = text.lines().map(|line| &line[..line.len().min(17)]).collect();
    assert_eq!(starts[0], "design,l5 [mm],l3");
    assert!(starts[1].starts_with("0,900,650,") && starts[2].starts_with("1,950,700,"), "{text}");
}

#[test]
fn load_cases_come_in_equal_shares() {
    let folder = folder("shares");
    run(&model(&folder), "cube", &folder, threads(1));
    for load in ["600", "700", "800"] {
        let count = csv(&folder, "cube").lines().skip(1).filter(|line| line.split(',').nth(2) == Some(load)).count();
        assert_eq!(count, 10, "{load}");
    }
}

#[test]
fn designs_that_fail_are_rows_with_their_reason() {
    let folder = folder("fail");
    let text = format!("{LIFT}{STUDIES}").replace("[bodies.link5]", "[bodies.link5x]\n\n[bodies.link5]");
    let text = text.replace("[bodies.link5x]\n", "");
    // The upper arm follows a parameter of its own: the four-bar of arms closes for some lengths only.
    let text = text
        .replace("H = [\"l5\", 0] }", "H = [\"l5 + extra\", 0] }")
        .replace("l62 = \"200 mm\"", "l62 = \"200 mm\"\nextra = \"0 mm\"");
    let text = text.replace(
        "vary = { l31 = 4, l32 = [\"120 mm\", \"160 mm\"]",
        "vary = { extra = [\"0 mm\", \"-600 mm\", \"900 mm\"], l32 = [\"120 mm\", \"160 mm\"]",
    );
    let result = run(&model_with(&folder, &text, &[]), "designs", &folder, threads(2));
    assert!(result.failure.is_none(), "{:?}", result.failure);
    let found = found(&result);
    assert!(found.failed > 0 && found.failed < found.done && found.done == 30, "{} of {}", found.failed, found.done);
    assert_eq!(found.failures.iter().map(|kind| kind.count).sum::<u64>(), found.failed);
    let text = csv(&folder, "designs");
    let failed: Vec<&str> = text.lines().filter(|line| line.contains(",,,")).collect();
    assert_eq!(failed.len() as u64, found.failed);
    assert!(failed.iter().all(|line| line.split_once(",,,").is_some_and(|(_, reason)| reason.len() > 10)), "{text}");
    assert!(!text.contains("study `few`"), "{text}");
    // And a resumed run reads them back.
    let whole = fs::read(folder.join("designs/designs.parquet")).unwrap();
    unfinished(&folder.join("designs"), text.len() - 5);
    let again = run(
        &model_with(&folder, &fs::read_to_string(folder.join("m.toml")).unwrap(), &[]),
        "designs",
        &folder,
        threads(1),
    );
    assert_eq!(csv(&folder, "designs"), text);
    assert_eq!(fs::read(folder.join("designs/designs.parquet")).unwrap(), whole);
    assert_eq!(format!("{:?}", found.failures), format!("{:?}", self::found(&again).failures));
}

/// What a run leaves that was killed when so many bytes were on disk.
fn unfinished(folder: &Path, bytes: usize) {
    let state = folder.join("designs.state.json");
    let text = fs::read_to_string(&state).unwrap().replace("\"finished\": true", "\"finished\": false");
    fs::write(&state, text).unwrap();
    let _ = fs::remove_file(folder.join("designs.parquet"));
    let rows = fs::read(folder.join("designs.csv")).unwrap();
    fs::write(folder.join("designs.csv"), &rows[..bytes]).unwrap();
}

/// Everything that is told, without what differs from run to run.
fn told(result: &StudyResult) -> String {
    let mut found = found(result).clone();
    (found.resumed, found.threads) = (0, 0);
    format!("{found:?}")
}

#[test]
fn a_killed_run_goes_on_without_loss_or_repetition() {
    let folder = folder("killed");
    let model = model(&folder);
    let whole = run(&model, "net", &folder.join("whole"), threads(2));
    let kept = |file: &str| fs::read(folder.join("whole/net").join(file)).unwrap();
    let rows = kept("designs.csv");
    let head = rows.iter().position(|byte| *byte == b'\n').unwrap() + 1;
    let second = head + rows[head..].iter().position(|byte| *byte == b'\n').unwrap() + 1;
    let some = rows.len() / 3;
    for bytes in
        [0, 5, head - 1, head, head + 1, second - 1, second, some, some + 7, some + 20, rows.len() - 1, rows.len()]
    {
        let out = folder.join(format!("{bytes}"));
        run(&model, "net", &out, threads(1));
        unfinished(&out.join("net"), bytes);
        let result = run(&model, "net", &out, threads(2));
        for file in ["designs.csv", "designs.parquet", "designs.state.json"] {
            assert_eq!(fs::read(out.join("net").join(file)).unwrap(), kept(file), "{file} after {bytes} bytes");
        }
        assert_eq!(told(&result), told(&whole), "after {bytes} bytes");
        let lines = rows[..bytes].iter().filter(|byte| **byte == b'\n').count() as u64;
        assert_eq!(found(&result).resumed, lines.saturating_sub(1), "after {bytes} bytes");
    }
}

#[test]
fn what_a_power_cut_leaves_is_computed_again() {
    let folder = folder("power");
    let model = model(&folder);
    run(&model, "net", &folder, threads(1));
    let rows = csv(&folder, "net");
    unfinished(&folder.join("net"), rows.len() / 2);
    let mut torn = fs::read(folder.join("net/designs.csv")).unwrap();
    torn.extend([0; 4000]);
    torn.extend(b"\n299,1,2,3,4,\n");
    fs::write(folder.join("net/designs.csv"), torn).unwrap();
    run(&model, "net", &folder, threads(1));
    assert_eq!(csv(&folder, "net"), rows);
}

/// Stops after so many questions.
struct Impatient(std::cell::Cell<usize>);

impl Progress for Impatient {
    fn at(&mut self, _fraction: f64, _message: &str) {}

    fn cancelled(&self) -> bool {
        self.0.set(self.0.get().saturating_sub(1));
        self.0.get() == 0
    }
}

#[test]
fn a_stopped_run_keeps_its_rows_and_says_how_to_go_on() {
    let folder = folder("stopped");
    let model = model(&folder);
    let options = RunOptions { folder: Some(folder.clone()), threads: 2, ..RunOptions::default() };
    let mut impatient = Impatient(std::cell::Cell::new(100));
    let stopped = model.run_all(&["net".to_owned()], &options, &mut impatient).unwrap().studies.remove(0);
    let failure = stopped.failure.as_ref().unwrap();
    assert!(failure.message.contains("after 99 of 300 designs, which are kept"), "{failure:?}");
    assert!(failure.hints[0].contains("the same command goes on"), "{failure:?}");
    assert_eq!((csv(&folder, "net").lines().count(), found(&stopped).done), (100, 99));
    assert_eq!(found(&stopped).files, ["designs.csv"]);
    let result = run(&model, "net", &folder, threads(1));
    assert_eq!((found(&result).resumed, found(&result).done), (99, 300));
    let fresh = run(&model, "net", &folder.join("other"), threads(1));
    assert_eq!(told(&result), told(&fresh));
    // What is done is computed anew, not added to.
    let again = run(&model, "net", &folder, threads(1));
    assert_eq!((found(&again).resumed, found(&again).done), (0, 300));
    assert_eq!(csv(&folder, "net"), csv(&folder.join("other"), "net"));
}

#[test]
fn a_changed_model_is_refused_and_the_change_is_told() {
    let folder = folder("changed");
    let text = format!("{LIFT}{STUDIES}");
    let rows = {
        run(&model(&folder), "designs", &folder, threads(1));
        let half = csv(&folder, "designs").len() / 2;
        unfinished(&folder.join("designs"), half);
        csv(&folder, "designs")
    };
    let comment = format!("# nothing new\n{text}\n[studies.other]\nlike = \"lift\"\n");
    let changed = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        text.replacen(from, to, 1)
    };
    let cases = [
        (changed("value = \"950 mm\"", "value = \"960 mm\""), "parameter `l5` was 950 mm and is 960 mm"),
        (
            changed("m1  = \"19.84 kg\"", "m1 = \"20 kg\"\nm7 = 1"),
            "parameter `m1` was 19.84 kg and is 20 kg; parameter `m7` is new",
        ),
        (
            changed("l61 = \"l32\"", "l61 = \"l32 + 0 mm\""),
            "parameter `l61` was `l32` (160 mm) and is `l32 + 0 mm` (160 mm)",
        ),
        (
            changed("[bodies.link2]", "[bodies.link2]\nmass = \"1 kg\"\ninertia = \"1 kg*m^2\""),
            "`bodies.link2` changed",
        ),
        (changed("to = \"30 deg\", points = 9", "to = \"30 deg\", points = 10"), "`studies.few` changed"),
        (changed("peak = \"max(abs(", "peak = \"max(-(-abs("), "response `peak` was"),
        (changed("l31 = 4", "l31 = 5"), "the range of `l31` was 600 mm to 800 mm in 4 levels and is"),
        (changed("title =", "units = { force = \"kN\" }\ntitle ="), "the line of columns was"),
        (changed("gravity = [0, \"-9.81", "gravity = [0, \"-9.8"), "`gravity` changed"),
    ];
    for (text, told) in cases {
        let text = text.replace("max(-(-abs(drive.slide.force))", "max(-(-abs(drive.slide.force)))");
        let result = run(&model_with(&folder, &text, &[]), "designs", &folder, threads(1));
        let failure = result.failure.unwrap_or_else(|| panic!("{told}"));
        assert!(failure.message.contains(told), "{failure:?}");
        assert!(failure.hints.iter().any(|hint| hint.contains("--fresh") && hint.contains("--out")), "{failure:?}");
        assert!(result.findings.is_none());
        assert_eq!(csv(&folder, "designs"), rows, "the rows are kept");
    }
    let set = run(&model_with(&folder, &text, &[("load", "900 N")]), "designs", &folder, threads(1));
    assert!(set.failure.is_some_and(|failure| failure.message.contains("parameter `load` was 800 N and is 900 N")));
    // What does not matter to the rows does not hinder.
    let result = run(&model_with(&folder, &comment, &[]), "designs", &folder, threads(1));
    assert!(found(&result).resumed > 0 && result.failure.is_none(), "{:?}", result.failure);
}

#[test]
fn fresh_begins_anew() {
    let folder = folder("fresh");
    run(&model(&folder), "designs", &folder, threads(1));
    unfinished(&folder.join("designs"), 400);
    let model = model_with(&folder, &format!("{LIFT}{STUDIES}"), &[("load", "900 N")]);
    let result = run(&model, "designs", &folder, RunOptions { fresh: true, ..threads(1) });
    assert_eq!((found(&result).resumed, found(&result).done), (0, 40));
    // A sweep that was interrupted before its first row has nothing to lose.
    let head = csv(&folder, "designs").find('\n').unwrap() + 1;
    unfinished(&folder.join("designs"), head);
    let result = run(&self::model(&folder), "designs", &folder, threads(1));
    assert_eq!((result.failure.is_none(), found(&result).done), (true, 40));
}

#[test]
fn one_run_at_a_time_writes() {
    let folder = folder("lock");
    let model = model(&folder);
    fs::create_dir_all(folder.join("designs")).unwrap();
    let held = fs::File::create(folder.join("designs/designs.lock")).unwrap();
    held.lock().unwrap();
    let result = run(&model, "designs", &folder, threads(1));
    assert!(result.failure.is_some_and(|failure| failure.message.contains("is writing the designs")));
    drop(held);
    // What a killed run left hinders nobody.
    let result = run(&model, "designs", &folder, threads(1));
    assert!(result.failure.is_none(), "{:?}", result.failure);
    assert!(!folder.join("designs/designs.lock").exists());
}

#[test]
fn without_a_folder_all_is_in_memory() {
    let folder = folder("memory");
    let result = model(&folder).run("designs", &mut Silent).unwrap();
    assert_eq!((found(&result).done, found(&result).sample.rows()), (40, 40));
    assert!(found(&result).files.is_empty());
}
