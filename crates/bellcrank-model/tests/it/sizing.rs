//! Studies that choose a drive.

use std::f64::consts::PI;

use bellcrank_model::{Model, Silent};
use bellcrank_results::{Candidate, Findings, Property, Sizing, StudyResult};

use crate::support::{Scratch, lift, model, model_of, run, value};

fn found(result: &StudyResult) -> &Sizing {
    match &result.findings {
        Some(Findings::Sizing(found)) => found,
        other => panic!("{other:?}, {:?}", result.failure),
    }
}

fn of<'r>(properties: &'r [Property], key: &str) -> &'r Property {
    properties.iter().find(|one| one.key == key).unwrap_or_else(|| panic!("no `{key}` in {properties:?}"))
}

fn chosen(result: &StudyResult) -> &Candidate {
    let found = found(result);
    &found.candidates[found.chosen.expect("a drive that passes")]
}

fn near(found: f64, expected: f64, relative: f64) {
    assert!((found - expected).abs() <= relative * expected.abs(), "{found} is not {expected}");
}

fn lifts(name: &str, studies: &str) -> Model {
    let text = std::fs::read_to_string(lift()).expect("the lift");
    model(name, &format!("{text}\n{studies}"))
}

/// The paper's lift: 4844.5 N without masses, 6473.6 N with them, over 159.931 mm.
#[test]
fn cylinders_for_the_lift() {
    let model = lifts(
        "cylinders",
        "[studies.light]\nkind = \"sizing\"\nof = \"massless\"\nsupply = \"6 bar\"\n\
         [studies.light10]\nlike = \"light\"\nsupply = \"10 bar\"\n\
         [studies.heavy10]\nlike = \"light10\"\nof = \"lift\"\n\
         [studies.set]\nlike = \"light\"\nof = \"lift\"\nset = { m1 = 0, m3 = 0, m5 = 0 }\n",
    );
    let name = |study: &str| chosen(&run(&model, study)).name.clone();
    assert_eq!(name("cylinder"), "iso15552-160, stroke 160 mm");
    assert_eq!(name("light"), "iso15552-125, stroke 160 mm");
    assert_eq!(name("heavy10"), "iso15552-125, stroke 160 mm");
    assert_eq!(name("light10"), "iso15552-100, stroke 160 mm");
    // Its parameters are those of the study that is asked, and what it sets itself.
    let set = run(&model, "set");
    assert_eq!(chosen(&set).name, "iso15552-125, stroke 160 mm");
    near(of(&found(&set).requirements, "push").value, 4844.52, 2e-6);

    let result = run(&model, "cylinder");
    let needs = &found(&result).requirements;
    near(of(needs, "push").value, 6473.61, 2e-6);
    near(of(needs, "stroke").value, 0.159_931, 4e-6);
    near(of(needs, "extending_speed").value, 0.02, 1e-9);
    assert_eq!(of(needs, "pull").value, 0.0);
    // The curve of the proposed cylinder over the stroke.
    let names: Vec<&str> = result.table.columns.iter().map(|column| column.name.as_str()).collect();
    let expected = [
        "joint.slide.position",
        "drive.slide.force",
        "working pressure",
        "usable pressure",
        "supply pressure",
        "joint.slide.velocity",
        "drive.slide.power",
    ];
    assert_eq!(names, expected);
    assert_eq!((result.axis.as_slice(), result.table.rows()), (&["joint.slide.position".to_owned()][..], 601));
    let area = PI / 4.0 * 0.16_f64.powi(2);
    for row in [0, 300, 600] {
        near(value(&result, "working pressure", row) * area, value(&result, "drive.slide.force", row), 1e-12);
    }
    assert_eq!((value(&result, "usable pressure", 0), value(&result, "supply pressure", 7)), (0.7 * 6e5, 6e5));
    // 160/40 at 6 bar: both sides at 7.013 bar absolute, (A + A_ring) s p / p_ANR; two of them a minute.
    let free = (2.0 * area - PI / 4.0 * 0.04_f64.powi(2)) * 0.16 * 7.013;
    let told = &chosen(&result).properties;
    near(of(told, "air_per_double_stroke").value, free, 1e-12);
    near(of(told, "mean_air").value, free / 30.0, 1e-12);
    near(of(told, "peak_air").value, area * 0.02 * 7.013, 1e-9);
    assert!(result.failure.is_none() && result.warnings.is_empty(), "{:?}", result.warnings);
}

