//! Reading a table by its schema: dimensions and whether a key must be there come from one place.

use bellcrank_doc::{Diagnostic, Dimension, Expression, Fields, Reader, Signals, Span, Spanned, Value, ValueKind};

use crate::measure::Motion;
use crate::schema::{AXES, Key, OPEN, Schema, Shape};

/// What other programs call a key.
const OTHER_WORDS: &[(&str, &str)] = &[
    ("objective", "minimize"),
    ("goal", "minimize"),
    ("cost", "minimize"),
    ("constraints", "subject_to"),
    ("constraint", "subject_to"),
    ("parameters", "variables"),
    ("parameters", "vary"),
    ("parameters", "tolerances"),
    ("variables", "parameters"),
    ("variables", "vary"),
    ("vary", "parameters"),
    ("vary", "variables"),
    ("study", "of"),
    ("max_iterations", "iterations"),
    ("rho", "density"),
    ("E", "young"),
    ("nu", "poisson"),
    ("G", "shear"),
    ("yield_strength", "yield"),
    ("hole", "bore"),
    ("diameter", "outer"),
    ("radius", "fillet"),
];

/// A cursor over a table of a known schema.
pub(crate) struct Keyed<'a> {
    fields: Fields<'a>,
    schema: &'static Schema,
    kind: Option<&'static str>,
    /// Dimensions of the space, 2 or 3.
    space: usize,
}

