//! Values, cycles, bounds, overrides.

use crate::{Diagnostics, Dimension, Override, ParameterSet, Sources, parse};

fn read(text: &str) -> (ParameterSet, Vec<String>) {
    let mut sources = Sources::new();
    let id = sources.add("m.toml", text);
    let mut diagnostics = Diagnostics::new();
    let tree = parse(&sources, id, &mut diagnostics);
    let set = ParameterSet::read(&tree, &mut diagnostics);
    (set, reports(diagnostics, &sources))
}

fn reports(mut diagnostics: Diagnostics, sources: &Sources) -> Vec<String> {
    diagnostics.sort();
    let report = |f: crate::Finding| {
        let (line, column) = f.location.map_or((0, 0), |l| (l.line, l.column));
        format!("{}:{line}:{column} {} | {}", f.file, f.message, f.hints.join(" | "))
    };
    diagnostics.findings(sources).into_iter().map(report).collect()
}

const LIFT: &str = "l61 = \"l32\"
l32 = { value = \"160 mm\", min = \"100 mm\", max = \"200 mm\", note = \"pin\", tolerance = \"0.1 mm\" }
m1 = \"19.84 kg\"
n = 3
half = \"l61/2 + 1 mm\"
";

#[test]
fn values_in_any_order() {
    let (set, reports) = read(LIFT);
    assert!(reports.is_empty(), "{reports:?}");
    assert_eq!(set.values(), [0.16, 0.16, 19.84, 3.0, 0.081]);
    let l32 = set.get("l32").unwrap();
    assert_eq!((l32.min, l32.max, l32.tolerance), (Some(0.1), Some(0.2), Some(1e-4)));
    assert_eq!((l32.note.as_str(), l32.written.as_str(), l32.dimension), ("pin", "160 mm", Dimension::LENGTH));
    let seeded = set.evaluate(&[(1, 0.2)]);
    assert_eq!(seeded, [0.2, 0.2, 19.84, 3.0, 0.101]);
}

#[test]
fn faults() {
    let cases: &[(&str, &[&str])] = &[
        (
            "a = \"b + 1 mm\"\nb = \"c\"\nc = \"2*a\"\nd = \"a\"",
            &[
                "m.toml:1:6 parameters depend on each other in a circle: a -> b -> c -> a | give one of them a value of its own",
            ],
        ),
        ("a = \"a + 1\"", &["m.toml:1:6 `a` is defined by itself | give it a value"]),
        ("arm = \"3 m\"\nb = \"amr\"", &["m.toml:2:6 unknown name `amr` | did you mean `arm`?"]),
        ("mm = 3", &["m.toml:1:1 a parameter cannot be named `mm`: that is a unit | as `mm_1`, say"]),
        ("time = 3", &["m.toml:1:1 a parameter cannot be named `time`: that is a signal | as `time_1`, say"]),
        ("max = 3", &["m.toml:1:1 a parameter cannot be named `max`: that is a function | as `max_1`, say"]),
        ("a = { min = 3 }", &["m.toml:1:5 `value` is missing in parameter `a` | "]),
        (
            "a = [1]",
            &[
                "m.toml:1:5 parameter `a` needs a value, found a list | a value is a number, or a string as `\"35 mm\"` or `\"l1/2\"`",
            ],
        ),
        ("a = { value = 1, min = 2 }", &["m.toml:1:15 `a` is below its lower bound | "]),
        ("a = { value = 1, min = 2, max = 0 }", &["m.toml:1:24 the lower bound of `a` is above its upper bound | "]),
        (
            "a = { value = 1, max = \"2 m\" }",
            &[
                "m.toml:1:25 `max` of parameter `a` needs a plain number, found a length | a number without a unit is a plain number; give it one, as `35 mm`",
            ],
        ),
        // What depends on a faulty one stays silent.
        ("a = \"3 mmm\"\nb = \"a + 1 deg\"", &["m.toml:1:8 unknown unit `mmm` | did you mean `mm`?"]),
        ("a = nan", &["m.toml:1:5 parameter `a` needs a finite number, found NaN | "]),
        ("a = \"1 m\"\nb = \"a + 1 deg\"", &["m.toml:2:10 adding an angle to a length | "]),
    ];
    for (text, wanted) in cases {
        assert_eq!(read(text).1, *wanted, "{text}");
    }
}

#[test]
fn a_mismatch_points_at_both_definitions() {
    let mut sources = Sources::new();
    let id = sources.add("m.toml", "a = \"30 deg\"\nb = \"1 m\"\nc = \"b + a\"\n");
    let mut diagnostics = Diagnostics::new();
    let tree = parse(&sources, id, &mut diagnostics);
    ParameterSet::read(&tree, &mut diagnostics);
    let expected = "\
error: adding an angle to a length
   ┌─ m.toml:3:10
 3 │ c = \"b + a\"
   │          ^ an angle
   │      - a length
   ┌─ m.toml:1:1
 1 │ a = \"30 deg\"
   │ - `a` is an angle, defined here
   ┌─ m.toml:2:1
 2 │ b = \"1 m\"
   │ - `b` is a length, defined here
";
    assert_eq!(diagnostics.render(&sources, false), expected);
}

#[test]
fn a_chain_of_any_length() {
    let chain: String = (0..50_000).map(|i| format!("k{i} = \"k{} + 1\"\n", i + 1)).collect();
    let (set, reports) = read(&format!("{chain}k50000 = 0\n"));
    assert!(reports.is_empty());
    assert_eq!(set.values()[0], 50_000.0);
    let (_, reports) = read(&format!("{chain}k50000 = \"k0\"\n"));
    assert_eq!(reports.len(), 1);
}

#[test]
fn overrides() {
    let (set, _) = read(LIFT);
    let apply = |arguments: &[&str]| {
        let mut sources = Sources::new();
        sources.add("m.toml", LIFT);
        let overrides: Result<Vec<Override>, _> =
            arguments.iter().map(|a| Override::from_argument(&mut sources, a)).collect();
        match overrides.map(|o| set.with_overrides(&o)) {
            Ok(Ok((set, warnings))) => Ok((set.values().to_vec(), reports(warnings, &sources))),
            Ok(Err(errors)) => Err(reports(errors, &sources)),
            Err(error) => Err(reports([error].into_iter().collect(), &sources)),
        }
    };
    assert_eq!(apply(&["m1=0"]), Ok((vec![0.16, 0.16, 0.0, 3.0, 0.081], vec![])));
    assert_eq!(apply(&["l32 = 0.1 m", "m1=n*1 kg"]), Ok((vec![0.1, 0.1, 3.0, 3.0, 0.1 / 2.0 + 1e-3], vec![])));
    let (_, warnings) = apply(&["l32=300 mm"]).unwrap();
    assert_eq!(warnings, ["--set:1:5 `l32` is above its upper bound | "]);
    let errors = [
        ("m1=3 mm", "--set:1:4 `m1` needs a mass, found a length | "),
        ("m2=3 kg", "--set:1:1 no parameter is named `m2` | did you mean `m1`?"),
        ("zebra=3 kg", "--set:1:1 no parameter is named `zebra` | the parameters are `l61`, `l32`, `m1`, `n`, `half`"),
        (
            "l32=l61",
            "--set:1:5 parameters depend on each other in a circle: l61 -> l32 -> l61 | give one of them a value of its own",
        ),
        ("n=1/0", "--set:1:3 division by zero | "),
    ];
    for (argument, wanted) in errors {
        let found = apply(&[argument]).unwrap_err();
        assert!(
            found.iter().any(|r| r == wanted || r.split_once(' ').map(|x| x.1) == wanted.split_once(' ').map(|x| x.1)),
            "{argument}: {found:?}"
        );
    }
    for argument in ["m1", "=3", "m1="] {
        assert!(apply(&[argument]).unwrap_err()[0].contains("expected `NAME=VALUE`"));
    }
    assert!(apply(&["m1=1 kg", "m1=2 kg"]).unwrap_err()[0].contains("`m1` is set twice"));
}
