//! What can be wrong with a solid.

/// A piece of a link, by its place in the list of its kind.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Part {
    /// In [`crate::Link::eyes`].
    Eye(usize),
    /// In [`crate::Link::webs`].
    Web(usize),
    /// In [`crate::Link::plates`].
    Plate(usize),
    /// In [`crate::Link::cuts`].
    Cut(usize),
    /// [`crate::Link::fillet`].
    Fillet,
    /// The profile of a [`crate::Revolved`].
    Profile,
}

/// A length that a part is given by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Quantity {
    /// Diameter of a hole.
    Bore,
    /// Outer diameter of an eye.
    Outer,
    /// Diameter of the room round an eye.
    Clearance,
    /// Width of a bar at its first eye, or of a slot.
    Width,
    /// Width of a bar at its second eye.
    SecondWidth,
    /// Thickness of the side walls of a box section.
    Wall,
    /// Thickness of the closing plates of a box section.
    Skin,
    /// Width of the flanges of an I-section.
    Flange,
    /// Thickness of the web of an I-section.
    Web,
    /// Diameter of a cut hole.
    Diameter,
    /// Radius of a fillet or of a corner (by its place in the outline).
    Radius,
}

/// Something wrong with a solid; lengths in m.
#[derive(Clone, Debug, PartialEq)]
pub enum Fault {
    /// A number is not finite.
    NotFinite {
        /// Where.
        part: Part,
    },
    /// Nothing is joined.
    Empty,
    /// The whole is smaller than 1e-6 m or larger than 1e6 m, or as far away.
    Extent {
        /// Largest distance between its points, or from the origin.
        extent: f64,
    },
    /// A length that must be positive is zero or negative.
    NotPositive {
        /// Whose.
        part: Part,
        /// Which.
        quantity: Quantity,
        /// What it is.
        value: f64,
    },
    /// A length, or what two leave of each other, is too small to be told from rounding.
    TooSmall {
        /// Whose.
        part: Part,
        /// Which.
        quantity: Quantity,
        /// What it is.
        value: f64,
        /// The least that is.
        least: f64,
    },
    /// The outer diameter of an eye is not larger than its bore.
    EyeThinnerThanBore {
        /// Place of the eye.
        eye: usize,
        /// Its bore.
        bore: f64,
        /// Its outer diameter.
        outer: f64,
    },
    /// No interval along z.
    NoLayers {
        /// Whose.
        part: Part,
    },
    /// An interval along z that is empty, reversed or thinner than what can be told from rounding.
    Layer {
        /// Whose.
        part: Part,
        /// Place in its layers.
        layer: usize,
        /// The interval.
        interval: [f64; 2],
    },
    /// An eye that a web goes to does not exist.
    NoSuchEye {
        /// Place of the web.
        web: usize,
        /// Place of the eye.
        eye: usize,
    },
    /// A hull of fewer than two eyes.
    TooFewEyes {
        /// Place of the web.
        web: usize,
        /// How many.
        count: usize,
    },
    /// A web between eyes on one axis.
    WebOfNoLength {
        /// Place of the web.
        web: usize,
    },
    /// None of a web's layers touches one of an eye's.
    WebMissesEye {
        /// Place of the web.
        web: usize,
        /// Place of the eye.
        eye: usize,
        /// Distance along z between the two.
        gap: f64,
    },
    /// Walls or flanges that leave no room between them in the width.
    WallsMeet {
        /// Place of the web.
        web: usize,
        /// [`Quantity::Wall`] or [`Quantity::Flange`].
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// The smaller width of the bar.
        width: f64,
    },
    /// Skins that leave no room between them, or a web that leaves no recess, in the height.
    SkinsMeet {
        /// Place of the web.
        web: usize,
        /// [`Quantity::Skin`] or [`Quantity::Web`].
        quantity: Quantity,
        /// Its value.
        value: f64,
        /// Height of the thinnest layer.
        height: f64,
    },
    /// An outline of fewer than three corners.
    TooFewCorners {
        /// Whose.
        part: Part,
        /// How many.
        count: usize,
    },
    /// A corner of an outline at the place of the one before.
    SideOfNoLength {
        /// Whose.
        part: Part,
        /// Place of the corner.
        corner: usize,
    },
    /// Two sides of an outline meet elsewhere than at a corner they share. A side has the number of the corner it begins at.
    SidesCross {
        /// Whose.
        part: Part,
        /// The sides.
        sides: [usize; 2],
    },
    /// The radii at the two ends of a side take more than there is of it.
    RadiusTooLarge {
        /// Whose.
        part: Part,
        /// Places of the corners at the ends of the side.
        corners: [usize; 2],
        /// Their radii.
        radii: [f64; 2],
        /// How much of the side they take.
        needed: f64,
        /// Length of the side.
        length: f64,
    },
    /// A re-entrant corner cannot be rounded: the curves at it are too short.
    FilletTooLarge {
        /// Place in plan.
        at: [f64; 2],
        /// Interval along z.
        layer: [f64; 2],
        /// Radius asked for.
        radius: f64,
        /// What it (with that of the neighbouring corner) needs of a curve; infinite where no such arc touches both.
        needed: f64,
        /// Length of that curve.
        length: f64,
    },
    /// The solid is in several pieces.
    Unconnected {
        /// How many.
        pieces: usize,
    },
    /// Parts that touch only along an edge or in a point.
    ThinContact {
        /// Place in plan.
        at: [f64; 2],
        /// Interval along z, of no height for a point or an edge in plan.
        interval: [f64; 2],
    },
    /// A cut that meets no material. The solid can be made all the same.
    CutRemovesNothing {
        /// Place of the cut.
        cut: usize,
    },
    /// A cut that goes through the wall of an eye. The solid can be made all the same.
    CutInEye {
        /// Place of the cut.
        cut: usize,
        /// Place of the eye.
        eye: usize,
    },
    /// A profile that is turned about an axis whose direction is not of length one.
    Axis {
        /// Its length.
        length: f64,
    },
    /// A corner of a profile on the far side of the axis.
    NegativeRadius {
        /// Place of the corner.
        corner: usize,
        /// Its distance from the axis.
        radius: f64,
    },
    /// A profile that touches the axis in a corner only: the solid would hang together in a point.
    TouchesAxis {
        /// Place of the corner.
        corner: usize,
    },
}

impl Fault {
    /// Whether the solid can be made all the same.
    pub fn is_warning(&self) -> bool {
        matches!(self, Fault::CutRemovesNothing { .. } | Fault::CutInEye { .. })
    }
}
