//! A Stewart platform on a time motion: geometry in closed form, forces made up but smooth.

use std::f64::consts::TAU;

use bellcrank_results::{
    Animation, Arrow, Column, Drawing, DrawnBody, DrawnJoint, Pose, Reaction, RunResult, SpaceKind, StudyResult, Table,
};

use super::{column, parameter, provenance, rate};

const ROWS: usize = 301;
const DURATION: f64 = 3.0;
const WEIGHT: f64 = 981.0;
type V3 = [f64; 3];
type Q4 = [f64; 4];

fn ring(radius: f64, half_gap: f64, offset: f64) -> Vec<V3> {
    (0..6)
        .map(|leg| {
            let pair = (leg / 2) as f64 * TAU / 3.0 + offset;
            let angle = pair + if leg % 2 == 0 { -half_gap } else { half_gap };
            [radius * angle.cos(), radius * angle.sin(), 0.0]
        })
        .collect()
}

fn anchors() -> (Vec<V3>, Vec<V3>) {
    let base = ring(0.6, 0.2, 0.0);
    let mut top = ring(0.35, 0.2, TAU / 6.0);
    // Each leg goes to the nearest point of the platform.
    top.rotate_right(1);
    (base, top)
}

fn turn(q: Q4, v: V3) -> V3 {
    let [w, x, y, z] = q;
    let t = [2.0 * (y * v[2] - z * v[1]), 2.0 * (z * v[0] - x * v[2]), 2.0 * (x * v[1] - y * v[0])];
    [
        v[0] + w * t[0] + y * t[2] - z * t[1],
        v[1] + w * t[1] + z * t[0] - x * t[2],
        v[2] + w * t[2] + x * t[1] - y * t[0],
    ]
}

/// The shortest turn that brings x onto `d`.
fn along(d: V3) -> Q4 {
    let q = [1.0 + d[0], 0.0, -d[2], d[1]];
    let n = q.iter().map(|a| a * a).sum::<f64>().sqrt();
    q.map(|a| a / n)
}

fn platform(t: f64) -> Pose {
    let phase = TAU * t / DURATION;
    let (tilt, heading) = (0.2 * phase.sin(), 0.35 * (2.0 * phase).sin());
    let ((sa, ca), (sb, cb)) = ((tilt / 2.0).sin_cos(), (heading / 2.0).sin_cos());
    let quaternion = [ca * cb, sa * cb, -sa * sb, ca * sb];
    Pose { position: [0.12 * phase.sin(), 0.08 * phase.cos(), 0.7 + 0.1 * phase.cos()], quaternion }
}

struct Leg {
    base: V3,
    direction: V3,
    length: f64,
}

fn legs(pose: &Pose) -> Vec<Leg> {
    let (base, top) = anchors();
    base.into_iter().zip(top).map(|(base, top)| leg(base, pose, top)).collect()
}

fn leg(base: V3, pose: &Pose, top: V3) -> Leg {
    let turned = turn(pose.quaternion, top);
    let d: Vec<f64> = (0..3).map(|k| pose.position[k] + turned[k] - base[k]).collect();
    let length = d.iter().map(|a| a * a).sum::<f64>().sqrt();
    Leg { base, direction: [d[0] / length, d[1] / length, d[2] / length], length }
}

fn poses(pose: &Pose) -> Vec<Pose> {
    let still = Pose { position: [0.0; 3], quaternion: [1.0, 0.0, 0.0, 0.0] };
    let of_leg = |leg: Leg| {
        let quaternion = along(leg.direction);
        let rod = leg.length - 0.35;
        let position = [0, 1, 2].map(|k| leg.base[k] + rod * leg.direction[k]);
        [Pose { position: leg.base, quaternion }, Pose { position, quaternion }]
    };
    [still, *pose].into_iter().chain(legs(pose).into_iter().flat_map(of_leg)).collect()
}

fn table(times: &[f64]) -> Table {
    let dt = vec![DURATION / (ROWS - 1) as f64; ROWS];
    let mut columns = vec![column("time", "s", times.to_vec())];
    for leg in 0..6 {
        let lengths: Vec<f64> = times.iter().map(|t| legs(&platform(*t))[leg].length).collect();
        let velocity = rate(&lengths, &dt);
        let acceleration = rate(&velocity, &dt);
        let force: Vec<f64> = acceleration.iter().map(|a| WEIGHT / 5.0 + 20.0 * a).collect();
        let power = force.iter().zip(&velocity).map(|(f, v)| f * v).collect();
        push_leg_forces(&mut columns, leg, times, &force);
        columns.push(column(format!("joint.slide{leg}.position"), "mm", lengths));
        columns.push(column(format!("joint.slide{leg}.velocity"), "mm/s", velocity));
        columns.push(column(format!("joint.slide{leg}.acceleration"), "mm/s^2", acceleration));
        columns.push(column(format!("drive.slide{leg}.force"), "N", force));
        columns.push(column(format!("drive.slide{leg}.power"), "W", power));
    }
    columns.push(column("check.closure", "m", vec![3e-14; times.len()]));
    columns.push(column("check.balance", "W", vec![3e-11; times.len()]));
    Table { columns }
}

