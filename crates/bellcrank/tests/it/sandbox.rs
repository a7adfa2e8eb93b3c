//! A folder of its own for each test, with the program run in it.

use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Output, Stdio};

/// The lift, as it is shipped.
pub(crate) const LIFT: &str = include_str!("../../../../models/assist-manipulator/lift.toml");

pub(crate) struct Sandbox {
    pub(crate) folder: PathBuf,
}

impl Sandbox {
    /// An empty folder named after the test.
    pub(crate) fn new(name: &str) -> Self {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        // Of the run before, if there was one.
        let _ = fs::remove_dir_all(&folder);
        fs::create_dir_all(&folder).unwrap();
        Self { folder }
    }

    /// A folder with `lift.toml`.
    pub(crate) fn with_lift(name: &str) -> Self {
        let sandbox = Self::new(name);
        sandbox.write("lift.toml", LIFT);
        sandbox
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) {
        fs::write(self.folder.join(name), bytes).unwrap();
    }

    pub(crate) fn read(&self, name: &str) -> String {
        fs::read_to_string(self.folder.join(name)).unwrap()
    }

    pub(crate) fn exists(&self, name: &str) -> bool {
        self.folder.join(name).exists()
    }

    /// The program, to be run here; what the outside sets must not change what tests see.
    pub(crate) fn command(&self, arguments: &[&str]) -> Command {
        let mut command = Command::new(env!("CARGO_BIN_EXE_bellcrank"));
        command.args(arguments).current_dir(&self.folder).stdin(Stdio::null());
        command.env_remove("NO_COLOR").env_remove("RUST_BACKTRACE").env_remove("CLICOLOR_FORCE");
        command
    }

    pub(crate) fn run(&self, arguments: &[&str]) -> Output {
        self.command(arguments).output().unwrap()
    }

    /// All files below, sorted, with `/` between folders.
    pub(crate) fn files(&self) -> Vec<String> {
        let mut found = Vec::new();
        collect(&self.folder, &mut found);
        let relative =
            |path: &PathBuf| path.strip_prefix(&self.folder).unwrap().display().to_string().replace('\\', "/");
        let mut names: Vec<String> = found.iter().map(relative).collect();
        names.sort();
        names
    }
}

fn collect(folder: &Path, found: &mut Vec<PathBuf>) {
    for entry in fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() { collect(&path, found) } else { found.push(path) }
    }
}

pub(crate) fn text(bytes: &[u8]) -> String {
    String::from_utf8(bytes.to_vec()).unwrap()
}
