//! Contours from closed forms: a perforated strip under tension (Kirsch), a bar in its modes, a bracket with a
//! re-entrant edge.

use std::collections::HashMap;
use std::f64::consts::TAU;

use bellcrank_results::{
    Contour, ContourField, ContourMark, ContourShape, Drawing, RunResult, SpaceKind, StudyResult, Unit,
};

use super::provenance;

pub type Key = [i32; 3];

/// A surface of quadrilaterals between nodes of a lattice.
#[derive(Default)]
pub struct Shell {
    nodes: HashMap<Key, u32>,
    keys: Vec<Key>,
    triangles: Vec<[u32; 3]>,
    edges: Vec<[u32; 2]>,
}

impl Shell {
    fn node(&mut self, key: Key) -> u32 {
        let Self { nodes, keys, .. } = self;
        *nodes.entry(key).or_insert_with(|| {
            keys.push(key);
            keys.len() as u32 - 1
        })
    }

    /// Counter-clockwise as seen from outside.
    fn quad(&mut self, corners: [Key; 4]) {
        let [a, b, c, d] = corners.map(|key| self.node(key));
        self.triangles.extend([[a, b, c], [a, c, d]]);
        self.edges.extend([[a, b], [b, c], [c, d], [d, a]]);
    }

    /// The sides of the cells of a lattice that no other cell covers.
    pub fn of_cells(cells: &[Key]) -> Self {
        let mut shell = Self::default();
        let there: HashMap<Key, ()> = cells.iter().map(|cell| (*cell, ())).collect();
        for &[i, j, k] in cells {
            for axis in 0..3 {
                for side in [0, 1] {
                    let mut beyond = [i, j, k];
                    beyond[axis] += 2 * side - 1;
                    if !there.contains_key(&beyond) {
                        shell.quad(face([i, j, k], axis, side));
                    }
                }
            }
        }
        shell
    }

    pub fn contour(self, title: &str, place: impl Fn(Key) -> [f64; 3]) -> Contour {
        let nodes = self.keys.iter().map(|key| place(*key).map(|x| x as f32)).collect();
        let numbers = (1..=self.keys.len() as u32).collect();
        let (triangles, edges) = (self.triangles, self.edges);
        Contour { title: title.to_owned(), nodes, numbers, triangles, edges, ..Contour::default() }
    }
}

fn face(cell: Key, axis: usize, side: i32) -> [Key; 4] {
    let (u, v) = ((axis + 1) % 3, (axis + 2) % 3);
    let corner = |a: i32, b: i32| {
        let mut key = cell;
        key[axis] += side;
        key[u] += a;
        key[v] += b;
        key
    };
    let [a, b, c, d] = [corner(0, 0), corner(1, 0), corner(1, 1), corner(0, 1)];
    if side == 1 { [a, b, c, d] } else { [a, d, c, b] }
}

fn field(name: &str, unit: (&str, f64), values: Vec<f64>) -> ContourField {
    let values = values.into_iter().map(|v| v as f32).collect();
    ContourField { name: name.to_owned(), unit: Unit::new(unit.0, unit.1), values, ceiling: None }
}

const MPA: (&str, f64) = ("MPa", 1e6);
const MM: (&str, f64) = ("mm", 1e-3);

/// Half length, half width, half thickness, radius of the hole (m); tension (Pa), modulus (Pa), Poisson's ratio.
const STRIP: [f64; 4] = [0.1, 0.05, 0.006, 0.015];
const TENSION: f64 = 60e6;
const YOUNG: f64 = 210e9;
const POISSON: f64 = 0.3;

/// Radial, hoop and shear stress and the two displacements around a hole in a wide plate drawn along x; polar.
fn kirsch(r: f64, phi: f64) -> ([f64; 3], [f64; 2]) {
    let a = STRIP[3];
    let (q, c, s) = ((a / r).powi(2), (2.0 * phi).cos(), (2.0 * phi).sin());
    let half = TENSION / 2.0;
    let stress = [
        half * (1.0 - q + (1.0 - 4.0 * q + 3.0 * q * q) * c),
        half * (1.0 + q - (1.0 + 3.0 * q * q) * c),
        -half * (1.0 + 2.0 * q - 3.0 * q * q) * s,
    ];
    let kappa = (3.0 - POISSON) / (1.0 + POISSON);
    let per = TENSION * (1.0 + POISSON) / (2.0 * YOUNG);
    let outwards = r * ((kappa - 1.0) / 2.0 + c) + a * a / r * (1.0 + (1.0 + kappa) * c) - a.powi(4) / r.powi(3) * c;
    let around = ((1.0 - kappa) * a * a / r - r - a.powi(4) / r.powi(3)) * s;
    (stress, [per * outwards, per * around])
}