impl<'a> Keyed<'a> {
    /// Opens a table; one with kinds reads its `kind` first.
    pub(crate) fn new(fields: Fields<'a>, schema: &'static Schema, space: usize) -> Keyed<'a> {
        let kinds: Vec<&'static str> = schema.kinds.iter().map(|kind| kind.name).collect();
        let kind = match (kinds.is_empty(), schema.usual) {
            (true, _) => None,
            (false, Some(usual)) if !fields.has("kind") => Some(usual),
            _ => kind_of(&fields, &kinds),
        };
        let hints = move |key: &str| what_to_write(schema, kind, space, key);
        Keyed { fields: fields.with_hints(hints).with_other_words(OTHER_WORDS), schema, kind, space }
    }

    /// Opens a table whose kind is known from elsewhere.
    pub(crate) fn of_kind(fields: Fields<'a>, schema: &'static Schema, kind: &'static str, space: usize) -> Keyed<'a> {
        fields.has("kind");
        let hints = move |key: &str| what_to_write(schema, Some(kind), space, key);
        let fields = fields.with_hints(hints).with_other_words(OTHER_WORDS);
        Keyed { fields, schema, kind: Some(kind), space }
    }

    pub(crate) fn kind(&self) -> Option<&'static str> {
        self.kind
    }

    pub(crate) fn reader(&self) -> &'a Reader<'a> {
        self.fields.reader()
    }

    pub(crate) fn span(&self) -> Span {
        self.fields.span()
    }

    pub(crate) fn what(&self) -> &str {
        self.fields.what()
    }

    /// Reports an error about a place in this table.
    pub(crate) fn report(&self, diagnostic: Diagnostic) {
        self.reader().report(diagnostic);
    }

    /// Reports an error about this table as a whole.
    pub(crate) fn fault(&self, code: &'static str, message: impl Into<String>) {
        self.fields.fault(code, message);
    }

    /// The key in messages.
    pub(crate) fn named(&self, name: &str) -> String {
        format!("`{name}` of {}", self.fields.what())
    }

    pub(crate) fn has(&self, name: &'static str) -> bool {
        self.fields.has(name)
    }

    /// The raw value; reported when absent and required.
    pub(crate) fn value(&self, name: &'static str) -> Option<&'a Value> {
        if self.key(name)?.required { self.fields.value(name) } else { self.fields.optional_value(name) }
    }

    /// A value over the parameters.
    pub(crate) fn quantity(&self, name: &'static str) -> Option<Expression> {
        let key = self.key(name)?;
        let Shape::Value(dimension) = key.shape else { return None };
        if key.required {
            self.fields.quantity(name, dimension)
        } else {
            self.fields.optional_quantity(name, dimension)
        }
    }

    /// The raw value of a key that is needed here, whatever the schema says of it elsewhere.
    pub(crate) fn needed(&self, name: &'static str) -> Option<&'a Value> {
        self.key(name)?;
        self.fields.value(name)
    }

    /// A value over the parameters whose dimension follows from elsewhere.
    pub(crate) fn free(&self, name: &'static str, dimension: Dimension) -> Option<Expression> {
        let Shape::Free = self.key(name)?.shape else { return None };
        self.fields.optional_quantity(name, dimension)
    }

    /// A value over the parameters, along a joint coordinate.
    pub(crate) fn along(&self, name: &'static str, motion: Motion) -> Option<Expression> {
        let key = self.key(name)?;
        let Shape::Along(along) = key.shape else { return None };
        let dimension = along.dimension(motion);
        if key.required {
            self.fields.quantity(name, dimension)
        } else {
            self.fields.optional_quantity(name, dimension)
        }
    }

    /// A value over parameters and signals; `motion` is that of the joint coordinate it belongs to, if any.
    pub(crate) fn signal(
        &self,
        name: &'static str,
        motion: Option<Motion>,
        signals: &mut dyn Signals,
    ) -> Option<Expression> {
        let key = self.key(name)?;
        let dimension = match (key.shape, motion) {
            (Shape::Signal(dimension), _) => dimension,
            (Shape::Along(along), Some(motion)) => along.dimension(motion),
            _ => return None,
        };
        let value = self.value(name)?;
        self.reader().signal_quantity(value, &self.named(name), dimension, signals)
    }

    /// As many values as the space has dimensions.
    pub(crate) fn vector(&self, name: &'static str) -> Option<Vec<Expression>> {
        let Shape::Vector(dimension) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        space_vector(self.reader(), value, &self.named(name), dimension, self.space)
    }

    /// The same over signals.
    pub(crate) fn signal_vector(&self, name: &'static str, signals: &mut dyn Signals) -> Option<Vec<Expression>> {
        let Shape::SignalVector(dimension) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        fits_space(self.reader(), value, &self.named(name), self.space)?;
        self.reader().signal_vector(value, &self.named(name), &vec![dimension; self.space], signals)
    }

    /// A list of values of one dimension.
    pub(crate) fn list(&self, name: &'static str) -> Option<Vec<Expression>> {
        let Shape::List(dimension, lengths) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        self.reader().uniform_vector(value, &self.named(name), dimension, lengths)
    }

    /// The same, or a single value where the list may have one.
    pub(crate) fn one_or_list(&self, name: &'static str) -> Option<Vec<Expression>> {
        let Shape::List(dimension, lengths) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        if value.as_list().is_none() && lengths.contains(&1) {
            return self.reader().quantity(value, &self.named(name), dimension).map(|one| vec![one]);
        }
        self.reader().uniform_vector(value, &self.named(name), dimension, lengths)
    }

    /// A list of pairs of values.
    pub(crate) fn pairs(&self, name: &'static str) -> Option<Vec<[Expression; 2]>> {
        let Shape::Pairs(dimension) = self.key(name)?.shape else { return None };
        let what = self.named(name);
        let pair = |value: &Value| {
            let pair = self.reader().uniform_vector(value, &format!("each pair of {what}"), dimension, &[2])?;
            pair.try_into().ok()
        };
        let pairs: Vec<Option<[Expression; 2]>> =
            self.reader().list(self.value(name)?, &what)?.iter().map(pair).collect();
        pairs.into_iter().collect()
    }

    /// Text, or a name.
    pub(crate) fn text(&self, name: &'static str) -> Option<Spanned<&'a str>> {
        if self.key(name)?.required { self.fields.string(name) } else { self.fields.optional_string(name) }
    }

    /// A list of names.
    pub(crate) fn texts(&self, name: &'static str) -> Option<Vec<Spanned<&'a str>>> {
        if self.key(name)?.required { self.fields.strings(name) } else { self.fields.optional_strings(name) }
    }

    /// One of some words.
    pub(crate) fn choice(&self, name: &'static str) -> Option<Spanned<&'static str>> {
        let key = self.key(name)?;
        let Shape::OneOf(words) = key.shape else { return None };
        if key.required { self.fields.one_of(name, words) } else { self.fields.optional_one_of(name, words) }
    }

    pub(crate) fn boolean(&self, name: &'static str) -> Option<Spanned<bool>> {
        self.key(name)?;
        self.fields.optional_boolean(name)
    }

    pub(crate) fn whole(&self, name: &'static str) -> Option<Spanned<i64>> {
        let key = self.key(name)?;
        let Shape::Whole(from, to) = key.shape else { return None };
        if key.required { self.fields.integer(name, from..=to) } else { self.fields.optional_integer(name, from..=to) }
    }

    /// A table of its own; with its place in the file.
    pub(crate) fn table(&self, name: &'static str) -> Option<Keyed<'a>> {
        let Shape::Table(schema) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        let fields = self.reader().fields(value, &self.named(name))?;
        Some(Keyed::new(fields, schema, self.space))
    }

    /// `true` or `false`, or a table of its own.
    pub(crate) fn switch(&self, name: &'static str) -> Option<Switch<'a>> {
        let Shape::Switch(schema) = self.key(name)?.shape else { return None };
        let value = self.value(name)?;
        if value.as_table().is_none() {
            return self.reader().boolean(value, &self.named(name)).map(|flag| Switch::Flag(flag.value));
        }
        let fields = self.reader().fields(value, &self.named(name))?;
        Some(Switch::Table(Keyed::new(fields, schema, self.space)))
    }

    /// An axis: a letter, or a vector of the space (three components are accepted in the plane, too).
    pub(crate) fn axis(&self, name: &'static str) -> Option<Axis> {
        let value = self.value(name)?;
        let what = self.named(name);
        if value.as_str().is_some() {
            let letter = self.reader().one_of(value, &what, AXES)?;
            return Some(Axis { span: value.span, kind: AxisKind::Letter(letter.value) });
        }
        let lengths: &[usize] = if self.space == 2 { &[2, 3] } else { &[3] };
        let components = self.reader().uniform_vector(value, &what, Dimension::NONE, lengths)?;
        Some(Axis { span: value.span, kind: AxisKind::Vector(components) })
    }

    /// Whether this table has the key, and how it is read.
    fn key(&self, name: &'static str) -> Option<&'static Key> {
        let found = self.schema.keys_of(self.kind).find(|key| key.name == name);
        debug_assert!(
            found.is_some() || self.kind.is_some() || self.schema.kinds.is_empty(),
            "`{name}` is not in the schema of {}",
            self.schema.name
        );
        found
    }

    /// Reports the keys that the schema does not have.
    pub(crate) fn finish(self) {
        for key in self.schema.keys_of(self.kind) {
            self.fields.has(key.name);
        }
        if !self.kind.is_some_and(|kind| OPEN.contains(&kind)) {
            self.fields.finish();
        }
    }
}

/// Words for kinds in other programs and books.
const ALSO_CALLED: &[(&str, &str)] = &[
    ("hinge", "revolute"),
    ("pin", "revolute"),
    ("rotational", "revolute"),
    ("rotary", "revolute"),
    ("slider", "prismatic"),
    ("translational", "prismatic"),
    ("slide", "prismatic"),
    ("cardan", "universal"),
    ("hooke", "universal"),
    ("ball", "spherical"),
    ("fixed", "weld"),
    ("rigid", "weld"),
    ("gear", "coupler"),
    ("helical", "screw"),
    ("cylinder", "distance"),
    ("rod", "distance"),
    ("moment", "torque"),
    ("damper", "spring"),
    ("torsion-spring", "joint-spring"),
    ("motor", "effort"),
];

fn kind_of(fields: &Fields<'_>, kinds: &[&'static str]) -> Option<&'static str> {
    let written = fields.optional_value("kind").and_then(|value| Some((value.as_str()?, value.span)));
    let (word, span) = match written {
        Some((word, span)) if !kinds.contains(&word) => (word.to_lowercase(), span),
        _ => return fields.one_of("kind", kinds).map(|kind| kind.value),
    };
    let meant = ALSO_CALLED.iter().find(|(other, kind)| *other == word && kinds.contains(kind));
    let Some((_, meant)) = meant else { return fields.one_of("kind", kinds).map(|kind| kind.value) };
    let message = format!("`kind` of {} cannot be `{word}`", fields.what());
    fields
        .reader()
        .report(Diagnostic::error("unknown-choice", span, message).hint(format!("here it is called `{meant}`")));
    None
}

/// As many values as the space has dimensions.
pub(crate) fn space_vector(
    reader: &Reader<'_>,
    value: &Value,
    what: &str,
    dimension: Dimension,
    space: usize,
) -> Option<Vec<Expression>> {
    fits_space(reader, value, what, space)?;
    reader.vector(value, what, &vec![dimension; space])
}

/// Reports what is no list of as many values as the space has dimensions.
fn fits_space(reader: &Reader<'_>, value: &Value, what: &str, space: usize) -> Option<()> {
    let found = match (value.as_list(), &value.kind) {
        (Some(list), _) if list.len() == space => return Some(()),
        (_, ValueKind::Faulty) => return None,
        (Some(list), _) => list.len().to_string(),
        (None, _) => value.describe().to_owned(),
    };
    let message = format!("{what} needs {space} values, found {found}");
    let hint = match space {
        2 => "the model is planar: `[x, y]`, a unit with each that is not 0",
        _ => "the model is spatial: `[x, y, z]`, a unit with each that is not 0",
    };
    reader.report(Diagnostic::error("wrong-length", value.span, message).hint(hint));
    None
}

/// What to write where a required key is absent.
fn what_to_write(schema: &'static Schema, kind: Option<&str>, space: usize, key: &str) -> Option<String> {
    if key == "kind" {
        let kinds: Vec<String> = schema.kinds.iter().map(|kind| format!("`{}`", kind.name)).collect();
        return Some(format!("one of {}", kinds.join(", ")));
    }
    let found = schema.keys_of(kind).find(|known| known.name == key)?;
    Some(match (found.shape, key, space) {
        (Shape::Version, ..) => format!("write `{key} = 1` at the top"),
        (Shape::OneOf(words), ..) => {
            let words: Vec<String> = words.iter().map(|word| format!("`{key} = \"{word}\"`")).collect();
            format!("write {}", words.join(" or "))
        }
        (_, "gravity", 2) => "write `gravity = [0, \"-9.81 m/s^2\"]`, or `[0, 0]` for none".to_owned(),
        (_, "gravity", _) => "write `gravity = [0, 0, \"-9.81 m/s^2\"]`, or `[0, 0, 0]` for none".to_owned(),
        (_, "connects", _) => "two points: `connects = [\"ground.O\", \"crank.O\"]`".to_owned(),
        _ => format!("`{key}`: {}", found.doc.trim_end_matches(" (required)")),
    })
}

/// `true`, `false` or a table.
pub(crate) enum Switch<'a> {
    Flag(bool),
    Table(Keyed<'a>),
}

/// An axis as written.
pub(crate) struct Axis {
    pub(crate) span: Span,
    pub(crate) kind: AxisKind,
}

pub(crate) enum AxisKind {
    Letter(&'static str),
    Vector(Vec<Expression>),
}
