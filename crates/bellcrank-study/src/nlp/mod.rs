//! Nonlinear programming: minimize f(x) subject to c(x) ≤ 0, c(x) = 0 and bounds, where f and every c ≤ 0 may be the
//! maximum of several smooth functions.
//!
//! The method is sequential quadratic programming in a box-shaped trust region with an exact ℓ1 penalty (Fletcher,
//! *Practical Methods of Optimization*, 2nd ed., 1987, section 14.4; Nocedal and Wright, *Numerical Optimization*, 2nd ed.,
//! 2006, section 18.5): each constraint may be violated in a subproblem at a price, so that no subproblem is infeasible.
//! Reading order: `problem` (what the caller gives), `solution` (what comes back), `solver` (the loop), `scaled`,
//! `subproblem`, `interior` (the quadratic program), `hessian` (damped BFGS), `kkt` (the independent check at the end).

mod answer;
mod dense;
mod hessian;
mod interior;
mod kkt;
mod multistart;
mod penalty;
mod point;
mod problem;
mod scaled;
mod solution;
mod solver;
mod subproblem;
mod trial;

pub use multistart::{Multistart, Optimum, Search, multistart, multistart_parallel, multistart_watched};
pub use problem::{Evaluation, Function, Malformed, Piece, Problem, Relation, Undefined, Values};
pub use solution::{Kkt, Multipliers, Options, Progress, Solution, Status, Tolerances};
pub use solver::{solve, solve_watched};
