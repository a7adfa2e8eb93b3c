//! Bodies that deform: what is kept of a solid, and beams.

use bellcrank_doc::Dimension as D;

use super::keys::Shape::{Axis, Boolean, List, Name, Names, OneOf, Table, Value, Whole};
use super::keys::{Key, Schema};
use super::parts::{COUPLINGS, MESH};

/// m⁴
const SECOND_MOMENT: D = D::of(4, 0, 0, 0, 0);

const fn plain(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Schema {
    Schema { name, doc, keys, kinds: &[], usual: None }
}

/// Of studies that run a machine.
pub(super) const FLEXIBLE_STUDY: Key =
    Key::optional("flexible", Boolean, "false: bodies that are `flexible` are rigid in this study; true unless given");

pub(crate) static FLEXIBLE: Schema = plain(
    "flexible",
    "How a body deforms: by the motion of its interfaces and by modes in which these rest (Craig-Bampton).",
    &[
        Key::optional(
            "interfaces",
            Names,
            "points of the body where joints and forces take hold; those where any do unless given",
        ),
        Key::optional("reference", Name, "the interface that the body's frame goes with; the first unless given"),
        Key::optional(
            "modes",
            Whole(0, 1000),
            "so many modes with the interfaces at rest; 10 unless given (beams: 0), or all up to `frequency`",
        ),
        Key::optional("frequency", Value(D::FREQUENCY), "no mode above this natural frequency"),
        Key::optional(
            "coupling",
            OneOf(COUPLINGS),
            "how a bore follows its interface: by the mean of its motion (unless given), or as a rigid surface",
        ),
        Key::optional("damping", Value(D::NONE), "part of critical damping in every natural mode; 0.01 unless given"),
        Key::optional(
            "stiffening",
            Boolean,
            "tension stiffens and compression softens; unless given, beams do and solids do not",
        ),
        Key::optional("mesh", Table(&MESH), "of a solid: sizes and kind of the elements"),
        Key::optional(
            "segments",
            Whole(1, 200),
            "of a beam: so many parts, each with a frame of its own; 1 unless given",
        ),
    ],
);

pub(crate) static BEAM: Schema = plain(
    "beam",
    "A straight rod of one section between two points of the bodies that use it.",
    &[
        Key::required("material", Name, "what it is made of"),
        Key::required("between", Names, "its two ends: points of the body"),
        Key::optional(
            "width",
            Value(D::LENGTH),
            "of a rectangle: across the plane, or along the second axis of the section",
        ),
        Key::optional("height", Value(D::LENGTH), "of a rectangle: in the plane, or along `up`"),
        Key::optional("diameter", Value(D::LENGTH), "of a round rod"),
        Key::optional("tube", List(D::LENGTH, &[2]), "[outer diameter, wall] of a tube"),
        Key::optional("area", Value(D::AREA), "of any other section, with `second_moment`"),
        Key::optional(
            "second_moment",
            List(SECOND_MOMENT, &[1, 2]),
            "of area, of any other section: in the plane one; in space [bending along `up`, bending across], or one for both",
        ),
        Key::optional("torsion", Value(SECOND_MOMENT), "torsion constant of any other section; needed in space"),
        Key::optional(
            "shear_areas",
            List(D::AREA, &[1, 2]),
            "of any other section: in the plane one; in space [along `up`, across]; without shear unless given",
        ),
        Key::optional(
            "up",
            Axis,
            "in space: the direction of `height`, body axes; z unless given (y for a rod along z)",
        ),
    ],
);
