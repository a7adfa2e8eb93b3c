//! Studies of dynamics: what they find when all is well, and what they say when not.

use bellcrank_model::{Progress, Silent};
use bellcrank_results::{EventKind, StudyResult};

use crate::support::{model, run, value};

const PENDULUM: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0]
[bodies.arm]
mass = "2 kg"
center = ["0.5 m", 0]
inertia = "0.1 kg*m^2"
points = { O = [0, 0], P = ["1 m", 0] }
[bodies.hand]
mass = "1 kg"
inertia = "0.01 kg*m^2"
center = ["0.1 m", 0]
points = { O = [0, 0] }
[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"], start = "10 deg", start_velocity = "1 rad/s" }
wrist = { kind = "revolute", connects = ["arm.P", "hand.O"], start = "0 deg" }
"#;

const BALL: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[ground.points]
O = [0, 0]
[bodies.ball]
mass = "2 kg"
inertia = 0
points = { O = [0, 0] }
[joints]
slide = { kind = "prismatic", connects = ["ground.O", "ball.O"], axis = "y", start = "1 m" }
"#;

/// The study `a` of a machine.
fn study(name: &str, machine: &str, study: &str) -> StudyResult {
    run(&model(name, &format!("{machine}\n{study}")), "a")
}

fn done(result: StudyResult) -> StudyResult {
    assert!(result.failure.is_none(), "{:?}", result.failure);
    result
}

fn scalar(result: &StudyResult, name: &str) -> Option<f64> {
    result.scalars.iter().find(|(known, ..)| known == name).map(|(_, value, _)| *value)
}

fn last(result: &StudyResult, signal: &str) -> f64 {
    value(result, signal, result.table.rows() - 1)
}

#[test]
fn energy_drifts_less_with_a_smaller_tolerance() {
    let study = |tolerance| {
        let keys = format!("[studies.a]\nkind = \"dynamics\"\nduration = \"3 s\"\ntolerance = {tolerance}\n");
        done(study(&format!("drift-{tolerance}"), PENDULUM, &keys))
    };
    let (loose, tight) = (study("1e-5"), study("1e-9"));
    assert_eq!((loose.table.rows(), loose.axis.as_slice()), (501, ["time".to_owned()].as_slice()));
    let [a, b] = [&loose, &tight].map(|result| scalar(result, "energy.drift").expect("a conservative machine"));
    assert!(b < 1e-6 && a < 1e-2 && b < 1e-2 * a, "{a} {b}");
    assert!((value(&loose, "joint.hinge.velocity", 0) - 1.0).abs() < 1e-12);
    assert!(value(&loose, "joint.wrist.velocity", 0).abs() < 1e-12);
    for name in ["steps", "rejected", "evaluations", "projections", "newton_iterations", "implicit_steps"] {
        assert!(tight.effort.iter().any(|(known, _)| known == name), "{name}");
    }
}

#[test]
fn a_held_joint_makes_a_simple_pendulum() {
    let keys = "[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\nhold = [\"wrist\"]\ntolerance = 1e-9\n";
    let result = done(study("held", PENDULUM, keys));
    assert!(result.table.column("drive.wrist.force").is_some() && result.table.column("drive.hinge.force").is_none());
    // θ̈ = −M g r cos θ / J at any row.
    let (inertia, moment) = (0.1 + 2.0 * 0.25 + 0.01 + 1.1 * 1.1, 9.81 * (2.0 * 0.5 + 1.1));
    for row in [0, 100, 500] {
        let expected = -moment * value(&result, "joint.hinge.position", row).cos() / inertia;
        let found = value(&result, "joint.hinge.acceleration", row);
        assert!((found - expected).abs() < 1e-9 * expected.abs(), "{row}: {found} {expected}");
    }
}

#[test]
fn a_condition_ends_the_study_with_a_row_of_its_own() {
    let keys = "[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\noutput_step = \"0.1 s\"\n\
                stop_when = [\"joint.slide.position <= 200 mm\", \"joint.slide.velocity > 2 m/s\"]\n";
    let result = done(study("stop", BALL, keys));
    let end = (2.0 * 0.8 / 9.81_f64).sqrt();
    assert!((last(&result, "time") - end).abs() < 1e-6, "{}", last(&result, "time"));
    assert!((last(&result, "joint.slide.position") - 0.2).abs() < 1e-6);
    assert_eq!(result.table.rows(), 6);
    let events = result.events.expect("events");
    assert_eq!(events.list[0].kind, EventKind::Condition);
    let ended = events.ended.expect("an end");
    assert_eq!(ended.by, "joint.slide.position <= 200 mm");
    assert!((ended.time - end).abs() < 1e-6);
}

#[test]
fn a_condition_that_holds_at_the_start_must_become_true_anew() {
    let ball = BALL.replace("start = \"1 m\"", "start = 0, start_velocity = \"2 m/s\"");
    let keys = "[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\nstop_when = \"joint.slide.position <= 0 m\"\n";
    let result = done(study("anew", &ball, keys));
    assert!((last(&result, "time") - 4.0 / 9.81).abs() < 1e-6, "{}", last(&result, "time"));
    assert!(result.warnings.iter().any(|told| told.contains("holds at the start")), "{:?}", result.warnings);
}

#[test]
fn a_ball_bounces_and_comes_to_rest() {
    let floor = "[forces]\nfloor = { kind = \"stop\", joint = \"slide\", min = 0, restitution = 0.5 }\n";
    let keys = "[studies.a]\nkind = \"dynamics\"\nduration = \"2 s\"\n";
    let result = done(study("bounce", &format!("{BALL}{floor}"), keys));
    let events = result.events.as_ref().expect("events");
    let first = &events.list[0];
    let speed = (2.0 * 9.81_f64).sqrt();
    assert_eq!((first.kind, first.name.as_str(), first.side), (EventKind::Impact, "floor", "lower"));
    assert!((first.time - speed / 9.81).abs() < 1e-6);
    let numbers: Vec<f64> = first.numbers.iter().map(|(_, value, _)| *value).collect();
    assert!((numbers[0] - speed).abs() < 1e-5 && (numbers[1] - 2.0 * 1.5 * speed).abs() < 1e-4, "{numbers:?}");
    assert_eq!(events.list.last().map(|event| event.kind), Some(EventKind::Contact));
    assert!(last(&result, "joint.slide.position").abs() < 1e-9 && last(&result, "joint.slide.velocity").abs() < 1e-9);
    // Impacts take energy.
    assert!(scalar(&result, "energy.drift").is_none());
}

#[test]
fn friction_stops_and_holds_a_box() {
    let box_ = BALL.replace("axis = \"y\", start = \"1 m\"", "axis = \"x\", start_velocity = \"1 m/s\"");
    let rub = "[forces]\nrub = { kind = \"friction\", joint = \"slide\", coulomb = 0.2 }\n";
    let keys = "[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\n";
    let result = done(study("rub", &format!("{box_}{rub}"), keys));
    let stops = 1.0 / (0.2 * 9.81);
    let stick = &result.events.as_ref().expect("events").list[0];
    assert_eq!((stick.kind, stick.joint.as_str()), (EventKind::Stick, "slide"));
    assert!((stick.time - stops).abs() < 1e-6, "{}", stick.time);
    assert!((last(&result, "joint.slide.position") - 0.5 * stops).abs() < 1e-6);
}

/// The lift, driven from rest, forwards and backwards: the same study in two kinds.
#[test]
fn the_lift_takes_the_force_of_its_inverse_dynamics() {
    let lift = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let studies = "[motions.up]\njoint = \"slide\"\nsegments = [{ to = \"800 mm\", over = \"2 s\" }, { hold = \"0.5 s\" }]\n\
                   [studies.back]\nkind = \"inverse-dynamics\"\nduration = \"2.5 s\"\nstep = \"50 ms\"\n\
                   [studies.forth]\nkind = \"dynamics\"\nlike = \"back\"\n";
    let model = model("lift-forth", &format!("{lift}\n{studies}"));
    let (back, forth) = (done(run(&model, "back")), done(run(&model, "forth")));
    assert_eq!(back.table.rows(), forth.table.rows());
    let peak = (0..51).map(|row| value(&back, "drive.slide.force", row).abs()).fold(0.0, f64::max);
    for row in 0..51 {
        let [a, b] = [&back, &forth].map(|result| value(result, "drive.slide.force", row));
        assert!((a - b).abs() < 1e-6 * peak, "row {row}: {a} {b}");
        for signal in ["joint.B.position", "joint.E.reaction.fx", "drive.slide.power", "energy.total"] {
            let [a, b] = [&back, &forth].map(|result| value(result, signal, row));
            assert!((a - b).abs() < 1e-6 * peak, "row {row}, {signal}: {a} {b}");
        }
    }
    assert!(scalar(&forth, "energy.drift").is_none());
    // At rest, too.
    let worst = (0..51).map(|row| value(&forth, "check.balance", row)).fold(0.0, f64::max);
    assert!(worst < 1e-9, "{worst}");
}

/// Of two slider-cranks on one shaft one is driven, and one falls.
#[test]
fn driven_and_free_go_together() {
    let crank = bellcrank_model::starter("crank");
    let machine = crank.split("[studies").next().expect("a machine");
    let bob = "[bodies.bob]\nmass = \"1 kg\"\ninertia = 0\ncenter = [0, \"-0.3 m\"]\npoints = { O = [0, 0] }\n";
    let joint = "[joints.swing]\nkind = \"revolute\"\nconnects = [\"ground.O\", \"bob.O\"]\nstart = \"20 deg\"\n";
    let studies = "[motions.turn]\njoint = \"O\"\nvelocity = \"60 rpm\"\n[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\nmotions = [\"turn\"]\n";
    let result = done(study("both", &format!("{machine}\n{bob}{joint}"), studies));
    let turned = last(&result, "joint.O.position") - value(&result, "joint.O.position", 0);
    assert!((turned - std::f64::consts::TAU).abs() < 1e-9, "{turned}");
    let swing = last(&result, "joint.swing.position");
    let frequency = (9.81_f64 / 0.3).sqrt();
    assert!((swing - 20_f64.to_radians() * frequency.cos()).abs() < 0.05, "{swing}");
    assert!(last(&result, "check.closure") < 1e-9 && last(&result, "check.balance") < 1e-6);
}

#[test]
fn every_method_finds_the_same_motion() {
    let study = |name: &str, keys: &str| {
        let keys = format!("[studies.a]\nkind = \"dynamics\"\nduration = \"1 s\"\n{keys}");
        done(study(name, PENDULUM, &keys))
    };
    let truth = study("truth", "method = \"explicit\"\ntolerance = 1e-11\n");
    let end = |result: &StudyResult| last(result, "joint.wrist.position");
    let implicit = study("implicit", "method = \"generalized-alpha\"\ntolerance = 1e-8\n");
    assert!((end(&implicit) - end(&truth)).abs() < 1e-4, "{} {}", end(&implicit), end(&truth));
    let effort =
        |result: &StudyResult, wanted: &str| result.effort.iter().find(|(name, _)| name == wanted).map(|(_, n)| *n);
    assert!(effort(&implicit, "newton_iterations") > Some(0.0) && effort(&truth, "newton_iterations") == Some(0.0));
    // Order 2: half the step, a quarter of the error.
    let fixed = |step: &str| {
        let keys = format!("method = \"generalized-alpha\"\nspectral_radius = 0.6\nstep = \"{step}\"\n");
        (end(&study(&format!("fixed-{}", step.len()), &keys)) - end(&truth)).abs()
    };
    let (coarse, fine) = (fixed("2 ms"), fixed("1.0 ms"));
    assert!((3.5..4.5).contains(&(coarse / fine)), "{coarse} {fine}");
    let short = study("short", "method = \"explicit\"\nlargest_step = \"0.5 ms\"\n");
    assert!(effort(&short, "steps") >= Some(2000.0));
}

fn failure(name: &str, machine: &str, keys: &str) -> (String, StudyResult) {
    let result = study(name, machine, keys);
    let told = result.failure.as_ref().map(|failure| failure.message.clone()).expect("a failure");
    (told, result)
}

const FALL: &str = "[studies.a]\nkind = \"dynamics\"\nduration = \"3 s\"\noutput_step = \"10 ms\"\n";

#[test]
fn a_force_that_is_not_finite_is_named_with_its_time() {
    let root = "[forces]\nroot = { kind = \"effort\", joint = \"slide\", value = \"1 N*sqrt(2 - time/(1 s))\" }\n";
    let (told, result) = failure("root", &format!("{BALL}{root}"), FALL);
    assert!(told.contains("time = 2") && told.contains("force `root` is not finite"), "{told}");
    assert!((199..=201).contains(&result.table.rows()), "{}", result.table.rows());
    let pole = "[forces]\npole = { kind = \"effort\", joint = \"slide\", value = \"1 N*s/(2 s - time)\" }\n";
    let (told, result) = failure("pole", &format!("{BALL}{pole}"), FALL);
    assert!(told.contains("time = 2 s: force `pole` grows without bound"), "{told}");
    assert!((199..=201).contains(&result.table.rows()), "{}", result.table.rows());
}

#[test]
fn a_body_without_mass_that_nothing_holds_is_refused() {
    let tail = "[bodies.tail]\npoints = { O = [0, 0] }\n[joints.wag]\nkind = \"revolute\"\nconnects = [\"ball.O\", \"tail.O\"]\n";
    let (told, result) = failure("massless", &format!("{BALL}{tail}"), FALL);
    assert!(told.contains("no mass moves with `wag`"), "{told}");
    assert_eq!(result.table.rows(), 0);
}

#[test]
fn velocities_that_do_not_fit_are_told_with_those_that_do() {
    let crank = bellcrank_model::starter("crank");
    let machine = crank.split("[studies").next().expect("a machine");
    let machine = machine.replacen(
        "connects = [\"ground.O\", \"crank.O\"]",
        "connects = [\"ground.O\", \"crank.O\"], start_velocity = \"10 rad/s\"",
        1,
    );
    let at = machine.find("guide").expect("a guide");
    let (front, rest) = machine.split_at(at);
    let machine = format!(
        "{front}{}",
        rest.replacen("kind = \"prismatic\",", "kind = \"prismatic\", start_velocity = \"3 m/s\",", 1)
    );
    let (told, _) = failure("conflict", &machine, FALL);
    assert!(told.contains("velocities at the start do not fit") && told.contains("possible"), "{told}");
}

#[test]
fn a_motion_that_asks_the_impossible_keeps_its_rows() {
    let lift = std::fs::read_to_string(crate::support::lift()).expect("the lift");
    let keys = "[motions.out]\njoint = \"slide\"\nsegments = [{ to = \"2 m\", over = \"2 s\" }]\n";
    let (told, result) = failure("impossible", &lift, &format!("{keys}{FALL}"));
    assert!(told.contains("slide") || told.contains("time ="), "{told}");
    assert!(result.table.rows() > 20 && result.table.rows() < 290, "{}", result.table.rows());
}

struct StopAt(f64, bool);

impl Progress for StopAt {
    fn at(&mut self, fraction: f64, _message: &str) {
        self.1 = fraction >= self.0;
    }
    fn cancelled(&self) -> bool {
        self.1
    }
}

#[test]
fn a_cancelled_run_keeps_its_rows() {
    let model = model("cancelled", &format!("{PENDULUM}\n{FALL}"));
    let result = model.run("a", &mut StopAt(0.3, false)).expect("a run");
    assert!(result.failure.expect("a failure").message.contains("stopped on request"));
    assert!((80..120).contains(&result.table.rows()), "{}", result.table.rows());
}

/// Each design of a sweep is a run of its own, with the events and the end that it has.
#[test]
fn a_sweep_asks_a_study_of_dynamics() {
    let machine = BALL.replace("start = \"1 m\"", "start = \"top\"");
    let keys = "[parameters]\ntop = \"1 m\"\nk = 0\n\
                [forces]\nwind = { kind = \"effort\", joint = \"slide\", value = \"-(k*1 N*s/m)*joint.slide.velocity\" }\n\
                [studies.fall]\nkind = \"dynamics\"\nduration = \"3 s\"\nstop_when = \"joint.slide.position < 0 m\"\n\
                tolerance = 1e-9\nmethod = \"METHOD\"\n\
                [studies.a]\nkind = \"sweep\"\nof = \"fall\"\nvary = { top = [\"0.5 m\", \"2 m\", \"100 m\"], k = [0, 3] }\n\
                responses = { time = \"last(time)\", speed = \"min(joint.slide.velocity)\", way = \"at(joint.slide.position, 0.1 s)\" }\n";
    for method in ["explicit", "generalized-alpha"] {
        let result = done(study(&format!("sweep-{method}"), &machine, &keys.replace("METHOD", method)));
        let Some(bellcrank_results::Findings::Designs(found)) = &result.findings else { panic!("no designs") };
        let column = |name: &str| &found.sample.column(name).expect("a column").values;
        assert_eq!((found.total, found.failed), (6, 0));
        let exact = |height: f64, k: f64| {
            // v = −(m g/k) (1 − e^(−k t/m)), and its integral.
            let (m, g) = (2.0, 9.81);
            let way =
                |t: f64| if k == 0.0 { g * t * t / 2.0 } else { m * g / k * (t - m / k * (1.0 - (-k * t / m).exp())) };
            let (mut low, mut high) = (0.0, 3.0);
            for _ in 0..100 {
                let middle = 0.5 * (low + high);
                if way(middle) < height { low = middle } else { high = middle }
            }
            (low, height - way(0.1))
        };
        for design in 0..6 {
            let at = |name: &str| column(name)[design];
            let (time, way) = exact(at("top"), at("k"));
            assert!((at("time") - time).abs() < 1e-4, "{method} {design}: {} {time}", at("time"));
            assert!((at("way") - way).abs() < 1e-4, "{method} {design}: {} {way}", at("way"));
        }
    }
}

/// A size can be chosen for a drive of a machine in free motion.
#[test]
fn sizing_asks_a_study_of_dynamics() {
    let studies = "[motions.up]\njoint = \"hinge\"\nsegments = [{ to = \"90 deg\", over = \"2 s\" }]\n\
                   [studies.lift]\nkind = \"dynamics\"\nduration = \"2 s\"\n\
                   [studies.a]\nkind = \"sizing\"\nof = \"lift\"\n";
    let machine = PENDULUM.replace(", start_velocity = \"1 rad/s\"", "");
    let model = model("sized", &format!("{machine}\n{studies}"));
    let result = model.run("a", &mut Silent).expect("a run");
    assert!(done(result).findings.is_some());
}
