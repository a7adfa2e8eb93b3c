use serde_json::{Value, json};

use crate::*;

fn mm() -> Unit {
    Unit::new("mm", 1e-3)
}

fn newton() -> Unit {
    Unit::new("N", 1.0)
}

fn summary(findings: Findings) -> Value {
    study_summary(&StudyResult { findings: Some(findings), ..StudyResult::default() })
}

fn sensitivity() -> Sensitivity {
    Sensitivity {
        of: "lift".to_owned(),
        response: "max(abs(drive.slide.force))".to_owned(),
        value: 6473.6,
        unit: newton(),
        at: vec![ActivePlace {
            reduction: "max(abs(drive.slide.force))".to_owned(),
            axis: "joint.B.position".to_owned(),
            place: (-30.0_f64).to_radians(),
            unit: Unit::new("deg", 1.0_f64.to_radians()),
            between_rows: false,
        }],
        parameters: vec![ParameterSensitivity {
            name: "l32".to_owned(),
            value: 0.16,
            unit: mm(),
            derivative: -39_151.0,
            derivative_unit: Unit::new("N/m", 1.0),
            relative: -0.968,
            note: String::new(),
            curve: Some(Curve { parameter: vec![0.1, 0.2], response: vec![9876.5, f64::NAN] }),
        }],
    }
}

fn optimization() -> Optimization {
    Optimization {
        of: "lift".to_owned(),
        objective: Objective {
            written: "max(abs(drive.slide.force))".to_owned(),
            maximize: false,
            start: 6400.0,
            value: 4800.0,
            unit: newton(),
        },
        variables: vec![VariableRow {
            name: "l31".to_owned(),
            start: 0.732,
            value: 0.6,
            unit: mm(),
            bounds: (0.6, f64::INFINITY),
            bound: Some("lower"),
            multiplier: 5100.0,
            multiplier_unit: Unit::new("N/m", 1.0),
        }],
        constraints: vec![ConstraintRow {
            written: "range(joint.slide.position) <= 160 mm".to_owned(),
            left: (0.15, 0.16),
            right: 0.16,
            unit: mm(),
            active: true,
            violation: 0.0,
            multiplier: -1300.0,
            multiplier_unit: Unit::new("N/m", 1.0),
        }],
        compared: vec![Compared { name: "stroke".to_owned(), start: 0.0, value: 0.16, unit: mm() }],
        iterations: vec![IterationRow {
            start: 0,
            iteration: 1,
            evaluations: 2,
            objective: 5000.0,
            violation: 0.25,
            optimality: 1e-3,
            step: 0.5,
        }],
        starts: vec![StartRow {
            start: 0,
            from: vec![0.732],
            point: vec![0.6],
            objective: 4800.0,
            violation: 0.0,
            status: "converged".to_owned(),
        }],
        iteration_count: 7,
        evaluations: 9,
        failed_designs: 1,
        status: "converged".to_owned(),
        first_order: FirstOrder { stationarity: 1e-9, feasibility: 0.0, complementarity: 2e-9, holds: true },
        written: None,
    }
}

fn column(name: &str, unit: Unit, values: &[f64]) -> Column {
    Column { name: name.to_owned(), unit, values: values.to_vec() }
}

fn designs() -> Designs {
    let front = Table { columns: vec![column("design", Unit::one(), &[7.0]), column("l32", mm(), &[0.18])] };
    Designs {
        of: "lift".to_owned(),
        method: "lhs".to_owned(),
        seed: Some(3),
        total: 50,
        done: 40,
        resumed: 10,
        failed: 2,
        failures: vec![DesignFailure { reason: "cannot be assembled".to_owned(), count: 2, first: 5 }],
        inputs: 1,
        sample: front.clone(),
        statistics: vec![ColumnStatistics {
            name: "l32".to_owned(),
            unit: mm(),
            min: (0.11, 4),
            max: (0.19, 8),
            mean: 0.15,
            deviation: 0.02,
        }],
        pareto: Some(ParetoFront { objectives: [("force".to_owned(), true), ("reach".to_owned(), false)], front }),
        files: vec!["designs.csv".to_owned()],
        threads: 2,
    }
}

