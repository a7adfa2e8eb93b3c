//! Tolerances of the lift and a cylinder for it.

use std::f64::consts::PI;

use bellcrank_results::{
    Candidate, Check, HistogramBin, MonteCarlo, Property, Reductions, Sizing, SobolIndices, Table, Tolerance,
    ToleranceInput, Yield,
};

use super::kinds::{PEAK, Point, derivative, nominal, peak, random};
use super::{column, unit};

/// Half widths of l31, l32 and l5, and the load's deviation.
const SPREAD: [(usize, &str, &str, f64); 4] =
    [(0, "l31", "mm", 0.000_8), (1, "l32", "mm", 0.001), (2, "l5", "mm", 0.001_5), (6, "load", "N", 9.0)];
const LIMITS: (f64, f64) = (6330.0, 6590.0);
const SAMPLES: usize = 20_000;

fn normal(state: &mut u64) -> f64 {
    (0..12).map(|_| random(state)).sum::<f64>() - 6.0
}

fn samples() -> Vec<f64> {
    let mut state = 11;
    let draw = |_| {
        let mut point: Point = nominal();
        for (index, _, _, half) in SPREAD {
            point[index] += normal(&mut state) * half / if index == 6 { 1.0 } else { 3.0 };
        }
        peak(point)
    };
    (0..SAMPLES).map(draw).collect()
}

fn inputs() -> Vec<ToleranceInput> {
    let deviation = |half: f64, index: usize| if index == 6 { half } else { half / 3.0 };
    let part = |index: usize, half: f64| (derivative(peak, index) * deviation(half, index)).powi(2);
    let total: f64 = SPREAD.iter().map(|(index, _, _, half)| part(*index, *half)).sum();
    let worst: f64 = SPREAD[..3].iter().map(|(index, _, _, half)| derivative(peak, *index).abs() * half).sum();
    let mut inputs: Vec<_> = SPREAD
        .iter()
        .map(|(index, name, symbol, half)| ToleranceInput {
            name: (*name).to_owned(),
            nominal: nominal()[*index],
            unit: unit(symbol),
            half_width: if *index == 6 { f64::INFINITY } else { *half },
            distribution: if *index == 6 { "normal" } else { "truncated" },
            deviation: deviation(*half, *index),
            derivative: derivative(peak, *index),
            derivative_unit: unit(if *index == 6 { "" } else { "N/m" }),
            variance_share: part(*index, *half) / total,
            worst_share: if *index == 6 { f64::NAN } else { derivative(peak, *index).abs() * half / worst },
            sobol: Some(SobolIndices {
                first: (part(*index, *half) / total, 0.004),
                total: (part(*index, *half) / total + 0.001, 0.006),
            }),
        })
        .collect();
    inputs.sort_by(|a, b| b.variance_share.total_cmp(&a.variance_share));
    inputs
}

pub fn tolerance() -> Tolerance {
    let inputs = inputs();
    let sum = |of: &dyn Fn(&ToleranceInput) -> f64| inputs.iter().map(of).filter(|v| v.is_finite()).sum::<f64>();
    let reach = sum(&|i| i.derivative.abs() * i.half_width);
    let linear_deviation = sum(&|i| (i.derivative * i.deviation).powi(2)).sqrt();
    let value = peak(nominal());
    let run = monte_carlo();
    let margin = (LIMITS.1 - run.mean.0).min(run.mean.0 - LIMITS.0);
    let capability = ((LIMITS.1 - LIMITS.0) / 6.0 / run.deviation.0, margin / 3.0 / run.deviation.0);
    Tolerance {
        of: "lift".to_owned(),
        response: PEAK.to_owned(),
        nominal: value,
        unit: unit("N"),
        limits: (Some(LIMITS.0), Some(LIMITS.1)),
        inputs,
        worst_case: (value - reach, value + reach),
        worst_case_exact: Some((value - reach + 1.3, value + reach + 1.7)),
        linear_deviation,
        linear_yield: 0.9974,
        capability,
        monte_carlo: Some(run),
    }
}

fn monte_carlo() -> MonteCarlo {
    let mut values = samples();
    values.sort_by(f64::total_cmp);
    let found = Reductions::of(&values).unwrap();
    let (low, high) = (found.min.value, found.max.value);
    let deviation = values.iter().map(|v| (v - found.mean).powi(2)).sum::<f64>().sqrt() / (SAMPLES as f64).sqrt();
    let width = (high - low) / 40.0;
    let bin = |index: usize| {
        let (from, to) = (low + width * index as f64, low + width * (index + 1) as f64);
        let inside = |v: &&f64| **v >= from && (**v < to || index == 39);
        HistogramBin { from, to, count: values.iter().filter(inside).count() as u64 }
    };
    let quantile = |share: f64| (share, values[((SAMPLES - 1) as f64 * share) as usize]);
    let within = values.iter().filter(|v| (LIMITS.0..=LIMITS.1).contains(*v)).count() as f64 / SAMPLES as f64;
    MonteCarlo {
        samples: SAMPLES as u64,
        seed: 11,
        failed: 0,
        mean: (found.mean, deviation / (SAMPLES as f64).sqrt()),
        deviation: (deviation, deviation / (2.0 * SAMPLES as f64).sqrt()),
        range: (low, high),
        quantiles: [0.001_35, 0.05, 0.5, 0.95, 0.998_65].map(quantile).to_vec(),
        histogram: (0..40).map(bin).collect(),
        within: Some(Yield { share: within, interval: (within - 0.0008, within + 0.0007) }),
    }
}

