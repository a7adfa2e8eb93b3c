//! An elastic bar on a pin from closed forms: it swings under a drive, bends in its plane and twists.

use std::f64::consts::TAU;

use bellcrank_results::{
    Animation, Deformation, Drawing, DrawnBody, DrawnJoint, Fatigue, FlexibleBodies, FlexibleBody, FlexibleMotion,
    KeptMode, MeshRow, MotionMark, Pose, ReductionCheck, RunResult, SpaceKind, SpotHistory, StudyResult, Surface,
    Table, Unit,
};

use super::stress::{Key, Shell};
use super::{column, planar_pose, provenance};

/// Length, width, thickness, m.
const SIZE: [f64; 3] = [0.6, 0.04, 0.02];
const YOUNG: f64 = 210e9;
const SHEAR: f64 = 80e9;
pub const ROWS: usize = 121;
const DURATION: f64 = 2.0;

/// Angle of the bar, deflection of its tip across (m), twist at its tip (rad).
fn state(t: f64) -> (f64, [f64; 2]) {
    let angle = 0.4 * (TAU * t / DURATION).sin() + 0.2;
    (angle, [3e-3 * (TAU * t / DURATION + 0.7).sin() + 5e-4 * (5.0 * TAU * t).sin(), 8e-3 * (3.0 * t).cos()])
}

/// Displacement and stress by place.
type Solution = fn([f64; 3]) -> ([f64; 3], [f64; 6]);

/// A cantilever under a force at its tip, scaled to a deflection of one: displacement and stress.
fn bent([x, y, _]: [f64; 3]) -> ([f64; 3], [f64; 6]) {
    let l = SIZE[0];
    let (w, slope, curve) = (
        x * x * (3.0 * l - x) / (2.0 * l.powi(3)),
        3.0 * x * (2.0 * l - x) / (2.0 * l.powi(3)),
        3.0 * (l - x) / l.powi(3),
    );
    ([-y * slope, w, 0.0], [-YOUNG * y * curve, 0.0, 0.0, 0.0, 0.0, 0.0])
}

/// An even twist of one at the tip, as of a round bar.
fn twisted([x, y, z]: [f64; 3]) -> ([f64; 3], [f64; 6]) {
    let (turn, rate) = (x / SIZE[0], 1.0 / SIZE[0]);
    ([0.0, -turn * z, turn * y], [0.0, 0.0, 0.0, -SHEAR * rate * z, 0.0, SHEAR * rate * y])
}

/// The bar in `cells` along, across and through.
pub fn motion(cells: [i32; 3], name: &str) -> FlexibleMotion {
    let shell = Shell::of_cells(&all(cells));
    let place = |key: Key| {
        let at = |axis: usize| SIZE[axis] * f64::from(key[axis]) / f64::from(cells[axis]);
        [at(0), at(1) - SIZE[1] / 2.0, at(2) - SIZE[2] / 2.0]
    };
    let contour = shell.contour(name, place);
    let places: Vec<[f64; 3]> = contour.nodes.iter().map(|p| p.map(f64::from)).collect();
    let shapes: [Solution; 2] = [bent, twisted];
    let displacements = shapes.map(|of| places.iter().map(|p| of(*p).0.map(|x| x as f32)).collect()).to_vec();
    let stresses = shapes.map(|of| places.iter().map(|p| of(*p).1.map(|x| x as f32)).collect()).to_vec();
    let states: Vec<(f64, [f64; 2])> = times().iter().map(|t| state(*t)).collect();
    let mut made = FlexibleMotion {
        body: name.to_owned(),
        nodes: contour.nodes,
        numbers: contour.numbers,
        triangles: contour.triangles,
        edges: contour.edges,
        displacements,
        stresses,
        rows: (0..ROWS).collect(),
        coordinates: states.iter().map(|(_, d)| d.to_vec()).collect(),
        poses: states.iter().map(|(angle, _)| planar_pose(0.0, 0.0, *angle)).collect(),
        envelope: Vec::new(),
        worst: 0,
        ceiling: None,
        marks: Vec::new(),
        unit: Unit::new("MPa", 1e6),
        length: Unit::new("mm", 1e-3),
    };
    summed_up(&mut made);
    made
}