#[test]
fn where_none_passes_the_nearest_is_told() {
    let text = "[studies.weak]\nkind = \"sizing\"\nof = \"lift\"\nsupply = \"0.5 bar\"\n";
    let result = run(&lifts("none", text), "weak");
    let found = found(&result);
    assert_eq!((found.chosen, found.nearest, found.candidates.len()), (None, Some(0), 17));
    assert!(found.candidates.iter().all(|candidate| !candidate.passes));
    let nearest = &found.candidates[0];
    assert_eq!(nearest.name, "iso15552-320, stroke 160 mm");
    assert_eq!(nearest.checks[0].reason, "push 4021 N × 0.7 = 2815 N, needed 6474 N at 652.4 mm");
    // The report says that the goal was not reached.
    assert!(result.failure.is_none() && result.warnings.is_empty());
    near(value(&result, "working pressure", 0), 6473.61 / (PI / 4.0 * 0.32_f64.powi(2)), 2e-6);
}

/// A slide of 12 kg that pushes 500 N; no gravity.
const SLIDE: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]
[parameters]
push = "500 N"
[ground.points]
O = [0, 0]
[bodies.block]
mass = "12 kg"
inertia = 0
points = { O = [0, 0] }
[joints]
slide = { kind = "prismatic", connects = ["ground.O", "block.O"], axis = "x", start = "30 mm" }
[forces]
load = { kind = "force", on = "block.O", vector = ["-push", 0] }
[studies.out]
kind = "inverse-dynamics"
sweep = { joint = "slide", from = "30 mm", to = "130 mm", points = 11 }
drive = { joint = "slide", velocity = "80 mm/s" }
[studies.still]
kind = "statics"
hold = { slide = "70 mm" }
"#;

fn slide(name: &str, studies: &str) -> Model {
    model(name, &format!("{SLIDE}{studies}"))
}

/// A rod that comes out while the coordinate shrinks pulls against the load.
#[test]
fn a_cylinder_may_be_bolted_the_other_way_round() {
    let model = slide(
        "reversed",
        "[studies.a]\nkind = \"sizing\"\nof = \"out\"\nsupply = \"6 bar\"\nefficiency = 0.9\n\
         [studies.b]\nlike = \"a\"\nreversed = true\n",
    );
    let [pushed, pulled] = ["a", "b"].map(|study| run(&model, study));
    for (result, push, pull) in [(&pushed, 500.0, 0.0), (&pulled, 0.0, 500.0)] {
        let needs = &found(result).requirements;
        near(of(needs, "push").value, push, 1e-12);
        near(of(needs, "pull").value, pull, 1e-12);
        // The rows stay those of the machine.
        near(value(result, "drive.slide.force", 3), 500.0, 1e-12);
    }
    let reason = |result: &StudyResult, index: usize| chosen(result).checks[index].reason.clone();
    assert_eq!(reason(&pushed, 0), "push 1178 N × 0.7 × 0.9 = 742.2 N, needed 500 N at 30 mm");
    assert!(reason(&pulled, 1).ends_with("needed 500 N at 30 mm"), "{}", reason(&pulled, 1));
    let ring = PI / 4.0 * (0.05_f64.powi(2) - 0.02_f64.powi(2));
    assert_eq!(chosen(&pulled).name, "iso15552-50, stroke 100 mm");
    near(value(&pulled, "working pressure", 5), 500.0 / ring / 0.9, 1e-12);
}

