//! Bodies that deform, put into a machine that was built rigid.
//!
//! A flexible body keeps its place among the bodies of the blueprint: it carries the floating frame, which goes with the
//! reference interface. Every other interface becomes a massless body behind those of the design, and an elastic joint
//! behind the joints of the design; what takes hold of the body there takes hold of that one. So ids of the design stay.

mod chain;
mod columns;
mod grips;
#[cfg(test)]
mod tests;

use std::sync::Arc;

use bellcrank_fem::beam::{Beam, BeamFault};
use bellcrank_multibody::{
    Blueprint, Body as BodyNumbers, BodyId, Coordinate, Flexible as FlexibleNumbers, Joint as JointNumbers, JointId,
    JointKind, Place,
};

use super::{Built, frames};
use crate::design::{Design, Flexible, Values};
use crate::flex::{Found, Origin, Reduced};
use crate::geometry::Stressed;
use crate::scalar::Scalar;

pub(crate) use chain::MOST_MODES;
pub(crate) use columns::{picked, shortened};
pub(super) use grips::faults;
use grips::{Grip, take_hold};

/// A flexible body of the engine, and where it comes from.
#[expect(dead_code, reason = "stress in beams is not recovered yet")]
#[derive(Clone, Debug)]
pub(crate) struct Deforming<T = f64> {
    /// Body of the design; a beam in segments has several of these in a row.
    pub(crate) body: usize,
    /// Carries the floating frame.
    pub(crate) carrier: BodyId,
    /// Its coordinates in the order of the shapes: those of interfaces, then `modes`.
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) modes: usize,
    /// Column of the reduction of each coordinate.
    pub(crate) columns: Vec<usize>,
    pub(crate) shapes: Shapes<T>,
}

/// Columns of displacement and stress.
#[expect(dead_code, reason = "stress in beams is not recovered yet")]
#[derive(Clone, Debug)]
pub(crate) enum Shapes<T = f64> {
    /// Of a solid, in body axes.
    Solid { reduced: Arc<Reduced>, origin: Origin },
    /// Of a segment of a beam, in the axes of its floating frame, which are the body's.
    Beam(Box<Beam<T>>),
}

/// Part of critical damping in every natural mode, unless given: welded and bolted steel has 0.005 to 0.02.
pub(crate) const DAMPING: f64 = 0.01;

/// Appends to a blueprint.
struct Appending<'a, T> {
    planar: bool,
    blueprint: &'a mut Blueprint<T>,
}

/// Makes the flexible bodies of a rigid machine deform; `found` are the reductions of the solids among them.
///
/// # Errors
/// What makes no beam, with the body.
pub(crate) fn deform<T: Scalar>(
    design: &Design,
    values: &Values<T>,
    built: &mut Built<T>,
    found: &[(usize, Found)],
) -> Result<(), (usize, BeamFault)> {
    for (index, body) in design.bodies.iter().enumerate() {
        let Some(form) = &body.flexible else { continue };
        if let Some((_, found)) = found.iter().find(|(of, _)| *of == index) {
            let damping = form.damping.as_ref().map_or(T::from_f64(DAMPING), |damping| damping.eval(values));
            solid(design, built, index, form, damping, found);
        }
        if body.rod.is_some() {
            chain::rod(design, values, built, index, form).map_err(|fault| (index, fault))?;
        }
    }
    Ok(())
}

fn solid<T: Scalar>(
    design: &Design,
    built: &mut Built<T>,
    body: usize,
    form: &Flexible,
    damping: T,
    Found { reduced, origin, .. }: &Found,
) {
    let at: Vec<[T; 3]> =
        form.interfaces.iter().map(|point| built.geometry.points[body][point.value].position).collect();
    let modes = reduced.modes();
    let columns = columns::kept(at.len(), form.reference, modes, design.planar);
    let mut numbers = reduced.numbers(&columns).map(T::from_f64);
    numbers.damping.iter_mut().for_each(|entry| *entry = *entry * damping);
    numbers.body = BodyId(body);
    let mut appending = Appending { planar: design.planar, blueprint: &mut built.blueprint };
    let mut grips = vec![Grip { at: at[form.reference], body: BodyId(body) }];
    for (_, at) in at.into_iter().enumerate().filter(|(place, _)| *place != form.reference) {
        let (joint, interface) = appending.interface(BodyId(body), at);
        numbers.interfaces.push(joint);
        grips.push(Grip { at, body: interface });
    }
    numbers.modes = (modes > 0).then(|| appending.modes(BodyId(body), modes));
    let coordinates = appending.coordinates(&numbers, modes);
    appending.flexible(numbers);
    take_hold(design, built, body, &grips);
    let shapes = Shapes::Solid { reduced: Arc::clone(reduced), origin: *origin };
    let (own, of) = (coordinates.clone(), columns.clone());
    built.geometry.stresses.push(Stressed { body, coordinates: own, columns: of, reduced: Arc::clone(reduced) });
    built.flexible.push(Deforming { body, carrier: BodyId(body), coordinates, modes, columns, shapes });
}

impl<T: Scalar> Appending<'_, T> {
    fn massless(&mut self) -> BodyId {
        let zero = T::zero();
        self.blueprint.bodies.push(BodyNumbers { mass: zero, center: [zero; 3], inertia: [[zero; 3]; 3] });
        BodyId(self.blueprint.bodies.len() - 1)
    }

    /// An interface of a body at a place in its axes.
    fn interface(&mut self, of: BodyId, at: [T; 3]) -> (JointId, BodyId) {
        let interface = self.massless();
        let joint = self.joint(JointKind::Elastic, of, at, interface, if self.planar { 3 } else { 6 });
        (joint, interface)
    }

    fn modes(&mut self, of: BodyId, count: usize) -> JointId {
        let carrier = self.massless();
        self.joint(JointKind::Modes { count }, of, [T::zero(); 3], carrier, count)
    }

    /// Undeformed at first, and held so while the machine is assembled.
    fn joint(&mut self, kind: JointKind<T>, of: BodyId, at: [T; 3], to: BodyId, coordinates: usize) -> JointId {
        let place = |body, position| Place { body, position, rotation: frames::identity() };
        self.blueprint.joints.push(JointNumbers {
            kind,
            places: Some([place(of, at), place(to, [T::zero(); 3])]),
            start: vec![Some(T::zero()); coordinates],
            at_start: true,
        });
        JointId(self.blueprint.joints.len() - 1)
    }

    fn coordinates(&self, numbers: &FlexibleNumbers<T>, modes: usize) -> Vec<Coordinate> {
        let each = if self.planar { 3 } else { 6 };
        let all = |joint: JointId, count: usize| (0..count).map(move |index| Coordinate { joint, index });
        let of_interfaces = numbers.interfaces.iter().flat_map(|&joint| all(joint, each));
        of_interfaces.chain(numbers.modes.into_iter().flat_map(|joint| all(joint, modes))).collect()
    }

    /// Its mass goes from the body to the shapes; the centre stays, as the place that is read as the body's.
    fn flexible(&mut self, numbers: FlexibleNumbers<T>) {
        let body = &mut self.blueprint.bodies[numbers.body.0];
        body.mass = T::zero();
        body.inertia = [[T::zero(); 3]; 3];
        self.blueprint.flexible.push(numbers);
    }
}
