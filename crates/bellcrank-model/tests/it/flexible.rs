//! Flexible bodies from the file to the rows.

use bellcrank_model::Model;
use bellcrank_results::Findings;

use crate::support::{model, run};

/// A cantilever along [0.6, 0.8] that a force across it and one along it act on; `BODY` says how it is made.
fn cantilever(body: &str) -> Model {
    let text = format!(
        r#"
bellcrank = 1
space = "planar"
gravity = [0, 0]
[parameters]
thick = "9 mm"
push = "100 N"
[ground.points]
O = ["30 mm", "-20 mm"]
[bodies.arm]
points = {{ A = ["-12 mm", "7 mm"], B = ["288 mm", "407 mm"] }}
{body}
[joints]
fixed = {{ kind = "weld", connects = ["ground.O", "arm.A"] }}
[forces]
end = {{ kind = "force", on = "arm.B", vector = ["-0.8*push", "0.6*push"] }}
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = 0.3
[beams.bar]
material = "steel"
between = ["A", "B"]
width = "thick"
height = "16 mm"
[solids.bar]
material = "steel"
thickness = "thick"
[solids.bar.plates]
bar = {{ outline = [["-18.4 mm", "11.8 mm"], ["-5.6 mm", "2.2 mm"], ["294.4 mm", "402.2 mm"], ["281.6 mm", "411.8 mm"]] }}
[solids.link]
material = "steel"
thickness = "thick"
eyes = {{ A = {{ bore = "9 mm", outer = "24 mm" }}, B = {{ bore = "9 mm", outer = "24 mm" }} }}
webs = {{ w = {{ between = ["A", "B"], width = "16 mm" }} }}
[studies.rest]
kind = "statics"
[studies.rigid]
like = "rest"
flexible = false
[studies.by]
kind = "sensitivity"
of = "rest"
response = "last(point.arm.B.x)"
parameters = ["thick", "push"]
points = 0
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

/// A deflection is in proportion to the load, and to one over the thickness across it: exactly for a beam, by differences for
/// a solid that is meshed anew.
#[test]
fn deflections_have_derivatives() {
    let bodies = [
        ("beam = \"bar\"\nflexible = { segments = 2, interfaces = [\"A\", \"B\"], stiffening = false }", 5e-3, 0),
        ("solid = \"link\"\nflexible = { interfaces = [\"A\", \"B\"], modes = 0 }", 2e-2, 1),
    ];
    for (body, slack, warnings) in bodies {
        let of = cantilever(body);
        let moved = place(&of, "rest")[0] - place(&of, "rigid")[0];
        let result = run(&of, "by");
        assert!(result.failure.is_none(), "{:?}", result.failure);
        let Some(Findings::Sensitivity(found)) = &result.findings else { panic!("{:?}", result.findings) };
        let [thick, push] = [0, 1].map(|place| found.parameters[place].derivative);
        assert!((thick * 0.009 / -moved - 1.0).abs() < slack, "{thick} {moved}");
        assert!((push * 100.0 / moved - 1.0).abs() < slack, "{push} {moved}");
        assert_eq!(result.warnings.len(), warnings, "{:?}", result.warnings);
    }
}
