//! The command line, checked: what the commands work with.

use std::path::{Path, PathBuf};

use bellcrank_model::{MeshFormats, PartFormat};
use bellcrank_report::Exports;

use crate::args::{CheckArgs, ConvergeArgs, Format, NewArgs, RunArgs, SolidFormat, SolidsArgs};
use crate::exit::Refusal;

/// A parameter's name and its other value, as written.
pub(crate) type Setting = (String, String);

/// What `run` shall print.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Printed {
    /// A summary for people.
    Summary,
    /// One JSON object.
    Json,
    /// Errors only.
    Nothing,
}

/// What `run` shall do.
#[derive(Debug)]
pub(crate) struct RunConfig {
    pub(crate) model: PathBuf,
    /// Each named once.
    pub(crate) studies: Vec<String>,
    pub(crate) settings: Vec<Setting>,
    /// `None` is the default, which depends on the model's name.
    pub(crate) out: Option<PathBuf>,
    pub(crate) exports: Exports,
    /// Files of solids.
    pub(crate) parts: PartFormat,
    /// Of studies of parts.
    pub(crate) meshes: MeshFormats,
    pub(crate) write: Option<Write>,
    pub(crate) printed: Printed,
    /// 0 is one a core.
    pub(crate) threads: usize,
    pub(crate) fresh: bool,
    /// Where reductions are kept; `None` for nowhere.
    pub(crate) cache: Option<PathBuf>,
}

/// Where the improved model goes.
#[derive(Debug)]
pub(crate) struct Write {
    pub(crate) file: PathBuf,
    /// A file that is there may be replaced.
    pub(crate) force: bool,
}

impl RunConfig {
    /// Checks the arguments of `run`.
    pub(crate) fn new(args: &RunArgs) -> Result<Self, Refusal> {
        let printed = match (args.json, args.quiet) {
            (true, _) => Printed::Json,
            (_, true) => Printed::Nothing,
            _ => Printed::Summary,
        };
        let settings = settings(&args.set)?;
        Ok(Self {
            model: args.model.clone(),
            studies: distinct(&args.studies),
            settings,
            out: args.out.clone(),
            exports: exports(&args.export),
            parts: PartFormat { step: args.export.contains(&Format::Step), stl: args.export.contains(&Format::Stl) },
            meshes: meshes(&args.export),
            write: args.write.clone().map(|file| Write { file, force: args.force }),
            printed,
            threads: args.threads.map_or(0, usize::from),
            fresh: args.fresh,
            cache: crate::cache::folder(&args.kept),
        })
    }
}

/// What `check` shall do.
#[derive(Debug)]
pub(crate) struct CheckConfig {
    pub(crate) model: PathBuf,
    pub(crate) settings: Vec<Setting>,
    pub(crate) json: bool,
}

impl CheckConfig {
    /// Checks the arguments of `check`.
    pub(crate) fn new(args: &CheckArgs) -> Result<Self, Refusal> {
        Ok(Self { model: args.model.clone(), settings: settings(&args.set)?, json: args.json })
    }
}

/// What `converge` shall do.
#[derive(Debug)]
pub(crate) struct ConvergeConfig {
    pub(crate) model: PathBuf,
    pub(crate) study: String,
    pub(crate) settings: Vec<Setting>,
    /// As a share, above 0.
    pub(crate) tolerance: f64,
    /// 0 is one a core.
    pub(crate) threads: usize,
    /// Where reductions are kept; `None` for nowhere.
    pub(crate) cache: Option<PathBuf>,
    pub(crate) json: bool,
}

impl ConvergeConfig {
    /// Checks the arguments of `converge`.
    pub(crate) fn new(args: &ConvergeArgs) -> Result<Self, Refusal> {
        Ok(Self {
            model: args.model.clone(),
            study: args.study.clone(),
            settings: settings(&args.set)?,
            tolerance: share(&args.tolerance)?,
            threads: args.threads.map_or(0, usize::from),
            cache: crate::cache::folder(&args.kept),
            json: args.json,
        })
    }
}

/// `1%`, `1 %` and `0.01` mean the same.
fn share(text: &str) -> Result<f64, Refusal> {
    let (number, unit) = text.trim().strip_suffix('%').map_or((text.trim(), 1.0), |number| (number.trim(), 0.01));
    match number.parse::<f64>().map(|number| number * unit) {
        Ok(share) if share > 0.0 && share < 1.0 => Ok(share),
        _ => Err(Refusal::command_line(format!("`--tolerance` needs a share between 0 and 1, found `{text}`"))
            .hint("write it as `--tolerance 1%` or `--tolerance 0.01`")),
    }
}

