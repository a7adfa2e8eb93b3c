//! Hand-made stacks whose volume is known in closed form.

mod stacks;

use std::collections::HashMap;
use std::f64::consts::PI;

use super::{Division, MesherError, Sizes, mesh_stack};
use crate::{Mesh, Shape};

const QUADRATIC: [Shape; 2] = [Shape::Wedge15, Shape::Tet10];
const ALL: [Shape; 4] = [Shape::Wedge15, Shape::Tet10, Shape::Wedge6, Shape::Tet4];

fn made(stack: &bellcrank_solid::Stack<f64>, shape: Shape, sizes: &Sizes) -> Mesh {
    let mesh = mesh_stack(stack, &["A", "B"], shape, sizes).expect("the stack is sound");
    let faults = mesh.check();
    assert!(faults.is_empty(), "{shape:?}: {:?}", &faults[..faults.len().min(5)]);
    conforms(&mesh);
    mesh
}

/// Every inner face belongs to two elements with all its nodes, mid-sides too; the boundary is closed.
fn conforms(mesh: &Mesh) {
    let mut seen: HashMap<Vec<u32>, usize> = HashMap::new();
    for face in mesh.faces() {
        let mut nodes: Vec<u32> = mesh.face_nodes(face).collect();
        nodes.sort_unstable();
        *seen.entry(nodes).or_default() += 1;
    }
    assert!(seen.values().all(|&count| count <= 2));
    let boundary = mesh.boundary();
    assert_eq!(seen.values().filter(|&&count| count == 1).count(), boundary.len());
    let mut edges: HashMap<[u32; 2], i32> = HashMap::new();
    for face in boundary {
        let corners = mesh.face_shape(face).corners();
        let nodes: Vec<u32> = mesh.face_nodes(face).collect();
        for k in 0..corners {
            let (a, b) = (nodes[k], nodes[(k + 1) % corners]);
            *edges.entry([a.min(b), a.max(b)]).or_default() += if a < b { 1 } else { -1 };
        }
    }
    assert!(edges.values().all(|&sum| sum == 0), "the boundary is not closed");
}

#[test]
fn every_hand_stack_gives_a_sound_mesh_of_its_volume() {
    for (name, stack, volume) in stacks::all() {
        for shape in ALL {
            let mesh = made(&stack, shape, &Sizes::default());
            let quality = mesh.quality();
            let error = (quality.volume / volume - 1.0).abs();
            println!(
                "{name} {shape:?}: {} nodes, worst {:.3}, volume off by {error:.1e}",
                quality.nodes, quality.worst
            );
            assert!(error < if shape.quadratic() { 2e-4 } else { 2e-2 }, "{name} {shape:?}: {error}");
            // A cusp in plan has no angle but what the chords of its first elements leave.
            let least = if name == "drop" { 0.015 } else { 0.12 };
            assert!(quality.worst > least, "{name} {shape:?}: {} at {:?}", quality.worst, quality.worst_place);
        }
    }
}

#[test]
fn the_volume_converges_with_the_fourth_order() {
    let (_, stack, volume) = stacks::block_with_bore();
    for shape in QUADRATIC {
        let error = |per_turn: f64| {
            let sizes = Sizes { at_bores: Division::PerTurn(per_turn), ..Sizes::default() };
            (made(&stack, shape, &sizes).quality().volume / volume - 1.0).abs()
        };
        let order = (error(24.0) / error(48.0)).log2();
        assert!(order > 3.8, "{shape:?}: {order}");
    }
}

#[test]
fn nodes_of_a_bore_lie_on_its_cylinder() {
    let (_, stack, _) = stacks::block_with_bore();
    let bore = &stack.bores[0];
    for shape in ALL {
        let mesh = made(&stack, shape, &Sizes::default());
        let nodes = &mesh.node_sets["bore.A"];
        for &node in nodes {
            let [x, y, _] = mesh.nodes[node as usize];
            let radius = (x - bore.center[0]).hypot(y - bore.center[1]);
            assert!((radius - bore.diameter / 2.0).abs() < 1e-15, "{shape:?}: {radius}");
        }
        assert_eq!(nodes, &mesh.nodes_of_faces(&mesh.face_sets["bore.A"]));
    }
}

/// Area of a face set by the flat facets of linear faces.
fn area(mesh: &Mesh, set: &str) -> f64 {
    let mut sum = 0.0;
    for &face in &mesh.face_sets[set] {
        let form = mesh.face_shape(face);
        let places: Vec<[f64; 3]> = mesh.face_nodes(face).map(|node| mesh.nodes[node as usize]).collect();
        for point in form.points() {
            let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
            form.evaluate([point.at[0], point.at[1]], &mut n, &mut d);
            let along = |c: usize| -> [f64; 3] {
                std::array::from_fn(|i| places.iter().zip(&d).map(|(place, d)| place[i] * d[c]).sum())
            };
            let normal = crate::boundary::cross(along(0), along(1));
            sum += point.weight * crate::boundary::dot(normal, normal).sqrt();
        }
    }
    sum
}

