use std::path::Path;

use bellcrank_multibody::{BodyId, Coordinate, Engine, JointId, JointKind};

use crate::build::{self, Built};
use crate::design::{Design, Values};
use crate::{Model, flex};

/// A slider-crank whose rod is a link with three eyes; a spring takes hold of the third.
pub(super) fn planar(of_rod: &str) -> Model {
    let text = format!(
        r#"
bellcrank = 1
space = "planar"
gravity = ["1.3 m/s^2", "-9.81 m/s^2"]
[ground.points]
O = ["11 mm", "-7 mm"]
G = {{ at = ["50 mm", "-23 mm"], rotate = {{ angle = "4 deg" }} }}
S = ["170 mm", "210 mm"]
[bodies.crank]
mass = "0.4 kg"
inertia = "3e-4 kg*m^2"
points = {{ O = ["2 mm", "-3 mm"], A = ["61 mm", "13 mm"] }}
[bodies.rod]
solid = "rod"
flexible = {of_rod}
points = {{ A = ["-21 mm", "17 mm"], B = ["182 mm", "-9 mm"], E = ["71 mm", "44 mm"], T = {{ at = ["182 mm", "-9 mm"], rotate = {{ angle = "31 deg" }} }}, M = ["90 mm", "5 mm"] }}
[bodies.slider]
mass = "0.7 kg"
inertia = "1e-4 kg*m^2"
points = {{ B = [0, 0] }}
[joints]
O = {{ kind = "revolute", connects = ["ground.O", "crank.O"], start = "37 deg" }}
A = {{ kind = "revolute", connects = ["crank.A", "rod.A"] }}
B = {{ kind = "revolute", connects = ["rod.T", "slider.B"] }}
slide = {{ kind = "prismatic", connects = ["ground.G", "slider.B"], axis = "x", start = "200 mm" }}
[forces.s]
kind = "spring"
between = ["ground.S", "rod.E"]
stiffness = "700 N/m"
free_length = "90 mm"
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = 0.3
[solids.rod]
material = "steel"
thickness = "9 mm"
[solids.rod.eyes]
A = {{ bore = "14 mm", outer = "30 mm" }}
B = {{ bore = "11 mm", outer = "26 mm" }}
E = {{ bore = "8 mm", outer = "20 mm" }}
[solids.rod.webs]
w = {{ between = ["A", "B"], width = "15 mm" }}
v = {{ between = ["A", "E"], width = "12 mm" }}
"#
    );
    let loaded = crate::load::load_text(Path::new("slider-crank.toml"), &text, &[]);
    let told = loaded.diagnostics.findings(&loaded.sources);
    loaded.model.unwrap_or_else(|| panic!("{told:?}"))
}

pub(super) fn spatial() -> Model {
    let text = r#"
bellcrank = 1
space = "spatial"
gravity = ["1.3 m/s^2", "0.4 m/s^2", "-9.81 m/s^2"]
[ground.points]
O = { at = ["11 mm", "-7 mm", "20 mm"], rpy = ["10 deg", "-20 deg", "35 deg"] }
[bodies.arm]
solid = "arm"
flexible = { reference = "B", modes = 3 }
points = { A = ["-21 mm", "17 mm", 0], B = { at = ["182 mm", "-9 mm", 0], rpy = ["-15 deg", "25 deg", "5 deg"] }, E = ["71 mm", "44 mm", 0] }
[bodies.hand]
mass = "0.7 kg"
inertia = ["1e-4 kg*m^2", "2e-4 kg*m^2", "2.5e-4 kg*m^2"]
points = { H = { at = ["5 mm", "-9 mm", "12 mm"], rpy = ["7 deg", "-9 deg", "50 deg"] }, T = ["50 mm", "20 mm", "-30 mm"] }
[bodies.finger]
mass = "0.1 kg"
inertia = ["1e-5 kg*m^2", "2e-5 kg*m^2", "2.5e-5 kg*m^2"]
points = { H = ["3 mm", "-4 mm", "6 mm"] }
[joints]
O = { kind = "revolute", connects = ["ground.O", "arm.A"], axis = [0.3, -0.2, 0.9], start = "37 deg" }
B = { kind = "revolute", connects = ["arm.B", "hand.H"], axis = [0.5, 0.4, -0.3], start = "-20 deg" }
E = { kind = "revolute", connects = ["arm.E", "finger.H"], axis = [-0.5, 0.4, 0.3], start = "12 deg" }
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = 0.3
[solids.arm]
material = "steel"
thickness = "9 mm"
[solids.arm.eyes]
A = { bore = "14 mm", outer = "30 mm" }
B = { bore = "11 mm", outer = "26 mm" }
E = { bore = "8 mm", outer = "20 mm" }
[solids.arm.webs]
w = { between = ["A", "B"], width = "15 mm" }
v = { between = ["A", "E"], width = "12 mm" }
"#;
    let loaded = crate::load::load_text(Path::new("arm.toml"), text, &[]);
    let told = loaded.diagnostics.findings(&loaded.sources);
    loaded.model.unwrap_or_else(|| panic!("{told:?}"))
}

