//! Random links of the solid crate.

use bellcrank_mesh::{Mesh, Shape, Sizes, mesh_stack};
use bellcrank_solid::{Link, Stack};

use crate::random::{Dice, random_link};

/// A link that can be built: with fillets, or without where they do not fit.
pub(crate) fn built(seed: u64) -> Option<(Link<f64>, Stack<f64>)> {
    let mut dice = Dice::new(seed);
    let mut link = random_link(&mut dice);
    link.fillet = dice.chance(0.5).then(|| dice.between(0.003, 0.015));
    if let Ok(stack) = link.build() {
        return Some((link, stack));
    }
    link.fillet = None;
    link.build().ok().map(|stack| (link, stack))
}

fn names(link: &Link<f64>) -> Vec<String> {
    (0..link.eyes.len()).map(|eye| format!("E{eye}")).collect()
}

fn mesh(link: &Link<f64>, stack: &Stack<f64>, shape: Shape) -> Mesh {
    let names = names(link);
    let names: Vec<&str> = names.iter().map(String::as_str).collect();
    let mesh = mesh_stack(stack, &names, shape, &Sizes::default()).expect("links can be meshed");
    assert_eq!(mesh.check(), []);
    mesh
}

#[test]
fn random_links_give_sound_meshes_of_their_mass() {
    for seed in 0..20 {
        let Some((link, stack)) = built(seed) else { continue };
        let exact = stack.mass_properties(7850.0);
        for shape in [Shape::Wedge15, Shape::Tet10] {
            let mesh = mesh(&link, &stack, shape);
            let quality = mesh.quality();
            // Cusps, where fillets and hulls touch eyes of another height, have no better elements.
            let least = if shape == Shape::Tet10 { 1e-5 } else { 0.01 };
            assert!(quality.worst > least, "{seed} {shape:?}: {} at {:?}", quality.worst, quality.worst_place);
            // Elements that a cusp makes thin are few. (Tetrahedra of a thin skin are flat, all of them.)
            let thin: usize = quality.histogram[..2].iter().sum();
            assert!(
                shape == Shape::Tet10 || thin * 50 <= quality.elements,
                "{seed} {shape:?}: {:?}",
                quality.histogram
            );
            let mass = mesh.mass_properties(7850.0);
            assert!((mass.mass / exact.mass - 1.0).abs() < 1e-3, "{seed} {shape:?}: {} {}", mass.mass, exact.mass);
            let off = (0..3).map(|i| (mass.center[i] - exact.center[i]).abs()).fold(0.0, f64::max);
            assert!(off < 1e-4, "{seed} {shape:?}: {off}");
        }
    }
}

#[test]
fn every_bore_has_its_sets_on_its_cylinder() {
    for seed in 40..50 {
        let Some((link, stack)) = built(seed) else { continue };
        let mesh = mesh(&link, &stack, Shape::Wedge15);
        for bore in &stack.bores {
            let name = format!("bore.E{}", bore.eye);
            let nodes = &mesh.node_sets[&name];
            assert!(nodes.len() >= 48, "{seed} {name}: {}", nodes.len());
            for &node in nodes {
                let [x, y, z] = mesh.nodes[node as usize];
                let radius = (x - bore.center[0]).hypot(y - bore.center[1]);
                assert!((radius - bore.diameter / 2.0).abs() < 1e-12, "{seed} {name}: {radius} {}", bore.diameter);
                assert!(bore.layers.iter().any(|layer| layer[0] - 1e-12 <= z && z <= layer[1] + 1e-12));
            }
            let around = mesh.cylinders().into_iter().find(|cylinder| cylinder.sets.contains(&name));
            let around = around.expect("a bore is a cylinder");
            assert!(around.bore && (around.radius - bore.diameter / 2.0).abs() < 1e-9, "{around:?}");
            assert!((around.center[0] - bore.center[0]).hypot(around.center[1] - bore.center[1]) < 1e-9);
        }
    }
}

#[test]
fn the_picture_of_a_surface_is_closed_and_uses_every_node() {
    let (link, stack) = (0..).find_map(built).expect("some link can be built");
    for shape in [Shape::Wedge15, Shape::Tet10] {
        let mesh = mesh(&link, &stack, shape);
        let faces = mesh.boundary();
        let surface = mesh.surface(&faces);
        assert_eq!(surface.nodes, mesh.nodes_of_faces(&faces));
        let mut edges = std::collections::HashMap::new();
        let mut volume = 0.0;
        for triangle in &surface.triangles {
            let [a, b, c] = triangle.map(|corner| mesh.nodes[surface.nodes[corner as usize] as usize]);
            volume += (a[0] * (b[1] * c[2] - b[2] * c[1])
                + a[1] * (b[2] * c[0] - b[0] * c[2])
                + a[2] * (b[0] * c[1] - b[1] * c[0]))
                / 6.0;
            for k in 0..3 {
                *edges.entry((triangle[k], triangle[(k + 1) % 3])).or_insert(0) += 1;
            }
        }
        assert!(edges.keys().all(|&(a, b)| edges.contains_key(&(b, a))), "{shape:?}: the surface has a hole");
        assert!((volume / stack.mass_properties(1.0).mass - 1.0).abs() < 5e-3, "{shape:?}: {volume}");
    }
}
