//! The stick drawing: bodies as the lines between their points, joints, arrows.

use bellcrank_multibody::{Coordinate, Place};
use bellcrank_results::{Arrow, Drawing, DrawnBody, DrawnJoint, SpaceKind};

use crate::build::Built;
use crate::design::{Body, Design, ForceShape, Joint, Over, Study, Task, Values, moved};
use crate::parts;

pub(crate) fn drawing(design: &Design, built: &Built, studies: &[Study]) -> Drawing {
    let places = &built.geometry.points;
    let driven = driven(design, studies);
    let values = Values::new(&design.scopes, &design.scopes[0].parameters);
    let body = |(index, body): (usize, &Body)| DrawnBody {
        surface: parts::surface(design, &values, index),
        ..drawn_body(built, index, body)
    };
    let joint = |(index, joint): (usize, &Joint)| {
        let is_driven = driven.iter().any(|c| c.joint.0 == index);
        drawn_joint(joint, &built.blueprint.joints[index], is_driven)
    };
    let arrow = |index: usize| {
        let force = &design.forces[index];
        match &force.shape {
            ForceShape::Point { at, .. } => Some(Arrow {
                name: force.name.clone(),
                body: at.body,
                at: places.get(at.body)?.get(at.point)?.position,
            }),
            _ => None,
        }
    };
    Drawing {
        space: if design.planar { SpaceKind::Planar } else { SpaceKind::Spatial },
        up: up(built.blueprint.gravity, design.planar),
        bodies: design.bodies.iter().enumerate().map(body).collect(),
        joints: design.joints.iter().enumerate().filter_map(joint).collect(),
        arrows: crate::run::arrows(design).filter_map(arrow).collect(),
    }
}

/// The axis of the world that points most against gravity.
fn up(gravity: [f64; 3], planar: bool) -> [f64; 3] {
    let usual = if planar { 1 } else { 2 };
    let most = (0..3).max_by(|&a, &b| gravity[a].abs().total_cmp(&gravity[b].abs())).filter(|&k| gravity[k] != 0.0);
    let (axis, sign) = most.map_or((usual, 1.0), |k| (k, -gravity[k].signum()));
    std::array::from_fn(|k| if k == axis { sign } else { 0.0 })
}

/// Coordinates that carry efforts in the first study that says so.
fn driven(design: &Design, studies: &[Study]) -> Vec<Coordinate> {
    let of = |study: &Study| match &study.task {
        Task::Motion { over: Over::Positions { drive, .. }, .. } => Some(vec![*drive]),
        Task::Motion { over: Over::Time { motions, drives, .. }, .. } => {
            Some(drives.clone().unwrap_or_else(|| moved(motions.iter().filter_map(|&i| design.motions.get(i)))))
        }
        Task::Dynamics(of) if !of.motions.is_empty() => {
            Some(moved(of.motions.iter().filter_map(|&i| design.motions.get(i))))
        }
        _ => None,
    };
    studies.iter().find_map(of).unwrap_or_default()
}

fn drawn_body(built: &Built, index: usize, body: &Body) -> DrawnBody {
    let places = &built.geometry.points[index];
    let points: Vec<(String, [f64; 3])> =
        body.points.iter().zip(places).map(|(point, place)| (point.name.clone(), place.position)).collect();
    let positions: Vec<[f64; 3]> = points.iter().map(|(_, at)| *at).collect();
    let lines = if index == 0 { Vec::new() } else { lines(&positions, body.planar) };
    let numbers = &built.blueprint.bodies[index];
    let center = (index > 0 && numbers.mass > 0.0).then_some(numbers.center);
    let block = center.and_then(|_| block(numbers.mass, &numbers.inertia));
    DrawnBody { name: body.name.clone(), points, lines, center, block, surface: None }
}

/// Sides of the block with this mass (kg) and these moments (kg·m²) about its middle: Ixx = m(b² + c²)/12, ...
fn block(mass: f64, inertia: &[[f64; 3]; 3]) -> Option<[f64; 3]> {
    let moments: [f64; 3] = std::array::from_fn(|k| inertia[k][k]);
    let sum: f64 = moments.iter().sum();
    let sides = moments.map(|own| (6.0 * (sum - 2.0 * own) / mass).sqrt());
    sides.iter().all(|side| side.is_finite() && *side > 0.0).then_some(sides)
}

/// A bar, a triangle; more points in the plane a polygon around their middle, in space the shortest tree. Frames at one
/// place are one point.
fn lines(points: &[[f64; 3]], planar: bool) -> Vec<[usize; 2]> {
    let mut lines = match points.len() {
        0 | 1 => Vec::new(),
        2 => vec![[0, 1]],
        n if planar || n == 3 => polygon(points),
        _ => shortest_tree(points),
    };
    lines.retain(|&[a, b]| points[a] != points[b]);
    lines
}

