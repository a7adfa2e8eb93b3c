//! A beam in segments: a chain of flexible bodies, each with its floating frame at the end of the one before.

use bellcrank_fem::beam::{Beam, BeamFault, Segment};
use bellcrank_multibody::{BodyId, Place};

use super::columns::{kept, picked, shortened};
use super::grips::{Grip, take_hold};
use super::{Appending, DAMPING, Deforming, Shapes};
use crate::build::Built;
use crate::build::rods::{RodNumbers, rod_of};
use crate::design::{Design, Flexible, Values};
use crate::flex::felt;
use crate::scalar::Scalar;

/// Coordinates of both ends of a segment.
const ENDS: usize = 12;
/// More modes than this of one segment are better had by more segments.
pub(crate) const MOST_MODES: usize = 24;

/// Makes a beam deform in a machine that was built rigid.
pub(super) fn rod<T: Scalar>(
    design: &Design,
    values: &Values<T>,
    built: &mut Built<T>,
    body: usize,
    form: &Flexible,
) -> Result<(), BeamFault> {
    let places = built.geometry.points[body].clone();
    let Some(rod) = rod_of(design, values, body, &places) else { return Ok(()) };
    let rod = if begins_at_second(design, body, form) { rod.turned() } else { rod };
    let shares = nodes(&rod, &interface_places(form, &places), form.segments);
    let damping = form.damping.as_ref().map_or(T::from_f64(DAMPING), |damping| damping.eval(values));
    let mut grips = vec![Grip { at: rod.ends[0], body: BodyId(body) }];
    for pair in shares.windows(2) {
        let [from, to] = [pair[0], pair[1]].map(T::from_f64);
        let first = pair[0] == 0.0;
        let at = |share: T| -> [T; 3] {
            std::array::from_fn(|i| rod.ends[0][i] + share * (rod.ends[1][i] - rod.ends[0][i]))
        };
        // The frame of the first is the body's; those of the others are at their beginning, with axes as the body's.
        let start = if first { at(from) } else { [T::zero(); 3] };
        let segment = Segment { line: rod.line(), length: (to - from) * rod.length, start, axes: rod.axes };
        let (beam, modes) = reduced(&segment, form, values, design.planar)?;
        let carrier = grips.last().map_or(BodyId(body), |grip| grip.body);
        let end: [T; 3] = std::array::from_fn(|i| start[i] + at(to)[i] - at(from)[i]);
        let node = piece(design.planar, built, (body, carrier), &beam, &modes, end, damping, form.stiffening);
        grips.push(Grip { at: at(to), body: node });
    }
    take_hold(design, built, body, &grips);
    Ok(())
}

/// The floating frame goes with the second end, as the reference does.
fn begins_at_second(design: &Design, body: usize, form: &Flexible) -> bool {
    let reference = form.interfaces[form.reference].value;
    design.bodies[body].rod.as_ref().is_some_and(|rod| rod.ends[1] == reference)
}

fn interface_places<T: Scalar>(form: &Flexible, places: &[Place<T>]) -> Vec<[f64; 3]> {
    form.interfaces.iter().map(|point| places[point.value].position.map(T::value)).collect()
}

/// Share of the length at which a place is, and how far from the axis, m.
pub(super) fn along<T: Scalar>(rod: &RodNumbers<T>, at: [f64; 3]) -> (f64, f64) {
    let [a, b] = rod.ends.map(|end| end.map(T::value));
    let axis: [f64; 3] = std::array::from_fn(|i| b[i] - a[i]);
    let arm: [f64; 3] = std::array::from_fn(|i| at[i] - a[i]);
    let square: f64 = axis.iter().map(|x| x * x).sum();
    let share = (0..3).map(|i| axis[i] * arm[i]).sum::<f64>() / square;
    let off = (0..3).map(|i| (arm[i] - share * axis[i]).powi(2)).sum::<f64>().sqrt();
    (share, off)
}

/// Shares of the length where segments meet: both ends, every interface, and equal parts between.
fn nodes<T: Scalar>(rod: &RodNumbers<T>, interfaces: &[[f64; 3]], segments: usize) -> Vec<f64> {
    const SAME: f64 = 1e-9;
    let mut fixed: Vec<f64> = interfaces.iter().map(|at| along(rod, *at).0).collect();
    fixed.retain(|share| *share > SAME && *share < 1.0 - SAME);
    fixed.sort_by(f64::total_cmp);
    fixed.dedup_by(|a, b| (*a - *b).abs() < SAME);
    fixed.push(1.0);
    let mut nodes = vec![0.0];
    for to in fixed {
        let from = nodes.last().copied().unwrap_or(0.0);
        let parts = ((segments as f64 * (to - from)).round() as usize).max(1);
        nodes.extend((1..parts).map(|k| from + (to - from) * k as f64 / parts as f64));
        nodes.push(to);
    }
    nodes
}

/// A segment with the modes that the machine can feel, by their places among its modes.
fn reduced<T: Scalar>(
    segment: &Segment<T>,
    form: &Flexible,
    values: &Values<T>,
    planar: bool,
) -> Result<(Beam<T>, Vec<usize>), BeamFault> {
    let wanted = form.modes.count.min(MOST_MODES);
    // Bending in two planes, stretch and torsion: not half of them move in the plane.
    let asked = if planar && wanted > 0 { (3 * wanted + 3).min(2 * MOST_MODES) } else { wanted };
    let beam = segment.reduce(asked)?;
    let limit = form.modes.frequency.as_ref().map(|limit| limit.eval::<T>(values).value());
    let felt = felt(&beam.inertia, 2, planar);
    let slow = |mode: usize| limit.is_none_or(|limit| beam.frequencies[mode] <= limit);
    let modes = (0..asked).filter(|&mode| felt[mode] && slow(mode)).take(wanted).collect();
    Ok((beam, modes))
}

/// Appends a segment; answers the body at its end.
#[expect(clippy::too_many_arguments, reason = "all that a segment is")]
fn piece<T: Scalar>(
    planar: bool,
    built: &mut Built<T>,
    (body, carrier): (usize, BodyId),
    beam: &Beam<T>,
    modes: &[usize],
    end: [T; 3],
    damping: T,
    stiffening: bool,
) -> BodyId {
    let mut columns = kept(2, 0, 0, planar);
    columns.extend(modes.iter().map(|mode| ENDS + mode));
    let unit = beam.damping(1.0).unwrap_or_else(|| vec![0.0; beam.coordinates() * beam.coordinates()]);
    let unit: Vec<T> = unit.into_iter().map(|entry| damping * T::from_f64(entry)).collect();
    let mut numbers = picked(&beam.inertia, &beam.stiffness, &unit, &columns);
    if stiffening {
        numbers.shortenings = shortened(&beam.shortenings, beam.coordinates(), &columns);
    }
    numbers.body = carrier;
    let mut appending = Appending { planar, blueprint: &mut built.blueprint };
    let (joint, node) = appending.interface(carrier, end);
    numbers.interfaces.push(joint);
    numbers.modes = (!modes.is_empty()).then(|| appending.modes(carrier, modes.len()));
    let coordinates = appending.coordinates(&numbers, modes.len());
    appending.flexible(numbers);
    let shapes = Shapes::Beam(Box::new(beam.clone()));
    built.flexible.push(Deforming { body, carrier, coordinates, modes: modes.len(), columns, shapes });
    node
}
