//! A sweep in words.

use bellcrank_results::Designs;

use super::{code, listed};

pub(super) fn sentences(found: &Designs) -> Vec<String> {
    [Some(counts(found)), front(found), files(found)].into_iter().flatten().collect()
}

fn counts(found: &Designs) -> String {
    let seed = found.seed.map_or(String::new(), |seed| format!(", seed {seed}"));
    let resumed = match found.resumed {
        0 => String::new(),
        count => format!(", {count} of them taken over from an earlier run"),
    };
    let failed = match found.failed {
        0 => "none failed".to_owned(),
        count => format!("{count} failed"),
    };
    format!(
        "{} of {} designs of study {} (method {}{seed}) were computed{resumed}; {failed}.",
        found.done,
        found.total,
        code(&found.of),
        code(&found.method)
    )
}

fn front(found: &Designs) -> Option<String> {
    let front = found.pareto.as_ref()?;
    let goal =
        |(name, minimize): &(String, bool)| format!("{} {}", if *minimize { "small" } else { "large" }, code(name));
    let goals: Vec<String> = front.objectives.iter().map(goal).collect();
    let (count, verb) = match front.front.rows() {
        1 => ("1 design".to_owned(), "is"),
        count => (format!("{count} designs"), "are"),
    };
    Some(format!("{count} {verb} a best compromise between {}: no other design is better in both.", listed(&goals)))
}

fn files(found: &Designs) -> Option<String> {
    let names: Vec<String> = found.files.iter().map(|name| code(name)).collect();
    (!names.is_empty()).then(|| format!("All rows are in {}.", listed(&names)))
}

pub(super) fn unmet(found: &Designs) -> Option<String> {
    match (found.done < found.total, found.failed) {
        (true, _) => Some(format!("{} of {} designs were not computed", found.total - found.done, found.total)),
        (false, 0) => None,
        (false, failed) if failed == found.total => Some("every design failed".to_owned()),
        (false, _) => None,
    }
}
