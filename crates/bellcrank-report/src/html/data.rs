//! The numbers behind the drawing and the curves, packed into the page.
//!
//! One JSON block describes everything; the numbers of a study follow as one base64 block of
//! little-endian floats, which the description points into by byte offset. Columns are in display
//! units, drawings and poses in SI.

mod base64;
mod blob;
mod integers;
mod solids;
mod thinning;

use bellcrank_results::{
    Animation, Arrow, Column, Designs, Drawing, DrawnBody, DrawnJoint, Findings, Pose, RunResult, SpaceKind,
    StudyResult, upright,
};
use serde_json::{Value, json};

pub(crate) use base64::encoded;
use blob::Blob;
pub(crate) use integers::Integers;
pub(crate) use thinning::{kept_frames, kept_rows};

pub(crate) fn push(page: &mut String, run: &RunResult) {
    let mut blobs = Vec::new();
    let mut studies = Vec::new();
    for study in &run.studies {
        let mut blob = Blob::default();
        studies.push(described(study, &run.drawing, &mut blob));
        blobs.push(blob);
    }
    let data = json!({ "drawing": drawing(&run.drawing), "studies": studies });
    page.push_str("<script type=\"application/json\" id=\"bellcrank-data\">");
    // A `<` can only stand in a string; escaped, no name can end the block.
    page.push_str(&data.to_string().replace('<', "\\u003c"));
    page.push_str("</script>\n");
    for (index, blob) in blobs.iter().enumerate() {
        page.push_str(&format!("<script type=\"text/plain\" id=\"bellcrank-blob-{index}\">"));
        page.push_str(&String::from_utf8_lossy(&base64::encoded(blob.bytes())));
        page.push_str("</script>\n");
    }
}

fn described(study: &StudyResult, drawing: &Drawing, blob: &mut Blob) -> Value {
    let rows = kept_rows(study);
    let columns: Vec<Value> =
        study.table.columns.iter().map(|column| packed(column, &rows, &study.axis, blob)).collect();
    json!({
        "name": study.name,
        "axis": study.axis,
        "rows": rows.len(),
        "columns": columns,
        "animation": study.animation.as_ref().map(|animation| moves(animation, &rows, drawing, blob)),
        "designs": match &study.findings {
            Some(Findings::Designs(found)) => designs(found, blob),
            _ => Value::Null,
        },
    })
}

/// The rows of a sweep that the page holds, and which designs are the front of which responses.
fn designs(found: &Designs, blob: &mut Blob) -> Value {
    let rows: Vec<usize> = (0..found.sample.rows()).collect();
    let counted = ["design".to_owned()];
    let front = found.pareto.as_ref().map(|front| {
        let side = |index: usize| {
            let column = front.front.column(&front.objectives[index].0);
            column.map_or_else(Vec::new, |column| {
                column.values.iter().map(|si| column.unit.show(*si)).collect::<Vec<f64>>()
            })
        };
        json!({ "x": front.objectives[0].0, "y": front.objectives[1].0, "xs": side(0), "ys": side(1) })
    });
    json!({
        "rows": rows.len(),
        "total": found.total,
        "inputs": found.inputs,
        "columns": found.sample.columns.iter().map(|column| packed(column, &rows, &counted, blob)).collect::<Vec<_>>(),
        "front": front,
    })
}

/// A column that never changes is one number; axes keep double precision (long times need it).
fn packed(column: &Column, rows: &[usize], axes: &[String], blob: &mut Blob) -> Value {
    let (name, unit) = (&column.name, &column.unit);
    let shown = rows.iter().map(|row| unit.show(column.values.get(*row).copied().unwrap_or(f64::NAN)));
    let constant = shown.clone().next().filter(|first| shown.clone().all(|value| value == *first));
    if let Some(constant) = constant {
        return json!({ "name": name, "unit": unit.symbol, "constant": constant });
    }
    if axes.contains(name) {
        json!({ "name": name, "unit": unit.symbol, "at": blob.push_doubles(shown), "double": true })
    } else {
        json!({ "name": name, "unit": unit.symbol, "at": blob.push_floats(shown) })
    }
}

/// The frames: to which of the page's rows each belongs, poses, and arrows as three components.
fn moves(animation: &Animation, rows: &[usize], drawing: &Drawing, blob: &mut Blob) -> Value {
    let planar = matches!(drawing.space, SpaceKind::Planar);
    let kept = kept_frames(animation);
    let frames = kept.iter().filter_map(|frame| animation.frames.get(*frame));
    let arrows = kept.iter().filter_map(|frame| animation.arrows.get(*frame));
    let row_of = |frame: &usize| animation.rows.get(*frame).map(|row| place_among(rows, *row));
    json!({
        "rows": kept.iter().filter_map(row_of).collect::<Vec<_>>(),
        "bodies": animation.frames.first().map_or(0, Vec::len),
        "arrows": animation.arrows.first().map_or(0, Vec::len),
        "posesAt": push_poses(frames.flatten(), planar, blob),
        "arrowsAt": blob.push_floats(arrows.flatten().flatten().copied()),
        "solids": solids::described(drawing, animation),
    })
}

/// Index of the kept row that `row` is, or comes before.
fn place_among(rows: &[usize], row: usize) -> usize {
    rows.partition_point(|kept| *kept < row).min(rows.len().saturating_sub(1))
}

/// Poses as x, y, angle in the plane, as x, y, z and quaternion w, x, y, z in space.
fn push_poses<'a>(poses: impl Iterator<Item = &'a Pose>, planar: bool, blob: &mut Blob) -> usize {
    if planar {
        return blob.push_floats(poses.flat_map(|pose| {
            let [w, _, _, z] = pose.quaternion;
            [pose.position[0], pose.position[1], 2.0 * z.atan2(w)]
        }));
    }
    blob.push_floats(poses.flat_map(|pose| {
        let ([x, y, z], [qw, qx, qy, qz]) = (pose.position, pose.quaternion);
        [x, y, z, qw, qx, qy, qz]
    }))
}

fn drawing(drawing: &Drawing) -> Value {
    json!({
        "planar": matches!(drawing.space, SpaceKind::Planar),
        "axes": upright(drawing.up),
        "bodies": drawing.bodies.iter().map(body).collect::<Vec<_>>(),
        "joints": drawing.joints.iter().map(joint).collect::<Vec<_>>(),
        "arrows": drawing.arrows.iter().map(arrow).collect::<Vec<_>>(),
    })
}

fn body(body: &DrawnBody) -> Value {
    json!({ "name": body.name, "points": body.points, "lines": body.lines, "center": body.center })
}

fn joint(joint: &DrawnJoint) -> Value {
    json!({
        "name": joint.name,
        "kind": joint.kind,
        "first": joint.first,
        "second": joint.second,
        "axis": joint.axis,
        "driven": joint.driven,
    })
}

fn arrow(arrow: &Arrow) -> Value {
    json!({ "name": arrow.name, "body": arrow.body, "at": arrow.at })
}
