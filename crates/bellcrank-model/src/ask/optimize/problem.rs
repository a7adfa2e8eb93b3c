//! Designs as the optimizer sees them.

use bellcrank_doc::Comparison;
use bellcrank_study::nlp::{Evaluation, Function, Piece, Problem, Relation, Undefined as Hole};

use super::sign;
use crate::ask::Asking;
use crate::design::{Optimize, Variable};
use crate::trial::{Asked, Derived, Trial, Undefined};

/// The sides of a constraint among the numbers asked: c = plus − minus.
struct Sides {
    plus: usize,
    minus: usize,
}

/// Objective and constraints over the variables, by trials.
pub(super) struct Designing<'d> {
    trial: Trial<'d>,
    variables: Vec<usize>,
    bounds: Vec<(f64, f64)>,
    relations: Vec<Relation>,
    sides: Vec<Sides>,
    sign: f64,
    /// Weight of each term, over its size at the start where there are several.
    weights: Vec<f64>,
    fixed: Vec<(usize, f64)>,
    /// Designs tried.
    pub(super) designs: usize,
    /// Why the first design without responses has none.
    pub(super) hole: Option<Undefined>,
}

/// Pieces that lie this far above the active one say another function.
const ABOVE: f64 = 1e-12;

impl<'d> Designing<'d> {
    pub(super) fn new(asking: &Asking<'d>, question: &Optimize) -> Designing<'d> {
        let mut asked = Asked::default();
        for term in &question.terms {
            asked.response(&term.response);
        }
        let (mut sides, mut relations) = (Vec::new(), Vec::new());
        for constraint in &question.constraints {
            let [left, right] = asked.constraint(constraint);
            let turned = matches!(constraint.comparison, Comparison::Greater | Comparison::GreaterOrEqual);
            sides.push(if turned { Sides { plus: right, minus: left } } else { Sides { plus: left, minus: right } });
            let equal = constraint.comparison == Comparison::Equal;
            relations.push(if equal { Relation::Zero } else { Relation::AtMostZero });
        }
        Designing {
            trial: asking.trial(asked),
            variables: question.variables.iter().map(|v| v.parameter).collect(),
            bounds: question.variables.iter().map(|v| bounds(asking, v)).collect(),
            relations,
            sides,
            sign: sign(question.maximize),
            weights: question.terms.iter().map(|term| term.weight).collect(),
            fixed: Vec::new(),
            designs: 0,
            hole: None,
        }
    }

    pub(super) fn limits(&self) -> &[(f64, f64)] {
        &self.bounds
    }

    /// Several terms count over their sizes at the start.
    pub(super) fn scale(&mut self, start: Option<&[f64]>) {
        if let (Some(start), true) = (start, self.weights.len() > 1) {
            for (weight, value) in self.weights.iter_mut().zip(start) {
                *weight /= if *value == 0.0 { 1.0 } else { value.abs() };
            }
        } else if self.weights.len() == 1 {
            self.weights[0] = 1.0;
        }
    }

    /// All numbers asked, at a design.
    pub(super) fn responses(&mut self, x: &[f64]) -> Result<Vec<f64>, Undefined> {
        self.fixed.clear();
        self.fixed.extend(self.variables.iter().copied().zip(x.iter().copied()));
        self.designs += 1;
        self.trial.run(&self.fixed).map(<[f64]>::to_vec)
    }

    /// The objective as the file means it.
    pub(super) fn objective(&self, numbers: &[f64]) -> f64 {
        self.weights.iter().zip(numbers).map(|(weight, number)| weight * number).sum()
    }

    /// Left and right side of a constraint, plus and minus as the solver has them.
    pub(super) fn sides(&self, constraint: usize) -> (usize, usize) {
        (self.sides[constraint].plus, self.sides[constraint].minus)
    }

    pub(super) fn positions(&self) -> usize {
        self.trial.positions
    }

    /// Sum of the terms, with each at its other pieces in turn.
    fn objective_function(&self, derived: &[Derived]) -> Function {
        let terms: Vec<(f64, &Derived)> = self.weights.iter().map(|w| self.sign * w).zip(derived).collect();
        sum(&terms, true)
    }

    fn constraint_function(&self, sides: &Sides, relation: Relation, derived: &[Derived]) -> Function {
        let terms = [(1.0, &derived[sides.plus]), (-1.0, &derived[sides.minus])];
        sum(&terms, relation == Relation::AtMostZero)
    }

    fn derived(&mut self, x: &[f64]) -> Result<Vec<Derived>, Undefined> {
        self.responses(x)?;
        let variables = std::mem::take(&mut self.variables);
        let derived = self.trial.gradients(&variables);
        self.variables = variables;
        derived
    }
}

impl Problem for Designing<'_> {
    fn variables(&self) -> usize {
        self.variables.len()
    }

    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }

    fn relations(&self) -> &[Relation] {
        &self.relations
    }

    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Hole> {
        match self.derived(x) {
            Ok(derived) => {
                let pairs = self.sides.iter().zip(&self.relations);
                let constraints = pairs.map(|(sides, r)| self.constraint_function(sides, *r, &derived)).collect();
                Ok(Evaluation { objective: self.objective_function(&derived), constraints })
            }
            Err(why) => {
                self.hole.get_or_insert(why);
                Err(Hole)
            }
        }
    }
}

/// Σ factor × response; in pieces where asked and where it is the highest of them.
fn sum(terms: &[(f64, &Derived)], in_pieces: bool) -> Function {
    let active = combined(terms.iter().map(|(factor, derived)| (*factor, &derived.active)));
    let mut pieces = vec![active];
    for (place, (_, derived)) in terms.iter().enumerate().filter(|_| in_pieces) {
        for other in &derived.others {
            let swapped =
                terms.iter().enumerate().map(|(i, (factor, d))| (*factor, if i == place { other } else { &d.active }));
            let piece = combined(swapped);
            if piece.value <= pieces[0].value + ABOVE * pieces[0].value.abs() {
                pieces.push(piece);
            }
        }
    }
    Function { pieces }
}

fn combined<'p>(parts: impl Iterator<Item = (f64, &'p crate::trial::Piece)>) -> Piece {
    let mut sum = Piece { value: 0.0, gradient: Vec::new() };
    for (factor, part) in parts {
        sum.value += factor * part.value;
        sum.gradient.resize(part.gradient.len(), 0.0);
        sum.gradient.iter_mut().zip(&part.gradient).for_each(|(s, g)| *s += factor * g);
    }
    sum
}

fn bounds(asking: &Asking<'_>, variable: &Variable) -> (f64, f64) {
    let parameter = asking.parameter(variable.parameter);
    let values = asking.study.parameters.values();
    let at = |own: &Option<bellcrank_doc::Expression>, of: Option<f64>, none: f64| match own {
        Some(own) => own.eval(values, &[]),
        None => of.unwrap_or(none),
    };
    (at(&variable.min, parameter.min, f64::NEG_INFINITY), at(&variable.max, parameter.max, f64::INFINITY))
}
