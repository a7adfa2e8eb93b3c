//! Folder and file names made from names that come out of a model file.

use crate::RunResult;

/// The folder of each study inside the result folder, in the order of `run.studies`.
///
/// Study names may hold any character; a folder holds only letters, digits, `.`, `_` and `-`,
/// starts with none of the dots, and is not used twice (also not in another case).
pub fn study_folders(run: &RunResult) -> Vec<String> {
    file_stems(run.studies.iter().map(|study| study.name.as_str()))
}

/// File stems made from `names`, each different from the others; those of the first few do not depend on the rest.
pub fn file_stems<'a>(names: impl Iterator<Item = &'a str>) -> Vec<String> {
    let mut taken: Vec<String> = Vec::new();
    for name in names {
        let stem = safe(name);
        let free = (1..)
            .map(|count| numbered(&stem, count))
            .find(|candidate| !taken.iter().any(|other| other.eq_ignore_ascii_case(candidate)));
        taken.extend(free);
    }
    taken
}

fn numbered(stem: &str, count: usize) -> String {
    if count == 1 { stem.to_owned() } else { format!("{stem}-{count}") }
}

/// Longer names are cut: file systems end at 255 bytes.
const LONGEST: usize = 100;

fn safe(name: &str) -> String {
    let keep = |c: char| if c.is_ascii_alphanumeric() || "._-".contains(c) { c } else { '_' };
    let stem: String = name.chars().take(LONGEST).map(keep).collect();
    let stem = stem.trim_start_matches('.');
    if stem.is_empty() { "unnamed".to_owned() } else { stem.to_owned() }
}

#[cfg(test)]
mod tests {
    use super::file_stems;

    #[test]
    fn names_stay_inside_the_folder() {
        let names = ["lift", "../../etc/passwd", "", "Lift", "a b", "a_b"];
        let folders = file_stems(names.into_iter());
        assert_eq!(folders, ["lift", "_.._etc_passwd", "unnamed", "Lift-2", "a_b", "a_b-2"]);
    }

    #[test]
    fn long_names_are_cut() {
        assert_eq!(file_stems(["x".repeat(5000).as_str()].into_iter())[0].len(), 100);
    }
}
