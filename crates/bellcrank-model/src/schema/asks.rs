//! Keys of studies that ask something of another study.

use bellcrank_doc::Dimension as D;

use super::keys::Shape::{
    Between, Boolean, ByParameter, Comparisons, Directions, Free, Name, Names, Objective, OneOf, Response, Responses,
    Text, Value, Whole,
};
use super::keys::{Key, Schema, Short};

/// Kinds of studies that ask, and are read into [`crate::design::Ask`].
pub(crate) const ASKING: &[&str] = &["sensitivity", "optimize", "sweep", "tolerance", "sizing"];

/// Kinds of studies that can be asked: they have rows of signals.
pub(crate) const WITH_ROWS: &[&str] = &["kinematics", "inverse-dynamics", "statics", "dynamics"];

/// Kinds of studies whose rows have forces in them.
pub(crate) const LOADING: &[&str] = &["inverse-dynamics", "statics", "dynamics"];

const fn plain(name: &'static str, doc: &'static str, keys: &'static [Key]) -> Schema {
    Schema { name, doc, keys, kinds: &[], usual: None }
}

pub(super) const OF: Key = Key::optional(
    "of",
    Name,
    "the study that gives the numbers, of kind kinematics, inverse-dynamics, statics or dynamics (required)",
);
const RESPONSE: Key =
    Key::optional("response", Response, "one number of that study, as \"max(abs(drive.slide.force))\" (required)");
const SEED: Key = Key::optional("seed", Whole(0, i64::MAX), "start of the random numbers; 1 unless given");

pub(super) const SENSITIVITY: &[Key] = &[
    OF,
    RESPONSE,
    Key::optional("parameters", Names, "with respect to these; all that are plain numbers unless given"),
    Key::optional(
        "points",
        Whole(0, 10_000),
        "samples of the response over the range of each parameter; 41 unless given, 0 for none",
    ),
];

pub(super) const OPTIMIZE: &[Key] = &[
    OF,
    Key::optional(
        "minimize",
        Objective(&OBJECTIVE),
        "a response, as \"max(abs(drive.slide.force))\", or a list of them, each with a weight; this or `maximize`",
    ),
    Key::optional("maximize", Objective(&OBJECTIVE), "likewise; this or `minimize`"),
    Key::optional(
        "variables",
        ByParameter(&VARIABLE, Short::Nothing),
        "parameters that may change, as [\"l5\"] or { l5 = { min = \"800 mm\" } }; bounds from here, else from \
         the parameter (required)",
    ),
    Key::optional("subject_to", Comparisons, "comparisons that must hold"),
    Key::optional("starts", Whole(1, 1_000_000), "number of starting points; 1 unless given"),
    SEED,
    Key::optional("tolerance", Value(D::NONE), "how exactly the optimum is met (first-order optimality)"),
    Key::optional("iterations", Whole(1, 1_000_000), "at most so many from each starting point"),
];

pub(super) const DESIGNS: &[Key] = &[
    OF,
    Key::optional(
        "responses",
        Responses,
        "numbers of that study, as [\"max(drive.slide.force)\"] or { peak = \"max(drive.slide.force)\" } (required)",
    ),
    Key::optional(
        "vary",
        ByParameter(&RANGE, Short::Levels),
        "parameters and their values, as [\"l5\"] or { l5 = [\"900 mm\", \"950 mm\"] }; required without `table`",
    ),
    Key::optional(
        "method",
        OneOf(&["grid", "lhs", "sobol", "table"]),
        "how the designs lie: every combination, Latin hypercube, Sobol points, or those of `table`; grid unless given",
    ),
    Key::optional("table", Text, "CSV file of designs: a column a parameter, `l31 [mm],l5 [mm]`"),
    Key::optional("samples", Whole(1, 1_000_000_000), "number of designs of the methods lhs and sobol"),
    SEED,
    Key::optional("pareto", Directions, "two responses that oppose each other, each \"min\" or \"max\""),
];

pub(super) const TOLERANCE: &[Key] = &[
    OF,
    RESPONSE,
    Key::optional(
        "tolerances",
        ByParameter(&SCATTER, Short::Value),
        "parameters that scatter, as [\"l5\"] or { l5 = \"0.1 mm\" }; all with a tolerance unless given",
    ),
    Key::optional("limits", Between(&LIMITS), "allowed range of the response"),
    Key::optional("samples", Whole(0, 1_000_000_000), "number of machines drawn; 10000 unless given, 0 for none"),
    SEED,
    Key::optional("sobol", Boolean, "shares of the variance that hold for any response (Sobol' indices), too"),
    Key::optional(
        "distribution",
        OneOf(DISTRIBUTIONS),
        "of parameters that have none of their own; normal unless given",
    ),
];

/// As `bellcrank-doc` reads them at parameters.
const DISTRIBUTIONS: &[&str] = &["uniform", "normal", "truncated"];

pub(crate) static OBJECTIVE: Schema = plain(
    "objective",
    "A part of the objective.",
    &[
        Key::required("response", Response, "one number of the study"),
        Key::optional("weight", Value(D::NONE), "above 0; 1 unless given"),
    ],
);

pub(crate) static VARIABLE: Schema = plain(
    "variable",
    "Bounds of a parameter in this study.",
    &[
        Key::optional("min", Free, "lower bound; that of the parameter unless given"),
        Key::optional("max", Free, "upper bound; that of the parameter unless given"),
    ],
);

pub(crate) static RANGE: Schema = plain(
    "range",
    "Values of a parameter in this study.",
    &[
        Key::optional("from", Free, "first value; `min` of the parameter unless given"),
        Key::optional("to", Free, "last value; `max` of the parameter unless given"),
        Key::optional("min", Free, "another word for `from`"),
        Key::optional("max", Free, "another word for `to`"),
        Key::optional("points", Whole(2, 1_000_000), "levels in a grid; 11 unless given"),
    ],
);

pub(crate) static SCATTER: Schema = plain(
    "scatter",
    "How a parameter scatters in this study.",
    &[
        Key::optional("tolerance", Free, "half width: the value lies within ± this"),
        Key::optional("sigma", Free, "standard deviation; a third of the tolerance unless given"),
        Key::optional("distribution", OneOf(DISTRIBUTIONS), "that of the parameter unless given"),
    ],
);

pub(crate) static LIMITS: Schema = plain(
    "limits",
    "Allowed range of the response; one side may be missing.",
    &[
        Key::optional("min", Free, "smallest value that is good"),
        Key::optional("max", Free, "largest value that is good"),
    ],
);