pub(super) fn built(design: &Design, flexible: bool) -> Built {
    let values: Values = Values::new(&design.scopes, &design.scopes[0].parameters);
    let mut built = build::build(design, &values, &mut Vec::new()).expect("a machine");
    if flexible {
        flex::deform(design, &values, &values, &mut built).expect("a reduction");
    }
    built
}

fn assembled(design: &Design, built: &Built) -> Box<dyn Engine> {
    let mut engine = build::engine(design, built).expect("a mechanism");
    let start = |index: usize| built.blueprint.joints[index].start.first().copied().flatten();
    let held = (0..design.joints.len()).filter_map(|joint| {
        let c = Coordinate { joint: JointId(joint), index: 0 };
        start(joint).filter(|_| design.joints[joint].name != "slide").map(|at| (c, at))
    });
    engine.assemble(&held.collect::<Vec<_>>()).expect("a machine that closes");
    engine
}

/// With its shape held, a flexible machine is where the rigid one is, whatever takes hold of its interfaces.
#[test]
fn an_undeformed_machine_is_the_rigid_one() {
    for model in [planar("{ modes = 3, interfaces = [\"B\", \"A\", \"E\"] }"), spatial()] {
        let design = model.design();
        let [rigid, flexible] = [false, true].map(|flexible| built(design, flexible));
        let [a, b] = [&rigid, &flexible].map(|built| assembled(design, built));
        for (body, points) in rigid.geometry.points.iter().enumerate() {
            for (point, place) in points.iter().enumerate() {
                let moved = &flexible.geometry.points[body][point];
                let (at, there) = (a.point(place.body, place.position), b.point(moved.body, moved.position));
                let apart = (0..3).map(|i| (at.position[i] - there.position[i]).abs()).fold(0.0, f64::max);
                assert!(apart < 1e-12, "{} {}: {apart}", design.bodies[body].name, points.len());
            }
        }
        for joint in 0..design.joints.len() {
            let c = Coordinate { joint: JointId(joint), index: 0 };
            assert!((a.coordinate(c).position - b.coordinate(c).position).abs() < 1e-11);
        }
    }
}

#[test]
fn what_is_at_an_interface_is_on_its_body() {
    let model = planar("{ modes = 3, interfaces = [\"B\", \"A\", \"E\"] }");
    let design = model.design();
    let built = built(design, true);
    let deforming = &built.flexible[0];
    // Ground, three bodies, two interfaces beside the reference B, modes.
    assert_eq!(built.blueprint.bodies.len(), 4 + 3);
    assert_eq!((deforming.coordinates.len(), deforming.modes), (2 * 3 + 3, 3));
    let of = |point: &str| {
        let point = design.bodies[2].points.iter().position(|one| one.name == point).expect("a point");
        &built.geometry.points[2][point]
    };
    assert_eq!([of("A"), of("E"), of("B"), of("T"), of("M")].map(|place| place.body.0), [4, 5, 2, 2, 2]);
    assert_eq!(of("A").position, [0.0; 3]);
    let kinds = built.blueprint.joints[design.joints.len()..].iter();
    let elastic = kinds.filter(|joint| matches!(joint.kind, JointKind::Elastic)).count();
    assert_eq!(elastic, 2);
    let joint = built.blueprint.joints[1].places.as_ref().expect("two places");
    assert_eq!(joint[1].body, BodyId(4));
    assert_eq!(built.blueprint.bodies[2].mass.to_bits(), 0);
}

/// Mass, centre and inertia of the shapes are those of the solid that the rigid body has them from.
#[test]
fn the_shapes_have_the_mass_of_the_solid() {
    let model = spatial();
    let design = model.design();
    let [rigid, flexible] = [false, true].map(|flexible| built(design, flexible));
    let (body, inertia) = (&rigid.blueprint.bodies[1], &flexible.blueprint.flexible[0].inertia);
    assert!((inertia.mass / body.mass - 1.0).abs() < 1e-4, "{} {}", inertia.mass, body.mass);
    let centre = inertia.first.map(|x| x / inertia.mass);
    assert!((0..3).all(|i| (centre[i] - body.center[i]).abs() < 1e-5), "{centre:?} {:?}", body.center);
    let c = body.center;
    let zz = inertia.second[0][0] + inertia.second[1][1] - inertia.mass * (c[0] * c[0] + c[1] * c[1]);
    assert!((zz / body.inertia[2][2] - 1.0).abs() < 1e-3, "{zz} {}", body.inertia[2][2]);
}

