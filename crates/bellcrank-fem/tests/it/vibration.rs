//! Natural frequencies against published and spectral values.

use bellcrank_fem::{Material, Modes, Part, Settings, Support};
use bellcrank_mesh::Shape;

use crate::grids::{self, nodes_where};

fn near(a: f64, b: f64) -> bool {
    (a - b).abs() < 1e-9
}

/// NAFEMS FV32: cantilevered tapered membrane, in-plane frequencies (F4_fv32: target and converged values). The half
/// on one side of the middle plane, which stays plane: bending is left out.
#[test]
fn fv32_tapered_membrane() {
    let place = |[u, v, z]: [f64; 3]| [10.0 * u, (v - 0.5) * (5.0 - 4.0 * u), 0.025 * z];
    let mesh = grids::grid(Shape::Hex20, [16, 8, 1], place);
    let part = Part {
        mesh: &mesh,
        materials: vec![Material::isotropic(2e11, 0.3, 8000.0).unwrap()],
        supports: vec![
            Support::along(nodes_where(&mesh, |at| near(at[0], 0.0)), [Some(0.0), Some(0.0), None]),
            Support::along(nodes_where(&mesh, |at| near(at[2], 0.0)), [None, None, Some(0.0)]),
        ],
        couplings: vec![],
    };
    let modes = Modes::lowest(&part, 8, &Settings::default()).unwrap();
    assert_eq!(modes.rigid, 0);
    let exact = [44.617, 130.0095, 162.6887, 245.9858, 379.7171, 391.4042, 522.579, 564.698];
    for (found, exact) in modes.frequencies.iter().zip(exact) {
        assert!((found / exact - 1.0).abs() < 2e-3, "{found} {exact}");
    }
}

/// A block, free and clamped, against three-dimensional spectral elements (F8_beam_modes).
#[test]
fn modes_of_a_block() {
    let place = |[u, v, w]: [f64; 3]| [u, 0.1 * (v - 0.5), 0.05 * (w - 0.5)];
    let free = [263.54127, 513.78, 715.35379, 1188.803, 1338.239, 1372.46746];
    let clamped = [41.87396, 83.13292, 259.40672, 498.6267, 600.36015, 713.70833];
    for (shape, bound) in [(Shape::Hex20, 5e-3), (Shape::Wedge15, 5e-3), (Shape::Tet10, 1.2e-2)] {
        let mesh = grids::grid(shape, [20, 3, 2], place);
        let steel = Material::isotropic(2.1e11, 0.3, 7850.0).unwrap();
        let mut part = Part { mesh: &mesh, materials: vec![steel], supports: vec![], couplings: vec![] };
        let modes = Modes::lowest(&part, 12, &Settings::default()).unwrap();
        assert_eq!(modes.rigid, 6);
        assert!(modes.residual < 1e-6, "{}", modes.residual);
        for (found, exact) in modes.frequencies[6..].iter().zip(free) {
            assert!((found / exact - 1.0).abs() < bound, "{shape:?} free: {found} {exact}");
        }
        part.supports = vec![Support::clamped(nodes_where(&mesh, |at| near(at[0], 0.0)))];
        let modes = Modes::lowest(&part, 6, &Settings::default()).unwrap();
        for (found, exact) in modes.frequencies.iter().zip(clamped) {
            assert!((found / exact - 1.0).abs() < 2.0 * bound, "{shape:?} clamped: {found} {exact}");
        }
    }
}
