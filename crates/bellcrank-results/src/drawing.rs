//! The stick drawing of a mechanism and its motion.

/// Plane or space.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SpaceKind {
    /// x-y plane.
    Planar,
    /// Three dimensions.
    Spatial,
}

/// Position (m) and orientation (unit quaternion w, x, y, z) of a body frame in the world.
#[derive(Clone, Copy, Debug)]
pub struct Pose {
    /// Origin of the body frame, world axes, m.
    pub position: [f64; 3],
    /// Rotation from body to world axes.
    pub quaternion: [f64; 4],
}

/// A body as its named points and the lines between them, body axes, m.
#[derive(Clone, Debug)]
pub struct DrawnBody {
    /// Name; body 0 of a drawing is `ground`.
    pub name: String,
    /// Point names and places.
    pub points: Vec<(String, [f64; 3])>,
    /// Pairs of indices into `points` to join by a line.
    pub lines: Vec<[usize; 2]>,
    /// Centre of mass, for bodies with mass.
    pub center: Option<[f64; 3]>,
    /// Sides (m, along body axes) of the block around the centre of mass that has the body's mass and moments of
    /// inertia; none where no block has them.
    pub block: Option<[f64; 3]>,
    /// Its real form, where the model has it.
    pub surface: Option<Surface>,
}

/// The surface of a body, body axes, m. Curved faces come divided; neighbours share their points.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Surface {
    /// Corners.
    pub points: Vec<[f64; 3]>,
    /// Triangles between them, counter-clockwise seen from outside.
    pub triangles: Vec<[u32; 3]>,
}

/// A joint symbol that moves with its first body.
#[derive(Clone, Debug)]
pub struct DrawnJoint {
    /// Name.
    pub name: String,
    /// Kind, as in the file.
    pub kind: String,
    /// Index of the first body and the place on it (body axes, m).
    pub first: (usize, [f64; 3]),
    /// Index of the second body and the place on it (body axes, m).
    pub second: (usize, [f64; 3]),
    /// Axis on the first body, body axes; z for a planar pin.
    pub axis: [f64; 3],
    /// Carries a drive.
    pub driven: bool,
}

/// An applied force arrow: body index, place on it, and the signal columns of its world components.
#[derive(Clone, Debug)]
pub struct Arrow {
    /// Force name.
    pub name: String,
    /// Body index.
    pub body: usize,
    /// Place on the body, body axes, m.
    pub at: [f64; 3],
}

/// What does not change while the mechanism moves.
#[derive(Clone, Debug)]
pub struct Drawing {
    /// Plane or space.
    pub space: SpaceKind,
    /// The axis of the world that points most against gravity, of length one; y in the plane and z in
    /// space where there is no gravity.
    pub up: [f64; 3],
    /// Bodies, ground first.
    pub bodies: Vec<DrawnBody>,
    /// Joints.
    pub joints: Vec<DrawnJoint>,
    /// Applied forces.
    pub arrows: Vec<Arrow>,
}

/// Poses of all bodies (ground included) for some of the rows.
#[derive(Clone, Debug, Default)]
pub struct Animation {
    /// Row of the study's table that each frame belongs to.
    pub rows: Vec<usize>,
    /// `frames[i][b]`: pose of body `b` in frame `i`.
    pub frames: Vec<Vec<Pose>>,
    /// `arrows[i][a]`: world components (N) of arrow `a` in frame `i`.
    pub arrows: Vec<Vec<[f64; 3]>>,
}
