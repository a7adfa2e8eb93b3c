//! A link as an engineer says it, in the axes of its plane: x and y in plan, z along the eyes.

/// Eyes joined by webs, with plates and cuts; lengths in m.
///
/// Everything joined is united first, then every cut, clearance and bore is taken away.
#[derive(Clone, Debug)]
pub struct Link<T> {
    /// Bossed holes that pins go through.
    pub eyes: Vec<Eye<T>>,
    /// What joins the eyes.
    pub webs: Vec<Web<T>>,
    /// Extruded outlines.
    pub plates: Vec<Plate<T>>,
    /// Slots, holes and outlines taken away.
    pub cuts: Vec<Cut<T>>,
    /// Radius that re-entrant corners in plan are rounded with, layer by layer; `None` leaves them sharp.
    pub fillet: Option<T>,
}

/// A cylinder round a bore.
#[derive(Clone, Debug)]
pub struct Eye<T> {
    /// Axis in plan.
    pub center: [T; 2],
    /// Diameter of the hole; zero for a solid boss.
    pub bore: T,
    /// Outer diameter.
    pub outer: T,
    /// Where it is along z: one interval, or several for a fork.
    pub layers: Vec<[T; 2]>,
    /// Diameter within which everything else is taken away outside the eye's own layers: the room that the
    /// counterpart of a fork or a tongue turns in.
    pub clearance: Option<T>,
}

/// What joins eyes.
#[derive(Clone, Debug)]
pub enum Web<T> {
    /// A bar from one eye to another.
    Bar(Bar<T>),
    /// A plate over the convex hull of the outer circles of eyes.
    Hull {
        /// Places of the eyes; at least two.
        eyes: Vec<usize>,
        /// Intervals along z.
        layers: Vec<[T; 2]>,
    },
}

/// A bar between the axes of two eyes.
#[derive(Clone, Debug)]
pub struct Bar<T> {
    /// Places of the two eyes.
    pub eyes: [usize; 2],
    /// Width in plan at the first and at the second eye's axis; it changes linearly between them.
    pub widths: [T; 2],
    /// Intervals along z.
    pub layers: Vec<[T; 2]>,
    /// Form of its cross-section.
    pub profile: Profile<T>,
}

/// Cross-section of a bar, in its width (in plan) and its height (along z).
#[derive(Clone, Debug)]
pub enum Profile<T> {
    /// Full.
    Flat,
    /// Hollow: the cavity ends at the eyes' outer circles.
    Box {
        /// Thickness of the two side walls, measured in plan.
        wall: T,
        /// Thickness of the two plates that close it along z; zero leaves it open (a ladder of two strips).
        skin: T,
    },
    /// Two flanges along the edges of the plan, a thin web between them in the middle of the height.
    I {
        /// Width of each flange, measured in plan.
        flange: T,
        /// Thickness of the web along z.
        web: T,
    },
}

/// An outline extruded along z.
#[derive(Clone, Debug)]
pub struct Plate<T> {
    /// Corners in order, either way round, closed from the last to the first.
    pub outline: Vec<Corner<T>>,
    /// Intervals along z.
    pub layers: Vec<[T; 2]>,
}

/// A corner of an outline.
#[derive(Clone, Debug)]
pub struct Corner<T> {
    /// Place in plan.
    pub at: [T; 2],
    /// Radius it is rounded with; zero leaves it sharp.
    pub radius: T,
}

/// Something taken away.
#[derive(Clone, Debug)]
pub struct Cut<T> {
    /// Its form in plan.
    pub shape: CutShape<T>,
    /// Intervals along z; `None` goes through everything.
    pub layers: Option<Vec<[T; 2]>>,
}

/// Form of a cut in plan.
#[derive(Clone, Debug)]
pub enum CutShape<T> {
    /// A round hole.
    Hole {
        /// Axis in plan.
        center: [T; 2],
        /// Diameter.
        diameter: T,
    },
    /// What a cutter leaves that goes from one place to another.
    Slot {
        /// Axis of the first round end.
        from: [T; 2],
        /// Axis of the other.
        to: [T; 2],
        /// Width; the diameter of the round ends.
        width: T,
    },
    /// A closed outline.
    Outline(Vec<Corner<T>>),
}
