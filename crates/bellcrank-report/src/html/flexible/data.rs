//! Flexible bodies row by row as the page holds them.
//!
//! One JSON block tells what there is; the numbers of each body follow as one block of packed integers: its surface, the
//! displacement and the stress of every node by each coordinate, and coordinates and floating frame of every frame of
//! the drawing. Displacement and stress at a frame are worked out in the browser, from these sums.
//!
//! A coordinate that hardly deforms the body needs few steps: all are held so that no one is off by more than the same
//! small part of the largest stress and displacement there is.

use bellcrank_results::{Animation, Contour, ContourField, FlexibleMotion, MotionMark, RunResult, StudyResult, Unit};
use serde_json::{Value, json};

use crate::html::contours::{colours, distinct, push_places, scale};
use crate::html::data::{Integers, encoded, kept_frames};
use crate::picture::{Scale, bounds, in_row, outline, usual_scale};

/// Steps of the largest stress and of the largest displacement.
const STEPS: f64 = 8192.0;
/// Frames that are searched for the largest displacement.
const SEARCHED: usize = 60;
/// Bytes of a body, before they are packed, that a page takes.
const MOST_BYTES: usize = 64 << 20;

/// Whether the page holds the numbers of a body.
pub(super) fn is_light(motion: &FlexibleMotion) -> bool {
    let of_node = 9 + 18 * motion.displacements.len();
    12 * motion.triangles.len() + 8 * motion.edges.len() + of_node * motion.nodes.len() < MOST_BYTES
}

/// Whether a study has bodies that the drawing can show.
pub(crate) fn any(study: &StudyResult) -> bool {
    study.animation.is_some() && study.motions.iter().any(|motion| motion.is_whole() && is_light(motion))
}

/// Appends the numbers behind every flexible body; nothing without.
pub(crate) fn push(page: &mut String, run: &RunResult) {
    let mut blocks = String::new();
    let studies = run.studies.iter().enumerate().filter(|(_, of)| any(of));
    let described: Vec<Value> =
        studies.filter_map(|(index, of)| described(run, index, of.animation.as_ref()?, &mut blocks)).collect();
    if described.is_empty() {
        return;
    }
    let data = json!({ "colours": colours(), "studies": described });
    page.push_str("<script type=\"application/json\" id=\"bellcrank-flexible\">");
    page.push_str(&data.to_string().replace('<', "\\u003c"));
    page.push_str("</script>\n");
    page.push_str(&blocks);
}

/// The bodies of a study; their numbers go to `blocks`. Colours mean the same on all of them.
fn described(run: &RunResult, index: usize, animation: &Animation, blocks: &mut String) -> Option<Value> {
    let shown: Vec<&FlexibleMotion> =
        run.studies[index].motions.iter().filter(|motion| motion.is_whole() && is_light(motion)).collect();
    let first = shown.first()?;
    let mut bodies = Vec::new();
    let mut moved = 0.0_f64;
    let mut usual = f32::INFINITY;
    for (body, motion) in shown.iter().enumerate() {
        let key = format!("{index}-{body}");
        let mut numbers = Integers::default();
        let frames = frames(motion, animation);
        let (largest, furthest) = furthest(motion, &frames);
        let still = in_row(motion, furthest, String::new());
        moved = moved.max(largest);
        usual = usual.min(usual_scale(&still, &still.shapes[0]));
        let mut of = part(motion, &frames, (largest, &still), &mut numbers);
        of["key"] = json!(key);
        of["body"] = json!(run.drawing.bodies.iter().position(|drawn| drawn.name == motion.body));
        bodies.push(of);
        blocks.push_str(&format!("<script type=\"text/plain\" id=\"bellcrank-flexible-{key}\">"));
        blocks.push_str(&String::from_utf8_lossy(&encoded(&numbers.packed())));
        blocks.push_str("</script>\n");
    }
    let stresses: Vec<f32> = shown.iter().flat_map(|motion| motion.envelope.iter().copied()).collect();
    let top = shown.iter().map(|motion| motion.limit() as f32).fold(0.0, f32::max);
    let ceiling = stresses.iter().any(|stress| *stress > 1.0001 * top).then_some(top);
    Some(json!({
        "study": index,
        "usual": usual,
        "stress": legend("von Mises stress, all rows", &first.unit, stresses, ceiling),
        "displacement": legend("displacement, all rows", &first.length, vec![moved as f32], None),
        "bodies": bodies,
    }))
}

/// For each frame of the page the row of the motion that is nearest to it.
fn frames(motion: &FlexibleMotion, animation: &Animation) -> Vec<usize> {
    let nearest = |row: usize| {
        let above = motion.rows.partition_point(|own| *own < row);
        let near = [above.saturating_sub(1), above.min(motion.rows.len() - 1)];
        let far = |at: &usize| motion.rows[*at].abs_diff(row);
        near.into_iter().min_by_key(far).unwrap_or(0)
    };
    kept_frames(animation).iter().filter_map(|frame| animation.rows.get(*frame)).map(|row| nearest(*row)).collect()
}