/// Verification cases P1_iso6358 and P2_iso15552: what a valve gives, and what a cylinder can.
#[test]
fn the_valve_follows_iso_6358() {
    // 63 mm at 3 bar: choked flow of 420 L/min ANR falls to 387.14 from 7 to 4 bar absolute.
    let force = 3e5 * PI / 4.0 * 0.063_f64.powi(2);
    let model = slide(
        "valve",
        &format!(
            "[studies.a]\nkind = \"sizing\"\nof = \"out\"\nset = {{ push = \"{force} N\" }}\nsupply = \"6 bar\"\n\
             atmosphere = \"1 bar\"\nvalve = {{ sonic_conductance = \"1 L/(s*bar)\", critical_ratio = 0.3 }}\n\
             [studies.b]\nlike = \"a\"\n\
             valve = {{ sonic_conductance = \"1e-9 m^3/(s*Pa)\", critical_ratio = 0.3, subsonic_index = 0.5 }}\n"
        ),
    );
    let result = run(&model, "a");
    let candidate = chosen(&result);
    assert_eq!(candidate.name, "iso15552-63, stroke 100 mm");
    let check = candidate.checks.iter().find(|check| check.key == "valve").expect("a check of the valve");
    near(check.available * 6e4, 387.140_221_395_241_6, 1e-9);
    near(check.needed, 0.08 * PI / 4.0 * 0.063_f64.powi(2) * 4.0, 1e-9);
    assert!((of(&candidate.properties, "push").value - 1870.3).abs() < 0.05);
    assert!((of(&candidate.properties, "pull").value - 1681.8).abs() < 0.06);
    let weak = run(&model, "b");
    let check = &found(&weak).candidates[0].checks.iter().find(|check| check.key == "valve").expect("a check").passes;
    assert_ne!(*check, None);
}

#[test]
fn a_rest_is_a_study_too() {
    let model = slide(
        "rest",
        "[studies.a]\nkind = \"sizing\"\nof = \"still\"\nsupply = \"6 bar\"\n\
         [studies.b]\nlike = \"a\"\nactuator = \"electric\"\nstroke_reserve = \"20 mm\"\nsafety = 1.2\n",
    );
    let result = run(&model, "a");
    assert_eq!((result.table.rows(), chosen(&result).name.as_str()), (1, "iso15552-40, stroke 25 mm"));
    // What is inherited for a cylinder alone does not count.
    let result = run(&model, "b");
    assert_eq!(found(&result).kind, "electric-linear");
    assert_eq!(chosen(&result).name, "generic-linear-630N, stroke 100 mm");
    near(of(&chosen(&result).properties, "shaft_rms_force").value, 600.0, 1e-12);
    let expected = "these rows tell no time, so the root mean square is taken over the rows, and no mean power";
    assert_eq!(result.warnings, [expected]);
}

/// The catalogue of a user: entries beside the built-in ones, in their place, or alone.
#[test]
fn a_catalogue_of_ones_own() {
    let scratch = Scratch::new("catalogue");
    let mine = "[cylinders.own]\nstandard = \"Own\"\nbore = \"45 mm\"\nrod = \"16 mm\"\nstrokes = [\"110 mm\"]\n\
                cushion_energy = \"0.1 J\"\nmax_speed = \"0.5 m/s\"\n\
                [cylinders.iso15552-50]\nbore = \"50 mm\"\nrod = \"20 mm\"\nmax_stroke = \"1 m\"\n";
    scratch.write("mine.toml", mine);
    let size =
        "kind = \"sizing\"\nof = \"out\"\nsupply = \"6 bar\"\nset = { push = \"600 N\" }\ncatalogue = \"mine.toml\"\n";
    let studies = format!(
        "[studies.a]\n{size}[studies.b]\nlike = \"a\"\nbuiltin = false\nmoved_mass = \"12 kg\"\n\
         [studies.c]\nlike = \"a\"\nstandards = [\"ISO 6432\"]\nsupply = \"8 bar\"\n\
         [studies.d]\nlike = \"b\"\narrival_speed = \"0.2 m/s\"\nmoved_mass = \"12 kg\"\n"
    );
    let model = model_of(&scratch.write("model.toml", format!("{SLIDE}{studies}")));
    let names = |study: &str| -> Vec<String> {
        let result = run(&model, study);
        found(&result).candidates.iter().map(|candidate| candidate.name.clone()).collect()
    };
    assert_eq!((names("a").len(), names("a")[0].as_str()), (18, "own, stroke 110 mm"));
    assert_eq!(names("b"), ["own, stroke 110 mm", "iso15552-50, special stroke 100 mm"]);
    // Entries that name no standard stay.
    assert_eq!((names("c").len(), names("c")[0].as_str()), (7, "iso15552-50, special stroke 100 mm"));
    // 12 kg at 0.2 m/s bring 0.24 J.
    let result = run(&model, "d");
    assert_eq!(found(&result).chosen, Some(0));
    assert_eq!(chosen(&result).name, "iso15552-50, special stroke 100 mm");
    let refused = &found(&result).candidates[1];
    let cushion = refused.checks.iter().find(|check| check.key == "cushion").expect("a cushion");
    assert_eq!(
        (cushion.passes, cushion.reason.as_str()),
        (Some(false), "cushion 0.1 J, 12 kg at 200 mm/s bring 0.24 J")
    );
    near(cushion.needed, 0.24, 1e-12);
}

