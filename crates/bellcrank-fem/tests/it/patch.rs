//! Patch tests: a constant strain is reproduced exactly on a distorted mesh, by every element.

use bellcrank_fem::{Free, Load, Material, Part, Settings, Statics, Stress, Support, stress};
use bellcrank_mesh::Shape;

use crate::grids;

/// A block with its inner nodes moved about; mid-side nodes stay in the middle, so that sides are straight.
fn distorted(shape: Shape) -> bellcrank_mesh::Mesh {
    let mut mesh = grids::grid(shape, [3, 2, 2], |[x, y, z]| [1.3 * x + 0.2 * y, 0.9 * y - 0.1 * z, 0.7 * z + 0.1 * x]);
    let wobble = |x: [f64; 3]| {
        let inside = |v: f64| (std::f64::consts::PI * v).sin();
        // Not affine and zero on no particular plane: boundaries stay where they are by the product below.
        let [a, b, c] = [x[0] / 1.3, x[1] / 0.9, x[2] / 0.7];
        0.06 * inside(a) * inside(b) * inside(c)
    };
    let corners = shape.corners();
    let block = mesh.blocks[0].clone();
    let mut moved = mesh.nodes.clone();
    for element in block.elements() {
        for &node in &element[..corners] {
            let at = mesh.nodes[node as usize];
            let by = wobble(at);
            moved[node as usize] = [at[0] + by, at[1] - 0.7 * by, at[2] + 0.5 * by];
        }
    }
    if shape.quadratic() {
        for element in block.elements() {
            for (k, ends) in shape.edges().iter().enumerate() {
                let [a, b] = ends.map(|end| moved[element[end as usize] as usize]);
                moved[element[corners + k] as usize] = std::array::from_fn(|i| f64::midpoint(a[i], b[i]));
            }
        }
    }
    mesh.nodes = moved;
    mesh
}

fn boundary(mesh: &bellcrank_mesh::Mesh) -> Vec<u32> {
    // A face that only one element has is outside.
    let mut count = std::collections::HashMap::<Vec<u32>, (usize, Vec<u32>)>::new();
    for face in grids::faces_where(mesh, |_| true) {
        let nodes: Vec<u32> = mesh.face_nodes(face).collect();
        let mut key = nodes.clone();
        key.sort_unstable();
        count.entry(key).or_insert((0, nodes)).0 += 1;
    }
    let mut nodes: Vec<u32> =
        count.into_values().filter(|(times, _)| *times == 1).flat_map(|(_, nodes)| nodes).collect();
    nodes.sort_unstable();
    nodes.dedup();
    nodes
}

const GRADIENT: [[f64; 3]; 3] = [[1.1e-3, 0.4e-3, -0.3e-3], [0.2e-3, -0.7e-3, 0.5e-3], [0.6e-3, -0.1e-3, 0.9e-3]];

fn field(x: [f64; 3]) -> [f64; 3] {
    std::array::from_fn(|i| 0.2e-3 * i as f64 + (0..3).map(|j| GRADIENT[i][j] * x[j]).sum::<f64>())
}

#[test]
fn constant_strain_is_exact_on_a_distorted_mesh() {
    let orthotropic =
        Material::orthotropic([150e9, 12e9, 9e9], [0.28, 0.35, 0.31], [5.1e9, 3.9e9, 4.6e9], 1600.0).unwrap();
    let (c, s) = (0.6, 0.8);
    let turned = orthotropic.rotated(&[[c, -s, 0.0], [s * 0.6, c * 0.6, -0.8], [s * 0.8, c * 0.8, 0.6]]);
    for material in [Material::isotropic(1e6, 0.25, 1.0).unwrap(), orthotropic, turned] {
        for shape in Shape::ALL {
            let mesh = distorted(shape);
            let supports = boundary(&mesh)
                .into_iter()
                .map(|node| Support::along(vec![node], field(mesh.nodes[node as usize]).map(Some)))
                .collect();
            let part = Part { mesh: &mesh, materials: vec![material.clone()], supports, couplings: Vec::new() };
            let statics = Statics::new(&part, Free::Refused, &Settings::default()).unwrap();
            let solution = statics.solve(&[]).unwrap();
            for (u, x) in solution.displacement.iter().zip(&mesh.nodes) {
                let exact = field(*x);
                assert!((0..3).all(|i| (u[i] - exact[i]).abs() < 1e-15), "{shape:?} {u:?} {exact:?}");
            }
            let g = GRADIENT;
            let strain = [g[0][0], g[1][1], g[2][2], g[0][1] + g[1][0], g[1][2] + g[2][1], g[2][0] + g[0][2]];
            let exact = material.stress(&strain);
            let size = exact.iter().fold(0.0_f64, |m, s| m.max(s.abs()));
            let smooth = Stress::new(&part, &solution);
            for stress in stress::at_points(&part, &solution).iter().chain(&smooth.nodal) {
                assert!((0..6).all(|i| (stress[i] - exact[i]).abs() < 1e-11 * size), "{shape:?} {stress:?} {exact:?}");
            }
            assert!(smooth.relative_error() < 1e-9, "{}", smooth.relative_error());
        }
    }
}

#[test]
fn heated_free_part_has_no_stress_and_a_held_one_the_full() {
    let material = Material::isotropic(2e11, 0.3, 7800.0).unwrap().with_expansion([1.2e-5; 3]);
    for shape in Shape::ALL {
        let mesh = distorted(shape);
        let heat = [Load::Temperature(vec![37.0; mesh.nodes.len()])];
        let free = Part { mesh: &mesh, materials: vec![material.clone()], supports: vec![], couplings: vec![] };
        let solution = Statics::new(&free, Free::Relieved, &Settings::default()).unwrap().solve(&heat).unwrap();
        let most = stress::at_points(&free, &solution).iter().flatten().fold(0.0_f64, |m, s| m.max(s.abs()));
        assert!(most < 1e-9 * 2e11 * 1.2e-5 * 37.0, "{shape:?} {most}");
        let all = (0..mesh.nodes.len() as u32).collect();
        let held = Part { supports: vec![Support::clamped(all)], ..free };
        let solution = Statics::new(&held, Free::Refused, &Settings::default()).unwrap().solve(&heat).unwrap();
        let exact = -2e11 / (1.0 - 0.6) * 1.2e-5 * 37.0;
        for stress in stress::at_points(&held, &solution) {
            assert!((0..3).all(|i| (stress[i] / exact - 1.0).abs() < 1e-12), "{shape:?} {stress:?}");
        }
    }
}
