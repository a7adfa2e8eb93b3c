//! A machine with one joint of each kind, in general positions, for tests.

use crate::{
    Animation, Column, Drawing, DrawnBody, DrawnJoint, Pose, Provenance, RunResult, SpaceKind, StudyResult, Table, Unit,
};

pub(crate) const FRAMES: usize = 9;
const KINDS: [&str; 10] = [
    "revolute",
    "prismatic",
    "cylindrical",
    "screw",
    "spherical",
    "universal",
    "point-on-line",
    "distance",
    "weld",
    "gear",
];

/// Body `k` hangs on body `k - 1` by a joint of the k-th kind.
pub(crate) fn drawing(space: SpaceKind) -> Drawing {
    let flat = space == SpaceKind::Planar;
    let points = |k: f64| {
        let z = if flat { 0.0 } else { 0.07 };
        vec![
            ("A".to_owned(), [0.0; 3]),
            ("B".to_owned(), [0.31 + 0.01 * k, 0.05, z]),
            ("C".to_owned(), [0.12, 0.17, -z]),
        ]
    };
    let body = |k: usize| DrawnBody {
        name: if k == 0 { "ground".to_owned() } else { format!("body{k}") },
        points: points(k as f64),
        lines: if k == 0 { Vec::new() } else { vec![[0, 1], [1, 2], [2, 0]] },
        center: None,
        block: None,
        surface: None,
    };
    let joint = |(k, kind): (usize, &&str)| DrawnJoint {
        name: format!("J{k}"),
        kind: (*kind).to_owned(),
        first: (k, points(k as f64)[1].1),
        second: (k + 1, [0.0; 3]),
        axis: if flat { [0.6, 0.8, 0.0] } else { [0.48, 0.6, 0.64] },
        driven: k % 2 == 0,
    };
    Drawing {
        space,
        up: if flat { [0.0, 1.0, 0.0] } else { [0.0, 0.0, 1.0] },
        bodies: (0..=KINDS.len()).map(body).collect(),
        joints: KINDS.iter().enumerate().map(joint).collect(),
        arrows: Vec::new(),
    }
}

/// Every body but the ground turns and moves; quaternions change their sign at will.
pub(crate) fn animation(bodies: usize) -> Animation {
    let pose = |frame: usize, body: usize| {
        let (t, b) = (frame as f64 / (FRAMES - 1) as f64, body as f64);
        let (sin, cos) = (0.4 * t * b).sin_cos();
        let sign = if (frame + body).is_multiple_of(3) { -1.0 } else { 1.0 };
        Pose {
            position: [0.3 * b + 0.02 * t, 0.04 * b * t, 0.01 * b],
            quaternion: [cos, 0.6 * sin, 0.0, 0.8 * sin].map(|x| sign * x),
        }
    };
    let still = Pose { position: [0.0; 3], quaternion: [1.0, 0.0, 0.0, 0.0] };
    let frame = |k: usize| [still].into_iter().chain((1..bodies).map(|body| pose(k, body))).collect();
    Animation { rows: (0..FRAMES).collect(), frames: (0..FRAMES).map(frame).collect(), arrows: Vec::new() }
}

pub(crate) fn run(space: SpaceKind, axis: &str) -> RunResult {
    let drawing = drawing(space);
    let values = (0..FRAMES).map(|k| 2.0 + 0.25 * k as f64).collect();
    let study = StudyResult {
        name: "swing".to_owned(),
        axis: vec![axis.to_owned()],
        table: Table { columns: vec![Column { name: axis.to_owned(), unit: Unit::new("", 1.0), values }] },
        animation: Some(animation(drawing.bodies.len())),
        ..StudyResult::default()
    };
    let text = String::new;
    RunResult {
        model: "sample".to_owned(),
        title: text(),
        provenance: Provenance { version: text(), file: text(), hash: text(), date: text() },
        parameters: Vec::new(),
        facts: Vec::new(),
        drawing,
        studies: vec![study],
        warnings: Vec::new(),
    }
}

/// A form of its own: the faces of a tetrahedron.
pub(crate) fn tetrahedron() -> crate::Surface {
    let points = vec![[0.01, -0.02, -0.05], [0.31, 0.03, -0.05], [0.11, 0.18, -0.05], [0.12, 0.07, 0.05]];
    crate::Surface { points, triangles: vec![[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]] }
}
