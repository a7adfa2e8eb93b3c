//! A place and an orientation.

use crate::{Space, Vector};

/// Pose of a frame F in a frame W: `R` turns F-components into W-components, `p` is the origin of F
/// in W, in m. Called `X_WF` where it stands.
#[derive(Clone, Copy, Debug)]
pub struct Frame<S: Space> {
    /// Rotation `R_WF`.
    pub rotation: S::Rotation,
    /// Origin `p_WF`, m.
    pub origin: S::Vector,
}

impl<S: Space> Frame<S> {
    /// F coincides with W.
    pub fn identity() -> Self {
        Self { rotation: S::identity(), origin: S::Vector::default() }
    }
    /// `X_WG = X_WF X_FG`.
    #[inline(always)]
    pub fn then(&self, inner: &Self) -> Self {
        Self { rotation: S::compose(&self.rotation, &inner.rotation), origin: self.at(inner.origin) }
    }
    /// `X_FW`.
    pub fn inverse(&self) -> Self {
        let rotation = S::transpose(&self.rotation);
        Self { origin: -S::rotate(&rotation, self.origin), rotation }
    }
    /// Place in W of a point given in F, m.
    #[inline(always)]
    pub fn at(&self, p_f: S::Vector) -> S::Vector {
        self.origin + S::rotate(&self.rotation, p_f)
    }
    /// From a place and a 3×3 rotation in space; the plane keeps x, y and the turn about z.
    pub fn from_spatial(position: &[S::T; 3], rotation: &[[S::T; 3]; 3]) -> Self {
        Self { rotation: S::from_matrix(rotation), origin: S::vector(position) }
    }
    /// Place and rotation in space; z is 0 for the plane.
    pub fn to_spatial(&self) -> ([S::T; 3], [[S::T; 3]; 3]) {
        (S::spread(self.origin), S::to_matrix(&self.rotation))
    }
}

/// Turning components as three, for output: the plane's one becomes (0, 0, z).
pub(crate) fn spread_angular<T: crate::Real, const N: usize>(w: Vector<T, N>) -> [T; 3] {
    std::array::from_fn(|i| if i + N >= 3 { w.0[i + N - 3] } else { T::zero() })
}
