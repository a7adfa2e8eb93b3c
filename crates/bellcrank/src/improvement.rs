//! `--write FILE`: the model with the values that its `optimize` study found.
//!
//! All that can be refused is refused before a study runs; the file appears whole or not at all.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use bellcrank_model::{ImproveError, Loaded, Model};
use bellcrank_results::{Findings, RunResult, StudyResult};

use crate::config::RunConfig;
use crate::exit::{Exit, Refusal};

const KIND: &str = "optimize";

/// Where the improved model goes, and which study improves it.
#[derive(Debug)]
pub(crate) struct Improvement {
    /// As given.
    file: PathBuf,
    study: String,
    force: bool,
}

impl Improvement {
    /// Refuses what could not be written when the study is done.
    pub(crate) fn prepare(config: &RunConfig, model: &Model) -> Result<Option<Self>, Refusal> {
        let Some(write) = &config.write else { return Ok(None) };
        let study = the_one(model, config)?;
        let improvement = Self { file: write.file.clone(), study, force: write.force };
        improvement.refuse_place(&config.model)?;
        improvement.refuse_references(&config.model, model)?;
        Ok(Some(improvement))
    }

    /// Writes the file and says so in the result; what the reader should know becomes warnings of the study.
    pub(crate) fn write(&self, model: &Model, run: &mut RunResult) -> Result<(), Refusal> {
        let result = run.studies.iter_mut().find(|study| study.name == self.study);
        let Some(result) = result else {
            let message = format!("`{}` was not written: study `{}` was not run", self.file.display(), self.study);
            return Err(Refusal { exit: Exit::Mathematics, message, hints: Vec::new() });
        };
        let improved = model.improved(result, &self.file).map_err(|error| self.not_improved(&error))?;
        self.put(&improved.text).map_err(|error| self.unwritable(&error))?;
        result.warnings.extend(improved.warnings);
        note(result, &self.file);
        Ok(())
    }

    fn refuse_place(&self, model: &Path) -> Result<(), Refusal> {
        let file = self.file.display();
        let folder = folder(&self.file);
        if self.file.is_dir() {
            let example = self.file.join("better.toml");
            return Err(Refusal::command_line(format!("`{file}` is a folder, `--write` needs a file"))
                .hint(format!("give it a name, as `--write {}`", example.display())));
        }
        if !folder.is_dir() {
            return Err(Refusal::command_line(format!("there is no folder `{}` for `{file}`", folder.display()))
                .hint("make the folder first, or write elsewhere"));
        }
        if self.file.exists() && !self.force {
            let refusal = Refusal::command_line(format!("`{file}` exists already"));
            return Err(if same(&self.file, model) {
                refusal.hint("it is the model itself: choose another name, or have its values replaced with `--force`")
            } else {
                refusal.hint("choose another name, or replace it with `--force`")
            });
        }
        self.try_folder().map_err(|error| self.unwritable(&error))
    }

    /// What a model names is relative to its file.
    fn refuse_references(&self, from: &Path, model: &Model) -> Result<(), Refusal> {
        if same(&folder(&self.file), &folder(from)) {
            return Ok(());
        }
        let Loaded { sources, diagnostics, model: moved } = model.moved(&self.file);
        if moved.is_some() {
            return Ok(());
        }
        let findings = diagnostics.findings(&sources);
        let first = findings.iter().find(|finding| finding.severity == "error");
        let message = first.map_or("it cannot be read there", |finding| finding.message.as_str());
        let name = self.file.file_name().filter(|name| Some(*name) != from.file_name());
        let beside = from.with_file_name(name.unwrap_or("better.toml".as_ref()));
        Err(Refusal::command_line(format!("the model cannot stand in `{}`: {message}", self.file.display()))
            .hint(format!("files that a model names are beside it: `--write {}`", beside.display())))
    }

