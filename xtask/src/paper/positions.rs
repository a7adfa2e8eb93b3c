//! The table at five positions.

use super::figure::cell;
use super::machine::Study;

/// θ3, then θ1 in deg, s2 in mm, ω3, ω1 in rad/s, v41, v42 in m/s, ε3, ε1 in rad/s², a41, a42 in m/s², force without and with
/// masses in N: recomputed from the paper's equations by an independent script.
const TARGETS: [(f64, [&str; 12]); 5] = [
    (
        -30.0,
        [
            "-31.8830",
            "-79.6477",
            "0.147210",
            "0.166280",
            "0.069925",
            "0.121113",
            "-0.015226",
            "-0.022881",
            "-0.025061",
            "-0.002233",
            "4844.52",
            "6473.61",
        ],
    ),
    (
        -15.0,
        [
            "-15.4523",
            "-41.3895",
            "0.129688",
            "0.137693",
            "0.031887",
            "0.119005",
            "-0.004936",
            "-0.009460",
            "-0.016647",
            "-0.000394",
            "4760.22",
            "6341.43",
        ],
    ),
    (
        0.0,
        [
            "0.0000",
            "0.0000",
            "0.125000",
            "0.125000",
            "0.000000",
            "0.118750",
            "0.000000",
            "-0.003415",
            "-0.014844",
            "0.000000",
            "4750.00",
            "6302.10",
        ],
    ),
    (
        15.0,
        [
            "14.5961",
            "41.4303",
            "0.129169",
            "0.122435",
            "-0.031760",
            "0.118529",
            "0.004118",
            "0.000912",
            "-0.016323",
            "-0.000323",
            "4741.16",
            "6268.57",
        ],
    ),
    (
        30.0,
        [
            "28.4878",
            "80.2829",
            "0.142220",
            "0.128858",
            "-0.067555",
            "0.117008",
            "0.009945",
            "0.006167",
            "-0.021365",
            "-0.001425",
            "4680.32",
            "6175.83",
        ],
    ),
];

const NAMES: [&str; 12] = [
    "θ1 [deg]",
    "s2 [mm]",
    "ω3 [rad/s]",
    "ω1 [rad/s]",
    "v41 [m/s]",
    "v42 [m/s]",
    "ε3 [rad/s²]",
    "ε1 [rad/s²]",
    "a41 [m/s²]",
    "a42 [m/s²]",
    "force, no mass [N]",
    "force [N]",
];

/// One line a quantity, one column a position; each cell the computed number and its deviation.
pub(crate) fn table(lift: &Study, massless: &Study, l1: f64) -> Result<String, String> {
    let columns = TARGETS.iter().map(|(angle, _)| values(lift, massless, l1, *angle)).collect::<Result<Vec<_>, _>>()?;
    let mut text = String::from("| at θ3 = | −30° | −15° | 0° | 15° | 30° |\n|---|---|---|---|---|---|\n");
    for (row, name) in NAMES.iter().enumerate() {
        let cells = TARGETS.iter().zip(&columns).map(|((_, targets), values)| cell(targets[row], values[row]));
        text.push_str(&format!("| {name} | {} |\n", cells.collect::<Vec<_>>().join(" | ")));
    }
    Ok(text)
}

fn values(lift: &Study, massless: &Study, l1: f64, angle: f64) -> Result<[f64; 12], String> {
    let at = |signal: &str| lift.at(angle, signal);
    Ok([
        at("joint.O.position")?.to_degrees(),
        1e3 * (at("joint.slide.position")? - l1),
        at("joint.B.velocity")?,
        at("joint.O.velocity")?,
        at("point.link4.K.vx")?,
        at("point.link4.K.vy")?,
        at("joint.B.acceleration")?,
        at("joint.O.acceleration")?,
        at("point.link4.K.ax")?,
        at("point.link4.K.ay")?,
        massless.at(angle, "drive.slide.force")?,
        at("drive.slide.force")?,
    ])
}
