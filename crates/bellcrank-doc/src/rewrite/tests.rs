//! What changes, what stays, and what is refused.

use crate::{RewriteError, Sources, rewrite_parameters};

fn rewritten(text: &str, changes: &[(&str, &str)]) -> Result<String, RewriteError> {
    let mut sources = Sources::new();
    let id = sources.add("m.toml", text);
    rewrite_parameters(&sources, id, changes)
}

const LAYOUT: &str = "# head\r\nbellcrank = 1\r\n\r\n[parameters] # all of them\r\n\
    n   = 3          # a count\r\n\
    l5  = { min = \"800 mm\", value = \"950 mm\" , max='1000 mm' }# arm\r\n\
    l32 = '160 mm'\r\n\
    \"l61\"=\"l32\"\r\n\
    l3 = \"732 mm ±  0.1 mm\"   # ±\r\n\
    l4 = \"732 ± 0.1 mm\"\r\n\
    l7 = \"\"\"\r\n   l32/2\r\n   + 5 mm\r\n\"\"\"\r\n\
    l8 = '''l5'''\r\n\
    r.value = \"2 N*m/rad\"\r\n\
    r.note = \"1 \\\"rate\\\"\"\r\n\
    q = { value = 2.50 }\r\n\
    [parameters.m1]\r\nvalue = \"19.84 kg\" # kg\r\n\
    tolerance = \"0.1 kg\"\r\n\
    [bodies.b]\r\nmass = \"m1\"\r\nl5 = \"950 mm\"";

#[test]
fn only_the_values_change() {
    let cases: &[(&str, &str, &str, &str)] = &[
        ("n", "4", "n   = 3 ", "n   = 4 "),
        ("n", ".5", "n   = 3 ", "n   = \".5\" "),
        ("n", "2*q", "n   = 3 ", "n   = \"2*q\" "),
        ("n", " 1e-9 ", "n   = 3 ", "n   = 1e-9 "),
        ("q", "-7.25", "2.50", "-7.25"),
        ("l5", "0.9 m", "value = \"950 mm\" ,", "value = \"0.9 m\" ,"),
        ("l32", "150 mm", "'160 mm'", "'150 mm'"),
        ("l61", "120 mm", "\"l61\"=\"l32\"", "\"l61\"=\"120 mm\""),
        ("l61", "l32 + 1 mm", "\"l61\"=\"l32\"", "\"l61\"=\"l32 + 1 mm\""),
        ("l3", "731.5 mm", "732 mm ±  ", "731.5 mm ±  "),
        ("l3", "731 mm +/- 0.2 mm", "732 mm ±  0.1 mm", "731 mm +/- 0.2 mm"),
        ("l3", "l5 - 1 cm", "732 mm ±  ", "l5 - 1 cm ±  "),
        ("l4", "700 mm", "732 ± 0.1", "700 mm ± 0.1"),
        ("l4", "0", "732 ± 0.1", "0 mm ± 0.1"),
        ("l7", "l32", "l32/2\r\n   + 5 mm", "l32"),
        ("l8", "2*l5", "'''l5'''", "'''2*l5'''"),
        ("r", "3 N*m/rad", "\"2 N*m/rad\"", "\"3 N*m/rad\""),
        ("m1", "0", "\"19.84 kg\"", "\"0 kg\""),
        ("m1", "20 kg", "\"19.84 kg\"", "\"20 kg\""),
    ];
    for (name, value, from, to) in cases {
        assert_eq!(LAYOUT.matches(from).count(), 1, "{from}");
        let text = rewritten(LAYOUT, &[(name, value)]).unwrap_or_else(|e| panic!("{name} {value}: {e}"));
        assert_eq!(text, LAYOUT.replacen(from, to, 1), "{name} = {value}");
    }
    let several = rewritten(LAYOUT, &[("m1", "2 kg"), ("n", "5"), ("l32", "l5/2")]).unwrap();
    let expected = LAYOUT.replace("19.84 kg", "2 kg").replace("n   = 3", "n   = 5").replace("'160 mm'", "'l5/2'");
    assert_eq!(several, expected);
    assert_eq!(rewritten(LAYOUT, &[]).unwrap(), LAYOUT);
}

#[test]
fn keys_of_every_kind() {
    let cases = [
        ("parameters.l5 = \"1 m\"\nbellcrank = 1", "parameters.l5 = \"2 m\"\nbellcrank = 1"),
        ("parameters.l5.value = '1 m'", "parameters.l5.value = '2 m'"),
        ("parameters = { l5 = \"1 m\" }", "parameters = { l5 = \"2 m\" }"),
        ("[parameters]\n'l5' = { \"value\" = \" 1 m \" }", "[parameters]\n'l5' = { \"value\" = \" 2 m \" }"),
        ("[parameters]\nl5 = \"1\\u0020m\"", "[parameters]\nl5 = \"2 m\""),
        ("[parameters]\nl5 = \"1 m \\u00b1 1 mm\"", "[parameters]\nl5 = \"2 m ± 1 mm\""),
        ("[parameters]\nl5 = \"\"\"\\\n  1 m\"\"\"", "[parameters]\nl5 = \"\"\"2 m\"\"\""),
        ("[parameters]\nl5 = 0", "[parameters]\nl5 = 0"),
    ];
    for (text, expected) in cases {
        let new = if text.ends_with("= 0") { "0" } else { "2 m" };
        assert_eq!(rewritten(text, &[("l5", new)]).unwrap(), expected, "{text}");
    }
}

#[test]
fn refusals() {
    let fault = |text: &str, name: &str, value: &str| rewritten(text, &[(name, value)]).unwrap_err().to_string();
    assert_eq!(fault(LAYOUT, "l9x", "1 m"), "the file defines no parameter `l9x`");
    assert_eq!(fault(LAYOUT, "m", "1 kg"), "the file defines no parameter `m`; did you mean `m1`?");
    assert_eq!(fault("bellcrank = 1", "m1", "1 kg"), "the file defines no parameter `m1`");
    assert_eq!(fault(LAYOUT, "l5", "1 kg"), "`l5` needs a length, found a mass");
    assert_eq!(fault(LAYOUT, "l32", "l61"), "parameters depend on each other in a circle: l32 -> l61 -> l32");
    assert_eq!(fault(LAYOUT, "l32", "1 m\" # "), "`\"` has no meaning in an expression");
    assert_eq!(fault(LAYOUT, "l32", ""), "the expression is empty");
    assert_eq!(fault("[parameters]\na = 1\nb = [", "a", "2"), {
        let first = rewritten("[parameters]\na = 1\nb = [", &[("a", "2")]).unwrap_err();
        let RewriteError::FaultyFile { diagnostics } = first else { panic!("{first}") };
        format!("the file has errors: {}", diagnostics.iter().next().unwrap().message)
    });
    let twice = rewritten(LAYOUT, &[("n", "1"), ("n", "2")]).unwrap_err();
    assert!(matches!(twice, RewriteError::RepeatedParameter { name } if name == "n"));
    // Fits as an override, but the file would define something else by it, or twice.
    for (name, value) in [("r", "3 N*m"), ("m1", "3 kg ± 1 kg"), ("l5", "0 + 0")] {
        let error = rewritten(LAYOUT, &[(name, value)]).unwrap_err();
        assert!(matches!(error, RewriteError::NotAsAsked { .. }), "{name}: {error}");
    }
}
