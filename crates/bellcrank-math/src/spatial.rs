//! Space: x, y and z.

use crate::{Real, Space, Vector};
use std::marker::PhantomData;

/// Three-dimensional space with scalar `T`.
#[derive(Clone, Copy, Debug, Default)]
pub struct Spatial<T>(PhantomData<T>);

/// A 3×3 matrix by its columns: `columns[j][i]` stands in row i, column j.
#[derive(Clone, Copy, Debug, Default)]
pub struct Matrix3<T: Real> {
    /// The three columns.
    pub columns: [Vector<T, 3>; 3],
}

impl<T: Real> Matrix3<T> {
    #[inline(always)]
    fn times(&self, v: Vector<T, 3>) -> Vector<T, 3> {
        self.columns[0] * v[0] + self.columns[1] * v[1] + self.columns[2] * v[2]
    }
    #[inline(always)]
    fn times_transposed(&self, v: Vector<T, 3>) -> Vector<T, 3> {
        Vector([self.columns[0].dot(v), self.columns[1].dot(v), self.columns[2].dot(v)])
    }
    #[inline(always)]
    fn product(&self, o: &Self) -> Self {
        let [x, y, z] = o.columns;
        Self { columns: [self.times(x), self.times(y), self.times(z)] }
    }
    fn transposed(&self) -> Self {
        Self { columns: std::array::from_fn(|j| Vector(std::array::from_fn(|i| self.columns[i][j]))) }
    }
}

/// A symmetric matrix of xx, xy, xz, yy, yz, zz.
#[inline(always)]
fn symmetric<T: Real>([xx, xy, xz, yy, yz, zz]: [T; 6]) -> Matrix3<T> {
    Matrix3 { columns: [Vector([xx, xy, xz]), Vector([xy, yy, yz]), Vector([xz, yz, zz])] }
}

#[inline(always)]
fn cross<T: Real>(a: Vector<T, 3>, b: Vector<T, 3>) -> Vector<T, 3> {
    Vector([a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]])
}

impl<T: Real> Space for Spatial<T> {
    type T = T;
    type With<U: Real> = Spatial<U>;
    type Vector = Vector<T, 3>;
    type Angular = Vector<T, 3>;
    type Rotation = Matrix3<T>;
    type Inertia = Matrix3<T>;
    const DIM: usize = 3;
    const ANG: usize = 3;
    const SLIDE: usize = 2;

