//! Links: the relative pose of two places, the equations that close loops, and the coordinates measured.
//!
//! A row h(q) = 0 has a wrench (f, n) at the second place's origin P₂: its rate is
//! `ḣ = f·v₂₁ + n·ω₂₁` with the velocity of the second body against the first, taken at P₂. The
//! multiplier λ of the row puts λ(f, n) on the second body and the opposite on the first.

use crate::topology::{Motion, PathEntry, joint_alignment};
use crate::workspace::NodeState;
use crate::{BuildError, JointId, JointKind};
use bellcrank_math::{Components, Frame, Real, Space, rpy_from_matrix};

/// An equation between the two frames of a link (frame axes are those of the alignment).
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum RowKind {
    /// World component i of `p₂ − p₁`.
    Point(usize),
    /// Component of `p₂ − p₁` along axis i of the first frame.
    Along(usize),
    /// Axis a of the first frame stays perpendicular to axis b of the second.
    Perpendicular(usize, usize),
    /// A measured coordinate keeps the link's `held` value.
    Held(Measure),
    /// Advance minus lead times turn of a screw.
    ScrewLead,
}

/// A coordinate read off a link.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Measure {
    /// Turn about z of the first frame; backwards when the flag is set.
    Turn(bool),
    /// Place along axis i of the first frame.
    Slide(usize),
    /// Turn of a screw: whole turns are told by its advance.
    Thread,
    /// Distance of the origins.
    Distance,
    /// Universal joint: angle about z of the first frame.
    Fork,
    /// Universal joint: angle about x of the second frame.
    Yoke,
    /// Roll, pitch or yaw of the second frame in the first.
    Attitude(usize),
    /// Nothing: the joint has no such coordinate.
    None,
}

impl Measure {
    pub(crate) fn is_attitude(self) -> bool {
        matches!(self, Measure::Attitude(_))
    }
    /// Angles wrap; distances do not.
    pub(crate) fn is_angle(self) -> bool {
        matches!(self, Measure::Turn(_) | Measure::Fork | Measure::Yoke | Measure::Attitude(_))
    }
    /// What coordinate `i` of a joint kind is on a link.
    pub(crate) fn of<S: Space>(kind: &JointKind<S::T>, i: usize) -> Self {
        use JointKind as K;
        match (kind, i) {
            (K::Revolute { axis }, 0) => Measure::Turn(S::DIM == 2 && axis[2].value() < 0.0),
            (K::Screw { .. }, 0) => Measure::Thread,
            (K::Cylindrical { .. }, 1) | (K::Planar, 2) => Measure::Turn(false),
            (K::Prismatic { .. } | K::Cylindrical { .. } | K::PointOnLine { .. }, 0) => Measure::Slide(S::SLIDE),
            (K::Universal { .. }, 0) => Measure::Fork,
            (K::Universal { .. }, 1) => Measure::Yoke,
            (K::Spherical, i) => Measure::Attitude(i),
            (K::Planar, i) => Measure::Slide(i),
            (K::Free, 2) if S::DIM == 2 => Measure::Turn(false),
            (K::Free, i) if i < 3 => Measure::Slide(i),
            (K::Free, i) => Measure::Attitude(i - 3),
            (K::Distance { .. }, _) => Measure::Distance,
            _ => Measure::None,
        }
    }
}

/// A joint seen from both of its places.
#[derive(Clone, Debug)]
pub(crate) struct Link<S: Space> {
    pub(crate) joint: JointId,
    /// Node and frame (in node axes) of the first and the second place.
    pub(crate) ends: [(usize, Frame<S>); 2],
    /// Equations; empty for joints of the tree.
    pub(crate) rows: Vec<RowKind>,
    pub(crate) first_row: usize,
    /// Lead a radian of a screw, or the held length of a distance.
    pub(crate) held: S::T,
    pub(crate) path: Vec<PathEntry>,
    /// Velocity component of each degree of freedom on the path.
    pub(crate) columns: Vec<usize>,
    /// Only the origins matter: no axis takes part in the rows.
    pub(crate) points_only: bool,
}

impl<S: Space> Link<S> {
    pub(crate) fn set_path(&mut self, path: Vec<PathEntry>, dofs: impl Fn(usize) -> (usize, usize)) {
        self.path = path.into_iter().filter(|e| dofs(e.node).0 > 0).collect();
        self.columns = self
            .path
            .iter()
            .flat_map(|e| (0..dofs(e.node).0).map(|k| dofs(e.node).1 + k).collect::<Vec<_>>())
            .collect();
        self.points_only = self.rows.iter().all(|r| matches!(r, RowKind::Point(_)));
    }
}

