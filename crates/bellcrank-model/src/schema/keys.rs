//! What a key may hold.

use bellcrank_doc::Dimension;

use crate::measure::Motion;

/// A quantity that follows the kind of a joint coordinate: a length or an angle and what is made of it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Along {
    Position,
    Velocity,
    Acceleration,
    Effort,
    Stiffness,
    Damping,
}

impl Along {
    pub(crate) fn dimension(self, motion: Motion) -> Dimension {
        let (slide, turn) = match self {
            Along::Position => (Dimension::LENGTH, Dimension::ANGLE),
            Along::Velocity => (Dimension::VELOCITY, Dimension::ANGULAR_VELOCITY),
            Along::Acceleration => (Dimension::ACCELERATION, Dimension::ANGULAR_ACCELERATION),
            Along::Effort => (Dimension::FORCE, Dimension::MOMENT),
            Along::Stiffness => (Dimension::STIFFNESS, Dimension::TORSIONAL_STIFFNESS),
            Along::Damping => (Dimension::DAMPING, Dimension::TORSIONAL_DAMPING),
        };
        match motion {
            Motion::Slide => slide,
            Motion::Turn => turn,
        }
    }
}

/// Axes that have a name.
pub(crate) const AXES: &[&str] = &["x", "y", "z", "-x", "-y", "-z"];

/// What a key may hold.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Shape {
    /// The format version.
    Version,
    /// Any text.
    Text,
    /// A list of texts.
    Texts,
    /// The name of something else in the file.
    Name,
    /// A list of such names.
    Names,
    /// `true` or `false`.
    Boolean,
    /// A whole number from .. to.
    Whole(i64, i64),
    /// One of some words.
    OneOf(&'static [&'static str]),
    /// A value over the parameters.
    Value(Dimension),
    /// A value over parameters, `time` and signals.
    Signal(Dimension),
    /// A value (over signals, too) whose dimension is that of a joint coordinate.
    Along(Along),
    /// As many values as the space has dimensions.
    Vector(Dimension),
    /// The same over signals.
    SignalVector(Dimension),
    /// A list of values of one dimension with one of these lengths.
    List(Dimension, &'static [usize]),
    /// A value or list of values, of dimensions that follow from elsewhere in the file.
    Values,
    /// `"x"`, `"y"`, `"z"`, one of them with a minus, or a vector.
    Axis,
    /// A value whose dimension follows from elsewhere in the file.
    Free,
    /// A time over the parameters, `after NAME` or `with NAME`.
    Start,
    /// An arithmetic expression over reductions of signals, or a comparison of two.
    Response,
    /// A list of such, or a table of named ones.
    Responses,
    /// A response, or a list of responses and of tables with a weight each.
    Objective(&'static Schema),
    /// A comparison of two responses, or a list of such.
    Comparisons,
    /// Names of parameters, or a table of what is said of each.
    ByParameter(&'static Schema, Short),
    /// A list of a lower and an upper value, or a table of them.
    Between(&'static Schema),
    /// A table of names, each made small or large.
    Directions,
    /// A table of its own.
    Table(&'static Schema),
    /// `true` or `false`, or a table of its own.
    Switch(&'static Schema),
    /// A list of tables.
    Tables(&'static Schema),
    /// A table of named tables.
    Named(&'static Schema),
    /// A table of named points.
    Points,
    /// A table of parameters.
    Parameters,
    /// A table of named values.
    Map,
    /// Names, or a table of named values.
    NamesOrMap,
    /// Which row of a study: a word, a number, or a table of a signal and its value.
    Row,
    /// A point of the body by name, or coordinates.
    Spot,
    /// A list of pairs of values of one dimension.
    Pairs(Dimension),
    /// A list of corners: places, or tables of what is said of each.
    Outline(&'static Schema),
}

/// What may stand in place of the table that is said of a parameter.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Short {
    Nothing,
    /// A value.
    Value,
    /// A list of values, or a number of levels.
    Levels,
}

/// Words for "made small" and "made large".
pub(crate) const DIRECTIONS: &[&str] = &["min", "max"];

/// A key of a table.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Key {
    pub(crate) name: &'static str,
    pub(crate) shape: Shape,
    pub(crate) required: bool,
    pub(crate) doc: &'static str,
}

impl Key {
    pub(crate) const fn required(name: &'static str, shape: Shape, doc: &'static str) -> Key {
        Key { name, shape, required: true, doc }
    }

    pub(crate) const fn optional(name: &'static str, shape: Shape, doc: &'static str) -> Key {
        Key { name, shape, required: false, doc }
    }
}

/// Keys that a table has when its `kind` is `name`.
#[derive(Debug)]
pub(crate) struct Kind {
    pub(crate) name: &'static str,
    pub(crate) doc: &'static str,
    pub(crate) keys: &'static [Key],
}

/// A table of the format.
#[derive(Debug)]
pub(crate) struct Schema {
    pub(crate) name: &'static str,
    pub(crate) doc: &'static str,
    /// Keys that it has whatever its kind.
    pub(crate) keys: &'static [Key],
    /// Kinds, when it has a key `kind`.
    pub(crate) kinds: &'static [Kind],
    /// The kind without that key, where it may be left out.
    pub(crate) usual: Option<&'static str>,
}

impl Schema {
    /// The keys of one kind, or of all.
    pub(crate) fn keys_of(&self, kind: Option<&str>) -> impl Iterator<Item = &'static Key> + use<'_> {
        let wanted = kind.map(str::to_owned);
        let kinds = self.kinds.iter().filter(move |k| wanted.as_deref().is_none_or(|w| w == k.name));
        self.keys.iter().chain(kinds.flat_map(|k| k.keys))
    }
}
