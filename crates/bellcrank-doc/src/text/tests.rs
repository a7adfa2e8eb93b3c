//! What is refused, and what passes.

use super::*;

fn loaded(bytes: &[u8]) -> (Option<String>, Option<String>) {
    let mut sources = Sources::new();
    let mut diagnostics = Diagnostics::new();
    let id = load(&mut sources, "m.toml", bytes, &mut diagnostics);
    let _ = diagnostics.render(&sources, false);
    let report = diagnostics.findings(&sources).into_iter().next().map(|f| match f.location {
        Some(l) => format!("{}:{}:{} {}", f.file, l.line, l.column, f.message),
        None => f.message,
    });
    (id.map(|id| sources.text(id).to_owned()), report)
}

#[test]
fn bytes_and_their_reports() {
    let cases: &[(&[u8], Option<&str>, Option<&str>)] = &[
        (b"a = 1", Some("a = 1"), None),
        (b"\xef\xbb\xbfa = 1", Some("a = 1"), None),
        (b"", None, Some("m.toml:1:1 the file is empty")),
        (b" \n\t\n", None, Some("m.toml:1:1 the file is empty")),
        (b"a\0b", None, Some("m.toml:1:1 this is not a text file: it holds NUL bytes")),
        (b"\xff\xfea\0", None, Some("m.toml:1:1 the file is UTF-16 text, not UTF-8")),
        (b"x = 1\na = \"\xe9t\xe9\"", None, Some("m.toml:2:6 byte 0xe9 is not UTF-8 text")),
    ];
    for (bytes, text, report) in cases {
        assert_eq!(loaded(bytes), (text.map(str::to_owned), report.map(str::to_owned)), "{bytes:?}");
    }
    assert!(decode(b"a\0").is_err() && decode("é".as_bytes()).is_ok());
}

#[test]
fn large_files_are_refused_before_parsing() {
    let refusal = check_size("huge.toml", 100 << 20).unwrap_err();
    assert_eq!(refusal.message, "`huge.toml` has 100 MiB; a model file may have 16 MiB");
    assert!(check_size("ok.toml", MAX_BYTES as u64).is_ok());
    assert!(loaded(&vec![b' '; MAX_BYTES + 1]).0.is_none());
}
