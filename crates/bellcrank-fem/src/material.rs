//! Linear elastic materials.

use bellcrank_math::linalg::dense;

/// Components of stress and strain in the order xx, yy, zz, xy, yz, zx; shear strains are the engineering ones.
pub type Six = [f64; 6];

/// A linear elastic material in the axes of the mesh; SI.
#[derive(Clone, Debug, PartialEq)]
pub struct Material {
    /// σ = D ε, Pa.
    pub stiffness: [Six; 6],
    /// kg/m³.
    pub density: f64,
    /// Thermal strain a kelvin along x, y, z.
    pub expansion: [f64; 3],
}

/// Why numbers make no material.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MaterialFault {
    /// A modulus that is not positive: its place (E1, E2, E3, G12, G23, G13).
    Modulus(usize),
    /// Poisson's ratio of exactly one half: the material keeps its volume and the stiffness has no value.
    Incompressible,
    /// Poisson's ratio not between -1 and 1/2.
    Poisson(f64),
    /// An orthotropic set whose elastic energy would not be positive: the smallest eigenvalue of its normalized
    /// compliance.
    Unstable(f64),
    /// A density that is negative or not a number.
    Density(f64),
}

impl Material {
    /// The same in all directions: Young's modulus in Pa, Poisson's ratio, density in kg/m³.
    ///
    /// # Errors
    /// What is wrong with the numbers.
    pub fn isotropic(young: f64, poisson: f64, density: f64) -> Result<Self, MaterialFault> {
        if poisson == 0.5 {
            return Err(MaterialFault::Incompressible);
        }
        if !(poisson > -1.0 && poisson < 0.5) {
            return Err(MaterialFault::Poisson(poisson));
        }
        let shear = young / (2.0 * (1.0 + poisson));
        Self::orthotropic([young; 3], [poisson; 3], [shear; 3], density)
    }

    /// Three planes of symmetry, along the axes: E1, E2, E3; ν12, ν23, ν13 (strain along the second for stress along
    /// the first, so ν21 = ν12 E2/E1); G12, G23, G13. Source: Jones, "Mechanics of Composite Materials", 2nd ed., 2.4.
    ///
    /// # Errors
    /// What is wrong with the numbers.
    pub fn orthotropic(e: [f64; 3], nu: [f64; 3], g: [f64; 3], density: f64) -> Result<Self, MaterialFault> {
        if let Some(place) = e.iter().chain(&g).position(|modulus| !(*modulus > 0.0 && modulus.is_finite())) {
            return Err(MaterialFault::Modulus(place));
        }
        if !(density >= 0.0 && density.is_finite()) {
            return Err(MaterialFault::Density(density));
        }
        let normal = normal_stiffness(e, nu)?;
        let mut stiffness = [[0.0; 6]; 6];
        for row in 0..3 {
            stiffness[row][..3].copy_from_slice(&normal[row]);
            stiffness[3 + row][3 + row] = g[row];
        }
        Ok(Self { stiffness, density, expansion: [0.0; 3] })
    }

    /// With thermal strains a kelvin along x, y, z.
    pub fn with_expansion(self, expansion: [f64; 3]) -> Self {
        Self { expansion, ..self }
    }

    /// The material whose own axes lie in the mesh as the columns of a rotation.
    pub fn rotated(&self, axes: &[[f64; 3]; 3]) -> Self {
        let t = strain_rotation(axes);
        let mut stiffness = [[0.0; 6]; 6];
        for i in 0..6 {
            for j in 0..6 {
                stiffness[i][j] =
                    (0..6).map(|k| (0..6).map(|l| t[k][i] * self.stiffness[k][l] * t[l][j]).sum::<f64>()).sum();
            }
        }
        // Expansion would gain shears; an equal one has none.
        let expansion = std::array::from_fn(|i| (0..3).map(|k| axes[i][k].powi(2) * self.expansion[k]).sum());
        Self { stiffness, density: self.density, expansion }
    }

    /// σ = D ε.
    pub fn stress(&self, strain: &Six) -> Six {
        std::array::from_fn(|i| (0..6).map(|j| self.stiffness[i][j] * strain[j]).sum())
    }

    /// D⁻¹: the strain of a stress.
    pub fn compliance(&self) -> [Six; 6] {
        let mut inverse = [[0.0; 6]; 6];
        for column in 0..6 {
            let solution = solve(&self.stiffness, std::array::from_fn(|row| f64::from(row == column)));
            (0..6).for_each(|row| inverse[row][column] = solution[row]);
        }
        inverse
    }
}