fn rods() -> Model {
    let text = r#"
bellcrank = 1
space = "spatial"
gravity = ["1.3 m/s^2", "0.4 m/s^2", "-9.81 m/s^2"]
[ground.points]
O = { at = ["11 mm", "-7 mm", "20 mm"], rpy = ["10 deg", "-20 deg", "35 deg"] }
S = ["0.2 m", "0.3 m", "0.5 m"]
[bodies.arm]
beam = "bar"
flexible = { segments = 4, modes = 2, reference = "B" }
points = { A = ["-21 mm", "17 mm", "33 mm"], B = { at = ["379 mm", "-83 mm", "233 mm"], rpy = ["-15 deg", "25 deg", "5 deg"] }, M = ["99 mm", "-13 mm", "93 mm"] }
[bodies.hand]
beam = "rod"
points = { H = { at = ["5 mm", "-9 mm", "12 mm"], rpy = ["7 deg", "-9 deg", "50 deg"] }, T = ["50 mm", "20 mm", "-30 mm"] }
[joints]
O = { kind = "revolute", connects = ["ground.O", "arm.A"], axis = [0.3, -0.2, 0.9], start = "37 deg" }
B = { kind = "revolute", connects = ["arm.B", "hand.H"], axis = [0.5, 0.4, -0.3], start = "-20 deg" }
[forces.s]
kind = "spring"
between = ["ground.S", "arm.M"]
stiffness = "700 N/m"
free_length = "90 mm"
[materials.steel]
density = "7850 kg/m^3"
young = "210 GPa"
poisson = 0.3
[beams.bar]
material = "steel"
between = ["A", "B"]
width = "9 mm"
height = "23 mm"
up = [0.2, 0.9, 0.4]
[beams.rod]
material = "steel"
between = ["T", "H"]
tube = ["14 mm", "2 mm"]
"#;
    let loaded = crate::load::load_text(Path::new("rods.toml"), text, &[]);
    let told = loaded.diagnostics.findings(&loaded.sources);
    loaded.model.unwrap_or_else(|| panic!("{told:?}"))
}

#[test]
fn a_chain_of_segments_is_where_the_rigid_beam_is() {
    let model = rods();
    let design = model.design();
    let [rigid, flexible] = [false, true].map(|flexible| built(design, flexible));
    // The spring is at 30 %: one part before it, three behind.
    assert_eq!(flexible.flexible.len(), 4);
    let [a, b] = [&rigid, &flexible].map(|built| assembled(design, built));
    for (body, points) in rigid.geometry.points.iter().enumerate() {
        for (place, moved) in points.iter().zip(&flexible.geometry.points[body]) {
            let (at, there) = (a.point(place.body, place.position), b.point(moved.body, moved.position));
            let apart = (0..3).map(|i| (at.position[i] - there.position[i]).abs()).fold(0.0, f64::max);
            assert!(apart < 1e-12, "{}: {apart}", design.bodies[body].name);
        }
    }
    let of = |point: usize| flexible.geometry.points[1][point].body;
    assert_eq!(of(1), BodyId(1), "the frame goes with the reference");
    assert!(of(0) != of(2) && of(0).0 >= design.bodies.len() && of(2).0 >= design.bodies.len());
}

/// Momentum and moment of momentum of the chain as a rigid body are those of the bar: a block of the same sides.
#[test]
fn a_beam_has_the_mass_of_its_bar() {
    let model = rods();
    let design = model.design();
    let [rigid, flexible] = [false, true].map(|flexible| built(design, flexible));
    let body = &rigid.blueprint.bodies[1];
    let length = (0.4_f64.powi(2) + 0.1_f64.powi(2) + 0.2_f64.powi(2)).sqrt();
    let mass = 7850.0 * 0.009 * 0.023 * length;
    assert!((body.mass / mass - 1.0).abs() < 1e-12);
    // Principal moments of a block.
    let squares = [length * length, 0.023_f64.powi(2), 0.009_f64.powi(2)];
    let mut expected: Vec<f64> = (0..3).map(|i| mass * (squares[(i + 1) % 3] + squares[(i + 2) % 3]) / 12.0).collect();
    let tensor: Vec<Vec<f64>> = body.inertia.iter().map(|row| row.to_vec()).collect();
    let (mut moments, _) = bellcrank_math::linalg::dense::symmetric_eigen(&tensor).expect("moments");
    expected.sort_by(f64::total_cmp);
    moments.sort_by(f64::total_cmp);
    assert!(expected.iter().zip(&moments).all(|(a, b)| (a / b - 1.0).abs() < 1e-10), "{expected:?} {moments:?}");
    let all: f64 = flexible.blueprint.flexible.iter().map(|piece| piece.inertia.mass).sum();
    assert!((all / mass - 1.0).abs() < 1e-12);
}
