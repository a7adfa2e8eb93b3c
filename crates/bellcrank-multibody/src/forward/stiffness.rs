//! Tangent stiffness and damping of the forces, exact: residuals in dual numbers at the present state.

use super::door::Surroundings;
use super::flight::Flight;
use super::locks::Act;
use crate::forces::Element;
use crate::solver::{Along, Machine, Slip, Tangent};
use crate::{MechanismError, SEEDS, Seeded};
use bellcrank_math::{Real, Space};

/// `K = ∂r/∂q` and `C = ∂r/∂v` of the unbalanced forces r (nv), by rows; positions along velocity components.
#[derive(Debug)]
pub(crate) struct Jacobian<S: Space<T = f64>> {
    tangent: Option<Box<Tangent<S::With<Seeded>>>>,
    pub(crate) stiffness: Vec<f64>,
    pub(crate) damping: Vec<f64>,
    /// They are those of the present structure, taken not long ago.
    pub(crate) known: bool,
    /// They were taken at the very state at hand.
    pub(crate) fresh: bool,
    slips: Vec<Option<Slip>>,
}

impl<S: Space<T = f64>> Jacobian<S> {
    pub(crate) fn new() -> Self {
        Self {
            tangent: None,
            stiffness: Vec::new(),
            damping: Vec::new(),
            known: false,
            fresh: false,
            slips: Vec::new(),
        }
    }
    /// The structure has changed.
    pub(crate) fn forget(&mut self) {
        (self.known, self.fresh) = (false, false);
    }
}

impl<S: Space<T = f64>> Machine<S> {
    /// Stiffness and damping at the present state, accelerations and multipliers.
    pub(crate) fn take_stiffness(
        &mut self,
        f: &mut Flight<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        f.effort.jacobians += 1;
        let nv = self.mech.nv;
        let mut jacobian = std::mem::replace(&mut f.jacobian, Jacobian::new());
        jacobian.stiffness.resize(nv * nv, 0.0);
        jacobian.damping.resize(nv * nv, 0.0);
        self.note_slips(f, &mut jacobian.slips);
        let result = self.fill_stiffness(f, &mut jacobian, around);
        (jacobian.known, jacobian.fresh) = (result.is_ok(), result.is_ok());
        f.jacobian = jacobian;
        result
    }

    fn fill_stiffness(
        &mut self,
        f: &Flight<S>,
        jacobian: &mut Jacobian<S>,
        around: &mut dyn Surroundings,
    ) -> Result<(), MechanismError> {
        let nv = self.mech.nv;
        let mut tangent = match jacobian.tangent.take() {
            Some(tangent) => tangent,
            None => {
                let seeded = self.blueprint.map(Seeded::from_f64);
                Box::new(Tangent::new(&seeded).map_err(|_| MechanismError::NotFinite("the machine's numbers"))?)
            }
        };
        for (along, into) in [(Along::Positions, &mut jacobian.stiffness), (Along::Velocities, &mut jacobian.damping)] {
            for first in (0..nv).step_by(SEEDS) {
                let inputs = &mut |at: &dyn crate::Readings<Seeded>, values: &mut [Seeded]| {
                    around.exact_inputs(at, values);
                };
                let left = tangent.unbalanced(self, along, first, &f.saddle.prescribed, &jacobian.slips, inputs)?;
                for (r, left) in left.iter().enumerate() {
                    for lane in 0..SEEDS.min(nv - first) {
                        into[r * nv + first + lane] = left.eps[lane];
                    }
                }
            }
        }
        jacobian.tangent = Some(tangent);
        Ok(())
    }

    /// Direction and normal force of each friction that slips.
    fn note_slips(&mut self, f: &Flight<S>, slips: &mut Vec<Option<Slip>>) {
        slips.clear();
        slips.resize(self.mech.elements.len(), None);
        for (i, slip) in slips.iter_mut().enumerate() {
            let Element::Friction(law) = self.mech.elements[i].clone() else { continue };
            let direction = match f.acts[i] {
                Act::Stick => continue,
                Act::Slip { up } => Some(if up { 1.0 } else { -1.0 }),
                _ => None,
            };
            *slip = Some((direction, self.passes(&f.saddle.prescribed).normal_force(&law)));
        }
    }
}
