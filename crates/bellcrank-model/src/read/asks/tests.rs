//! Good studies of all kinds, as they are read.

use bellcrank_doc::{Diagnostics, Distribution, Sources};

use crate::design::{Ask, Levels, Method, Question, Study, Task};
use crate::disk::read_source;
use crate::read::{Tables, read_files, read_model};
use crate::signals::Source;

const MACHINE: &str = r#"
bellcrank = 1
space = "planar"
gravity = [0, "-9.81 m/s^2"]
[parameters]
l1 = { value = "300 mm", min = "200 mm", max = "400 mm" }
l2 = "200 ± 0.5 mm"
l3 = "l1/2"
m1 = { value = "2 kg", sigma = "0.1 kg" }
[ground.points]
O = [0, 0]
[bodies.arm]
mass = "m1"
inertia = "0.1 kg*m^2"
points = { O = [0, 0], P = ["l1", "l2"], Q = ["l3", 0] }
[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"] }
[studies.run]
kind = "inverse-dynamics"
sweep = { joint = "hinge", from = "0 deg", to = "90 deg", points = 4 }
set = { m1 = "3 kg", l1 = "320 mm" }
"#;

/// The studies of the machine and `text`, with a table of designs beside it.
fn studies(name: &str, text: &str) -> Vec<Study> {
    let folder = std::env::temp_dir().join(format!("bellcrank-asks-{name}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("designs.csv"), "l2 [cm], l1 [mm]\n20.5, 250\n21, 260\n").expect("a table");
    let path = folder.join("model.toml");
    std::fs::write(&path, format!("{MACHINE}{text}")).expect("a model");
    let (mut sources, mut diagnostics) = (Sources::new(), Diagnostics::new());
    let main = read_source(&mut sources, &path, &mut diagnostics).expect("a file");
    let files = read_files(&mut sources, main, &path, Vec::new(), &mut diagnostics).expect("files");
    let read = read_model(files, &Tables::new(&mut sources), &mut diagnostics);
    std::fs::remove_dir_all(&folder).expect("a folder that goes away");
    assert!(diagnostics.is_empty(), "{}", diagnostics.render(&sources, false));
    read.expect("a model").studies
}

fn asked<'s>(studies: &'s [Study], name: &str) -> (&'s Study, &'s Ask) {
    let study = studies.iter().find(|study| study.name == name).expect("a study");
    match &study.task {
        Task::Ask(ask) => (study, ask),
        other => panic!("{name}: {other:?}"),
    }
}

#[test]
fn sensitivity() {
    let studies = studies(
        "sensitivity",
        "[studies.a]\nkind = \"sensitivity\"\nof = \"run\"\nresponse = \"max(abs(drive.hinge.force)) + 0 N*m\"\n\
         set = { l1 = \"310 mm\" }\n\
         [studies.b]\nlike = \"a\"\nparameters = [\"l3\"]\nresponse = \"range(point.arm.P.y)\"\npoints = 0\n",
    );
    let (study, ask) = asked(&studies, "a");
    let Question::Sensitivity(of) = &ask.question else { panic!("{ask:?}") };
    assert_eq!((ask.of.as_str(), of.parameters.as_slice(), of.points), ("run", &[0, 1, 3][..], 41));
    // What the study that is asked sets, and this one over it.
    let values = study.parameters.values();
    assert_eq!((values[0], values[2], values[3]), (0.31, 0.155, 3.0));
    let mut changed = study.changed.clone();
    changed.sort_unstable();
    assert_eq!(changed, [0, 3]);
    let (study, ask) = asked(&studies, "b");
    let Question::Sensitivity(of) = &ask.question else { panic!("{ask:?}") };
    assert_eq!((of.parameters.as_slice(), of.points, study.named.as_slice()), (&[2][..], 0, &[2][..]));
    // One list of signals for both.
    let signal = ask.signals[of.response.reductions[0].curve.signals()[0]];
    assert!(matches!(signal.source, Source::Point { body: 1, point: 1 }), "{signal:?}");
    assert_eq!(ask.signals.len(), 2);
}

#[test]
fn optimize() {
    let studies = studies(
        "optimize",
        "[studies.a]\nkind = \"optimize\"\nof = \"run\"\n\
         minimize = [{ response = \"max(drive.hinge.force)\", weight = 2 }, \"range(point.arm.P.y)\"]\n\
         variables = { l1 = { min = \"l2 + 50 mm\" }, m1 = {} }\n\
         subject_to = \"range(point.arm.P.y) < 200 mm\"\ntolerance = 1e-8\niterations = 50\n\
         [studies.b]\nlike = \"a\"\nmaximize = \"min(drive.hinge.force)\"\nvariables = [\"l1\"]\nstarts = 8\nseed = 7\n",
    );
    let (_, ask) = asked(&studies, "a");
    let Question::Optimize(of) = &ask.question else { panic!("{ask:?}") };
    assert_eq!((of.maximize, of.terms.len(), of.terms[0].weight, of.terms[1].weight), (false, 2, 2.0, 1.0));
    assert_eq!((of.variables.len(), of.variables[0].parameter, of.variables[1].parameter), (2, 0, 3));
    assert!(of.variables[0].min.is_some() && of.variables[0].max.is_none());
    assert_eq!((of.constraints.len(), of.starts, of.seed), (1, 1, 1));
    assert_eq!((of.tolerance, of.iterations), (Some(1e-8), Some(50)));
    let (_, ask) = asked(&studies, "b");
    let Question::Optimize(of) = &ask.question else { panic!("{ask:?}") };
    assert_eq!((of.maximize, of.terms.len(), of.variables.len(), of.starts, of.seed), (true, 1, 1, 8, 7));
    assert_eq!(of.constraints.len(), 1);
}

#[test]
fn sweep() {
    let studies = studies(
        "sweep",
        "[studies.grid]\nkind = \"sweep\"\nof = \"run\"\n\
         responses = { peak = \"max(drive.hinge.force)\", lift = \"range(point.arm.P.y)\" }\n\
         vary = { l1 = 5, l2 = [\"190 mm\", \"210 mm\"], m1 = { from = \"1 kg\", to = \"4 kg\", points = 3 } }\n\
         pareto = { lift = \"max\", peak = \"min\" }\n\
         [studies.points]\nlike = \"grid\"\nmethod = \"sobol\"\nsamples = 256\n\
         [studies.table]\nlike = \"points\"\ntable = \"designs.csv\"\n\
         [studies.plain]\nkind = \"sweep\"\nof = \"run\"\nresponses = [\"max(drive.hinge.force)\"]\nvary = [\"l1\"]\n",
    );
    let designs = |name| {
        let (_, ask) = asked(&studies, name);
        let Question::Designs(of) = &ask.question else { panic!("{ask:?}") };
        of
    };
    let grid = designs("grid");
    let names: Vec<&str> = grid.responses.iter().map(|one| one.name.as_str()).collect();
    assert_eq!(
        (names.as_slice(), grid.method, grid.pareto),
        (&["peak", "lift"][..], Method::Grid, Some([(1, false), (0, true)]))
    );
    let levels: Vec<usize> = grid.vary.iter().map(|one| count(&one.levels)).collect();
    assert_eq!((levels.as_slice(), grid.samples, grid.seed), (&[5, 2, 3][..], 0, 1));
    let points = designs("points");
    assert_eq!((points.method, points.samples, points.vary.len()), (Method::Sobol, 256, 3));
    let table = designs("table");
    let parameters: Vec<usize> = table.vary.iter().map(|one| one.parameter).collect();
    assert_eq!((table.method, parameters.as_slice(), table.samples), (Method::Table, &[1, 0][..], 0));
    assert_eq!(table.table.len(), 2);
    assert!((table.table[0][0] - 0.205).abs() < 1e-15 && table.table[1][1] == 0.26);
    let plain = designs("plain");
    assert_eq!((plain.responses[0].name.as_str(), count(&plain.vary[0].levels)), ("max(drive.hinge.force)", 11));
}

fn count(levels: &Levels) -> usize {
    match levels {
        Levels::Range { points, .. } => *points,
        Levels::List(values) => values.len(),
    }
}

#[test]
fn tolerance() {
    let studies = studies(
        "tolerance",
        "[studies.a]\nkind = \"tolerance\"\nof = \"run\"\nresponse = \"max(drive.hinge.force)\"\n\
         [studies.b]\nlike = \"a\"\ntolerances = { l1 = \"0.1 mm\", m1 = { tolerance = \"0.3 kg\" } }\n\
         limits = { max = \"40 N*m\" }\nsamples = 0\nsobol = true\ndistribution = \"uniform\"\n",
    );
    let (study, ask) = asked(&studies, "a");
    let Question::Tolerance(of) = &ask.question else { panic!("{ask:?}") };
    let parameters: Vec<usize> = of.scattered.iter().map(|one| one.parameter).collect();
    assert_eq!((parameters.as_slice(), of.samples, of.seed, of.sobol), (&[1, 3][..], 10_000, 1, false));
    let spread = |i: usize| of.scattered[i].spread(&study.parameters, study.parameters.values());
    assert_eq!((spread(0).half_width, spread(0).distribution), (Some(0.5e-3), Some(Distribution::Normal)));
    assert_eq!((spread(1).half_width, spread(1).sigma), (None, Some(0.1)));
    assert!(of.limits.iter().all(Option::is_none));
    let (study, ask) = asked(&studies, "b");
    let Question::Tolerance(of) = &ask.question else { panic!("{ask:?}") };
    let spread = |i: usize| of.scattered[i].spread(&study.parameters, study.parameters.values());
    assert_eq!((spread(0).half_width, spread(0).distribution), (Some(1e-4), Some(Distribution::Uniform)));
    assert_eq!((spread(1).half_width, spread(1).sigma), (Some(0.3), None));
    assert_eq!((of.limits[0].is_some(), of.limits[1].is_some(), of.samples, of.sobol), (false, true, 0, true));
}
