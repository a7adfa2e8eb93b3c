//! A model with a parameter wherever a number may stand. It need not work as a machine.

use std::fmt::Write;

use crate::Model;

/// `{1.3 kg}` is a parameter of its own with this value.
const TEXT: &str = r#"
bellcrank = 1
space = "spatial"
gravity = ["{0.3 m/s^2}", "{-0.2 m/s^2}", "{-9.7 m/s^2}"]

[ground.points]
O = ["{0.11 m}", "{0.12 m}", "{-0.13 m}"]
T = { at = [0, 0, "{0.2 m}"], rotate = { axis = ["{0.3}", "{-0.5}", "{0.7}"], angle = "{25 deg}" } }
Q = { at = ["{0.5 m}", 0, 0], quaternion = ["{0.8}", "{0.3}", "{-0.4}", "{0.2}"] }
R = { at = [0, "{0.4 m}", 0], rpy = ["{10 deg}", "{-20 deg}", "{35 deg}"] }

[bodies.a]
mass = "{2.5 kg}"
center = ["{30 mm}", "{-20 mm}", "{10 mm}"]
inertia = ["{0.031 kg*m^2}", "{0.025 kg*m^2}", "{0.04 kg*m^2}", "{0.003 kg*m^2}", "{-0.002 kg*m^2}", "{0.001 kg*m^2}"]
points = { o = [0, 0, 0], p = ["{0.3 m}*cos({20 deg})", "sqrt({0.04 m^2})", "max({0.1 m}, {0.09 m})*{2}^{1.5}"] }

[bodies.b]
mass = "{1.5 kg}"
inertia = ["{0.01 kg*m^2}", "{0.02 kg*m^2}", "{0.025 kg*m^2}"]
points = { o = [0, 0, 0], p = ["{0.25 m}", 0, 0] }

[bodies.c]
points = { o = [0, 0, 0], p = ["{0.22 m}", 0, 0] }

[joints]
revolute = { kind = "revolute", connects = ["ground.O", "a.o"], axis = ["{0.1}", "{0.2}", "{0.9}"], start = "{5 deg}" }
cylindrical = { kind = "cylindrical", connects = ["a.p", "b.o"], axis = "x", start = ["{30 mm}", "{7 deg}"] }
screw = { kind = "screw", connects = ["b.p", "c.o"], axis = "z", pitch = "{4 mm}" }
universal = { kind = "universal", connects = ["ground.T", "c.p"], axis = ["{0.6}", 0, 0], axis2 = [0, "{0.7}", 0] }
held = { kind = "distance", connects = ["ground.Q", "b.p"], length = "{0.9 m}" }
line = { kind = "point-on-line", connects = ["ground.R", "c.o"], axis = ["{0.2}", "{0.3}", 1] }
slide = { kind = "prismatic", connects = ["ground.R", "b.o"], axis = ["{0.2}", "{-0.3}", 1] }
mesh = { kind = "coupler", joints = ["revolute", "screw"], ratio = "{-2.2}", offset = "{3 deg}" }

