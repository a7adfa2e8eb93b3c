//! A cylinder of the catalogue.

use crate::SizingError;
use crate::error::Demands;
use crate::pneumatic::buckling::YOUNGS_MODULUS_STEEL;

/// A double-acting cylinder with one rod, SI. What the catalogue does not say is `None`, and the
/// check that would need it says so.
#[derive(Clone, Debug, PartialEq)]
pub struct Cylinder {
    /// Name in the catalogue, e.g. `iso15552-63`.
    pub name: String,
    /// Standard, e.g. `ISO 15552`; may be empty.
    pub standard: String,
    /// Bore (piston diameter), m.
    pub bore: f64,
    /// Piston rod diameter, m; 0 for a rodless cylinder.
    pub rod: f64,
    /// Strokes it is stocked with, m, in any order.
    pub strokes: Vec<f64>,
    /// Longest stroke that can be ordered, m; `None`: only the standard strokes.
    pub max_stroke: Option<f64>,
    /// Largest gauge pressure, Pa.
    pub max_pressure: Option<f64>,
    /// Largest speed, m/s.
    pub max_speed: Option<f64>,
    /// Kinetic energy the cushion takes at one end, J.
    pub cushion_energy: Option<f64>,
    /// Mass of piston and rod at stroke 0, kg.
    pub moving_mass: Option<f64>,
    /// What a metre of stroke adds to it, kg/m.
    pub moving_mass_per_stroke: Option<f64>,
    /// Distance of the two places where the cylinder is held, retracted, less the stroke, m: what a stroke of
    /// 0 would measure from clevis to clevis.
    pub base_length: Option<f64>,
    /// Young's modulus of the rod, Pa; 2.1e11 for steel.
    pub youngs_modulus: f64,
}

impl Cylinder {
    /// A cylinder of which nothing is known but that its rod is of steel; its bore is still to be set.
    pub fn bare() -> Cylinder {
        Cylinder {
            name: String::new(),
            standard: String::new(),
            bore: 0.0,
            rod: 0.0,
            strokes: Vec::new(),
            max_stroke: None,
            max_pressure: None,
            max_speed: None,
            cushion_energy: None,
            moving_mass: None,
            moving_mass_per_stroke: None,
            base_length: None,
            youngs_modulus: YOUNGS_MODULUS_STEEL,
        }
    }

    /// Mass of piston and rod at this stroke, kg, where the catalogue knows it.
    pub fn moving_mass_at(&self, stroke: f64) -> Option<f64> {
        self.moving_mass.map(|base| base + self.moving_mass_per_stroke.unwrap_or(0.0) * stroke)
    }

    /// Fails at numbers that are no cylinder: a bore of 0, a rod as thick as the bore, NaN.
    pub fn validate(&self) -> Result<(), SizingError> {
        let demands = Demands(&self.name);
        demands.positive("bore", self.bore)?;
        demands.below("rod", self.rod, self.bore)?;
        demands.positive("youngs_modulus", self.youngs_modulus)?;
        self.strokes.iter().try_for_each(|stroke| demands.positive("strokes", *stroke))?;
        demands.positive_if_any("max_stroke", self.max_stroke)?;
        demands.positive_if_any("max_pressure", self.max_pressure)?;
        demands.positive_if_any("max_speed", self.max_speed)?;
        demands.not_negative_if_any("cushion_energy", self.cushion_energy)?;
        demands.not_negative_if_any("moving_mass", self.moving_mass)?;
        demands.not_negative_if_any("moving_mass_per_stroke", self.moving_mass_per_stroke)?;
        demands.not_negative_if_any("base_length", self.base_length)
    }
}