/// `moved`: the largest displacement and the body in a row as a picture.
fn part(motion: &FlexibleMotion, frames: &[usize], moved: (f64, &Contour), numbers: &mut Integers) -> Value {
    let (low, high) = bounds(motion.nodes.iter().copied()).unwrap_or_default();
    let sharp = outline(moved.1);
    let edges = distinct(&motion.edges);
    push_places(&motion.nodes, low, high, numbers);
    numbers.push(4, motion.triangles.iter().flatten().copied());
    numbers.push(4, edges.iter().flatten().copied());
    numbers.push(4, sharp.iter().flatten().copied());
    let columns = columns(motion, moved.0, numbers);
    push_frames(motion, frames, numbers);
    let marks: Vec<Value> = motion.marks.iter().map(|of| mark(motion, of, frames, numbers)).collect();
    json!({
        "name": motion.body,
        "nodes": motion.nodes.len(),
        "triangles": motion.triangles.len(),
        "edges": edges.len(),
        "outline": sharp.len(),
        "low": low,
        "high": high,
        "columns": columns,
        "frames": frames.len(),
        "worst": frames.iter().enumerate().min_by_key(|(_, at)| at.abs_diff(motion.worst)).map(|(frame, _)| frame),
        "marks": marks,
    })
}

/// The largest displacement of some of the frames, m, and the row of the motion where it is.
fn furthest(motion: &FlexibleMotion, frames: &[usize]) -> (f64, usize) {
    let size = |u: [f64; 3]| u.iter().map(|x| x * x).sum::<f64>().sqrt();
    let in_row = |at: usize| {
        let all = (0..motion.nodes.len()).map(|node| size(motion.displacement(at, node)));
        (all.filter(|u| u.is_finite()).fold(0.0, f64::max), at)
    };
    let some = frames.iter().step_by(frames.len().div_ceil(SEARCHED).max(1)).copied().chain([motion.worst]);
    some.map(in_row).max_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or_default()
}

/// Colours that mean the same in every row; they begin at nothing.
fn legend(name: &str, unit: &Unit, mut values: Vec<f32>, ceiling: Option<f32>) -> Value {
    values.push(0.0);
    let field = ContourField { name: name.to_owned(), unit: unit.clone(), values, ceiling };
    let mut described = Scale::of(&[&field]).map_or(Value::Null, |of| scale(&of));
    described["factor"] = json!(unit.factor);
    described
}

/// Displacement and stress by each coordinate: sizes of a step and the bytes they take.
fn columns(motion: &FlexibleMotion, moved: f64, numbers: &mut Integers) -> Vec<Value> {
    let largest = motion.envelope.iter().copied().filter(|s| s.is_finite()).fold(0.0, f32::max);
    let amplitude =
        |e: usize| motion.coordinates.iter().map(|row| row[e].abs()).filter(|d| d.is_finite()).fold(0.0, f64::max);
    let column = |e: usize| {
        let by = amplitude(e) * STEPS;
        let [move_step, move_width] = pushed(&motion.displacements[e], moved / by, numbers);
        let [stress_step, stress_width] = pushed(&motion.stresses[e], f64::from(largest) / by, numbers);
        json!({ "moveStep": move_step, "moveWidth": move_width, "stressStep": stress_step, "stressWidth": stress_width })
    };
    (0..motion.displacements.len()).map(column).collect()
}

/// Components one after the other in steps of that size; nothing where the coordinate does not move. Gives the step and
/// the width, 0 where nothing was written.
fn pushed<const N: usize>(column: &[[f32; N]], step: f64, numbers: &mut Integers) -> [Value; 2] {
    // Neither more steps than an integer holds, nor a step of no size.
    let most =
        column.as_flattened().iter().copied().filter(|x| x.is_finite()).fold(0.0_f32, |most, x| most.max(x.abs()));
    let step = step.max(f64::from(most) / 1e9);
    if !(step.is_finite() && step > 0.0) {
        return [json!(0.0), json!(0)];
    }
    let steps: Vec<i32> =
        (0..N).flat_map(|k| column.iter().map(move |of| (f64::from(of[k]) / step).round() as i32)).collect();
    if steps.iter().all(|of| *of == 0) {
        return [json!(0.0), json!(0)];
    }
    [json!(step), json!(numbers.push_signed(&steps))]
}

/// Coordinates, then place and turn (w, x, y, z) of the floating frame, each over the frames.
fn push_frames(motion: &FlexibleMotion, frames: &[usize], numbers: &mut Integers) {
    for e in 0..motion.displacements.len() {
        numbers.push_floats(frames.iter().map(|at| motion.coordinates[*at][e]));
    }
    let poses = || frames.iter().map(|at| &motion.poses[*at]);
    (0..3).for_each(|k| numbers.push_floats(poses().map(|pose| pose.position[k])));
    (0..4).for_each(|k| numbers.push_floats(poses().map(|pose| pose.quaternion[k])));
}

fn mark(motion: &FlexibleMotion, of: &MotionMark, frames: &[usize], numbers: &mut Integers) -> Value {
    let stress = |at: &usize| motion.unit.show(of.history.get(*at).copied().unwrap_or(f64::NAN));
    numbers.push_floats(frames.iter().map(stress));
    json!({ "label": of.label, "node": of.node, "doubtful": of.doubtful })
}