/// Rows of a joint as a constraint, and the aligned frames they refer to.
pub(crate) fn link_of<S: Space>(
    joint: JointId,
    kind: &JointKind<S::T>,
    ends: [(usize, Frame<S>); 2],
) -> Result<Link<S>, BuildError> {
    let (ends, held) = aligned::<S>(joint, kind, ends)?;
    let rows = if S::DIM == 2 { planar_rows(kind) } else { spatial_rows(kind) };
    Ok(Link { joint, ends, rows, first_row: 0, held, path: Vec::new(), columns: Vec::new(), points_only: false })
}

/// The numbers of a link: its places with the axes that the rows refer to, and what it holds.
pub(crate) fn aligned<S: Space>(
    joint: JointId,
    kind: &JointKind<S::T>,
    ends: Ends<S>,
) -> Result<(Ends<S>, S::T), BuildError> {
    let align = alignment::<S>(joint, kind)?;
    let turned = Frame { rotation: align, origin: S::Vector::default() };
    let ends = ends.map(|(node, frame)| (node, frame.then(&turned)));
    let held = match kind {
        JointKind::Distance { length: Some(l) } => *l,
        JointKind::Screw { pitch, .. } => *pitch * S::T::from_f64(0.5 / std::f64::consts::PI),
        _ => S::T::zero(),
    };
    Ok((ends, held))
}

/// Node and frame of the first and the second place.
type Ends<S> = [(usize, Frame<S>); 2];

fn alignment<S: Space>(joint: JointId, kind: &JointKind<S::T>) -> Result<S::Rotation, BuildError> {
    use JointKind as K;
    match kind {
        K::Revolute { axis } | K::Cylindrical { axis } | K::Screw { axis, .. } => {
            joint_alignment::<S>(joint, axis, Motion::Turn)
        }
        K::Prismatic { axis } | K::PointOnLine { axis } => joint_alignment::<S>(joint, axis, Motion::Slide),
        K::Universal { axis, axis2 } => Ok(fork_frame::<S>(axis, axis2)),
        _ => Ok(S::identity()),
    }
}

/// z along the first axis, x along the second (checked perpendicular before).
fn fork_frame<S: Space>(axis: &[S::T; 3], axis2: &[S::T; 3]) -> S::Rotation {
    let unit = |a: &[S::T; 3]| {
        let n = (a[0] * a[0] + a[1] * a[1] + a[2] * a[2]).sqrt();
        a.map(|x| x / n)
    };
    let (z, x) = (unit(axis), unit(axis2));
    let y = [z[1] * x[2] - z[2] * x[1], z[2] * x[0] - z[0] * x[2], z[0] * x[1] - z[1] * x[0]];
    S::from_matrix(&std::array::from_fn(|i| [x[i], y[i], z[i]]))
}

const PARALLEL_Z: [RowKind; 2] = [RowKind::Perpendicular(0, 2), RowKind::Perpendicular(1, 2)];
const NO_TURN: [RowKind; 3] =
    [RowKind::Perpendicular(1, 2), RowKind::Perpendicular(2, 0), RowKind::Perpendicular(0, 1)];
const POINT: [RowKind; 3] = [RowKind::Point(0), RowKind::Point(1), RowKind::Point(2)];
const ON_Z: [RowKind; 2] = [RowKind::Along(0), RowKind::Along(1)];

fn spatial_rows<T>(kind: &JointKind<T>) -> Vec<RowKind> {
    use JointKind as K;
    match kind {
        K::Revolute { .. } => [&POINT[..], &PARALLEL_Z].concat(),
        K::Prismatic { .. } => [&ON_Z[..], &NO_TURN].concat(),
        K::Cylindrical { .. } => [&ON_Z[..], &PARALLEL_Z].concat(),
        K::Screw { .. } => [&ON_Z[..], &PARALLEL_Z, &[RowKind::ScrewLead]].concat(),
        K::Universal { .. } => [&POINT[..], &[RowKind::Perpendicular(2, 0)]].concat(),
        K::Spherical => POINT.to_vec(),
        K::Planar => [&[RowKind::Along(2)][..], &PARALLEL_Z].concat(),
        K::Weld => [&POINT[..], &NO_TURN].concat(),
        K::Distance { length: Some(_) } => vec![RowKind::Held(Measure::Distance)],
        K::PointOnLine { .. } => ON_Z.to_vec(),
        K::Free | K::Elastic | K::Modes { .. } | K::Distance { length: None } | K::Coupler { .. } => Vec::new(),
    }
}