/// A crank that turns a slide: torque, speed and power at the crank; a motor for it.
#[test]
fn a_motor_for_a_crank() {
    let path = crate::support::root().join("models/slider-crank/slider-crank.toml");
    let text = std::fs::read_to_string(path).expect("the slider-crank");
    let study = text.lines().find_map(|line| line.strip_prefix("[studies.")).expect("a study");
    let study = study.split(']').next().expect("a name");
    let motor = format!("[studies.motor]\nkind = \"sizing\"\nof = \"{study}\"\nsafety = 1.25\n");
    let model = model("motor", &format!("{text}\n{motor}"));
    let [loads, result] = [study, "motor"].map(|name| run(&model, name));
    let found = found(&result);
    assert_eq!(found.kind, "electric-rotary");
    let name = format!("drive.{}.force", found.drive);
    let torque = &loads.table.column(&name).expect("a torque").values;
    let peak = torque.iter().fold(0.0_f64, |most, torque| most.max(torque.abs()));
    near(of(&found.requirements, "peak_torque").value, peak, 1e-12);
    // A whole turn at one speed: the simple mean of the squares, lines between rows.
    let square = |pair: &[f64]| (pair[0] * pair[0] + pair[0] * pair[1] + pair[1] * pair[1]) / 3.0;
    let mean = torque.windows(2).map(square).sum::<f64>() / (torque.len() - 1) as f64;
    near(of(&found.requirements, "rms_torque").value, mean.sqrt(), 1e-6);
    let first = &found.candidates[0];
    let rms = first.checks.iter().find(|check| check.key == "rms_effort").expect("a check");
    if let Some(index) = found.chosen {
        assert!(index == 0 && first.passes && rms.needed <= rms.available);
    }
    assert_eq!(result.axis, [format!("joint.{}.position", found.drive)]);
    assert_eq!(result.table.columns.len(), 4);
}

/// A joint of kind `distance` is a cylinder without bodies.
#[test]
fn a_distance_is_a_cylinder() {
    let text = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0]
C = ["0.3 m", "-0.4 m"]
[bodies.arm]
mass = "20 kg"
center = ["0.5 m", 0]
inertia = "1 kg*m^2"
points = { O = [0, 0], P = ["0.6 m", 0] }
[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"] }
jack = { kind = "distance", connects = ["ground.C", "arm.P"] }
[studies.raise]
kind = "statics"
sweep = { joint = "jack", from = "0.5 m", to = "0.6 m", points = 21 }
[studies.size]
kind = "sizing"
of = "raise"
supply = "6 bar"
"#;
    let result = run(&model("jack", text), "size");
    assert_eq!((found(&result).drive.as_str(), found(&result).kind.as_str()), ("jack", "pneumatic"));
    // Moments about the hinge at the first row, where the arm is level.
    let force = value(&result, "drive.jack.force", 0);
    near(force, 20.0 * 9.81 * 0.5 / (0.6 * 0.4 / 0.5), 1e-9);
    assert!(chosen(&result).passes);
}

#[test]
fn what_stops_the_loads_stops_the_choice() {
    let text = "[studies.far]\nlike = \"out\"\nhold = [\"slide\"]\n\
                [studies.size]\nkind = \"sizing\"\nof = \"far\"\ndrive = \"slide\"\nsupply = \"6 bar\"\n";
    let result = slide("far", text).run("size", &mut Silent).expect("a result");
    let failure = result.failure.expect("a failure");
    assert!(failure.message.starts_with("study `far`"), "{}", failure.message);
    assert!(result.findings.is_none());
}
