//! Kinds of studies, and their keys.

use bellcrank_doc::Dimension as D;

use super::asks::{DESIGNS, OF, OPTIMIZE, SENSITIVITY, TOLERANCE};
use super::keys::Shape::{Map, Name, Names, NamesOrMap, Response, Table, Value};
use super::keys::{Key, Kind, Schema};
use super::sizing::SIZING;
use super::tables::{DRIVE, SWEEP};

/// Kinds that this version runs.
pub(crate) const AVAILABLE: &[&str] =
    &["kinematics", "inverse-dynamics", "statics", "sensitivity", "optimize", "sweep", "tolerance", "sizing"];

/// Kinds whose keys are not settled: an unknown key there is no error yet.
pub(crate) const OPEN: &[&str] = &["workspace", "modes", "stress"];

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
const OVER_POSITIONS_OR_TIME: &[Key] = &[SWEPT, DRIVEN, HOLD, DURATION, STEP, MOTIONS, DRIVES];

pub(crate) static STUDY: Schema = Schema {
    name: "study",
    doc: "Something to find out.",
    keys: &[
        Key::optional("like", Name, "another study that this one starts from"),
        Key::optional("set", Map, "other values for parameters in this study"),
    ],
    kinds: &[
        kind("kinematics", "positions, velocities and accelerations", OVER_POSITIONS_OR_TIME),
        kind("inverse-dynamics", "kinematics, drive forces and reactions", OVER_POSITIONS_OR_TIME),
        kind("statics", "equilibrium at rest", &[SWEPT, HOLD, MOTIONS]),
        kind(
            "dynamics",
            "motion from forces",
            &[
                DURATION,
                Key::optional("output_step", Value(D::TIME), "from row to row"),
                Key::optional("tolerance", Value(D::NONE), "1e-6 unless given"),
                MOTIONS,
                HOLD,
                Key::optional("stop_when", Response, "condition that ends the study"),
            ],
        ),
        kind("sensitivity", "derivatives of a response with respect to parameters", SENSITIVITY),
        kind("optimize", "the best parameters", OPTIMIZE),
        kind("sweep", "responses over many designs", DESIGNS),
        kind("tolerance", "scatter of a response", TOLERANCE),
        kind("sizing", "a standard cylinder or an electric drive for the force, stroke and speed of a drive", SIZING),
        kind("workspace", "where a point can go", &[OF]),
        kind("modes", "natural frequencies", &[OF]),
        kind("stress", "stresses of flexible bodies", &[OF]),
    ],
};
