//! Files for tests.

use std::path::{Path, PathBuf};

use bellcrank_model::{Loaded, Model, Silent, load};
use bellcrank_results::StudyResult;

/// A folder of its own that goes away with the value.
pub(crate) struct Scratch(PathBuf);

impl Scratch {
    pub(crate) fn new(name: &str) -> Scratch {
        let path = std::env::temp_dir().join(format!("bellcrank-model-{name}-{}", std::process::id()));
        std::fs::create_dir_all(&path).expect("a scratch folder");
        Scratch(path)
    }

    pub(crate) fn write(&self, name: &str, bytes: impl AsRef<[u8]>) -> PathBuf {
        let path = self.0.join(name);
        std::fs::write(&path, bytes).expect("a scratch file");
        path
    }
}

impl Drop for Scratch {
    fn drop(&mut self) {
        let _ = std::fs::remove_dir_all(&self.0);
    }
}

pub(crate) fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

/// The lift of the assist manipulator.
pub(crate) fn lift() -> PathBuf {
    root().join("models/assist-manipulator/lift.toml")
}

/// The text of all diagnostics.
pub(crate) fn rendered(loaded: &Loaded) -> String {
    loaded.diagnostics.render(&loaded.sources, false)
}

pub(crate) fn model_of(path: &Path) -> Model {
    let loaded = load(path, &[]);
    let text = rendered(&loaded);
    loaded.model.unwrap_or_else(|| panic!("{}:\n{text}", path.display()))
}

/// The model of a text.
pub(crate) fn model(name: &str, text: &str) -> Model {
    let scratch = Scratch::new(name);
    model_of(&scratch.write("model.toml", text))
}

pub(crate) fn run(model: &Model, study: &str) -> StudyResult {
    model.run(study, &mut Silent).unwrap_or_else(|error| panic!("{error}"))
}

/// A value of a signal, SI.
pub(crate) fn value(result: &StudyResult, signal: &str, row: usize) -> f64 {
    result.table.column(signal).unwrap_or_else(|| panic!("no signal {signal}")).values[row]
}
