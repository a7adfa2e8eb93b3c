//! Supports, couplings and loads by their identities.

use bellcrank_fem::{
    Coupling, CouplingKind, Fault, Free, FreeMotion, Load, Material, Part, Region, Settings, Solution, Statics, Support,
};
use bellcrank_mesh::{Mesh, Shape};

use crate::grids;

fn steel() -> Material {
    Material::isotropic(2.1e11, 0.29, 7850.0).unwrap()
}

/// A bent, twisted bar: nothing lies on an axis.
fn bar(shape: Shape) -> Mesh {
    grids::grid(shape, [6, 2, 2], |[x, y, z]| {
        let (y, z) = (0.08 * (y - 0.5), 0.05 * (z - 0.5));
        let (c, s) = ((0.4 * x).cos(), (0.4 * x).sin());
        [0.5 * x + 0.3 * y, c * y - s * z + 0.1 * x * x, s * y + c * z + 0.07 * x]
    })
}

fn ends(mesh: &Mesh, cells: [usize; 3]) -> [Vec<bellcrank_mesh::Face>; 2] {
    // Elements are made cell by cell: the first and the last layer along x.
    let per_cell = mesh.element_count() / (cells[0] * cells[1] * cells[2]);
    let face_at = |last: bool| {
        let mut faces = Vec::new();
        for face in grids::faces_where(mesh, |_| true) {
            let cell = face.element as usize / per_cell;
            let i = cell % cells[0];
            if i == if last { cells[0] - 1 } else { 0 } {
                let on_end = mesh.face_nodes(face).all(|node| {
                    let at = mesh.nodes[node as usize];
                    let x = if last { 0.5 } else { 0.0 };
                    // The map keeps sections in planes x = 0.5 t + 0.3 y.
                    (at[0] - x).abs() < 0.3 * 0.05
                });
                if on_end {
                    faces.push(face);
                }
            }
        }
        faces
    };
    [face_at(false), face_at(true)]
}

fn settings() -> Settings<'static> {
    Settings::default()
}

fn sum_of(mesh: &Mesh, solution: &Solution, about: [f64; 3]) -> [f64; 6] {
    let mut sum = [0.0; 6];
    for (force, at) in solution.reactions.iter().zip(&mesh.nodes) {
        let r: [f64; 3] = std::array::from_fn(|i| at[i] - about[i]);
        let m =
            [r[1] * force[2] - r[2] * force[1], r[2] * force[0] - r[0] * force[2], r[0] * force[1] - r[1] * force[0]];
        (0..3).for_each(|i| {
            sum[i] += force[i];
            sum[3 + i] += m[i];
        });
    }
    sum
}

#[test]
fn reactions_balance_the_loads() {
    let force = [310.0, -170.0, 420.0];
    let moment = [12.0, -31.0, 17.0];
    for shape in [Shape::Tet10, Shape::Wedge15, Shape::Hex20, Shape::Hex8] {
        let mesh = bar(shape);
        let [first, last] = ends(&mesh, [6, 2, 2]);
        assert!(!first.is_empty() && !last.is_empty());
        let reference = [0.61, 0.13, -0.08];
        for kind in [CouplingKind::Rigid, CouplingKind::Distributing] {
            let nodes = first.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
            let part = Part {
                mesh: &mesh,
                materials: vec![steel()],
                supports: vec![Support::clamped(nodes)],
                couplings: vec![Coupling::free(Region::Faces(last.clone()), reference, kind)],
            };
            let statics = Statics::new(&part, Free::Refused, &settings()).unwrap();
            let solution = statics.solve(&[Load::Frame { coupling: 0, force, moment }]).unwrap();
            assert!(solution.residual < 1e-9, "{shape:?} {kind:?} {}", solution.residual);
            let sum = sum_of(&mesh, &solution, reference);
            for i in 0..3 {
                assert!((sum[i] + force[i]).abs() < 1e-6, "{shape:?} {kind:?} {sum:?}");
                assert!((sum[3 + i] + moment[i]).abs() < 1e-6, "{shape:?} {kind:?} {sum:?}");
            }
            // Clapeyron: the work of the loads is twice the elastic energy.
            let frame = solution.frames[0];
            let work: f64 = (0..3).map(|i| force[i] * frame[i] + moment[i] * frame[3 + i]).sum();
            assert!((work / (2.0 * solution.energy) - 1.0).abs() < 1e-9, "{shape:?} {kind:?}");
        }
    }
}

