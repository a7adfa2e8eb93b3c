//! Kinds of studies, and their keys.

use bellcrank_doc::Dimension as D;

use super::asks::{DESIGNS, OF, OPTIMIZE, SENSITIVITY, TOLERANCE};
use super::flexible::FLEXIBLE_STUDY;
use super::keys::Shape::{Boolean, Comparisons, Map, Name, Names, NamesOrMap, OneOf, Table, Value, Whole};
use super::keys::{Key, Kind, Schema};
use super::parts::{self, STRESS};
use super::sizing::SIZING;
use super::tables::{DRIVE, SWEEP};

/// Kinds that this version runs.
pub(crate) const AVAILABLE: &[&str] = &[
    "kinematics",
    "inverse-dynamics",
    "statics",
    "dynamics",
    "modes",
    "sensitivity",
    "optimize",
    "sweep",
    "tolerance",
    "sizing",
    "stress",
];

/// Kinds whose keys are not settled: an unknown key there is no error yet.
pub(crate) const OPEN: &[&str] = &["workspace"];

const fn kind(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Kind {
    Kind { name, doc, keys }
}

const HOLD: Key = Key::optional(
    "hold",
    NamesOrMap,
    "coordinates that rest: names (at their start), or a table of names and positions",
);
const SWEPT: Key = Key::optional("sweep", Table(&SWEEP), "over positions: the joint that is swept");
const DRIVEN: Key = Key::optional("drive", Table(&DRIVE), "over positions: the joint that moves and carries the force");
const DURATION: Key = Key::optional("duration", Value(D::TIME), "over time: how long");
const STEP: Key = Key::optional("step", Value(D::TIME), "over time: from row to row");
const MOTIONS: Key = Key::optional("motions", Names, "over time: motions that act; all unless given");
const DRIVES: Key =
    Key::optional("drives", Names, "over time: joints that carry the efforts; those with motions unless given");
/// Ways to step in time.
const METHODS: &[&str] = &["auto", "explicit", "generalized-alpha"];

const DYNAMICS: &[Key] = &[
    DURATION,
    Key::optional("output_step", Value(D::TIME), "from row to row; a 500th of the duration unless given"),
    Key::optional("tolerance", Value(D::NONE), "local error of a step, 1e-12 to 0.1; 1e-6 unless given"),
    MOTIONS,
    HOLD,
    Key::optional(
        "stop_when",
        Comparisons,
        "ends the study: a comparison at one instant, as \"joint.slide.position > 200 mm\", or a list, of which any ends it",
    ),
    Key::optional(
        "method",
        OneOf(METHODS),
        "auto (unless given): explicit until the machine turns out stiff, generalized-alpha from then on",
    ),
    Key::optional(
        "spectral_radius",
        Value(D::NONE),
        "of generalized-alpha: 1 damps nothing, 0 all that the steps do not resolve; 0.8 unless given",
    ),
    Key::optional("step", Value(D::TIME), "a fixed step of the integration; chosen by the error unless given"),
    Key::optional("largest_step", Value(D::TIME), "no step is longer"),
];
const MODES: &[Key] = &[
    Key::optional("sweep", Table(&SWEEP), "at each position of this joint"),
    HOLD,
    Key::optional("motions", Names, "motions whose joints are held where they begin; none unless given"),
    Key::optional("count", Whole(1, 100_000), "so many modes, the slowest first; all unless given"),
    Key::optional("equilibrium", Boolean, "find equilibrium first (unless given), or take the position as assembled"),
    parts::BODY,
    parts::COUNT,
    parts::FIXED,
    parts::BODY_MESH,
];
const OVER_POSITIONS_OR_TIME: &[Key] = &[SWEPT, DRIVEN, HOLD, DURATION, STEP, MOTIONS, DRIVES];

pub(crate) static STUDY: Schema = Schema {
    name: "study",
    doc: "Something to find out.",
    keys: &[
        Key::optional("like", Name, "another study that this one starts from"),
        Key::optional("set", Map, "other values for parameters in this study"),
        FLEXIBLE_STUDY,
    ],
    kinds: &[
        kind("kinematics", "positions, velocities and accelerations", OVER_POSITIONS_OR_TIME),
        kind("inverse-dynamics", "kinematics, drive forces and reactions", OVER_POSITIONS_OR_TIME),
        kind("statics", "equilibrium at rest", &[SWEPT, HOLD, MOTIONS]),
        kind("dynamics", "motion from forces, in time", DYNAMICS),
        kind("modes", "natural frequencies and mode shapes: of the machine about a position, or of a body", MODES),
        kind("sensitivity", "derivatives of a response with respect to parameters", SENSITIVITY),
        kind("optimize", "the best parameters", OPTIMIZE),
        kind("sweep", "responses over many designs", DESIGNS),
        kind("tolerance", "scatter of a response", TOLERANCE),
        kind("sizing", "a standard cylinder or an electric drive for the force, stroke and speed of a drive", SIZING),
        kind("workspace", "where a point can go", &[OF]),
        kind("stress", "stress in a body, with its error", STRESS),
    ],
    usual: None,
};
