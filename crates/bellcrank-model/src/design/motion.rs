//! Prescribed motions of a checked model.

use std::sync::Arc;

use bellcrank_doc::Span;
use bellcrank_multibody::Coordinate;

use super::Quantity;
use crate::motion::{Profile, Spline};

/// Coordinates prescribed in time.
#[derive(Debug)]
pub(crate) struct Prescribed {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// One, or all of a joint with several.
    pub(crate) coordinates: Vec<Coordinate>,
    pub(crate) law: Law,
    pub(crate) start: Start,
}

/// When a motion begins.
#[derive(Clone, Debug)]
pub(crate) struct Start {
    /// The keys that say it; the motion where there are none.
    pub(crate) span: Span,
    pub(crate) origin: Origin,
    /// Comes on top.
    pub(crate) delay: Option<Quantity>,
}

/// What the start of a motion counts from.
#[derive(Clone, Debug)]
pub(crate) enum Origin {
    /// Time 0.
    Zero,
    Time(Quantity),
    /// The end of something.
    After(Mark),
    /// The beginning of something.
    With(Mark),
    /// It was written wrong, which has been told.
    Unknown,
}

/// A motion by its place in the list, or one of its segments.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Mark {
    pub(crate) motion: usize,
    pub(crate) segment: Option<usize>,
}

/// How a coordinate moves.
#[derive(Clone, Debug)]
pub(crate) enum Law {
    Segments(Vec<Segment>),
    /// One of `time` for each coordinate; `time` is signal 0 and counts from the start of the motion.
    Expressions(Vec<Quantity>),
    Table(Arc<Spline>),
    Velocity(Quantity),
}

/// A part of a motion.
#[derive(Clone, Debug)]
pub(crate) struct Segment {
    pub(crate) name: Option<String>,
    pub(crate) span: Span,
    pub(crate) kind: SegmentKind,
    pub(crate) duration: Quantity,
}

#[derive(Clone, Debug)]
pub(crate) enum SegmentKind {
    Move { goal: Goal, profile: Profile },
    Hold,
}

/// Where a move ends.
#[derive(Clone, Debug)]
pub(crate) enum Goal {
    To(Quantity),
    /// From where it begins.
    By(Quantity),
}

impl Goal {
    pub(crate) fn quantity(&self) -> &Quantity {
        match self {
            Goal::To(quantity) | Goal::By(quantity) => quantity,
        }
    }
}

impl Prescribed {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        self.law.each_quantity(visit);
        if let Origin::Time(time) = &self.start.origin {
            visit(time);
        }
        self.start.delay.iter().for_each(visit);
    }
}

impl Start {
    /// What it waits for.
    pub(crate) fn mark(&self) -> Option<Mark> {
        match self.origin {
            Origin::After(mark) | Origin::With(mark) => Some(mark),
            _ => None,
        }
    }
}

impl Law {
    fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Law::Segments(segments) => {
                for segment in segments {
                    visit(&segment.duration);
                    if let SegmentKind::Move { goal, .. } = &segment.kind {
                        visit(goal.quantity());
                    }
                }
            }
            Law::Expressions(laws) => laws.iter().for_each(visit),
            Law::Velocity(rate) => visit(rate),
            Law::Table(_) => {}
        }
    }

    /// Whether a time comes from which on it rests.
    pub(crate) fn ends(&self) -> bool {
        matches!(self, Law::Segments(_) | Law::Table(_))
    }
}

/// The coordinates that motions move, each once, in the order of the motions.
pub(crate) fn moved<'m>(motions: impl IntoIterator<Item = &'m Prescribed>) -> Vec<Coordinate> {
    let mut all: Vec<Coordinate> = Vec::new();
    for &c in motions.into_iter().flat_map(|motion| &motion.coordinates) {
        if !all.contains(&c) {
            all.push(c);
        }
    }
    all
}
