//! The model file with the values that an optimization found.

use std::path::Path;

use bellcrank_model::{ImproveError, Improved, Model, Silent, load};

use crate::support::{Scratch, model_of};

/// A weight on an arm, held by a motor: the moment is least at the shortest arm, and on target at 400 mm.
const ARM: &str = r#"bellcrank = 1                # comments stay
space = "planar"
gravity = [0, "-10 m/s^2"]
[parameters]
arm   = { value = "0.5 m", min = "20 cm", max = "1 m", note = "ä" }
other = "arm"                # follows
mass  = '2 kg'
third = "0.3333 m"
[bodies.arm]
mass = "mass"
center = ["other", 0]
inertia = 0
points = { O = [0, 0] }
[ground.points]
O = [0, 0]
[joints]
hinge = { kind = "revolute", connects = ["ground.O", "arm.O"] }
[studies.hold]
kind = "inverse-dynamics"
sweep = { joint = "hinge", from = 0, to = "40 deg", points = 5 }
[studies.light]
kind = "optimize"
of = "hold"
minimize = "max(drive.hinge.force)"
variables = ["arm"]
[studies.target]
kind = "optimize"
of = "hold"
minimize = "(max(drive.hinge.force)/(1 N*m) - 7)^2"
variables = { other = { min = "100 mm", max = "2 m" } }
[studies.heavy]
like = "light"
set = { mass = "3 kg", arm = "0.6 m" }
[studies.never]
like = "light"
subject_to = "arm >= 2 m"
"#;

fn improved(model: &Model, study: &str, path: &Path) -> Result<Improved, ImproveError> {
    let result = model.run(study, &mut Silent).expect("a study");
    model.improved(&result, path)
}

fn of(scratch: &Scratch, text: &str, study: &str) -> Improved {
    let path = scratch.write("arm.toml", text);
    improved(&model_of(&path), study, &path).unwrap_or_else(|error| panic!("{error}"))
}

/// The lines of `b` that are not those of `a`.
fn changed<'t>(a: &str, b: &'t str) -> Vec<&'t str> {
    assert_eq!(a.lines().count(), b.lines().count());
    a.lines().zip(b.lines()).filter(|(a, b)| a != b).map(|(_, b)| b).collect()
}

#[test]
fn a_bound_is_written_as_it_reads() {
    let scratch = Scratch::new("improve-bound");
    let found = of(&scratch, ARM, "light");
    assert_eq!(
        changed(ARM, &found.text),
        ["arm   = { value = \"0.2 m\", min = \"20 cm\", max = \"1 m\", note = \"ä\" }"]
    );
    assert!(found.warnings.is_empty(), "{:?}", found.warnings);
}

/// 2 kg · 10 m/s² · 350 mm = 7 N·m; the definition of what followed another is replaced, in the display unit.
#[test]
fn an_inner_optimum_has_few_digits_and_ends_what_followed() {
    let scratch = Scratch::new("improve-inner");
    let found = of(&scratch, ARM, "target");
    let lines = changed(ARM, &found.text);
    assert_eq!(lines.len(), 1, "{lines:?}");
    let value = lines[0].split('"').nth(1).expect("a value");
    assert!(lines[0].ends_with("\"                # follows"), "{}", lines[0]);
    let number: f64 = value.strip_suffix(" mm").expect("mm").parse().expect("a number");
    assert!((number - 350.0).abs() < 1e-4, "{value}");
    assert!(value.len() <= "349.999999999 mm".len(), "{value}");
}

#[test]
fn marks_and_line_ends_stay() {
    let scratch = Scratch::new("improve-bytes");
    let text = format!("\u{feff}{}", ARM.replace('\n', "\r\n"));
    let found = of(&scratch, &text, "light");
    assert_eq!(found.text, text.replacen("0.5 m", "0.2 m", 1));
}

#[test]
fn what_the_optimum_rests_on_is_told() {
    let scratch = Scratch::new("improve-set");
    let found = of(&scratch, ARM, "heavy");
    assert_eq!(changed(ARM, &found.text).len(), 1);
    let [first, second] = found.warnings.as_slice() else { panic!("{:?}", found.warnings) };
    assert!(first.contains("`arm`") && first.contains("`heavy`"), "{first}");
    assert!(second.contains("`mass`") && second.contains("keeps the old value"), "{second}");

    let path = scratch.write("arm.toml", ARM);
    let settings = [("arm", "700 mm"), ("mass", "5 kg")].map(|(name, value)| (name.to_owned(), value.to_owned()));
    let model = load(&path, &settings).model.expect("a model");
    let found = improved(&model, "light", &path).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(found.text, ARM.replacen("0.5 m", "0.2 m", 1));
    assert!(found.warnings.len() == 1 && found.warnings[0].contains("`mass`"), "{:?}", found.warnings);
}

#[test]
fn nothing_is_written_where_nothing_was_found() {
    let scratch = Scratch::new("improve-never");
    let path = scratch.write("arm.toml", ARM);
    let model = model_of(&path);
    for (study, status) in [("never", "infeasible"), ("hold", "")] {
        match improved(&model, study, &path) {
            Err(ImproveError::NoDesign { study: named, status: found }) => {
                assert_eq!((named.as_str(), found.as_str()), (study, status))
            }
            other => panic!("{other:?}"),
        }
    }
}
