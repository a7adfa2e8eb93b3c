//! Craig–Bampton reduction by published numbers and identities.

#![expect(clippy::needless_range_loop, reason = "indices are how the formulas are written down")]

use bellcrank_fem::reduce::{self, natural_frequencies};
use bellcrank_fem::{
    Coupling, CouplingKind, Fault, Free, Interface, Keep, Load, Material, Modes, Part, Reduction, Region, Settings,
    Statics, Stress, Support,
};
use bellcrank_mesh::{Face, Mesh, Shape};

use crate::grids;

fn close(found: &[f64], expected: &[f64], bound: f64, what: &str) {
    assert!(found.len() >= expected.len(), "{what}: {found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < bound, "{what}: {found} {expected}");
    }
}

/// Stiffness and consistent mass of `count` equal Hermite beam elements; unknowns w, θ of each node.
fn hermite(ei: f64, mass: f64, length: f64, count: usize) -> (Vec<f64>, Vec<f64>) {
    let (h, size) = (length / count as f64, 2 * (count + 1));
    let k = [
        [12.0, 6.0 * h, -12.0, 6.0 * h],
        [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
        [-12.0, -6.0 * h, 12.0, -6.0 * h],
        [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
    ];
    let m = [
        [156.0, 22.0 * h, 54.0, -13.0 * h],
        [22.0 * h, 4.0 * h * h, 13.0 * h, -3.0 * h * h],
        [54.0, 13.0 * h, 156.0, -22.0 * h],
        [-13.0 * h, -3.0 * h * h, -22.0 * h, 4.0 * h * h],
    ];
    let (mut stiffness, mut masses) = (vec![0.0; size * size], vec![0.0; size * size]);
    for element in 0..count {
        for i in 0..4 {
            for j in 0..4 {
                let at = (2 * element + i) * size + 2 * element + j;
                stiffness[at] += ei / h.powi(3) * k[i][j];
                masses[at] += mass * h / 420.0 * m[i][j];
            }
        }
    }
    (stiffness, masses)
}

/// Without the rows and columns of the first two unknowns: the first end clamped.
fn clamped(matrix: &[f64]) -> Vec<f64> {
    let size = matrix.len().isqrt();
    let rows = matrix.chunks_exact(size).skip(2);
    rows.flat_map(|row| row[2..].to_vec()).collect()
}

/// Case F9: a beam of ten Hermite elements, reduced to its ends and 2, 4, 6 modes.
#[test]
fn f9_beam_of_ten_elements() {
    let (b, h): (f64, f64) = (0.05, 0.01);
    let (k, m) = hermite(2.1e11 * b * h.powi(3) / 12.0, 7850.0 * b * h, 1.0, 10);
    let fixed = [
        53.167_854_452_800_73,
        146.592_369_874_049_7,
        287.588_316_257_772_3,
        476.183_153_714_260_1,
        713.521_660_670_107_5,
        1_001.515_430_678_865_9,
    ];
    let free: [&[f64]; 3] = [
        &[53.357_979_020_513_28, 147.218_263_245_427_95, 484.165_831_092_948, 871.836_956_174_084_2],
        &[53.188_757_409_159_01, 146.713_045_144_193_13, 288.718_366_445_838_6, 477.665_807_635_853_3],
        &[53.171_752_872_210_5, 146.619_844_188_057_93, 287.876_693_474_862, 476.579_800_794_234_7],
    ];
    let cantilever: [&[f64]; 3] = [
        &[8.355_657_571_749_07, 52.419_257_590_534_1, 147.183_446_271_431_73, 596.671_684_121_541],
        &[8.355_216_251_651_262, 52.369_615_488_968_43, 146.747_053_240_507_4, 288.007_330_425_304_7],
        &[8.355_180_636_062_6, 52.364_037_565_427_324, 146.671_605_968_995_72, 287.692_043_252_376_2],
    ];
    let ends = [0, 1, 20, 21];
    for (place, count) in [2, 4, 6].into_iter().enumerate() {
        let reduced = reduce::reduce_matrices(&k, &m, &ends, count).unwrap();
        let found: Vec<f64> = reduced.eigenvalues.iter().map(|l| l.sqrt() / std::f64::consts::TAU).collect();
        close(&found, &fixed[..count], 1e-8, "fixed");
        close(&natural_frequencies(&reduced.stiffness, &reduced.mass)[2..], free[place], 1e-8, "free");
        let (kc, mc) = (clamped(&reduced.stiffness), clamped(&reduced.mass));
        close(&natural_frequencies(&kc, &mc), cantilever[place], 1e-8, "cantilever");
        let size = 4 + count;
        let block = |of: &[f64]| [of[0], of[1], of[2], of[3], of[size + 1], of[2 * size + 2], of[2 * size + 3]];
        close(
            &block(&reduced.stiffness),
            &[10_500.0, 5_250.0, -10_500.0, 5_250.0, 3_500.0, 10_500.0, -5_250.0],
            1e-8,
            "K",
        );
        let mass = [
            1.457_857_142_857_112,
            0.205_595_238_095_232_53,
            0.504_642_857_142_836_6,
            -0.121_488_095_238_090_91,
            0.037_380_952_380_951_38,
            1.457_857_142_857_112,
            -0.205_595_238_095_236_03,
        ];
        close(&block(&reduced.mass), &mass, 1e-8, "M");
    }
}

const CELLS: [usize; 3] = [8, 2, 2];

/// A bent, twisted bar whose sections grow: nothing lies on an axis, nothing is symmetric.
fn bar(shape: Shape) -> Mesh {
    grids::grid(shape, CELLS, |[x, y, z]| {
        let (y, z) = (0.08 * (y - 0.4) * (1.0 + 0.3 * x), 0.05 * (z - 0.6));
        let (c, s) = ((0.4 * x).cos(), (0.4 * x).sin());
        [0.7 * x + 0.3 * y + 0.2, c * y - s * z + 0.1 * x * x - 0.1, s * y + c * z + 0.07 * x + 0.3]
    })
}

/// An orthotropic material with its axes turned.
fn material() -> Material {
    let turn = {
        let ((a, b), (c, d)) = ((0.7_f64.cos(), 0.7_f64.sin()), (0.4_f64.cos(), 0.4_f64.sin()));
        [[a * c, -b, a * d], [b * c, a, b * d], [-d, 0.0, c]]
    };
    let (e, nu, g) = ([2.1e11, 1.2e11, 0.9e11], [0.25, 0.3, 0.2], [0.7e11, 0.5e11, 0.4e11]);
    Material::orthotropic(e, nu, g, 7310.0).unwrap().rotated(&turn)
}

/// Faces of the bar's first and last layer, and of its top in the middle.
fn faces(mesh: &Mesh) -> [Vec<Face>; 3] {
    let per_cell = mesh.element_count() / (CELLS[0] * CELLS[1] * CELLS[2]);
    let cell = |face: &Face| {
        let cell = face.element as usize / per_cell;
        [cell % CELLS[0], cell / CELLS[0] % CELLS[1], cell / (CELLS[0] * CELLS[1])]
    };
    let mut found = [const { Vec::new() }; 3];
    let outer = outside(mesh);
    for face in &outer {
        let normal = normal(mesh, *face);
        let [i, _, k] = cell(face);
        let along = normal[0].abs() > 0.75;
        match i {
            0 if along && normal[0] < 0.0 => found[0].push(*face),
            7 if along && normal[0] > 0.0 => found[1].push(*face),
            3 | 4 if k == 1 && normal[2] > 0.7 => found[2].push(*face),
            _ => {}
        }
    }
    assert!(found.iter().all(|faces| faces.len() >= 2), "{found:?}");
    found
}

/// Faces that belong to one element only.
fn outside(mesh: &Mesh) -> Vec<Face> {
    let mut seen = std::collections::HashMap::<Vec<u32>, Vec<Face>>::new();
    for face in grids::faces_where(mesh, |_| true) {
        let mut nodes: Vec<u32> = mesh.face_nodes(face).collect();
        nodes.sort_unstable();
        seen.entry(nodes).or_default().push(face);
    }
    let mut faces: Vec<Face> = seen.into_values().filter(|list| list.len() == 1).map(|list| list[0]).collect();
    faces.sort_unstable();
    faces
}

fn normal(mesh: &Mesh, face: Face) -> [f64; 3] {
    let at: Vec<[f64; 3]> = mesh.face_nodes(face).map(|node| mesh.nodes[node as usize]).collect();
    let [u, v]: [[f64; 3]; 2] = [1, 2].map(|k| std::array::from_fn(|i| at[k][i] - at[0][i]));
    let n = [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    let size = n.iter().map(|n| n * n).sum::<f64>().sqrt();
    n.map(|n| n / size)
}

const POINTS: [[f64; 3]; 3] = [[0.19, -0.13, 0.31], [0.93, 0.04, 0.35], [0.55, -0.02, 0.42]];

/// The kinds of the three interfaces of the bar.
const MIXES: [[CouplingKind; 3]; 3] = [
    [CouplingKind::Rigid; 3],
    [CouplingKind::Rigid, CouplingKind::Distributing, CouplingKind::Distributing],
    [CouplingKind::Distributing; 3],
];

fn interfaces(mesh: &Mesh, kinds: [CouplingKind; 3]) -> Vec<Interface> {
    let regions = faces(mesh).map(Region::Faces);
    let all = regions.into_iter().zip(POINTS).zip(kinds);
    all.map(|((region, point), kind)| Interface { region, point, kind }).collect()
}

fn part(mesh: &Mesh) -> Part<'_> {
    Part { mesh, materials: vec![material()], supports: vec![], couplings: vec![] }
}

fn count(count: usize) -> Keep {
    Keep { count: Some(count), frequency: None }
}

fn reduced(mesh: &Mesh, kinds: [CouplingKind; 3], modes: usize) -> Reduction {
    Reduction::craig_bampton(&part(mesh), &interfaces(mesh, kinds), &count(modes), &Settings::default()).unwrap()
}

fn form(x: &[f64], matrix: &[f64], y: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    x.iter().zip(matrix.chunks_exact(y.len())).map(|(x, row)| x * dot(row, y)).sum()
}

/// Checks are small, modes have unit mass, and the stiffness of interfaces and modes is apart.
#[test]
fn a_reduction_keeps_its_promises() {
    for (shape, kinds) in [Shape::Hex20, Shape::Wedge15, Shape::Tet10].into_iter().zip(MIXES) {
        let mesh = bar(shape);
        let reduction = reduced(&mesh, kinds, 9);
        let checks = &reduction.checks;
        assert!(checks.rigid < 1e-9, "{shape:?} {checks:?}");
        assert!(checks.unstrained < 1e-9, "{shape:?} {checks:?}");
        assert!(checks.symmetry < 1e-9, "{shape:?} {checks:?}");
        assert!(checks.coupling < 1e-8, "{shape:?} {checks:?}");
        assert!(checks.static_residual < 1e-9, "{shape:?} {checks:?}");
        assert!(checks.mode_residual < 1e-6, "{shape:?} {checks:?}");
        assert!(checks.free_frequencies[5] < 1e-4 * checks.free_frequencies[6], "{shape:?} {checks:?}");
        let (n, mass) = (reduction.coordinates(), reduction.mass());
        assert_eq!((n, reduction.shapes.len(), reduction.modes), (27, 27, 9));
        for i in 18..n {
            for j in 0..n {
                let own = f64::from(u8::from(i == j));
                if j >= 18 {
                    assert!((mass[i * n + j] - own).abs() < 1e-9, "{shape:?} {i} {j} {}", mass[i * n + j]);
                }
                let omega = std::f64::consts::TAU * reduction.frequencies[i - 18];
                assert!((reduction.stiffness[i * n + j] - own * omega * omega).abs() <= 1e-9 * own * omega * omega);
            }
        }
    }
}

/// The integrals without shapes are those of the mesh; with the coordinates of rigid motion the others are, too.
#[test]
fn the_inertia_of_a_rigid_body_is_exact() {
    for (shape, kinds) in [Shape::Wedge15, Shape::Hex20, Shape::Tet10].into_iter().zip(MIXES) {
        let mesh = bar(shape);
        let reduction = reduced(&mesh, kinds, 4);
        let (inertia, exact) = (&reduction.inertia, mesh.mass_properties(7310.0));
        let (mass, center) = (exact.mass, exact.center);
        assert!((inertia.mass / mass - 1.0).abs() < 1e-12);
        let trace = |m: &[[f64; 3]; 3]| m[0][0] + m[1][1] + m[2][2];
        for i in 0..3 {
            assert!((inertia.first[i] - mass * center[i]).abs() < 1e-12 * mass);
            for j in 0..3 {
                let turned = |m: &[[f64; 3]; 3]| if i == j { trace(m) } else { 0.0 } - m[i][j];
                let parallel: [[f64; 3]; 3] =
                    std::array::from_fn(|a| std::array::from_fn(|b| mass * center[a] * center[b]));
                let own = turned(&inertia.second) - turned(&parallel);
                assert!((own - exact.inertia[i][j]).abs() < 1e-10 * exact.inertia[2][2], "{i} {j}");
            }
        }
        let motions = reduction.rigid_motions();
        let matrix = reduction.mass();
        for (a, x) in motions.iter().enumerate() {
            for (b, y) in motions.iter().enumerate() {
                let wanted = rigid_mass(inertia.mass, inertia.first, &inertia.second, a, b);
                let found = form(x, &matrix, y);
                assert!((found - wanted).abs() < 1e-10 * mass, "{shape:?} {a} {b} {found} {wanted}");
            }
        }
        // ∫ φ dm and ∫ x φᵀ dm of a displacement along y: m e_y and first e_yᵀ.
        let sum = |k: usize, i: usize, j: usize| -> [f64; 2] {
            let shares = motions[k].iter().enumerate();
            shares.fold([0.0; 2], |s, (e, z)| [s[0] + z * inertia.flow[e][j], s[1] + z * inertia.placed[e][i][j]])
        };
        for i in 0..3 {
            for j in 0..3 {
                let own = f64::from(u8::from(j == 1));
                let [flow, placed] = sum(1, i, j);
                assert!((flow - own * mass).abs() < 1e-10 * mass);
                assert!((placed - own * inertia.first[i]).abs() < 1e-10 * mass);
            }
        }
    }
}

/// Entry of the 6 × 6 mass matrix of a rigid body about the origin.
fn rigid_mass(mass: f64, first: [f64; 3], second: &[[f64; 3]; 3], a: usize, b: usize) -> f64 {
    let same = f64::from(u8::from(a % 3 == b % 3));
    match (a < 3, b < 3) {
        (true, true) => mass * same,
        (false, false) => (0..3).map(|i| second[i][i]).sum::<f64>() * same - second[a - 3][b - 3],
        // The velocity of a turn about k is e_k × x.
        (true, false) => [0, 1, 2].map(|i| if i == a { cross(b - 3, first)[i] } else { 0.0 }).iter().sum(),
        (false, true) => rigid_mass(mass, first, second, b, a),
    }
}

fn cross(k: usize, x: [f64; 3]) -> [f64; 3] {
    let (i, j) = ((k + 1) % 3, (k + 2) % 3);
    let mut c = [0.0; 3];
    (c[i], c[j]) = (-x[j], x[i]);
    c
}

/// A force and a moment on one frame while another is held: displacement and stress are those of statics.
#[test]
fn the_static_limit_is_statics() {
    for (shape, kinds) in [Shape::Wedge15, Shape::Tet10, Shape::Hex20].into_iter().zip(MIXES) {
        let mesh = bar(shape);
        let reduction = reduced(&mesh, kinds, 5);
        let force = [310.0, -170.0, 420.0, 12.0, -31.0, 17.0];
        let couplings = interfaces(&mesh, kinds).into_iter().enumerate();
        let coupling = |(index, one): (usize, Interface)| Coupling {
            held: if index == 0 { [Some(0.0); 6] } else { [None; 6] },
            ..Coupling::free(one.region, one.point, one.kind)
        };
        let held = Part { couplings: couplings.map(coupling).collect(), ..part(&mesh) };
        let statics = Statics::new(&held, Free::Refused, &Settings::default()).unwrap();
        let (push, turn) = ([force[0], force[1], force[2]], [force[3], force[4], force[5]]);
        let solution = statics.solve(&[Load::Frame { coupling: 1, force: push, moment: turn }]).unwrap();
        let n = reduction.coordinates();
        let left: Vec<Vec<f64>> = (6..n).map(|i| reduction.stiffness[i * n + 6..(i + 1) * n].to_vec()).collect();
        let mut pushed = force.to_vec();
        pushed.resize(n - 6, 0.0);
        let d = solve(left, pushed);
        for k in 0..12 {
            let wanted = solution.frames[1 + k / 6][k % 6];
            let size = solution.frames[1 + k / 6].iter().fold(0.0_f64, |m, u| m.max(u.abs()));
            assert!((d[k] - wanted).abs() < 1e-8 * size, "{shape:?} {k} {} {wanted}", d[k]);
        }
        let size = solution.displacement.iter().flatten().fold(0.0_f64, |m, u| m.max(u.abs()));
        for (node, wanted) in solution.displacement.iter().enumerate() {
            for i in 0..3 {
                let found: f64 = d.iter().zip(&reduction.shapes[6..]).map(|(d, shape)| d * shape[node][i]).sum();
                assert!((found - wanted[i]).abs() < 1e-8 * size, "{shape:?} {node} {found} {}", wanted[i]);
            }
        }
        let exact = Stress::new(&held, &solution).nodal;
        let stress = reduce::stress(&part(&mesh), &reduction, 2);
        let size = exact.iter().flatten().fold(0.0_f64, |m, s| m.max(s.abs()));
        for (node, wanted) in exact.iter().enumerate() {
            for c in 0..6 {
                let found: f64 = d.iter().zip(&stress[6..]).map(|(d, one)| d * one[node][c]).sum();
                assert!((found - wanted[c]).abs() < 1e-8 * size, "{shape:?} {node} {c} {found} {}", wanted[c]);
            }
        }
    }
}

/// Gauss with pivots.
fn solve(mut a: Vec<Vec<f64>>, mut b: Vec<f64>) -> Vec<f64> {
    let n = b.len();
    for k in 0..n {
        let pivot = (k..n).max_by(|&i, &j| a[i][k].abs().total_cmp(&a[j][k].abs())).unwrap();
        a.swap(k, pivot);
        b.swap(k, pivot);
        for i in k + 1..n {
            let factor = a[i][k] / a[k][k];
            for j in k..n {
                a[i][j] -= factor * a[k][j];
            }
            b[i] -= factor * b[k];
        }
    }
    for k in (0..n).rev() {
        let known: f64 = (k + 1..n).map(|j| a[k][j] * b[j]).sum();
        b[k] = (b[k] - known) / a[k][k];
    }
    b
}

/// Nothing held: up to a third of the highest frequency kept, those of the reduced body are those of the whole mesh with
/// the same couplings; and never below them.
#[test]
fn free_frequencies_are_those_of_the_mesh() {
    for kinds in MIXES {
        let mesh = bar(Shape::Wedge15);
        let reduction = reduced(&mesh, kinds, 24);
        let couplings = interfaces(&mesh, kinds).into_iter().map(|one| Coupling::free(one.region, one.point, one.kind));
        let full = Part { couplings: couplings.collect(), ..part(&mesh) };
        let modes = Modes::lowest(&full, 20, &Settings::default()).unwrap();
        let band = reduction.frequencies[23] / 3.0;
        let kept: Vec<f64> = modes.frequencies[6..].iter().copied().filter(|f| *f < band).collect();
        assert!(kept.len() >= 5, "{kept:?} {band}");
        close(&reduction.checks.free_frequencies[6..], &kept, 5e-3, "free");
        assert!(kept.iter().zip(&reduction.checks.free_frequencies[6..]).all(|(full, own)| *own > full * (1.0 - 1e-6)));
    }
}

/// Modal damping: every free mode has the ratio asked for, rigid motions have none.
#[test]
fn damping_is_modal() {
    let mesh = bar(Shape::Hex20);
    let reduction = reduced(&mesh, MIXES[1], 6);
    let (mass, damping, n) = (reduction.mass(), reduction.damping(0.013), reduction.coordinates());
    let largest = damping.iter().fold(0.0_f64, |m, d| m.max(d.abs()));
    for motion in reduction.rigid_motions() {
        let left = damping.chunks_exact(n).map(|row| row.iter().zip(&motion).map(|(d, z)| d * z).sum::<f64>());
        assert!(left.fold(0.0_f64, |m, f| m.max(f.abs())) < 1e-10 * largest);
    }
    // With D x = 2 ζ ω M x for modes, (ω² − s²) M x and i s D x share their eigenvectors: D M⁻¹ D = (2 ζ)² K.
    let rows = |of: &[f64]| -> Vec<Vec<f64>> { of.chunks_exact(n).map(<[f64]>::to_vec).collect() };
    let columns: Vec<Vec<f64>> =
        (0..n).map(|j| solve(rows(&mass), (0..n).map(|i| damping[i * n + j]).collect())).collect();
    for i in 0..n {
        for j in 0..n {
            let found: f64 = (0..n).map(|k| damping[i * n + k] * columns[j][k]).sum();
            let wanted = 0.026 * 0.026 * reduction.stiffness[i * n + j];
            let size = 0.026 * 0.026 * (reduction.stiffness[i * (n + 1)] * reduction.stiffness[j * (n + 1)]).sqrt();
            assert!((found - wanted).abs() < 1e-7 * size, "{i} {j} {found} {wanted}");
        }
    }
}

#[test]
fn modes_are_kept_by_number_and_frequency() {
    let mesh = bar(Shape::Wedge6);
    let (part, interfaces) = (part(&mesh), interfaces(&mesh, MIXES[0]));
    let with = |keep: Keep| Reduction::craig_bampton(&part, &interfaces, &keep, &Settings::default());
    let many = with(count(25)).unwrap().frequencies;
    let limit = f64::midpoint(many[19], many[20]);
    let below = with(Keep { count: None, frequency: Some(limit) }).unwrap();
    assert_eq!(below.modes, 20);
    close(&below.frequencies, &many[..20], 1e-9, "below a limit");
    assert_eq!(with(Keep { count: Some(7), frequency: Some(limit) }).unwrap().modes, 7);
    assert_eq!(with(Keep { count: Some(24), frequency: Some(limit) }).unwrap().modes, 20);
    assert_eq!(with(Keep::default()).unwrap().modes, 0);
}

#[test]
fn wrong_interfaces_are_named() {
    let mesh = bar(Shape::Hex20);
    let settings = Settings::default();
    let faults = |interfaces: &[Interface], keep: &Keep| {
        Reduction::craig_bampton(&part(&mesh), interfaces, keep, &settings).unwrap_err()
    };
    assert_eq!(faults(&[], &count(1)), [Fault::NoInterface]);
    for kinds in MIXES {
        let good = interfaces(&mesh, kinds);
        let mut wrong = good.clone();
        wrong[1].region = Region::Faces(vec![]);
        assert_eq!(faults(&wrong, &count(1)), [Fault::EmptyInterface(1)]);
        let middle = mesh.nodes.iter().position(|at| (0.35..0.45).contains(&at[0])).unwrap();
        wrong[1].region = Region::Nodes(vec![middle as u32]);
        assert_eq!(faults(&wrong, &count(1)), [Fault::InterfaceOnLine(1)]);
        wrong[1].region = wrong[2].region.clone();
        assert!(matches!(faults(&wrong, &count(1))[..], [Fault::InterfacesOverlap { interfaces: [1, 2], .. }]));
        let found = faults(&good, &count(5000));
        let [Fault::TooManyModes { asked: 5000, available }] = found[..] else { panic!("{found:?}") };
        assert!(available < 3 * mesh.nodes.len());
    }
    let mut part = part(&mesh);
    part.supports.push(Support::clamped(vec![3]));
    let found = Reduction::craig_bampton(&part, &interfaces(&mesh, MIXES[0]), &count(1), &settings).unwrap_err();
    assert_eq!(found, [Fault::ReducedPartHeld]);
}

/// One element between two rigid interfaces has nothing that is free: its constraint modes are motions of the faces.
#[test]
fn a_part_without_free_nodes_has_no_modes() {
    let mesh = grids::grid(Shape::Hex8, [1, 1, 1], |[x, y, z]| [x + 0.2 * y, y - 0.1 * x, z + 0.3 * x]);
    let side = |last: usize| Interface {
        region: Region::Nodes(
            (0..8).filter(|&node| usize::from(mesh.nodes[node as usize][2] > 0.65) == last).collect(),
        ),
        point: [0.4, 0.6, last as f64],
        kind: CouplingKind::Rigid,
    };
    let (part, interfaces) = (part(&mesh), [side(0), side(1)]);
    let with = |keep: Keep| Reduction::craig_bampton(&part, &interfaces, &keep, &Settings::default());
    let reduction = with(Keep { count: None, frequency: Some(1e9) }).unwrap();
    assert_eq!((reduction.modes, reduction.coordinates()), (0, 12));
    assert!(reduction.checks.rigid < 1e-14 && reduction.checks.unstrained < 1e-12, "{:?}", reduction.checks);
    assert_eq!(with(count(1)).unwrap_err(), [Fault::TooManyModes { asked: 1, available: 0 }]);
}

/// A node that belongs to no element changes nothing.
#[test]
fn nodes_of_no_element_stay_where_they_are() {
    let mesh = bar(Shape::Wedge6);
    let mut more = mesh.clone();
    more.nodes.push([3.0, 1.0, -2.0]);
    for kinds in MIXES {
        let (one, other) = (reduced(&mesh, kinds, 3), reduced(&more, kinds, 3));
        close(&other.frequencies, &one.frequencies, 1e-9, "frequencies");
        assert!(other.checks.rigid < 1e-9, "{:?}", other.checks);
        assert!(other.shapes.iter().all(|shape| shape[mesh.nodes.len()] == [0.0; 3]));
    }
}

#[test]
fn memory_and_patience_have_ends() {
    let mesh = bar(Shape::Hex20);
    let (part, interfaces) = (part(&mesh), interfaces(&mesh, MIXES[1]));
    let small = Settings { memory: Some(100_000), ..Settings::default() };
    let found = Reduction::craig_bampton(&part, &interfaces, &count(3), &small).unwrap_err();
    assert!(matches!(found[..], [Fault::Memory { needed, allowed: 100_000 }] if needed > 100_000), "{found:?}");
    for share in [0.0, 0.501] {
        let stop = |done: f64| done < share;
        let stopped = Settings { progress: &stop, ..Settings::default() };
        let found = Reduction::craig_bampton(&part, &interfaces, &count(20), &stopped).unwrap_err();
        assert_eq!(found, [Fault::Interrupted]);
    }
}