fn planar_rows<T>(kind: &JointKind<T>) -> Vec<RowKind> {
    use JointKind as K;
    match kind {
        K::Revolute { .. } => POINT[..2].to_vec(),
        K::Prismatic { .. } => vec![RowKind::Along(1), RowKind::Perpendicular(0, 1)],
        K::Weld => vec![RowKind::Point(0), RowKind::Point(1), RowKind::Perpendicular(0, 1)],
        K::Distance { length: Some(_) } => vec![RowKind::Held(Measure::Distance)],
        K::PointOnLine { .. } => vec![RowKind::Along(1)],
        _ => Vec::new(),
    }
}

/// A row's or coordinate's value and its wrench at P₂, world axes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Gradient<S: Space> {
    pub(crate) value: S::T,
    pub(crate) f: S::Vector,
    pub(crate) n: S::Angular,
}

/// Both frames of a link in the world.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkPose<S: Space> {
    pub(crate) R: [S::Rotation; 2],
    pub(crate) p: [S::Vector; 2],
    pub(crate) d: S::Vector,
}

/// Motion of both frames: angular velocity and acceleration, velocity and acceleration of the origins.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LinkMotion<S: Space> {
    w: [S::Angular; 2],
    wd: [S::Angular; 2],
    d_dot: S::Vector,
    d_ddot: S::Vector,
}

impl<S: Space> Link<S> {
    #[inline]
    pub(crate) fn pose(&self, nodes: &[NodeState<S>]) -> LinkPose<S> {
        let [a, b] = &self.ends;
        let (x, y) = (&nodes[a.0], &nodes[b.0]);
        let p = [x.p + S::rotate(&x.R, a.1.origin), y.p + S::rotate(&y.R, b.1.origin)];
        let R = [S::compose(&x.R, &a.1.rotation), S::compose(&y.R, &b.1.rotation)];
        LinkPose { R, p, d: p[1] - p[0] }
    }
    /// Like [`Link::pose`] where no axis is asked for.
    #[inline]
    pub(crate) fn points(&self, nodes: &[NodeState<S>]) -> [S::Vector; 2] {
        let [a, b] = &self.ends;
        let (x, y) = (&nodes[a.0], &nodes[b.0]);
        [x.p + S::rotate(&x.R, a.1.origin), y.p + S::rotate(&y.R, b.1.origin)]
    }

    /// A pose good enough for the link's own rows: axes are left out where no row reads them.
    #[inline]
    pub(crate) fn pose_for_rows(&self, nodes: &[NodeState<S>]) -> LinkPose<S> {
        if !self.points_only {
            return self.pose(nodes);
        }
        let p = self.points(nodes);
        LinkPose { R: [S::identity(), S::identity()], p, d: p[1] - p[0] }
    }

    #[inline]
    pub(crate) fn motion(&self, nodes: &[NodeState<S>], pose: &LinkPose<S>) -> LinkMotion<S> {
        let n = [&nodes[self.ends[0].0], &nodes[self.ends[1].0]];
        let at = [n[0].at(pose.p[0]), n[1].at(pose.p[1])];
        LinkMotion { w: [n[0].w, n[1].w], wd: [n[0].wd, n[1].wd], d_dot: at[1].0 - at[0].0, d_ddot: at[1].1 - at[0].1 }
    }

    #[inline]
    pub(crate) fn row(&self, kind: RowKind, x: &LinkPose<S>) -> Gradient<S> {
        match kind {
            RowKind::Point(i) => Gradient { value: x.d[i], f: basis::<S>(i), n: S::Angular::default() },
            RowKind::Along(i) => x.slide(i),
            RowKind::Perpendicular(a, b) => x.perpendicular(a, b),
            RowKind::Held(m) => {
                let g = self.measure(m, x);
                Gradient { value: g.value - self.held, ..g }
            }
            RowKind::ScrewLead => {
                let (s, t) = (x.slide(2), self.measure(Measure::Thread, x));
                Gradient { value: s.value - self.held * t.value, f: s.f, n: t.n * -self.held }
            }
        }
    }