    fn identity() -> Matrix3<T> {
        Matrix3 { columns: std::array::from_fn(Vector::unit) }
    }
    #[inline(always)]
    fn compose(a: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
        a.product(b)
    }
    fn transpose(r: &Matrix3<T>) -> Matrix3<T> {
        r.transposed()
    }
    #[inline(always)]
    fn rotate(r: &Matrix3<T>, v: Vector<T, 3>) -> Vector<T, 3> {
        r.times(v)
    }
    #[inline(always)]
    fn rotate_angular(r: &Matrix3<T>, w: Vector<T, 3>) -> Vector<T, 3> {
        r.times(w)
    }
    #[inline(always)]
    fn rotate_back(r: &Matrix3<T>, v: Vector<T, 3>) -> Vector<T, 3> {
        r.times_transposed(v)
    }
    #[inline(always)]
    fn rotate_angular_back(r: &Matrix3<T>, w: Vector<T, 3>) -> Vector<T, 3> {
        r.times_transposed(w)
    }
    #[inline(always)]
    fn along_turn(w: Vector<T, 3>) -> T {
        w[2]
    }
    #[inline(always)]
    fn add_along_turn(w: &mut Vector<T, 3>, k: T) {
        w[2] += k;
    }
    #[inline(always)]
    fn cross_turn(w: Vector<T, 3>, k: T) -> Vector<T, 3> {
        Vector([w[1] * k, -(w[0] * k), T::zero()])
    }
    #[inline(always)]
    fn turn_cross(k: T, r: Vector<T, 3>) -> Vector<T, 3> {
        Vector([-(k * r[1]), k * r[0], T::zero()])
    }
    #[inline(always)]
    fn inertia_turn(j: &Matrix3<T>, k: T) -> Vector<T, 3> {
        j.columns[2] * k
    }
    #[inline(always)]
    fn column(r: &Matrix3<T>, i: usize) -> Vector<T, 3> {
        r.columns[i]
    }
    #[inline(always)]
    fn turn(r: &Matrix3<T>, (s, c): (T, T)) -> Matrix3<T> {
        let [x, y, z] = r.columns;
        Matrix3 { columns: [x * c + y * s, y * c - x * s, z] }
    }
    #[inline(always)]
    fn turn_axis(r: &Matrix3<T>) -> Vector<T, 3> {
        r.columns[2]
    }
    #[inline(always)]
    fn slide_axis(r: &Matrix3<T>) -> Vector<T, 3> {
        r.columns[2]
    }
    #[inline(always)]
    fn cross(w: Vector<T, 3>, r: Vector<T, 3>) -> Vector<T, 3> {
        cross(w, r)
    }
    #[inline(always)]
    fn moment(r: Vector<T, 3>, f: Vector<T, 3>) -> Vector<T, 3> {
        cross(r, f)
    }
    #[inline(always)]
    fn cross_angular(w: Vector<T, 3>, h: Vector<T, 3>) -> Vector<T, 3> {
        cross(w, h)
    }
    #[inline(always)]
    fn apply_inertia(j: &Matrix3<T>, r: &Matrix3<T>, w: Vector<T, 3>) -> Vector<T, 3> {
        r.times(j.times(r.times_transposed(w)))
    }
    #[inline(always)]
    fn inertia_times(j: &Matrix3<T>, w: Vector<T, 3>) -> Vector<T, 3> {
        j.times(w)
    }
    #[inline(always)]
    fn add_inertia(a: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
        let (a, b) = (&a.columns, &b.columns);
        Matrix3 { columns: [a[0] + b[0], a[1] + b[1], a[2] + b[2]] }
    }
    #[inline(always)]
    fn moved_inertia(m: T, h: Vector<T, 3>, r: Vector<T, 3>) -> Matrix3<T> {
        // With s = h + m r the tensor is (r·(h + s)) 1 − r hᵀ − s rᵀ.
        let s = h + r * m;
        let (xx, yy, zz) = (r[0] * (h[0] + s[0]), r[1] * (h[1] + s[1]), r[2] * (h[2] + s[2]));
        let entry = |i: usize, k: usize| -(r[i] * h[k]) - s[i] * r[k];
        symmetric([yy + zz, entry(0, 1), entry(0, 2), xx + zz, entry(1, 2), xx + yy])
    }
    fn vector(v: &[T; 3]) -> Vector<T, 3> {
        Vector(*v)
    }
    fn angular(v: &[T; 3]) -> Vector<T, 3> {
        Vector(*v)
    }
    fn spread(v: Vector<T, 3>) -> [T; 3] {
        v.0
    }
    fn spread_angular(w: Vector<T, 3>) -> [T; 3] {
        w.0
    }
    fn inertia(j: &[[T; 3]; 3]) -> Matrix3<T> {
        Self::from_matrix(j)
    }
    #[inline(always)]
    fn turn_inertia(j: &Matrix3<T>, r: &Matrix3<T>) -> Matrix3<T> {
        // Column k of the result is R J times row k of R; the tensor is symmetric, so six entries are enough.
        let [x, y, z] = r.product(j).columns;
        let entry = |i: usize, k: usize| x[i] * r.columns[0][k] + y[i] * r.columns[1][k] + z[i] * r.columns[2][k];
        symmetric([entry(0, 0), entry(0, 1), entry(0, 2), entry(1, 1), entry(1, 2), entry(2, 2)])
    }
    fn from_matrix(r: &[[T; 3]; 3]) -> Matrix3<T> {
        Matrix3 { columns: std::array::from_fn(|j| Vector(std::array::from_fn(|i| r[i][j]))) }
    }
    fn to_matrix(r: &Matrix3<T>) -> [[T; 3]; 3] {
        std::array::from_fn(|i| std::array::from_fn(|j| r.columns[j][i]))
    }
    fn from_quaternion(q: &[T; 4]) -> Matrix3<T> {
        Self::from_matrix(&matrix_from_quaternion(q))
    }
}

/// Rotation matrix (rows) of a unit quaternion (w, x, y, z).
pub fn matrix_from_quaternion<T: Real>(q: &[T; 4]) -> [[T; 3]; 3] {
    let [w, x, y, z] = *q;
    let (one, two) = (T::one(), T::from_f64(2.0));
    [
        [one - two * (y * y + z * z), two * (x * y - w * z), two * (x * z + w * y)],
        [two * (x * y + w * z), one - two * (x * x + z * z), two * (y * z - w * x)],
        [two * (x * z - w * y), two * (y * z + w * x), one - two * (x * x + y * y)],
    ]
}