/// Envelope, worst row and marks of what is there.
fn summed_up(made: &mut FlexibleMotion) {
    let nodes = 0..made.nodes.len();
    let stress: Vec<Vec<f64>> =
        (0..ROWS).map(|at| nodes.clone().map(|node| made.von_mises(at, node)).collect()).collect();
    let peak = |row: &Vec<f64>| row.iter().copied().fold(0.0, f64::max);
    made.worst = (0..ROWS).max_by(|a, b| peak(&stress[*a]).total_cmp(&peak(&stress[*b]))).unwrap();
    made.envelope = nodes.clone().map(|node| stress.iter().map(|row| row[node]).fold(0.0, f64::max) as f32).collect();
    let worst = made.worst;
    let spot = |label: &str, from: f64, to: f64, doubtful: bool| {
        let inside = |node: &usize| (from..=to).contains(&f64::from(made.nodes[*node][0]));
        let node = nodes.clone().filter(inside).max_by(|a, b| stress[worst][*a].total_cmp(&stress[worst][*b])).unwrap();
        let history = stress.iter().map(|row| row[node]).collect();
        MotionMark { label: label.to_owned(), node: node as u32, history, doubtful }
    };
    made.marks =
        vec![spot("bore A", 0.0, 0.02, false), spot("elsewhere", 0.2, 0.4, false), spot("bore B", 0.55, 0.7, true)];
}

fn all(cells: [i32; 3]) -> Vec<Key> {
    (0..cells[0]).flat_map(|i| (0..cells[1]).flat_map(move |j| (0..cells[2]).map(move |k| [i, j, k]))).collect()
}

fn times() -> Vec<f64> {
    (0..ROWS).map(|k| DURATION * k as f64 / (ROWS - 1) as f64).collect()
}

fn drawing(motion: &FlexibleMotion) -> Drawing {
    let body = |name: &str, points: Vec<(String, [f64; 3])>, surface| DrawnBody {
        name: name.to_owned(),
        lines: if points.len() > 1 { vec![[0, 1]] } else { Vec::new() },
        points,
        center: None,
        block: None,
        surface,
    };
    let surface = Surface {
        points: motion.nodes.iter().map(|p| p.map(f64::from)).collect(),
        triangles: motion.triangles.clone(),
    };
    let point = |name: &str, x: f64| (name.to_owned(), [x, 0.0, 0.0]);
    Drawing {
        space: SpaceKind::Planar,
        up: [0.0, 1.0, 0.0],
        bodies: vec![
            body("ground", vec![point("A", 0.0)], None),
            body("bar", vec![point("A", 0.0), point("B", SIZE[0])], Some(surface)),
        ],
        joints: vec![DrawnJoint {
            name: "A".to_owned(),
            kind: "revolute".to_owned(),
            first: (0, [0.0; 3]),
            second: (1, [0.0; 3]),
            axis: [0.0, 0.0, 1.0],
            driven: true,
        }],
        arrows: Vec::new(),
    }
}

