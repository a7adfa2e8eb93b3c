//! Every study of every shipped machine closes its loops and balances its powers.

use std::path::PathBuf;

use bellcrank_model::{RunOptions, Silent};
use bellcrank_results::{Findings, StudyResult};

use crate::support::{model_of, root};

/// Closure in m, power balance relative.
const LIMITS: [(&str, f64); 2] = [("check.closure", 1e-12), ("check.balance", 1e-9)];

fn machines() -> Vec<PathBuf> {
    let folders = std::fs::read_dir(root().join("models")).expect("the folder of machines");
    let files = folders.flatten().filter_map(|folder| std::fs::read_dir(folder.path()).ok());
    let mut machines: Vec<PathBuf> = files.flatten().flatten().map(|file| file.path()).collect();
    machines.retain(|path| {
        let path = path.to_string_lossy();
        path.ends_with(".toml") && !path.ends_with("expected.toml")
    });
    machines
}

#[test]
fn every_shipped_machine_closes_and_balances() {
    let machines = machines();
    assert!(machines.len() >= 12, "{machines:?}");
    for path in machines {
        let model = model_of(&path);
        // Studies that ask others have no rows, and parts close no loops.
        let asking = ["sensitivity", "optimize", "sweep", "tolerance", "sizing", "stress"];
        let with_rows = model.studies().into_iter().filter(|study| study.available);
        let with_rows = with_rows.filter(|study| !asking.contains(&study.kind.as_str())).map(|study| study.name);
        let names: Vec<String> = with_rows.collect();
        if names.is_empty() || model.joints().is_empty() {
            continue;
        }
        let run = model.run_all(&names, &RunOptions::default(), &mut Silent).expect("runs");
        let machine = |study: &&StudyResult| !matches!(study.findings, Some(Findings::BodyModes(_)));
        for study in run.studies.iter().filter(machine) {
            let what = format!("{}, study {}", path.display(), study.name);
            assert!(study.failure.is_none(), "{what}");
            for (signal, limit) in LIMITS {
                let column = study.table.column(signal).expect("a trust signal");
                assert!(column.values.iter().all(|x| x.abs() < limit), "{what}: {signal}");
            }
        }
    }
}
