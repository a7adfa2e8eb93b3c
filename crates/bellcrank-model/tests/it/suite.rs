//! Model files with faults, and the reports they get: `#! error LINE:COLUMN code: message | hint` at their end.
//! `BELLCRANK_BLESS=1 cargo test -p bellcrank-model suite` rewrites the annotations; read them before committing.

use std::path::{Path, PathBuf};

use bellcrank_model::{Loaded, load};

const MARK: &str = "#! ";

fn files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite");
    let mut files: Vec<PathBuf> =
        std::fs::read_dir(folder).expect("the suite").map(|entry| entry.expect("a file").path()).collect();
    files.retain(|path| path.is_file());
    files.sort();
    files
}

/// Findings as annotations; files are named when they are not the one that was loaded.
fn annotations(path: &Path, loaded: &Loaded) -> Vec<String> {
    let annotation = |finding: bellcrank_doc::Finding| {
        let place = finding.location.map_or("-".to_owned(), |at| format!("{}:{}", at.line, at.column));
        let file = Path::new(&finding.file);
        let elsewhere = if finding.file.is_empty() || file == path {
            String::new()
        } else {
            format!("{} ", file.file_name().expect("a name").to_string_lossy())
        };
        let folder = format!("{}/", path.parent().expect("a folder").display());
        let message = finding.message.replace(&folder, "");
        let hints: String = finding.hints.iter().map(|hint| format!(" | {hint}")).collect();
        format!("{} {elsewhere}{place} {}: {message}{hints}", finding.severity, finding.code)
    };
    loaded.diagnostics.findings(&loaded.sources).into_iter().map(annotation).collect()
}

#[test]
fn every_fault_is_told_where_it_is() {
    let bless = std::env::var_os("BELLCRANK_BLESS").is_some();
    for path in files() {
        let text = std::fs::read_to_string(&path).expect("a text");
        let found = annotations(&path, &load(&path, &[]));
        if bless {
            let model: String =
                text.lines().filter(|line| !line.starts_with(MARK)).map(|line| format!("{line}\n")).collect();
            let marks: String = found.iter().map(|line| format!("{MARK}{line}\n")).collect();
            std::fs::write(&path, model + &marks).expect("a file that can be written");
            continue;
        }
        let expected: Vec<&str> = text.lines().filter_map(|line| line.strip_prefix(MARK)).collect();
        assert!(!expected.is_empty(), "{} has no annotation", path.display());
        assert_eq!(found, expected, "{}", path.display());
    }
}
