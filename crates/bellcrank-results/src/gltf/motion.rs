//! Poses over time as an animation.

use serde_json::{Value, json};

use super::buffer::Buffer;
use crate::{Animation, Pose, StudyResult};

/// A study that is not over time plays this long, s.
const SWEEP_SECONDS: f64 = 4.0;

/// Frames that can be played: time (s, rising) and poses.
struct Track<'a> {
    times: Vec<f32>,
    frames: Vec<&'a [Pose]>,
}

/// Translation and rotation of every body that moves; nothing where none does.
pub(super) fn animation(study: &StudyResult, animation: &Animation, buffer: &mut Buffer) -> Option<Value> {
    let track = track(study, animation);
    let bodies = track.frames.first().map_or(0, |frame| frame.len());
    let moving: Vec<usize> = (0..bodies).filter(|body| moves(&track, *body)).collect();
    if moving.is_empty() {
        return None;
    }
    let input = buffer.push_times(&track.times);
    let (mut samplers, mut channels) = (Vec::new(), Vec::new());
    let mut push = |output: usize, body: usize, path: &str| {
        channels.push(json!({ "sampler": samplers.len(), "target": { "node": body + 1, "path": path } }));
        samplers.push(json!({ "input": input, "output": output, "interpolation": "LINEAR" }));
    };
    for body in moving {
        let places: Vec<[f32; 3]> = track.frames.iter().map(|frame| frame[body].position.map(|x| x as f32)).collect();
        push(buffer.push_track(&places), body, "translation");
        push(buffer.push_track(&rotations(&track, body)), body, "rotation");
    }
    Some(json!({ "name": study.name, "samplers": samplers, "channels": channels }))
}

/// Frames with finite numbers at times that rise, the first at 0.
fn track<'a>(study: &StudyResult, animation: &'a Animation) -> Track<'a> {
    let clock = if study.axis.first().is_some_and(|axis| axis == "time") { study.table.column("time") } else { None };
    let last = animation.rows.last().copied().unwrap_or(0).max(1) as f64;
    let time = |row: usize| match clock {
        Some(column) => column.values.get(row).zip(column.values.first()).map_or(f64::NAN, |(t, start)| t - start),
        None => SWEEP_SECONDS * row as f64 / last,
    };
    let mut track = Track { times: Vec::new(), frames: Vec::new() };
    for (row, frame) in animation.rows.iter().zip(&animation.frames) {
        let at = time(*row) as f32;
        let rises = track.times.last().is_none_or(|before| at > *before);
        let fits = track.frames.first().is_none_or(|first| first.len() == frame.len());
        if at.is_finite() && rises && fits && frame.iter().all(is_finite) {
            track.times.push(at);
            track.frames.push(frame);
        }
    }
    track
}

pub(super) fn is_finite(pose: &Pose) -> bool {
    pose.position.iter().chain(&pose.quaternion).all(|x| x.is_finite())
}

fn moves(track: &Track<'_>, body: usize) -> bool {
    let first = &track.frames[0][body];
    let same = |pose: &Pose| pose.position == first.position && pose.quaternion == first.quaternion;
    track.frames.iter().any(|frame| !same(&frame[body]))
}

/// Quaternions x, y, z, w of which each is on the side of the one before: the way between them is the short one.
fn rotations(track: &Track<'_>, body: usize) -> Vec<[f32; 4]> {
    let mut before: Option<[f32; 4]> = None;
    let mut turns = Vec::with_capacity(track.frames.len());
    for frame in &track.frames {
        let mut q = xyzw(frame[body].quaternion);
        if before.is_some_and(|p| p.iter().zip(&q).map(|(a, b)| a * b).sum::<f32>() < 0.0) {
            q = q.map(|x| -x);
        }
        before = Some(q);
        turns.push(q);
    }
    turns
}

/// glTF's order, of length one after rounding as before.
pub(super) fn xyzw([w, x, y, z]: [f64; 4]) -> [f32; 4] {
    let length = (w * w + x * x + y * y + z * z).sqrt();
    if length > 0.0 { [x, y, z, w].map(|c| (c / length) as f32) } else { [0.0, 0.0, 0.0, 1.0] }
}

/// Of the rotation whose matrix has these rows, as x, y, z, w (Shepperd's method).
pub(super) fn quaternion(rows: [[f64; 3]; 3]) -> [f32; 4] {
    let [[a, b, c], [d, e, f], [g, h, i]] = rows;
    let squares = [1.0 + a + e + i, 1.0 + a - e - i, 1.0 - a + e - i, 1.0 - a - e + i];
    let largest = (0..4).max_by(|&m, &n| squares[m].total_cmp(&squares[n])).unwrap_or(0);
    let q = match largest {
        0 => [squares[0], h - f, c - g, d - b],
        1 => [h - f, squares[1], b + d, c + g],
        2 => [c - g, b + d, squares[2], f + h],
        _ => [d - b, c + g, f + h, squares[3]],
    };
    xyzw(if q[0] < 0.0 { q.map(|x: f64| -x) } else { q })
}
