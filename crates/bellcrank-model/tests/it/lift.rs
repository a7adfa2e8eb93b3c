//! The lift of the assist manipulator: the numbers of the paper.

use bellcrank_model::load;
use bellcrank_results::{Reductions, StudyResult};

use crate::support::{lift, model_of, run, value};

fn range(result: &StudyResult, signal: &str) -> (f64, f64) {
    let column = result.table.column(signal).expect("a signal");
    let found = Reductions::of(&column.values).expect("numbers");
    (found.min.value, found.max.value)
}

#[test]
fn the_paper_is_met_to_its_printed_digits() {
    let model = model_of(&lift());
    let result = run(&model, "lift");
    assert!(result.failure.is_none() && result.warnings.is_empty());
    assert_eq!(result.table.rows(), 601);
    let (low, high) = range(&result, "joint.O.position");
    assert!((low.to_degrees() + 31.883).abs() < 5e-4 && (high.to_degrees() - 28.488).abs() < 5e-4);
    let (low, high) = range(&result, "joint.slide.position");
    assert!((low - 0.732 + 0.079_648).abs() < 5e-7 && (high - 0.732 - 0.080_283).abs() < 5e-7);
    assert!((value(&result, "drive.slide.force", 0) - 6473.61).abs() < 5e-3);
    assert!((range(&result, "drive.slide.force").1 - 6473.61).abs() < 5e-3);
    let massless = run(&model, "massless");
    assert!((range(&massless, "drive.slide.force").1 - 4844.52).abs() < 5e-3);
    assert_eq!(massless.changed.len(), 3);
}

/// θ3 [deg] and, there, θ1 [deg], s2 [mm], ω3, ω1, v41, v42, ε3, ε1, a41, a42, force without and with masses.
const TABLE: [[f64; 13]; 5] = [
    [
        -30.0, -31.8830, -79.6477, 0.147210, 0.166280, 0.069925, 0.121113, -0.015226, -0.022881, -0.025061, -0.002233,
        4844.52, 6473.61,
    ],
    [
        -15.0, -15.4523, -41.3895, 0.129688, 0.137693, 0.031887, 0.119005, -0.004936, -0.009460, -0.016647, -0.000394,
        4760.22, 6341.43,
    ],
    [0.0, 0.0, 0.0, 0.125000, 0.125000, 0.0, 0.118750, 0.0, -0.003415, -0.014844, 0.0, 4750.00, 6302.10],
    [
        15.0, 14.5961, 41.4303, 0.129169, 0.122435, -0.031760, 0.118529, 0.004118, 0.000912, -0.016323, -0.000323,
        4741.16, 6268.57,
    ],
    [
        30.0, 28.4878, 80.2829, 0.142220, 0.128858, -0.067555, 0.117008, 0.009945, 0.006167, -0.021365, -0.001425,
        4680.32, 6175.83,
    ],
];

#[test]
fn the_table_at_five_positions_is_met() {
    let model = model_of(&lift());
    let (full, massless) = (run(&model, "lift"), run(&model, "massless"));
    for (i, line) in TABLE.iter().enumerate() {
        let row = i * 150;
        let at = |signal: &str| value(&full, signal, row);
        let computed = [
            at("joint.B.position").to_degrees(),
            at("joint.O.position").to_degrees(),
            (at("joint.slide.position") - 0.732) * 1e3,
            at("joint.B.velocity"),
            at("joint.O.velocity"),
            at("point.link4.K.vx"),
            at("point.link4.K.vy"),
            at("joint.B.acceleration"),
            at("joint.O.acceleration"),
            at("point.link4.K.ax"),
            at("point.link4.K.ay"),
            value(&massless, "drive.slide.force", row),
            at("drive.slide.force"),
        ];
        let tolerances =
            [1e-9, 5.1e-5, 5.1e-5, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-3, 5.1e-3];
        for ((found, wanted), tolerance) in computed.iter().zip(line).zip(tolerances) {
            assert!((found - wanted).abs() < tolerance, "row {row}: {found} against {wanted}");
        }
    }
}

#[test]
fn residuals_are_small_and_the_drawing_moves() {
    let model = model_of(&lift());
    let result = run(&model, "lift");
    assert!(range(&result, "check.closure").1 < 1e-12);
    assert!(range(&result, "check.balance").1 < 1e-9);
    let animation = result.animation.expect("frames");
    assert_eq!(animation.frames.len(), 241);
    assert_eq!((animation.rows[0], animation.rows[240]), (0, 600));
    let drawing = model.drawing();
    assert_eq!(drawing.bodies.len(), animation.frames[0].len());
    assert_eq!(drawing.arrows.len(), animation.arrows[0].len());
    assert!(drawing.joints.iter().any(|joint| joint.name == "slide" && joint.driven));
}

#[test]
fn the_check_counts_freedoms_and_loops() {
    let check = model_of(&lift()).check();
    assert_eq!((check.degrees, check.counted, check.loops), (Some(1), 1, 2));
    assert!(check.redundant.is_empty() && check.failure.is_none());
    assert_eq!(check.json()["degrees_of_freedom"]["computed"], 1);
    assert!(check.text().contains("closes a loop"));
}

#[test]
fn the_command_line_overrides_parameters() {
    let loaded = load(&lift(), &[("m1".to_owned(), "0kg".to_owned()), ("load".to_owned(), "0 N".to_owned())]);
    let model = loaded.model.expect("a model");
    let parameters = model.parameters();
    assert_eq!(parameters.iter().find(|p| p.name == "m1").map(|p| p.value), Some(0.0));
    let wrong = load(&lift(), &[("m9".to_owned(), "0kg".to_owned()), ("m1".to_owned(), "1 m".to_owned())]);
    assert_eq!(wrong.diagnostics.errors(), 2);
}