/// Takes the strains of the mesh's axes to those of the material's.
fn strain_rotation(axes: &[[f64; 3]; 3]) -> [Six; 6] {
    const PAIRS: [[usize; 2]; 6] = [[0, 0], [1, 1], [2, 2], [0, 1], [1, 2], [2, 0]];
    let mut t = [[0.0; 6]; 6];
    for (row, [a, b]) in PAIRS.into_iter().enumerate() {
        for (column, [i, j]) in PAIRS.into_iter().enumerate() {
            let product = axes[i][a] * axes[j][b];
            let swapped = axes[j][a] * axes[i][b];
            t[row][column] = match (row < 3, column < 3) {
                (true, _) => product,
                (false, true) => 2.0 * product,
                (false, false) => product + swapped,
            };
        }
    }
    t
}

/// Gauss and Jordan on a positive definite matrix.
fn solve(matrix: &[Six; 6], rhs: Six) -> Six {
    let (mut a, mut x) = (*matrix, rhs);
    for pivot in 0..6 {
        for row in (0..6).filter(|&row| row != pivot) {
            let factor = a[row][pivot] / a[pivot][pivot];
            (pivot..6).for_each(|column| a[row][column] -= factor * a[pivot][column]);
            x[row] -= factor * x[pivot];
        }
    }
    std::array::from_fn(|i| x[i] / a[i][i])
}

/// The 3 x 3 block of the normal components, from the compliance.
fn normal_stiffness(e: [f64; 3], [n12, n23, n13]: [f64; 3]) -> Result<[[f64; 3]; 3], MaterialFault> {
    // Divided by the square roots of the moduli, so that the eigenvalues are pure numbers.
    let root = e.map(f64::sqrt);
    let off = [n12 * root[1] / root[0], n23 * root[2] / root[1], n13 * root[2] / root[0]];
    let c = [[1.0, -off[0], -off[2]], [-off[0], 1.0, -off[1]], [-off[2], -off[1], 1.0]];
    let rows: Vec<Vec<f64>> = c.iter().map(|row| row.to_vec()).collect();
    let eigen = dense::symmetric_eigen(&rows).map(|(values, _)| values);
    let lowest = eigen.map_or(f64::NAN, |values| values.into_iter().fold(f64::INFINITY, f64::min));
    if lowest.is_nan() || lowest < 1e-12 {
        return Err(MaterialFault::Unstable(lowest));
    }
    let minor = |i: usize, j: usize| {
        let (a, b) = ((i + 1) % 3, (i + 2) % 3);
        let (p, q) = ((j + 1) % 3, (j + 2) % 3);
        c[a][p] * c[b][q] - c[a][q] * c[b][p]
    };
    let determinant: f64 = (0..3).map(|j| c[0][j] * minor(0, j)).sum();
    Ok(std::array::from_fn(|i| std::array::from_fn(|j| root[i] * minor(j, i) / determinant * root[j])))
}

/// Principal stresses, largest first.
pub fn principal(stress: &Six) -> [f64; 3] {
    let [xx, yy, zz, xy, yz, zx] = *stress;
    let mean = (xx + yy + zz) / 3.0;
    let s = [xx - mean, yy - mean, zz - mean];
    let j2 = (s[0] * s[0] + s[1] * s[1] + s[2] * s[2]) / 2.0 + xy * xy + yz * yz + zx * zx;
    if j2 <= 0.0 {
        return [mean; 3];
    }
    let j3 = s[0] * (s[1] * s[2] - yz * yz) - xy * (xy * s[2] - yz * zx) + zx * (xy * yz - s[1] * zx);
    // Lode's angle; the argument leaves [-1, 1] by rounding only.
    let angle = (j3 / 2.0 * (3.0 / j2).powf(1.5)).clamp(-1.0, 1.0).acos() / 3.0;
    let radius = 2.0 * (j2 / 3.0).sqrt();
    let turn = 2.0 * std::f64::consts::PI / 3.0;
    [angle, angle - turn, angle + turn].map(|angle| mean + radius * angle.cos())
}

/// Von Mises' equivalent stress.
pub fn von_mises(stress: &Six) -> f64 {
    let [xx, yy, zz, xy, yz, zx] = *stress;
    let differences = (xx - yy).powi(2) + (yy - zz).powi(2) + (zz - xx).powi(2);
    (differences / 2.0 + 3.0 * (xy * xy + yz * yz + zx * zx)).sqrt()
}