fn tolerance() -> Tolerance {
    Tolerance {
        of: "lift".to_owned(),
        response: "at(point.K.y, 3)".to_owned(),
        nominal: 0.36,
        unit: mm(),
        limits: (None, Some(0.3605)),
        inputs: vec![ToleranceInput {
            name: "l5".to_owned(),
            nominal: 0.95,
            unit: mm(),
            half_width: f64::INFINITY,
            distribution: "normal",
            deviation: 0.000_1,
            derivative: 0.25,
            derivative_unit: Unit::one(),
            variance_share: 0.75,
            worst_share: 0.5,
            sobol: Some(SobolIndices { first: (0.75, 0.01), total: (0.76, 0.02) }),
        }],
        worst_case: (0.3596, 0.3604),
        worst_case_exact: None,
        linear_deviation: 0.000_15,
        linear_yield: 0.9996,
        capability: (f64::NAN, 1.11),
        monte_carlo: Some(MonteCarlo {
            samples: 1000,
            seed: 11,
            failed: 0,
            mean: (0.36, 5e-6),
            deviation: (0.000_15, 3e-6),
            range: (0.3595, 0.3605),
            quantiles: vec![(0.5, 0.36), (0.001_35, 0.3596)],
            histogram: vec![HistogramBin { from: 0.3595, to: 0.3605, count: 1000 }],
            within: Some(Yield { share: 0.999, interval: (0.995, 0.9999) }),
        }),
    }
}

fn sizing() -> Sizing {
    let push = Property { key: "peak_push".to_owned(), label: "peak push".to_owned(), value: 6473.6, unit: newton() };
    Sizing {
        of: "lift".to_owned(),
        drive: "slide".to_owned(),
        kind: "pneumatic".to_owned(),
        requirements: vec![push.clone()],
        conditions: Vec::new(),
        candidates: vec![Candidate {
            name: "ISO 15552 160 x 40".to_owned(),
            passes: true,
            properties: vec![push],
            checks: vec![Check {
                key: "push".to_owned(),
                needed: 6473.6,
                available: f64::NAN,
                unit: newton(),
                passes: None,
                reason: "the catalogue does not say".to_owned(),
            }],
        }],
        chosen: Some(0),
        nearest: None,
    }
}

#[test]
fn derivatives_stand_by_parameter() {
    let found = summary(Findings::Sensitivity(sensitivity()));
    assert_eq!(found["response"]["value"], 6473.6);
    assert_eq!(found["response"]["unit"], "N");
    assert_eq!(found["response"]["at"][0]["at"]["joint.B.position"], -30.0);
    let expected = r#"{"l32":{"derivative":-39151.0,"unit":"N/m","relative":-0.968,"value":160.0,"parameter_unit":"mm","note":"","curve":{"parameter":[100.0,200.0],"response":[9876.5,null],"parameter_unit":"mm","response_unit":"N"}}}"#;
    assert_eq!(found["sensitivity"].to_string(), expected);
    assert!(found.get("signals").is_none(), "no rows, no signals");
    assert_eq!(found["rows"], 0);
}

#[test]
fn a_better_design_has_before_and_after() {
    let found = summary(Findings::Optimization(optimization()));
    let expected = r#"{"start":6400.0,"value":4800.0,"unit":"N","change":-0.25,"expression":"max(abs(drive.slide.force))","maximize":false}"#;
    assert_eq!(found["objective"].to_string(), expected);
    let expected = r#"{"l31":{"start":732.0,"value":600.0,"unit":"mm","bound":"lower","min":600.0,"max":null,"multiplier":5100.0,"multiplier_unit":"N/m"}}"#;
    assert_eq!(found["variables"].to_string(), expected);
    assert_eq!(
        (&found["iterations"], &found["evaluations"], &found["status"]),
        (&json!(7), &json!(9), &json!("converged"))
    );
    assert_eq!(found["constraints"][0]["right"], 160.0);
    assert_eq!(found["compared"][0]["change"], Value::Null);
    assert_eq!(found["starts"][0]["point"]["l31"], 600.0);
    assert_eq!(found["history"][0]["violation"], 0.25);
    assert_eq!(found["first_order"]["holds"], true);
    assert_eq!(found["written"], Value::Null);
}

#[test]
fn designs_are_counted() {
    let found = summary(Findings::Designs(designs()));
    assert_eq!((&found["rows"], &found["total"], &found["seed"]), (&json!(40), &json!(50), &json!(3)));
    assert_eq!(found["statistics"]["l32"]["max"], json!({ "value": 190.0, "design": 8 }));
    assert_eq!(found["pareto"]["objectives"][1], json!({ "response": "reach", "goal": "maximize" }));
    assert_eq!(found["pareto"]["rows"], json!([{ "design": 7.0, "l32": 180.0 }]));
    assert_eq!(found["failures"][0]["count"], 2);
}

