//! Running the shipped lift, as it is and with other values.

use std::path::{Path, PathBuf};

use bellcrank_model::{Loaded, Model, Silent, load};
use bellcrank_results::{Findings, ParameterRow, StudyResult};

use crate::shell::root;

pub(crate) const MODEL: &str = "models/assist-manipulator/lift.toml";

/// A study with its columns by short names.
pub(crate) struct Study(StudyResult);

impl Study {
    /// A column, SI.
    pub(crate) fn column(&self, signal: &str) -> Result<&[f64], String> {
        let column = self.0.table.column(signal).ok_or_else(|| format!("the lift has no signal `{signal}`"))?;
        Ok(&column.values)
    }

    /// Smallest and largest value of a column, SI.
    pub(crate) fn range(&self, signal: &str) -> Result<(f64, f64), String> {
        let values = self.column(signal)?;
        Ok((
            values.iter().copied().fold(f64::INFINITY, f64::min),
            values.iter().copied().fold(f64::NEG_INFINITY, f64::max),
        ))
    }

    /// A signal where θ3 is so many degrees, SI.
    pub(crate) fn at(&self, degrees: f64, signal: &str) -> Result<f64, String> {
        let angles = self.column("joint.B.position")?;
        let row = angles.iter().position(|angle| (angle.to_degrees() - degrees).abs() < 1e-6);
        let row = row.ok_or_else(|| format!("the sweep has no row at {degrees} deg"))?;
        Ok(self.column(signal)?[row])
    }

    /// Largest drive force, N, and the angle θ3 where it occurs, degrees.
    pub(crate) fn peak(&self) -> Result<(f64, f64), String> {
        let forces = self.column("drive.slide.force")?.iter().map(|force| force.abs());
        let angles = self.column("joint.B.position")?.iter().map(|angle| angle.to_degrees());
        let peak = forces.zip(angles).max_by(|a, b| a.0.total_cmp(&b.0));
        peak.ok_or_else(|| "the sweep is empty".to_owned())
    }
}

/// A study of the shipped lift with other values for some parameters.
pub(crate) fn study(name: &str, settings: &[(&str, String)]) -> Result<Study, String> {
    run(&root().join(MODEL), name, settings)
}

/// A study of the lift with a piece of its text replaced, where no parameter stands for it.
pub(crate) fn rewritten(name: &str, pieces: &[(&str, &str)]) -> Result<Study, String> {
    let path = root().join(MODEL);
    let mut text = std::fs::read_to_string(&path).map_err(|error| format!("{MODEL}: {error}"))?;
    for (piece, other) in pieces {
        if !text.contains(piece) {
            return Err(format!("{MODEL} does not hold `{piece}`"));
        }
        text = text.replace(piece, other);
    }
    let room = Room::new()?;
    let file = room.0.join("lift.toml");
    std::fs::write(&file, text).map_err(|error| format!("{}: {error}", file.display()))?;
    run(&file, name, &[])
}

/// What a study of the shipped lift that asks another one found.
pub(crate) fn findings(name: &str) -> Result<Findings, String> {
    let found = run(&root().join(MODEL), name, &[])?.0.findings;
    found.ok_or_else(|| format!("{MODEL}, {name}: it finds nothing"))
}

/// The parameters of the shipped lift.
pub(crate) fn parameters() -> Result<Vec<ParameterRow>, String> {
    Ok(open(&root().join(MODEL), &[])?.parameters())
}

fn run(path: &Path, name: &str, settings: &[(&str, String)]) -> Result<Study, String> {
    let result = open(path, settings)?.run(name, &mut Silent).map_err(|error| error.to_string())?;
    match result.failure {
        Some(failure) => Err(format!("{MODEL}, {name}: {}", failure.message)),
        None => Ok(Study(result)),
    }
}

fn open(path: &Path, settings: &[(&str, String)]) -> Result<Model, String> {
    let settings: Vec<_> = settings.iter().map(|(name, value)| ((*name).to_owned(), value.clone())).collect();
    let Loaded { sources, diagnostics, model } = load(path, &settings);
    model.ok_or_else(|| diagnostics.render(&sources, false))
}

/// A folder for one file, gone afterwards; numbered, since tests run side by side.
struct Room(PathBuf);

impl Room {
    fn new() -> Result<Self, String> {
        static NEXT: std::sync::atomic::AtomicUsize = std::sync::atomic::AtomicUsize::new(0);
        let number = NEXT.fetch_add(1, std::sync::atomic::Ordering::Relaxed);
        let path = std::env::temp_dir().join(format!("bellcrank-paper-{}-{number}", std::process::id()));
        std::fs::create_dir_all(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        Ok(Self(path))
    }
}

impl Drop for Room {
    fn drop(&mut self) {
        // Left behind in the system's folder for temporary files at worst.
        let _ = std::fs::remove_dir_all(&self.0);
    }
}