fn push_leg_forces(columns: &mut Vec<Column>, leg: usize, times: &[f64], force: &[f64]) {
    for foot in ["foot", "head"] {
        for (k, name) in ["fx", "fy", "fz"].into_iter().enumerate() {
            let along = |(t, f): (&f64, &f64)| f * legs(&platform(*t))[leg].direction[k];
            let values = times.iter().zip(force).map(along).collect();
            columns.push(column(format!("joint.{foot}{leg}.reaction.{name}"), "N", values));
        }
        let size = force.iter().map(|f| f.abs()).collect();
        columns.push(column(format!("joint.{foot}{leg}.reaction.force"), "N", size));
    }
}

fn drawing() -> Drawing {
    let (base, top) = anchors();
    let hexagon = |points: &[V3], prefix: &str| -> Vec<(String, V3)> {
        points.iter().enumerate().map(|(leg, p)| (format!("{prefix}{leg}"), *p)).collect()
    };
    let edges: Vec<[usize; 2]> = (0..6).map(|k| [k, (k + 1) % 6]).collect();
    let named = |name: &str, points, lines, center| DrawnBody {
        name: name.to_owned(),
        points,
        lines,
        center,
        block: None,
        surface: None,
    };
    let mut bodies = vec![
        named("ground", hexagon(&base, "P"), edges.clone(), None),
        named("platform", hexagon(&top, "Q"), edges, Some([0.0; 3])),
    ];
    let mut joints = Vec::new();
    for leg in 0..6 {
        let (lower, upper) = (2 + 2 * leg, 3 + 2 * leg);
        let end = |name: &str, x: f64| (name.to_owned(), [x, 0.0, 0.0]);
        bodies.push(named(&format!("cylinder{leg}"), vec![end("foot", 0.0), end("mouth", 0.4)], vec![[0, 1]], None));
        bodies.push(named(&format!("rod{leg}"), vec![end("tail", 0.0), end("head", 0.35)], vec![[0, 1]], None));
        let joint = |name: &str, kind: &str, first, second, driven| DrawnJoint {
            name: format!("{name}{leg}"),
            kind: kind.to_owned(),
            first,
            second,
            axis: [1.0, 0.0, 0.0],
            driven,
        };
        joints.push(joint("foot", "universal", (0, base[leg]), (lower, [0.0; 3]), false));
        joints.push(joint("slide", "prismatic", (lower, [0.0; 3]), (upper, [0.0; 3]), true));
        joints.push(joint("head", "spherical", (1, top[leg]), (upper, [0.35, 0.0, 0.0]), false));
    }
    let arrows = vec![Arrow { name: "payload".to_owned(), body: 1, at: [0.0, 0.0, 0.0] }];
    Drawing { space: SpaceKind::Spatial, up: [0.0, 0.0, 1.0], bodies, joints, arrows }
}

fn reactions() -> Vec<Reaction> {
    let reaction = |leg: usize, name: &str, kind: &str| Reaction {
        joint: format!("{name}{leg}"),
        kind: kind.to_owned(),
        unique: ["fx", "fy", "fz"].map(|c| (c.to_owned(), true)).to_vec(),
    };
    (0..6).flat_map(|leg| [reaction(leg, "foot", "universal"), reaction(leg, "head", "spherical")]).collect()
}

/// A platform moved in time by six legs.
pub fn run() -> RunResult {
    let times: Vec<f64> = (0..ROWS).map(|i| DURATION * i as f64 / (ROWS - 1) as f64).collect();
    let study = StudyResult {
        name: "wave".to_owned(),
        kind: "inverse-dynamics".to_owned(),
        axis: vec!["time".to_owned()],
        table: table(&times),
        reactions: reactions(),
        animation: Some(Animation {
            rows: (0..ROWS).collect(),
            frames: times.iter().map(|t| poses(&platform(*t))).collect(),
            arrows: vec![vec![[0.0, 0.0, -WEIGHT]]; ROWS],
        }),
        effort: vec![("newton_iterations".to_owned(), 903.0)],
        seconds: 0.004,
        ..StudyResult::default()
    };
    RunResult {
        model: "stewart".to_owned(),
        title: "Stewart platform".to_owned(),
        provenance: provenance("models/stewart-platform/stewart.toml"),
        parameters: vec![parameter("mass", "100 kg", 100.0, "kg", None, "payload")],
        facts: vec![("Degrees of freedom".to_owned(), "6".to_owned())],
        drawing: drawing(),
        studies: vec![study],
        warnings: Vec::new(),
    }
}
