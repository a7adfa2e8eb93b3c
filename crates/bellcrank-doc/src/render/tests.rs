//! Whole renderings.

use crate::{Diagnostic, Diagnostics, RENDER_LIMIT, Sources, Span};

#[test]
fn both_places_and_a_hint() {
    let text = "param stroke = 2 * crank.length\nüüü = 1\n   length = 35 deg\n";
    let mut sources = Sources::new();
    let id = sources.add("four_bar.toml", text);
    let deg = text.find("35 deg").unwrap();
    let used = text.find("crank").unwrap();
    let error =
        Diagnostic::error("dimension", Span::new(id, deg, deg + 6), "`crank.length` needs a length, found an angle")
            .label("angle")
            .also(Span::new(id, used, used + 12), "used as a length here")
            .hint("write `35 mm`");
    let all: Diagnostics = [error].into_iter().collect();
    let expected = "\
error: `crank.length` needs a length, found an angle
   ┌─ four_bar.toml:3:13
 3 │    length = 35 deg
   │             ^^^^^^ angle
   ┌─ four_bar.toml:1:20
 1 │ param stroke = 2 * crank.length
   │                    ------------ used as a length here
hint: write `35 mm`
";
    assert_eq!(all.render(&sources, false), expected);
    let colored = all.render(&sources, true);
    assert!(colored.starts_with("\x1b[1;31merror\x1b[0m"));
    let finding = &all.findings(&sources)[0];
    assert_eq!((finding.file.as_str(), finding.code, finding.severity), ("four_bar.toml", "dimension", "error"));
}

#[test]
fn nothing_steers_the_terminal_and_long_lines_are_cut() {
    let text = format!("\ta = \"\x1b[2J\u{202e}長\" # {}", "x".repeat(5000));
    let mut sources = Sources::new();
    let id = sources.add("evil\x1b.toml", text.clone());
    let at = text.find('長').unwrap();
    let error = Diagnostic::error("x", Span::new(id, at, at + 3), "the \x07 bell");
    let far = text.len() - 10;
    let other = Diagnostic::error("x", Span::new(id, far, far + 3), "far");
    let all: Diagnostics = [error, other].into_iter().collect();
    let shown = all.render(&sources, false);
    assert!(!shown.contains('\x1b') && !shown.contains('\u{202e}') && !shown.contains('\x07') && !shown.contains('\t'));
    assert!(shown.lines().all(|l| l.chars().count() < 140), "{shown}");
    let carets: Vec<&str> = shown.lines().filter(|l| l.contains('^')).collect();
    assert!(carets[0].ends_with("^^") && carets[1].ends_with("^^^"), "{shown}");
}

#[test]
fn many_are_counted() {
    let mut sources = Sources::new();
    let id = sources.add("a", "x");
    let all: Diagnostics = (0..70).map(|i| Diagnostic::error("x", Span::new(id, 0, 1), format!("e{i}"))).collect();
    let shown = all.render(&sources, false);
    assert!(shown.ends_with("... and 20 more\n"));
    assert_eq!(shown.matches("error: ").count(), RENDER_LIMIT);
}

#[test]
fn sorting_orders_and_drops_repeats() {
    let mut sources = Sources::new();
    let id = sources.add("a", "xyz");
    let at = |i: usize| Diagnostic::error("x", Span::new(id, i, i + 1), "e");
    let mut all: Diagnostics = [at(2), at(0), at(2), Diagnostic::placeless("y", "no place")].into_iter().collect();
    all.sort();
    let starts: Vec<_> = all.iter().map(|d| d.primary.as_ref().map(|p| p.span.start)).collect();
    assert_eq!(starts, [None, Some(0), Some(2)]);
    assert!(all.render(&sources, false).starts_with("error: no place\n"));
}
