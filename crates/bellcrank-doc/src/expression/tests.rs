//! Exact values, precedence, dimensions, and the reports of what is wrong.

use crate::{
    Diagnostics, Dimension, Expression, NoSignals, ParameterSet, Reader, Response, Signals, Sources, Table, parse,
};

/// A file with some parameters and `x = <value>`, in TOML.
fn file(value: &str) -> String {
    format!(
        "[parameters]\nl5 = \"950 mm\"\na = \"30 deg\"\nm1 = \"2 kg\"\nx_1 = 3\nw = \"10 Hz\"\nz = \"0 mm\"\n[values]\nx = {value}\n"
    )
}

struct Curves;

impl Signals for Curves {
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)> {
        match name {
            "time" => Some((0, Dimension::TIME)),
            "drive.slide.force" => Some((1, Dimension::FORCE)),
            "joint.slide.position" => Some((2, Dimension::LENGTH)),
            "joint.left-knee.position" => Some((3, Dimension::ANGLE)),
            "joint.J.position.0" => Some((4, Dimension::ANGLE)),
            _ => None,
        }
    }

    fn names(&self) -> Vec<String> {
        ["time", "drive.slide.force", "joint.slide.position", "joint.left-knee.position", "joint.J.position.0"]
            .map(String::from)
            .to_vec()
    }
}

