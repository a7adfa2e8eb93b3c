//! What a file says, part by part, as fingerprints that do not see comments, blank space and places: they tell which part
//! of a model changed since an earlier run.

use bellcrank_doc::{Entry, Table, Value, ValueKind};

use crate::provenance::Fingerprint;
use crate::read::Part;

/// Parts that are told by the name of what they define.
const NAMED: &[&str] = &["bodies", "joints", "forces", "motions", "subsystems", "studies", "materials", "solids"];
/// What does not count: format and title; display units, which are told by the columns they stand over.
const SILENT: &[&str] = &["bellcrank", "title", "units"];

/// A part of a model file, as `bodies.link1`.
#[derive(Clone, Debug)]
pub(crate) struct Section {
    pub(crate) name: String,
    pub(crate) fingerprint: u64,
    /// The study that a study is like.
    pub(crate) like: Option<String>,
}

/// All parts of all files. Parameters of the main file are left out: a run may have them from elsewhere.
pub(crate) fn sections(files: &[Part]) -> Vec<Section> {
    let mut all = Vec::new();
    for file in files {
        let main = file.prefix.is_empty();
        let silent = if main { "parameters" } else { "studies" };
        let counts = |entry: &&Entry| entry.key != silent && !SILENT.contains(&entry.key.as_str());
        for entry in file.table.iter().filter(counts) {
            match entry.value.as_table().filter(|_| NAMED.contains(&entry.key.as_str())) {
                Some(table) => all.extend(
                    table.iter().map(|one| section(format!("{}{}.{}", file.prefix, entry.key, one.key), &one.value)),
                ),
                None => all.push(section(format!("{}{}", file.prefix, entry.key), &entry.value)),
            }
        }
    }
    all
}

fn section(name: String, value: &Value) -> Section {
    let mut fingerprint = Fingerprint::default();
    add(&mut fingerprint, value);
    let like = value.as_table().and_then(|table| table.get("like")).and_then(|like| like.value.as_str());
    Section { name, fingerprint: fingerprint.value(), like: like.map(str::to_owned) }
}

fn add(to: &mut Fingerprint, value: &Value) {
    match &value.kind {
        ValueKind::String(text) => to.words("text", &text.value),
        ValueKind::Integer(number) => to.words("number", &number.to_string()),
        ValueKind::Float(number) => to.words("number", &number.to_string()),
        ValueKind::Boolean(yes) => to.words("truth", &yes.to_string()),
        ValueKind::Datetime(date) => to.words("date", date),
        ValueKind::List(values) => {
            to.words("list", &values.len().to_string());
            values.iter().for_each(|value| add(to, value));
        }
        ValueKind::Table(table) => add_table(to, table),
        ValueKind::Faulty => to.words("nothing", ""),
    }
}

fn add_table(to: &mut Fingerprint, table: &Table) {
    to.words("table", &table.len().to_string());
    for entry in table.iter() {
        to.words("key", &entry.key);
        add(to, &entry.value);
    }
}
