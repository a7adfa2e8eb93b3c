//! Answers of a mechanism that was never solved: smooth in one phase, and in the points asked for.

use bellcrank_math::{Real, matrix_from_rpy};
use bellcrank_multibody::{
    BodyId, BodyMotion, Checks, Coordinate, Energy, ForceId, ForceOutput, JointId, PointMotion, Reading, Readings,
    Wrench,
};

pub(super) struct Wave<T>(pub(super) T);

impl<T: Real> Wave<T> {
    /// A number of its own for each `k`.
    fn at(&self, k: usize) -> T {
        let c = T::from_f64;
        // Small, so that differences of the phase are not rounded away.
        let k = (k % 97) as f64 / 10.0;
        (self.0 * c(0.7 + 0.1 * (10.0 * k).cos()) + c(0.3 + k)).sin_cos().0 + c(0.05 * (10.0 * k).sin())
    }

    fn vector(&self, k: usize) -> [T; 3] {
        std::array::from_fn(|i| self.at(3 * k + i))
    }
}

impl<T: Real> Readings<T> for Wave<T> {
    fn time(&self) -> T {
        self.0 + T::from_f64(0.4)
    }
    fn coordinates_of(&self, _: JointId) -> usize {
        0
    }
    fn coordinate(&self, c: Coordinate) -> Reading<T> {
        let [position, velocity, acceleration] = self.vector(7 * c.joint.0 + c.index);
        Reading { position, velocity, acceleration }
    }
    fn point(&self, body: BodyId, at: [T; 3]) -> PointMotion<T> {
        let k = 11 * body.0;
        let moved = |k: usize| std::array::from_fn(|i| self.vector(k)[i] + self.at(k + 5 + i) * at[i]);
        PointMotion { position: moved(k), velocity: moved(k + 1), acceleration: moved(k + 2) }
    }
    fn body(&self, body: BodyId) -> BodyMotion<T> {
        let k = 13 * body.0;
        BodyMotion {
            origin: self.vector(k),
            rotation: matrix_from_rpy(&self.vector(k + 1)),
            omega: self.vector(k + 2),
            alpha: self.vector(k + 3),
            center: self.point(body, self.vector(k + 4)),
        }
    }
    fn reaction(&self, joint: JointId) -> Wrench<T> {
        Wrench { force: self.vector(17 * joint.0), moment: self.vector(17 * joint.0 + 1) }
    }
    fn drive(&self, i: usize) -> T {
        self.at(19 * i)
    }
    fn force(&self, force: ForceId) -> ForceOutput<T> {
        let k = 23 * force.0;
        ForceOutput { length: self.at(k), rate: self.at(k + 1), effort: self.at(k + 2), vector: self.vector(k + 3) }
    }
    fn energy(&self) -> Energy<T> {
        Energy { kinetic: self.at(1), potential: self.at(2) }
    }
    fn checks(&self) -> Checks {
        Checks { closure: 1e-12, balance: 1e-13 }
    }
}
