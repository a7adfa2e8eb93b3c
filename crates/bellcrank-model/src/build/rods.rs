//! Beams on the points of their bodies, in numbers.

use bellcrank_doc::Diagnostic;
use bellcrank_fem::beam::{Line, Section as SectionNumbers, SectionFault, ShearRule, axes};
use bellcrank_math::Real;
use bellcrank_multibody::{Body as BodyNumbers, Place};

use super::Numbers;
use super::frames::Matrix;
use crate::design::{Beam, Design, Elastic, Rod, Section, Values};
use crate::scalar::{Scalar, length};

/// A rod from one end to the other, body axes.
#[derive(Clone, Debug)]
pub(crate) struct RodNumbers<T = f64> {
    pub(crate) ends: [[T; 3]; 2],
    /// Along the rod, along the height of its section, across: columns.
    pub(crate) axes: Matrix<T>,
    pub(crate) length: T,
    pub(crate) section: SectionNumbers<T>,
    /// Young's and shear modulus, Pa, and density, kg/m³; moduli are 0 where the material gives none.
    pub(crate) young: T,
    pub(crate) shear: T,
    pub(crate) density: T,
}

impl<T: Real> RodNumbers<T> {
    /// Constants a length, about the second and third of its axes.
    pub(crate) fn line(&self) -> Line<T> {
        self.section.line(self.young, self.shear, self.density)
    }

    /// The same rod from its other end.
    pub(crate) fn turned(&self) -> RodNumbers<T> {
        let [a, b] = self.ends;
        // Half a turn about the height.
        let axes = self.axes.map(|[x, y, z]| [-x, y, -z]);
        RodNumbers { ends: [b, a], axes, ..self.clone() }
    }

    /// Mass properties as a rigid body.
    fn body(&self) -> BodyNumbers<T> {
        let line = self.line();
        let mass = line.mass * self.length;
        let slender = mass * self.length * self.length / T::from_f64(12.0);
        let [about_y, about_z] = line.rotary.map(|rotary| rotary * self.length);
        let own = [about_y + about_z, slender + about_y, slender + about_z];
        let entry =
            |i: usize, j: usize| (0..3).fold(T::zero(), |sum, k| sum + self.axes[i][k] * own[k] * self.axes[j][k]);
        let half = T::from_f64(0.5);
        BodyNumbers {
            mass,
            center: std::array::from_fn(|i| half * (self.ends[0][i] + self.ends[1][i])),
            inertia: std::array::from_fn(|i| std::array::from_fn(|j| entry(i, j))),
        }
    }
}

/// Mass, centre and inertia of a body from its beam; massless where that cannot be made, which is reported.
pub(super) fn mass<T: Scalar>(numbers: &mut Numbers<'_, T>, rod: &Rod, places: &[Place<T>]) -> BodyNumbers<T> {
    let zero = T::zero();
    let none = BodyNumbers { mass: zero, center: [zero; 3], inertia: [[zero; 3]; 3] };
    of(numbers, rod, places).map_or(none, |rod| rod.body())
}

/// The rod of a body at some values; `None` for a body without one, and where its numbers are wrong.
pub(crate) fn rod_of<T: Scalar>(
    design: &Design,
    values: &Values<T>,
    body: usize,
    places: &[Place<T>],
) -> Option<RodNumbers<T>> {
    let rod = design.bodies.get(body)?.rod.as_ref()?;
    of(&mut Numbers { design, values, faults: &mut Vec::new() }, rod, places)
}

fn of<T: Scalar>(numbers: &mut Numbers<'_, T>, rod: &Rod, places: &[Place<T>]) -> Option<RodNumbers<T>> {
    let design = numbers.design;
    let beam = &design.beams[rod.beam];
    let before = numbers.faults.len();
    let ends = rod.ends.map(|end| places[end].position);
    let along: [T; 3] = std::array::from_fn(|i| ends[1][i] - ends[0][i]);
    let length = length(along);
    if length.value() <= 0.0 {
        let message = format!("beam `{}` has no length: its two ends are at one place", beam.name);
        numbers.faults.push(Diagnostic::error("out-of-range", rod.span, message).also(beam.span, "this beam"));
        return None;
    }
    let axes = upright(numbers, beam, &along);
    let (young, shear, poisson, density) = material(numbers, beam);
    let section = section(numbers, beam, poisson);
    let (axes, section) = (axes?, section?);
    (numbers.faults.len() == before).then_some(RodNumbers { ends, axes, length, section, young, shear, density })
}

