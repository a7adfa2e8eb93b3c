//! Mass properties and points in numbers.

use std::fmt::Arguments;

use bellcrank_doc::Diagnostic;
use bellcrank_math::matrix_from_rpy;
use bellcrank_multibody::{Body as BodyNumbers, BodyId, Place};

use super::Numbers;
use super::frames::{self, Matrix};
use super::rods;
use super::solids::{self, Kept};
use crate::design::{Body, Point, Quantity, Rotation};
use crate::scalar::Scalar;

/// Mass properties of all bodies, whose points are there already.
pub(super) fn bodies<T: Scalar>(
    numbers: &mut Numbers<'_, T>,
    points: &[Vec<Place<T>>],
    solids: &mut Vec<Kept<T>>,
    bodies: &mut Vec<BodyNumbers<T>>,
) {
    let design = numbers.design;
    bodies.clear();
    solids.resize_with(design.bodies.len(), Kept::default);
    let all = design.bodies.iter().zip(points).zip(solids);
    bodies.extend(all.map(|((body, places), kept)| match (&body.solid, &body.rod) {
        (Some(worn), _) => solids::mass(numbers, worn, places, kept),
        (None, Some(rod)) => rods::mass(numbers, rod, places),
        (None, None) => one(numbers, body),
    }));
}

fn one<T: Scalar>(numbers: &mut Numbers<'_, T>, body: &Body) -> BodyNumbers<T> {
    let name = &body.name;
    let mass =
        body.mass.as_ref().map_or(T::zero(), |mass| numbers.positive(mass, format_args!("`mass` of body `{name}`")));
    let center = body.center.as_deref().unwrap_or_default();
    let center = numbers.vector(center, format_args!("`center` of body `{name}`"));
    let inertia = body.inertia.as_deref().unwrap_or_default();
    let inertia = tensor(numbers, inertia, format_args!("`inertia` of body `{name}`"));
    BodyNumbers { mass, center, inertia }
}

/// From one value (the plane), three or six. In space a body of a planar file with one value counts as a round disc in
/// its plane: half of it about each axis there.
fn tensor<T: Scalar>(numbers: &mut Numbers<'_, T>, values: &[Quantity], what: Arguments<'_>) -> Matrix<T> {
    let o = T::zero();
    if let [zz] = values {
        let zz = numbers.positive(zz, what);
        let half = if numbers.design.planar { o } else { zz / T::from_f64(2.0) };
        return [[half, o, o], [o, half, o], [o, o, zz]];
    }
    let (moments, products) = values.split_at(values.len().min(3));
    let mut diagonal = [o; 3];
    for (place, value) in diagonal.iter_mut().zip(moments) {
        *place = numbers.positive(value, what);
    }
    let ([xx, yy, zz], [xy, xz, yz]) = (diagonal, numbers.vector(products, what));
    [[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]]
}

/// The frames of all points, by body.
pub(super) fn points<T: Scalar>(numbers: &mut Numbers<'_, T>, points: &mut Vec<Vec<Place<T>>>) {
    let design = numbers.design;
    points.resize_with(design.bodies.len(), Vec::new);
    for (index, (body, places)) in design.bodies.iter().zip(points).enumerate() {
        places.clear();
        for point in &body.points {
            let place = frame(numbers, body, point, BodyId(index));
            let base = point.base.and_then(|base| places.get(base));
            let place = base.map_or_else(|| place.clone(), |base| placed_in(base, &place));
            places.push(place);
        }
    }
}

fn frame<T: Scalar>(numbers: &mut Numbers<'_, T>, body: &Body, point: &Point, id: BodyId) -> Place<T> {
    let what = format_args!("point `{}` of body `{}`", point.name, body.name);
    let position = numbers.vector(&point.at, what);
    let rotation = rotation(numbers, &point.rotation, what);
    let out_of_plane = point.planar && (rotation[2][2].value() - 1.0).abs() > 1e-12;
    if out_of_plane {
        let message = format!("{what} is turned out of the plane");
        let report = Diagnostic::error("not-in-plane", point.span, message);
        numbers.faults.push(report.hint("in the plane points turn about z"));
    }
    Place { body: id, position, rotation }
}

fn rotation<T: Scalar>(numbers: &mut Numbers<'_, T>, rotation: &Rotation, what: Arguments<'_>) -> Matrix<T> {
    match rotation {
        Rotation::None => frames::identity(),
        Rotation::About { axis, angle } => {
            let before = numbers.faults.len();
            let axis = numbers.direction(axis, format_args!("the axis of {what}"));
            let angle = numbers.number(angle, format_args!("the angle of {what}"));
            if numbers.faults.len() > before { frames::identity() } else { frames::about(axis, angle) }
        }
        Rotation::Quaternion(values) => {
            let mut quaternion = [T::zero(); 4];
            for (place, value) in quaternion.iter_mut().zip(values) {
                *place = numbers.number(value, what);
            }
            frames::from_quaternion(quaternion).unwrap_or_else(|| {
                if let Some(value) = values.first() {
                    numbers.report("no-axis", value.span(), format!("the quaternion of {what} is zero"));
                }
                frames::identity()
            })
        }
        // R = Rz(yaw) Ry(pitch) Rx(roll).
        Rotation::Rpy(values) => matrix_from_rpy(&numbers.vector(values, what)),
    }
}

fn placed_in<T: Scalar>(base: &Place<T>, place: &Place<T>) -> Place<T> {
    let shift = frames::apply(&base.rotation, place.position);
    Place {
        body: base.body,
        position: std::array::from_fn(|i| base.position[i] + shift[i]),
        rotation: frames::product(&base.rotation, &place.rotation),
    }
}