fn property(key: &str, value: f64, symbol: &str) -> Property {
    let unit = match symbol {
        "bar" => bellcrank_results::Unit::new("bar", 1e5),
        symbol => unit(symbol),
    };
    Property { key: key.to_owned(), label: key.replace('_', " "), value, unit }
}

/// Working pressure over the stroke of a bore of 160 mm.
pub fn pressure() -> Table {
    let position: Vec<f64> = (0..61).map(|i| -0.0796 + 0.1599 * f64::from(i) / 60.0).collect();
    let force: Vec<f64> =
        position.iter().map(|s| 6473.6 - 300.0 * (s + 0.0796) / 0.1599 + 9000.0 * (s - 0.02) * (s + 0.08)).collect();
    let area = PI / 4.0 * 0.16 * 0.16;
    let bar = |values: Vec<f64>| bellcrank_results::Column {
        unit: bellcrank_results::Unit::new("bar", 1e5),
        ..column("", "", values)
    };
    let named =
        |name: &str, column: bellcrank_results::Column| bellcrank_results::Column { name: name.to_owned(), ..column };
    Table {
        columns: vec![
            column("joint.slide.position", "mm", position),
            named("working pressure", bar(force.iter().map(|f| f / area).collect())),
            named("supply pressure", bar(vec![6e5; 61])),
            column("drive.slide.force", "N", force),
        ],
    }
}

fn candidate(bore: f64, rod: f64) -> Candidate {
    let area = PI / 4.0 * bore * bore;
    let available = 6e5 * area * 0.7;
    let needed = 6473.6;
    let push = available >= needed;
    let need_stroke = 0.1599;
    let buckling = PI.powi(3) * 2.1e11 * (rod / 2.0_f64).powi(4) / 4.0 / 1.2_f64.powi(2) / 5.0;
    let share = 100.0 * needed / (6e5 * area);
    let check = |key: &str, needed: f64, available: f64, symbol: &str, passes: Option<bool>, reason: String| Check {
        key: key.to_owned(),
        needed,
        available,
        unit: unit(symbol),
        passes,
        reason,
    };
    let push_reason = format!("6474 N is {share:.0} % of the {:.0} N at 6 bar; up to 70 % is allowed", 6e5 * area);
    let rod_reason = format!("6474 N against {buckling:.0} N with both ends hinged and a safety of 5");
    Candidate {
        name: format!("ISO 15552 {:.0} x {:.0}, stroke 160", bore * 1e3, rod * 1e3),
        passes: push && buckling > needed,
        properties: vec![
            property("bore", bore, "mm"),
            property("rod", rod, "mm"),
            property("stroke", 0.16, "mm"),
            property("push_force", 6e5 * area, "N"),
        ],
        checks: vec![
            check("push", needed, available, "N", Some(push), push_reason),
            check("stroke", need_stroke, 0.16, "mm", Some(true), "159.9 mm of 160 mm".to_owned()),
            check("buckling", needed, buckling, "N", Some(buckling > needed), rod_reason),
            check("speed", 0.02, f64::NAN, "mm/s", None, "the catalogue gives no speed".to_owned()),
        ],
    }
}

pub fn sizing() -> Sizing {
    let mut candidates: Vec<_> = [(0.08, 0.025), (0.1, 0.025), (0.125, 0.032), (0.16, 0.04), (0.2, 0.04), (0.25, 0.05)]
        .map(|(bore, rod)| candidate(bore, rod))
        .to_vec();
    candidates.sort_by_key(|candidate| !candidate.passes);
    Sizing {
        of: "lift".to_owned(),
        drive: "slide".to_owned(),
        kind: "pneumatic".to_owned(),
        requirements: vec![
            property("stroke", 0.1599, "mm"),
            property("peak_push", 6473.6, "N"),
            property("peak_pull", 0.0, "N"),
            property("peak_speed", 0.02, "mm/s"),
            property("peak_power", 129.5, "W"),
        ],
        conditions: vec![
            property("supply_pressure", 6e5, "bar"),
            property("load_factor", 0.7, ""),
            property("buckling_safety", 5.0, ""),
        ],
        candidates,
        chosen: Some(0),
        nearest: None,
    }
}
