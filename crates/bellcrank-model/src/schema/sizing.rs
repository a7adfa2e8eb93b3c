//! Keys of studies that choose a drive.

use bellcrank_doc::Dimension as D;

use super::asks::OF;
use super::keys::Shape::{Boolean, Free, Name, OneOf, Table, Text, Texts, Value};
use super::keys::{Key, Schema};

pub(super) const SIZING: &[Key] = &[
    OF,
    Key::optional("drive", Name, "the joint whose drive is chosen; that of the study unless it has several"),
    Key::optional(
        "actuator",
        OneOf(&["pneumatic", "electric"]),
        "unless given pneumatic where the drive slides, electric where it turns",
    ),
    Key::optional("reversed", Boolean, "true: the rod comes out while the coordinate shrinks"),
    Key::optional("stroke_reserve", Free, "travel kept free at each end, 0 unless given"),
    Key::optional("catalogue", Text, "TOML file with entries of your own; one of a built-in name takes its place"),
    Key::optional("builtin", Boolean, "false: only what is in `catalogue`"),
    Key::optional("supply", Value(D::PRESSURE), "gauge pressure at the valve, the lowest that occurs (required)"),
    Key::optional("atmosphere", Value(D::PRESSURE), "absolute pressure around; 1.013 bar unless given"),
    Key::optional(
        "load_factor",
        Value(D::NONE),
        "share of the theoretical force that may be used; 0.7 unless given, 0.5 is usual for fast motion",
    ),
    Key::optional(
        "efficiency",
        Value(D::NONE),
        "share of the force that gets past the seals, where the load factor does not cover them; 1 unless given",
    ),
    Key::optional(
        "standards",
        Texts,
        "only cylinders of these standards, and those without one; all unless given: [\"ISO 15552\", \"ISO 6432\"]",
    ),
    Key::optional(
        "mounting",
        OneOf(&["rear", "centre", "front"]),
        "where the body is held: the buckling column has 2, 1.5 or 1 strokes; rear unless given",
    ),
    Key::optional(
        "ends",
        OneOf(&["fixed-free", "pinned-pinned", "fixed-pinned", "fixed-fixed"]),
        "Euler's case of body and rod end; pinned-pinned unless given",
    ),
    Key::optional(
        "offset",
        Value(D::LENGTH),
        "added to the buckling column: rod eye, clevis, body where the catalogue gives no base length; 0 unless given",
    ),
    Key::optional("buckling_safety", Value(D::NONE), "5 unless given"),
    Key::optional(
        "buckling_load",
        OneOf(&["duty", "supply"]),
        "what must not buckle the rod: the largest push of the study (unless given), or that of the full supply",
    ),
    Key::optional("moved_mass", Value(D::MASS), "mass that arrives at the ends, reduced to the rod; for the cushion"),
    Key::optional("arrival_speed", Value(D::VELOCITY), "speed at the ends; the largest of the study unless given"),
    Key::optional(
        "cycles",
        Value(D::FREQUENCY),
        "double strokes in a time, as \"12 1/min\" or \"0.2 Hz\"; for the mean air",
    ),
    Key::optional("dead_volume", Value(D::VOLUME), "of tubes and ports, both sides, filled each time; 0 unless given"),
    Key::optional("valve", Table(&VALVE), "the valve that feeds the cylinder"),
    Key::optional("safety", Value(D::NONE), "factor on the efforts of an electric drive; 1 unless given"),
    Key::optional(
        "cycle_time",
        Value(D::TIME),
        "time of a whole cycle, the rest of it without effort; the study follows itself unless given",
    ),
];

/// Keys that have a meaning for cylinders alone.
pub(crate) const PNEUMATIC_KEYS: &[&str] = &[
    "supply",
    "atmosphere",
    "load_factor",
    "efficiency",
    "standards",
    "mounting",
    "ends",
    "offset",
    "buckling_safety",
    "buckling_load",
    "moved_mass",
    "arrival_speed",
    "cycles",
    "dead_volume",
    "valve",
];

/// Keys that have a meaning for electric drives alone.
pub(crate) const ELECTRIC_KEYS: &[&str] = &["safety", "cycle_time"];

/// m^3/(s*Pa)
const CONDUCTANCE: D = D::of(4, -1, 1, 0, 0);

pub(crate) static VALVE: Schema = Schema {
    name: "valve",
    doc: "A valve, with its tubes, after ISO 6358.",
    keys: &[
        Key::required("sonic_conductance", Value(CONDUCTANCE), "C of the data sheet, as \"2 L/(s*bar)\""),
        Key::required("critical_ratio", Value(D::NONE), "b of the data sheet, 0 to below 1"),
        Key::optional("subsonic_index", Value(D::NONE), "m of the data sheet; 0.5 unless given"),
    ],
    kinds: &[],
    usual: None,
};
