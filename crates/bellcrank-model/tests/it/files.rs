//! Files that are no models at all.

use std::path::Path;

use bellcrank_model::load;

use crate::support::{Scratch, rendered};

fn report(name: &str, bytes: &[u8]) -> String {
    let scratch = Scratch::new(name);
    let loaded = load(&scratch.write("model.toml", bytes), &[]);
    assert!(loaded.model.is_none());
    rendered(&loaded)
}

#[test]
fn empty_binary_and_foreign_files_are_refused() {
    assert!(report("empty", b"").contains("the file is empty"));
    assert!(report("blank", b" \n\t\n").contains("the file is empty"));
    assert!(report("binary", b"\x7fELF\0\0\0").contains("not a text file"));
    assert!(report("latin", b"title = \"\xe9\"").contains("not UTF-8"));
    assert!(report("utf16", b"\xff\xfeb\0").contains("UTF-16"));
    assert!(report("words", b"this is a letter, not a model").contains("error"));
}

#[test]
fn a_hundred_megabytes_are_refused_unread() {
    let scratch = Scratch::new("large");
    let path = scratch.write("large.toml", b"");
    std::fs::File::options().write(true).open(&path).and_then(|file| file.set_len(100 << 20)).expect("a sparse file");
    let loaded = load(&path, &[]);
    assert!(rendered(&loaded).contains("100 MiB"), "{}", rendered(&loaded));
}

#[test]
fn absent_files_and_folders_are_told() {
    assert!(rendered(&load(Path::new("/absent/model.toml"), &[])).contains("cannot read"));
    assert!(rendered(&load(&std::env::temp_dir(), &[])).contains("folder"));
    if cfg!(unix) {
        assert!(load(Path::new("/dev/zero"), &[]).model.is_none());
    }
}
