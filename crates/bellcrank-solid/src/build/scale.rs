//! What counts as zero for a link.

use bellcrank_math::Real;

use crate::{Corner, CutShape, Fault, Link};

/// Smallest and largest extent of a solid in m.
const EXTENTS: [f64; 2] = [1e-6, 1e6];

/// Size of a link and what follows from it, in m.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Scale {
    /// Middle of its box in plan.
    pub(crate) middle: [f64; 2],
    /// Places nearer than this are one.
    pub(crate) tolerance: f64,
    /// Lengths below this are refused.
    pub(crate) least: f64,
}

/// Scale of a link of finite numbers.
pub(crate) fn scale<T: Real>(link: &Link<T>) -> Result<Scale, Fault> {
    let mut reach = Box::default();
    for eye in &link.eyes {
        let half = [eye.bore, eye.outer, eye.clearance.unwrap_or(T::zero())].map(|d| d.value().abs() / 2.0);
        reach.disc(eye.center, half.into_iter().fold(0.0, f64::max));
    }
    let corners = link.plates.iter().map(|p| &p.outline).chain(link.cuts.iter().filter_map(|cut| match &cut.shape {
        CutShape::Outline(corners) => Some(corners),
        _ => None,
    }));
    corners.flatten().for_each(|Corner { at, .. }| reach.disc(*at, 0.0));
    for cut in &link.cuts {
        match &cut.shape {
            CutShape::Hole { center, diameter } => reach.disc(*center, diameter.value().abs() / 2.0),
            CutShape::Slot { from, to, width } => {
                reach.disc(*from, width.value().abs() / 2.0);
                reach.disc(*to, width.value().abs() / 2.0);
            }
            CutShape::Outline(_) => {}
        }
    }
    reach.scale()
}

/// Lowest and highest coordinates.
struct Box([[f64; 2]; 2]);

impl Default for Box {
    fn default() -> Self {
        Box([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]])
    }
}

impl Box {
    fn disc<T: Real>(&mut self, center: [T; 2], radius: f64) {
        let [low, high] = &mut self.0;
        for ((low, high), x) in low.iter_mut().zip(high).zip(center) {
            *low = low.min(x.value() - radius);
            *high = high.max(x.value() + radius);
        }
    }

    fn scale(&self) -> Result<Scale, Fault> {
        let [low, high] = self.0;
        if low[0] > high[0] {
            return Err(Fault::Empty);
        }
        let size = (high[0] - low[0]).max(high[1] - low[1]);
        let far = [low[0], low[1], high[0], high[1]].into_iter().fold(0.0, |a: f64, b| a.max(b.abs()));
        let within = |x: f64| (EXTENTS[0]..=EXTENTS[1]).contains(&x);
        if !within(size) || far > EXTENTS[1] {
            return Err(Fault::Extent { extent: if within(size) { far } else { size } });
        }
        let tolerance = 1e-9 * size + 1e-13 * far;
        Ok(Scale { middle: [(low[0] + high[0]) / 2.0, (low[1] + high[1]) / 2.0], tolerance, least: 20.0 * tolerance })
    }
}