#[test]
fn sets_are_complete() {
    let (_, stack, _) = stacks::boss_on_plate();
    for shape in QUADRATIC {
        let mesh = made(&stack, shape, &Sizes::default());
        let expected = [
            ("bore.A", 2.0 * PI * stacks::BORE * stacks::HEIGHT),
            ("top", PI * (stacks::BOSS.powi(2) - stacks::BORE.powi(2))),
            ("bottom", PI * (stacks::PLATE.powi(2) - stacks::BORE.powi(2))),
        ];
        for (set, exact) in expected {
            assert!((area(&mesh, set) / exact - 1.0).abs() < 2e-4, "{shape:?} {set}: {} {exact}", area(&mesh, set));
        }
        assert_eq!(mesh.face_sets["surface"], mesh.boundary());
        // The circle where the boss stands on the plate is re-entrant, and nothing else.
        for &node in &mesh.node_sets["sharp"] {
            let [x, y, z] = mesh.nodes[node as usize];
            assert!((x.hypot(y) - stacks::BOSS).abs() < 1e-6 && (z - stacks::PLATE_TOP).abs() < 1e-12, "{x} {y} {z}");
        }
        let turn: usize = mesh.node_sets["sharp"].len();
        assert!(turn >= 24, "{turn}");
    }
}

#[test]
fn tetrahedra_fill_the_same_volume_as_wedges() {
    for (name, stack, _) in stacks::all() {
        let volume = |shape| made(&stack, shape, &Sizes::default()).quality().volume;
        let (wedges, tets) = (volume(Shape::Wedge15), volume(Shape::Tet10));
        // Next to a cusp the two bend their mid-side nodes at different heights.
        let most = if name == "drop" { 1e-4 } else { 1e-12 };
        assert!((wedges / tets - 1.0).abs() < most, "{name}: {wedges} {tets}");
        let (wedges, tets) = (volume(Shape::Wedge6), volume(Shape::Tet4));
        assert!((wedges / tets - 1.0).abs() < 1e-12, "{name}: {wedges} {tets}");
    }
}

#[test]
fn elements_have_the_wanted_size_near_and_far() {
    let (_, stack, _) = stacks::block_with_bore();
    let hot = [0.055, 0.01];
    let background = move |[x, y, _]: [f64; 3]| 0.0004 + 0.3 * (x - hot[0]).hypot(y - hot[1]);
    let sizes = Sizes { size: Some(0.008), background: Some(&background), ..Sizes::default() };
    let mesh = made(&stack, Shape::Wedge6, &sizes);
    for nodes in mesh.blocks[0].elements() {
        let places: Vec<[f64; 3]> = nodes[..3].iter().map(|&node| mesh.nodes[node as usize]).collect();
        let middle: [f64; 3] = std::array::from_fn(|i| places.iter().map(|place| place[i]).sum::<f64>() / 3.0);
        let side = |i: usize, j: usize| (places[i][0] - places[j][0]).hypot(places[i][1] - places[j][1]);
        let mean = (side(0, 1) + side(1, 2) + side(2, 0)) / 3.0;
        let wanted = background(middle).min(0.008);
        assert!(mean < 1.7 * wanted, "{mean} {wanted} at {middle:?}");
    }
}

#[test]
fn a_mesh_that_is_too_large_is_refused_with_a_good_estimate() {
    let (_, stack, _) = stacks::boss_on_plate();
    for shape in ALL {
        let sizes = Sizes { size: Some(0.002), ..Sizes::default() };
        let nodes = made(&stack, shape, &sizes).nodes.len();
        let refused = mesh_stack(&stack, &[], shape, &Sizes { most_nodes: 1000, ..sizes });
        let Err(MesherError::TooLarge { estimate, limit: 1000 }) = refused else { panic!("{refused:?}") };
        assert!((estimate as f64 / nodes as f64 - 1.0).abs() < 0.25, "{shape:?}: {estimate} for {nodes}");
    }
    let huge = Sizes { size: Some(1e-7), ..Sizes::default() };
    assert!(matches!(mesh_stack(&stack, &[], Shape::Tet10, &huge), Err(MesherError::TooLarge { .. })));
}

#[test]
fn wrong_sizes_are_refused() {
    let (_, stack, _) = stacks::block_with_bore();
    let refused = |sizes: Sizes, shape| mesh_stack(&stack, &[], shape, &sizes).map(|_| ()).unwrap_err();
    let wrong = |what, value| MesherError::Size { what, value };
    let sizes = Sizes { growth: 1.0, ..Sizes::default() };
    assert_eq!(refused(sizes, Shape::Tet10), wrong("growth", 1.0));
    let sizes = Sizes { size: Some(-0.1), ..Sizes::default() };
    assert_eq!(refused(sizes, Shape::Tet10), wrong("size", -0.1));
    assert_eq!(refused(Sizes::default(), Shape::Hex20), MesherError::Shape(Shape::Hex20));
}
