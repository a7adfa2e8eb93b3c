//! Which designs there are: each is made from its number alone.

use std::sync::Arc;

use bellcrank_doc::Expression;
use bellcrank_study::sampling::{Grid, LatinHypercube, Sobol};

use super::super::Asking;
use super::columns::tidy;
use crate::design::{Designs, Levels, Method, Varied};
use crate::trial::Undefined;

/// The values that one parameter takes.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Axis {
    pub(super) span: Span,
    /// Both ends, or all values, as they are shown.
    shown: Vec<f64>,
    /// SI value of the unit in which they are shown.
    factor: f64,
}

/// SI.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Span {
    Range { from: f64, to: f64, levels: usize },
    List(Vec<f64>),
}

/// A value of a parameter.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Value {
    pub(super) si: f64,
    pub(super) shown: f64,
}

/// How a design follows from its number.
enum Points {
    Grid(Grid),
    LatinHypercube(LatinHypercube),
    Sobol(Sobol),
    Table(Arc<Vec<Vec<f64>>>),
}

/// All designs.
pub(super) struct Plan {
    /// Parameters that vary.
    pub(super) parameters: Vec<usize>,
    pub(super) axes: Vec<Axis>,
    points: Points,
    pub(super) total: u64,
}

impl Plan {
    pub(super) fn new(asking: &Asking<'_>, question: &Designs) -> Result<Plan, Undefined> {
        let axes: Vec<Axis> = question.vary.iter().map(|varied| axis(asking, varied)).collect();
        let count = axes.len();
        let (points, total) = match question.method {
            Method::Grid => {
                let levels: Vec<usize> = axes.iter().map(Axis::levels).collect();
                let grid = Grid::new(&levels).ok_or_else(|| refused("this grid has too many designs"))?;
                let rows = grid.rows();
                (Points::Grid(grid), rows)
            }
            Method::LatinHypercube => {
                let cube = LatinHypercube::new(question.samples, count, question.seed);
                (Points::LatinHypercube(cube), question.samples)
            }
            Method::Sobol => {
                let sobol = Sobol::new(count, question.seed).map_err(|why| Undefined {
                    message: why.to_string(),
                    hints: vec!["vary fewer parameters, or take `method = \"lhs\"`".to_owned()],
                })?;
                (Points::Sobol(sobol), question.samples.min(Sobol::POINTS))
            }
            Method::Table => (Points::Table(Arc::clone(&question.table)), question.table.len() as u64),
        };
        let parameters = question.vary.iter().map(|varied| varied.parameter).collect();
        Ok(Plan { parameters, axes, points, total })
    }

    /// The values of a design in the order of the parameters.
    pub(super) fn values(&self, design: u64, values: &mut Vec<Value>) {
        values.clear();
        match &self.points {
            Points::Grid(grid) => {
                let levels = grid.row(design).unwrap_or_default();
                values.extend(self.axes.iter().zip(levels).map(|(axis, level)| axis.level(level)));
            }
            Points::LatinHypercube(cube) => self.sample(&cube.point(design).unwrap_or_default(), values),
            Points::Sobol(sobol) => self.sample(&sobol.point(design).unwrap_or_default(), values),
            Points::Table(rows) => {
                let row = usize::try_from(design).ok().and_then(|design| rows.get(design));
                let row = row.into_iter().flatten();
                values.extend(self.axes.iter().zip(row).map(|(axis, &si)| axis.value(si)));
            }
        }
    }

    fn sample(&self, point: &[f64], values: &mut Vec<Value>) {
        values.extend(self.axes.iter().zip(point).map(|(axis, &share)| axis.at(share)));
    }
}

impl Axis {
    fn levels(&self) -> usize {
        match &self.span {
            Span::Range { levels, .. } => *levels,
            Span::List(values) => values.len(),
        }
    }

    /// A level of a grid: both ends of a range are met exactly, a single level lies in the middle.
    fn level(&self, level: usize) -> Value {
        match &self.span {
            Span::Range { levels: 1, .. } => self.at(0.5),
            Span::Range { levels, .. } => self.at(level as f64 / (levels - 1) as f64),
            Span::List(values) => Value { si: values[level], shown: self.shown[level] },
        }
    }

    /// The value at a share (0 to 1) of the way. Between ends that are round to people, levels are, too.
    fn at(&self, share: f64) -> Value {
        match &self.span {
            Span::Range { from, .. } if share == 0.0 => Value { si: *from, shown: self.shown[0] },
            Span::Range { to, .. } if share == 1.0 => Value { si: *to, shown: self.shown[1] },
            Span::Range { .. } => {
                let shown = self.shown[0] * (1.0 - share) + self.shown[1] * share;
                Value { si: shown * self.factor, shown }
            }
            Span::List(values) => self.level(((share * values.len() as f64) as usize).min(values.len() - 1)),
        }
    }

    /// A value from a table.
    fn value(&self, si: f64) -> Value {
        Value { si, shown: tidy(si / self.factor) }
    }
}

fn axis(asking: &Asking<'_>, varied: &Varied) -> Axis {
    let values = asking.study.parameters.values();
    let parameter = asking.parameter(varied.parameter);
    let end = |own: &Option<Expression>, of: Option<f64>| match own {
        Some(own) => own.eval(values, &[]),
        None => of.unwrap_or(f64::NAN),
    };
    let span = match &varied.levels {
        Levels::Range { from, to, points } => {
            Span::Range { from: end(from, parameter.min), to: end(to, parameter.max), levels: *points }
        }
        Levels::List(all) => Span::List(all.iter().map(|value| value.eval(values, &[])).collect()),
    };
    let factor = asking.parameter_unit(varied.parameter).factor;
    let given = match &span {
        Span::Range { from, to, .. } => &[*from, *to][..],
        Span::List(values) => values,
    };
    let shown = given.iter().map(|si| tidy(si / factor)).collect();
    Axis { span, shown, factor }
}

fn refused(message: &str) -> Undefined {
    Undefined { message: message.to_owned(), hints: Vec::new() }
}
