//! Mass properties and points in numbers.

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::{Body as BodyNumbers, BodyId, Place};

use super::Numbers;
use super::frames::{self, IDENTITY, Matrix};
use crate::design::{Body, Point, Quantity, Rotation};

pub(super) fn bodies(numbers: &mut Numbers<'_>) -> Vec<BodyNumbers<f64>> {
    let design = numbers.design;
    design.bodies.iter().map(|body| one(numbers, body)).collect()
}

fn one(numbers: &mut Numbers<'_>, body: &Body) -> BodyNumbers<f64> {
    let of = |key: &str| format!("`{key}` of body `{}`", body.name);
    let mass = body.mass.as_ref().map_or(0.0, |mass| positive(numbers, mass, &of("mass")));
    let center = body.center.as_ref().map_or([0.0; 3], |center| numbers.vector(center, &of("center")));
    let inertia = body.inertia.as_ref().map_or([[0.0; 3]; 3], |inertia| tensor(numbers, inertia, &of("inertia")));
    BodyNumbers { mass, center, inertia }
}

fn positive(numbers: &mut Numbers<'_>, quantity: &Quantity, what: &str) -> f64 {
    let value = numbers.number(quantity, what);
    if value < 0.0 {
        numbers.report("negative", quantity.span(), format!("{what} is negative"));
    }
    value
}

/// From one value (the plane), three or six.
fn tensor(numbers: &mut Numbers<'_>, values: &[Quantity], what: &str) -> Matrix {
    if let [zz] = values {
        return [[0.0; 3], [0.0; 3], [0.0, 0.0, positive(numbers, zz, what)]];
    }
    let diagonal: Vec<f64> = values.iter().take(3).map(|value| positive(numbers, value, what)).collect();
    let products: Vec<f64> = values.iter().skip(3).map(|value| numbers.number(value, what)).collect();
    let product = |i: usize| products.get(i).copied().unwrap_or(0.0);
    let moment = |i: usize| diagonal.get(i).copied().unwrap_or(0.0);
    let (xy, xz, yz) = (product(0), product(1), product(2));
    [[moment(0), xy, xz], [xy, moment(1), yz], [xz, yz, moment(2)]]
}

/// The frames of all points, by body.
pub(super) fn points(numbers: &mut Numbers<'_>) -> Vec<Vec<Place<f64>>> {
    let mut all = Vec::with_capacity(numbers.design.bodies.len());
    for (index, body) in numbers.design.bodies.iter().enumerate() {
        let mut places: Vec<Place<f64>> = Vec::with_capacity(body.points.len());
        for point in &body.points {
            let base = point.base.and_then(|base| places.get(base).cloned());
            let place = frame(numbers, body, point, BodyId(index));
            places.push(match base {
                Some(base) => placed_in(&base, place),
                None => place,
            });
        }
        all.push(places);
    }
    all
}

fn frame(numbers: &mut Numbers<'_>, body: &Body, point: &Point, id: BodyId) -> Place<f64> {
    let what = format!("point `{}` of body `{}`", point.name, body.name);
    let position = numbers.vector(&point.at, &what);
    let rotation = rotation(numbers, &point.rotation, &what);
    let in_plane = numbers.design.planar && (rotation[2][2] - 1.0).abs() > 1e-12;
    if in_plane {
        let message = format!("{what} is turned out of the plane");
        let report = Diagnostic::error("not-in-plane", point.span, message);
        numbers.faults.push(report.hint("in the plane points turn about z"));
    }
    Place { body: id, position, rotation }
}

fn rotation(numbers: &mut Numbers<'_>, rotation: &Rotation, what: &str) -> Matrix {
    match rotation {
        Rotation::None => IDENTITY,
        Rotation::About { axis, angle } => {
            let before = numbers.faults.len();
            let axis = numbers.direction(axis, &format!("the axis of {what}"));
            let angle = numbers.number(angle, &format!("the angle of {what}"));
            if numbers.faults.len() > before { IDENTITY } else { frames::about(axis, angle) }
        }
        Rotation::Quaternion(values) => {
            let mut quaternion = [0.0; 4];
            for (place, value) in quaternion.iter_mut().zip(values) {
                *place = numbers.number(value, what);
            }
            frames::from_quaternion(quaternion).unwrap_or_else(|| {
                if let Some(value) = values.first() {
                    numbers.report("no-axis", value.span(), format!("the quaternion of {what} is zero"));
                }
                IDENTITY
            })
        }
        Rotation::Rpy(values) => frames::from_rpy(numbers.vector(values, what)),
    }
}

fn placed_in(base: &Place<f64>, place: Place<f64>) -> Place<f64> {
    let shift = frames::apply(&base.rotation, place.position);
    Place {
        body: base.body,
        position: std::array::from_fn(|i| base.position[i] + shift[i]),
        rotation: frames::product(&base.rotation, &place.rotation),
    }
}
