//! Stress and natural frequencies of bodies, from text to findings.

use bellcrank_results::{Findings, HotSpot, StressBody, StudyResult};

use crate::support::{model, run, value};

const MATERIAL: &str = r#"
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = POISSON
yield = "355 MPa"
expansion = "12e-6 1/K"
"#;

/// A model of one body that nothing is joined to.
fn part(name: &str, poisson: f64, rest: &str) -> bellcrank_model::Model {
    let head = "bellcrank = 1\nspace = \"planar\"\ngravity = [0, 0]\n";
    let material = MATERIAL.replace("POISSON", &poisson.to_string());
    model(name, &format!("{head}{material}\n[bodies.part]\nsolid = \"part\"\n{rest}"))
}

fn body(result: &StudyResult) -> &StressBody {
    assert!(result.failure.is_none(), "{:?}", result.failure);
    match &result.findings {
        Some(Findings::Stress(found)) => &found.bodies[0],
        other => panic!("{other:?}"),
    }
}

fn spot<'r>(body: &'r StressBody, region: &str) -> &'r HotSpot {
    let found = body.spots.iter().find(|spot| spot.region.starts_with(region) && spot.singular.is_none());
    found.unwrap_or_else(|| panic!("no {region} among {:?}", body.spots))
}

/// Source: `F6_hole` of the verification cases, d/W = 0.2: 3.1525666 times the stress far away. Without lateral
/// contraction a plate of any thickness is in plane stress.
#[test]
fn the_stress_at_a_hole_is_within_its_error() {
    let strip = part(
        "strip",
        0.0,
        r#"
[solids.part]
material = "steel"
[solids.part.plates.body]
thickness = "8 mm"
outline = [["-300 mm", "-50 mm"], ["300 mm", "-50 mm"], ["300 mm", "50 mm"], ["-300 mm", "50 mm"]]
[solids.part.cuts.middle]
kind = "hole"
at = [0, 0]
diameter = "20 mm"
[studies.tension]
kind = "stress"
body = "part"
stress = { accuracy = "2 %" }
mesh = { layers = 1 }
[studies.tension.supports.root]
set = "xmin"
coupling = "distributing"
[studies.tension.loads.end]
set = "xmax"
traction = ["50 MPa", 0]
[studies.coarse]
like = "tension"
mesh = { layers = 1, size = "40 mm", fillets = "5 mm" }
"#,
    );
    let exact = 3.152_566_648_217_520_8 * 50e6;
    for study in ["tension", "coarse"] {
        let result = run(&strip, study);
        let found = body(&result);
        assert_eq!(found.reached, Some(true), "{study}: {:?}", found.meshes);
        let hole = spot(found, "hole at [0, 0] mm");
        assert!(hole.relative_error() <= 0.02, "{study}: {}", hole.relative_error());
        assert!((hole.value - exact).abs() <= hole.error.max(1e-3 * exact), "{study}: {hole:?}");
        // On the transverse diameter.
        assert!(
            hole.at[0].abs() < 1e-3 && (hole.at[0].hypot(hole.at[1]) - 0.01).abs() < 1e-9,
            "{study}: {:?}",
            hole.at
        );
        assert!((found.mass[0] / found.mass[1] - 1.0).abs() < 1e-5);
    }
}

/// Source: Lamé; plane stress: sigma_t = p (ro^2 + ri^2) / (ro^2 - ri^2), sigma_r = -p at the bore.
#[test]
fn a_ring_under_pressure_is_that_of_lame() {
    let ring = part(
        "ring",
        0.3,
        r#"
[solids.part]
material = "steel"
thickness = "10 mm"
[solids.part.eyes.A]
at = ["40 mm", "-30 mm"]
bore = "60 mm"
outer = "110 mm"
[studies.pressed]
kind = "stress"
body = "part"
[studies.pressed.supports.middle]
set = "A"
coupling = "distributing"
[studies.pressed.loads.oil]
set = "bore.A"
pressure = "30 MPa"
[studies.finer]
like = "pressed"
stress = { accuracy = "2 %" }
"#,
    );
    for study in ["pressed", "finer"] {
        ring_is_that_of_lame(spot(body(&run(&ring, study)), "bore A"));
    }
}

fn ring_is_that_of_lame(bore: &HotSpot) {
    let (inner, outer, p) = (30.0_f64.powi(2), 55.0_f64.powi(2), 30e6);
    let hoop = p * (outer + inner) / (outer - inner);
    let mises = (hoop * hoop + hoop * p + p * p).sqrt();
    assert!((bore.value - mises).abs() <= bore.error.max(5e-3 * mises), "{} {mises} {}", bore.value, bore.error);
    assert!(
        (bore.principal[0] / hoop - 1.0).abs() < (2.0 * bore.relative_error()).max(5e-3),
        "{} {hoop}",
        bore.principal[0]
    );
}

