//! Materials in numbers, and what no material can have.

mod fatigue;

use bellcrank_doc::Diagnostic;
use bellcrank_fem::fatigue::Fatigue;

use super::Numbers;
use crate::design::{Design, Elastic, Material, Quantity, Values};

/// A material in numbers, SI.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct MaterialNumbers {
    /// kg/m³; `None` where the file gives none.
    pub(crate) density: Option<f64>,
    pub(crate) elastic: Option<ElasticNumbers>,
    /// Yield strength, Pa.
    pub(crate) strength: Option<f64>,
    /// Thermal expansion along the axes of the solid, 1/K.
    pub(crate) expansion: Option<[f64; 3]>,
    /// Tensile strength, Pa.
    pub(crate) tensile: Option<f64>,
    /// How life under repeated load is worked out.
    pub(crate) fatigue: Option<Fatigue>,
}

/// How a material gives way; moduli in Pa.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum ElasticNumbers {
    Isotropic {
        young: f64,
        poisson: f64,
    },
    /// E1, E2, E3; ν12, ν23, ν13; G12, G23, G13.
    Orthotropic {
        young: [f64; 3],
        poisson: [f64; 3],
        shear: [f64; 3],
    },
}

/// A material of the design in numbers; what is wrong with them is reported.
pub(crate) fn material(
    design: &Design,
    values: &Values,
    place: usize,
    faults: &mut Vec<Diagnostic>,
) -> Option<MaterialNumbers> {
    let material = design.materials.get(place)?;
    let before = faults.len();
    let mut check = Check { numbers: Numbers { design, values, faults }, material };
    let tensile = material.tensile.as_ref().map(|strength| check.above_zero(strength, "tensile"));
    let found = MaterialNumbers {
        density: material.density.as_ref().map(|density| check.above_zero(density, "density")),
        elastic: material.elastic.as_ref().map(|elastic| check.elastic(elastic)),
        strength: material.strength.as_ref().map(|strength| check.above_zero(strength, "yield")),
        expansion: check.expansion(),
        tensile,
        fatigue: material.fatigue.as_ref().and_then(|form| check.fatigue(form, tensile)),
    };
    check.ordered(&found);
    (faults.len() == before).then_some(found)
}

/// What is wrong with the numbers of all materials.
pub(crate) fn material_faults(design: &Design, values: &Values, faults: &mut Vec<Diagnostic>) {
    for place in 0..design.materials.len() {
        material(design, values, place, faults);
    }
}

struct Check<'a> {
    numbers: Numbers<'a>,
    material: &'a Material,
}

impl Check<'_> {
    fn number(&mut self, quantity: &Quantity, key: &str) -> f64 {
        self.numbers.number(quantity, format_args!("`{key}` of material `{}`", self.material.name))
    }

    fn above_zero(&mut self, quantity: &Quantity, key: &str) -> f64 {
        let name = &self.material.name;
        self.numbers.above_zero(quantity, format_args!("`{key}` of material `{name}`"))
    }

    fn report(&mut self, quantity: &Quantity, message: String, hint: &str) {
        self.numbers.faults.push(Diagnostic::error("material", quantity.span(), message).hint(hint));
    }

    /// No material yields above its tensile strength.
    fn ordered(&mut self, found: &MaterialNumbers) {
        let (Some(strength), Some(tensile), Some(quantity)) = (found.strength, found.tensile, &self.material.tensile)
        else {
            return;
        };
        if 0.0 < tensile && tensile < strength {
            let message = format!("`tensile` of material `{}` is below its `yield`", self.material.name);
            self.report(quantity, message, "the tensile strength is the larger one");
        }
    }

    fn expansion(&mut self) -> Option<[f64; 3]> {
        let given: Vec<f64> = self.material.expansion.iter().map(|one| self.number(one, "expansion")).collect();
        match *given.as_slice() {
            [one] => Some([one; 3]),
            [x, y, z] => Some([x, y, z]),
            _ => None,
        }
    }

    fn elastic(&mut self, elastic: &Elastic) -> ElasticNumbers {
        match elastic {
            Elastic::Isotropic { young, poisson } => {
                ElasticNumbers::Isotropic { young: self.above_zero(young, "young"), poisson: self.poisson(poisson) }
            }
            Elastic::Orthotropic { young: moduli, poisson: ratios, shear } => {
                let before = self.numbers.faults.len();
                let young = std::array::from_fn(|k| self.above_zero(&moduli[k], "young"));
                let poisson = std::array::from_fn(|k| self.number(&ratios[k], "poisson"));
                let shear = std::array::from_fn(|k| self.above_zero(&shear[k], "shear"));
                if self.numbers.faults.len() == before {
                    self.stable(ratios, young, poisson);
                }
                ElasticNumbers::Orthotropic { young, poisson, shear }
            }
        }
    }

    fn poisson(&mut self, quantity: &Quantity) -> f64 {
        let before = self.numbers.faults.len();
        let poisson = self.number(quantity, "poisson");
        let name = &self.material.name;
        if poisson == 0.5 {
            let message = format!(
                "`poisson` of material `{name}` is 0.5: such a material keeps its volume, its bulk modulus has no bound, and elements of displacements lock"
            );
            let hint = "rubber: take 0.49 or what was measured; up to that second-order elements do not lock";
            self.report(quantity, message, hint);
        } else if self.numbers.faults.len() == before && !(-1.0 < poisson && poisson < 0.5) {
            let message = format!("`poisson` of material `{name}` must lie above -1 and below 0.5, found {poisson}");
            self.report(
                quantity,
                message,
                "metals have 0.25 to 0.35; beyond the limits a material would give energy away",
            );
        }
        poisson
    }

    /// Every strain must take energy: the compliance between the three normal strains is positive definite.
    fn stable(&mut self, ratios: &[Quantity; 3], [e1, e2, e3]: [f64; 3], [n12, n23, n13]: [f64; 3]) {
        let name = &self.material.name;
        let pairs = [("12", n12, e1 / e2, "E1/E2"), ("23", n23, e2 / e3, "E2/E3"), ("13", n13, e1 / e3, "E1/E3")];
        let mut faults = Vec::new();
        for (k, (axes, ratio, limit, of)) in pairs.into_iter().enumerate() {
            let minor = 1.0 - ratio * ratio / limit;
            if minor <= 0.0 {
                let message = format!(
                    "material `{name}` is not stable: the minor of axes {} and {}, 1 - nu{axes}^2/({of}), is {}",
                    &axes[..1],
                    &axes[1..],
                    rounded(minor)
                );
                let hint =
                    format!("nu{axes} must lie within -sqrt({of}) and sqrt({of}), here {}", rounded(limit.sqrt()));
                faults.push((k, message, hint));
            }
        }
        let determinant =
            1.0 - n12 * n12 * e2 / e1 - n23 * n23 * e3 / e2 - n13 * n13 * e3 / e1 - 2.0 * n12 * n23 * n13 * e3 / e1;
        if faults.is_empty() && determinant <= 0.0 {
            let message = format!(
                "material `{name}` is not stable: the determinant of all three axes, 1 - nu12^2 E2/E1 - nu23^2 E3/E2 - nu13^2 \
                 E3/E1 - 2 nu12 nu23 nu13 E3/E1, is {}",
                rounded(determinant)
            );
            faults.push((0, message, "smaller Poisson's ratios make it positive".to_owned()));
        }
        for (k, message, hint) in faults {
            self.report(&ratios[k], message, &hint);
        }
    }
}

/// Four digits are enough to see what is meant.
fn rounded(value: f64) -> f64 {
    format!("{value:.3e}").parse().unwrap_or(value)
}