fn polygon(points: &[[f64; 3]]) -> Vec<[usize; 2]> {
    let n = points.len();
    let middle: [f64; 2] = std::array::from_fn(|k| points.iter().map(|p| p[k]).sum::<f64>() / n as f64);
    let angle = |i: &usize| (points[*i][1] - middle[1]).atan2(points[*i][0] - middle[0]);
    let mut order: Vec<usize> = (0..n).collect();
    order.sort_by(|a, b| angle(a).total_cmp(&angle(b)));
    (0..n).map(|i| [order[i], order[(i + 1) % n]]).collect()
}

/// Prim's tree.
fn shortest_tree(points: &[[f64; 3]]) -> Vec<[usize; 2]> {
    let square = |a: usize, b: usize| (0..3).map(|k| (points[a][k] - points[b][k]).powi(2)).sum::<f64>();
    let mut nearest: Vec<(usize, f64)> = (0..points.len()).map(|i| (0, square(0, i))).collect();
    let mut left: Vec<usize> = (1..points.len()).collect();
    let mut lines = Vec::with_capacity(left.len());
    while let Some(at) = (0..left.len()).min_by(|&a, &b| nearest[left[a]].1.total_cmp(&nearest[left[b]].1)) {
        let next = left.swap_remove(at);
        lines.push([nearest[next].0, next]);
        for &other in &left {
            let distance = square(next, other);
            if distance < nearest[other].1 {
                nearest[other] = (next, distance);
            }
        }
    }
    lines
}

fn drawn_joint(joint: &Joint, numbers: &bellcrank_multibody::Joint<f64>, driven: bool) -> Option<DrawnJoint> {
    let [first, second] = numbers.places.as_ref()?;
    let at = |place: &Place<f64>| (place.body.0, place.position);
    let axis = axis(&numbers.kind);
    let turned = std::array::from_fn(|i| (0..3).map(|k| first.rotation[i][k] * axis[k]).sum());
    Some(DrawnJoint {
        name: joint.name.clone(),
        kind: joint.kind.to_owned(),
        first: at(first),
        second: at(second),
        axis: turned,
        driven,
    })
}

fn axis(kind: &bellcrank_multibody::JointKind<f64>) -> [f64; 3] {
    use bellcrank_multibody::JointKind as K;
    match kind {
        K::Revolute { axis }
        | K::Prismatic { axis }
        | K::Cylindrical { axis }
        | K::Screw { axis, .. }
        | K::Universal { axis, .. }
        | K::PointOnLine { axis } => *axis,
        _ => [0.0, 0.0, 1.0],
    }
}

#[cfg(test)]
mod tests {
    use super::{block, lines, up};

    #[test]
    fn up_is_the_axis_against_gravity() {
        assert_eq!(up([0.0, 0.0, -9.81], false), [0.0, 0.0, 1.0]);
        assert_eq!(up([0.0, -9.81, 0.0], false), [0.0, 1.0, 0.0]);
        assert_eq!(up([9.6, -2.0, 0.0], true), [-1.0, 0.0, 0.0]);
        assert_eq!((up([0.0; 3], true), up([0.0; 3], false)), ([0.0, 1.0, 0.0], [0.0, 0.0, 1.0]));
    }
    #[test]
    fn frames_at_one_place_make_no_line() {
        let (a, b) = ([0.1, 0.2, 0.3], [0.4, -0.2, 0.1]);
        assert!(lines(&[a, a], false).is_empty());
        assert_eq!(lines(&[a, a, b, b], false).len(), 1);
        assert_eq!(lines(&[a, b], false), [[0, 1]]);
    }

    #[test]
    fn a_block_has_the_moments_it_is_made_from() {
        let moments = |m: f64, [a, b, c]: [f64; 3]| [b * b + c * c, a * a + c * c, a * a + b * b].map(|x| m * x / 12.0);
        let [x, y, z] = moments(80.0, [0.5, 0.25, 0.4]);
        let sides = block(80.0, &[[x, 0.0, 0.0], [0.0, y, 0.0], [0.0, 0.0, z]]).unwrap();
        assert!(sides.iter().zip([0.5, 0.25, 0.4]).all(|(a, b)| (a - b).abs() < 1e-12), "{sides:?}");
        assert!(block(1.0, &[[0.1, 0.0, 0.0], [0.0, 0.1, 0.0], [0.0, 0.0, 0.2]]).is_none());
        assert!(block(1.0, &[[0.0; 3]; 3]).is_none());
    }
}