/// Source: Euler and Bernoulli, free at both ends: f = k^2 / (2 pi L^2) sqrt(E I / (rho A)), k = 4.73004, 7.85320; shear
/// and rotary inertia take less than 1 % and 2 % of them here.
#[test]
fn a_free_bar_rings_as_a_beam() {
    let bar = part(
        "bar",
        0.3,
        r#"
[solids.part]
material = "steel"
[solids.part.plates.body]
thickness = "10 mm"
outline = [[0, 0], ["600 mm", 0], ["600 mm", "15 mm"], [0, "15 mm"]]
[studies.shapes]
kind = "modes"
body = "part"
modes = 4
mesh = { size = "10 mm", layers = 1 }
[studies.clamped]
like = "shapes"
fixed = ["xmin"]
modes = 2
"#,
    );
    let wave = |h: f64| (210e9 * h * h / 12.0 / 7850.0_f64).sqrt() / (std::f64::consts::TAU * 0.36);
    let Some(Findings::BodyModes(free)) = run(&bar, "shapes").findings else { panic!("no modes") };
    let free = &free.bodies[0];
    assert_eq!(free.rigid, 6);
    let expected = [4.730_04, 4.730_04, 7.853_2, 7.853_2];
    for ((found, k), h) in free.frequencies.iter().zip(expected).zip([0.010, 0.015, 0.010, 0.015]) {
        let theory = k * k * wave(h);
        let off = found / theory - 1.0;
        assert!((-0.02..0.002).contains(&off), "{found} Hz, {theory} Hz");
    }
    let Some(Findings::BodyModes(held)) = run(&bar, "clamped").findings else { panic!("no modes") };
    let held = &held.bodies[0];
    assert_eq!(held.rigid, 0);
    for (found, h) in held.frequencies.iter().zip([0.010, 0.015]) {
        let off = found / (1.875_104 * 1.875_104 * wave(h)) - 1.0;
        assert!(off.abs() < 0.01, "{off}");
    }
}

/// A four-bar linkage whose coupler is a link with a pin off its plane, turned fast.
fn linkage(seed: usize, studies: &str) -> bellcrank_model::Model {
    let pick = |k: usize, low: f64, high: f64| {
        let x = ((seed * 7 + k) as f64 * 12.9898).sin() * 43758.5453;
        low + (high - low) * (x - x.floor())
    };
    let (crank, coupler, rocker) = (pick(1, 60.0, 90.0), pick(2, 280.0, 320.0), pick(3, 180.0, 240.0));
    let (px, py) = (pick(4, 100.0, 200.0), pick(5, 60.0, 90.0));
    let material = MATERIAL.replace("POISSON", "0.3");
    model(
        &format!("linkage-{seed}"),
        &format!(
            r#"
bellcrank = 1
space = "planar"
gravity = ["1.3 m/s^2", "-9.7 m/s^2"]
{material}
[solids.rod]
material = "steel"
thickness = "12 mm"
fillet = "10 mm"
[solids.rod.eyes]
A = {{ bore = "20 mm", outer = "44 mm" }}
B = {{ bore = "24 mm", outer = "50 mm" }}
P = {{ bore = "16 mm", outer = "36 mm" }}
[solids.rod.webs]
main = {{ between = ["A", "B"], width = ["36 mm", "30 mm"] }}
lug = {{ kind = "hull", between = ["A", "B", "P"], thickness = "8 mm" }}
[ground.points]
O = [0, 0]
Q = ["300 mm", "20 mm"]
[bodies.crank]
mass = "1.2 kg"
inertia = "0.01 kg*m^2"
center = ["{c} mm", "3 mm"]
points = {{ O = [0, 0], A = ["{crank} mm", 0] }}
[bodies.coupler]
solid = "rod"
points = {{ A = ["17 mm", "-11 mm"], B = ["17 mm + {coupler} mm", "5 mm"], P = ["{px} mm", "{py} mm"] }}
[bodies.rocker]
mass = "2 kg"
inertia = "0.02 kg*m^2"
points = {{ Q = [0, 0], B = ["{rocker} mm", 0] }}
[joints]
O = {{ kind = "revolute", connects = ["ground.O", "crank.O"], start = "40 deg" }}
A = {{ kind = "revolute", connects = ["crank.A", "coupler.A"] }}
B = {{ kind = "revolute", connects = ["rocker.B", "coupler.B"] }}
Q = {{ kind = "revolute", connects = ["ground.Q", "rocker.Q"], start = "100 deg" }}
[forces]
pull = {{ kind = "force", on = "coupler.P", vector = ["-400 N", "650 N"] }}
spring = {{ kind = "spring", between = ["ground.O", "coupler.P"], stiffness = "2 N/mm", free_length = "50 mm" }}
[studies.turn]
kind = "inverse-dynamics"
sweep = {{ joint = "O", from = "40 deg", to = "160 deg", points = 13 }}
drive = {{ joint = "O", velocity = "20 rad/s", acceleration = "90 rad/s^2" }}
{studies}
"#,
            c = crank / 2.0
        ),
    )
}