/// What `solids` shall do.
#[derive(Debug)]
pub(crate) struct SolidsConfig {
    pub(crate) model: PathBuf,
    pub(crate) settings: Vec<Setting>,
    /// `None` is the default, which depends on the model's name.
    pub(crate) out: Option<PathBuf>,
    pub(crate) formats: PartFormat,
    pub(crate) json: bool,
}

impl SolidsConfig {
    /// Checks the arguments of `solids`.
    pub(crate) fn new(args: &SolidsArgs) -> Result<Self, Refusal> {
        let wanted = |format| args.format.is_empty() || args.format.contains(&format);
        Ok(Self {
            model: args.model.clone(),
            settings: settings(&args.set)?,
            out: args.out.clone(),
            formats: PartFormat { step: wanted(SolidFormat::Step), stl: wanted(SolidFormat::Stl) },
            json: args.json,
        })
    }
}

/// What `new` shall do.
#[derive(Debug)]
pub(crate) struct NewConfig {
    pub(crate) file: PathBuf,
    pub(crate) name: String,
    pub(crate) force: bool,
}

impl NewConfig {
    /// Checks the arguments of `new`; `NAME` and `NAME.toml` mean the same.
    pub(crate) fn new(args: &NewArgs) -> Result<Self, Refusal> {
        let file = with_ending(&args.name);
        match args.name.file_name().and_then(|_| file.file_stem()?.to_str()) {
            Some(name) => Ok(Self { name: name.to_owned(), file, force: args.force }),
            None => Err(Refusal::command_line(format!("`{}` is no name for a file", args.name.display()))),
        }
    }
}

/// Not `Path::with_extension`, which would make `lift.2` into `lift.toml`.
fn with_ending(path: &Path) -> PathBuf {
    if path.extension().is_some_and(|ending| ending == "toml") {
        return path.to_owned();
    }
    let mut name = path.as_os_str().to_owned();
    name.push(".toml");
    name.into()
}

fn settings(all: &[String]) -> Result<Vec<Setting>, Refusal> {
    all.iter().map(|text| setting(text)).collect()
}

fn setting(text: &str) -> Result<Setting, Refusal> {
    let parts = text.split_once('=').map(|(name, value)| (name.trim(), value.trim()));
    match parts {
        Some((name, value)) if !name.is_empty() && !value.is_empty() => Ok((name.to_owned(), value.to_owned())),
        _ => Err(Refusal::command_line(format!("`--set` needs NAME=VALUE, found `{text}`"))
            .hint("write it as `--set l31=700mm`")),
    }
}

fn meshes(formats: &[Format]) -> MeshFormats {
    let has = |format| formats.contains(&format);
    MeshFormats { vtu: has(Format::Vtu), inp: has(Format::Inp), msh: has(Format::Msh) }
}

fn exports(formats: &[Format]) -> Exports {
    let has = |format| formats.contains(&format);
    Exports { gltf: has(Format::Gltf), parquet: has(Format::Parquet), vtu: has(Format::Vtu) }
}

fn distinct(names: &[String]) -> Vec<String> {
    let mut once: Vec<String> = Vec::new();
    for name in names {
        if !once.contains(name) {
            once.push(name.clone());
        }
    }
    once
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_setting_is_a_name_and_a_value() {
        let pair = |name: &str, value: &str| Some((name.to_owned(), value.to_owned()));
        assert_eq!(setting("l31=700mm").ok(), pair("l31", "700mm"));
        assert_eq!(setting(" a = b == c ").ok(), pair("a", "b == c"));
        for wrong in ["l31", "=3", "l31=", "", "="] {
            assert!(setting(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_share_has_a_percent_sign_or_none() {
        for one in ["1%", "1 %", "0.01", " 1.0 % "] {
            assert!((share(one).expect("a share") - 0.01).abs() < 1e-15, "{one}");
        }
        for wrong in ["", "%", "0", "-1%", "100%", "1", "1 mm", "nan", "inf"] {
            assert!(share(wrong).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_name_becomes_a_file() {
        let file = |name: &str| with_ending(Path::new(name)).display().to_string();
        assert_eq!(file("crane"), "crane.toml");
        assert_eq!(file("crane.toml"), "crane.toml");
        assert_eq!(file("machines/crane.2"), "machines/crane.2.toml");
        for wrong in ["", "..", "/"] {
            assert!(NewConfig::new(&NewArgs { name: wrong.into(), force: false }).is_err(), "{wrong}");
        }
    }

    #[test]
    fn a_study_named_twice_is_run_once() {
        let names = ["b", "a", "b"].map(str::to_owned);
        assert_eq!(distinct(&names), ["b", "a"]);
    }
}
