//! The numbers behind the drawing and the curves, packed into the page.
//!
//! One JSON block describes everything; the numbers of a study follow as one base64 block of
//! little-endian floats, which the description points into by byte offset. Columns are in display
//! units, drawings and poses in SI.

mod base64;
mod blob;

use bellcrank_results::{Animation, Arrow, Column, Drawing, DrawnBody, DrawnJoint, RunResult, SpaceKind, StudyResult};
use serde_json::{Value, json};

use blob::Blob;

pub(crate) fn push(page: &mut String, run: &RunResult) {
    let planar = matches!(run.drawing.space, SpaceKind::Planar);
    let mut blobs = Vec::new();
    let mut studies = Vec::new();
    for study in &run.studies {
        let mut blob = Blob::default();
        studies.push(described(study, planar, &mut blob));
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

fn described(study: &StudyResult, planar: bool, blob: &mut Blob) -> Value {
    let columns: Vec<Value> = study.table.columns.iter().map(|column| packed(column, study, blob)).collect();
    json!({
        "name": study.name,
        "axis": study.axis,
        "rows": study.table.rows(),
        "columns": columns,
        "animation": study.animation.as_ref().map(|animation| moves(animation, planar, blob)),
    })
}

/// A column that never changes is one number; axes keep double precision (long times need it).
fn packed(column: &Column, study: &StudyResult, blob: &mut Blob) -> Value {
    let (name, unit) = (&column.name, &column.unit);
    let constant = column.values.first().filter(|first| column.values.iter().all(|v| v == *first));
    if let Some(&si) = constant {
        return json!({ "name": name, "unit": unit.symbol, "constant": unit.show(si) });
    }
    let shown = column.values.iter().map(|si| unit.show(*si));
    if study.axis.contains(name) {
        let at = blob.push_doubles(shown);
        json!({ "name": name, "unit": unit.symbol, "at": at, "double": true })
    } else {
        let at = blob.push_floats(shown);
        json!({ "name": name, "unit": unit.symbol, "at": at })
    }
}

/// Poses as x, y, angle in the plane, as x, y, z and quaternion w, x, y, z in space; then arrows
/// as three components.
fn moves(animation: &Animation, planar: bool, blob: &mut Blob) -> Value {
    let poses = animation.frames.iter().flatten();
    let poses_at = if planar {
        blob.push_floats(poses.flat_map(|pose| {
            let [w, _, _, z] = pose.quaternion;
            [pose.position[0], pose.position[1], 2.0 * z.atan2(w)]
        }))
    } else {
        blob.push_floats(poses.flat_map(|pose| {
            let ([x, y, z], [qw, qx, qy, qz]) = (pose.position, pose.quaternion);
            [x, y, z, qw, qx, qy, qz]
        }))
    };
    let arrows_at = blob.push_floats(animation.arrows.iter().flatten().flatten().copied());
    json!({
        "rows": animation.rows,
        "bodies": animation.frames.first().map_or(0, Vec::len),
        "arrows": animation.arrows.first().map_or(0, Vec::len),
        "posesAt": poses_at,
        "arrowsAt": arrows_at,
    })
}

fn drawing(drawing: &Drawing) -> Value {
    json!({
        "planar": matches!(drawing.space, SpaceKind::Planar),
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
