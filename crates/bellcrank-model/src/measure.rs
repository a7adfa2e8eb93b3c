//! What a number measures, and the unit it is shown in.

use bellcrank_doc::Dimension;
use bellcrank_results::Unit;

/// What a joint coordinate counts.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Motion {
    /// A distance.
    Slide,
    /// An angle.
    Turn,
}

/// What a number measures. Energy and moment have one dimension and different names and units.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Measure {
    One,
    Length,
    Angle,
    Time,
    Force,
    Moment,
    Stress,
    Mass,
    Power,
    Energy,
    Velocity,
    Acceleration,
    AngularVelocity,
    AngularAcceleration,
}

impl Measure {
    pub(crate) fn position(motion: Motion) -> Measure {
        match motion {
            Motion::Slide => Measure::Length,
            Motion::Turn => Measure::Angle,
        }
    }

    pub(crate) fn velocity(motion: Motion) -> Measure {
        match motion {
            Motion::Slide => Measure::Velocity,
            Motion::Turn => Measure::AngularVelocity,
        }
    }

    pub(crate) fn acceleration(motion: Motion) -> Measure {
        match motion {
            Motion::Slide => Measure::Acceleration,
            Motion::Turn => Measure::AngularAcceleration,
        }
    }

    pub(crate) fn effort(motion: Motion) -> Measure {
        match motion {
            Motion::Slide => Measure::Force,
            Motion::Turn => Measure::Moment,
        }
    }

    pub(crate) fn dimension(self) -> Dimension {
        match self {
            Measure::One => Dimension::NONE,
            Measure::Length => Dimension::LENGTH,
            Measure::Angle => Dimension::ANGLE,
            Measure::Time => Dimension::TIME,
            Measure::Force => Dimension::FORCE,
            Measure::Moment => Dimension::MOMENT,
            Measure::Stress => Dimension::PRESSURE,
            Measure::Mass => Dimension::MASS,
            Measure::Power => Dimension::POWER,
            Measure::Energy => Dimension::ENERGY,
            Measure::Velocity => Dimension::VELOCITY,
            Measure::Acceleration => Dimension::ACCELERATION,
            Measure::AngularVelocity => Dimension::ANGULAR_VELOCITY,
            Measure::AngularAcceleration => Dimension::ANGULAR_ACCELERATION,
        }
    }
}

/// Keys of `[units]`, what they measure, and the unit without that key ("" where it follows from others).
pub(crate) const DISPLAYED: &[(&str, Measure, &str)] = &[
    ("length", Measure::Length, "mm"),
    ("angle", Measure::Angle, "deg"),
    ("force", Measure::Force, "N"),
    ("time", Measure::Time, "s"),
    ("stress", Measure::Stress, "MPa"),
    ("moment", Measure::Moment, "N*m"),
    ("mass", Measure::Mass, "kg"),
    ("power", Measure::Power, "W"),
    ("energy", Measure::Energy, "J"),
    ("velocity", Measure::Velocity, ""),
    ("acceleration", Measure::Acceleration, ""),
    ("angular_velocity", Measure::AngularVelocity, ""),
    ("angular_acceleration", Measure::AngularAcceleration, ""),
];

/// The unit of every measure.
#[derive(Clone, Debug)]
pub(crate) struct DisplayUnits {
    /// In the order of [`DISPLAYED`].
    units: Vec<Unit>,
}

impl DisplayUnits {
    /// The units of the format, with some (by their place in [`DISPLAYED`]) chosen by the file.
    pub(crate) fn new(chosen: &[(usize, Unit)]) -> DisplayUnits {
        let picked = |index: usize| chosen.iter().find(|(i, _)| *i == index).map(|(_, unit)| unit.clone());
        let mut units: Vec<Unit> = Vec::with_capacity(DISPLAYED.len());
        for (index, (_, measure, symbol)) in DISPLAYED.iter().enumerate() {
            let unit = picked(index).unwrap_or_else(|| match rate(*measure) {
                Some((of, power)) => over_time(&units[of], &units[TIME], power),
                None => named(symbol),
            });
            units.push(unit);
        }
        DisplayUnits { units }
    }

    /// The unit of a measure.
    pub(crate) fn of(&self, measure: Measure) -> Unit {
        let index = DISPLAYED.iter().position(|(_, m, _)| *m == measure);
        index.map_or_else(Unit::one, |i| self.units[i].clone())
    }

    /// The unit of a dimension: that of the measure with it, or one made of SI units.
    pub(crate) fn of_dimension(&self, dimension: Dimension) -> Unit {
        let known = DISPLAYED.iter().find(|(_, measure, _)| measure.dimension() == dimension);
        known.map_or_else(|| composed(dimension), |(_, measure, _)| self.of(*measure))
    }
}

const LENGTH: usize = 0;
const ANGLE: usize = 1;
const TIME: usize = 3;

/// For a measure that is another one over a power of time: which, and the power.
fn rate(measure: Measure) -> Option<(usize, i32)> {
    match measure {
        Measure::Velocity => Some((LENGTH, 1)),
        Measure::Acceleration => Some((LENGTH, 2)),
        Measure::AngularVelocity => Some((ANGLE, 1)),
        Measure::AngularAcceleration => Some((ANGLE, 2)),
        _ => None,
    }
}

fn over_time(of: &Unit, time: &Unit, power: i32) -> Unit {
    let exponent = if power == 1 { String::new() } else { format!("^{power}") };
    Unit::new(format!("{}/{}{exponent}", of.symbol, time.symbol), of.factor / time.factor.powi(power))
}

/// A unit that the program itself names.
fn named(symbol: &str) -> Unit {
    bellcrank_doc::unit(symbol).map_or_else(|_| Unit::one(), |unit| Unit::new(symbol, unit.factor))
}

/// The SI unit of a dimension without a key in `[units]`.
fn composed(dimension: Dimension) -> Unit {
    if dimension.is_none() { Unit::one() } else { Unit::new(dimension.unit(), 1.0) }
}
