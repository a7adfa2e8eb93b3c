//! Figures as SVG text, small and fast.
//!
//! An own writer, not `kuva` 0.6: that one took 0.83 ms and 73 kB for a figure of six curves of
//! 601 points (release, measured on this machine), so that the forty figures of a run alone would
//! spend the 30 ms the whole report may take. Thinning the lines to what can be seen (see `curve`)
//! is what makes the difference in size.

use crate::number;

mod bars;
mod chart;
mod curve;
mod cycle;
mod frame;
mod histogram;
mod hodograph;
mod legend;
mod parallel;
mod progress;
mod response;
mod scale;
mod scatter;
mod svg;
pub(crate) mod ticks;

pub(crate) use bars::{Bar, Bars};
pub(crate) use chart::Chart;
pub(crate) use cycle::Cycle;
pub(crate) use histogram::{Histogram, Mark, MarkStyle};
pub(crate) use hodograph::Hodograph;
pub(crate) use parallel::{Parallel, Ruler};
pub(crate) use progress::{Course, Progress};
pub(crate) use response::{Response, shared_span};
pub(crate) use scatter::Scatter;

/// A line of a chart: display numbers, not necessarily finite.
pub(crate) struct Curve<'a> {
    pub(crate) name: &'a str,
    pub(crate) y: Vec<f64>,
}

/// An axis label: `joint.B.position [deg]` is split for the tick steps of angles.
#[derive(Clone, Default)]
pub(crate) struct Axis {
    pub(crate) name: String,
    pub(crate) unit: String,
}

impl Axis {
    fn label(&self) -> String {
        match (self.name.as_str(), self.unit.as_str()) {
            (name, "") => name.to_owned(),
            (name, unit) => format!("{name} / {}", number::unit(unit)),
        }
    }
}
