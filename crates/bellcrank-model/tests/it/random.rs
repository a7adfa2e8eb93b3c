//! Random damage to the lift file never panics and never hangs.

use bellcrank_model::load;
use proptest::prelude::*;

use crate::support::{Scratch, lift};

const PIECES: &[&str] = &[
    "\"",
    "[",
    "]",
    "{",
    "}",
    "=",
    ".",
    "#",
    "\n",
    "0",
    "-1",
    "1e308",
    "nan",
    "inf",
    " kg",
    " mm",
    " deg",
    "ground.O",
    "link1",
    "B",
    "slide",
    "[bodies.x]",
    "like = \"lift\"",
    "sqrt(-1)",
    "l31",
    "1/0",
    "é",
    "\u{0}",
    "'''",
];

#[derive(Clone, Debug)]
enum Damage {
    Remove(f64, usize),
    Insert(f64, usize),
    Repeat(f64, usize),
    SwapLines(f64, f64),
}

fn damage() -> impl Strategy<Value = Damage> {
    let share = 0.0..1.0f64;
    prop_oneof![
        (share.clone(), 1..40usize).prop_map(|(at, length)| Damage::Remove(at, length)),
        (share.clone(), 0..PIECES.len()).prop_map(|(at, piece)| Damage::Insert(at, piece)),
        (share.clone(), 1..60usize).prop_map(|(at, length)| Damage::Repeat(at, length)),
        (share.clone(), share).prop_map(|(a, b)| Damage::SwapLines(a, b)),
    ]
}

fn apply(text: &str, damage: &Damage) -> String {
    let chars: Vec<char> = text.chars().collect();
    let at = |share: &f64| ((chars.len() as f64 * share) as usize).min(chars.len());
    let join = |parts: &[&[char]]| parts.iter().flat_map(|part| part.iter()).collect::<String>();
    match damage {
        Damage::Remove(share, length) => {
            let from = at(share);
            join(&[&chars[..from], &chars[(from + length).min(chars.len())..]])
        }
        Damage::Insert(share, piece) => {
            let from = at(share);
            let inserted: Vec<char> = PIECES[*piece].chars().collect();
            join(&[&chars[..from], &inserted, &chars[from..]])
        }
        Damage::Repeat(share, length) => {
            let from = at(share);
            let to = (from + length).min(chars.len());
            join(&[&chars[..to], &chars[from..to], &chars[to..]])
        }
        Damage::SwapLines(a, b) => {
            let mut lines: Vec<&str> = text.lines().collect();
            let line = |share: &f64| ((lines.len() as f64 * share) as usize).min(lines.len().saturating_sub(1));
            let (a, b) = (line(a), line(b));
            if !lines.is_empty() {
                lines.swap(a, b);
            }
            lines.join("\n")
        }
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 300, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn damaged_lifts_are_read_and_checked(damages in prop::collection::vec(damage(), 1..6)) {
        let text = std::fs::read_to_string(lift()).expect("the lift");
        let text = damages.iter().fold(text, |text, damage| apply(&text, damage));
        let scratch = Scratch::new("random");
        let loaded = load(&scratch.write("lift.toml", text), &[]);
        prop_assert!(loaded.model.is_some() || loaded.diagnostics.has_errors());
        if let Some(model) = loaded.model {
            let _ = model.check().text();
        }
    }
}