[forces]
force = { kind = "force", on = "a.p", vector = ["{7 N}", "{-8 N}", "{9 N}"] }
torque = { kind = "torque", on = "b", vector = ["{0.7 N*m}", "{-0.8 N*m}", "{0.9 N*m}"], axes = "body" }
effort = { kind = "effort", joint = "screw", value = "{0.35 N*m}" }
spring = { kind = "spring", between = ["ground.O", "a.p"], stiffness = "{700 N/m}", damping = "{3 N*s/m}", free_length = "{0.2 m}", preload = "{12 N}" }
coil = { kind = "joint-spring", joint = "revolute", stiffness = "{70 N*m/rad}", damping = "{0.3 N*m*s/rad}", free_position = "{11 deg}", preload = "{1.2 N*m}" }
rub = { kind = "friction", joint = "revolute", coulomb = "{0.1}", static = "{0.15}", stribeck_velocity = "{0.2 rad/s}", viscous = "{0.02 N*m*s/rad}", radius = "{20 mm}" }
stop = { kind = "stop", joint = "slide", min = "{-0.3 m}", max = "{0.4 m}", stiffness = "{1e5 N/m}", damping = "{100 N*s/m}" }
mount = { kind = "bushing", between = ["ground.T", "a.p"], stiffness = ["{100 N/m}", "{110 N/m}", "{120 N/m}", "{13 N*m/rad}", "{14 N*m/rad}", "{15 N*m/rad}"], damping = ["{1 N*s/m}", "{2 N*s/m}", "{3 N*s/m}", "{0.4 N*m*s/rad}", "{0.5 N*m*s/rad}", "{0.6 N*m*s/rad}"] }
waves = { kind = "force", on = "b.p", vector = ["{3 N}*sin(time*{4 rad/s})", "-{5 N*s/m}*joint.slide.velocity", "{60 N/m}*(force.spring.length - point.a.p.x)"] }
drag = { kind = "effort", joint = "revolute", value = "-{0.2 N*m*s^2/rad^2}*body.a.omega_z*abs(joint.revolute.velocity) + {0.1 N*m}*body.c.yaw" }
damper = { kind = "spring", between = ["ground.Q", "c.p"], damping = "{2 N*s/m} + {1 N*s^2/m^2}*force.spring.rate" }

[motions.cycloidal]
joint = "revolute"
segments = [{ to = "{40 deg}", over = "{0.31 s}" }, { hold = "{0.12 s}", name = "pause" }, { to = "{-9 deg}", over = "{0.53 s}" }]

[motions.others]
joint = "screw"
segments = [
    { to = "{1 rad}", over = "{0.23 s}", profile = "poly5" },
    { to = "{2 rad}", over = "{0.19 s}", profile = "trapezoid" },
    { to = "{-1 rad}", over = "{0.27 s}", profile = "s-curve" },
    { to = "{3 rad}", over = "{0.25 s}", profile = "linear" },
]

[motions.formula]
joint = "cylindrical"
expression = [
    "{0.2 m}*sin({3 rad/s}*time)*({1.3})^(time/{1.1 s}) + sqrt({2 m^2} + {4 m^2/s^2}*time^2)",
    "atan2({2 m/s}*time, {3 m}) + asin({0.4 1/s}*time)*acos({0.3 1/s}*time)/(1 rad) + tan(time/{2 s})*atan(time/{3 s})*(time/{1.7 s})^{2.5}",
]

[motions.rate]
joint = "slide"
velocity = "{0.3 m/s}"

[motions.table]
joint = "line"
table = "table.csv"
start = "with cycloidal.pause"
delay = "{-0.05 s}*{0.9}"

[motions.after]
joint = "slide"
start = "after cycloidal.pause"
delay = "{0.03 s}"
segments = [{ by = "{0.3 m}", over = "{0.41 s}" }, { by = "{-0.1 m}", over = "{0.33 s}" }]

[motions.fixed]
joint = "slide"
start = "{0.07 s}"
velocity = "{0.3 m/s}"

[materials.steel]
density = "{7850 kg/m^3}"

[solids.link]
material = "steel"
thickness = "{20 mm}"
plane = "zx"
[solids.link.eyes]
A = { bore = "{31 mm}", outer = "{71 mm}", width = "{33 mm}", offset = "{4 mm}", clearance = "{83 mm}" }
B = { bore = "{22 mm}", outer = "{52 mm}", layers = [["{-18 mm}", "{-7 mm}"], ["{8 mm}", "{17 mm}"]] }
C = { at = ["{110 mm}", "{120 mm}"], bore = "{11 mm}", outer = "{41 mm}" }
[solids.link.webs]
box = { kind = "box", between = ["A", "B"], width = ["{44 mm}", "{33 mm}"], height = "{24 mm}", wall = "{5 mm}", skin = "{3 mm}" }
beam = { kind = "i", between = ["A", "C"], width = "{37 mm}", flange = "{8 mm}", web = "{6 mm}" }
hull = { kind = "hull", between = ["B", "C"], thickness = "{9 mm}", offset = "{-12 mm}" }
[solids.link.plates.tab]
thickness = "{12 mm}"
outline = [["{107 mm}", "{119 mm}"], { at = ["{150 mm}", "{121 mm}"], radius = "{4 mm}" }, ["{148 mm}", "{170 mm}"], { at = ["{105 mm}", "{168 mm}"], radius = "{7 mm}" }]
[solids.link.cuts]
hole = { kind = "hole", at = ["{127 mm}", "{155 mm}"], diameter = "{13 mm}", thickness = "{7 mm}", offset = "{1 mm}" }
slot = { kind = "slot", from = ["{125 mm}", "{3 mm}"], to = ["{171 mm}", "{-2 mm}"], width = "{9 mm}" }
notch = { kind = "outline", outline = [["{128 mm}", "{142 mm}"], ["{139 mm}", "{141 mm}"], { at = ["{138 mm}", "{134 mm}"], radius = "{1 mm}" }] }

