//! Places, heights and outlines of a solid.

use bellcrank_doc::{Diagnostic, Dimension, Entry, Span, Spanned, Value, ValueKind};

use crate::design::{CornerForm, Height, NamedSpot, Quantity, Spot};
use crate::keyed::Keyed;
use crate::read::PartReader;
use crate::schema::CORNER;

/// What reading a solid needs and collects.
pub(super) struct FormReader<'a> {
    pub(super) part: PartReader<'a>,
    /// The solid in messages.
    pub(super) solid: String,
    /// Thickness of what gives none.
    pub(super) thickness: Option<Quantity>,
    /// Points of the body that have been named.
    pub(super) points: Vec<NamedSpot>,
}

/// The entries of a table of named things, which may be absent.
pub(super) fn named<'a>(keyed: &Keyed<'a>, key: &'static str) -> Vec<&'a Entry> {
    let Some(value) = keyed.value(key) else { return Vec::new() };
    let fields = keyed.reader().fields(value, &keyed.named(key));
    fields.map_or_else(Vec::new, |fields| fields.table().iter().collect())
}

impl FormReader<'_> {
    /// In messages: "eye `B` of solid `link3`".
    pub(super) fn what(&self, kind: &str, name: &str) -> String {
        format!("{kind} `{name}` of {}", self.solid)
    }

    pub(super) fn quantity(&self, keyed: &Keyed<'_>, name: &'static str) -> Option<Quantity> {
        keyed.quantity(name).map(|one| self.part.quantity(one))
    }

    /// The point of the body with this name.
    pub(super) fn point(&mut self, name: &str, span: Span, what: &str) -> Spot {
        let known = self.points.iter().position(|point| point.name.value == name);
        Spot::Point(known.unwrap_or_else(|| {
            let name = Spanned { value: name.to_owned(), span };
            self.points.push(NamedSpot { name, what: what.to_owned() });
            self.points.len() - 1
        }))
    }

    /// A point by name, or coordinates: two in the plan of a link, as many as the space has for others.
    pub(super) fn spot(&mut self, value: &Value, what: &str, space: usize) -> Option<Spot> {
        if let Some(name) = value.as_str() {
            return Some(self.point(name, value.span, what));
        }
        let at = match value.as_list() {
            Some(_) => self.part.reader.uniform_vector(value, what, Dimension::LENGTH, &[space]),
            None => {
                if !matches!(value.kind, ValueKind::Faulty) {
                    let message =
                        format!("{what} needs the name of a point or a list of {space}, found {}", value.describe());
                    self.part.reader.report(Diagnostic::error("wrong-type", value.span, message));
                }
                None
            }
        };
        at.map(|at| Spot::At(self.part.quantities(at)))
    }

    /// The same of a key that has to be there.
    pub(super) fn spot_of(&mut self, keyed: &Keyed<'_>, name: &'static str, space: usize) -> Option<Spot> {
        let value = keyed.value(name)?;
        self.spot(value, &keyed.named(name), space)
    }

    /// Where something is along the axis: `layers`, or one of `thickness` with or without an `offset`, else the
    /// thickness of the solid.
    pub(super) fn height(&self, keyed: &Keyed<'_>, thickness: &[&'static str]) -> Option<Height> {
        match self.own_height(keyed, thickness)? {
            Some(height) => Some(height),
            None => match &self.thickness {
                Some(thickness) => {
                    Some(Height::Middle { thickness: thickness.clone(), offset: self.quantity(keyed, "offset") })
                }
                None => {
                    let name = thickness[0];
                    let message = format!("`{name}` is missing in {}", keyed.what());
                    let hint =
                        format!("give it `{name}` or `layers`, or the solid a `thickness` for all that have none");
                    keyed.report(Diagnostic::error("missing-key", keyed.span(), message).hint(hint));
                    None
                }
            },
        }
    }

    /// The same without the thickness of the solid; `Some(None)` where nothing is said.
    pub(super) fn own_height(&self, keyed: &Keyed<'_>, thickness: &[&'static str]) -> Option<Option<Height>> {
        let given: Vec<&'static str> = thickness.iter().copied().filter(|name| keyed.has(name)).collect();
        let layers = keyed.has("layers").then_some("layers");
        let offset = keyed.has("offset").then_some("offset").filter(|_| layers.is_some());
        let said: Vec<String> =
            given.iter().copied().chain(layers).chain(offset).map(|name| format!("`{name}`")).collect();
        if said.len() > 1 {
            let message =
                format!("{} says where it is along the axis in more than one way: {}", keyed.what(), said.join(", "));
            keyed.report(Diagnostic::error("conflicting-keys", keyed.span(), message));
            return None;
        }
        if layers.is_some() {
            return Some(Some(Height::Layers(self.layers(keyed)?)));
        }
        match given.first() {
            Some(name) => {
                let thickness = self.quantity(keyed, name)?;
                Some(Some(Height::Middle { thickness, offset: self.quantity(keyed, "offset") }))
            }
            None => Some(None),
        }
    }

    fn layers(&self, keyed: &Keyed<'_>) -> Option<Vec<[Quantity; 2]>> {
        let layers = keyed.pairs("layers")?;
        if layers.is_empty() {
            let message = format!("{} has none", keyed.named("layers"));
            let span = keyed.value("layers").map_or(keyed.span(), |value| value.span);
            keyed.report(
                Diagnostic::error("wrong-length", span, message).hint("as `layers = [[\"-10 mm\", \"10 mm\"]]`"),
            );
            return None;
        }
        Some(layers.into_iter().map(|pair| pair.map(|one| self.part.quantity(one))).collect())
    }

    /// `outline`: places, or tables with a radius.
    pub(super) fn outline(&mut self, keyed: &Keyed<'_>) -> Option<Vec<CornerForm>> {
        let value = keyed.value("outline")?;
        let what = keyed.named("outline");
        let corners: Vec<Option<CornerForm>> =
            self.part.reader.list(value, &what)?.iter().map(|corner| self.corner(corner, &what)).collect();
        if corners.len() < 3 {
            let message = format!("{what} needs three corners or more, found {}", corners.len());
            keyed.report(Diagnostic::error("wrong-length", value.span, message));
            return None;
        }
        corners.into_iter().collect()
    }

    fn corner(&mut self, value: &Value, what: &str) -> Option<CornerForm> {
        let what = format!("a corner of {what}");
        if value.as_table().is_none() {
            return Some(CornerForm { span: value.span, at: self.spot(value, &what, 2)?, radius: None });
        }
        let keyed = Keyed::new(self.part.reader.fields(value, &what)?, &CORNER, 2);
        let (at, radius) = (self.spot_of(&keyed, "at", 2), self.quantity(&keyed, "radius"));
        keyed.finish();
        Some(CornerForm { span: value.span, at: at?, radius })
    }
}
