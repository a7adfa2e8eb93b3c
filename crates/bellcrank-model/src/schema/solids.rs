//! Materials and solids.

use bellcrank_doc::Dimension as D;

use super::keys::Shape::{Axis, List, Name, Named, Names, OneOf, Outline, Pairs, Spot, Table, Text, Value};
use super::keys::{Key, Kind, Schema};

const fn plain(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Schema {
    Schema { name, doc, keys, kinds: &[], usual: None }
}

const fn kind(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Kind {
    Kind { name, doc, keys }
}

/// 1/K
const EXPANSION: D = D::of(0, 0, 0, 0, -1);

pub(crate) static MATERIAL: Schema = plain(
    "material",
    "What solids are made of.",
    &[
        Key::optional("density", Value(D::DENSITY), "density; needed where bodies take their mass from a solid"),
        Key::optional("young", List(D::PRESSURE, &[1, 3]), "Young's modulus; orthotropic: [E1, E2, E3]"),
        Key::optional(
            "poisson",
            List(D::NONE, &[1, 3]),
            "Poisson's ratio, above -1 and below 0.5; orthotropic: [nu12, nu23, nu13]",
        ),
        Key::optional("shear", List(D::PRESSURE, &[3]), "shear moduli of an orthotropic material: [G12, G23, G13]"),
        Key::optional("yield", Value(D::PRESSURE), "yield strength"),
        Key::optional("tensile", Value(D::PRESSURE), "tensile strength"),
        Key::optional("expansion", List(EXPANSION, &[1, 3]), "thermal expansion, one value or one for each axis"),
        Key::optional("fatigue", Table(&FATIGUE), "what it stands when loaded again and again"),
    ],
);

pub(crate) static FATIGUE: Schema = plain(
    "fatigue",
    "Woehler line of the part as it is, with its surface and size: cycles = `cycles` * (amplitude / `amplitude`)^-`slope`.",
    &[
        Key::required("amplitude", Value(D::PRESSURE), "stress amplitude at the knee, at no mean stress (R = -1)"),
        Key::required("cycles", Value(D::NONE), "cycles to failure there"),
        Key::required("slope", Value(D::NONE), "its slope above that amplitude; above 1"),
        Key::optional(
            "beyond",
            OneOf(BEYOND),
            "below that amplitude: no damage, the same slope (elementary, unless given), or twice the slope less one (haibach)",
        ),
        Key::required("mean", OneOf(MEANS), "how the mean stress of a cycle counts; `goodman` needs `tensile`"),
        Key::optional(
            "sensitivity",
            Value(D::NONE),
            "of `fkm`: mean stress sensitivity, 0 to 1; that of `group` unless given",
        ),
        Key::optional("group", OneOf(GROUPS), "of `fkm`: metal, whose sensitivity follows from `tensile`"),
    ],
);

pub(crate) const BEYOND: &[&str] = &["none", "elementary", "haibach"];
pub(crate) const MEANS: &[&str] = &["none", "goodman", "fkm"];
pub(crate) const GROUPS: &[&str] =
    &["steel", "cast-steel", "nodular-iron", "malleable-iron", "grey-iron", "wrought-aluminium", "cast-aluminium"];

const LAYERS: Key = Key::optional("layers", Pairs(D::LENGTH), "intervals along the axis in place of a thickness");
const OFFSET: Key = Key::optional("offset", Value(D::LENGTH), "how far its middle is from the plane; 0 unless given");
const THICKNESS: Key = Key::optional("thickness", Value(D::LENGTH), "along the axis; that of the solid unless given");

pub(crate) static SOLID: Schema = plain(
    "solid",
    "A part as a solid: a link of eyes, webs, plates and cuts, a body of revolution, or a file. Bodies that use it give \
     the points.",
    &[
        Key::required("material", Name, "what it is made of"),
        Key::optional("thickness", Value(D::LENGTH), "of every eye, web and plate that gives none"),
        Key::optional("fillet", Value(D::LENGTH), "radius of re-entrant corners in plan; sharp unless given"),
        Key::optional(
            "plane",
            OneOf(&["xy", "yz", "zx"]),
            "plane of the body's axes that the link lies in, through the origin; xy unless given",
        ),
        Key::optional("eyes", Named(&EYE), "bossed holes that pins go through"),
        Key::optional("webs", Named(&WEB), "what joins the eyes"),
        Key::optional("plates", Named(&PLATE), "extruded outlines"),
        Key::optional("cuts", Named(&CUT), "what is taken away at the end"),
        Key::optional("revolved", Table(&REVOLVED), "a pin, a bush, a shaft"),
        Key::optional(
            "file",
            Text,
            "a mesh (`.inp` of Abaqus and CalculiX, `.msh` of Gmsh) or a part (`.step`, by way of Gmsh) beside the model \
             file",
        ),
        Key::optional("unit", Text, "length that the numbers of `file` are counted in, as \"mm\""),
    ],
);

pub(crate) static EYE: Schema = plain(
    "eye",
    "A cylinder round a bore.",
    &[
        Key::optional(
            "at",
            Spot,
            "a point of the body, or a place in the plane; the point of the eye's name unless given",
        ),
        Key::required("bore", Value(D::LENGTH), "diameter of the hole; 0 for a solid boss"),
        Key::required("outer", Value(D::LENGTH), "outer diameter"),
        Key::optional("width", Value(D::LENGTH), "along the axis; the thickness of the solid unless given"),
        OFFSET,
        LAYERS,
        Key::optional(
            "clearance",
            Value(D::LENGTH),
            "diameter of the room that is cut out of everything else outside the eye's own layers",
        ),
    ],
);

const BETWEEN: Key = Key::required("between", Names, "eyes; two, any number for a hull");
const HEIGHT: Key = Key::optional("height", Value(D::LENGTH), "another word for `thickness`");
const WIDTH: Key = Key::required("width", List(D::LENGTH, &[1, 2]), "in plan; a list of two for a taper");

pub(crate) static WEB: Schema = Schema {
    name: "web",
    doc: "Joins eyes. Without `kind` it is a flat bar.",
    keys: &[BETWEEN, THICKNESS, HEIGHT, OFFSET, LAYERS],
    kinds: &[
        kind("flat", "a flat bar", &[WIDTH]),
        kind(
            "box",
            "a hollow bar: side walls, and skins that close it",
            &[
                WIDTH,
                Key::required("wall", Value(D::LENGTH), "thickness of the side walls, in plan"),
                Key::required("skin", Value(D::LENGTH), "thickness of the plates that close it; 0 leaves it open"),
            ],
        ),
        kind(
            "i",
            "two flanges along its edges and a thin web between them",
            &[
                WIDTH,
                Key::required("flange", Value(D::LENGTH), "width of each flange, in plan"),
                Key::required("web", Value(D::LENGTH), "thickness of the web, along the axis"),
            ],
        ),
        kind("hull", "a plate over the convex hull of the eyes", &[]),
    ],
    usual: Some("flat"),
};

pub(crate) static PLATE: Schema = plain(
    "plate",
    "An extruded outline.",
    &[
        Key::required("outline", Outline(&CORNER), "corners in order, closed from the last to the first"),
        THICKNESS,
        OFFSET,
        LAYERS,
    ],
);

pub(crate) static CORNER: Schema = plain(
    "corner",
    "A corner of an outline.",
    &[
        Key::required("at", Spot, "a point of the body, or a place in the plane"),
        Key::optional("radius", Value(D::LENGTH), "radius that it is rounded with; sharp unless given"),
    ],
);

const DEPTH: Key = Key::optional("thickness", Value(D::LENGTH), "along the axis; through everything unless given");

pub(crate) static CUT: Schema = Schema {
    name: "cut",
    doc: "Taken away from everything that is joined.",
    keys: &[DEPTH, OFFSET, LAYERS],
    kinds: &[
        kind(
            "hole",
            "a round hole",
            &[
                Key::required("at", Spot, "its axis: a point of the body, or a place in the plane"),
                Key::required("diameter", Value(D::LENGTH), "diameter"),
            ],
        ),
        kind(
            "slot",
            "a slot with round ends",
            &[
                Key::required("from", Spot, "axis of the first round end"),
                Key::required("to", Spot, "axis of the other"),
                Key::required("width", Value(D::LENGTH), "width, the diameter of the ends"),
            ],
        ),
        kind("outline", "a closed outline", &[Key::required("outline", Outline(&CORNER), "corners in order")]),
    ],
    usual: None,
};

pub(crate) static REVOLVED: Schema = plain(
    "revolved",
    "A closed profile turned once about an axis.",
    &[
        Key::optional("at", Spot, "a point of the body, or a place; the origin unless given"),
        Key::optional("axis", Axis, "body axes; z unless given"),
        Key::required("profile", Pairs(D::LENGTH), "corners [r, h]: distance from the axis, and height along it"),
    ],
);
