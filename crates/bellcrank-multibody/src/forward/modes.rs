//! The machine linearized: `M δ̈ + C δ̇ + K δ = 0` over the motions that the constraints leave.
//!
//! K and C are exact, the geometric stiffness of the multipliers included; a basis of the null space of J reduces them.

use super::door::{Dynamics, Linearized, Mode, Surroundings};
use super::flight::Flight;
use crate::solver::{Machine, RANK};
use crate::{Coordinate, MechanismError, Reading, Readings, Seeded, kinematics};
use bellcrank_math::{Space, linalg::dense};

/// Eigenvalues below this part of the largest are those of free motion.
const STILL: f64 = 1e-7;

type Matrix = Vec<Vec<f64>>;

/// Surroundings in which driven coordinates rest where they are.
struct Resting<'a> {
    places: Vec<f64>,
    around: &'a mut dyn Surroundings,
}

impl Surroundings for Resting<'_> {
    fn inputs(&mut self, at: &dyn Readings<f64>, values: &mut [f64]) {
        self.around.inputs(at, values);
    }
    fn exact_inputs(&mut self, at: &dyn Readings<Seeded>, values: &mut [Seeded]) {
        self.around.exact_inputs(at, values);
    }
    fn drives(&mut self, _: f64, motion: &mut [Reading]) {
        for (motion, &position) in motion.iter_mut().zip(&self.places) {
            *motion = Reading { position, velocity: 0.0, acceleration: 0.0 };
        }
    }
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// `M δ̈ + C δ̇ + K δ = 0` over the free motions.
struct Reduced {
    mass: Matrix,
    damping: Matrix,
    stiffness: Matrix,
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn find_modes(
        &mut self,
        driven: &[Coordinate],
        around: &mut dyn Surroundings,
    ) -> Result<Linearized, MechanismError> {
        self.check_list(driven)?;
        let time = self.time;
        self.freedom_beside(driven)?;
        let places = driven.iter().map(|&c| self.solved().coordinate(c).position).collect();
        let mut around = Resting { places, around };
        let dynamics = Dynamics { driven: driven.to_vec(), ..Dynamics::free() };
        let mut f = self.new_flight(&dynamics, true);
        self.rebuild(&mut f);
        self.use_masses(&mut f);
        self.friction.fill(0.0);
        self.v.fill(0.0);
        self.time = time;
        self.accelerate(&mut f, &mut around)?;
        self.answer_forces(&mut f);
        self.take_stiffness(&mut f, &mut around)?;
        let found = self.linearized(&mut f);
        self.prepared = None;
        self.flight = Some(Box::new(f));
        found
    }

    fn linearized(&mut self, f: &mut Flight<S>) -> Result<Linearized, MechanismError> {
        let basis = null_space(&f.saddle.dense_jacobian(), f.saddle.columns.len());
        if basis.is_empty() {
            return Ok(Linearized { unbalanced: self.unbalanced_force(f), ..Linearized::default() });
        }
        let reduced = self.reduce(f, &basis);
        if !is_positive(&reduced.mass) {
            return Err(self.missing_mass(f));
        }
        let eigenvalues = eigenvalues(&reduced);
        let mut modes: Vec<(Mode, Vec<[f64; 2]>)> = Vec::with_capacity(eigenvalues.len());
        for (k, &eigenvalue) in eigenvalues.iter().enumerate() {
            let shape = shape_of(&reduced, eigenvalue, k);
            modes.push((mode_of(eigenvalue), self.spread_shape(f, &basis, &shape)));
        }
        let unbalanced = self.unbalanced_force(f);
        f.modes = modes;
        Ok(Linearized { freedom: basis.len(), modes: f.modes.iter().map(|m| m.0.clone()).collect(), unbalanced })
    }

    /// Masses times the accelerations of the machine let go here.
    fn unbalanced_force(&self, f: &Flight<S>) -> f64 {
        let mut force = vec![0.0; self.mech.nv];
        for (&(i, j), m) in f.mass.entries.iter().zip(&f.mass.values) {
            force[i] += m * self.a[j];
            if i != j {
                force[j] += m * self.a[i];
            }
        }
        f.saddle.columns.iter().fold(0.0, |most: f64, &v| most.max(force[v].abs()))
    }

