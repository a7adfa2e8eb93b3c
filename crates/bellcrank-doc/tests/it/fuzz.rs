//! Whatever is given: no panic, no hang, and every place inside its text.

use bellcrank_doc::{
    Diagnostics, Dimension, Fields, NoSignals, Override, ParameterSet, Reader, Signals, SourceId, Sources, Table,
    Value, ValueKind, load, nearest, parse, rewrite_parameters, unit,
};
use proptest::prelude::*;

use crate::lift::LIFT;

struct Everything;

impl Signals for Everything {
    fn lookup(&mut self, name: &str) -> Option<(usize, Dimension)> {
        name.contains('.').then_some((name.len(), Dimension::LENGTH))
    }

    fn names(&self) -> Vec<String> {
        vec!["joint.slide.position".to_owned()]
    }
}

/// Reads the file in every way there is, and checks all places.
fn read(bytes: &[u8]) {
    let mut sources = Sources::new();
    let mut diagnostics = Diagnostics::new();
    let Some(id) = load(&mut sources, "fuzz.toml", bytes, &mut diagnostics) else {
        return check(&diagnostics, &sources);
    };
    let tree = parse(&sources, id, &mut diagnostics);
    let empty = Table::new(sources.whole(id));
    let table = tree.get("parameters").and_then(|e| e.value.as_table()).unwrap_or(&empty);
    let parameters = ParameterSet::read(table, &mut diagnostics);
    let reader = Reader::new(&parameters);
    read_table(&reader, &tree, &sources);
    let overrides = Override::from_table(table, &mut diagnostics);
    diagnostics.append(match parameters.with_overrides(&overrides) {
        Ok((_, warnings)) => warnings,
        Err(errors) => errors,
    });
    diagnostics.append(reader.finish());
    diagnostics.sort();
    check(&diagnostics, &sources);
    rewrite(&sources, id, &parameters);
}

/// A text that is given back can be read, whatever was asked for.
fn rewrite(sources: &Sources, id: SourceId, parameters: &ParameterSet) {
    for (parameter, value) in parameters.all().iter().zip(parameters.values()).take(1) {
        let other = parameter.value_as_written(value + 1.0, "");
        for new in other.iter().chain([&parameter.written]) {
            let Ok(text) = rewrite_parameters(sources, id, &[(&parameter.name, new)]) else { continue };
            let (mut sources, mut diagnostics) = (Sources::new(), Diagnostics::new());
            let id = sources.add("again", text);
            parse(&sources, id, &mut diagnostics);
            assert!(!diagnostics.has_errors());
        }
    }
}

fn read_table(reader: &Reader<'_>, table: &Table, sources: &Sources) {
    let fields = Fields::new(reader, table, "a table");
    fields.optional_string("title");
    fields.optional_quantity("mass", Dimension::MASS);
    for entry in table.iter() {
        inside(entry.key_span, sources);
        read_value(reader, &entry.value, sources);
    }
    fields.finish();
}

fn read_value(reader: &Reader<'_>, value: &Value, sources: &Sources) {
    inside(value.span, sources);
    let read = reader.any_quantity(value, "a value", &mut Everything);
    if let Some(expression) = read {
        inside(expression.span(), sources);
        let _: f64 = expression.eval(reader.parameters().values(), &[1.0; 40]);
    }
    reader.quantity(value, "a value", Dimension::LENGTH);
    reader.response(value, "a value", &mut Everything);
    reader.constraint(value, "a value", &mut Everything);
    reader.condition(value, "a value", &mut NoSignals);
    reader.one_of(value, "a value", &["revolute"]);
    match &value.kind {
        ValueKind::Table(table) => read_table(reader, table, sources),
        ValueKind::List(values) => values.iter().for_each(|v| read_value(reader, v, sources)),
        _ => {}
    }
}

fn inside(span: bellcrank_doc::Span, sources: &Sources) {
    let text = sources.text(span.source);
    assert!(text.get(span.start..span.end).is_some(), "{span:?} in {} bytes", text.len());
}

fn check(diagnostics: &Diagnostics, sources: &Sources) {
    for diagnostic in diagnostics.iter() {
        assert!(!diagnostic.message.is_empty() && !diagnostic.code.is_empty());
        let labels = diagnostic.primary.iter().map(|l| &**l).chain(&diagnostic.secondary);
        labels.for_each(|label| inside(label.span, sources));
    }
    let shown = diagnostics.render(sources, false);
    assert!(!shown.contains('\x1b') && !shown.contains('\r'));
    assert!(diagnostics.findings(sources).len() <= diagnostics.len());
}