const STRESS: &str = r#"
[studies.strength]
kind = "stress"
body = "coupler"
of = "turn"
mesh = { size = "25 mm", bores = "8 mm", fillets = "8 mm", layers = 1 }
[studies.each]
like = "strength"
at = "all"
[studies.row]
like = "strength"
at = 7
hinges = "distributing"
[studies.rigid]
like = "strength"
at = { "joint.O.position" = "111 deg" }
hinges = "rigid"
"#;

#[test]
fn the_loads_of_a_machine_are_in_balance() {
    for seed in 0..3 {
        let linkage = linkage(seed, STRESS);
        for study in ["strength", "row", "rigid"] {
            let result = run(&linkage, study);
            let found = body(&result);
            let unbalance = found.unbalance.expect("a body that floats");
            assert!(unbalance < 1e-4, "{seed} {study}: {unbalance}");
            assert!(found.residual < 1e-7, "{seed} {study}: {}", found.residual);
        }
        let nearest = run(&linkage, "rigid");
        assert_eq!(body(&nearest).place, "joint.O.position = 110 deg");
    }
}

/// The curve over the stroke is by superposition: at any row it is what a solution of that row gives.
#[test]
fn superposition_is_what_a_solution_of_the_row_gives() {
    let linkage = linkage(5, STRESS);
    let curve = run(&linkage, "strength");
    let row = run(&linkage, "row");
    for (region, key) in [("bore A", "bore.A"), ("bore B", "bore.B"), ("bore P", "bore.P")] {
        let direct = spot(body(&row), region).value;
        let summed = value(&curve, &format!("stress.coupler.{key}"), 7);
        assert!((summed / direct - 1.0).abs() < 1e-6, "{region}: {summed} {direct}");
    }
    let peaks = |result: &StudyResult| {
        let columns = result.table.columns.iter().filter(|column| column.name.starts_with("stress."));
        columns.flat_map(|column| column.values.clone()).fold(0.0, f64::max)
    };
    // The worst of all rows is the one that is solved.
    let worst = body(&curve);
    let of_row = worst.place.strip_prefix("joint.O.position = ").and_then(|rest| rest.strip_suffix(" deg"));
    let angle: f64 = of_row.and_then(|text| text.parse().ok()).expect("an angle");
    let index = ((angle - 40.0) / 10.0).round() as usize;
    let at_row = curve.table.columns.iter().filter(|column| column.name.starts_with("stress."));
    let largest = at_row.map(|column| column.values[index]).fold(0.0, f64::max);
    assert_eq!(largest, peaks(&curve));
    // Each spot at its own worst is at least what it is at the worst of all.
    let each = run(&linkage, "each");
    for found in worst.spots.iter().filter(|spot| spot.singular.is_none()) {
        let own = spot(body(&each), &found.region);
        assert!(own.value >= found.value * (1.0 - 1e-9), "{}: {} {}", found.region, own.value, found.value);
    }
}

#[test]
fn what_cannot_be_solved_says_why() {
    let studies = |held: &str| {
        format!(
            r#"
[solids.part]
material = "steel"
thickness = "10 mm"
[solids.part.eyes.A]
at = [0, 0]
bore = "20 mm"
outer = "50 mm"
[solids.part.eyes.B]
at = ["200 mm", 0]
bore = "20 mm"
outer = "50 mm"
[solids.part.webs.bar]
between = ["A", "B"]
width = "30 mm"
[studies.pull]
kind = "stress"
body = "part"
mesh = {{ size = "20 mm", bores = "6 mm", layers = 1 }}
{held}
[studies.pull.loads.end]
set = "B"
force = ["1 kN", 0, 0]
"#
        )
    };
    let failure = |name: &str, held: &str| {
        let result = run(&part(name, 0.3, &studies(held)), "pull");
        result.failure.map(|failure| failure.message).unwrap_or_default()
    };
    let line = "[studies.pull.supports.root]\nset = \"A\"\nspring = [\"1 N/mm\", \"1 N/mm\", 0]\n";
    let found = failure("free-line", line);
    assert_eq!(found, "study `pull`: body `part` is not held: it is free to move along z");
    let none = failure("free-all", "");
    assert!(none.contains("free to turn about an axis along z through [100, 0, 0] mm"), "{none}");
    let twice = "[studies.pull.supports.a]\nset = \"A\"\ncoupling = \"rigid\"\n[studies.pull.supports.b]\nset = \"A\"\nfixed = [\"x\"]\n";
    let found = failure("held-twice", twice);
    assert!(found.contains("support `a` of body `part` holds a node rigidly that a support holds as well"), "{found}");
}
