//! Values, cycles, bounds, overrides.

use crate::{Diagnostics, Dimension, Distribution, Override, ParameterSet, Sources, parse};

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

#[test]
fn tolerances_in_the_value() {
    let same = [
        "\"732 mm ± 0.1 mm\"",
        "\"732 mm +/- 0.1 mm\"",
        "\"732 mm +- 0.1 mm\"",
        "\"732mm+-0.1mm\"",
        "\"732 ± 0.1 mm\"",
        "\"732 +/- .1 mm\"",
        "'732 mm ± w'",
        "\"732 mm \\u00b1 0.1 mm\"",
        "{ value = \"732 mm ± 0.2*w + 80 um\" }",
        "{ value = \"732 mm\", tolerance = \"0.1 mm\" }",
    ];
    for value in same {
        let (set, reports) = read(&format!("w = \"0.1 mm\"\nl3 = {value}\nl4 = \"2*l3\""));
        assert!(reports.is_empty(), "{value}: {reports:?}");
        let l3 = set.get("l3").unwrap();
        assert_eq!((set.values()[1], set.values()[2], l3.tolerance), (0.732, 1.464, Some(1e-4)), "{value}");
        assert_eq!((l3.spread.half_width, l3.spread.sigma, l3.dimension), (Some(1e-4), None, Dimension::LENGTH));
    }
    let (set, _) = read("l3 = \" 732 mm ± 0.1 mm\"\nn = \"3 ± 1\"\nv = \"-5 ± 2 degC\"\nu = \"20 degC ± 2 degC\"");
    let l3 = set.get("l3").unwrap();
    assert_eq!((l3.written.as_str(), l3.expression.written()), (" 732 mm ± 0.1 mm", "732 mm"));
    let found: Vec<_> = set.all().iter().zip(set.values()).map(|(p, v)| (*v, p.tolerance.unwrap())).collect();
    assert_eq!(found, [(0.732, 1e-4), (3.0, 1.0), (268.15, 2.0), (293.15, 2.0)]);
    let units: Vec<_> = set.all().iter().map(|p| p.unit_as_written().unwrap()).collect();
    assert_eq!(units, ["mm", "", "degC", "degC"]);
    // Two signs apart are two signs.
    assert_eq!(read("l3 = \"5 mm + -3 mm\"\nl4 = \"2*+-3 mm\"").0.values(), [0.002, -0.006]);
}

#[test]
fn faulty_tolerances() {
    let belongs = "a tolerance belongs to a parameter: `[parameters] l3 = \"732 mm ± 0.1 mm\"`";
    let cases: &[(&str, &str)] = &[
        ("a = { value = \"1 m ± 1 mm\", tolerance = \"2 mm\" }", "m.toml:1:29 the tolerance of `a` is given twice | "),
        ("a = \"1 m ± 1 deg\"", "m.toml:1:12 the tolerance of `a` needs a length, found an angle | "),
        ("a = \"1 m ± 1\"", "m.toml:1:12 the tolerance of `a` needs a length, found a plain number | write `\"1 mm\"`"),
        ("a = \"1 m ± -1 mm\"", "m.toml:1:12 the tolerance of `a` is negative | it is a width: 0 or more"),
        (
            "a = { value = 3, tolerance = -1 }",
            "m.toml:1:30 the tolerance of `a` is negative | it is a width: 0 or more",
        ),
        ("a = { value = 3, sigma = -1 }", "m.toml:1:26 the `sigma` of `a` is negative | it is a width: 0 or more"),
        (
            "a = \"(1 ± 0.1) m\"",
            &format!("m.toml:1:9 `±` sets the tolerance of a parameter and cannot stand here | {belongs}"),
        ),
        (
            "a = \"1 m ± 1 mm ± 2 mm\"",
            &format!("m.toml:1:17 `±` sets the tolerance of a parameter and cannot stand here | {belongs}"),
        ),
        (
            "a = { value = 1, max = \"2 ± 1\" }",
            &format!("m.toml:1:27 `±` sets the tolerance of a parameter and cannot stand here | {belongs}"),
        ),
        (
            "a = { value = 1, max = \"2 +-1\" }",
            &format!(
                "m.toml:1:27 `+-` sets the tolerance of a parameter and cannot stand here | {belongs} | for a difference write `-`"
            ),
        ),
        ("a = \"1 m ±\"", "m.toml:1:11 the expression ends here; expected a number, a name or `(` | "),
        (
            "a = \"1 m ± 1 %\"",
            "m.toml:1:14 `%` has no meaning in an expression | a part is a plain number: `1 %` of `l1` is `0.01*l1`",
        ),
        ("arm = \"1 m ± amr\"", "m.toml:1:14 unknown name `amr` | did you mean `arm`?"),
        (
            "a = { value = 1, distribution = \"gauss\" }",
            "m.toml:1:33 `distribution` of parameter `a` cannot be `gauss` | known: `uniform`, `normal`, `truncated`",
        ),
        ("a = { value = 1, distribution = 3 }", "m.toml:1:33 `distribution` needs a string, found a number | "),
        (
            "a = { value = 1, distribution = \"uniform\", sigma = 1 }",
            "m.toml:1:44 parameter `a` is uniform and cannot have a `sigma` | a uniform distribution is as wide as the tolerance; `sigma` goes with `normal` and `truncated`",
        ),
    ];
    for (text, wanted) in cases {
        assert_eq!(read(text).1, [*wanted], "{text}");
    }
}

