//! Studies of kind `tolerance` against closed forms.

use bellcrank_model::{Model, Progress, RunOptions, Silent};
use bellcrank_results::{Findings, MonteCarlo, StudyResult, Tolerance, ToleranceInput, study_summary};

use crate::support::{model, root, run};

/// Offset slider-crank; x = r cos θ + √(l² − (e − r sin θ)²).
const SLIDER_CRANK: &str = r#"
[parameters]
r = "50 mm ± 0.3 mm"
l = { value = "200 mm", tolerance = "0.4 mm", sigma = "0.1 mm", distribution = "truncated" }
e = { value = "10 mm", sigma = "0.05 mm" }
"#;

const MACHINE: &str = r#"
[ground.points]
O     = [0, 0]
guide = [0, "e"]
[bodies.crank.points]
O = [0, 0]
A = ["r", 0]
[bodies.rod.points]
A = [0, 0]
B = ["l", 0]
[bodies.slider.points]
B = [0, 0]
[joints]
crank = { kind = "revolute",  connects = ["ground.O", "crank.O"], start = "START" }
A     = { kind = "revolute",  connects = ["rod.A", "crank.A"] }
B     = { kind = "revolute",  connects = ["slider.B", "rod.B"] }
slide = { kind = "prismatic", connects = ["ground.guide", "slider.B"], axis = "x", start = "150 mm" }
[studies.turn]
kind = "kinematics"
sweep = { joint = "crank", from = "START", to = "START + 10 deg", points = 2 }
[studies.scatter]
kind = "tolerance"
of = "turn"
"#;

fn machine(name: &str, parameters: &str, start: &str, study: &str) -> Model {
    let text = format!(
        "bellcrank = 1\ntitle = \"t\"\nspace = \"planar\"\ngravity = [0, 0]\n{parameters}{}{study}",
        MACHINE.replace("START", start)
    );
    model(name, &text)
}

fn found(result: &StudyResult) -> &Tolerance {
    match &result.findings {
        Some(Findings::Tolerance(found)) => found,
        _ => panic!("{:?}", result.failure),
    }
}

fn input<'f>(found: &'f Tolerance, name: &str) -> &'f ToleranceInput {
    found.inputs.iter().find(|input| input.name == name).unwrap_or_else(|| panic!("no input {name}"))
}

fn drawn(found: &Tolerance) -> &MonteCarlo {
    found.monte_carlo.as_ref().expect("machines were drawn")
}

fn near(found: f64, wanted: f64, relative: f64) {
    assert!((found - wanted).abs() <= relative * wanted.abs(), "{found} instead of {wanted}");
}

/// `found` with its standard error holds `wanted`; four errors are chance once in 16 000 times, and the seed is fixed.
fn within(found: (f64, f64), wanted: f64) {
    assert!((found.0 - wanted).abs() < 4.0 * found.1, "{found:?} instead of {wanted}");
}

fn said(result: &StudyResult, part: &str) -> bool {
    result.warnings.iter().any(|warning| warning.contains(part))
}

fn slider(th: f64, [r, l, e]: [f64; 3]) -> f64 {
    r * th.cos() + (l * l - (e - r * th.sin()).powi(2)).sqrt()
}

fn standard_deviation_when_cut(sigma: f64, k: f64) -> f64 {
    // φ(4), Φ(4) of tables.
    let (density, inside) = (1.338_302_257_648_853_7e-4, 1.0 - 2.0 * 3.167_124_183_311_998_6e-5);
    sigma * (1.0 - 2.0 * k * density / inside).sqrt()
}