#[test]
fn a_scatter_has_limits_and_shares() {
    let found = summary(Findings::Tolerance(tolerance()));
    assert_eq!(found["response"]["value"], 360.0);
    assert_eq!(found["limits"], json!({ "min": null, "max": 360.5, "unit": "mm" }));
    assert_eq!(found["tolerances"]["l5"]["half_width"], Value::Null);
    assert_eq!(found["tolerances"]["l5"]["sobol"]["total"]["value"], 0.76);
    assert_eq!(found["monte_carlo"]["quantiles"]["0.5"], 360.0);
    assert_eq!(found["monte_carlo"]["yield"], json!({ "share": 0.999, "low": 0.995, "high": 0.9999 }));
    assert_eq!((&found["cp"], &found["cpk"]), (&Value::Null, &json!(1.11)));
}

#[test]
fn a_drive_is_named() {
    let found = summary(Findings::Sizing(sizing()));
    assert_eq!(found["chosen"], "ISO 15552 160 x 40");
    assert_eq!(found["requirements"]["peak_push"], json!({ "value": 6473.6, "unit": "N" }));
    let check = &found["candidates"][0]["checks"][0];
    assert_eq!((&check["passes"], &check["available"]), (&Value::Null, &Value::Null));
}

#[test]
fn a_study_with_rows_keeps_its_signals() {
    let table = Table { columns: vec![column("pressure", Unit::new("bar", 1e5), &[4.5e5])] };
    let study = StudyResult { table, findings: Some(Findings::Sizing(sizing())), ..StudyResult::default() };
    assert_eq!(study_summary(&study)["signals"]["pressure"]["max"]["value"], 4.5);
}

#[test]
fn tables_for_spreadsheets() {
    let stems = |findings| finding_tables(&findings).into_iter().map(|(stem, _)| stem).collect::<Vec<_>>();
    assert_eq!(stems(Findings::Sensitivity(sensitivity())), ["sensitivity", "curves"]);
    assert_eq!(stems(Findings::Optimization(optimization())), ["variables", "constraints", "iterations"]);
    assert_eq!(stems(Findings::Tolerance(tolerance())), ["tolerances", "histogram"]);
    assert_eq!(stems(Findings::Sizing(sizing())), ["candidates"]);
    assert!(stems(Findings::Designs(designs())).is_empty());
    let mut out = Vec::new();
    let (_, iterations) = finding_tables(&Findings::Optimization(optimization())).remove(2);
    write_text_csv(&iterations, &mut out).unwrap();
    let expected = "start,iteration,evaluations,objective [N],violation,optimality,step\n0,1,2,5000,0.25,0.001,0.5\n";
    assert_eq!(String::from_utf8(out).unwrap(), expected);
}

#[test]
fn every_start_has_its_row() {
    let mut found = optimization();
    found.starts.push(StartRow { start: 1, ..found.starts[0].clone() });
    let tables = finding_tables(&Findings::Optimization(found));
    let (stem, starts) = &tables[3];
    assert_eq!(stem, "starts");
    assert_eq!(starts.heads, ["start", "from l31 [mm]", "to l31 [mm]", "objective [N]", "violation", "status"]);
    assert_eq!(starts.rows[1][0], Field::Number(1.0));
}

#[test]
fn modes_have_frequencies_and_shapes() {
    let mode = ModeRow {
        eigenvalue: [-0.1, 3.0],
        frequency: 0.5,
        damping: 0.03,
        shape: vec![ShapeRow { coordinate: "hinge".to_owned(), unit: Unit::new("rad", 1.0), amplitude: [0.6, -0.8] }],
    };
    let still = ModeRow { eigenvalue: [0.0, 1e-12], frequency: 0.0, damping: 0.0, shape: Vec::new() };
    let found = Modes { freedom: 2, all: 3, at_equilibrium: false, modes: vec![still, mode] };
    let summary = summary(Findings::Modes(found));
    assert_eq!(summary["modes"][0]["what"], "moves freely");
    let mode = &summary["modes"][1];
    assert_eq!(mode["frequency"], json!({ "value": 0.5, "unit": "Hz" }));
    assert_eq!(mode["eigenvalue"], json!({ "re": -0.1, "im": 3.0, "unit": "1/s" }));
    assert_eq!(mode["shape"]["hinge"], json!({ "re": 0.6, "im": -0.8, "unit": "rad" }));
    assert_eq!((&mode["what"], &summary["mode_count"]), (&json!("oscillates"), &json!(3)));
}