#[test]
fn distributions() {
    let text = "a = { value = \"1 m ± 3 mm\", distribution = \"truncated\", sigma = \"1 mm\" }\nb = { value = \"20 degC\", tolerance = \"2 degC\", distribution = \"normal\" }";
    let (set, reports) = read(text);
    assert!(reports.is_empty(), "{reports:?}");
    let spread = set.all()[0].spread;
    assert_eq!(
        (spread.half_width, spread.sigma, spread.distribution),
        (Some(3e-3), Some(1e-3), Some(Distribution::Truncated))
    );
    let spread = set.all()[1].spread;
    assert_eq!((spread.half_width, spread.sigma, spread.distribution), (Some(2.0), None, Some(Distribution::Normal)));
    assert_eq!(Distribution::Uniform.name(), "uniform");
}

#[test]
fn overrides_of_tolerances() {
    let (set, _) = read("w = \"1 mm\"\nl3 = { value = \"732 mm ± w/10\", sigma = \"50 um\" }");
    let l3 = |argument: &str| {
        let mut sources = Sources::new();
        sources.add("m.toml", "");
        let one = Override::from_argument(&mut sources, argument).unwrap();
        let set = set.with_overrides(&[one]).map_err(|errors| reports(errors, &sources));
        set.map(|(set, _)| (set.values()[1], set.get("l3").unwrap().clone()))
    };
    // A plain value keeps the tolerance, which follows what it is made of.
    let (value, p) = l3("l3=700 mm").unwrap();
    assert_eq!((value, p.tolerance, p.written.as_str()), (0.7, Some(1e-4), "700 mm"));
    assert_eq!(l3("w=2 mm").unwrap().1.tolerance, Some(2e-4));
    let (value, p) = l3("l3 = 700 ± 0.3 mm").unwrap();
    assert_eq!((value, p.tolerance, p.spread.sigma), (0.7, Some(3e-4), Some(5e-5)));
    assert_eq!((p.written.as_str(), p.spread.half_width), (" 700 ± 0.3 mm", Some(3e-4)));
    assert_eq!(
        l3("l3=700 mm ± 1 deg").unwrap_err(),
        ["--set:1:13 the tolerance of `l3` needs a length, found an angle | "]
    );
    assert_eq!(
        l3("l3=700 mm ± -1 mm").unwrap_err()[0],
        "--set:1:13 the tolerance of `l3` is negative | it is a width: 0 or more"
    );
}

#[test]
fn values_into_what_is_there() {
    let (set, _) = read(LIFT);
    let mut values = vec![9.0; 3];
    set.evaluate_into(&[(1, 0.2), (99, 1.0)], &mut values);
    assert_eq!(values, [0.2, 0.2, 19.84, 3.0, 0.101]);
    let place = values.as_ptr();
    set.evaluate_into(&[(1, 0.3), (1, 0.4), (0, 0.1)], &mut values);
    assert_eq!(values, [0.1, 0.4, 19.84, 3.0, 0.1 / 2.0 + 1e-3]);
    assert_eq!(place, values.as_ptr());
    // A value that is given stands, whatever it is.
    set.evaluate_into(&[(3, f64::NAN), (0, f64::NAN)], &mut values);
    assert!(values[3].is_nan() && values[4].is_nan() && values[1] == 0.16);
}

#[test]
fn what_follows_what() {
    let (set, _) = read(LIFT);
    assert_eq!((set.dependents(1), set.dependents(0), set.dependents(4)), (vec![0, 4], vec![4], vec![]));
    assert_eq!((set.dependencies(4), set.dependencies(0), set.dependencies(2)), (vec![0, 1], vec![1], vec![]));
    assert!(set.depends_on(4, 1) && !set.depends_on(1, 4) && !set.depends_on(1, 1));
    assert_eq!((set.dependents(99), set.dependencies(99)), (vec![], vec![]));
}
