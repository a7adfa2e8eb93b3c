use std::fs;
use std::path::PathBuf;

use bellcrank_report::{Exports, ReportError, figures, write_report, write_run};

use crate::markup::assert_balanced;
use crate::sample::{lift, stewart};

/// A folder of this test's own, empty.
fn folder(name: &str) -> PathBuf {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-{name}", std::process::id()));
    let _ = fs::remove_dir_all(&dir);
    dir
}

#[test]
fn a_run_leaves_these_files() {
    let dir = folder("run");
    let written = write_run(&lift::run(), &dir, Exports::default()).unwrap();
    assert_eq!(written[0], dir.join("report.html"));
    for name in ["report.html", "lift/series.csv", "lift/summary.json", "massless/plots/drive-force.svg"] {
        assert!(dir.join(name).is_file(), "{name}");
        assert!(written.contains(&dir.join(name)), "{name}");
    }
    let series = fs::read_to_string(dir.join("lift/series.csv")).unwrap();
    assert!(series.starts_with("joint.B.position [deg],joint.B.velocity [deg/s],"));
    assert_eq!(series.lines().count(), 602);
    let summary: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(dir.join("massless/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["signals"]["drive.slide.force"]["max"]["at"]["joint.B.position"], -30.0);
    fs::remove_dir_all(dir).unwrap();
}

#[test]
fn a_folder_that_cannot_be_made_is_named() {
    let dir = folder("blocked");
    fs::write(&dir, "a file stands here").unwrap();
    let error = write_report(&lift::run(), &dir).unwrap_err();
    assert!(matches!(&error, ReportError::Folder { path, .. } if *path == dir));
    assert!(error.to_string().contains("cannot make the folder"));
    fs::remove_file(dir).unwrap();
}

#[test]
fn plots_are_whole_and_small() {
    for run in [lift::run(), lift::troubled(), stewart::run()] {
        for figure in run.studies.iter().flat_map(figures) {
            assert_balanced(&figure.svg);
            assert!(figure.svg.len() < 25_000, "{}: {}", figure.stem, figure.svg.len());
            assert!(!figure.svg.contains("NaN") && !figure.svg.contains("inf"), "{}", figure.stem);
        }
    }
}

#[test]
fn each_quantity_and_each_pin_has_its_figure() {
    let run = lift::run();
    let stems: Vec<String> = figures(&run.studies[0]).into_iter().map(|figure| figure.stem).collect();
    for stem in ["position-deg", "position-mm", "velocity-deg_s", "acceleration-mm_s_2", "drive-force", "reaction"] {
        assert!(stems.iter().any(|found| found == stem), "{stem} among {stems:?}");
    }
    for joint in ["O", "B", "A", "E", "H", "N"] {
        assert!(stems.contains(&format!("hodograph-{joint}-fy")), "{joint}");
    }
}
