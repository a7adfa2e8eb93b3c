//! Machines let go: what is printed and left, and what is said when it goes wrong.

use serde_json::Value;

use crate::sandbox::Sandbox;
use crate::snapshot;

const BALL: &str = r#"bellcrank = 1
title = "A ball on a floor"
space = "planar"
gravity = [0, "-9.81 m/s^2"]

[ground.points]
O = [0, 0]

[bodies.ball]
mass = "2 kg"
inertia = 0
points = { O = [0, 0] }

[joints]
height = { kind = "prismatic", connects = ["ground.O", "ball.O"], axis = "y", start = "1 m" }

[forces]
floor = { kind = "stop", joint = "height", min = 0, restitution = 0.5 }

[studies.fall]
kind = "dynamics"
duration = "2 s"
stop_when = "time > 1.2 s"
"#;

const PAIR: &str = r#"bellcrank = 1
title = "Two cars on springs"
space = "planar"
gravity = [0, 0]

[ground.points]
O = [0, 0]

[bodies.first]
mass = "2 kg"
inertia = 0
points = { O = [0, 0] }

[bodies.second]
mass = "3 kg"
inertia = 0
points = { O = [0, 0] }

[joints]
a = { kind = "prismatic", connects = ["ground.O", "first.O"], axis = "x" }
b = { kind = "prismatic", connects = ["first.O", "second.O"], axis = "x", start_velocity = "1 m/s" }

[forces]
wall = { kind = "joint-spring", joint = "a", stiffness = "500 N/m" }
link = { kind = "joint-spring", joint = "b", stiffness = "300 N/m", damping = "2 N*s/m" }
"#;

#[test]
fn a_ball_bounces() {
    let sandbox = Sandbox::new("run-bounce");
    sandbox.write("ball.toml", BALL);
    snapshot::check("run-bounce", &sandbox, &["run", "ball.toml"]);
    let events = sandbox.read("results/ball/fall/events.csv");
    assert!(events.starts_with("time [s],event,name,joint,side,speed,speed unit,impulse,impulse unit\n"), "{events}");
    let summary: Value = serde_json::from_str(&sandbox.read("results/ball/fall/summary.json")).unwrap();
    assert_eq!(summary["events"][0]["kind"], "impact");
    assert_eq!(summary["ended"]["by"], "time > 1.2 s");
    assert!(sandbox.read("results/ball/report.html").contains("<h3>Events</h3>"));
}

#[test]
fn two_cars_ring() {
    let sandbox = Sandbox::new("run-modes");
    sandbox.write("pair.toml", format!("{PAIR}\n[studies.ring]\nkind = \"modes\"\n"));
    snapshot::check("run-modes", &sandbox, &["run", "pair.toml"]);
    assert_eq!(sandbox.read("results/pair/ring/modes.csv").lines().count(), 3);
}

/// Each says which study, when, which part, and what to try; the rows until then are kept.
#[test]
fn what_stops_a_machine_that_is_let_go() {
    let sandbox = Sandbox::new("run-stopped");
    let fall = "[studies.fall]\nkind = \"dynamics\"\nduration = \"3 s\"\n";
    let massless = "[bodies.tail]\npoints = { O = [0, 0] }\n\
                    [joints.wag]\nkind = \"revolute\"\nconnects = [\"second.O\", \"tail.O\"]\n";
    let pole = "[forces.pole]\nkind = \"effort\"\njoint = \"a\"\nvalue = \"1 N*s/(2 s - time)\"\n";
    let coupled = "[joints.gear]\nkind = \"coupler\"\njoints = [\"a\", \"b\"]\nratio = 2\n";
    let pair = PAIR.replace("axis = \"x\" }\nb", "axis = \"x\", start_velocity = \"1 m/s\" }\nb");
    for (name, machine, more) in [("massless", PAIR, massless), ("pole", PAIR, pole), ("velocity", &pair, coupled)] {
        sandbox.write(&format!("{name}.toml"), format!("{machine}\n{more}\n{fall}"));
        snapshot::check(&format!("run-{name}"), &sandbox, &["run", &format!("{name}.toml"), "--out", name]);
    }
    let rows = sandbox.read("pole/fall/series.csv").lines().count();
    assert!((300..340).contains(&rows), "{rows}");
}
