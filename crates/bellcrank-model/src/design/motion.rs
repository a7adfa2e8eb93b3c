//! Prescribed motions of a checked model.

use std::sync::Arc;

use bellcrank_multibody::Coordinate;

use super::Quantity;
use crate::motion::{Profile, Spline};

/// Coordinates prescribed in time.
#[derive(Debug)]
pub(crate) struct Prescribed {
    pub(crate) name: String,
    /// One, or all of a joint with several.
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) law: Law,
}

/// How a coordinate moves.
#[derive(Clone, Debug)]
pub(crate) enum Law {
    Segments(Vec<Segment>),
    /// One of `time` for each coordinate; `time` is signal 0.
    Expressions(Vec<Quantity>),
    Table(Arc<Spline>),
    Velocity(Quantity),
}

/// A part of a motion.
#[derive(Clone, Debug)]
pub(crate) struct Segment {
    pub(crate) kind: SegmentKind,
    pub(crate) duration: Quantity,
}

#[derive(Clone, Debug)]
pub(crate) enum SegmentKind {
    Move { to: Quantity, profile: Profile },
    Hold,
}

impl Law {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Law::Segments(segments) => {
                for segment in segments {
                    visit(&segment.duration);
                    if let SegmentKind::Move { to, .. } = &segment.kind {
                        visit(to);
                    }
                }
            }
            Law::Expressions(laws) => laws.iter().for_each(visit),
            Law::Velocity(rate) => visit(rate),
            Law::Table(_) => {}
        }
    }
}