    fn not_improved(&self, error: &ImproveError) -> Refusal {
        let message = format!("`{}` was not written: {error}", self.file.display());
        Refusal { exit: Exit::Mathematics, message, hints: error.hints() }
    }

    fn unwritable(&self, error: &io::Error) -> Refusal {
        Refusal::command_line(format!("cannot write `{}`: {error}", self.file.display()))
    }

    fn try_folder(&self) -> io::Result<()> {
        let room = self.room();
        fs::write(&room, "")?;
        fs::remove_file(room)
    }

    fn put(&self, text: &str) -> io::Result<()> {
        let room = self.room();
        let put = self.put_by(&room, text);
        if put.is_err() {
            // Of no use to anybody.
            let _ = fs::remove_file(&room);
        }
        put
    }

    /// A file that is replaced keeps its permissions, and a link to it stays one.
    fn put_by(&self, room: &Path, text: &str) -> io::Result<()> {
        fs::write(room, text)?;
        match self.file.canonicalize() {
            // It came into being while the study ran.
            Ok(_) if !self.force => Err(io::ErrorKind::AlreadyExists.into()),
            Ok(target) => {
                fs::set_permissions(room, fs::metadata(&target)?.permissions())?;
                fs::rename(room, target)
            }
            Err(_) => fs::rename(room, &self.file),
        }
    }

    /// Beside the file, or beside what it is a link to: a file is not moved from disk to disk.
    fn room(&self) -> PathBuf {
        let target = self.file.canonicalize().unwrap_or_else(|_| self.file.clone());
        target.with_file_name(format!(".bellcrank-{}.toml", std::process::id()))
    }
}

/// The `optimize` study among those that are run.
fn the_one(model: &Model, config: &RunConfig) -> Result<String, Refusal> {
    let known = model.studies();
    let able: Vec<&str> = known.iter().filter(|s| s.kind == KIND && s.available).map(|s| s.name.as_str()).collect();
    let chosen = |name: &&&str| config.studies.is_empty() || config.studies.iter().any(|study| study == **name);
    let run: Vec<&str> = able.iter().filter(chosen).copied().collect();
    let command = |study: &str| format!("`bellcrank run {} {study} --write FILE`", config.model.display());
    match run.as_slice() {
        [one] => Ok((*one).to_owned()),
        [first, ..] => {
            Err(Refusal::command_line(format!("`--write` needs one study of kind `{KIND}`, found {}", listed(&run)))
                .hint(format!("name the one to write: {}", command(first))))
        }
        [] => Err(nothing(&config.studies, &able, command)),
    }
}

fn nothing(named: &[String], able: &[&str], command: impl Fn(&str) -> String) -> Refusal {
    let message = format!("`--write` needs a study of kind `{KIND}`, which finds what to write");
    let refusal = Refusal::command_line(message);
    match able {
        [] => refusal.hint(format!("the model has none: add `[studies.NAME]` with `kind = \"{KIND}\"`")),
        [first, ..] => {
            let names: Vec<&str> = named.iter().map(String::as_str).collect();
            let verb = if names.len() == 1 { "is" } else { "are" };
            refusal.hint(format!("{} {verb} of another kind; try {}", listed(&names), command(first)))
        }
    }
}

fn note(result: &mut StudyResult, file: &Path) {
    if let Some(Findings::Optimization(found)) = &mut result.findings {
        found.written = Some(file.display().to_string());
    }
}

fn listed(names: &[&str]) -> String {
    names.iter().map(|name| format!("`{name}`")).collect::<Vec<_>>().join(", ")
}

/// The folder of a file; that of a mere name is the current one.
fn folder(file: &Path) -> PathBuf {
    match file.parent() {
        Some(folder) if folder.as_os_str().is_empty() => PathBuf::from("."),
        Some(folder) => folder.to_owned(),
        None => PathBuf::from("."),
    }
}

fn same(a: &Path, b: &Path) -> bool {
    matches!((a.canonicalize(), b.canonicalize()), (Ok(a), Ok(b)) if a == b)
}
