//! The house rules that a compiler does not know, as tests.

use std::collections::BTreeMap;
use std::path::Path;

use crate::shell::{files, relative, root};

/// Crates that do no input or output, start no threads and read no clock: their callers decide.
const SILENT: [&str; 5] =
    ["bellcrank-math", "bellcrank-doc", "bellcrank-multibody", "bellcrank-results", "bellcrank-sizing"];

/// What a silent crate may not name, and where it belongs instead.
const LOUD: [(&str, &str); 8] = [
    ("std::fs", "files are opened by bellcrank-model, bellcrank-report and the command line"),
    ("std::time", "the caller owns the clock"),
    ("std::thread", "the caller owns the threads"),
    ("std::env", "the command line reads the environment"),
    ("std::process", "only the command line ends a process"),
    ("println!", "give the text to the caller"),
    ("print!", "give the text to the caller"),
    ("dbg!", "remove it"),
];

fn read(path: &Path) -> String {
    std::fs::read_to_string(path).unwrap_or_else(|error| panic!("{}: {error}", path.display()))
}

/// The arrows that ARCHITECTURE.md allows: its block of lines `crate → crates`.
fn allowed() -> BTreeMap<String, Vec<String>> {
    let text = read(&root().join("ARCHITECTURE.md"));
    let block = text.split("```arrows\n").nth(1).and_then(|rest| rest.split("```").next());
    let lines = block.expect("ARCHITECTURE.md holds a block ```arrows").lines();
    lines.filter_map(|line| line.split_once('→')).map(|(from, to)| (full(from), targets(to))).collect()
}

fn targets(list: &str) -> Vec<String> {
    list.split(',').map(full).filter(|name| name != "bellcrank-nothing of ours").collect()
}

/// `math` is `bellcrank-math`; the command line is `bellcrank` and the chores `xtask`.
fn full(name: &str) -> String {
    let name = name.trim();
    if ["bellcrank", "xtask"].contains(&name) { name.to_owned() } else { format!("bellcrank-{name}") }
}

/// Our own crates among all dependencies of a manifest, also those of tests and build scripts.
fn own_dependencies(manifest: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut inside = false;
    for line in manifest.lines().map(str::trim) {
        if let Some(section) = line.strip_prefix('[') {
            inside = section.contains("dependencies");
            found.extend(section.split_once("dependencies.").map(|(_, name)| name.trim_end_matches(']').to_owned()));
        } else if inside {
            found.extend(line.split(['.', ' ', '=']).next().map(str::to_owned));
        }
    }
    found.retain(|name| name == "bellcrank" || name.starts_with("bellcrank-"));
    found
}

#[test]
fn dependencies_follow_the_arrows_of_the_architecture_page() {
    let allowed = allowed();
    let mut wrong = Vec::new();
    for path in files(&root(), &|name| name == "Cargo.toml") {
        let Some(package) = package_name(&read(&path)) else { continue };
        let Some(targets) = allowed.get(&package) else {
            wrong.push(format!("`{package}` has no line among the arrows"));
            continue;
        };
        let refused = own_dependencies(&read(&path)).into_iter().filter(|name| !targets.contains(name));
        wrong.extend(refused.map(|name| format!("{}: `{package}` may not use `{name}`", relative(&path))));
    }
    assert!(wrong.is_empty(), "arrows against ARCHITECTURE.md:\n{}", wrong.join("\n"));
}

fn package_name(manifest: &str) -> Option<String> {
    let package = manifest.split("[package]").nth(1)?;
    let line = package.lines().find(|line| line.starts_with("name"))?;
    Some(line.split('"').nth(1)?.to_owned())
}

#[test]
fn manifests_are_read_as_cargo_reads_them() {
    let manifest = "[package]\nname = \"a\"\n[dependencies]\nbellcrank-doc.workspace = true\nserde = \"1\"\n\
        bellcrank-model = { path = \"..\" }\n[dev-dependencies.bellcrank-math]\npath = \"..\"\n[lints]\nbellcrank-x = 1\n";
    assert_eq!(package_name(manifest).as_deref(), Some("a"));
    assert_eq!(own_dependencies(manifest), ["bellcrank-doc", "bellcrank-model", "bellcrank-math"]);
}

#[test]
fn lower_crates_do_no_input_or_output() {
    let mut wrong = Vec::new();
    for name in SILENT {
        let sources = root().join("crates").join(name).join("src");
        for path in files(&sources, &|name| name.ends_with(".rs") && name != "tests.rs") {
            wrong.extend(loud_lines(&path));
        }
    }
    assert!(wrong.is_empty(), "not in a lower crate:\n{}", wrong.join("\n"));
}

fn loud_lines(path: &Path) -> Vec<String> {
    let text = read(path);
    // A file's unit tests stand at its end.
    let code = text.split("#[cfg(test)]").next().unwrap_or_default();
    let mut found = Vec::new();
    for (number, line) in code.lines().enumerate() {
        let line = line.split("//").next().unwrap_or_default();
        for (word, instead) in LOUD.iter().filter(|(word, _)| line.contains(word)) {
            found.push(format!("{}:{}: `{word}` ({instead})", relative(path), number + 1));
        }
    }
    found
}

#[test]
fn every_dependency_has_its_reason() {
    let manifest = read(&root().join("Cargo.toml"));
    let section = manifest.split("[workspace.dependencies]").nth(1).unwrap_or_default();
    let lines = section.lines().take_while(|line| !line.starts_with('['));
    let bare: Vec<&str> =
        lines.filter(|line| line.contains('=') && !line.starts_with('#')).filter(|l| is_bare(l)).collect();
    assert!(bare.is_empty(), "a dependency says why in a comment on its line:\n{}", bare.join("\n"));
}

fn is_bare(line: &str) -> bool {
    !line.starts_with("bellcrank") && !line.contains('#')
}

#[test]
fn links_between_the_documents_lead_somewhere() {
    let mut broken = Vec::new();
    for path in files(&root(), &|name| name.ends_with(".md")) {
        let text = read(&path);
        let folder = path.parent().unwrap_or(Path::new(""));
        let missing = links(&text).filter(|target| !folder.join(target).exists());
        broken.extend(missing.map(|target| format!("{}: {target}", relative(&path))));
    }
    assert!(broken.is_empty(), "links to nowhere:\n{}", broken.join("\n"));
}

/// Targets of `[text](target)` that are files of the repository, without their `#section`.
fn links(text: &str) -> impl Iterator<Item = &str> {
    let targets = text.split("](").skip(1).filter_map(|rest| rest.split(')').next());
    let files = targets.filter(|target| !target.contains("://") && !target.starts_with('#') && !target.contains(' '));
    files.map(|target| target.split('#').next().unwrap_or(target))
}
