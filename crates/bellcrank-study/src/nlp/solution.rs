//! What the solver is told beside the problem, and what it answers.

/// When to stop. All are measured in the solver's scaling: variables by the width of their bounds (or by magnitude),
/// functions by the size of their gradient at the start.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Tolerances {
    /// Greatest component of the gradient of the Lagrangian, and greatest product of multiplier and slack.
    pub optimality: f64,
    /// Greatest violation of a constraint, over the size of its gradient.
    pub feasibility: f64,
    /// A trust region smaller than this ends the search.
    pub step: f64,
}

/// Everything the solver can be told.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Options {
    /// When a point is good enough.
    pub tolerances: Tolerances,
    /// Greatest number of iterations.
    pub iterations: usize,
    /// First trust region: how far a variable may move in the first step, as a share of its scale (the width of its
    /// bounds, or its magnitude).
    pub first_step: f64,
}

/// Tolerances are numbers of the method, not of the physics: 1e-8, 1e-9, 1e-12, 400 iterations.
impl Default for Options {
    fn default() -> Self {
        let tolerances = Tolerances { optimality: 1e-8, feasibility: 1e-9, step: 1e-12 };
        Self { tolerances, iterations: 400, first_step: 0.5 }
    }
}

/// Where the search stands, once an iteration.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Progress {
    /// Number of accepted steps so far.
    pub iteration: usize,
    /// Number of points evaluated so far, with or without gradients.
    pub evaluations: usize,
    /// Objective at the current point, as the caller computes it.
    pub objective: f64,
    /// Greatest violation at the current point, as the caller computes it.
    pub violation: f64,
    /// Greatest component of the scaled gradient of the Lagrangian.
    pub optimality: f64,
    /// Length of the last accepted step: greatest change of a variable over its scale.
    pub step: f64,
}

/// How a search ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Status {
    /// Feasible and stationary within the tolerances.
    Converged,
    /// No step improves the point any more, though the tolerances are not met; usually good to fewer digits.
    StepTooSmall,
    /// As many iterations as allowed.
    IterationLimit,
    /// The sum of the scaled violations has a local minimum here, and it is not zero.
    Infeasible,
    /// The caller asked to stop.
    Interrupted,
    /// The problem has no values at the start.
    UndefinedStart,
}

/// Lagrange multipliers, in the caller's units, so that with L = f + Σ λᵢ cᵢ
///
/// ∇f + Σ λᵢ ∇cᵢ − lower + upper = 0.
///
/// λᵢ ≥ 0 where cᵢ ≤ 0; λᵢ has any sign where cᵢ = 0. Where a function has pieces, ∇ is the mean of the pieces' gradients
/// with the weights of `*_pieces`. Raising the right-hand side 0 of cᵢ to ε changes the
/// optimum by −λᵢ ε.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Multipliers {
    /// λᵢ, one a constraint.
    pub constraints: Vec<f64>,
    /// Of the lower bounds, ≥ 0, one a variable.
    pub lower: Vec<f64>,
    /// Of the upper bounds, ≥ 0, one a variable.
    pub upper: Vec<f64>,
    /// Weight of each piece of the objective in the order of the last evaluation: ≥ 0 with sum 1.
    pub objective_pieces: Vec<f64>,
    /// Share of each piece of each constraint in λᵢ; their sum is λᵢ.
    pub constraint_pieces: Vec<Vec<f64>>,
}

/// Karush–Kuhn–Tucker residuals at the answer, in the solver's scaling, recomputed from the gradients there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kkt {
    /// Greatest component of the gradient of the Lagrangian.
    pub stationarity: f64,
    /// Greatest violation of a constraint.
    pub feasibility: f64,
    /// Greatest product of a multiplier and the slack of what it belongs to.
    pub complementarity: f64,
}

impl Kkt {
    /// The worst of the three.
    #[must_use]
    pub fn worst(&self) -> f64 {
        self.stationarity.max(self.feasibility).max(self.complementarity)
    }

    /// What stands for "not known".
    pub(crate) const UNKNOWN: Self = Self { stationarity: f64::NAN, feasibility: f64::NAN, complementarity: f64::NAN };
}

/// The answer of the solver.
#[derive(Clone, Debug, PartialEq)]
pub struct Solution {
    /// How the search ended.
    pub status: Status,
    /// The best point found, inside the bounds: a feasible one of least objective, else one of least violation.
    pub x: Vec<f64>,
    /// Objective there; NaN if the start was undefined.
    pub objective: f64,
    /// Constraint values there; empty if the start was undefined.
    pub constraints: Vec<f64>,
    /// Greatest violation as the caller computes it.
    pub violation: f64,
    /// Lagrange multipliers.
    pub multipliers: Multipliers,
    /// Constraints that hold with equality (within ten times the feasibility tolerance) or have a multiplier.
    pub active_constraints: Vec<usize>,
    /// Variables on their lower bound.
    pub active_lower: Vec<usize>,
    /// Variables on their upper bound.
    pub active_upper: Vec<usize>,
    /// The check of the answer.
    pub kkt: Kkt,
    /// Greatest component of the objective's gradient at the answer in the solver's scaling of the variables alone; zero
    /// says that the objective does not depend on the variables there.
    pub objective_gradient: f64,
    /// Accepted steps.
    pub iterations: usize,
    /// Points evaluated, with or without gradients.
    pub evaluations: usize,
    /// Points evaluated with gradients.
    pub gradient_evaluations: usize,
    /// Points without values that were met on the way.
    pub undefined: usize,
}

impl Solution {
    /// Whether the answer satisfies bounds and constraints within the tolerance of the solver.
    #[must_use]
    pub fn is_feasible(&self, tolerances: &Tolerances) -> bool {
        self.kkt.feasibility <= 10.0 * tolerances.feasibility
    }
}
