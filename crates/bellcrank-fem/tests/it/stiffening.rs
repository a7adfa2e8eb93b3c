//! Geometric stiffness of reduced parts against the theory of beams; the beam lies askew.

use std::f64::consts::{PI, TAU};

use bellcrank_fem::reduce::{self, SPIN_PAIRS, natural_frequencies};
use bellcrank_fem::{CouplingKind, Interface, Keep, Material, Part, Reduction, Region, Settings, Shortening};
use bellcrank_mesh::{Mesh, Shape};

use crate::grids;

const LENGTH: f64 = 1.3;
const WIDTH: f64 = 0.03;
const HEIGHT: f64 = 0.02;
const YOUNG: f64 = 2.1e11;
const DENSITY: f64 = 7850.0;
const START: [f64; 3] = [0.3, -0.2, 0.4];

/// Axes of the beam as rows: along it, its width, its height.
fn axes() -> [[f64; 3]; 3] {
    let ((a, b), (c, d)) = ((0.7_f64.cos(), 0.7_f64.sin()), (0.4_f64.cos(), 0.4_f64.sin()));
    [[a * c, b * c, -d], [-b, a, 0.0], [a * d, b * d, c]]
}

fn bending() -> f64 {
    YOUNG * WIDTH * HEIGHT.powi(3) / 12.0
}

fn at(local: [f64; 3]) -> [f64; 3] {
    let axes = axes();
    std::array::from_fn(|i| START[i] + (0..3).map(|k| axes[k][i] * local[k]).sum::<f64>())
}

fn beam() -> Mesh {
    grids::grid(Shape::Hex20, [24, 1, 1], |[x, y, z]| at([LENGTH * x, WIDTH * (y - 0.5), HEIGHT * (z - 0.5)]))
}

/// The beam held at its start, with interfaces at its ends.
struct Case {
    mesh: Mesh,
    interfaces: Vec<Interface>,
}

impl Case {
    fn new(kind: CouplingKind) -> Self {
        let mesh = beam();
        let end = |x: f64| {
            let place = at([x, 0.0, 0.0]);
            let axis = axes()[0];
            let faces =
                grids::faces_where(&mesh, |at| (0..3).map(|i| (at[i] - place[i]) * axis[i]).sum::<f64>().abs() < 1e-9);
            Interface { region: Region::Faces(faces), point: place, kind }
        };
        let interfaces = vec![end(0.0), end(LENGTH)];
        Self { mesh, interfaces }
    }

    fn part(&self) -> Part<'_> {
        let materials = vec![Material::isotropic(YOUNG, 0.0, DENSITY).unwrap()];
        Part { mesh: &self.mesh, materials, supports: vec![], couplings: vec![] }
    }

    fn reduced(&self, modes: usize) -> Reduction {
        let keep = Keep { count: Some(modes), frequency: None };
        Reduction::craig_bampton(&self.part(), &self.interfaces, &keep, &Settings::default()).unwrap()
    }
}

/// C of a unit force along the beam.
fn axial(found: &[Shortening]) -> Vec<f64> {
    assert_eq!(found.iter().map(|one| one.along).collect::<Vec<_>>(), [6, 7, 8]);
    let mut sum = vec![0.0; found[0].matrix.len()];
    for (one, share) in found.iter().zip(axes()[0]) {
        sum.iter_mut().zip(&one.matrix).for_each(|(sum, c)| *sum += share * c);
    }
    sum
}

fn form(x: &[f64], matrix: &[f64], y: &[f64]) -> f64 {
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    x.iter().zip(matrix.chunks_exact(y.len())).map(|(x, row)| x * dot(row, y)).sum()
}

/// Without the coordinates of the first interface.
fn held(matrix: &[f64]) -> Vec<f64> {
    let n = matrix.len().isqrt();
    matrix.chunks_exact(n).skip(6).flat_map(|row| row[6..].to_vec()).collect()
}

