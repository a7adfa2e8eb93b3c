//! Pins, bushes and cones.

use std::f64::consts::PI;

use bellcrank_mesh::{Mesh, MesherError, Shape, Sizes, mesh_revolved};
use bellcrank_solid::Revolved;

fn turned(profile: &[[f64; 2]]) -> Revolved<f64> {
    let axis = [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0];
    Revolved { base: [0.1, -0.2, 0.3], axis, profile: profile.to_vec() }
}

/// Volume of a profile turned once (Pappus).
fn volume(profile: &[[f64; 2]]) -> f64 {
    let side = |k: usize| (profile[k], profile[(k + 1) % profile.len()]);
    let part = |(a, b): ([f64; 2], [f64; 2])| (b[1] - a[1]) * (a[0] * a[0] + a[0] * b[0] + b[0] * b[0]) / 3.0;
    (PI * (0..profile.len()).map(side).map(part).sum::<f64>()).abs()
}

fn sound(profile: &[[f64; 2]], shape: Shape) -> Mesh {
    let mesh = mesh_revolved(&turned(profile), shape, &Sizes::default()).expect("the profile is sound");
    assert_eq!(mesh.check(), []);
    let quality = mesh.quality();
    let off = (quality.volume / volume(profile) - 1.0).abs();
    println!("{shape:?}: {} nodes, worst {:.3}, volume off by {off:.1e}", quality.nodes, quality.worst);
    assert!(off < if shape.quadratic() { 1e-3 } else { 0.06 }, "{shape:?}: {off}");
    assert!(quality.worst > 0.05, "{shape:?}: {}", quality.worst);
    mesh
}

const STEPPED: [[f64; 2]; 6] = [[0.0, 0.0], [0.02, 0.0], [0.02, 0.008], [0.012, 0.008], [0.012, 0.05], [0.0, 0.05]];
const CONE: [[f64; 2]; 6] = [[0.0, 0.0], [0.02, 0.0], [0.02, 0.01], [0.012, 0.03], [0.012, 0.05], [0.0, 0.05]];
const BUSH: [[f64; 2]; 5] = [[0.008, 0.03], [0.014, 0.03], [0.018, 0.02], [0.018, 0.0], [0.008, 0.0]];
const TIP: [[f64; 2]; 3] = [[0.0, 0.0], [0.02, 0.0], [0.0, 0.04]];

#[test]
fn stepped_pins_are_discs_and_cones_are_swept() {
    assert_eq!(sound(&STEPPED, Shape::Wedge15).blocks[0].shape, Shape::Wedge15);
    assert_eq!(sound(&STEPPED, Shape::Tet4).blocks[0].shape, Shape::Tet4);
    for profile in [&CONE[..], &BUSH, &TIP] {
        assert_eq!(sound(profile, Shape::Wedge15).blocks[0].shape, Shape::Tet10);
        assert_eq!(sound(profile, Shape::Tet4).blocks[0].shape, Shape::Tet4);
    }
}

#[test]
fn nodes_of_a_swept_surface_lie_on_it() {
    let revolved = turned(&BUSH);
    let mesh = sound(&BUSH, Shape::Tet10);
    for node in mesh.nodes_of_faces(&mesh.boundary()) {
        let place = mesh.nodes[node as usize];
        let from: Vec<f64> = (0..3).map(|i| place[i] - revolved.base[i]).collect();
        let h: f64 = (0..3).map(|i| from[i] * revolved.axis[i]).sum();
        let r = (from.iter().map(|c| c * c).sum::<f64>() - h * h).sqrt();
        let on = |k: usize| {
            let (a, b) = (BUSH[k], BUSH[(k + 1) % BUSH.len()]);
            let (u, v) = ([b[0] - a[0], b[1] - a[1]], [r - a[0], h - a[1]]);
            (u[0] * v[1] - u[1] * v[0]).abs() / u[0].hypot(u[1])
        };
        assert!((0..BUSH.len()).map(on).fold(f64::INFINITY, f64::min) < 1e-12, "{r} {h}");
    }
}

#[test]
fn profiles_that_enclose_nothing_are_refused() {
    let refused = |profile: &[[f64; 2]]| mesh_revolved(&turned(profile), Shape::Tet10, &Sizes::default()).unwrap_err();
    assert_eq!(refused(&[[0.0, 0.0], [0.01, 0.0]]), MesherError::Profile);
    assert_eq!(refused(&[[-0.01, 0.0], [0.01, 0.0], [0.01, 0.01]]), MesherError::Profile);
    let crossed = refused(&[[0.01, 0.0], [0.03, 0.02], [0.03, 0.0], [0.01, 0.03]]);
    assert!(matches!(crossed, MesherError::Crossing(_)), "{crossed}");
}
