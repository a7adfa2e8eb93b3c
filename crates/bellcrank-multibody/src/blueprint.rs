//! What a mechanism is made of: plain numbers, checked for units and names by whoever filled them in.

/// A body; 0 is the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct BodyId(pub usize);

impl BodyId {
    /// The body that does not move.
    pub const GROUND: Self = Self(0);
}

/// A joint or constraint, by its place in [`Blueprint::joints`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct JointId(pub usize);

/// A force element, by its place in [`Blueprint::forces`].
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct ForceId(pub usize);

/// One coordinate of a joint: `index` counts within the joint.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Coordinate {
    /// The joint.
    pub joint: JointId,
    /// 0 unless the joint has several coordinates.
    pub index: usize,
}

/// Everything a mechanism is built from. Bodies include the ground at index 0.
#[derive(Clone, Debug)]
pub struct Blueprint<T> {
    /// Acceleration of free fall, world axes, m/s².
    pub gravity: [T; 3],
    /// Bodies, ground first (its mass properties are ignored).
    pub bodies: Vec<Body<T>>,
    /// Joints and constraints.
    pub joints: Vec<Joint<T>>,
    /// Force elements.
    pub forces: Vec<Force<T>>,
    /// Bodies that change their shape.
    pub flexible: Vec<crate::Flexible<T>>,
    /// Number of values that are set anew at every position or time ([`Value::Input`]).
    pub inputs: usize,
}

impl<T: Copy> Blueprint<T> {
    /// Takes the numbers of another one, in the memory of the old.
    pub(crate) fn copy_from(&mut self, other: &Blueprint<T>) {
        self.gravity = other.gravity;
        self.bodies.clone_from(&other.bodies);
        self.joints.clone_from(&other.joints);
        self.forces.clone_from(&other.forces);
        self.flexible.clone_from(&other.flexible);
        self.inputs = other.inputs;
    }
}

/// Mass properties in body axes.
#[derive(Clone, Debug)]
pub struct Body<T> {
    /// kg; 0 for a massless body.
    pub mass: T,
    /// Centre of mass, m.
    pub center: [T; 3],
    /// Inertia tensor about the centre of mass, kg·m²; the plane uses zz.
    pub inertia: [[T; 3]; 3],
}

/// A frame fixed on a body.
#[derive(Clone, Debug)]
pub struct Place<T> {
    /// The body.
    pub body: BodyId,
    /// Origin in body axes, m.
    pub position: [T; 3],
    /// Rotation matrix (rows) from the frame's axes to body axes.
    pub rotation: [[T; 3]; 3],
}

/// What a joint allows. Axes are given in the frame of the first place unless said otherwise and need
/// not be of unit length.
#[derive(Clone, Debug)]
pub enum JointKind<T> {
    /// Turning about an axis: angle.
    Revolute {
        /// Axis.
        axis: [T; 3],
    },
    /// Sliding along an axis: distance.
    Prismatic {
        /// Axis.
        axis: [T; 3],
    },
    /// Sliding along and turning about one axis: distance, angle.
    Cylindrical {
        /// Axis.
        axis: [T; 3],
    },
    /// Turning about an axis and advancing with it: angle.
    Screw {
        /// Axis.
        axis: [T; 3],
        /// Advance a full turn, m.
        pitch: T,
    },
    /// Turning about an axis of the first and one of the second place: two angles.
    Universal {
        /// Axis on the first place.
        axis: [T; 3],
        /// Axis on the second place, perpendicular to the first at zero angles.
        axis2: [T; 3],
    },
    /// Turning any way about a point: roll, pitch, yaw.
    Spherical,
    /// Moving in the x-y plane of the first place: x, y, angle.
    Planar,
    /// Moving any way: x, y, z, roll, pitch, yaw; in the plane x, y, angle.
    Free,
    /// Moving any way by little: x, y, z, then turns about x, y, z of the second place's own axes one after another; in
    /// the plane x, y, angle. Always in the tree: it joins an interface to its flexible body.
    Elastic,
    /// So many numbers that move nothing: the modes of a flexible body, and the massless body that stands for them.
    Modes {
        /// How many.
        count: usize,
    },
    /// Not moving.
    Weld,
    /// The distance of the two origins: held at `length`, or a coordinate.
    Distance {
        /// Held length, m.
        length: Option<T>,
    },
    /// The second origin stays on a line of the first place: place on the line.
    PointOnLine {
        /// The line's direction.
        axis: [T; 3],
    },
    /// Two coordinates move together: `b = ratio·a + offset`. Has no places of its own.
    Coupler {
        /// The coordinate that leads.
        a: Coordinate,
        /// The coordinate that follows.
        b: Coordinate,
        /// In SI units of b per SI unit of a.
        ratio: T,
        /// In SI units of b.
        offset: T,
    },
}