/// Cells around the hole, outwards and through the thickness.
pub fn strip(around: i32, outwards: i32, through: i32) -> Contour {
    let mut shell = Shell::default();
    for i in 0..around {
        let next = (i + 1) % around;
        for j in 0..outwards {
            shell.quad([[i, j, through], [i, j + 1, through], [next, j + 1, through], [next, j, through]]);
            shell.quad([[i, j, 0], [next, j, 0], [next, j + 1, 0], [i, j + 1, 0]]);
        }
        for k in 0..through {
            shell.quad([[i, 0, k], [i, 0, k + 1], [next, 0, k + 1], [next, 0, k]]);
            shell.quad([[i, outwards, k], [next, outwards, k], [next, outwards, k + 1], [i, outwards, k + 1]]);
        }
    }
    let place = |[i, j, k]: Key| {
        let rim = rim(f64::from(i) / f64::from(around));
        let reach = rim[0].hypot(rim[1]);
        let share = (f64::from(j) / f64::from(outwards)).powf(1.7);
        let r = STRIP[3] + share * (reach - STRIP[3]);
        [rim[0] / reach * r, rim[1] / reach * r, STRIP[2] * (2.0 * f64::from(k) / f64::from(through) - 1.0)]
    };
    let mut contour = shell.contour("strip: stress under 60 MPa tension", place);
    contour.shapes = vec![tension(&contour.nodes)];
    contour.marks = vec![
        mark("hole, side: 180.0 MPa ± 1.2 %", [0.0, STRIP[3], STRIP[2]], false),
        mark("hole, end: 60.0 MPa ± 3.0 %", [STRIP[3], 0.0, STRIP[2]], false),
    ];
    contour
}

/// A place on the rim of the strip, a share of its length from the middle of the right side.
fn rim(share: f64) -> [f64; 2] {
    let [w, h, ..] = STRIP;
    let at = (share * 4.0 * (w + h) + h) % (4.0 * (w + h));
    match at {
        s if s < 2.0 * h => [w, s - h],
        s if s < 2.0 * (h + w) => [w - (s - 2.0 * h), h],
        s if s < 4.0 * h + 2.0 * w => [-w, h - (s - 2.0 * (h + w))],
        s => [s - (4.0 * h + 2.0 * w) - w, -h],
    }
}

fn mark(label: &str, at: [f64; 3], doubtful: bool) -> ContourMark {
    ContourMark { label: label.to_owned(), at: at.map(|x| x as f32), doubtful }
}

fn tension(nodes: &[[f32; 3]]) -> ContourShape {
    let polar = |p: &[f32; 3]| (f64::from(p[0]).hypot(f64::from(p[1])), f64::from(p[1]).atan2(f64::from(p[0])));
    let solved: Vec<([f64; 3], [f64; 2], f64)> = nodes
        .iter()
        .map(|p| {
            let (r, phi) = polar(p);
            let (stress, u) = kirsch(r, phi);
            (stress, u, phi)
        })
        .collect();
    let displacement = solved.iter().zip(nodes).map(|((stress, [ur, ut], phi), p)| {
        let (s, c) = phi.sin_cos();
        let uz = -POISSON / YOUNG * (stress[0] + stress[1]) * f64::from(p[2]);
        [ur * c - ut * s, ur * s + ut * c, uz].map(|x| x as f32)
    });
    let displacement: Vec<[f32; 3]> = displacement.collect();
    let mises = |[a, b, t]: [f64; 3]| (a * a - a * b + b * b + 3.0 * t * t).sqrt();
    let radius = |[a, b, t]: [f64; 3]| ((a - b) / 2.0).hypot(t);
    let least = |s: [f64; 3]| (s[0] + s[1]) / 2.0 - radius(s);
    let moved = |u: &[f32; 3]| u.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt();
    let fields = vec![
        field("von Mises stress", MPA, solved.iter().map(|s| mises(s.0)).collect()),
        field("third principal stress", MPA, solved.iter().map(|s| least(s.0)).collect()),
        field("displacement", MM, displacement.iter().map(moved).collect()),
        field("error estimate", ("%", 0.01), solved.iter().map(|s| 2e-10 * mises(s.0)).collect()),
    ];
    ContourShape { name: String::new(), displacement, swings: false, fields }
}

/// Displacement by place.
type Moves = Box<dyn Fn([f64; 3]) -> [f64; 3]>;

/// A bar clamped at its left end, in six modes.
pub fn bar() -> Contour {
    const SIZE: [f64; 3] = [0.3, 0.04, 0.012];
    const CELLS: [i32; 3] = [60, 8, 3];
    let all = (0..CELLS[0]).flat_map(|i| (0..CELLS[1]).flat_map(move |j| (0..CELLS[2]).map(move |k| [i, j, k])));
    let shell = Shell::of_cells(&all.collect::<Vec<_>>());
    let place = |key: Key| {
        let at = |axis: usize| SIZE[axis] * f64::from(key[axis]) / f64::from(CELLS[axis]);
        [at(0), at(1) - SIZE[1] / 2.0, at(2) - SIZE[2] / 2.0]
    };
    let mut contour = shell.contour("bar: mode shapes, clamped at its left end", place);
    let shapes: [(&str, Moves); 6] = [
        ("mode 1, 109.6 Hz", Box::new(|p| bent(p, 0, 2, SIZE[0]))),
        ("mode 2, 362.2 Hz", Box::new(|p| bent(p, 0, 1, SIZE[0]))),
        ("mode 3, 686.4 Hz", Box::new(|p| bent(p, 1, 2, SIZE[0]))),
        ("mode 4, 1297 Hz", Box::new(|p| twisted(p, SIZE[0]))),
        ("mode 5, 1921 Hz", Box::new(|p| bent(p, 2, 2, SIZE[0]))),
        ("mode 6, 2150 Hz", Box::new(|p| bent(p, 1, 1, SIZE[0]))),
    ];
    contour.shapes = shapes.iter().map(|(name, moves)| swing(name, &contour.nodes, moves)).collect();
    contour
}