[bodies.d]
points = { A = ["{3 mm}", 0, "{-2 mm}"], B = ["{13 mm}", "{1 mm}", "{290 mm}"] }
solid = "link"

[solids.bar]
material = "steel"
thickness = "{20 mm}"
fillet = "{7 mm}"
[solids.bar.eyes]
A = { bore = "{31 mm}", outer = "{71 mm}" }
B = { bore = "{22 mm}", outer = "{52 mm}" }
[solids.bar.webs]
flat = { between = ["A", "B"], width = ["{44 mm}", "{33 mm}"] }

[bodies.f]
points = { A = ["{3 mm}", "{2 mm}", 0], B = ["{213 mm}", "{11 mm}", 0] }
solid = "bar"

[solids.pin]
material = "steel"
revolved = { at = ["{5 mm}", "{6 mm}", "{7 mm}"], axis = ["{0.3}", "{0.4}", "{0.5}"], profile = [[0, "{1 mm}"], ["{8 mm}", "{2 mm}"], ["{9 mm}", "{30 mm}"], [0, "{31 mm}"]] }

[bodies.e]
solid = "pin"

[subsystems.arm]
file = "arm.toml"
ground = "a.p"
set = { length = "{0.4 m} + {0.05 m}^2/{0.06 m}" }
"#;

const ARM: &str = r#"
bellcrank = 1
space = "spatial"
gravity = [0, 0, "-9.81 m/s^2"]

[parameters]
length = "300 mm"
half = "length/2"

[ground.points]
O = { at = ["half", 0, 0], rpy = [0, "length*(1 rad/m)", 0] }

[bodies.arm]
mass = "2 kg"
center = ["half", 0, 0]
inertia = [0, "(2 kg)*length^2/12", "(2 kg)*length^2/12"]
points = { O = [0, 0, 0] }

[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"] }
"#;

const TABLE: &str = "0,0.1\n0.3,0.25\n0.5,0.2\n0.8,0.4\n1.3,0.35\n";

pub(super) fn model() -> Model {
    let folder = std::env::temp_dir().join(format!("bellcrank-derivatives-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a scratch folder");
    let path = folder.join("everything.toml");
    for (name, text) in [("everything.toml", text().as_str()), ("arm.toml", ARM), ("table.csv", TABLE)] {
        std::fs::write(folder.join(name), text).expect("a scratch file");
    }
    let model = super::loaded(&path);
    let _ = std::fs::remove_dir_all(&folder);
    model
}

/// The text with its parameters named and defined.
fn text() -> String {
    let mut pieces = TEXT.split('{');
    let mut text = pieces.next().unwrap_or_default().to_owned();
    let mut parameters = "[parameters]\n".to_owned();
    let mut count = 0;
    for piece in pieces {
        match piece.split_once('}') {
            // A table of TOML: its braces have space inside.
            Some((value, rest)) if !value.starts_with(' ') && !piece.starts_with('\n') => {
                let _ = writeln!(parameters, "p{count} = \"{value}\"");
                let _ = write!(text, "p{count}{rest}");
                count += 1;
            }
            _ => text += &format!("{{{piece}"),
        }
    }
    text + "\n" + &parameters
}