/// A part held by a frame at one end answers a load at the other as it answers the same load with the ends' parts
/// swapped: Maxwell's reciprocity.
#[test]
fn frames_hold_and_answer_reciprocally() {
    let mesh = bar(Shape::Wedge15);
    let [first, last] = ends(&mesh, [6, 2, 2]);
    for held in [CouplingKind::Rigid, CouplingKind::Distributing] {
        for loaded in [CouplingKind::Rigid, CouplingKind::Distributing] {
            let hold =
                Coupling { held: [Some(0.0); 6], ..Coupling::free(Region::Faces(first.clone()), [0.0; 3], held) };
            let middle = grids::faces_where(&mesh, |at| (0.2..0.3).contains(&at[0]) && at[2] > 0.0);
            let part = Part {
                mesh: &mesh,
                materials: vec![steel()],
                supports: vec![],
                couplings: vec![
                    hold,
                    Coupling::free(Region::Faces(last.clone()), [0.5, 0.1, 0.07], loaded),
                    Coupling::free(Region::Faces(middle), [0.25, 0.0, 0.1], CouplingKind::Distributing),
                ],
            };
            let statics = Statics::new(&part, Free::Refused, &settings()).unwrap();
            let (a, b) = ([90.0, -40.0, 70.0], [-20.0, 85.0, 35.0]);
            let on = |coupling, force| Load::Frame { coupling, force, moment: [3.0, -2.0, 4.0] };
            let one = statics.solve(&[on(1, a)]).unwrap();
            let two = statics.solve(&[on(2, b)]).unwrap();
            let work = |f: [f64; 3], u: [f64; 6]| {
                let m = [3.0, -2.0, 4.0];
                (0..3).map(|i| f[i] * u[i] + m[i] * u[3 + i]).sum::<f64>()
            };
            let (ab, ba) = (work(a, two.frames[1]), work(b, one.frames[2]));
            assert!((ab / ba - 1.0).abs() < 1e-8, "{held:?} {loaded:?}: {ab} {ba}");
            assert!(one.frames[0].iter().all(|u| u.abs() < 1e-15), "{:?}", one.frames[0]);
            let reaction = one.frame_reactions[0];
            for i in 0..3 {
                assert!((reaction[i] + a[i]).abs() < 1e-6, "{held:?} {loaded:?}: {reaction:?}");
            }
        }
    }
}

#[test]
fn inertia_relief_balances_what_is_left() {
    let mesh = bar(Shape::Tet10);
    let [first, last] = ends(&mesh, [6, 2, 2]);
    let part = Part {
        mesh: &mesh,
        materials: vec![steel()],
        supports: vec![],
        couplings: vec![
            Coupling::free(Region::Faces(first), [0.0; 3], CouplingKind::Rigid),
            Coupling::free(Region::Faces(last), [0.5, 0.1, 0.07], CouplingKind::Distributing),
        ],
    };
    let statics = Statics::new(&part, Free::Relieved, &settings()).unwrap();
    let load = |coupling, force| Load::Frame { coupling, force, moment: [1.0, 2.0, -3.0] };
    let solution = statics.solve(&[load(0, [100.0, 50.0, -70.0]), load(1, [-30.0, 20.0, 40.0])]).unwrap();
    let relief = solution.relief.unwrap();
    for (found, exact) in relief.iter().zip([70.0, 70.0, -30.0]) {
        assert!((found - exact).abs() < 1e-9, "{relief:?}");
    }
    assert!(solution.residual < 1e-8, "{}", solution.residual);
    // A uniform acceleration and its weight cancel: no stress, no displacement.
    let nothing = statics
        .solve(&[
            Load::Gravity([1.0, -9.0, 4.0]),
            Load::Motion { about: [0.1; 3], acceleration: [1.0, -9.0, 4.0], omega: [0.0; 3], alpha: [0.0; 3] },
        ])
        .unwrap();
    assert!(nothing.displacement.iter().flatten().all(|u| u.abs() < 1e-18));
}

