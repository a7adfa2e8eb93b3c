//! Studies that ask: the paper's lift, its optimum and its sensitivities, and constraints that bite.

use bellcrank_model::{Model, load};
use bellcrank_results::{Findings, Optimization, Sensitivity, StudyResult};

use crate::support::{lift, model, run};

/// The shipped lift with more studies.
fn lift_with(name: &str, studies: &str) -> Model {
    let text = std::fs::read_to_string(lift()).expect("the shipped lift");
    model(name, &format!("{text}\n{studies}"))
}

fn optimum(result: &StudyResult) -> &Optimization {
    match &result.findings {
        Some(Findings::Optimization(found)) => found,
        other => panic!("{other:?}"),
    }
}

fn sensitivity(result: &StudyResult) -> &Sensitivity {
    match &result.findings {
        Some(Findings::Sensitivity(found)) => found,
        other => panic!("{other:?}"),
    }
}

/// Closed form of the stroke: ON(30°) − ON(−30°) with l61 = l32.
fn stroke(l31: f64, l32: f64) -> f64 {
    let length = |turn: f64| {
        let (sin, cos) = turn.to_radians().sin_cos();
        (l31 * cos + l32 * sin).hypot(l32 + l31 * sin - l32 * cos)
    };
    length(30.0) - length(-30.0)
}

/// Peak force of the lift with these lengths: a run of its own.
fn peak(l31: f64, l32: f64, l5: f64) -> f64 {
    let set = [("l31", l31), ("l32", l32), ("l5", l5)].map(|(name, x)| (name.to_owned(), format!("{x:?} m")));
    let model = load(&lift(), &set).model.expect("a model");
    let table = run(&model, "lift").table;
    table.column("drive.slide.force").expect("a drive").values.iter().fold(0.0, |m: f64, f| m.max(f.abs()))
}

#[test]
fn the_papers_optimum() {
    let model = lift_with("optimum", "");
    let result = run(&model, "shorter");
    let found = optimum(&result);
    assert_eq!(found.status, "converged");
    assert!((found.objective.start - 6473.6).abs() < 0.05 && (found.objective.value - 4423.5).abs() < 0.05);
    for (variable, (value, bound)) in found.variables.iter().zip([(0.6, "lower"), (0.2, "upper"), (0.8, "lower")]) {
        assert_eq!((variable.value, variable.bound), (value, Some(bound)), "{}", variable.name);
    }
    assert!(found.first_order.holds && found.evaluations <= 10, "{found:?}");
}

#[test]
fn a_constraint_that_bites_has_the_closed_forms_length_and_multiplier() {
    let model = lift_with(
        "tight",
        "[studies.tight]\nlike = \"shorter\"\nsubject_to = [\"range(joint.slide.position) <= 180 mm\"]",
    );
    let result = run(&model, "tight");
    let found = optimum(&result);
    // l31 and l5 lie on their lower bounds; the stroke decides l32.
    let (mut low, mut high) = (0.1, 0.2);
    for _ in 0..80 {
        let middle = 0.5 * (low + high);
        if stroke(0.6, middle) > 0.18 { high = middle } else { low = middle }
    }
    assert!((found.variables[1].value - low).abs() < 1e-9, "{} and {low}", found.variables[1].value);
    let constraint = &found.constraints[0];
    assert!(constraint.active && constraint.violation == 0.0);
    assert!(found.first_order.holds);
    // ∂F/∂(allowed stroke) along l32, from runs of their own.
    let h = 1e-5;
    let slope = (peak(0.6, low + h, 0.8) - peak(0.6, low - h, 0.8)) / (stroke(0.6, low + h) - stroke(0.6, low - h));
    assert!((constraint.multiplier - slope).abs() < 1e-6 * slope.abs(), "{} and {slope}", constraint.multiplier);
    // ∂F/∂(lower bound of l5), with l32 held by the stroke.
    let by_l5 = (peak(0.6, low, 0.8 + h) - peak(0.6, low, 0.8 - h)) / (2.0 * h);
    let told = found.variables[2].multiplier;
    assert!((told - by_l5).abs() < 1e-6 * by_l5.abs(), "{told} and {by_l5}");
}

#[test]
fn an_infeasible_problem_says_by_how_much() {
    let studies = "[studies.never]\nlike = \"shorter\"\nsubject_to = [\"range(joint.slide.position) <= 80 mm\"]";
    let result = run(&lift_with("infeasible", studies), "never");
    let found = optimum(&result);
    assert_eq!(found.status, "infeasible");
    // The shortest stroke within the bounds is that of the shortest l32.
    let least = stroke(0.6, 0.1).min(stroke(0.8, 0.1)) - 0.08;
    assert!((found.constraints[0].violation - least).abs() < 1e-6, "{} and {least}", found.constraints[0].violation);
    let failure = result.failure.expect("no design is a failure");
    assert!(failure.message.contains("`range(joint.slide.position) <= 80 mm` by "), "{}", failure.message);
}

#[test]
fn many_starts_find_the_same_optimum_and_are_repeatable() {
    let studies = "[studies.many]\nlike = \"shorter\"\nstarts = 6\nseed = 4";
    let model = lift_with("starts", studies);
    let (a, b) = (run(&model, "many"), run(&model, "many"));
    let (a, b) = (optimum(&a), optimum(&b));
    assert_eq!(a.starts.len(), 6);
    for start in &a.starts {
        let off = start.point.iter().zip([0.6, 0.2, 0.8]).fold(0.0, |m: f64, (x, at)| m.max((x - at).abs()));
        assert!(off < 1e-6, "one optimum from all starts: {start:?}");
    }
    assert_eq!(format!("{:?}", a.variables), format!("{:?}", b.variables));
    assert_eq!(a.variables[0].value, 0.6);
}

#[test]
fn the_peak_between_two_rows_is_found_whatever_the_rows() {
    let studies = |points: usize| {
        format!(
            "[studies.coarse]\nlike = \"lift\"\nsweep = {{ joint = \"B\", from = \"-30 deg\", to = \"30 deg\", points = {points} }}\n\
             [studies.push]\nkind = \"sensitivity\"\nof = \"coarse\"\nresponse = \"max(joint.slide.reaction.fx)\"\n\
             parameters = [\"l32\", \"l5\"]\npoints = 0"
        )
    };
    let values = [7, 41, 601].map(|points| {
        let result = run(&lift_with(&format!("rows-{points}"), &studies(points)), "push");
        let found = sensitivity(&result);
        (found.value, found.parameters[0].derivative, found.parameters[1].derivative, found.at[0].place)
    });
    for other in &values[1..] {
        assert!((other.0 - values[0].0).abs() < 1e-9 * values[0].0, "{values:?}");
        assert!((other.1 - values[0].1).abs() < 1e-7 * values[0].1.abs(), "{values:?}");
        assert!((other.2 - values[0].2).abs() < 1e-7 * values[0].2.abs(), "{values:?}");
        assert!((other.3 - values[0].3).abs() < 1e-7, "{values:?}");
    }
}

#[test]
fn a_parameter_without_effect_is_named() {
    let studies = "[studies.none]\nkind = \"sensitivity\"\nof = \"lift\"\nresponse = \"max(abs(drive.slide.force))\"\nparameters = [\"l42\", \"l62\"]\npoints = 0";
    let result = run(&lift_with("flat", studies), "none");
    let found = sensitivity(&result);
    assert!(found.parameters.iter().all(|p| p.note.starts_with("no effect")), "{:?}", found.parameters);
    assert!(result.warnings.iter().any(|w| w.contains("does not depend on any of these")), "{:?}", result.warnings);
}