/// What files and expressions are made of, and what they are not.
fn pieces() -> impl Strategy<Value = String> {
    let words = [
        "[",
        "]",
        "[[",
        "]]",
        "{",
        "}",
        "=",
        ",",
        ".",
        "\n",
        "\r\n",
        "\"",
        "'",
        "\"\"\"",
        "'''",
        "#",
        " ",
        "\\",
        "\\u00e9",
        "parameters",
        "[parameters]\n",
        "a",
        "b",
        "l1",
        "joint.'x-y'.p",
        "a.b",
        "mm",
        "m/s^2",
        "degC",
        "min",
        "max(",
        "(",
        ")",
        "+",
        "-",
        "*",
        "/",
        "^",
        "<=",
        "==",
        "1",
        "0",
        "-5",
        "1e300",
        "nan",
        "inf",
        "3.5",
        "3,5",
        "é",
        "°",
        "π",
        "\u{feff}",
        "\u{202e}",
        "\t",
        "true",
        "1979-05-27",
        "value",
        "\u{0}",
        "sqrt(",
        "pi",
        "time",
        "±",
        "+/-",
        "+-",
        " ± 0.1 mm",
        "tolerance",
        "sigma",
        "at(",
        "last(",
    ];
    prop::collection::vec(prop::sample::select(words.to_vec()), 0..60).prop_map(|words| words.concat())
}

/// The lift with a piece of it cut out or put elsewhere, and a word put in.
fn mutations() -> impl Strategy<Value = Vec<u8>> {
    let spot = 0..LIFT.len();
    (prop::collection::vec((spot.clone(), 0..40_usize, pieces(), spot), 1..6)).prop_map(|changes| {
        let mut bytes = LIFT.as_bytes().to_vec();
        for (at, length, word, from) in changes {
            let at = at.min(bytes.len());
            let end = (at + length).min(bytes.len());
            let from = from.min(bytes.len());
            let copied = bytes[from..(from + length).min(bytes.len())].to_vec();
            bytes.splice(at..end, word.bytes().chain(copied));
        }
        bytes
    })
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, ..ProptestConfig::default() })]

    #[test]
    fn any_bytes(bytes in prop::collection::vec(any::<u8>(), 0..300)) {
        read(&bytes);
    }

    #[test]
    fn any_text(text in ".{0,200}") {
        read(text.as_bytes());
    }

    #[test]
    fn words_of_the_format(text in pieces()) {
        read(text.as_bytes());
    }

    #[test]
    fn expressions(text in pieces()) {
        let text = text.replace(['"', '\\', '\n', '\r', '\0'], " ");
        read(format!("[parameters]\na = \"1 m\"\nb = 2\n[v]\nx = \"{text}\"\ny = '''\n{text}'''").as_bytes());
        let _ = unit(&text);
        let _ = Override::from_argument(&mut Sources::new(), &text);
    }

    #[test]
    fn rewritten_lifts(factor in 0.9..1.1_f64, pick in 0..11_usize) {
        let mut sources = Sources::new();
        let mut read = |text: &str| {
            let id = sources.add("lift.toml", text);
            let mut diagnostics = Diagnostics::new();
            let tree = parse(&sources, id, &mut diagnostics);
            let table = tree.get("parameters").and_then(|e| e.value.as_table()).unwrap();
            (sources.clone(), id, ParameterSet::read(table, &mut diagnostics))
        };
        let (before, id, parameters) = read(LIFT);
        let parameter = &parameters.all()[pick];
        let wanted = parameters.values()[pick] * factor;
        let value = parameter.value_as_written(wanted, "mm").unwrap();
        let text = rewrite_parameters(&before, id, &[(&parameter.name, &value)]).unwrap();
        let (_, _, after) = read(&text);
        prop_assert!((after.values()[pick] - wanted).abs() <= wanted * f64::EPSILON, "{value}");
        let lines = LIFT.lines().zip(text.lines());
        prop_assert_eq!(lines.filter(|(a, b)| a != b).count(), 1);
        prop_assert_eq!(LIFT.lines().count(), text.lines().count());
    }

    #[test]
    fn mutated_files(bytes in mutations()) {
        read(&bytes);
    }

    #[test]
    fn nearest_is_a_candidate(name in ".{0,12}", candidates in prop::collection::vec(".{0,12}", 0..8)) {
        if let Some(found) = nearest(&name, candidates.iter().map(String::as_str)) {
            prop_assert!(candidates.iter().any(|c| c == found));
        }
        if candidates.contains(&name) && !name.is_empty() {
            prop_assert!(nearest(&name, candidates.iter().map(String::as_str)).is_some() || name.chars().count() == 1);
        }
    }
}
