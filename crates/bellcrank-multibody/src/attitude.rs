//! Roll, pitch and yaw against angular velocity: `R = Rz(yaw) Ry(pitch) Rx(roll)`.
//!
//! In the axes of the fixed frame `ω = yaẇ ẑ + pitcḣ Rz ŷ + roll̇ Rz Ry x̂`.

use bellcrank_math::Real;

/// Angular velocity and acceleration (components in the first frame) from angles and their derivatives.
pub(crate) fn spin_of_rpy<T: Real>(rpy: &[T; 3], rate: &[T; 3], accel: &[T; 3]) -> ([T; 3], [T; 3]) {
    let ((sp, cp), (sy, cy)) = (rpy[1].sin_cos(), rpy[2].sin_cos());
    let [r, p, y] = *rate;
    let [r2, p2, y2] = *accel;
    let w = [r * cy * cp - p * sy, r * sy * cp + p * cy, y - r * sp];
    let wd = [
        r2 * cy * cp - p2 * sy - r * (y * sy * cp + p * cy * sp) - p * y * cy,
        r2 * sy * cp + p2 * cy + r * (y * cy * cp - p * sy * sp) - p * y * sy,
        y2 - r2 * sp - r * p * cp,
    ];
    (w, wd)
}

/// Rates and accelerations of the angles from angular velocity and acceleration; infinite at pitch ±90°.
pub(crate) fn rpy_rates<T: Real>(rpy: &[T; 3], w: &[T; 3], wd: &[T; 3]) -> [(T, T); 3] {
    let ((sp, cp), (sy, cy)) = (rpy[1].sin_cos(), rpy[2].sin_cos());
    let unmix = |w: &[T; 3]| {
        let r = (w[0] * cy + w[1] * sy) / cp;
        [r, w[1] * cy - w[0] * sy, w[2] + r * sp]
    };
    let rate = unmix(w);
    let zero = [T::zero(); 3];
    let (_, bias) = spin_of_rpy(rpy, &rate, &zero);
    let accel = unmix(&std::array::from_fn(|i| wd[i] - bias[i]));
    std::array::from_fn(|i| (rate[i], accel[i]))
}

/// Into −π..π.
pub(crate) fn wrap(angle: f64) -> f64 {
    let turn = std::f64::consts::TAU;
    angle - turn * (angle / turn).round()
}

/// Rotation vector (rad, axes of the frame that `r` turns) of a rotation matrix given by rows.
pub(crate) fn rotation_vector(r: &[[f64; 3]; 3]) -> [f64; 3] {
    let q = bellcrank_math::quaternion_from_matrix(r);
    let s = (q[1] * q[1] + q[2] * q[2] + q[3] * q[3]).sqrt();
    let w = if q[0] < 0.0 { -1.0 } else { 1.0 };
    let angle = 2.0 * s.atan2(q[0] * w);
    let k = if s > 1e-300 { angle / s * w } else { 2.0 * w };
    [q[1] * k, q[2] * k, q[3] * k]
}

/// Unit quaternion of a rotation vector, rad.
pub(crate) fn quaternion_of<T: Real>(v: &[T; 3]) -> [T; 4] {
    let square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    let half = T::from_f64(0.5);
    // Series below 1e-8 rad keeps derivatives finite at zero.
    let (w, k) = if square.value() < 1e-16 {
        (T::one() - square * T::from_f64(0.125), half)
    } else {
        let angle = square.sqrt();
        let (s, c) = (angle * half).sin_cos();
        (c, s / angle)
    };
    [w, v[0] * k, v[1] * k, v[2] * k]
}

/// Hamilton product.
pub(crate) fn quaternion_product<T: Real>(a: &[T; 4], b: &[T; 4]) -> [T; 4] {
    [
        a[0] * b[0] - a[1] * b[1] - a[2] * b[2] - a[3] * b[3],
        a[0] * b[1] + a[1] * b[0] + a[2] * b[3] - a[3] * b[2],
        a[0] * b[2] - a[1] * b[3] + a[2] * b[0] + a[3] * b[1],
        a[0] * b[3] + a[1] * b[2] - a[2] * b[1] + a[3] * b[0],
    ]
}

/// Scales to unit length.
pub(crate) fn normalize<T: Real>(q: &mut [T]) {
    let n = q.iter().fold(T::zero(), |s, x| s + *x * *x).sqrt();
    q.iter_mut().for_each(|x| *x = *x / n);
}

#[cfg(test)]
mod tests {
    use super::*;
    use bellcrank_math::matrix_from_rpy;

    #[test]
    fn spin_is_the_derivative_of_the_rotation() {
        let (a, b, c) = ([0.3, -0.8, 1.9], [0.7, 0.4, -1.1], [0.2, -0.5, 0.9]);
        let rpy = |t: f64| -> [f64; 3] { std::array::from_fn(|i| a[i] + b[i] * t + 0.5 * c[i] * t * t) };
        let h = 1e-5;
        let turn = |t0: f64, t1: f64| {
            let (m, n) = (matrix_from_rpy(&rpy(t0)), matrix_from_rpy(&rpy(t1)));
            let r: [[f64; 3]; 3] =
                std::array::from_fn(|i| std::array::from_fn(|j| (0..3).map(|k| n[i][k] * m[j][k]).sum()));
            rotation_vector(&r)
        };
        let (w, wd) = spin_of_rpy(&a, &b, &c);
        let (ahead, behind) = (turn(0.0, h), turn(-h, 0.0));
        for i in 0..3 {
            assert!(((ahead[i] + behind[i]) / (2.0 * h) - w[i]).abs() < 1e-8);
            assert!(((ahead[i] - behind[i]) / (h * h) - wd[i]).abs() < 1e-4);
        }
        let back = rpy_rates(&a, &w, &wd);
        for i in 0..3 {
            assert!((back[i].0 - b[i]).abs() < 1e-14 && (back[i].1 - c[i]).abs() < 1e-13);
        }
    }
}
