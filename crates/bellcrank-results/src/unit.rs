//! A display unit: a symbol and its size in SI.

/// How a number is shown: `shown = si / factor`.
#[derive(Clone, Debug, PartialEq)]
pub struct Unit {
    /// What is written beside the number, e.g. `mm`; empty for a pure number.
    pub symbol: String,
    /// SI value of one unit, e.g. `0.001` for mm.
    pub factor: f64,
}

impl Unit {
    /// A unit from its symbol and its SI value.
    pub fn new(symbol: impl Into<String>, factor: f64) -> Self {
        Self { symbol: symbol.into(), factor }
    }
    /// The pure number.
    pub fn one() -> Self {
        Self::new("", 1.0)
    }
    /// An SI value in this unit.
    pub fn show(&self, si: f64) -> f64 {
        si / self.factor
    }
}
