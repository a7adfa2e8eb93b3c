//! The name that was probably meant.

/// Candidates that are looked at; beyond, a hint is not worth its time.
const MAX_CANDIDATES: usize = 2000;
/// Longer names than this are not compared.
const MAX_LENGTH: usize = 64;

/// The candidate nearest to `name`, if any is near: equal but for case first, then by
/// Damerau-Levenshtein distance up to a third of the length (one for short names), then one that
/// `name` abbreviates.
pub fn nearest<'a>(name: &str, candidates: impl IntoIterator<Item = &'a str>) -> Option<&'a str> {
    let wanted = folded(name);
    if wanted.is_empty() || wanted.len() > MAX_LENGTH {
        return None;
    }
    let scored = candidates.into_iter().take(MAX_CANDIDATES).filter_map(|c| Some((score(&wanted, &folded(c))?, c)));
    scored.min_by_key(|&(score, _)| score).map(|(_, candidate)| candidate)
}

fn folded(name: &str) -> Vec<char> {
    name.chars().take(MAX_LENGTH + 1).flat_map(char::to_lowercase).collect()
}

/// Smaller is nearer; `None` is too far.
fn score(name: &[char], candidate: &[char]) -> Option<usize> {
    let allowed = (name.len().max(candidate.len()) / 3).max(1);
    if name.len().abs_diff(candidate.len()) <= allowed {
        let distance = distance(name, candidate);
        // A change of every character is no likeness (`x` and `y`).
        if distance <= allowed && distance < name.len().max(candidate.len()) {
            return Some(distance);
        }
    }
    let abbreviates = name.len() >= 3 && candidate.starts_with(name);
    abbreviates.then_some(MAX_LENGTH)
}

/// Insertions, deletions, changes and swaps of neighbours (optimal string alignment).
fn distance(a: &[char], b: &[char]) -> usize {
    let mut before: Vec<usize> = Vec::new();
    let mut last: Vec<usize> = (0..=b.len()).collect();
    for (i, &x) in a.iter().enumerate() {
        let mut row = vec![i + 1];
        for (j, &y) in b.iter().enumerate() {
            let mut best = (last[j] + usize::from(x != y)).min(last[j + 1] + 1).min(row[j] + 1);
            if i > 0 && j > 0 && x == b[j - 1] && a[i - 1] == y {
                best = best.min(before[j - 1] + 1);
            }
            row.push(best);
        }
        before = std::mem::replace(&mut last, row);
    }
    last.last().copied().unwrap_or(0)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_that_are_near() {
        let keys = ["length", "axis", "kind", "connects", "start", "mm", "MPa"];
        let cases = [
            ("lenght", Some("length")),
            ("Axis", Some("axis")),
            ("conects", Some("connects")),
            ("mmm", Some("mm")),
            ("mpa", Some("MPa")),
            ("con", Some("connects")),
            ("zebra", None),
            ("", None),
        ];
        for (name, expected) in cases {
            assert_eq!(nearest(name, keys), expected, "{name}");
        }
        assert_eq!(nearest("x", ["y"]), None);
        assert_eq!(nearest("l1", ["q7", "l2"]), Some("l2"));
    }
}
