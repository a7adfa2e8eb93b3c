//! Integrals of places and shapes over the mass of a flexible body: all that its motion needs to know of its mass.

use bellcrank_math::Real;

/// Integrals over the mass, about the origin of the body and in its axes. x is the place in the undeformed body, φ_e
/// the displacement by coordinate e of n.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct ShapeIntegrals<T = f64> {
    /// `∫ dm`, kg.
    pub mass: T,
    /// `∫ x dm`, kg·m.
    pub first: [T; 3],
    /// `∫ x xᵀ dm`, kg·m² (not the inertia tensor, which is its trace times 1 less it).
    pub second: [[T; 3]; 3],
    /// `∫ φ_e dm`, n of them.
    pub flow: Vec<[T; 3]>,
    /// `∫ x φ_eᵀ dm`, n of them: row by x, column by φ.
    pub placed: Vec<[[T; 3]; 3]>,
    /// `∫ φ_e φ_fᵀ dm` at e·n + f.
    pub products: Vec<[[T; 3]; 3]>,
}

impl<T: Real> ShapeIntegrals<T> {
    /// No mass yet, n coordinates.
    pub fn zero(n: usize) -> Self {
        let (flow, placed, products) =
            (vec![[T::zero(); 3]; n], vec![[[T::zero(); 3]; 3]; n], vec![[[T::zero(); 3]; 3]; n * n]);
        Self { flow, placed, products, ..Self::default() }
    }

    /// Number of coordinates n.
    pub fn coordinates(&self) -> usize {
        self.flow.len()
    }

    /// Mass `dm` at x that moves by φ: any number of these sums up to the integrals.
    pub fn add(&mut self, dm: T, x: &[T; 3], phi: &[[T; 3]]) {
        self.mass += dm;
        add_scaled(&mut self.first, dm, x);
        for (flow, phi_e) in self.flow.iter_mut().zip(phi) {
            add_scaled(flow, dm, phi_e);
        }
        self.add_spread(dm, x, phi);
    }

    /// Second moment `j` of mass that lies evenly on both sides of where it was added, along `x`, and moves by φ for each
    /// unit of distance: adds to the integrals of second order only.
    pub(crate) fn add_spread(&mut self, j: T, x: &[T; 3], phi: &[[T; 3]]) {
        let n = self.coordinates();
        add_outer(&mut self.second, j, x, x);
        for (e, phi_e) in phi.iter().enumerate() {
            add_outer(&mut self.placed[e], j, x, phi_e);
            for (f, phi_f) in phi.iter().enumerate() {
                add_outer(&mut self.products[e * n + f], j, phi_e, phi_f);
            }
        }
    }

    /// `M_ef = ∫ φ_e · φ_f dm`, n × n by rows.
    pub fn mass_matrix(&self) -> Vec<T> {
        self.products.iter().map(|p| p[0][0] + p[1][1] + p[2][2]).collect()
    }
}

fn add_scaled<T: Real>(sum: &mut [T; 3], factor: T, v: &[T; 3]) {
    (0..3).for_each(|i| sum[i] += factor * v[i]);
}

fn add_outer<T: Real>(sum: &mut [[T; 3]; 3], factor: T, a: &[T; 3], b: &[T; 3]) {
    for i in 0..3 {
        add_scaled(&mut sum[i], factor * a[i], b);
    }
}
