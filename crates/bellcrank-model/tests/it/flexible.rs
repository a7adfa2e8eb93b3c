//! Flexible bodies from the file to the rows.

use bellcrank_model::Model;

use crate::support::{model, run};

/// A cantilever along [0.6, 0.8] that a force across it and one along it act on; `BODY` says how it is made.
fn cantilever(body: &str) -> Model {
    let text = format!(
        r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]
[ground.points]
O = ["30 mm", "-20 mm"]
[bodies.arm]
points = {{ A = ["-12 mm", "7 mm"], B = ["288 mm", "407 mm"] }}
{body}
[joints]
fixed = {{ kind = "weld", connects = ["ground.O", "arm.A"] }}
[forces]
end = {{ kind = "force", on = "arm.B", vector = ["-80 N", "60 N"] }}
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = 0.3
[beams.bar]
material = "steel"
between = ["A", "B"]
width = "9 mm"
height = "16 mm"
[solids.bar]
material = "steel"
thickness = "9 mm"
[solids.bar.plates]
bar = {{ outline = [["-18.4 mm", "11.8 mm"], ["-5.6 mm", "2.2 mm"], ["294.4 mm", "402.2 mm"], ["281.6 mm", "411.8 mm"]] }}
[studies.rest]
kind = "statics"
[studies.rigid]
like = "rest"
flexible = false
"#
    );
    model("cantilever", &text)
}

fn place(model: &Model, study: &str) -> [f64; 2] {
    let result = run(model, study);
    assert!(result.failure.is_none(), "{:?}", result.failure);
    ["x", "y"].map(|axis| {
        let name = format!("point.arm.B.{axis}");
        let column = result.table.columns.iter().find(|column| column.name == name);
        column.unwrap_or_else(|| panic!("no {name}")).values[0]
    })
}

/// F L³/(3 E I) and F L/(G A κ) for a force of 100 N across it.
#[test]
fn a_loaded_beam_bends_as_its_formula_says() {
    let (length, force, young): (f64, f64, f64) = (0.5, 100.0, 210e9);
    let (area, second) = (0.009 * 0.016, 0.009 * 0.016_f64.powi(3) / 12.0);
    let kappa = 10.0 * 1.3 / (12.0 + 11.0 * 0.3);
    let expected = force * length.powi(3) / (3.0 * young * second) + force * length * 2.6 / (young * area * kappa);
    for segments in [1, 3] {
        let of =
            cantilever(&format!("beam = \"bar\"\nflexible = {{ segments = {segments}, interfaces = [\"A\", \"B\"] }}"));
        let ([x, y], [x0, y0]) = (place(&of, "rest"), place(&of, "rigid"));
        let across = -0.8 * (x - x0) + 0.6 * (y - y0);
        // Small against the length: large deflections differ from the formula by its square.
        let slack = 2.0 * (expected / length).powi(2);
        assert!((across / expected - 1.0).abs() < slack, "{segments}: {across} {expected}");
    }
}

/// The same bar as a solid, held and loaded by the faces nearest to the middles of its ends, which reach round the corners:
/// some millimetres of five hundred do not bend.
#[test]
fn a_loaded_solid_bends_as_the_beam() {
    let solid = cantilever("solid = \"bar\"\nflexible = { interfaces = [\"B\", \"A\"], modes = 0, reference = \"A\" }");
    let beam = cantilever("beam = \"bar\"\nflexible = { interfaces = [\"A\", \"B\"] }");
    let across = |of: &Model| {
        let ([x, y], [x0, y0]) = (place(of, "rest"), place(of, "rigid"));
        -0.8 * (x - x0) + 0.6 * (y - y0)
    };
    let [solid, beam] = [&solid, &beam].map(across);
    assert!(solid < beam && solid > 0.95 * beam, "{solid} {beam}");
}
