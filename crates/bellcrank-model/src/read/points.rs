//! Named points of a body.

use bellcrank_doc::{Diagnostic, Entry, Value};

use super::PartReader;
use crate::design::{Point, Rotation};
use crate::keyed::{Keyed, space_vector};
use crate::names;
use crate::schema::PLACE;

/// Whose points are read.
pub(crate) struct Owner {
    /// In messages.
    pub(crate) what: String,
    /// Stands before the names: `lift.ground.` for the ground of a subsystem.
    pub(crate) prefix: String,
    /// The point that they are given in.
    pub(crate) base: Option<usize>,
}

/// Reads a table of points.
pub(crate) fn read(part: PartReader<'_>, value: &Value, owner: &Owner) -> Vec<Point> {
    let Some(fields) = part.reader.fields(value, &format!("`points` of {}", owner.what)) else { return Vec::new() };
    let point = |entry: &Entry| {
        if let Some(fault) = names::fault(entry, "point") {
            part.reader.report(fault);
        }
        read_point(part, entry, owner)
    };
    fields.table().iter().filter_map(point).collect()
}

/// A point that cannot be read is kept at the origin: what refers to it is not wrong for that.
pub(crate) fn read_point(part: PartReader<'_>, entry: &Entry, owner: &Owner) -> Option<Point> {
    let what = format!("point `{}` of {}", entry.key, owner.what);
    let mut point = Point {
        name: format!("{}{}", owner.prefix, entry.key),
        span: entry.key_span,
        at: Vec::new(),
        rotation: Rotation::None,
        base: owner.base,
        planar: part.planar,
    };
    if entry.value.as_table().is_some() {
        let keyed = Keyed::new(part.reader.fields(&entry.value, &what)?, &PLACE, part.space());
        point.at = keyed.vector("at").map(|at| part.quantities(at)).unwrap_or_default();
        point.rotation = rotation(part, &keyed);
        keyed.finish();
    } else {
        let at = space_vector(part.reader, &entry.value, &what, bellcrank_doc::Dimension::LENGTH, part.space());
        point.at = at.map(|at| part.quantities(at)).unwrap_or_default();
    }
    Some(point)
}

fn rotation(part: PartReader<'_>, keyed: &Keyed<'_>) -> Rotation {
    let given: Vec<&str> = ["rotate", "quaternion", "rpy"].into_iter().filter(|key| keyed.has(key)).collect();
    if given.len() > 1 {
        let message = format!("{} has more than one orientation: {}", keyed.what(), given.join(", "));
        keyed.report(Diagnostic::error("conflicting-keys", keyed.span(), message));
    }
    if let Some(values) = keyed.list("quaternion") {
        return Rotation::Quaternion(part.quantities(values));
    }
    if let Some(values) = keyed.list("rpy") {
        return Rotation::Rpy(part.quantities(values));
    }
    keyed.table("rotate").and_then(|rotate| about(part, rotate)).unwrap_or(Rotation::None)
}

fn about(part: PartReader<'_>, rotate: Keyed<'_>) -> Option<Rotation> {
    let axis = rotate.axis("axis").map(|axis| part.direction(axis));
    let angle = rotate.quantity("angle").map(|angle| part.quantity(angle));
    let axis = axis.unwrap_or_else(|| PartReader::z(rotate.span()));
    rotate.finish();
    Some(Rotation::About { axis, angle: angle? })
}
