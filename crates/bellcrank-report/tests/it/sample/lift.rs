//! The lift of the assist manipulator, in closed form, quasi-static (inertia adds 3 N in 6000).

use std::f64::consts::PI;

use bellcrank_results::{
    Animation, Arrow, Column, Drawing, DrawnBody, DrawnJoint, Failure, ParameterRow, Pose, Reaction, RunResult,
    SpaceKind, StudyResult, Table,
};

use super::{column, parameter, planar_pose, provenance, rate};

const ROWS: usize = 601;
const L31: f64 = 0.732;
const L32: f64 = 0.160;
const L5: f64 = 0.950;
const L61: f64 = L32;
const L62: f64 = 0.2;
const L42: f64 = 0.1;
const L1: f64 = L31;
const LOAD: f64 = 800.0;
const G: f64 = 9.81;

#[derive(Clone, Copy)]
struct Masses {
    m1: f64,
    m3: f64,
    m5: f64,
}

/// One position: everything the columns are made of.
struct Position {
    theta3: f64,
    theta1: f64,
    s2: f64,
    omega3: f64,
    drive: f64,
    points: Vec<(&'static str, [f64; 2])>,
    reactions: Vec<(&'static str, [f64; 3])>,
    poses: Vec<Pose>,
}

fn position(theta: f64, m: Masses) -> Position {
    let (s, c) = theta.sin_cos();
    let n = [L31 * c + L32 * s, L61 + L31 * s - L32 * c];
    let dn = [-L31 * s + L32 * c, L31 * c + L32 * s];
    let length = n[0].hypot(n[1]);
    let theta1 = n[1].atan2(n[0]);
    let u = [theta1.cos(), theta1.sin()];
    let slope = dn[0] * u[0] + dn[1] * u[1];
    let e = [L5 * c, L61 + L5 * s];
    let h = [e[0], e[1] + L62];
    let hx = L42 * LOAD / L62;
    let hy = hx * s / c + m.m5 * G / 2.0;
    let on_link4 = [hx, hy + LOAD];
    let across = m.m1 * G * (L1 / 2.0) * u[0] / length;
    let moment_e = L5 * (c * -on_link4[1] - s * -on_link4[0]);
    let moment_w = -m.m3 * G * (L5 / 2.0 - 0.05) * c;
    let arm = [n[0], n[1] - L61];
    let turned = [u[1] * across, -u[0] * across];
    let moment_t = arm[0] * turned[1] - arm[1] * turned[0];
    let drive = -(moment_e + moment_w + moment_t) / (arm[0] * u[1] - arm[1] * u[0]);
    let at_n = [drive * u[0] + turned[0], drive * u[1] + turned[1]];
    let b = [on_link4[0] - at_n[0], on_link4[1] + m.m3 * G - at_n[1]];
    Position {
        theta3: theta,
        theta1,
        s2: length - L1,
        omega3: 0.02 / slope,
        drive,
        points: vec![
            ("link3.B", [0.0, L61]),
            ("link3.N", n),
            ("link3.E", e),
            ("link4.H", h),
            ("link4.K", [e[0] + L42, h[1]]),
            ("link5.A", [0.0, L61 + L62]),
        ],
        reactions: vec![
            ("O", [at_n[0], at_n[1] + m.m1 * G, 0.0]),
            ("slide", [turned[0], turned[1], 0.0]),
            ("B", [b[0], b[1], 0.0]),
            ("A", [-hx, m.m5 * G - hy, 0.0]),
            ("E", [on_link4[0], on_link4[1], 0.0]),
            ("H", [-hx, -hy, 0.0]),
            ("N", [-at_n[0], -at_n[1], 0.0]),
        ],
        poses: vec![
            planar_pose(0.0, 0.0, 0.0),
            planar_pose(0.0, 0.0, theta1),
            planar_pose(n[0], n[1], theta1),
            planar_pose(0.0, L61, theta),
            planar_pose(e[0], e[1], 0.0),
            planar_pose(0.0, L61 + L62, theta),
        ],
    }
}

fn motion(columns: &mut Vec<Column>, name: &str, units: [&str; 3], values: Vec<f64>, dt: &[f64]) {
    let velocity = rate(&values, dt);
    let acceleration = rate(&velocity, dt);
    columns.push(column(format!("{name}.position"), units[0], values));
    columns.push(column(format!("{name}.velocity"), units[1], velocity));
    columns.push(column(format!("{name}.acceleration"), units[2], acceleration));
}

fn table(rows: &[Position]) -> Table {
    let take = |value: &dyn Fn(&Position) -> f64| rows.iter().map(value).collect::<Vec<f64>>();
    let step = PI / 180.0 * 0.1;
    let dt: Vec<f64> = rows.iter().map(|p| step / p.omega3).collect();
    let mut columns = Vec::new();
    let turning = ["deg", "deg/s", "deg/s^2"];
    let sliding = ["mm", "mm/s", "mm/s^2"];
    motion(&mut columns, "joint.B", turning, take(&|p| p.theta3), &dt);
    motion(&mut columns, "joint.O", turning, take(&|p| p.theta1), &dt);
    motion(&mut columns, "joint.slide", sliding, take(&|p| p.s2), &dt);
    motion(&mut columns, "joint.A", turning, take(&|p| p.theta3), &dt);
    motion(&mut columns, "joint.E", turning, take(&|p| -p.theta3), &dt);
    motion(&mut columns, "joint.H", turning, take(&|p| -p.theta3), &dt);
    motion(&mut columns, "joint.N", turning, take(&|p| p.theta1 - p.theta3), &dt);
    columns.push(column("drive.slide.force", "N", take(&|p| p.drive)));
    columns.push(column("drive.slide.power", "W", take(&|p| 0.02 * p.drive)));
    push_reactions(&mut columns, rows);
    push_points(&mut columns, rows, &dt);
    columns.push(column("check.closure", "m", (0..rows.len()).map(|i| 1e-16 * (1 + i % 3) as f64).collect()));
    columns.push(column("check.balance", "", (0..rows.len()).map(|i| 2e-15 * (i % 5) as f64).collect()));
    Table { columns }
}

fn push_reactions(columns: &mut Vec<Column>, rows: &[Position]) {
    for (index, (joint, _)) in rows[0].reactions.iter().enumerate() {
        let of = |k: usize| rows.iter().map(|p| p.reactions[index].1[k]).collect::<Vec<f64>>();
        let magnitude = rows.iter().map(|p| p.reactions[index].1[0].hypot(p.reactions[index].1[1])).collect();
        for (k, (name, symbol)) in [("fx", "N"), ("fy", "N"), ("mz", "N*m")].into_iter().enumerate() {
            columns.push(column(format!("joint.{joint}.reaction.{name}"), symbol, of(k)));
        }
        columns.push(column(format!("joint.{joint}.reaction.force"), "N", magnitude));
        columns.push(column(format!("joint.{joint}.reaction.moment"), "N*m", vec![0.0; rows.len()]));
    }
}

fn push_points(columns: &mut Vec<Column>, rows: &[Position], dt: &[f64]) {
    for (index, (point, _)) in rows[0].points.iter().enumerate() {
        for (k, letter) in ["x", "y"].into_iter().enumerate() {
            let values: Vec<f64> = rows.iter().map(|p| p.points[index].1[k]).collect();
            let velocity = rate(&values, dt);
            let acceleration = rate(&velocity, dt);
            columns.push(column(format!("point.{point}.{letter}"), "mm", values));
            columns.push(column(format!("point.{point}.v{letter}"), "mm/s", velocity));
            columns.push(column(format!("point.{point}.a{letter}"), "mm/s^2", acceleration));
        }
    }
}

fn rows(m: Masses, count: usize) -> Vec<Position> {
    (0..count).map(|i| position(PI / 180.0 * (-30.0 + 0.1 * i as f64), m)).collect()
}

fn study(name: &str, m: Masses, count: usize, changed: Vec<ParameterRow>) -> StudyResult {
    let rows = rows(m, count);
    let animation = Animation {
        rows: (0..count).collect(),
        frames: rows.iter().map(|p| p.poses.clone()).collect(),
        arrows: vec![vec![[0.0, -LOAD, 0.0]]; count],
    };
    StudyResult {
        name: name.to_owned(),
        kind: "inverse-dynamics".to_owned(),
        changed,
        axis: vec!["joint.B.position".to_owned()],
        table: table(&rows),
        reactions: reactions(),
        animation: Some(animation),
        effort: vec![("newton_iterations".to_owned(), 1203.0), ("factorizations".to_owned(), 601.0)],
        seconds: 0.000_612,
        ..StudyResult::default()
    }
}

fn reactions() -> Vec<Reaction> {
    let reaction = |(joint, kind): (&str, &str)| Reaction {
        joint: joint.to_owned(),
        kind: kind.to_owned(),
        unique: ["fx", "fy", "mz"].map(|c| (c.to_owned(), true)).to_vec(),
    };
    [
        ("O", "revolute"),
        ("slide", "prismatic"),
        ("B", "revolute"),
        ("A", "revolute"),
        ("E", "revolute"),
        ("H", "revolute"),
        ("N", "revolute"),
    ]
    .map(reaction)
    .to_vec()
}

fn body(name: &str, points: &[(&str, [f64; 2])], lines: &[[usize; 2]], center: Option<[f64; 3]>) -> DrawnBody {
    let point = |(name, [x, y]): &(&str, [f64; 2])| ((*name).to_owned(), [*x, *y, 0.0]);
    DrawnBody {
        name: name.to_owned(),
        points: points.iter().map(point).collect(),
        lines: lines.to_vec(),
        center,
        block: None,
        surface: None,
    }
}

fn joint(name: &str, kind: &str, first: (usize, [f64; 2]), second: (usize, [f64; 2]), driven: bool) -> DrawnJoint {
    let place = |(body, [x, y]): (usize, [f64; 2])| (body, [x, y, 0.0]);
    let axis = if kind == "prismatic" { [1.0, 0.0, 0.0] } else { [0.0, 0.0, 1.0] };
    DrawnJoint {
        name: name.to_owned(),
        kind: kind.to_owned(),
        first: place(first),
        second: place(second),
        axis,
        driven,
    }
}

fn drawing() -> Drawing {
    let a = L61 + L62;
    Drawing {
        space: SpaceKind::Planar,
        up: [0.0, 1.0, 0.0],
        bodies: vec![
            body("ground", &[("O", [0.0, 0.0]), ("B", [0.0, L61]), ("A", [0.0, a])], &[], None),
            body("link1", &[("O", [0.0, 0.0])], &[], Some([L1 / 2.0, 0.0, 0.0])),
            body("link2", &[("N", [0.0, 0.0])], &[], None),
            body(
                "link3",
                &[("B", [0.0, 0.0]), ("N", [L31, -L32]), ("E", [L5, 0.0])],
                &[[0, 1], [1, 2], [2, 0]],
                Some([L5 / 2.0 - 0.05, 0.0, 0.0]),
            ),
            body("link4", &[("E", [0.0, 0.0]), ("H", [0.0, L62]), ("K", [L42, L62])], &[[0, 1], [1, 2], [2, 0]], None),
            body("link5", &[("A", [0.0, 0.0]), ("H", [L5, 0.0])], &[[0, 1]], Some([L5 / 2.0, 0.0, 0.0])),
        ],
        joints: vec![
            joint("O", "revolute", (0, [0.0, 0.0]), (1, [0.0, 0.0]), false),
            joint("slide", "prismatic", (1, [0.0, 0.0]), (2, [0.0, 0.0]), true),
            joint("B", "revolute", (0, [0.0, L61]), (3, [0.0, 0.0]), false),
            joint("A", "revolute", (0, [0.0, a]), (5, [0.0, 0.0]), false),
            joint("E", "revolute", (3, [L5, 0.0]), (4, [0.0, 0.0]), false),
            joint("H", "revolute", (5, [L5, 0.0]), (4, [0.0, L62]), false),
            joint("N", "revolute", (3, [L31, -L32]), (2, [0.0, 0.0]), false),
        ],
        arrows: vec![Arrow { name: "load".to_owned(), body: 4, at: [L42, L62, 0.0] }],
    }
}

fn parameters() -> Vec<ParameterRow> {
    vec![
        parameter("l31", "732 mm", L31, "mm", Some((0.6, 0.8)), "lever: B to the foot of the cylinder pin"),
        parameter("l32", "160 mm", L32, "mm", Some((0.1, 0.2)), "lever: cylinder pin below the arm"),
        parameter("l5", "950 mm", L5, "mm", Some((0.8, 1.0)), "arm length"),
        parameter("l61", "l32", L61, "mm", None, ""),
        parameter("l62", "200 mm", L62, "mm", None, ""),
        parameter("l42", "100 mm", L42, "mm", None, ""),
        parameter("l1", "l31", L1, "mm", None, ""),
        parameter("m1", "19.84 kg", 19.84, "kg", None, ""),
        parameter("m3", "20.8 kg", 20.8, "kg", None, ""),
        parameter("m5", "19.4 kg", 19.4, "kg", None, ""),
        parameter("load", "800 N", LOAD, "N", None, ""),
    ]
}

fn facts() -> Vec<(String, String)> {
    [
        ("Bodies", "5 and the ground: link1, link2, link3, link4, link5"),
        ("Joints", "6 revolute, 1 prismatic"),
        ("Degrees of freedom", "1 (count 1, rank 1)"),
        ("Loops", "2, closed at N and H"),
        ("Redundant equations", "none"),
    ]
    .map(|(label, text)| (label.to_owned(), text.to_owned()))
    .to_vec()
}

/// The lift and the same without masses: 2 × 601 rows.
pub fn run() -> RunResult {
    let none = Masses { m1: 0.0, m3: 0.0, m5: 0.0 };
    let zero = |name: &str| parameter(name, "0 kg", 0.0, "kg", None, "");
    RunResult {
        model: "lift".to_owned(),
        title: "Assist manipulator: parallel six-bar lift".to_owned(),
        provenance: provenance("models/assist-manipulator/lift.toml"),
        parameters: parameters(),
        facts: facts(),
        drawing: drawing(),
        studies: vec![
            study("lift", Masses { m1: 19.84, m3: 20.8, m5: 19.4 }, ROWS, Vec::new()),
            study("massless", none, ROWS, vec![zero("m1"), zero("m3"), zero("m5")]),
        ],
        warnings: Vec::new(),
    }
}

/// The lift stopped early, over-constrained, with rows where a signal is not defined.
pub fn troubled() -> RunResult {
    let mut run = run();
    run.studies.truncate(1);
    run.warnings.push("body `link2` has no mass: its weight and inertia are left out".to_owned());
    let mut study = study("lift <fast>", Masses { m1: 19.84, m3: 20.8, m5: 19.4 }, 220, Vec::new());
    study.warnings.push("joint `A`: friction reverses at -12.3 deg & holds".to_owned());
    study.failure = Some(Failure {
        message: "at `joint.B.position` = -8.1 deg the mechanism is singular: joints `O`, `slide`, `N`".to_owned(),
        hints: vec![
            "end the sweep at -8 deg".to_owned(),
            "drive `B` instead of `slide`, which cannot push across its line".to_owned(),
        ],
    });
    study.reactions[3].unique[0].1 = false;
    for column in &mut study.table.columns {
        let spoiled = column.name.ends_with("acceleration") || column.name == "check.balance";
        if spoiled {
            column.values[100..130].fill(f64::NAN);
        }
        if column.name == "check.closure" {
            column.values[150] = 1e-4;
        }
    }
    run.studies.insert(0, study);
    run
}