/// Axes with the second along the height of the section: in the plane where there is one, else along `up`.
fn upright<T: Scalar>(numbers: &mut Numbers<'_, T>, beam: &Beam, along: &[T; 3]) -> Option<Matrix<T>> {
    let (zero, one) = (T::zero(), T::one());
    if numbers.design.planar {
        return axes(along, &[-along[1], along[0], zero]);
    }
    let Some(up) = &beam.up else {
        return axes(along, &[zero, zero, one]).or_else(|| axes(along, &[zero, one, zero]));
    };
    let direction = numbers.direction(up, format_args!("`up` of beam `{}`", beam.name));
    let found = axes(along, &direction);
    if found.is_none() && direction.iter().any(|x| x.value() != 0.0) {
        let message = format!("`up` of beam `{}` is along the beam", beam.name);
        let report = Diagnostic::error("no-axis", up.span, message);
        numbers.faults.push(report.hint("the height of the section lies across the beam"));
    }
    found
}

/// Young's modulus along the rod, shear modulus, Poisson's ratio, density; zeros where the material gives none.
fn material<T: Scalar>(numbers: &mut Numbers<'_, T>, beam: &Beam) -> (T, T, T, T) {
    let zero = T::zero();
    let design = numbers.design;
    let Some(material) = beam.material.and_then(|place| design.materials.get(place)) else {
        return (zero, zero, zero, zero);
    };
    let name = &material.name;
    let density = material.density.as_ref();
    let density = density.map_or(zero, |one| numbers.above_zero(one, format_args!("`density` of material `{name}`")));
    // What is wrong with moduli is told with the material.
    let value = |quantity: &crate::design::Quantity| quantity.eval::<T>(numbers.values);
    match &material.elastic {
        Some(Elastic::Isotropic { young, poisson }) => {
            let (young, poisson) = (value(young), value(poisson));
            let shear = young / (T::from_f64(2.0) * (T::one() + poisson));
            (young, shear, poisson, density)
        }
        Some(Elastic::Orthotropic { young, poisson, shear }) => {
            (value(&young[0]), value(&shear[0]), value(&poisson[0]), density)
        }
        None => (zero, zero, zero, density),
    }
}

fn section<T: Scalar>(numbers: &mut Numbers<'_, T>, beam: &Beam, poisson: T) -> Option<SectionNumbers<T>> {
    let name = &beam.name;
    let before = numbers.faults.len();
    let rule = ShearRule::Cowper(poisson);
    let mut size = |quantity, key: &str| numbers.above_zero(quantity, format_args!("`{key}` of beam `{name}`"));
    let (made, at) = match &beam.section {
        Section::Faulty => return None,
        Section::Rectangle { width, height } => {
            let sizes = (size(width, "width"), size(height, "height"));
            // The second axis, which the section calls y, is along the height.
            (SectionNumbers::rectangle(sizes.1, sizes.0, rule), width.span())
        }
        Section::Round(diameter) => (SectionNumbers::circle(size(diameter, "diameter"), rule), diameter.span()),
        Section::Tube { outer, wall } => {
            let sizes = (size(outer, "tube"), size(wall, "tube"));
            (SectionNumbers::tube(sizes.0, sizes.1, rule), wall.span())
        }
        Section::Any { area, second_moment, torsion, shear_areas } => {
            let area = size(area, "area");
            let second: Vec<T> = second_moment.iter().map(|one| size(one, "second_moment")).collect();
            let shear: Vec<T> = shear_areas.iter().map(|one| size(one, "shear_areas")).collect();
            let both = |values: &[T]| Some([*values.first()?, *values.last()?]);
            let [up, across] = both(&second)?;
            let torsion = torsion.as_ref().map_or(up + across, |one| size(one, "torsion"));
            let shear = both(&shear).map(|both| both.map(|one| one / area));
            (Ok(SectionNumbers { area, second: [across, up], torsion, shear, points: Vec::new() }), beam.span)
        }
    };
    match made {
        Ok(section) => (numbers.faults.len() == before).then_some(section),
        Err(SectionFault::Size(..)) => None,
        Err(SectionFault::Wall(..)) => {
            let message = format!("the wall of beam `{name}` fills its section");
            let report = Diagnostic::error("out-of-range", at, message);
            numbers.faults.push(report.hint("a full round rod has a `diameter`; a tube `[outer diameter, wall]`"));
            None
        }
    }
}