#[test]
fn the_accuracy_of_a_slider_is_that_of_the_closed_form() {
    let study = "response = \"first(joint.slide.position)\"\nsamples = 20000\nlimits = [\"220 mm\", \"221 mm\"]\n";
    let result = run(&machine("slider", SLIDER_CRANK, "60 deg", study), "scatter");
    let found = found(&result);
    let th = 60f64.to_radians();
    let (r, l, e) = (0.05, 0.2, 0.01);
    let s = (l * l - (e - r * th.sin()).powi(2)).sqrt();
    let gradient = [th.cos() + (e - r * th.sin()) * th.sin() / s, l / s, -(e - r * th.sin()) / s];
    let sigmas = [1e-4, standard_deviation_when_cut(1e-4, 4.0), 5e-5];
    let widths = [3e-4, 4e-4, 1.5e-4];
    near(found.nominal, slider(th, [r, l, e]), 1e-14);
    let variance: f64 = gradient.iter().zip(sigmas).map(|(g, s)| (g * s).powi(2)).sum();
    near(found.linear_deviation, variance.sqrt(), 1e-11);
    let reach: f64 = gradient.iter().zip(widths).map(|(g, t)| (g * t).abs()).sum();
    near(found.worst_case.1 - found.nominal, reach, 1e-11);
    for (i, name) in ["r", "l", "e"].into_iter().enumerate() {
        let of = input(found, name);
        near(of.derivative, gradient[i], 1e-11);
        near(of.deviation, sigmas[i], 1e-12);
        near(of.variance_share, (gradient[i] * sigmas[i]).powi(2) / variance, 1e-10);
        near(of.worst_share, (gradient[i] * widths[i]).abs() / reach, 1e-10);
    }
    assert!(found.inputs.windows(2).all(|pair| pair[0].variance_share >= pair[1].variance_share));
    assert_eq!(input(found, "e").half_width, f64::INFINITY);

    let corner = |signs: [f64; 3]| {
        let at = |i: usize, x: f64| x + signs[i] * widths[i];
        slider(th, [at(0, r), at(1, l), at(2, e)])
    };
    let (low, high) = found.worst_case_exact.expect("every corner closes");
    near(low, corner([-1.0, -1.0, -1.0]), 1e-13);
    near(high, corner([1.0, 1.0, 1.0]), 1e-13);

    // Monte Carlo and the linear estimate agree within the sampling error: the response is all but straight here.
    let drawn = drawn(found);
    within(drawn.deviation, found.linear_deviation);
    within(drawn.mean, found.nominal);
    near(drawn.mean.1, found.linear_deviation / 20000f64.sqrt(), 0.02);
    near(drawn.deviation.1, found.linear_deviation / 40000f64.sqrt(), 0.05);
    assert!(result.warnings.is_empty(), "{:?}", result.warnings);
    assert_eq!(drawn.histogram.iter().map(|bin| bin.count).sum::<u64>(), 20000);
    let cpk = (0.221 - drawn.mean.0).min(drawn.mean.0 - 0.220) / (3.0 * drawn.deviation.0);
    near(found.capability.1, cpk, 1e-12);
    near(found.capability.0, 0.001 / (6.0 * drawn.deviation.0), 1e-12);
}

#[test]
fn a_uniform_rod_gives_uniform_positions() {
    let parameters = "[parameters]\nr = \"50 mm\"\nl = \"200 mm ± 1 mm\"\ne = \"10 mm\"\n";
    let study = "response = \"first(joint.slide.position)\"\nsamples = 10000\ndistribution = \"uniform\"\nseed = 3\n\
                 limits = { max = \"LIMIT\" }\n";
    let th = 60f64.to_radians();
    let at = |l: f64| slider(th, [0.05, l, 0.01]);
    let limit = at(0.2006);
    let study = study.replace("LIMIT", &format!("{limit:e} m"));
    let result = run(&machine("uniform", parameters, "60 deg", &study), "scatter");
    let found = found(&result);
    let drawn = drawn(found);
    let share = 0.8; // of rods below 200.6 mm
    let within_limits = drawn.within.expect("there is a limit");
    within((within_limits.share, (share * (1.0 - share) / 1e4f64).sqrt()), share);
    assert!(within_limits.interval.0 < share && share < within_limits.interval.1);
    within(drawn.deviation, (at(0.201) - at(0.199)) / 12f64.sqrt());
    // The sample quantile at p of a uniform distribution has the standard error width √(p(1 − p)/n).
    for &(p, value) in &drawn.quantiles {
        let error = (at(0.201) - at(0.199)) * (p * (1.0 - p) / 1e4_f64).sqrt();
        within((value, error), at(0.199 + 0.002 * p));
    }
    let (low, high) = found.worst_case_exact.expect("both ends close");
    assert!(low <= drawn.range.0 && drawn.range.1 <= high);
    near(high, at(0.201), 1e-13);
}

#[test]
fn any_number_of_threads_gives_the_same_numbers() {
    let study = "response = \"first(joint.slide.position)\"\nsamples = 700\nsobol = true\nseed = 11\n";
    let machine = machine("threads", SLIDER_CRANK, "20 deg", study);
    let summary = |threads: usize, seed: &str| {
        let options = RunOptions { threads, ..RunOptions::default() };
        let mut run = machine.run_all(&["scatter".to_owned()], &options, &mut Silent).expect("runs");
        run.studies[0].seconds = 0.0;
        (study_summary(&run.studies[0]).to_string(), seed.to_owned())
    };
    assert_eq!(summary(1, ""), summary(2, ""));
    assert_eq!(summary(1, ""), summary(5, ""));
}

