//! The table of a study: room for all rows is made beforehand.

use std::ops::Range;

use bellcrank_multibody::Coordinate;
use bellcrank_results::{Column, Table};

use crate::design::Design;
use crate::signals::{Level, MOST, PLANAR_ANGLE, Source, View};
use crate::trial::running_on;

/// Signals of one source that are recorded.
struct Group {
    source: Source,
    /// Which answers of the source go into which columns, and when they are known.
    parts: Vec<(usize, Level)>,
    columns: Range<usize>,
    /// The answer that is an angle of a body, told between −π and π; it is made to run on.
    turning: Option<usize>,
}

/// Columns that grow row by row.
#[derive(Default)]
pub(super) struct Recorder {
    groups: Vec<Group>,
    columns: Vec<Column>,
    forces: bool,
}

impl Recorder {
    /// For all signals of the model; drives for the coordinates that carry efforts.
    pub(super) fn new(design: &Design, efforts: &[Coordinate], forces: bool, has_time: bool) -> Recorder {
        let mut recorder = Recorder { forces, ..Recorder::default() };
        for &source in design.catalogue.sources() {
            let wanted = match source {
                Source::Time => has_time,
                Source::Drive(c) => efforts.contains(&c),
                // Recovered for all rows at once when the study is over.
                Source::Stress(_) => false,
                _ => true,
            };
            if wanted {
                recorder.add(design, source);
            }
        }
        recorder
    }

    fn add(&mut self, design: &Design, source: Source) {
        let from = self.columns.len();
        let mut parts = Vec::new();
        for (part, column) in design.catalogue.columns(source).into_iter().enumerate() {
            if self.forces || column.level < Level::Force {
                parts.push((part, column.level));
                let unit = design.units.of(column.measure);
                self.columns.push(Column { name: column.name, unit, values: Vec::new() });
            }
        }
        let turns = design.planar && matches!(source, Source::Body(_));
        if !parts.is_empty() {
            let columns = from..self.columns.len();
            self.groups.push(Group { source, parts, columns, turning: turns.then_some(PLANAR_ANGLE) });
        }
    }

    pub(super) fn has_forces(&self) -> bool {
        self.forces
    }

    /// Number of columns.
    pub(super) fn width(&self) -> usize {
        self.columns.len()
    }

    pub(super) fn rows(&self) -> usize {
        self.columns.first().map_or(0, |column| column.values.len())
    }

    /// What a column holds so far; nothing where there is no such column.
    pub(super) fn values(&self, name: &str) -> &[f64] {
        self.columns.iter().find(|column| column.name == name).map_or(&[], |column| &column.values)
    }

    pub(super) fn reserve(&mut self, rows: usize) {
        self.columns.iter_mut().for_each(|column| column.values.reserve_exact(rows));
    }

    /// Adds a row; what is not known at the view's level is NaN.
    pub(super) fn record(&mut self, view: &View<'_>) {
        let mut answers = [f64::NAN; MOST];
        for group in &self.groups {
            view.read(group.source, &mut answers);
            for (&(part, level), column) in group.parts.iter().zip(&mut self.columns[group.columns.clone()]) {
                let mut value = if level <= view.level { answers[part] } else { f64::NAN };
                if group.turning == Some(part) {
                    value = running_on(column.values.last().copied(), value);
                }
                column.values.push(value);
            }
        }
    }

    pub(super) fn table(self) -> Table {
        Table { columns: self.columns }
    }
}
