//! A flexible body in its worst row as a picture of a part.

use std::borrow::Cow;

use bellcrank_results::{Contour, ContourField, ContourMark, ContourShape, Extreme, FlexibleMotion, StudyResult};

use crate::{findings, number};

/// The contours of a study, then its flexible bodies in their worst rows.
pub(crate) fn contours(study: &StudyResult) -> Vec<Cow<'_, Contour>> {
    let stills = study.motions.iter().map(|motion| Cow::Owned(still(study, motion)));
    study.contours.iter().map(Cow::Borrowed).chain(stills).collect()
}

/// Without a surface where the numbers do not belong together.
fn still(study: &StudyResult, motion: &FlexibleMotion) -> Contour {
    let row = motion.rows.get(motion.worst).copied().unwrap_or(0);
    let place = findings::whereabouts(study, Extreme { value: f64::NAN, row });
    let axis = study.axis.first().filter(|_| study.axis.len() == 1 && !place.is_empty());
    let place = axis.map_or(place.clone(), |axis| format!("{axis} = {place}"));
    let at = if place.is_empty() { String::new() } else { format!(" at {place}, where it is largest") };
    let title = format!("{}: stress{at}", motion.body);
    if motion.is_whole() { in_row(motion, motion.worst, title) } else { Contour { title, ..Contour::default() } }
}

/// The body in one of its rows: stress and displacement then, and the largest stress over all rows.
pub(crate) fn in_row(motion: &FlexibleMotion, at: usize, title: String) -> Contour {
    let nodes = 0..motion.nodes.len();
    let moved: Vec<[f64; 3]> = nodes.clone().map(|node| motion.displacement(at, node)).collect();
    let field = |name: &str, unit: &bellcrank_results::Unit, values: Vec<f32>| ContourField {
        name: name.to_owned(),
        unit: unit.clone(),
        values,
        ceiling: None,
    };
    let cut = |field: ContourField| ContourField { ceiling: ceiling(motion, &field.values), ..field };
    let mises = field("von Mises stress", &motion.unit, nodes.map(|node| motion.von_mises(at, node) as f32).collect());
    let largest = field("largest von Mises stress over the rows", &motion.unit, motion.envelope.clone());
    let far = moved.iter().map(|u| u.iter().map(|x| x * x).sum::<f64>().sqrt() as f32);
    let shape = ContourShape {
        name: String::new(),
        displacement: moved.iter().map(|u| u.map(|x| x as f32)).collect(),
        swings: false,
        fields: vec![cut(mises), cut(largest), field("displacement", &motion.length, far.collect())],
    };
    Contour {
        title,
        nodes: motion.nodes.clone(),
        numbers: motion.numbers.clone(),
        triangles: motion.triangles.clone(),
        edges: motion.edges.clone(),
        shapes: vec![shape],
        marks: motion.marks.iter().map(|mark| label(motion, mark, at)).collect(),
    }
}

/// Where colours end, where there is something above.
fn ceiling(motion: &FlexibleMotion, values: &[f32]) -> Option<f32> {
    motion.ceiling.filter(|ceiling| values.iter().any(|value| *value > 1.0001 * ceiling))
}

fn label(motion: &FlexibleMotion, mark: &bellcrank_results::MotionMark, at: usize) -> ContourMark {
    let stress = mark.history.get(at).copied().unwrap_or(f64::NAN);
    let stress = number::with_unit(&number::significant(motion.unit.show(stress), 4), &motion.unit.symbol);
    let doubt = if mark.doubtful { ", not to be trusted" } else { "" };
    let at = motion.nodes.get(mark.node as usize).copied().unwrap_or_default();
    ContourMark { label: format!("{}: {stress}{doubt}", mark.label), at, doubtful: mark.doubtful }
}