/// Rotation matrix (rows) `Rz(yaw) Ry(pitch) Rx(roll)`, angles in rad.
pub fn matrix_from_rpy<T: Real>(rpy: &[T; 3]) -> [[T; 3]; 3] {
    let ((sr, cr), (sp, cp), (sy, cy)) = (rpy[0].sin_cos(), rpy[1].sin_cos(), rpy[2].sin_cos());
    [
        [cy * cp, cy * sp * sr - sy * cr, cy * sp * cr + sy * sr],
        [sy * cp, sy * sp * sr + cy * cr, sy * sp * cr - cy * sr],
        [-sp, cp * sr, cp * cr],
    ]
}

/// (roll, pitch, yaw) in rad with `R = Rz(yaw) Ry(pitch) Rx(roll)`, pitch within ±90°.
pub fn rpy_from_matrix<T: Real>(r: &[[T; 3]; 3]) -> [T; 3] {
    let level = (r[0][0] * r[0][0] + r[1][0] * r[1][0]).sqrt();
    [r[2][1].atan2(r[2][2]), (-r[2][0]).atan2(level), r[1][0].atan2(r[0][0])]
}

/// Unit quaternion (w, x, y, z) of a rotation matrix, by its largest component (Shepperd 1978).
pub fn quaternion_from_matrix(r: &[[f64; 3]; 3]) -> [f64; 4] {
    let trace = r[0][0] + r[1][1] + r[2][2];
    let squares = [trace, r[0][0], r[1][1], r[2][2]];
    let k = (0..4).fold(0, |best, i| if squares[i] > squares[best] { i } else { best });
    let mut q = if k == 0 {
        [1.0 + trace, r[2][1] - r[1][2], r[0][2] - r[2][0], r[1][0] - r[0][1]]
    } else {
        quaternion_by_axis(r, k - 1)
    };
    let n = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    q.iter_mut().for_each(|x| *x /= n);
    q
}

fn quaternion_by_axis(r: &[[f64; 3]; 3], i: usize) -> [f64; 4] {
    let (j, k) = ((i + 1) % 3, (i + 2) % 3);
    let mut q = [0.0; 4];
    q[0] = r[k][j] - r[j][k];
    q[1 + i] = 1.0 + r[i][i] - r[j][j] - r[k][k];
    q[1 + j] = r[i][j] + r[j][i];
    q[1 + k] = r[i][k] + r[k][i];
    q
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn quaternion_and_rpy_return_to_the_same_matrix() {
        for rpy in [[0.3, -0.7, 2.9], [3.0, 0.4, -1.2], [-2.5, 1.1, 0.2], [0.1, -1.2, -3.0]] {
            let r = matrix_from_rpy(&rpy);
            let back = matrix_from_quaternion(&quaternion_from_matrix(&r));
            let again = rpy_from_matrix(&r);
            for i in 0..3 {
                assert!((again[i] - rpy[i]).abs() < 1e-14);
                for j in 0..3 {
                    assert!((back[i][j] - r[i][j]).abs() < 1e-15 * 8.0);
                }
            }
        }
    }

    #[test]
    fn the_plane_is_the_same_algebra_as_space_about_z() {
        use crate::Planar;
        let (a, b) = (0.7_f64, -1.9_f64);
        let s = Spatial::<f64>::turn(&Spatial::turn(&Spatial::identity(), a.sin_cos()), b.sin_cos());
        let p = Planar::<f64>::turn(&Planar::turn(&Planar::identity(), a.sin_cos()), b.sin_cos());
        let v = [0.4, -2.3, 0.0];
        let (rs, rp) = (Spatial::rotate(&s, Vector(v)), Planar::rotate(&p, Planar::vector(&v)));
        assert!((rs[0] - rp[0]).abs() + (rs[1] - rp[1]).abs() < 1e-15);
        let f = [1.3, 0.9, 0.0];
        let n =
            Spatial::moment(Vector(v), Vector(f))[2] - Planar::<f64>::moment(Planar::vector(&v), Planar::vector(&f))[0];
        assert!(n.abs() < 1e-15);
    }
}
