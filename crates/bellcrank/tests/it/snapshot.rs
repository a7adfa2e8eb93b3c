//! Whole outputs compared with stored ones. Forty lines of our own: what a snapshot crate would add (review tools,
//! inline texts, redaction languages) is not used, and `git diff` is the review.

use std::fs;
use std::path::Path;

use crate::sandbox::{Sandbox, text};

/// Runs the program and compares command, exit code and both outputs with `tests/snapshots/NAME.txt`.
pub(crate) fn check(name: &str, sandbox: &Sandbox, arguments: &[&str]) {
    let output = sandbox.run(arguments);
    let code = output.status.code().map_or("none".to_owned(), |code| code.to_string());
    let seen = format!(
        "$ {}\nexit code: {code}\n----- stdout\n{}----- stderr\n{}",
        [&["bellcrank"], arguments].concat().join(" "),
        redacted(&text(&output.stdout)),
        redacted(&text(&output.stderr))
    );
    compare(name, &seen);
}

fn compare(name: &str, seen: &str) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/snapshots").join(format!("{name}.txt"));
    if std::env::var_os("BELLCRANK_BLESS").is_some() {
        fs::write(&path, seen).unwrap();
    }
    let kept = fs::read_to_string(&path).unwrap_or_default().replace("\r\n", "\n");
    assert!(kept == seen, "{name} changed; `cargo xtask bless` accepts it.\n--- kept\n{kept}\n--- seen\n{seen}");
}

/// Times and rounding errors, which differ from run to run and from machine to machine.
pub(crate) fn redacted(output: &str) -> String {
    output.split_inclusive('\n').map(redacted_line).collect()
}

fn redacted_line(line: &str) -> String {
    let body = line.strip_suffix('\n').unwrap_or(line);
    let mut words: Vec<&str> = body.split(' ').collect();
    // A line that ends in a time: how long a study took.
    if let [.., value, "s" | "ms" | "µs"] = words[..]
        && is_number(value)
    {
        words.truncate(words.len() - 2);
        words.push("[TIME]");
    }
    for word in &mut words {
        match word.strip_suffix(',') {
            Some(bare) if is_rounding_error(bare) => *word = "[TINY],",
            _ if is_rounding_error(word) => *word = "[TINY]",
            _ => {}
        }
    }
    words.join(" ") + &line[body.len()..]
}

fn is_number(word: &str) -> bool {
    word.parse::<f64>().is_ok()
}

fn is_rounding_error(word: &str) -> bool {
    is_number(word) && word.split_once("e-").is_some_and(|(_, exponent)| exponent.parse::<u32>().is_ok_and(|e| e >= 10))
}

#[test]
fn only_what_differs_is_redacted() {
    assert_eq!(redacted("a, 601 rows, 1.25 ms\n"), "a, 601 rows, [TIME]\n");
    assert_eq!(redacted("closure 2.2e-16 m ok"), "closure [TINY] m ok");
    assert_eq!(redacted("gradient 2.2e-16, violation 0"), "gradient [TINY], violation 0");
    assert_eq!(redacted("lasts 3 s in all, 5e-3"), "lasts 3 s in all, 5e-3");
}
