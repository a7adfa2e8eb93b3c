//! Poses of all bodies at some of the rows, for the moving drawing.

use bellcrank_math::quaternion_from_matrix;
use bellcrank_multibody::{BodyId, ForceId};
use bellcrank_results::{Animation, Pose};

use crate::design::{Design, ForceShape};
use crate::signals::{Level, View};

/// Frames of an animation, but for one at the end.
const MOST_FRAMES: usize = 240;

/// Poses picked evenly from the rows.
#[derive(Default)]
pub(super) struct Frames {
    bodies: usize,
    /// Elements that are drawn as arrows.
    arrows: Vec<ForceId>,
    /// Rows of the whole study.
    expected: usize,
    animation: Animation,
}

/// The forces that are drawn as arrows, in the order of the drawing.
pub(crate) fn arrows(design: &Design) -> impl Iterator<Item = usize> + '_ {
    let is_arrow = |(_, force): &(usize, &crate::design::Force)| matches!(force.shape, ForceShape::Point { .. });
    design.forces.iter().enumerate().filter(is_arrow).map(|(index, _)| index)
}

impl Frames {
    pub(super) fn new(design: &Design, expected: usize) -> Frames {
        let arrows = arrows(design).map(ForceId).collect();
        Frames { bodies: design.bodies.len(), arrows, expected, animation: Animation::default() }
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
        if last <= MOST_FRAMES {
            return true;
        }
        let frame = (row * MOST_FRAMES).div_ceil(last);
        frame * last / MOST_FRAMES == row
    }

    pub(super) fn animation(self) -> Option<Animation> {
        (!self.animation.rows.is_empty()).then_some(self.animation)
    }
}
