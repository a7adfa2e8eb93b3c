//! Poses of all bodies at some of the rows, for the moving drawing.

use bellcrank_math::quaternion_from_matrix;
use bellcrank_multibody::{BodyId, ForceId};
use bellcrank_results::{Animation, Pose};

use crate::design::{Design, ForceShape};
use crate::signals::{Level, View};

/// Frames of an animation over positions, but for one at the end: it plays within seconds.
const FEWEST_FRAMES: usize = 240;
/// Frames of one over time, which can be long: as many as this allows, and poses of all bodies.
const MOST_FRAMES: usize = 1200;
const MOST_POSES: usize = 24_000;

/// Poses picked evenly from the rows.
#[derive(Default)]
pub(super) struct Frames {
    bodies: usize,
    /// Elements that are drawn as arrows.
    arrows: Vec<ForceId>,
    /// Rows of the whole study.
    expected: usize,
    /// Frames, but for one at the end.
    most: usize,
    animation: Animation,
}

/// The forces that are drawn as arrows, in the order of the drawing.
pub(crate) fn arrows(design: &Design) -> impl Iterator<Item = usize> + '_ {
    let is_arrow = |(_, force): &(usize, &crate::design::Force)| matches!(force.shape, ForceShape::Point { .. });
    design.forces.iter().enumerate().filter(is_arrow).map(|(index, _)| index)
}

impl Frames {
    pub(super) fn new(design: &Design, expected: usize, has_time: bool) -> Frames {
        let arrows = arrows(design).map(ForceId).collect();
        let bodies = design.bodies.len();
        let most =
            if has_time { (MOST_POSES / bodies.max(1)).clamp(FEWEST_FRAMES, MOST_FRAMES) } else { FEWEST_FRAMES };
        Frames { bodies, arrows, expected, most, animation: Animation::default() }
    }

    /// Takes the row when its turn has come.
    pub(super) fn record(&mut self, view: &View<'_>, row: usize) {
        if !self.wants(row) {
            return;
        }
        let pose = |body| {
            let motion = view.readings.body(BodyId(body));
            Pose { position: motion.origin, quaternion: quaternion_from_matrix(&motion.rotation) }
        };
        self.animation.rows.push(row);
        self.animation.frames.push((0..self.bodies).map(pose).collect());
        let arrow = |force: &ForceId| match view.level {
            Level::Force => view.readings.force(*force).vector,
            _ => [f64::NAN; 3],
        };
        self.animation.arrows.push(self.arrows.iter().map(arrow).collect());
    }

    /// Whether this row is the nearest one below a frame: k·(rows − 1)/frames, both ends included.
    fn wants(&self, row: usize) -> bool {
        let last = self.expected.saturating_sub(1);
        if last <= self.most {
            return true;
        }
        let frame = (row * self.most).div_ceil(last);
        frame * last / self.most == row
    }

    pub(super) fn animation(self) -> Option<Animation> {
        (!self.animation.rows.is_empty()).then_some(self.animation)
    }
}