/// Reads `x`; what `read` makes of it, its parameters, and the reports as `line:column code message`.
fn with<T>(
    text: &str,
    read: impl Fn(&Reader<'_>, &crate::Value) -> Option<T>,
) -> (Option<T>, ParameterSet, Vec<String>) {
    let mut sources = Sources::new();
    let id = sources.add("x.toml", text);
    let mut diagnostics = Diagnostics::new();
    let tree = parse(&sources, id, &mut diagnostics);
    let table = |name: &str| tree.get(name).and_then(|e| e.value.as_table()).cloned();
    let empty = Table::new(sources.whole(id));
    let parameters = ParameterSet::read(&table("parameters").unwrap_or(empty.clone()), &mut diagnostics);
    let reader = Reader::new(&parameters);
    let result = table("values").and_then(|t| t.get("x").and_then(|e| read(&reader, &e.value)));
    diagnostics.append(reader.finish());
    let _ = diagnostics.render(&sources, true);
    let findings = diagnostics.findings(&sources).into_iter();
    let reports = findings.map(|f| {
        let (line, column) = f.location.map_or((0, 0), |l| (l.line, l.column));
        format!("{line}:{column} {} | {}", f.message, f.hints.join(" | "))
    });
    let reports = reports.collect();
    (result, parameters, reports)
}

fn any(text: &str) -> (f64, Dimension) {
    let (expression, parameters, reports) =
        with(&file(&format!("\"{text}\"")), |r, v| r.any_quantity(v, "`x`", &mut NoSignals));
    let expression: Expression = expression.unwrap_or_else(|| panic!("{text}: {reports:?}"));
    (expression.eval(parameters.values(), &[]), expression.dimension())
}

#[test]
fn values_in_si() {
    let pi = std::f64::consts::PI;
    let cases: &[(&str, f64, &str)] = &[
        ("732 mm", 0.732, "m"),
        ("l5/2 - 50 mm", 0.425, "m"),
        ("-30 deg", -pi / 6.0, "rad"),
        ("1.5e3 N", 1500.0, "N"),
        ("0.5*(l5+l5)", 0.95, "m"),
        ("m1*(l5/2)^2", 2.0 * 0.475 * 0.475, "kg*m^2"),
        ("(pi/6) rad", pi / 6.0, "rad"),
        ("l5/2 mm", 475.0, "1"),
        ("-9.81 m/s^2", -9.81, "m/s^2"),
        ("2 m*l5", 1.9, "m^2"),
        ("2 N*m/rad", 2.0, "N*m/rad"),
        ("3 kg*m^2/(s*rad)", 3.0, "N*m*s/rad"),
        ("10 1/s", 10.0, "Hz"),
        ("10/s", 10.0, "Hz"),
        ("2*mm", 0.002, "m"),
        ("2 s^-2", 2.0, "1/s^2"),
        ("2^3^2", 512.0, "1"),
        ("-2^2", -4.0, "1"),
        ("2^-1", 0.5, "1"),
        ("7-2-1", 4.0, "1"),
        ("16/4/2", 2.0, "1"),
        ("2*3+4", 10.0, "1"),
        ("--2", 2.0, "1"),
        ("20 degC", 293.15, "K"),
        ("-5 degC", 268.15, "K"),
        ("30 degC - 20 degC", 10.0, "K"),
        ("2 in", 0.0508, "m"),
        ("min(3 min, 2 h)", 180.0, "s"),
        ("60 rpm", 2.0 * pi, "rad/s"),
        ("1 psi", 6894.757293168361, "Pa"),
        ("2 L", 0.002, "m^3"),
        ("5mm", 0.005, "m"),
        ("sqrt(4 m^2)", 2.0, "m"),
        ("atan2(1 m, 1 m)", pi / 4.0, "rad"),
        ("sin(a)", 0.5, "1"),
        ("l5*a + l5", 0.95 * pi / 6.0 + 0.95, "m"),
        ("max(1, x_1, 2)", 3.0, "1"),
        ("min(0, l5)", 0.0, "m"),
        ("sign(-2 m)", -1.0, "1"),
        ("abs(-2 m)", 2.0, "m"),
        ("0 + l5", 0.95, "m"),
        ("5 N/(m1*l5)", 5.0 / 1.9, "1/s^2"),
        (".5", 0.5, "1"),
    ];
    for (text, value, unit) in cases {
        let (found, dimension) = any(text);
        assert!((found - value).abs() <= 1e-14 * value.abs(), "{text}: {found} for {value}");
        assert_eq!(dimension.unit(), *unit, "{text}");
    }
}

#[test]
fn faults_with_their_places() {
    // Columns count from the start of `x = "..."`: the text starts in column 6.
    let cases: &[(&str, &str)] = &[
        ("l5 + a", "9:11 adding an angle to a length |"),
        ("732 mmm", "9:10 unknown unit `mmm` | did you mean `mm`?"),
        ("2 Nm", "9:8 unknown unit `Nm` | did you mean `N*m`?"),
        ("2 MM", "9:8 unknown unit `MM` | did you mean `mm`?"),
        ("2 degree", "9:8 unknown unit `degree` | did you mean `deg`?"),
        ("2 mm2", "9:8 unknown unit `mm2` | did you mean `mm^2`?"),
        ("30°", "9:8 `°` has no meaning in an expression | write `deg`"),
        ("l6", "9:6 unknown name `l6` | did you mean `l5`?"),
        ("sine(a)", "9:6 unknown function `sine` | did you mean `sin`?"),
        ("l5(2)", "9:6 unknown function `l5` | for a product write `l5*(...)`"),
        ("sin", "9:6 `sin` is a function | write `sin(...)`"),
        ("sin(l5)", "9:10 `sin` takes an angle, found a length |"),
        ("1/0", "9:6 division by zero |"),
        ("l5/z", "9:6 division by zero |"),
        ("sqrt(-1)", "9:6 the square root of a negative number (-1) |"),
        ("asin(2)", "9:6 the argument is 2; it must lie within -1 and 1 |"),
        ("atan2(1)", "9:6 `atan2` takes 2 values, found 1 |"),
        ("1e200", "9:6 this number is too large to mean anything |"),
        ("1e100*1e100", "9:6 this is 1e200, too large to mean anything |"),
        ("2 +", "9:9 the expression ends here; expected a number, a name or `(` |"),
        ("", "9:6 the expression is empty |"),
        ("(2", "9:8 the expression ends here; expected a number, a name or `(` |"),
        ("2)", "9:7 a `)` without its `(`, or after an operator |"),
        ("3,5 mm", "9:6 a number with a comma | decimals are set off by a point: `3.5`"),
        (
            "l5 mm",
            "9:9 an operator is missing before `mm` | a unit follows a number or `)`; for a product write `* 1 mm`",
        ),
        ("l5^a", "9:9 an exponent is a plain number, found an angle |"),
        ("l5^x_1", "9:9 the exponent of a length must be written as a number |"),
        ("time", "9:6 `time` changes along a run and cannot be used here | only parameters can be used here"),
        ("2 m^2^2", "9:9 a unit with two exponents | set the number and its unit in parentheses: `(2 m^2)^2`"),
        ("(20) degC", "9:11 `degC` needs a number right before it | write `20 degC`, or `K` for a difference"),
        ("l5 <= 2 m", "9:9 `x` is a value, found a comparison |"),
        ("a ** 2", "9:8 `**` is not an operator | a power is written `^`"),
        (
            "max(l5)",
            "9:6 `max` of one value reduces a curve to a number; that has no place here | of several values: `max(a, b)`",
        ),
    ];
    for (text, report) in cases {
        let (_, _, reports) = with(&file(&format!("\"{text}\"")), |r, v| r.any_quantity(v, "`x`", &mut NoSignals));
        assert_eq!(reports.first().map(|r| r.trim_end()), Some(*report), "{text}");
    }
}

#[test]
fn wanted_dimensions() {
    use Dimension as D;
    let cases: &[(&str, Dimension, Option<&str>)] = &[
        ("0", D::LENGTH, None),
        ("\"0\"", D::ANGLE, None),
        ("35", D::LENGTH, Some("9:5 `x` needs a length, found a plain number | write `\"35 mm\"`")),
        ("-35", D::ANGLE, Some("9:5 `x` needs an angle, found a plain number | write `\"-35 deg\"`")),
        (
            "\"w\"",
            D::ANGULAR_VELOCITY,
            Some(
                "9:6 `x` needs an angular velocity, found a frequency | write turning speeds in rpm or rad/s (1 Hz is 60 rpm)",
            ),
        ),
        (
            "\"pi/6\"",
            D::ANGLE,
            Some(
                "9:6 `x` needs an angle, found a plain number | an angle has a unit: `30 deg`, `0.5 rad`, `(pi/6) rad`",
            ),
        ),
        ("\"2 N*m/rad\"", D::MOMENT, None),
        ("\"2 N*m\"", D::TORSIONAL_STIFFNESS, None),
        ("\"m1*l5^2*a/(1 s^2)\"", D::MOMENT, None),
        ("\"l5*a\"", D::LENGTH, None),
        ("nan", D::LENGTH, Some("9:5 `x` needs a finite number, found NaN |")),
        ("inf", D::NONE, Some("9:5 `x` needs a finite number, found inf |")),
        ("1e200", D::NONE, Some("9:5 `x` needs a finite number, found 1e200, too large to mean anything |")),
        (
            "true",
            D::NONE,
            Some(
                "9:5 `x` needs a value, found true or false | a value is a number, or a string as `\"35 mm\"` or `\"l1/2\"`",
            ),
        ),
        ("\"a\\u0020+ l5\"", D::ANGLE, Some("9:5 adding a length to an angle |")),
        ("'''l5\n + a'''", D::LENGTH, Some("10:4 adding an angle to a length |")),
    ];
    for (value, wanted, report) in cases {
        let (_, _, reports) = with(&file(value), |r, v| r.quantity(v, "`x`", *wanted));
        assert_eq!(reports.first().map(|r| r.trim_end()), *report, "{value}");
    }
}

#[test]
fn signals_and_reductions() {
    let read = |text: &str| {
        let (response, parameters, reports) =
            with(&file(&format!("\"{text}\"")), |r, v| r.response(v, "`x`", &mut Curves));
        (response, parameters, reports)
    };
    let (response, parameters, _) = read("2*max(abs(drive.slide.force)) + rms(drive.slide.force)*x_1");
    let response: Response = response.unwrap();
    assert_eq!(response.reductions.len(), 2);
    let curve = &response.reductions[0].curve;
    assert_eq!(curve.eval(parameters.values(), &[0.0, -7.0]), 7.0);
    assert_eq!(response.value.eval(parameters.values(), &[7.0, 5.0]), 29.0);
    assert_eq!(response.value.dimension(), Dimension::FORCE);

    let (_, _, reports) = read("drive.slide.force");
    assert_eq!(reports[0].split(" | ").next(), Some("9:6 `drive.slide.force` is a curve; one number is needed here"));
    let (_, _, reports) = read("max(joint.left-knee.position)");
    assert!(reports[0].contains("joint.'left-knee'.position"), "{reports:?}");
    assert!(read("max(joint.'left-knee'.position)").0.is_some());
    assert!(read("last(joint.J.position.0)").0.is_some());
    assert!(read("max(drive.slid.force)").2[0].contains("did you mean `drive.slide.force`?"));
}

#[test]
fn responses_of_parameters_alone() {
    let (response, parameters, reports) = with(&file("\" l5 + 2*l5\""), |r, v| r.response(v, "`x`", &mut Curves));
    let response = response.unwrap_or_else(|| panic!("{reports:?}"));
    assert_eq!((response.value.eval(parameters.values(), &[]), response.reductions.len()), (0.95 + 1.9, 0));
    assert_eq!((response.written(), response.value.dimension()), (" l5 + 2*l5", Dimension::LENGTH));
    assert_eq!(response.span().end - response.span().start, "l5 + 2*l5".len());
    let (constraint, parameters, reports) =
        with(&file("\"l5 + l5 <= 1 m\""), |r, v| r.constraint(v, "`x`", &mut Curves));
    let constraint = constraint.unwrap_or_else(|| panic!("{reports:?}"));
    assert_eq!(constraint.left.eval(parameters.values(), &[]), 1.9);
    assert_eq!((constraint.written(), constraint.dimension()), ("l5 + l5 <= 1 m", Dimension::LENGTH));
    assert_eq!(constraint.span().end - constraint.span().start, constraint.written().len());
    let (mass, parameters, _) = with(&file("\"m1\""), |r, v| r.response(v, "`x`", &mut Curves));
    assert_eq!(mass.map(|m| m.value.eval(parameters.values(), &[])), Some(2.0));
    let (number, ..) = with(&file("3"), |r, v| r.response(v, "`x`", &mut Curves));
    assert_eq!(number.map(|n| n.value.as_constant()), Some(Some(3.0)));
}

#[test]
fn values_at_a_place() {
    let read = |text: &str| with(&file(&format!("\"{text}\"")), |r, v| r.response(v, "`x`", &mut Curves));
    let (response, parameters, reports) = read("at(abs(drive.slide.force), a/2) - at(drive.slide.force, 0)");
    let response = response.unwrap_or_else(|| panic!("{reports:?}"));
    let [first, second] = response.reductions.as_slice() else { panic!("two reductions") };
    assert_eq!((first.kind, first.kind.name()), (crate::ReductionKind::At, "at"));
    assert_eq!(first.curve.eval(parameters.values(), &[0.0, -7.0]), 7.0);
    let place = first.place.as_ref().unwrap();
    assert_eq!(place.eval::<f64>(parameters.values(), &[]), std::f64::consts::PI / 12.0);
    assert!(first.check_place(Dimension::ANGLE).is_ok() && second.check_place(Dimension::TIME).is_ok());
    let fault = first.check_place(Dimension::TIME).unwrap_err();
    assert_eq!(fault.message, "`at` needs a time here, found an angle");
    assert_eq!(response.value.dimension(), Dimension::FORCE);
    assert_eq!(response.value.eval(&[], &[7.0, 5.0]), 2.0);
    assert!(read("max(drive.slide.force)").0.unwrap().reductions[0].place.is_none());

    let faults = [
        (
            "at(drive.slide.force)",
            "9:6 `at` takes 2 values, found 1 | a curve and a place: `at(drive.slide.force, 15 deg)`",
        ),
        (
            "at(drive.slide.force, time)",
            "9:28 `time` changes along a run and cannot be used here | only parameters can be used here",
        ),
        (
            "at(drive.slide.force, last(time))",
            "9:28 `last` of one value reduces a curve to a number; that has no place here | reductions stand in responses, objectives and limits of studies",
        ),
        ("mean(l5, a)", "9:6 `mean` takes 1 value, found 2 |"),
    ];
    for (text, report) in faults {
        assert_eq!(read(text).2.first().map(|r| r.trim_end()), Some(report), "{text}");
    }
    let (_, _, reports) = with(&file("\"at(l5, a)\""), |r, v| r.any_quantity(v, "`x`", &mut Curves));
    assert!(reports[0].starts_with("9:6 `at` reduces a curve to a number; that has no place here"), "{reports:?}");
    let (_, _, reports) = read("max(drive.slide.force) ± 1 N");
    assert!(reports[0].contains("| a tolerance belongs to a parameter"), "{reports:?}");
    let tolerance =
        with(&file("\"max(drive.slide.force) <= 9 N +/- 1 N\""), |r, v| r.constraint(v, "`x`", &mut Curves));
    assert!(tolerance.2[0].contains("`+/-` sets the tolerance of a parameter"), "{:?}", tolerance.2);
}

#[test]
fn comparisons() {
    let (constraint, parameters, reports) =
        with(&file("\"range(joint.slide.position) <= 200 mm\""), |r, v| r.constraint(v, "`x`", &mut Curves));
    let constraint = constraint.unwrap_or_else(|| panic!("{reports:?}"));
    let left = constraint.left.eval(parameters.values(), &[0.15]);
    let right = constraint.right.eval(parameters.values(), &[0.15]);
    assert!(constraint.comparison.holds(left, right));

    let (condition, _, _) = with(&file("\"time > 2 s\""), |r, v| r.condition(v, "`x`", &mut Curves));
    assert!(condition.is_some_and(|c| c.left.eval(&[], &[3.0]) > c.right.eval(&[], &[3.0])));
    let (_, _, reports) = with(&file("\"time > 2 m\""), |r, v| r.condition(v, "`x`", &mut Curves));
    assert_eq!(reports[0].trim_end(), "9:13 comparing a time with a length |");
}

#[test]
fn deep_and_long_texts_are_refused() {
    let deep = "(".repeat(5000);
    let minus = "-".repeat(5000);
    let chain = "1+".repeat(3000) + "1";
    let powers = "2^".repeat(3000) + "1";
    let units = "1 N/(m*(".repeat(600);
    let long = "1+".repeat(30_000) + "1";
    for text in [deep, minus, chain, powers, units, long] {
        let (result, _, reports) = with(&file(&format!("\"{text}\"")), |r, v| r.any_quantity(v, "`x`", &mut NoSignals));
        assert!(result.is_none() && reports.len() == 1, "{reports:?}");
    }
}

#[test]
fn display_units() {
    let deg = crate::unit("deg").unwrap();
    assert!((deg.from_si(std::f64::consts::PI) - 180.0).abs() < 1e-12);
    assert_eq!(crate::unit("kg*m^2").unwrap().dimension, Dimension::INERTIA);
    assert_eq!(crate::unit("1/s").unwrap().dimension, Dimension::FREQUENCY);
    assert_eq!(crate::unit("degC").unwrap().from_si(273.15), 0.0);
    assert_eq!(crate::unit("Nm").unwrap_err(), "`Nm` is not a unit; did you mean `N*m`?");
    assert!(crate::unit("2 mm").is_err() && crate::unit("").is_err());
}

#[test]
fn every_unit_reads_as_written() {
    for name in crate::unit_names() {
        let (value, dimension) = any(&format!("1 {name}"));
        let unit = crate::unit(name).unwrap();
        assert_eq!((value, dimension), (unit.to_si(1.0), unit.dimension), "{name}");
        assert_eq!(crate::unit(&dimension.unit()).unwrap().dimension, dimension, "{name}");
    }
}