    fn reduce(&self, f: &Flight<S>, basis: &[Vec<f64>]) -> Reduced {
        let (nv, columns) = (self.mech.nv, &f.saddle.columns);
        let scaled = |of: &[f64]| -> Matrix {
            let entry = |i: usize, j: usize| of[columns[i] * nv + columns[j]] * f.saddle.unit(i) * f.saddle.unit(j);
            (0..columns.len()).map(|i| (0..columns.len()).map(|j| entry(i, j)).collect()).collect()
        };
        let mut mass = f.saddle.dense_masses();
        mass.iter_mut().flatten().for_each(|m| *m *= f.saddle.mass_scale());
        Reduced {
            mass: project(&mass, basis),
            damping: project(&scaled(&f.jacobian.damping), basis),
            stiffness: project(&scaled(&f.jacobian.stiffness), basis),
        }
    }

    /// A shape over the basis as velocity components; the largest is 1.
    fn spread_shape(&self, f: &Flight<S>, basis: &[Vec<f64>], shape: &[[f64; 2]]) -> Vec<[f64; 2]> {
        let mut all = vec![[0.0; 2]; self.mech.nv];
        let (mut largest, mut unit) = (0.0, [1.0, 0.0]);
        for (i, &v) in f.saddle.columns.iter().enumerate() {
            let sum = |part: usize| basis.iter().zip(shape).map(|(b, s)| b[i] * s[part]).sum::<f64>();
            let scaled = [sum(0), sum(1)];
            all[v] = scaled.map(|x| x * f.saddle.unit(i));
            let size = scaled[0].hypot(scaled[1]);
            if size > largest * (1.0 + 1e-9) {
                (largest, unit) = (size, all[v]);
            }
        }
        let square = unit[0] * unit[0] + unit[1] * unit[1];
        for z in &mut all {
            *z = [(z[0] * unit[0] + z[1] * unit[1]) / square, (z[1] * unit[0] - z[0] * unit[1]) / square];
        }
        all
    }

    pub(crate) fn put_mode(&mut self, mode: usize, phase: f64) {
        let Some(flight) = self.flight.take() else { return };
        if let Some((_, shape)) = flight.modes.get(mode) {
            let (s, c) = phase.sin_cos();
            self.v.iter_mut().zip(shape).for_each(|(v, z)| *v = z[0] * c - z[1] * s);
            self.a.fill(0.0);
            kinematics::velocities(&self.mech, &self.v, &mut self.x);
            kinematics::accelerations(&self.mech, &self.v, Some(&self.a), &mut self.x);
        }
        self.flight = Some(flight);
    }
}

/// Orthonormal vectors that the rows of `a` annihilate.
fn null_space(a: &Matrix, columns: usize) -> Vec<Vec<f64>> {
    let mut square = a.clone();
    square.resize(a.len().max(columns), vec![0.0; columns]);
    let Some(svd) = dense::svd(&square, columns) else { return Vec::new() };
    let top = svd.values.first().copied().unwrap_or(0.0);
    svd.values.iter().zip(&svd.right).filter(|(s, _)| **s <= RANK * top).map(|(_, r)| r.clone()).collect()
}

/// `Zᵀ A Z`.
fn project(a: &Matrix, basis: &[Vec<f64>]) -> Matrix {
    let times =
        |z: &Vec<f64>| -> Vec<f64> { a.iter().map(|row| row.iter().zip(z).map(|(a, z)| a * z).sum()).collect() };
    let images: Vec<Vec<f64>> = basis.iter().map(times).collect();
    let dot = |a: &[f64], b: &[f64]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    basis.iter().map(|z| images.iter().map(|image| dot(z, image)).collect()).collect()
}

