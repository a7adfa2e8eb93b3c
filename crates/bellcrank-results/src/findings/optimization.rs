//! A better design and how it was found.

use crate::Unit;

/// What an optimization found.
#[derive(Clone, Debug)]
pub struct Optimization {
    /// Name of the study that gives the responses.
    pub of: String,
    /// The objective.
    pub objective: Objective,
    /// The variables, in the order of the file.
    pub variables: Vec<VariableRow>,
    /// The constraints, in the order of the file.
    pub constraints: Vec<ConstraintRow>,
    /// Responses before and after: objective, terms of a weighted sum, both sides of constraints.
    pub compared: Vec<Compared>,
    /// All iterations of all starts.
    pub iterations: Vec<IterationRow>,
    /// Each starting point and where it led; the best one first.
    pub starts: Vec<StartRow>,
    /// Iterations of the best start.
    pub iteration_count: usize,
    /// Designs evaluated, all starts.
    pub evaluations: usize,
    /// Designs that could not be assembled or solved on the way.
    pub failed_designs: usize,
    /// `converged`, `infeasible`, `iteration-limit`, `small-step`, `interrupted`, `no-start`.
    pub status: String,
    /// Whether the result is a first-order (Karush–Kuhn–Tucker) point, by how much.
    pub first_order: FirstOrder,
    /// File that the improved model was written to.
    pub written: Option<String>,
}

/// What is made small or large.
#[derive(Clone, Debug)]
pub struct Objective {
    /// As written.
    pub written: String,
    /// It is maximized.
    pub maximize: bool,
    /// Value of the model as it is, SI; NaN where it cannot be assembled.
    pub start: f64,
    /// Value of the result, SI.
    pub value: f64,
    /// Display unit.
    pub unit: Unit,
}

/// A variable.
#[derive(Clone, Debug)]
pub struct VariableRow {
    /// Parameter.
    pub name: String,
    /// In the model as it is, SI.
    pub start: f64,
    /// In the result, SI.
    pub value: f64,
    /// Display unit.
    pub unit: Unit,
    /// Bounds, SI; infinite where there is none.
    pub bounds: (f64, f64),
    /// `"lower"` or `"upper"` where a bound is active.
    pub bound: Option<&'static str>,
    /// ∂objective/∂bound, SI: what moving the active bound up by one unit does to the objective; 0 off the bounds.
    pub multiplier: f64,
    /// SI unit of the multiplier, e.g. `N/m`.
    pub multiplier_unit: Unit,
}

/// A constraint.
#[derive(Clone, Debug)]
pub struct ConstraintRow {
    /// As written.
    pub written: String,
    /// Left side at the start and in the result, SI.
    pub left: (f64, f64),
    /// Right side in the result, SI.
    pub right: f64,
    /// Unit of both sides.
    pub unit: Unit,
    /// It holds with equality (within tolerance).
    pub active: bool,
    /// By how much it is violated in the result, SI; 0 where it holds.
    pub violation: f64,
    /// ∂objective/∂right side, SI; 0 where it is not active.
    pub multiplier: f64,
    /// SI unit of the multiplier.
    pub multiplier_unit: Unit,
}

/// A number before and after.
#[derive(Clone, Debug)]
pub struct Compared {
    /// What it is.
    pub name: String,
    /// Before, SI.
    pub start: f64,
    /// After, SI.
    pub value: f64,
    /// Display unit.
    pub unit: Unit,
}

/// One line of the iteration display.
#[derive(Clone, Debug)]
pub struct IterationRow {
    /// Which start, from 0.
    pub start: usize,
    /// Iteration, from 0.
    pub iteration: usize,
    /// Designs evaluated so far.
    pub evaluations: usize,
    /// Objective, SI.
    pub objective: f64,
    /// Largest violation of a constraint, scaled.
    pub violation: f64,
    /// First-order optimality, scaled.
    pub optimality: f64,
    /// Length of the step, scaled.
    pub step: f64,
}

/// A starting point and where it led.
#[derive(Clone, Debug)]
pub struct StartRow {
    /// Which start, from 0; 0 is the model as it is.
    pub start: usize,
    /// Where it began, SI, in the order of the variables.
    pub from: Vec<f64>,
    /// Where it ended, SI.
    pub point: Vec<f64>,
    /// Objective there, SI.
    pub objective: f64,
    /// Largest violation there, scaled.
    pub violation: f64,
    /// As [`Optimization::status`].
    pub status: String,
}

/// How well the conditions of Karush, Kuhn and Tucker hold (scaled, dimensionless).
#[derive(Clone, Copy, Debug, Default)]
pub struct FirstOrder {
    /// Gradient of the Lagrangian.
    pub stationarity: f64,
    /// Violation of the constraints.
    pub feasibility: f64,
    /// Multipliers times slacks.
    pub complementarity: f64,
    /// All three are within tolerance.
    pub holds: bool,
}
