//! Orders of convergence of displacement and energy, against Lamé's thick cylinder in plane strain.

use std::f64::consts::FRAC_PI_2;

use bellcrank_fem::{Free, Load, Material, Part, Settings, Statics, Stress, Support};
use bellcrank_mesh::{MOST_NODES, Shape};

use crate::grids::{self, faces_where, nodes_where};

const INNER: f64 = 0.1;
const OUTER: f64 = 0.2;
const YOUNG: f64 = 2.1e11;
const POISSON: f64 = 0.3;
const PRESSURE: f64 = 50e6;

fn radial(r: f64) -> f64 {
    let c = PRESSURE * INNER * INNER / (OUTER * OUTER - INNER * INNER);
    (1.0 + POISSON) / YOUNG * c * ((1.0 - 2.0 * POISSON) * r + OUTER * OUTER / r)
}

/// Elastic energy of a quarter of height 0.03: half the work of the pressure.
fn exact_energy() -> f64 {
    0.5 * PRESSURE * radial(INNER) * INNER * FRAC_PI_2 * 0.03
}

struct Errors {
    /// L2 norm of the displacement's error, relative.
    displacement: f64,
    /// Energy norm of the error, relative, from the difference of the energies.
    energy: f64,
    /// The same as Zienkiewicz and Zhu estimate it.
    estimate: f64,
}

fn errors(shape: Shape, cells: usize) -> Errors {
    let place = |[u, s, z]: [f64; 3]| {
        // The arc parameter is bent so that no symmetry of the mesh helps.
        let (sin, cos) = ((s + 0.08 * (2.0 * FRAC_PI_2 * s).sin()) * FRAC_PI_2).sin_cos();
        let r = INNER + (OUTER - INNER) * u;
        [r * cos, r * sin, 0.03 * z]
    };
    let mesh = grids::grid(shape, [cells, 2 * cells, 1], place);
    let held = |axis: usize, at: f64| {
        let mut values = [None; 3];
        values[axis] = Some(0.0);
        Support::along(nodes_where(&mesh, |x| (x[axis] - at).abs() < 1e-9), values)
    };
    let part = Part {
        mesh: &mesh,
        materials: vec![Material::isotropic(YOUNG, POISSON, 7850.0).unwrap()],
        supports: vec![held(0, 0.0), held(1, 0.0), held(2, 0.0), held(2, 0.03)],
        couplings: vec![],
    };
    let bore = faces_where(&mesh, |x| (x[0].hypot(x[1]) - INNER).abs() < 1e-9);
    let load = [Load::Pressure { faces: bore, value: PRESSURE }];
    let solution = Statics::new(&part, Free::Refused, &Settings::default()).unwrap().solve(&load).unwrap();
    let stress = Stress::new(&part, &solution);
    let (mut square, mut size) = (0.0, 0.0);
    for element in mesh.blocks[0].elements() {
        for point in shape.mass_points() {
            let (mut n, mut d) = ([0.0; MOST_NODES], [[0.0; 3]; MOST_NODES]);
            shape.evaluate(point.at, &mut n, &mut d);
            let mix = |of: &[[f64; 3]], i: usize| -> f64 {
                element.iter().zip(&n).map(|(&node, n)| n * of[node as usize][i]).sum()
            };
            let at: [f64; 3] = std::array::from_fn(|i| mix(&mesh.nodes, i));
            let r = at[0].hypot(at[1]);
            let exact = [radial(r) * at[0] / r, radial(r) * at[1] / r, 0.0];
            for (i, exact) in exact.iter().enumerate() {
                square += (mix(&solution.displacement, i) - exact).powi(2);
                size += exact * exact;
            }
        }
    }
    let energy = (2.0 * (exact_energy() - solution.energy)).abs() / (2.0 * exact_energy());
    Errors { displacement: (square / size).sqrt(), energy: energy.sqrt(), estimate: stress.relative_error() }
}

#[test]
fn displacement_and_energy_converge_with_the_order_of_the_element() {
    for (shape, coarse) in [
        (Shape::Hex8, 4),
        (Shape::Wedge6, 4),
        (Shape::Tet4, 5),
        (Shape::Hex20, 2),
        (Shape::Wedge15, 2),
        (Shape::Tet10, 2),
    ] {
        let (one, two) = (errors(shape, coarse), errors(shape, 2 * coarse));
        let order = |a: f64, b: f64| (a / b).log2();
        let (u, e) = if shape.quadratic() { (3.0, 2.0) } else { (2.0, 1.0) };
        let found = (order(one.displacement, two.displacement), order(one.energy, two.energy));
        assert!(found.0 > u - 0.3 && found.1 > e - 0.3, "{shape:?}: {found:?}");
        let effectivity = two.estimate / two.energy;
        assert!((0.5..2.0).contains(&effectivity), "{shape:?}: {effectivity}");
    }
}