#[test]
fn machines_that_do_not_close_are_counted() {
    // At 90° the rod must span 40 mm; one in 0.1587 is shorter.
    let parameters = "[parameters]\nr = \"50 mm\"\nl = \"42 mm ± 6 mm\"\ne = \"10 mm\"\n";
    let study = "response = \"first(joint.slide.position)\"\nsamples = 4000\nlimits = { min = \"-1 m\" }\n";
    let result = run(&machine("failing", parameters, "90 deg", study), "scatter");
    let found = found(&result);
    let drawn = drawn(found);
    let share = 0.158_655_253_931_457_05;
    within((drawn.failed as f64 / 4000.0, (share * (1.0 - share) / 4000.0_f64).sqrt()), share);
    near(drawn.within.expect("a limit").share, 1.0 - drawn.failed as f64 / 4000.0, 1e-12);
    assert_eq!(found.worst_case_exact, None);
    assert!(said(&result, "there is no exact worst case: 1 of the 2 machines"), "{:?}", result.warnings);
    assert!(said(&result, "machines gave no result, which counts as outside the limits"));
    assert!(said(&result, "the linear estimate of the standard deviation is off by"));
    assert!(result.failure.is_none());
}

#[test]
fn what_the_linear_estimate_does_not_see_is_said() {
    // The mean of √(l² − e²) over a normal e is l − σ²/2l, its deviation σ²/(√2 l); the derivative is zero.
    let parameters = "[parameters]\nr = \"50 mm\"\nl = \"200 mm\"\ne = { value = \"0 mm\", sigma = \"2 mm\" }\n";
    let study = "response = \"first(joint.slide.position)\"\nsamples = 4000\n";
    let result = run(&machine("curved", parameters, "0 deg", study), "scatter");
    let found = found(&result);
    assert!(found.linear_deviation < 1e-15);
    within(drawn(found).deviation, 4e-6 / (0.2 * 2f64.sqrt()));
    within((drawn(found).mean.0 - found.nominal, drawn(found).mean.1), -4e-6 / 0.4);
    assert!(said(&result, "is off by -100.00 %"), "{:?}", result.warnings);
    assert!(said(&result, "the response is curved"));
}

#[test]
fn a_distance_has_a_kink_where_it_is_zero() {
    let parameters = "[parameters]\nr = \"50 mm\"\nl = \"200 mm\"\ne = { value = \"10 mm\", sigma = \"0.1 mm\" }\n";
    let study = "response = \"sqrt((e - 10 mm)^2)\"\nsamples = 4000\n";
    let result = run(&machine("distance", parameters, "60 deg", study), "scatter");
    let found = found(&result);
    assert_eq!(found.linear_deviation, 0.0);
    near(found.worst_case_exact.expect("evaluated").1, 3e-4, 1e-12);
    assert!(said(&result, "is off by -100.00 %") && said(&result, "at the corners"), "{:?}", result.warnings);
    // A half-normal distribution.
    within(drawn(found).mean, 1e-4 * std::f64::consts::FRAC_2_PI.sqrt());
    within(drawn(found).deviation, 1e-4 * (1.0 - std::f64::consts::FRAC_2_PI).sqrt());
}

#[test]
fn a_reaction_without_a_derivative_is_still_drawn() {
    let door = root().join("verify/cases/door-two-hinges/model.toml");
    let text = std::fs::read_to_string(door).expect("reads").replace("\"28 kg\"", "\"leaf\"");
    let study = "[parameters]\nleaf = \"28 kg ± 0.6 kg\"\n[studies.share]\nkind = \"tolerance\"\nof = \"run\"\n\
                 response = \"first(joint.low.reaction.fz)\"\nsamples = 200\n";
    let result = run(&model("door", &format!("{text}{study}")), "share");
    let found = found(&result);
    let reason = "there is no linear estimate: the response has no derivative by `leaf` (equilibrium alone";
    assert!(said(&result, reason), "{:?}", result.warnings);
    assert!(
        found.linear_deviation.is_nan() && found.worst_case.0.is_nan() && input(found, "leaf").variance_share.is_nan()
    );
    assert_eq!(drawn(found).failed, 0);
    assert!(found.worst_case_exact.is_some() && drawn(found).deviation.0 > 0.0);
}