/// What the study says of the bar.
pub fn bodies(motion: &FlexibleMotion) -> FlexibleBodies {
    let spot = |mark: &MotionMark| {
        let peak = (0..ROWS).max_by(|a, b| mark.history[*a].total_cmp(&mark.history[*b])).unwrap();
        SpotHistory {
            region: mark.label.clone(),
            at: motion.nodes[mark.node as usize].map(f64::from),
            value: mark.history[peak],
            row: peak,
            place: format!("time = {:.3} s", times()[peak]),
            error: (!mark.doubtful).then_some(0.021 * mark.history[peak]),
            principal: [mark.history[peak], -0.1 * mark.history[peak]],
            margin: (!mark.doubtful).then_some(355e6 / mark.history[peak] - 1.0),
            singular: mark.doubtful.then_some("re-entrant edge"),
            signal: format!("body.bar.stress.{}", mark.label.replace(' ', ".")),
            fatigue: (!mark.doubtful).then_some(Fatigue {
                damage: 3.2e-7 * (mark.history[peak] / 126e6).powi(3),
                life: Some(3.1e6),
                amplitude: 0.7 * mark.history[peak],
                mean: 12e6,
                cycles: 5.5,
            }),
        }
    };
    let mode = |frequency: f64| KeptMode { frequency, damping: 0.01 };
    let check = |key: &str, meaning: &str, value: f64, limit: Option<f64>| ReductionCheck {
        key: key.to_owned(),
        meaning: meaning.to_owned(),
        value,
        limit,
    };
    FlexibleBodies {
        bodies: vec![FlexibleBody {
            body: "bar".to_owned(),
            solid: "bar".to_owned(),
            material: "S355".to_owned(),
            strength: Some(355e6),
            coupling: "rigid".to_owned(),
            interfaces: vec!["A".to_owned(), "B".to_owned()],
            coordinates: 2,
            modes: vec![mode(231.5), mode(638.1), mode(1_251.0)],
            stiffening: true,
            mesh: Some(MeshRow {
                nodes: motion.nodes.len(),
                elements: motion.nodes.len() / 3,
                element: "C3D15".to_owned(),
                worst_jacobian: 0.71,
                peak: f64::NAN,
                error: f64::NAN,
            }),
            mass: [3.768, 3.7681],
            checks: vec![
                check("rigid_inertia", "inertia as a rigid body against that of the mesh", 3.1e-13, Some(1e-10)),
                check("free_frequencies", "free frequencies against the whole mesh", 2.1e-3, Some(5e-3)),
            ],
            cached: true,
            peak: Some(0),
            spots: motion.marks.iter().map(spot).collect(),
            error: "The error is that of the last mesh.".to_owned(),
            deformation: Some(Deformation {
                displacement: 3.4e-3,
                share: 5.7e-3,
                turn: 8e-3,
                place: "time = 0.25 s".to_owned(),
                limit: 0.1,
            }),
        }],
        assumptions: vec![
            "Cycles are counted by rainflow on the von Mises stress with the sign of the larger principal one."
                .to_owned(),
        ],
        unit: Unit::new("MPa", 1e6),
        length: Unit::new("mm", 1e-3),
    }
}

/// A run whose one study moves the bar.
pub fn run_of(motion: FlexibleMotion) -> RunResult {
    let times = times();
    let angles: Vec<f64> = times.iter().map(|t| state(*t).0).collect();
    let mut columns = vec![column("time", "s", times.clone()), column("joint.A.position", "deg", angles)];
    for mark in &motion.marks {
        let name = format!("body.bar.stress.{}", mark.label.replace(' ', "."));
        columns.push(bellcrank_results::Column { name, unit: motion.unit.clone(), values: mark.history.clone() });
    }
    let still = planar_pose(0.0, 0.0, 0.0);
    let frames = motion.poses.iter().map(|pose: &Pose| vec![still, *pose]).collect();
    let drawing = drawing(&motion);
    let study = StudyResult {
        name: "swing".to_owned(),
        kind: "dynamics".to_owned(),
        axis: vec!["time".to_owned()],
        table: Table { columns },
        animation: Some(Animation { rows: (0..ROWS).collect(), frames, arrows: Vec::new() }),
        flexible: Some(bodies(&motion)),
        motions: vec![motion],
        seconds: 0.3,
        ..StudyResult::default()
    };
    RunResult {
        model: "bar".to_owned(),
        title: "A bar that bends".to_owned(),
        provenance: provenance("models/bar.toml"),
        parameters: Vec::new(),
        facts: Vec::new(),
        drawing,
        studies: vec![study],
        warnings: Vec::new(),
    }
}

/// A bar of some thousand nodes.
pub fn run() -> RunResult {
    run_of(motion([60, 8, 4], "bar"))
}