/// An end that moves across and turns: the geometric stiffness of a Hermite element, (1/30L) [36, −3L; −3L, 4L²].
#[test]
fn an_end_that_moves_across_comes_nearer() {
    for kind in [CouplingKind::Rigid, CouplingKind::Distributing] {
        let case = Case::new(kind);
        let reduction = case.reduced(0);
        let c = axial(&reduce::shortenings(&case.part(), &reduction, 0, 2));
        let one = axial(&reduce::shortenings(&case.part(), &reduction, 0, 1));
        assert_eq!(c, one, "threads change nothing");
        let [_, width, height] = axes();
        let coordinate = |first: usize, axis: [f64; 3]| {
            let mut x = vec![0.0; 12];
            x[first..first + 3].copy_from_slice(&axis);
            x
        };
        // A displacement along the width goes with a turn about the height, one along the height with one against the width.
        for (across, about, sign) in [(width, height, 1.0), (height, width, -1.0)] {
            let (w, t) = (coordinate(6, across), coordinate(9, about));
            let near = |found: f64, exact: f64| assert!((found / exact - 1.0).abs() < 5e-3, "{kind:?} {found} {exact}");
            near(form(&w, &c, &w), 36.0 / (30.0 * LENGTH));
            near(form(&t, &c, &t), 4.0 * LENGTH / 30.0);
            near(form(&w, &c, &t), -sign / 10.0);
        }
    }
}

/// Pressed along its axis it buckles at π² E I / 4 L² (Euler), and at nine times that.
#[test]
fn a_held_beam_buckles_at_eulers_load() {
    let case = Case::new(CouplingKind::Rigid);
    let reduction = case.reduced(10);
    let c = held(&axial(&reduce::shortenings(&case.part(), &reduction, 0, 1)));
    // C x = μ K x, with the loads 1/μ.
    let found = natural_frequencies(&c, &held(&reduction.stiffness));
    let mut loads: Vec<f64> = found.iter().rev().map(|f| 1.0 / (TAU * f).powi(2)).collect();
    loads.truncate(4);
    let euler = PI * PI * bending() / (4.0 * LENGTH * LENGTH);
    let wide = (WIDTH / HEIGHT).powi(2);
    let exact = [1.0, wide, 9.0, 9.0 * wide];
    for (found, exact) in loads.iter().zip(exact) {
        assert!((found / euler / exact - 1.0).abs() < 1.2e-2, "{loads:?} {euler} {exact}");
    }
}

/// Frequencies across the plane of rotation of a beam that spins about its held end. Source: A. D. Wright, C. E. Smith, R. W.
/// Thresher and J. L. C. Wang, J. Appl. Mech. 49 (1982) 197: 3.5160, 22.0345 at rest; 13.1702, 37.6031 at twelve times the unit
/// (E I / ρ A L⁴)^½.
#[test]
fn a_beam_that_spins_is_stiffer() {
    for kind in [CouplingKind::Rigid, CouplingKind::Distributing] {
        let case = Case::new(kind);
        let reduction = case.reduced(12);
        let settings = Settings { threads: 2, ..Settings::default() };
        let spin = reduce::spin_stiffness(&case.part(), &case.interfaces, &reduction, 0, &settings).unwrap();
        let unit = (bending() / (DENSITY * WIDTH * HEIGHT)).sqrt() / LENGTH.powi(2);
        for (rate, exact) in [(0.0, [3.5160, 22.0345]), (2.0, [4.1373, 22.6149]), (12.0, [13.1702, 37.6031])] {
            let omega = axes()[2].map(|c| c * rate * unit);
            let mut stiffness = reduction.stiffness.clone();
            for (matrix, [i, j]) in spin.iter().zip(SPIN_PAIRS) {
                stiffness.iter_mut().zip(matrix).for_each(|(k, s)| *k += omega[i] * omega[j] * s);
            }
            let found = frequencies_across(&reduction, &stiffness);
            for (found, exact) in found.iter().zip(exact) {
                assert!(
                    (found * TAU / unit / exact - 1.0).abs() < 5e-3,
                    "{kind:?} {rate} {} {exact}",
                    found * TAU / unit
                );
            }
        }
    }
}

/// Frequencies of motions along the height alone: all others are held by a large stiffness.
fn frequencies_across(reduction: &Reduction, stiffness: &[f64]) -> Vec<f64> {
    let (n, mass) = (reduction.coordinates(), reduction.mass());
    let mut held_stiffness = held(stiffness);
    let width = axes()[1];
    // ∫ (φ_i · b) (φ_j · b) dm: what moves along the width.
    let products = &reduction.inertia.products;
    let along =
        |m: &[[f64; 3]; 3]| (0..3).map(|i| (0..3).map(|j| width[i] * m[i][j] * width[j]).sum::<f64>()).sum::<f64>();
    let extra: Vec<f64> = held(&(0..n * n).map(|at| along(&products[at])).collect::<Vec<_>>());
    held_stiffness.iter_mut().zip(extra).for_each(|(k, m)| *k += 1e9 * m);
    natural_frequencies(&held_stiffness, &held(&mass))
}
