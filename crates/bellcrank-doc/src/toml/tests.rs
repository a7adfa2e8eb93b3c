//! What is read, and what is reported where.

use crate::{Diagnostics, Sources, Table, ValueKind, parse};

fn read(text: &str) -> (Table, Vec<String>) {
    let mut sources = Sources::new();
    let id = sources.add("m.toml", text);
    let mut diagnostics = Diagnostics::new();
    let tree = parse(&sources, id, &mut diagnostics);
    diagnostics.sort();
    let report = |f: crate::Finding| {
        let (line, column) = f.location.map_or((0, 0), |l| (l.line, l.column));
        format!("{line}:{column} {}", f.message)
    };
    let reports = diagnostics.findings(&sources).into_iter().map(report).collect();
    (tree, reports)
}

/// Keys in order, nested ones in parentheses.
fn outline(table: &Table) -> String {
    let entry = |e: &crate::Entry| match &e.value.kind {
        ValueKind::Table(inner) => format!("{}({})", e.key, outline(inner)),
        ValueKind::List(values) => {
            let inner: Vec<String> = values.iter().map(|v| v.as_table().map_or(".".into(), outline)).collect();
            format!("{}[{}]", e.key, inner.join(";"))
        }
        ValueKind::Faulty => format!("{}!", e.key),
        _ => e.key.clone(),
    };
    table.iter().map(entry).collect::<Vec<_>>().join(" ")
}

#[test]
fn order_headers_and_dotted_keys() {
    let cases = [
        ("b = 1\na = 2", "b a"),
        ("[x.y]\na = 1\n[x]\nb = 2\n[x.z]", "x(y(a) b z())"),
        ("a.b.c = 1\na.b.d = 2\na.e = 3", "a(b(c d) e)"),
        ("[[s]]\na = 1\n[s.t]\nb = 1\n[[s]]\nc = 1", "s[a t(b);c]"),
        ("x = { p = { q = 1 }, r.s = 2 }", "x(p(q) r(s))"),
        ("\"left-knee\" = 1\nright-knee = 2", "left-knee right-knee"),
        ("x = {\n  a = 1, # why\n  b = 2,\n}\ny = [\n 1,\n 2,\n]", "x(a b) y[.;.]"),
    ];
    for (text, expected) in cases {
        let (tree, reports) = read(text);
        assert_eq!((outline(&tree).as_str(), reports.len()), (expected, 0), "{text}: {reports:?}");
    }
}

#[test]
fn faults_and_what_is_read_beside_them() {
    let cases: &[(&str, &str, &[&str])] = &[
        (
            "[bodies.a]\nm = 1\n[bodies.a]\nm = 2\n[joints]\nj = 1",
            "bodies(a(m)) joints(j)",
            &["3:9 two bodies are named `a`"],
        ),
        ("[joints]\nB = 1\nB = 2", "joints(B)", &["3:1 two joints are named `B`"]),
        ("x = { length = 1, length = 2 }", "x(length)", &["1:19 `length` is given twice"]),
        ("l = 732 mm\nk = 1", "l! k", &["1:5 this is no value"]),
        ("g = [0, -9.81 m/s^2]", "g[.;.]", &["1:9 this is no value"]),
        ("t = \"x\nk = 1", "t! k", &["1:7 this string is not closed on its line, or holds what it may not"]),
        ("a == 3\nb = 1", "b", &["1:4 extra `=`"]),
        ("a\nb = 1", "b", &["1:2 key with no value; expected `=`"]),
        ("a = { b = 1\n[c]\nd = 1", "a(b!) c(d)", &["1:12 this `{` is never closed"]),
        ("a = { b = 1\nc = 1\nd = 2", "a(b!) c d", &["1:12 this `{` is never closed"]),
        ("a = [1, 2\n[c]\nd = 1", "a[.;.] c(d)", &["1:10 this `[` is never closed"]),
        ("a = { b = 1 }\n[a]\nc = 1", "a(b)", &["2:2 `a` is given twice"]),
        ("a = { b = 1 }\na.c = 1", "a(b)", &["2:1 `a` is complete elsewhere and cannot take `c` here"]),
        ("a = 1\n[a.b]\nc = 1\n[d]", "a d()", &["2:2 `a` is complete elsewhere and cannot take `b` here"]),
        ("é = 1\nb = 1", "b", &["1:1 invalid unquoted key; expected letters, numbers, `-` or `_`"]),
    ];
    for (text, expected, wanted) in cases {
        let (tree, reports) = read(text);
        assert_eq!(reports, *wanted, "{text}");
        // A key that is in error itself may be kept or not.
        if *expected != "b" {
            assert_eq!(outline(&tree), *expected, "{text}");
        }
    }
}

#[test]
fn strings_know_where_they_stand() {
    let text = "a = \"l5\"\nb = 'l5'\nc = \"l\\u0035\"\nd = \"\"\"\nl5\"\"\"\n";
    let (tree, _) = read(text);
    let origin = |key: &str| match &tree.get(key).unwrap().value.kind {
        ValueKind::String(t) => (t.value.clone(), t.origin.map(|o| &text[o..o + 2])),
        _ => panic!("{key}"),
    };
    for key in ["a", "b", "d"] {
        assert_eq!(origin(key), ("l5".to_owned(), Some("l5")), "{key}");
    }
    assert_eq!(origin("c"), ("l5".to_owned(), None));
}

#[test]
fn hostile_files_end_soon() {
    let n = 200_000;
    let lines = |line: &str| line.repeat(n);
    let numbered = |f: &dyn Fn(usize) -> String| (0..n).map(f).collect::<String>();
    let cases = [
        format!("a = {}", "[".repeat(n)),
        format!("a = {}", "{a=".repeat(n)),
        format!("a = [{}", "1,".repeat(n)),
        format!("a = [x, {}]", "1,".repeat(n)),
        format!("{} = 1", "a.".repeat(n) + "a"),
        format!("[{}]", "a.".repeat(n) + "a"),
        lines("a = 1\n"),
        lines("[a]\n"),
        lines("a = {\n"),
        lines("[[a]]\nx=1\n"),
        lines("\"\n"),
        lines("= "),
        numbered(&|i| format!("k{i} = \"k{}\"\n", i + 1)),
        numbered(&|i| format!("[x.k{i}]\n")),
    ];
    for text in cases {
        let started = std::time::Instant::now();
        let (tree, _) = read(&text);
        drop(tree);
        assert!(started.elapsed().as_secs() < 20, "{}", &text[..20]);
    }
}