fn swing(name: &str, nodes: &[[f32; 3]], moves: impl Fn([f64; 3]) -> [f64; 3]) -> ContourShape {
    let moved: Vec<[f64; 3]> = nodes.iter().map(|p| moves(p.map(f64::from))).collect();
    let far = moved.iter().map(|u| u.iter().map(|x| x * x).sum::<f64>().sqrt()).collect();
    let displacement = moved.iter().map(|u| u.map(|x| x as f32)).collect();
    ContourShape { name: name.to_owned(), displacement, swings: true, fields: vec![field("displacement", MM, far)] }
}

/// A clamped beam bends across, its sections turn with it.
fn bent(p: [f64; 3], mode: usize, across: usize, length: f64) -> [f64; 3] {
    let (root, tie) = [(1.875_104, 0.734_096), (4.694_091, 1.018_467), (7.854_757, 0.999_224)][mode];
    let (b, x) = (root / length, root * p[0] / length);
    let w = x.cosh() - x.cos() - tie * (x.sinh() - x.sin());
    let slope = b * (x.sinh() + x.sin() - tie * (x.cosh() - x.cos()));
    let mut u = [-0.01 * p[across] * slope, 0.0, 0.0];
    u[across] = 0.01 * w;
    u
}

fn twisted(p: [f64; 3], length: f64) -> [f64; 3] {
    let angle = 0.4 * (TAU / 4.0 * p[0] / length).sin();
    [0.0, -angle * p[2], angle * p[1]]
}

/// A bracket whose inner edge is sharp: stress there has no largest value.
pub fn bracket() -> Contour {
    const CELL: f64 = 0.004;
    let all = (0..40).flat_map(|i| (0..40).flat_map(move |j| (0..5).map(move |k| [i, j, k])));
    let cells: Vec<Key> = all.filter(|[i, j, _]| !(*i >= 14 && *j >= 14)).collect();
    let shell = Shell::of_cells(&cells);
    let mut contour =
        shell.contour("bracket: stress at joint.B.position = -30 deg", |key| key.map(|k| CELL * f64::from(k)));
    let inner = 14.0 * CELL;
    let stress = |p: &[f32; 3]| {
        let [x, y, _] = p.map(f64::from);
        let r = (x - inner).hypot(y - inner).max(0.2e-3);
        let singular = 22e6 * (r / 0.02).powf(-0.455);
        let above = (y - inner).max(0.0) / 0.1;
        let bending =
            (1.0 - above) * ((x - 0.028) / 0.028).abs().min(1.0) * 60e6 * (1.0 - (inner - y).max(0.0) / inner);
        singular + if x < inner + 1e-6 { bending } else { 0.0 }
    };
    let moved = |p: &[f32; 3]| {
        let bend = 4e-4 * (p[1] / 0.16).powi(2);
        [-bend, 0.0, 0.05 * bend]
    };
    let displacement: Vec<[f32; 3]> = contour.nodes.iter().map(moved).collect();
    let mut mises = field("von Mises stress", MPA, contour.nodes.iter().map(stress).collect());
    mises.ceiling = Some(95e6);
    contour.shapes = vec![ContourShape { name: String::new(), displacement, swings: false, fields: vec![mises] }];
    contour.marks = vec![
        mark("foot of the arm: 63.9 MPa ± 2.1 %", [0.0, inner, 0.02], false),
        mark("inner edge: singular, no stress to trust", [inner, inner, 0.012], true),
        mark("back: 12.4 MPa ± 5 %", [0.08, 0.03, 0.0], false),
    ];
    contour
}

fn study(name: &str, kind: &str, contours: Vec<Contour>) -> StudyResult {
    StudyResult { name: name.to_owned(), kind: kind.to_owned(), contours, seconds: 1.2, ..StudyResult::default() }
}

/// Studies that leave nothing but pictures.
pub fn run() -> RunResult {
    RunResult {
        model: "parts".to_owned(),
        title: "Stress and modes of parts".to_owned(),
        provenance: provenance("models/parts.toml"),
        parameters: Vec::new(),
        facts: Vec::new(),
        drawing: Drawing {
            space: SpaceKind::Spatial,
            up: [0.0, 0.0, 1.0],
            bodies: Vec::new(),
            joints: Vec::new(),
            arrows: Vec::new(),
        },
        studies: vec![
            study("stress", "stress", vec![strip(120, 24, 4), bracket()]),
            study("swinging", "part-modes", vec![bar()]),
        ],
        warnings: Vec::new(),
    }
}
