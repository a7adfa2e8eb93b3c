//! The assist manipulator's lift: every number of the reference table.

use crate::build::*;
use crate::machines::lift;
use bellcrank_multibody::{Actuation, BodyId, Engine};

/// θ₃ [°], θ₁ [°], s₂ [mm], ω₃, ω₁, v₄₁, v₄₂, ε₃, ε₁, a₄₁, a₄₂, force without masses, force.
const TABLE: [[f64; 13]; 5] = [
    [
        -30.0, -31.8830, -79.6477, 0.147210, 0.166280, 0.069925, 0.121113, -0.015226, -0.022881, -0.025061, -0.002233,
        4844.52, 6473.61,
    ],
    [
        -15.0, -15.4523, -41.3895, 0.129688, 0.137693, 0.031887, 0.119005, -0.004936, -0.009460, -0.016647, -0.000394,
        4760.22, 6341.43,
    ],
    [0.0, 0.0, 0.0, 0.125000, 0.125000, 0.000000, 0.118750, 0.000000, -0.003415, -0.014844, 0.000000, 4750.00, 6302.10],
    [
        15.0, 14.5961, 41.4303, 0.129169, 0.122435, -0.031760, 0.118529, 0.004118, 0.000912, -0.016323, -0.000323,
        4741.16, 6268.57,
    ],
    [
        30.0, 28.4878, 80.2829, 0.142220, 0.128858, -0.067555, 0.117008, 0.009945, 0.006167, -0.021365, -0.001425,
        4680.32, 6175.83,
    ],
];

fn table_of(mut e: Box<dyn Engine>) -> Vec<[f64; 13]> {
    e.assemble(&[]).expect("assembles");
    let (lever, slide) = (coordinate(2), coordinate(1));
    let actuation = Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] };
    e.prepare(&actuation).expect("one degree of freedom");
    let mut rows = Vec::new();
    for i in 0..=60 {
        let theta = (-30.0 + f64::from(i)).to_radians();
        e.move_to(0.0, &[theta]).expect("moves");
        e.set_rates(&[0.02], &[0.0]).expect("regular");
        e.solve_forces(&mut |_, _| {}).expect("regular");
        let (checks, r) = (e.checks(), |j| e.coordinate(coordinate(j)));
        assert!(checks.closure < 1e-12 && checks.balance < 1e-9, "{checks:?}");
        if i % 15 == 0 {
            let k = e.point(BodyId(4), [0.1, 0.2, 0.0]);
            rows.push([
                r(2).position.to_degrees(),
                r(0).position.to_degrees(),
                (r(1).position - 0.732) * 1e3,
                r(2).velocity,
                r(0).velocity,
                k.velocity[0],
                k.velocity[1],
                r(2).acceleration,
                r(0).acceleration,
                k.acceleration[0],
                k.acceleration[1],
                0.0,
                e.drive(0),
            ]);
        }
    }
    rows
}

#[test]
fn every_number_of_the_table() {
    let (full, bare) = (table_of(lift([19.84, 20.8, 19.4])), table_of(lift([0.0; 3])));
    let digits = [1e-9, 5.1e-5, 5.1e-5, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-7, 5.1e-3, 5.1e-3];
    for ((row, bare), known) in full.iter().zip(&bare).zip(&TABLE) {
        let mut row = *row;
        row[11] = bare[12];
        for (k, (x, y)) in row.iter().zip(known).enumerate() {
            assert!((x - y).abs() <= digits[k], "column {k} at {}: {x} against {y}", known[0]);
        }
    }
}

#[test]
fn freedom_and_loops() {
    let mut e = lift([19.84, 20.8, 19.4]);
    e.assemble(&[]).expect("assembles");
    let f = e.freedom();
    assert_eq!((f.degrees, f.counted, f.loops, f.redundant.len()), (1, 1, 2, 0));
}
