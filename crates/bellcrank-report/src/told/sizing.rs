//! A drive in words.

use bellcrank_results::{Check, Sizing};

use super::{code, listed, shown};

pub(super) fn sentences(found: &Sizing) -> Vec<String> {
    let needs: Vec<String> =
        found.requirements.iter().map(|need| format!("{} {}", need.label, shown(need.value, &need.unit))).collect();
    let what = format!("{} in study {} needs: {}.", code(&found.drive), code(&found.of), needs.join(", "));
    [Some(choice(found)), (!needs.is_empty()).then_some(what)].into_iter().flatten().collect()
}

fn choice(found: &Sizing) -> String {
    let count = found.candidates.len();
    let passing = found.candidates.iter().filter(|candidate| candidate.passes).count();
    match found.chosen.and_then(|index| found.candidates.get(index)) {
        Some(chosen) => {
            format!(
                "Proposed for {}: {}, the smallest of {passing} that pass every check, of {count} looked at.",
                code(&found.drive),
                code(&chosen.name)
            )
        }
        None if count == 0 => format!("There is no drive for {} in the catalogue.", code(&found.drive)),
        None => format!("None of {count} drives passes every check for {}{}.", code(&found.drive), nearest(found)),
    }
}

/// The one that fails least.
fn nearest(found: &Sizing) -> String {
    let Some(nearest) = found.nearest.and_then(|index| found.candidates.get(index)) else { return String::new() };
    let reasons: Vec<String> =
        nearest.checks.iter().filter(|check| check.passes == Some(false)).map(|check| check.reason.clone()).collect();
    format!("; nearest is {}, which fails: {}", code(&nearest.name), listed(&reasons))
}

pub(super) fn unmet(found: &Sizing) -> Option<String> {
    found.chosen.is_none().then(|| "no drive passes every check".to_owned())
}

/// How a check ended, in a word.
pub(crate) fn word(check: &Check) -> &'static str {
    match check.passes {
        Some(true) => "pass",
        Some(false) => "FAIL",
        None => "not checked",
    }
}