/// A joint between two places.
#[derive(Clone, Debug)]
pub struct Joint<T> {
    /// What it allows.
    pub kind: JointKind<T>,
    /// First and second place; `None` for a coupler.
    pub places: Option<[Place<T>; 2]>,
    /// First guess of each coordinate (SI), where given; may be shorter than the coordinates.
    pub start: Vec<Option<T>>,
    /// Hold the given starts exactly during assembly.
    pub at_start: bool,
}

/// A number of a force element: fixed, or set anew at every position or time.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Value<T> {
    /// Fixed.
    Constant(T),
    /// Index into the inputs.
    Input(usize),
}

/// Axes that a vector is given in.
#[derive(Clone, Debug)]
pub enum Axes<T> {
    /// World axes: the direction stays.
    World,
    /// The axes of the body it acts on: the direction turns along.
    Body,
    /// The axes of a frame on another body, wherever it is.
    Frame(Place<T>),
}

/// A force element.
#[derive(Clone, Debug)]
pub enum Force<T> {
    /// A force at a point, N.
    Point {
        /// Where it acts.
        at: Place<T>,
        /// Components, N.
        vector: [Value<T>; 3],
        /// Axes of the components.
        axes: Axes<T>,
    },
    /// A free moment on a body, N·m (the plane uses z).
    Torque {
        /// The body.
        on: BodyId,
        /// Components, N·m.
        vector: [Value<T>; 3],
        /// Axes of the components.
        axes: Axes<T>,
    },
    /// An effort along a joint coordinate, positive when it pushes the coordinate up, N or N·m.
    Effort {
        /// The coordinate.
        coordinate: Coordinate,
        /// N or N·m.
        value: Value<T>,
    },
    /// Spring and damper between two points: effort `−k (l − l₀) − c l̇ + preload`, positive pushes apart.
    Spring {
        /// The two places.
        between: [Place<T>; 2],
        /// N/m.
        stiffness: Value<T>,
        /// N·s/m.
        damping: Value<T>,
        /// m.
        free_length: Value<T>,
        /// N.
        preload: Value<T>,
    },
    /// Spring and damper on a joint coordinate: effort `−k (q − q₀) − c q̇ + preload`.
    JointSpring {
        /// The coordinate.
        coordinate: Coordinate,
        /// N/m or N·m/rad.
        stiffness: Value<T>,
        /// N·s/m or N·m·s/rad.
        damping: Value<T>,
        /// m or rad.
        free_position: Value<T>,
        /// N or N·m.
        preload: Value<T>,
    },
    /// Friction in a joint: `−sign(q̇) μ(q̇) N r − c q̇` with `μ = μ_c + (μ_s − μ_c) exp(−(q̇/v_s)²)`; N is the
    /// reaction across the joint's axis, r = 1 on sliding joints.
    Friction {
        /// The coordinate it acts along.
        coordinate: Coordinate,
        /// Coulomb coefficient.
        coulomb: Value<T>,
        /// Coefficient at the onset of motion (the Coulomb one unless given).
        static_coefficient: Option<Value<T>>,
        /// Width of the Stribeck drop in m/s or rad/s (needed with a static coefficient).
        stribeck_velocity: Option<Value<T>>,
        /// N·s/m or N·m·s/rad.
        viscous: Value<T>,
        /// Radius at which friction acts on turning joints, m.
        radius: Option<Value<T>>,
        /// Below this speed friction grows smoothly with the speed (`tanh(q̇/v)` instead of the sign); without it
        /// friction can hold still, and sticking and slipping are told apart.
        smoothing_velocity: Option<Value<T>>,
    },
    /// A one-sided spring and damper beyond each given limit of a coordinate (never pulls); with a restitution a
    /// limit that is never passed, and acts in forward dynamics only.
    Stop {
        /// The coordinate.
        coordinate: Coordinate,
        /// Lower limit.
        min: Option<Value<T>>,
        /// Upper limit.
        max: Option<Value<T>>,
        /// N/m or N·m/rad.
        stiffness: Value<T>,
        /// N·s/m or N·m·s/rad.
        damping: Value<T>,
        /// Hard: part of the speed that an impact leaves, 0 to 1.
        restitution: Option<Value<T>>,
    },
    /// Six springs and dampers between two frames, along and about the axes of the first: x, y, z and the
    /// rotation vector; the plane uses x, y and the angle (entries 0, 1 and 5).
    Bushing {
        /// The two places.
        between: [Place<T>; 2],
        /// N/m three times, N·m/rad three times.
        stiffness: [Value<T>; 6],
        /// N·s/m three times, N·m·s/rad three times.
        damping: [Value<T>; 6],
    },
}
