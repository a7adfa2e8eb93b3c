//! Units by name.

use crate::Dimension;

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
        value * self.factor + self.offset
    }

    /// An SI value in this unit.
    #[must_use]
    pub fn from_si(self, si: f64) -> f64 {
        (si - self.offset) / self.factor
    }
}

/// The unit written as `mm` or `kg*m^2`; `Err` is a sentence saying why not, with a hint. For
/// display units (`[units] length = "mm"`).
pub fn unit(written: &str) -> Result<Unit, String> {
    todo!()
}

/// Names of all single units.
pub fn unit_names() -> impl Iterator<Item = &'static str> {
    [""].into_iter()
}
