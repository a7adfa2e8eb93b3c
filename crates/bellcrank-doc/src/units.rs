//! Units by name.

use std::f64::consts::PI;

use crate::expression::parse_unit;
use crate::{Dimension, nearest};

/// A unit: `value * factor + offset` is the SI value.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Unit {
    /// SI value of one.
    pub factor: f64,
    /// SI value of zero; not 0 only for degC standing alone.
    pub offset: f64,
    /// What it measures.
    pub dimension: Dimension,
}

impl Unit {
    /// A value in this unit, in SI.
    #[must_use]
    pub fn to_si(self, value: f64) -> f64 {
        let scaled = match self.divisor() {
            Some(divisor) => value / divisor,
            None => value * self.factor,
        };
        scaled + self.offset
    }

    /// An SI value in this unit.
    #[must_use]
    pub fn from_si(self, si: f64) -> f64 {
        match self.divisor() {
            Some(divisor) => (si - self.offset) * divisor,
            None => (si - self.offset) / self.factor,
        }
    }

    /// 1000 for mm: 0.001 has no exact binary form, but 732/1000 rounds to 0.732 as one expects.
    fn divisor(self) -> Option<f64> {
        let divisor = (1.0 / self.factor).round();
        (self.factor < 1.0 && 1.0 / divisor == self.factor).then_some(divisor)
    }
}

const fn plain(factor: f64, dimension: Dimension) -> Unit {
    Unit { factor, offset: 0.0, dimension }
}

/// Exact by definition, but for deg and rpm, which hold pi.
const TABLE: &[(&str, Unit)] = &[
    ("m", plain(1.0, Dimension::LENGTH)),
    ("mm", plain(1e-3, Dimension::LENGTH)),
    ("cm", plain(1e-2, Dimension::LENGTH)),
    ("um", plain(1e-6, Dimension::LENGTH)),
    ("in", plain(0.0254, Dimension::LENGTH)),
    ("ft", plain(0.3048, Dimension::LENGTH)),
    ("kg", plain(1.0, Dimension::MASS)),
    ("g", plain(1e-3, Dimension::MASS)),
    ("t", plain(1e3, Dimension::MASS)),
    ("lb", plain(0.453_592_37, Dimension::MASS)),
    ("s", plain(1.0, Dimension::TIME)),
    ("ms", plain(1e-3, Dimension::TIME)),
    ("min", plain(60.0, Dimension::TIME)),
    ("h", plain(3600.0, Dimension::TIME)),
    ("N", plain(1.0, Dimension::FORCE)),
    ("kN", plain(1e3, Dimension::FORCE)),
    ("lbf", plain(POUND_FORCE, Dimension::FORCE)),
    ("Pa", plain(1.0, Dimension::PRESSURE)),
    ("kPa", plain(1e3, Dimension::PRESSURE)),
    ("MPa", plain(1e6, Dimension::PRESSURE)),
    ("GPa", plain(1e9, Dimension::PRESSURE)),
    ("bar", plain(1e5, Dimension::PRESSURE)),
    ("psi", plain(POUND_FORCE / (0.0254 * 0.0254), Dimension::PRESSURE)),
    ("J", plain(1.0, Dimension::ENERGY)),
    ("W", plain(1.0, Dimension::POWER)),
    ("kW", plain(1e3, Dimension::POWER)),
    ("Hz", plain(1.0, Dimension::FREQUENCY)),
    ("rpm", plain(PI / 30.0, Dimension::ANGULAR_VELOCITY)),
    ("rad", plain(1.0, Dimension::ANGLE)),
    ("deg", plain(PI / 180.0, Dimension::ANGLE)),
    ("K", plain(1.0, Dimension::TEMPERATURE)),
    ("degC", Unit { factor: 1.0, offset: 273.15, dimension: Dimension::TEMPERATURE }),
    ("L", plain(1e-3, Dimension::VOLUME)),
];

const POUND_FORCE: f64 = 4.448_221_615_260_5;

/// What people write for units of the table.
const ALIASES: &[(&str, &str)] = &[
    ("degree", "deg"),
    ("degrees", "deg"),
    ("°", "deg"),
    ("grad", "deg"),
    ("radian", "rad"),
    ("radians", "rad"),
    ("°C", "degC"),
    ("C", "degC"),
    ("celsius", "degC"),
    ("kelvin", "K"),
    ("meter", "m"),
    ("metre", "m"),
    ("meters", "m"),
    ("metres", "m"),
    ("micron", "um"),
    ("µm", "um"),
    ("μm", "um"),
    ("inch", "in"),
    ("inches", "in"),
    ("foot", "ft"),
    ("feet", "ft"),
    ("lbs", "lb"),
    ("kgs", "kg"),
    ("ton", "t"),
    ("tonne", "t"),
    ("sec", "s"),
    ("second", "s"),
    ("seconds", "s"),
    ("minute", "min"),
    ("minutes", "min"),
    ("hour", "h"),
    ("hours", "h"),
    ("hr", "h"),
    ("newton", "N"),
    ("l", "L"),
    ("liter", "L"),
    ("litre", "L"),
    ("mps", "m/s"),
    ("rps", "rad/s"),
];

/// A single unit by its name.
pub(crate) fn single(name: &str) -> Option<Unit> {
    TABLE.iter().find(|(n, _)| *n == name).map(|(_, unit)| *unit)
}

/// The unit written as `mm` or `kg*m^2`; `Err` is a sentence saying why not, with a hint. For
/// display units (`[units] length = "mm"`).
pub fn unit(written: &str) -> Result<Unit, String> {
    parse_unit(written).map_err(|fault| match suggestion(written.trim()) {
        Some(meant) => format!("{fault}; did you mean `{meant}`?"),
        None => fault,
    })
}

/// Names of all single units.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    TABLE.iter().map(|(name, _)| *name)
}

/// What was probably meant by a name that is no unit: `Nm` -> `N*m`, `MM` -> `mm`.
pub(crate) fn suggestion(name: &str) -> Option<String> {
    let alias = |n: &str| ALIASES.iter().find(|(from, _)| *from == n).map(|(_, to)| (*to).to_owned());
    let other_case = || unit_names().find(|n| n.eq_ignore_ascii_case(name)).map(str::to_owned);
    let near = || nearest(name, unit_names()).map(str::to_owned);
    alias(name).or_else(|| alias(&name.to_lowercase())).or_else(other_case).or_else(|| joined(name)).or_else(near)
}

/// A power or product written without its sign: `mm2`, `Nm`, `kgm2`.
fn joined(name: &str) -> Option<String> {
    let starts = ["", "kN", "N", "lbf", "kg", "kW", "W"];
    starts.iter().find_map(|first| {
        let rest = name.strip_prefix(first)?;
        let second = rest.strip_suffix(['2', '3']).unwrap_or(rest);
        single(second)?;
        let times = if first.is_empty() { "" } else { "*" };
        let power = if second == rest { String::new() } else { format!("^{}", &rest[second.len()..]) };
        Some(format!("{first}{times}{second}{power}"))
    })
}
