//! Dimensions in words and in units.

use crate::Dimension;

/// A dimension that has a name.
struct Named {
    dimension: Dimension,
    /// With its article.
    phrase: &'static str,
    /// SI unit.
    unit: &'static str,
    /// The unit an example is given in.
    example: &'static str,
}

const fn named(dimension: Dimension, phrase: &'static str, unit: &'static str, example: &'static str) -> Named {
    Named { dimension, phrase, unit, example }
}

const NAMED: &[Named] = &[
    named(Dimension::NONE, "a plain number", "1", ""),
    named(Dimension::LENGTH, "a length", "m", "mm"),
    named(Dimension::AREA, "an area", "m^2", "mm^2"),
    named(Dimension::VOLUME, "a volume", "m^3", "mm^3"),
    named(Dimension::MASS, "a mass", "kg", "kg"),
    named(Dimension::TIME, "a time", "s", "s"),
    named(Dimension::ANGLE, "an angle", "rad", "deg"),
    named(Dimension::TEMPERATURE, "a temperature", "K", "degC"),
    named(Dimension::FREQUENCY, "a frequency", "Hz", "Hz"),
    named(Dimension::VELOCITY, "a velocity", "m/s", "mm/s"),
    named(Dimension::ACCELERATION, "an acceleration", "m/s^2", "m/s^2"),
    named(Dimension::ANGULAR_VELOCITY, "an angular velocity", "rad/s", "rad/s"),
    named(Dimension::ANGULAR_ACCELERATION, "an angular acceleration", "rad/s^2", "rad/s^2"),
    named(Dimension::FORCE, "a force", "N", "N"),
    named(Dimension::MOMENT, "a moment (N*m)", "N*m", "N*m"),
    named(Dimension::POWER, "a power", "W", "W"),
    named(Dimension::INERTIA, "an inertia (kg*m^2)", "kg*m^2", "kg*m^2"),
    named(Dimension::PRESSURE, "a pressure", "Pa", "MPa"),
    named(Dimension::DENSITY, "a density", "kg/m^3", "kg/m^3"),
    named(Dimension::STIFFNESS, "a stiffness (N/m)", "N/m", "N/mm"),
    named(Dimension::DAMPING, "a damping (N*s/m)", "N*s/m", "N*s/m"),
    named(Dimension::TORSIONAL_STIFFNESS, "a torsional stiffness (N*m/rad)", "N*m/rad", "N*m/rad"),
    named(Dimension::TORSIONAL_DAMPING, "a torsional damping (N*m*s/rad)", "N*m*s/rad", "N*m*s/rad"),
];

impl Dimension {
    /// In words with the article: `a length`, `a moment (N*m)`, `a value in kg*m`.
    #[must_use]
    pub fn phrase(self) -> String {
        match self.name() {
            Some(named) => named.phrase.to_owned(),
            None => format!("a value in {}", self.unit()),
        }
    }

    /// Its SI unit as a model file writes it: `N*m`, `kg*m/s`; `1` for a plain number.
    #[must_use]
    pub fn unit(self) -> String {
        match self.name() {
            Some(named) => named.unit.to_owned(),
            None => self.base_units(),
        }
    }

    /// The unit an example value would be written in.
    pub(crate) fn example_unit(self) -> String {
        match self.name() {
            Some(named) => named.example.to_owned(),
            None => self.base_units(),
        }
    }

    fn name(self) -> Option<&'static Named> {
        NAMED.iter().find(|n| n.dimension == self)
    }

    fn base_units(self) -> String {
        let symbols = ["m", "kg", "s", "rad", "K"];
        let exponents = self.exponents();
        // kg first, as everyone writes it.
        let factors = [1, 0, 2, 3, 4].map(|i| (symbols[i], exponents[i]));
        let above: Vec<String> = factors.iter().filter(|f| f.1 > 0.0).map(|f| power(f.0, f.1)).collect();
        let below: Vec<String> = factors.iter().filter(|f| f.1 < 0.0).map(|f| power(f.0, -f.1)).collect();
        let numerator = if above.is_empty() { "1".to_owned() } else { above.join("*") };
        match below.as_slice() {
            [] => numerator,
            [one] => format!("{numerator}/{one}"),
            many => format!("{numerator}/({})", many.join("*")),
        }
    }
}

fn power(symbol: &str, exponent: f64) -> String {
    if exponent == 1.0 { symbol.to_owned() } else { format!("{symbol}^{exponent}") }
}