#[test]
fn free_motions_are_named() {
    let mesh = bar(Shape::Hex8);
    let part = |supports| Part { mesh: &mesh, materials: vec![steel()], supports, couplings: vec![] };
    let faults = |supports| match Statics::new(&part(supports), Free::Refused, &settings()) {
        Err(faults) => faults,
        Ok(_) => panic!("held"),
    };
    let [Fault::UnderSupported(all)] = &faults(vec![])[..] else { panic!("six motions") };
    assert_eq!(all.len(), 6);
    assert_eq!(all.iter().filter(|motion| matches!(motion, FreeMotion::Along(_))).count(), 3);
    let (a, b) = (mesh.nodes[0], mesh.nodes[17]);
    let found = faults(vec![Support::clamped(vec![0, 17])]);
    let [Fault::UnderSupported(hinge)] = &found[..] else { panic!("a hinge: {found:?}") };
    let [FreeMotion::About { axis, point, pitch }] = hinge[..] else { panic!("a turn: {hinge:?}") };
    let d: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
    let r: [f64; 3] = std::array::from_fn(|i| point[i] - a[i]);
    let cross =
        |u: [f64; 3], v: [f64; 3]| [u[1] * v[2] - u[2] * v[1], u[2] * v[0] - u[0] * v[2], u[0] * v[1] - u[1] * v[0]];
    assert!(cross(axis, d).iter().all(|x| x.abs() < 1e-9) && cross(axis, r).iter().all(|x| x.abs() < 1e-9));
    assert!(pitch.abs() < 1e-9);
}

#[test]
fn what_does_not_fit_is_iterated_or_refused() {
    let mesh = bar(Shape::Tet10);
    let [first, last] = ends(&mesh, [6, 2, 2]);
    let nodes = first.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    let part = Part {
        mesh: &mesh,
        materials: vec![steel()],
        supports: vec![Support::clamped(nodes)],
        couplings: vec![Coupling::free(Region::Faces(last), [0.6, 0.1, 0.0], CouplingKind::Distributing)],
    };
    let load = [Load::Frame { coupling: 0, force: [310.0, -170.0, 420.0], moment: [12.0, -31.0, 17.0] }];
    let within = |memory| Statics::new(&part, Free::Refused, &Settings { memory, ..settings() });
    let direct = within(None).unwrap();
    assert!(direct.effort.factor_entries > 0);
    let entries = direct.effort.factor_entries;
    // Room for the matrix and its incomplete factor, not for the complete one.
    let iterated = within(Some(8 * entries)).unwrap();
    assert_eq!(iterated.effort.factor_entries, 0);
    let (a, b) = (direct.solve(&load).unwrap(), iterated.solve(&load).unwrap());
    let size = a.displacement.iter().flatten().fold(0.0_f64, |m, u| m.max(u.abs()));
    for (a, b) in a.displacement.iter().zip(&b.displacement) {
        assert!((0..3).all(|i| (a[i] - b[i]).abs() < 1e-7 * size));
    }
    let Err(faults) = within(Some(1000)) else { panic!("no memory") };
    assert!(matches!(faults[..], [Fault::Memory { needed, allowed: 1000 }] if needed > 1000));
}