    pub(crate) fn measure(&self, measure: Measure, x: &LinkPose<S>) -> Gradient<S> {
        match measure {
            Measure::Turn(false) => x.turn(),
            Measure::Turn(true) => {
                let g = x.turn();
                Gradient { value: -g.value, f: g.f, n: -g.n }
            }
            Measure::Thread => {
                let (s, t) = (x.slide(2), x.turn());
                Gradient { value: nearest_turn(t.value, (s.value / self.held).value()), ..t }
            }
            Measure::Slide(i) => x.slide(i),
            Measure::Distance => x.distance(),
            Measure::Fork => x.fork(),
            Measure::Yoke => x.yoke(),
            Measure::Attitude(i) => x.attitude(i),
            Measure::None => Gradient { value: S::T::zero(), f: S::Vector::default(), n: S::Angular::default() },
        }
    }

    /// First and second time derivative of a row, with the accelerations that `m` holds.
    #[inline]
    pub(crate) fn row_rates(&self, kind: RowKind, x: &LinkPose<S>, m: &LinkMotion<S>) -> (S::T, S::T) {
        match kind {
            RowKind::Point(i) => (m.d_dot[i], m.d_ddot[i]),
            RowKind::Along(i) => m.slide_rates(x, i),
            RowKind::Perpendicular(a, b) => m.perpendicular_rates(x, a, b),
            RowKind::Held(k) => self.measure_rates(k, x, m),
            RowKind::ScrewLead => {
                let (s, t) = (m.slide_rates(x, 2), m.turn_rates(x));
                (s.0 - self.held * t.0, s.1 - self.held * t.1)
            }
        }
    }

    pub(crate) fn measure_rates(&self, measure: Measure, x: &LinkPose<S>, m: &LinkMotion<S>) -> (S::T, S::T) {
        match measure {
            Measure::Turn(false) | Measure::Thread | Measure::Fork => m.turn_rates(x),
            Measure::Turn(true) => {
                let t = m.turn_rates(x);
                (-t.0, -t.1)
            }
            Measure::Slide(i) => m.slide_rates(x, i),
            Measure::Distance => m.distance_rates(x),
            Measure::Yoke => m.yoke_rates(x),
            Measure::Attitude(i) => m.attitude_rates(x)[i],
            Measure::None => (S::T::zero(), S::T::zero()),
        }
    }
}

/// The angle plus whole turns that comes nearest to `wanted`: a screw's advance counts its turns.
fn nearest_turn<T: Real>(angle: T, wanted: f64) -> T {
    let turns = ((wanted - angle.value()) / std::f64::consts::TAU).round();
    if turns.is_finite() { angle + T::from_f64(turns * std::f64::consts::TAU) } else { angle }
}

fn basis<S: Space>(i: usize) -> S::Vector {
    let mut e = S::Vector::default();
    e[i] = S::T::one();
    e
}

impl<S: Space> LinkPose<S> {
    fn slide(&self, i: usize) -> Gradient<S> {
        let u = S::column(&self.R[0], i);
        Gradient { value: u.dot(self.d), f: u, n: S::Angular::default() }
    }
    fn perpendicular(&self, a: usize, b: usize) -> Gradient<S> {
        let (u, w) = (S::column(&self.R[0], a), S::column(&self.R[1], b));
        Gradient { value: u.dot(w), f: S::Vector::default(), n: S::moment(w, u) }
    }
    fn turn(&self) -> Gradient<S> {
        let (x1, y1, x2) = (S::column(&self.R[0], 0), S::column(&self.R[0], 1), S::column(&self.R[1], 0));
        Gradient { value: y1.dot(x2).atan2(x1.dot(x2)), f: S::Vector::default(), n: S::turn_axis(&self.R[0]) }
    }
    fn distance(&self) -> Gradient<S> {
        let l = self.d.dot(self.d).sqrt();
        let inverse = if l.value() > 0.0 { S::T::one() / l } else { S::T::zero() };
        Gradient { value: l, f: self.d * inverse, n: S::Angular::default() }
    }
    /// `R₁₂ = Rz(θ₁) Rx(θ₂)`: x₂ lies at θ₁ in the first frame.
    fn fork(&self) -> Gradient<S> {
        self.turn()
    }
    fn yoke(&self) -> Gradient<S> {
        let (z1, y2) = (S::column(&self.R[0], S::DIM - 1), S::column(&self.R[1], 1));
        let z2 = S::column(&self.R[1], S::DIM - 1);
        let axis = S::column(&self.R[1], 0);
        let n = S::angular(&S::spread(axis));
        Gradient { value: z1.dot(y2).atan2(z1.dot(z2)), f: S::Vector::default(), n }
    }
    /// The value is roll, pitch or yaw; the wrench turns about x, y or z of the first frame, so that three
    /// of them prescribe the angular velocity.
    fn attitude(&self, i: usize) -> Gradient<S> {
        let rpy = rpy_from_matrix(&self.relative());
        let n = S::angular(&S::spread(S::column(&self.R[0], i.min(S::DIM - 1))));
        Gradient { value: rpy[i], f: S::Vector::default(), n }
    }
    /// `R₁₂`, rows.
    pub(crate) fn relative(&self) -> [[S::T; 3]; 3] {
        S::to_matrix(&S::compose(&S::transpose(&self.R[0]), &self.R[1]))
    }
}