#[test]
fn sobol_indices_of_a_product() {
    let parameters = "[parameters]\nr = { value = \"50 mm\", sigma = \"10 mm\" }\nl = \"200 mm\"\n\
                      e = { value = \"30 mm\", sigma = \"10 mm\" }\n";
    let study = "response = \"r*e\"\nsamples = 1024\nsobol = true\n";
    let result = run(&machine("product", parameters, "60 deg", study), "scatter");
    let found = found(&result);
    let (of_r, of_e, both) = (0.03f64.powi(2) * 1e-4, 0.05f64.powi(2) * 1e-4, 1e-8);
    let variance = of_r + of_e + both;
    within(drawn(found).deviation, variance.sqrt());
    for (name, alone) in [("r", of_r), ("e", of_e)] {
        let sobol = input(found, name).sobol.expect("asked for");
        within(sobol.first, alone / variance);
        within(sobol.total, (alone + both) / variance);
        near(sobol.first.0, alone / variance, 0.05);
    }
    let designs = result.effort.iter().find(|(name, _)| name == "designs").map(|(_, count)| *count);
    assert_eq!(designs, Some(1.0 + 4.0 + 1024.0 + 1024.0 * 4.0));
}

#[test]
fn many_dimensions_are_taken_by_the_signs_of_their_derivatives() {
    let names: Vec<String> = (0..14).map(|i| format!("d{i}")).collect();
    let lines = names.iter().map(|name| format!("{name} = \"1 mm ± 0.1 mm\"\n")).collect::<String>();
    let parameters = format!("[parameters]\nr = \"50 mm\"\nl = \"200 mm\"\ne = \"10 mm\"\n{lines}");
    let factors = names.iter().enumerate().map(|(i, name)| format!("{} * {name}", i as i32 * 3 - 19));
    let sum = factors.collect::<Vec<_>>().join(" + ").replace("+ -", "- ");
    let study = format!("response = \"{sum}\"\nsamples = 0\n");
    let result = run(&machine("many", &parameters, "60 deg", &study), "scatter");
    let found = found(&result);
    let reach: f64 = (0..14).map(|i| (f64::from(i) * 3.0 - 19.0).abs() * 1e-4).sum();
    let (low, high) = found.worst_case_exact.expect("found");
    near(high - found.nominal, reach, 1e-12);
    near(found.nominal - low, reach, 1e-12);
    assert!(said(&result, "14 dimensions have 2^14 corners"), "{:?}", result.warnings);
    assert!(found.monte_carlo.is_none());
}

#[test]
fn extremes_that_tie_are_told() {
    // Without offset the slider is as fast on its way back; the offset moves the two apart.
    let parameters = "[parameters]\nr = \"50 mm\"\nl = \"200 mm\"\ne = { value = \"0 mm\", sigma = \"0.1 mm\" }\n";
    let study = "response = \"max(abs(joint.slide.velocity))\"\nsamples = 0\n\
                 [studies.round]\nkind = \"kinematics\"\nsweep = { joint = \"crank\", from = \"0 deg\", to = \"360 deg\", \
                 points = 37 }\ndrive = { joint = \"crank\", velocity = \"10 rad/s\" }\n[studies.tied]\nlike = \"scatter\"\n\
                 of = \"round\"\n";
    let result = run(&machine("tied", parameters, "0 deg", study), "tied");
    assert!(said(&result, "two positions have the same extreme here"), "{:?}", result.warnings);
}

/// Stops after so many questions.
struct Impatient(std::cell::Cell<u32>);

impl Progress for Impatient {
    fn at(&mut self, fraction: f64, _message: &str) {
        assert!((0.0..=1.0).contains(&fraction));
    }

    fn cancelled(&self) -> bool {
        self.0.set(self.0.get() - 1);
        self.0.get() == 0
    }
}

#[test]
fn a_study_that_is_stopped_keeps_what_it_has() {
    let study = "response = \"first(joint.slide.position)\"\nsamples = 5000\nsobol = true\n";
    let machine = machine("stopped", SLIDER_CRANK, "20 deg", study);
    let options = RunOptions { threads: 2, ..RunOptions::default() };
    // Once before the study, at eight corners, and at 500 machines.
    let mut progress = Impatient(std::cell::Cell::new(509));
    let run = machine.run_all(&["scatter".to_owned()], &options, &mut progress).expect("runs");
    let result = &run.studies[0];
    let message = &result.failure.as_ref().expect("a failure").message;
    assert!(message.contains("stopped by the user after 500 of 5000 machines"), "{message}");
    assert_eq!(drawn(found(result)).samples, 500);
    assert!(found(result).worst_case_exact.is_some() && found(result).inputs[0].sobol.is_none());
}
