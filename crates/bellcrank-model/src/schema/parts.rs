//! Keys of studies of parts: stress, and natural frequencies of a body.

use bellcrank_doc::Dimension as D;

use super::keys::Shape::{Boolean, List, Name, Named, Names, OneOf, Row, Table, Value, Whole};
use super::keys::{Key, Schema};

/// Elements that the mesher makes, by the number of their nodes.
const ELEMENTS: &[&str] = &["wedge15", "tet10"];
/// How a pin bears in its bore.
const HINGES: &[&str] = &["bearing", "distributing", "rigid"];
pub(super) const COUPLINGS: &[&str] = &["distributing", "rigid"];

const fn plain(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Schema {
    Schema { name, doc, keys, kinds: &[], usual: None }
}

const MESHED: Key = Key::optional("mesh", Table(&MESH), "sizes and kind of the elements");

pub(super) const STRESS: &[Key] = &[
    Key::optional("body", Name, "the body that is analysed; this or `bodies`"),
    Key::optional("bodies", Names, "several, each by itself"),
    Key::optional(
        "of",
        Name,
        "the study whose positions load the body, of kind inverse-dynamics, statics or dynamics; `loads` and \
         `supports` alone unless given",
    ),
    Key::optional(
        "at",
        Row,
        "of that study: \"worst\" (unless given), \"all\", the number of a row from 0, or a signal and its value, as \
         { \"joint.B.position\" = \"-30 deg\" }: the row that comes nearest",
    ),
    Key::optional(
        "hinges",
        OneOf(HINGES),
        "how the pins of the joints bear: pressure as the cosine on one side (unless given), spread over the bore, or as \
         a rigid pin that is bonded",
    ),
    Key::optional("stress", Table(&ACCURACY), "refine the mesh until the stress is as exact as this"),
    MESHED,
    Key::optional("supports", Named(&SUPPORT), "what holds the body"),
    Key::optional("loads", Named(&LOAD), "what acts on the body beside the loads of `of`"),
];

/// Of studies of kind `modes` with a `body`.
pub(super) const BODY: Key =
    Key::optional("body", Name, "the natural frequencies of this body as an elastic part; of the machine unless given");
pub(super) const COUNT: Key = Key::optional(
    "modes",
    Whole(1, 1000),
    "of a body: so many modes beside the motions as a rigid body; 10 unless given",
);
pub(super) const FIXED: Key =
    Key::optional("fixed", Names, "of a body: bores and sets that are clamped; none unless given");
pub(super) const BODY_MESH: Key = Key::optional("mesh", Table(&MESH), "of a body: sizes and kind of the elements");

static ACCURACY: Schema = plain(
    "accuracy",
    "How exact the stress at hot spots has to be.",
    &[
        Key::required("accuracy", Value(D::NONE), "largest estimated error, as \"3 %\" or 0.03"),
        Key::optional("refinements", Whole(0, 12), "at most so many meshes after the first; 4 unless given"),
    ],
);

pub(super) static MESH: Schema = plain(
    "mesh",
    "Sizes of elements.",
    &[
        Key::optional("size", Value(D::LENGTH), "away from everything; a third of the usual wall unless given"),
        Key::optional("bores", Value(D::LENGTH), "at bores; 24 elements on a turn unless given"),
        Key::optional("fillets", Value(D::LENGTH), "at fillets, holes and slots; 24 elements on a turn unless given"),
        Key::optional("layers", Whole(1, 100), "fewest layers through a thickness; 2 unless given"),
        Key::optional("element", OneOf(ELEMENTS), "wedge15 unless given"),
    ],
);

pub(crate) static SUPPORT: Schema = plain(
    "support",
    "Holds a set of the mesh.",
    &[
        Key::required("set", Name, "a bore as `bore.B` or `B`, or another set of the mesh"),
        Key::optional("fixed", Names, "directions: x, y, z in body axes; with a coupling rx, ry, rz as well"),
        Key::optional(
            "value",
            List(D::LENGTH, &[3]),
            "prescribed displacement; of the directions in `fixed`, or of all",
        ),
        Key::optional("spring", List(D::STIFFNESS, &[3]), "stiffness to ground of the whole set"),
        Key::optional("coupling", OneOf(COUPLINGS), "hold the set as a whole by its middle"),
    ],
);

pub(crate) static LOAD: Schema = plain(
    "load",
    "Acts on a set of the mesh, or on the whole body.",
    &[
        Key::optional(
            "set",
            Name,
            "a bore as `bore.B` or `B`, or another set of the mesh; the whole body unless given",
        ),
        Key::optional("force", List(D::FORCE, &[2, 3]), "resultant force, body axes"),
        Key::optional("moment", List(D::MOMENT, &[3]), "resultant moment about the middle of the set, body axes"),
        Key::optional("coupling", OneOf(COUPLINGS), "how force and moment are spread; distributing unless given"),
        Key::optional("bearing", Boolean, "the force is that of a pin: pressure as the cosine on one side of the bore"),
        Key::optional("pressure", Value(D::PRESSURE), "on the faces of the set, positive into the body"),
        Key::optional("traction", List(D::PRESSURE, &[2, 3]), "force an area on the faces of the set, body axes"),
        Key::optional("gravity", List(D::ACCELERATION, &[2, 3]), "weight of the whole body, body axes"),
        Key::optional("temperature", Value(D::TEMPERATURE), "rise of the whole body"),
    ],
);