impl<S: Space> LinkMotion<S> {
    fn relative_spin(&self) -> (S::Angular, S::Angular) {
        (self.w[1] - self.w[0], self.wd[1] - self.wd[0])
    }
    /// Rates of a vector `u` fixed in frame `k`.
    fn carried(&self, k: usize, u: S::Vector) -> (S::Vector, S::Vector) {
        let u_dot = S::cross(self.w[k], u);
        (u_dot, S::cross(self.wd[k], u) + S::cross(self.w[k], u_dot))
    }
    fn slide_rates(&self, x: &LinkPose<S>, i: usize) -> (S::T, S::T) {
        let u = S::column(&x.R[0], i);
        let (u1, u2) = self.carried(0, u);
        let two = S::T::from_f64(2.0);
        (u1.dot(x.d) + u.dot(self.d_dot), u2.dot(x.d) + two * u1.dot(self.d_dot) + u.dot(self.d_ddot))
    }
    fn perpendicular_rates(&self, x: &LinkPose<S>, a: usize, b: usize) -> (S::T, S::T) {
        let (u, w) = (S::column(&x.R[0], a), S::column(&x.R[1], b));
        let ((u1, u2), (w1, w2)) = (self.carried(0, u), self.carried(1, w));
        let two = S::T::from_f64(2.0);
        (u1.dot(w) + u.dot(w1), u2.dot(w) + two * u1.dot(w1) + u.dot(w2))
    }
    fn about(&self, axis: S::Angular, frame: usize) -> (S::T, S::T) {
        let (w, wd) = self.relative_spin();
        (w.dot(axis), wd.dot(axis) + w.dot(S::cross_angular(self.w[frame], axis)))
    }
    fn turn_rates(&self, x: &LinkPose<S>) -> (S::T, S::T) {
        self.about(S::turn_axis(&x.R[0]), 0)
    }
    fn yoke_rates(&self, x: &LinkPose<S>) -> (S::T, S::T) {
        self.about(S::angular(&S::spread(S::column(&x.R[1], 0))), 1)
    }
    fn distance_rates(&self, x: &LinkPose<S>) -> (S::T, S::T) {
        let l = x.d.dot(x.d).sqrt();
        if l.value() == 0.0 {
            return (S::T::zero(), S::T::zero());
        }
        let rate = x.d.dot(self.d_dot) / l;
        (rate, (self.d_dot.dot(self.d_dot) + x.d.dot(self.d_ddot) - rate * rate) / l)
    }
    /// The relative spin's component along axis `i` of the first frame, and its derivative.
    pub(crate) fn spin_rates(&self, x: &LinkPose<S>, i: usize) -> (S::T, S::T) {
        self.about(S::angular(&S::spread(S::column(&x.R[0], i))), 0)
    }
    /// Rates and accelerations of roll, pitch and yaw from the relative spin in the first frame.
    pub(crate) fn attitude_rates(&self, x: &LinkPose<S>) -> [(S::T, S::T); 3] {
        let (w, wd) = self.relative_spin();
        // Components in the turning first frame: d/dt(R₁ᵀ ω₂₁) = R₁ᵀ (ω̇₂₁ − ω₁ × ω₂₁).
        let back = S::transpose(&x.R[0]);
        let w_1 = S::spread_angular(S::rotate_angular(&back, w));
        let wd_1 = S::spread_angular(S::rotate_angular(&back, wd - S::cross_angular(self.w[0], w)));
        crate::attitude::rpy_rates(&rpy_from_matrix(&x.relative()), &w_1, &wd_1)
    }
}