fn is_positive(mass: &Matrix) -> bool {
    let Some((values, _)) = dense::symmetric_eigen(mass) else { return false };
    let top = values.iter().fold(0.0, |m: f64, v| m.max(v.abs()));
    values.iter().all(|v| *v > 1e-12 * top)
}

/// Eigenvalues of the companion matrix `[0 1; −M⁻¹K −M⁻¹C]`, slowest first, one of each conjugate pair.
fn eigenvalues(reduced: &Reduced) -> Vec<[f64; 2]> {
    let n = reduced.mass.len();
    let mut a = vec![vec![0.0; 2 * n]; 2 * n];
    for j in 0..n {
        a[j][n + j] = 1.0;
        for (matrix, at) in [(&reduced.stiffness, j), (&reduced.damping, n + j)] {
            let column: Vec<f64> = (0..n).map(|i| -matrix[i][j]).collect();
            if let Some(solved) = dense::solve(&reduced.mass, &column) {
                solved.iter().enumerate().for_each(|(i, x)| a[n + i][at] = *x);
            }
        }
    }
    let mut found: Vec<[f64; 2]> = dense::eigenvalues(&a).into_iter().map(|(re, im)| [re, im]).collect();
    let top = found.iter().fold(0.0, |m: f64, e| m.max(e[0].hypot(e[1])));
    for e in &mut found {
        if e[0].hypot(e[1]) < STILL * top {
            *e = [0.0, 0.0];
        }
        // The real part of an undamped oscillation is rounding.
        if e[0].abs() < 1e-12 * e[1].abs() {
            e[0] = 0.0;
        }
    }
    found.sort_by(|a, b| a[0].hypot(a[1]).total_cmp(&b[0].hypot(b[1])).then(b[1].total_cmp(&a[1])));
    keep_one_of_each(&found)
}

/// Of conjugate pairs and of the two zeros of a free motion one stays.
fn keep_one_of_each(found: &[[f64; 2]]) -> Vec<[f64; 2]> {
    let zeros = found.iter().filter(|e| **e == [0.0, 0.0]).count();
    let rest = found.iter().filter(|e| **e != [0.0, 0.0] && e[1] >= 0.0).copied();
    std::iter::repeat_n([0.0, 0.0], zeros.div_ceil(2)).chain(rest).collect()
}

fn mode_of(eigenvalue: [f64; 2]) -> Mode {
    let size = eigenvalue[0].hypot(eigenvalue[1]);
    let damping = if size > 0.0 { -eigenvalue[0] / size } else { 0.0 };
    Mode { eigenvalue, frequency: size / std::f64::consts::TAU, damping }
}

/// The vector that `λ² M + λ C + K` annihilates, by inverse iteration.
fn shape_of(reduced: &Reduced, [re, im]: [f64; 2], k: usize) -> Vec<[f64; 2]> {
    let n = reduced.mass.len();
    // Beside the eigenvalue the matrix can be solved.
    let nudge = 1e-9 * re.hypot(im).max(1e-6);
    let (re, im) = (re + nudge, im + 0.37 * nudge);
    let (square_re, square_im) = (re * re - im * im, 2.0 * re * im);
    let mut a = vec![vec![0.0; 2 * n]; 2 * n];
    for i in 0..n {
        for j in 0..n {
            let (m, c, s) = (reduced.mass[i][j], reduced.damping[i][j], reduced.stiffness[i][j]);
            let (x, y) = (square_re * m + re * c + s, square_im * m + im * c);
            (a[i][j], a[n + i][n + j], a[i][n + j], a[n + i][j]) = (x, x, -y, y);
        }
    }
    // Another beginning for each mode: equal frequencies have different shapes.
    let mut shape: Vec<f64> =
        (0..2 * n).map(|i| if i < n { ((i * 7 + k * 13 + 1) as f64).sin() } else { 0.0 }).collect();
    for _ in 0..4 {
        let Some(next) = dense::solve(&a, &shape) else { break };
        let size = next.iter().map(|x| x * x).sum::<f64>().sqrt();
        shape = next.iter().map(|x| x / size).collect();
    }
    (0..n).map(|i| [shape[i], shape[n + i]]).collect()
}
