//! Everything that has a signal, and the signal of a name.

use std::collections::HashMap;
use std::sync::OnceLock;

use bellcrank_multibody::Coordinate;

use super::columns::Column;
use crate::measure::Motion;

/// What signals come from. One source answers several signals at once.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Source {
    Time,
    Joint(Coordinate),
    Reaction(usize),
    Drive(Coordinate),
    Point {
        body: usize,
        point: usize,
    },
    Body(usize),
    Force(usize),
    /// Of a body that deforms, by its place among the bodies.
    Stress(usize),
    Energy,
    Check,
}

/// One signal: a source, and which of its answers.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Signal {
    pub(crate) source: Source,
    pub(crate) part: usize,
}

/// Names and kinds of everything that has signals.
#[derive(Debug, Default)]
pub(crate) struct Layout {
    pub(crate) planar: bool,
    /// Ground first; name, and names of the points.
    pub(crate) bodies: Vec<(String, Vec<String>)>,
    pub(crate) joints: Vec<JointLayout>,
    pub(crate) forces: Vec<ForceLayout>,
    /// Bodies with stress: place, and regions.
    pub(crate) stresses: Vec<(usize, Vec<String>)>,
}

#[derive(Debug)]
pub(crate) struct JointLayout {
    pub(crate) name: String,
    pub(crate) coordinates: &'static [Motion],
    /// A coupler has an effort and no reaction components.
    pub(crate) coupler: bool,
}

#[derive(Debug)]
pub(crate) struct ForceLayout {
    pub(crate) name: String,
    pub(crate) outputs: Outputs,
}

/// What a force element tells about itself.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Outputs {
    /// A force: components and magnitude.
    Force,
    /// A torque: components and magnitude.
    Torque,
    /// An effort along a coordinate.
    Effort(Motion),
    /// Length or coordinate, rate, effort.
    Element(Motion),
}

/// All signals of a model.
#[derive(Debug)]
pub(crate) struct Catalogue {
    layout: Layout,
    sources: Vec<Source>,
    /// Made when the first name is looked up; a chain of 10,000 bodies has half a million names.
    index: OnceLock<HashMap<String, Signal>>,
}

impl Catalogue {
    pub(crate) fn new(layout: Layout) -> Catalogue {
        let sources = sources(&layout);
        Catalogue { layout, sources, index: OnceLock::new() }
    }

    pub(crate) fn layout(&self) -> &Layout {
        &self.layout
    }

    /// In the order of the results.
    pub(crate) fn sources(&self) -> &[Source] {
        &self.sources
    }

    /// The signals of a source.
    pub(crate) fn columns(&self, source: Source) -> Vec<Column> {
        super::columns::columns(source, &self.layout)
    }

    pub(crate) fn find(&self, name: &str) -> Option<Signal> {
        self.index.get_or_init(|| self.indexed()).get(name).copied()
    }

    /// What a signal measures and how late in a position's solution it is known.
    pub(crate) fn column(&self, signal: Signal) -> Option<Column> {
        self.columns(signal.source).into_iter().nth(signal.part)
    }

    fn indexed(&self) -> HashMap<String, Signal> {
        let named = |&source: &Source| {
            let columns = self.columns(source).into_iter().enumerate();
            columns.map(move |(part, column)| (column.name, Signal { source, part }))
        };
        self.sources.iter().flat_map(named).collect()
    }

    /// Names in the order of the results.
    pub(crate) fn names(&self) -> impl Iterator<Item = String> + '_ {
        self.sources.iter().flat_map(|&source| self.columns(source)).map(|column| column.name)
    }
}

fn sources(layout: &Layout) -> Vec<Source> {
    let joints = || layout.joints.iter().enumerate();
    let coordinates = |(joint, of): (usize, &JointLayout)| {
        let joint = bellcrank_multibody::JointId(joint);
        (0..of.coordinates.len()).map(move |index| Coordinate { joint, index })
    };
    let bodies = || layout.bodies.iter().enumerate().skip(1);
    let points = |(body, (_, points)): (usize, &(String, Vec<String>))| {
        (0..points.len()).map(move |point| Source::Point { body, point })
    };
    let mut all = vec![Source::Time];
    all.extend(joints().flat_map(coordinates).map(Source::Joint));
    all.extend(joints().flat_map(coordinates).map(Source::Drive));
    all.extend(joints().map(|(joint, _)| Source::Reaction(joint)));
    all.extend(bodies().flat_map(points));
    all.extend(bodies().map(|(body, _)| Source::Body(body)));
    all.extend((0..layout.forces.len()).map(Source::Force));
    all.extend(layout.stresses.iter().map(|(body, _)| Source::Stress(*body)));
    all.extend([Source::Energy, Source::Check]);
    all
}
