//! Where the paper errs, with the program's numbers as witnesses.

use super::figure::signed;
use super::machine::{Study, rewritten};
use super::questions::value;
use bellcrank_results::ParameterRow;

const ANGLES: [f64; 5] = [-30.0, -15.0, 0.0, 15.0, 30.0];

/// Lengths and the state of the lift in one position, in the paper's symbols.
struct State {
    l31: f64,
    l32: f64,
    length: f64,
    theta3: f64,
    theta1: f64,
    w3: f64,
    w1: f64,
    e3: f64,
    e1: f64,
    v2: f64,
}

impl State {
    fn at(lift: &Study, parameters: &[ParameterRow], angle: f64) -> Result<Self, String> {
        let of = |signal: &str| lift.at(angle, signal);
        Ok(Self {
            l31: value(parameters, "l31")?,
            l32: value(parameters, "l32")?,
            length: of("joint.slide.position")?,
            theta3: of("joint.B.position")?,
            theta1: of("joint.O.position")?,
            w3: of("joint.B.velocity")?,
            w1: of("joint.O.velocity")?,
            e3: of("joint.B.acceleration")?,
            e1: of("joint.O.acceleration")?,
            v2: of("joint.slide.velocity")?,
        })
    }

    /// First row of the matrix of formulas 2 and 3 times (x3, x1).
    fn first_row(&self, x3: f64, x1: f64) -> f64 {
        let lever = self.l32 * self.theta3.cos() - self.l31 * self.theta3.sin();
        lever * x3 + self.length * self.theta1.sin() * x1
    }

    /// First row of formula 3 on the right, as printed.
    fn printed_acceleration(&self) -> f64 {
        (self.l32 * self.theta3.sin() + self.l31 * self.theta3.cos()) * self.w3.powi(2)
            - self.length * self.theta1.cos() * self.w1.powi(2)
    }

    fn coriolis(&self) -> f64 {
        -2.0 * self.v2 * self.w1 * self.theta1.sin()
    }
}

fn states(lift: &Study, parameters: &[ParameterRow]) -> Result<Vec<State>, String> {
    ANGLES.iter().map(|&angle| State::at(lift, parameters, angle)).collect()
}

fn row(name: &str, numbers: impl Iterator<Item = f64>) -> String {
    let cells: Vec<String> = numbers.map(|number| signed(number, 6)).collect();
    format!("| {name} | {} |\n", cells.join(" | "))
}

const HEADING: &str = "\n| | −30° | −15° | 0° | 15° | 30° |\n|---|---|---|---|---|---|\n";

/// The section on the paper's errors.
pub(crate) fn section(lift: &Study, massless: &Study, parameters: &[ParameterRow]) -> Result<String, String> {
    let states = states(lift, parameters)?;
    let parts = [
        formula_2(&states),
        formula_3(&states),
        percentage(lift, massless)?,
        stress(lift)?,
        inertia(lift)?,
        inertia_forces(lift)?,
    ];
    Ok(parts.concat())
}

fn formula_2(states: &[State]) -> String {
    let mut text = String::from(
        "### 1. Formula 2, first row: the sign of v2 cos θ1\n\nDifferentiating formula 1b gives \
         (l32 cos θ3 − l31 sin θ3) ω3 + (s2 + l1) sin θ1 ω1 = **+**v2 cos θ1; the paper prints −v2 cos θ1. \
         With the computed velocities, in m/s:\n",
    );
    text.push_str(HEADING);
    text.push_str(&row("left side", states.iter().map(|s| s.first_row(s.w3, s.w1))));
    text.push_str(&row("+v2 cos θ1", states.iter().map(|s| s.v2 * s.theta1.cos())));
    text.push_str(&row("as printed", states.iter().map(|s| -s.v2 * s.theta1.cos())));
    text
}

fn formula_3(states: &[State]) -> String {
    let mut text = String::from(
        "\n### 2. Formula 3, first row: the Coriolis term is missing\n\nDifferentiating again gives on the right side \
         the further term −2 v2 ω1 sin θ1. With the computed velocities and accelerations, in m/s²:\n",
    );
    text.push_str(HEADING);
    text.push_str(&row("left side", states.iter().map(|s| s.first_row(s.e3, s.e1))));
    text.push_str(&row("with the term", states.iter().map(|s| s.printed_acceleration() + s.coriolis())));
    text.push_str(&row("as printed", states.iter().map(State::printed_acceleration)));
    text
}

fn percentage(lift: &Study, massless: &Study) -> Result<String, String> {
    let (with, without) = (lift.peak()?.0, massless.peak()?.0);
    Ok(format!(
        "\n### 3. \"25.2 % higher\"\n\n{with:.1} N is {:.1} % above {without:.1} N; {:.1} % is the difference as a share of the \
         larger figure.\n",
        1e2 * (with / without - 1.0),
        1e2 * (1.0 - without / with),
    ))
}

/// Peak of the paper's rigid–flexible simulation, N.
const FLEXIBLE_PEAK: f64 = 7214.0;

fn stress(lift: &Study) -> Result<String, String> {
    let rigid = lift.peak()?.0;
    Ok(format!(
        "\n### 4. Where the stress is\n\nSection 4 puts the largest stress on link 3, the conclusion on \"the joint of link 4\". The \
         {FLEXIBLE_PEAK} N and about 150 MPa of the rigid–flexible simulation depend on solids that the paper does not give; this \
         page has no number to set beside them. (\"10 % deviation\": {FLEXIBLE_PEAK} N is {:.1} % above {rigid:.1} N.)\n",
        1e2 * (FLEXIBLE_PEAK / rigid - 1.0)
    ))
}

/// The inertia expressions of the model, and the same for uniform bars: a third.
const BARS: [(&str, &str); 3] = [
    ("m1*(l1/2)^2", "m1*(l1/2)^2/3"),
    ("m3*(l5/2 - 50 mm)^2", "m3*(l5/2 - 50 mm)^2/3"),
    ("m5*(l5/2)^2", "m5*(l5/2)^2/3"),
];

fn inertia(lift: &Study) -> Result<String, String> {
    let change = largest_change(lift, &rewritten("lift", &BARS)?)?;
    Ok(format!(
        "\n### 5. J = m·c² is the inertia of a point mass\n\nA uniform bar has m·c²/3 about its centre, c being half its length. \
         At 20 mm/s it hardly matters: the lift run again with m·c²/3 changes the drive force by at most {change:.1} N.\n"
    ))
}

fn inertia_forces(lift: &Study) -> Result<String, String> {
    let still = rewritten("lift", &[("velocity = \"20 mm/s\"", "velocity = \"0 mm/s\"")])?;
    Ok(format!(
        "\n## Inertia forces\n\nAt most {:.1} N of the drive force (2.8 N recomputed): the lift run again at rest.\n",
        largest_change(lift, &still)?
    ))
}

fn largest_change(one: &Study, other: &Study) -> Result<f64, String> {
    let forces = |study: &Study| study.column("drive.slide.force").map(<[f64]>::to_vec);
    let pairs = forces(one)?.into_iter().zip(forces(other)?);
    Ok(pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max))
}
