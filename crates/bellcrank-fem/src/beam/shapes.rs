//! How a beam bends when its ends are moved: exact solutions without load between them.
//!
//! Source: J. S. Przemieniecki, *Theory of Matrix Structural Analysis*, McGraw-Hill 1968, 5.6 and 11.

use bellcrank_math::Real;

/// A shape at one place of the axis, in one set of axes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Shape<T> {
    /// u, v, w.
    pub(super) moved: [T; 3],
    /// θ_x, θ_y, θ_z.
    pub(super) turned: [T; 3],
    /// u', γ_y, γ_z, θ_x', θ_y', θ_z'; always in the axes of the beam.
    pub(super) strain: [T; 6],
    /// v', w'; always in the axes of the beam.
    pub(super) slope: [T; 2],
}

/// Bending in one plane: deflection, turn with θ = v' − γ, curvature θ', shear strain γ.
#[derive(Clone, Copy, Debug)]
pub(super) struct Bend<T> {
    pub(super) deflection: T,
    pub(super) turn: T,
    pub(super) curvature: T,
    pub(super) shear: T,
}

impl<T: Real> Bend<T> {
    /// In the plane x–y (`plane` 0), or x–z (1) where a positive turn about y lowers what lies ahead.
    pub(super) fn shape(&self, plane: usize) -> Shape<T> {
        let mut shape = Shape::default();
        shape.moved[1 + plane] = self.deflection;
        shape.strain[1 + plane] = self.shear;
        shape.slope[plane] = self.turn + self.shear;
        let (turn, curvature) = if plane == 0 { (self.turn, self.curvature) } else { (-self.turn, -self.curvature) };
        shape.turned[2 - plane] = turn;
        shape.strain[5 - plane] = curvature;
        shape
    }

    fn negative(&self) -> Self {
        Self { deflection: -self.deflection, turn: -self.turn, curvature: -self.curvature, shear: -self.shear }
    }
}

impl<T: Real> Shape<T> {
    /// Displacement (`what` 0) or turn (1) along the axis.
    pub(super) fn along(what: usize, value: T, slope: T) -> Self {
        let mut shape = Shape::default();
        if what == 0 {
            shape.moved[0] = value
        } else {
            shape.turned[0] = value
        }
        shape.strain[3 * what] = slope;
        shape
    }

    pub(super) fn add(&mut self, factor: T, other: &Self) {
        add(&mut self.moved, factor, &other.moved);
        add(&mut self.turned, factor, &other.turned);
        add(&mut self.strain, factor, &other.strain);
        add(&mut self.slope, factor, &other.slope);
    }

    /// Motion in the axes of the body.
    pub(super) fn placed(&self, axes: &[[T; 3]; 3]) -> Self {
        Self { moved: rotate(axes, &self.moved), turned: rotate(axes, &self.turned), ..*self }
    }
}

fn add<T: Real, const N: usize>(sum: &mut [T; N], factor: T, other: &[T; N]) {
    (0..N).for_each(|i| sum[i] += factor * other[i]);
}

pub(super) fn rotate<T: Real>(axes: &[[T; 3]; 3], v: &[T; 3]) -> [T; 3] {
    std::array::from_fn(|i| axes[i][0] * v[0] + axes[i][1] * v[1] + axes[i][2] * v[2])
}

/// The twelve shapes of the ends at ξ = x/L, in the axes of the beam: displacements and turns of end 1, then of end 2.
pub(super) fn end_shapes<T: Real>(xi: f64, length: T, phi: [T; 2]) -> [Shape<T>; 12] {
    let mut shapes = [Shape::default(); 12];
    let (ahead, slope) = ([1.0 - xi, xi], T::one() / length);
    for end in 0..2 {
        let value = T::from_f64(ahead[end]);
        let slope = if end == 0 { -slope } else { slope };
        shapes[6 * end] = Shape::along(0, value, slope);
        shapes[6 * end + 3] = Shape::along(1, value, slope);
    }
    for plane in 0..2 {
        let [v1, t1, v2, t2] = bends(xi, length, phi[plane]);
        // In the plane x–z the turn of Bend is that about −y.
        let [t1, t2] = if plane == 0 { [t1, t2] } else { [t1.negative(), t2.negative()] };
        for (end, (v, t)) in [(v1, t1), (v2, t2)].into_iter().enumerate() {
            shapes[6 * end + 1 + plane] = v.shape(plane);
            shapes[6 * end + 5 - plane] = t.shape(plane);
        }
    }
    shapes
}

/// Unit deflection and unit turn of end 1, then of end 2.
fn bends<T: Real>(xi: f64, length: T, phi: T) -> [Bend<T>; 4] {
    let share = T::one() / (T::one() + phi);
    // A part of pure bending and one in proportion to Φ.
    let mix = |[bent, sheared]: [f64; 2]| (T::from_f64(bent) + phi * T::from_f64(sheared)) * share;
    let (x, x2, x3) = (xi, xi * xi, xi * xi * xi);
    let steep = 6.0 * (x2 - x);
    let inverse = T::one() / length;
    let unit_deflection = |v: [f64; 2], sign: f64| Bend {
        deflection: mix(v),
        turn: mix([sign * steep, 0.0]) * inverse,
        curvature: mix([sign * (12.0 * x - 6.0), 0.0]) * inverse * inverse,
        shear: mix([0.0, -sign]) * inverse,
    };
    let unit_turn = |v: [f64; 2], t: [f64; 2], curvature: [f64; 2]| Bend {
        deflection: mix(v) * length,
        turn: mix(t),
        curvature: mix(curvature) * inverse,
        shear: mix([0.0, -0.5]),
    };
    [
        unit_deflection([1.0 - 3.0 * x2 + 2.0 * x3, 1.0 - x], 1.0),
        unit_turn([x - 2.0 * x2 + x3, 0.5 * (x - x2)], [1.0 - 4.0 * x + 3.0 * x2, 1.0 - x], [6.0 * x - 4.0, -1.0]),
        unit_deflection([3.0 * x2 - 2.0 * x3, x], -1.0),
        unit_turn([x3 - x2, 0.5 * (x2 - x)], [3.0 * x2 - 2.0 * x, x], [6.0 * x - 2.0, 1.0]),
    ]
}