/// A rocking triangle of three springs, a bore loaded by a pin, a skew prescribed support.
#[test]
fn springs_bearings_and_skew_supports_balance() {
    let mesh = bar(Shape::Hex20);
    let [first, last] = ends(&mesh, [6, 2, 2]);
    let (c, s) = (0.8, 0.6);
    let axes = [[c, s, 0.0], [-s * 0.6, c * 0.6, 0.8], [s * 0.8, -c * 0.8, 0.6]];
    let nodes: Vec<u32> = first.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    let ends: Vec<u32> = last.iter().flat_map(|&face| mesh.face_nodes(face)).collect();
    let part = Part {
        mesh: &mesh,
        materials: vec![steel()],
        supports: vec![
            Support::Fixed { nodes: nodes.clone(), axes, values: [Some(1e-5), None, Some(-2e-5)] },
            Support::Spring { nodes: ends, stiffness: [2e6, 5e6, 3e6] },
        ],
        couplings: vec![],
    };
    let statics = Statics::new(&part, Free::Refused, &settings()).unwrap();
    let force = [240.0, 310.0, -150.0];
    let pin = Load::Bearing { faces: last.clone(), center: [0.3, 0.0, 0.1], axis: [0.0, 0.6, 0.8], force };
    let solution = statics.solve(&[pin, Load::Gravity([0.0, 0.0, -9.81])]).unwrap();
    assert!(solution.residual < 1e-8, "{}", solution.residual);
    for &node in &nodes {
        let u = solution.displacement[node as usize];
        let along = |axis: [f64; 3]| (0..3).map(|i| axis[i] * u[i]).sum::<f64>();
        assert!((along(axes[0]) - 1e-5).abs() < 1e-16 && (along(axes[2]) + 2e-5).abs() < 1e-16);
        let r = solution.reactions[node as usize];
        let free: f64 = (0..3).map(|i| axes[1][i] * r[i]).sum();
        assert!(free.abs() < 1e-6, "the free direction holds nothing: {free}");
    }
    let mut volume = 0.0;
    for element in mesh.blocks[0].elements() {
        let (mut n, mut d) = ([0.0; 20], [[0.0; 3]; 20]);
        for point in Shape::Hex20.mass_points() {
            Shape::Hex20.evaluate(point.at, &mut n, &mut d);
            let j: [[f64; 3]; 3] = std::array::from_fn(|i| {
                std::array::from_fn(|k| {
                    element.iter().zip(&d).map(|(&node, d)| d[i] * mesh.nodes[node as usize][k]).sum()
                })
            });
            let cross = [
                j[1][1] * j[2][2] - j[1][2] * j[2][1],
                j[1][2] * j[2][0] - j[1][0] * j[2][2],
                j[1][0] * j[2][1] - j[1][1] * j[2][0],
            ];
            volume += point.weight * (0..3).map(|k| j[0][k] * cross[k]).sum::<f64>();
        }
    }
    let sum = sum_of(&mesh, &solution, [0.0; 3]);
    let loads = [force[0], force[1], force[2] - 9.81 * 7850.0 * volume];
    for i in 0..3 {
        assert!((sum[i] + loads[i]).abs() < 1e-6, "{sum:?} {loads:?}");
    }
}

#[test]
fn a_loose_piece_is_found() {
    let mut mesh = bar(Shape::Tet4);
    let other = grids::grid(Shape::Tet4, [2, 1, 1], |[x, y, z]| [0.7 + 0.1 * x, 0.05 * y + 0.01 * x, 0.04 * z]);
    let first = mesh.nodes.len() as u32;
    mesh.nodes.extend(&other.nodes);
    mesh.blocks[0].nodes.extend(other.blocks[0].nodes.iter().map(|node| node + first));
    let held = grids::nodes_where(&mesh, |at| at[0] < 0.05);
    let part = |supports| Part { mesh: &mesh, materials: vec![steel()], supports, couplings: vec![] };
    let one = part(vec![Support::clamped(held.clone())]);
    let Err(faults) = Statics::new(&one, Free::Refused, &settings()) else { panic!("loose") };
    assert!(matches!(faults[..], [Fault::Pieces { pieces: 2, node }] if node >= first), "{faults:?}");
    let far = grids::nodes_where(&mesh, |at| at[0] > 0.78);
    let both = part(vec![Support::clamped(held), Support::clamped(far)]);
    assert!(Statics::new(&both, Free::Refused, &settings()).is_ok());
}
