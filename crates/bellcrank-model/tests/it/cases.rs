//! The verification runner on cases that are fast in a debug build; `cargo xtask verify` runs them all.

use bellcrank_model::verify::{case_name, run_case};

use crate::support::{model_of, root};

#[test]
fn shipped_references_are_met() {
    for case in [
        "verify/cases/four-bar-k2",
        "verify/cases/bennett-k6",
        "verify/cases/loads",
        "models/assist-manipulator",
        "models/assist-manipulator/machine.expected.toml",
        "models/assist-manipulator/lift-solids.expected.toml",
        "verify/cases/slider-crank-tolerance",
        "verify/cases/four-bar-tolerance",
    ] {
        let report = run_case(&root().join(case));
        let failed: Vec<_> = report.comparisons.iter().filter(|c| !c.passed).collect();
        assert!(report.passed(), "{case}: {:?} {failed:?}", report.faults);
    }
}

#[test]
fn a_folder_without_a_reference_is_a_fault() {
    assert!(!run_case(&root().join("docs")).passed());
}

#[test]
fn a_folder_may_hold_the_references_of_several_models() {
    let named = |path: &str| case_name(&root().join(path));
    assert_eq!(named("models/lamp"), "lamp");
    assert_eq!(named("models/lamp/expected.toml"), "lamp");
    assert_eq!(named("models/assist-manipulator/machine.expected.toml"), "assist-manipulator/machine");
}

/// A part of mass 0 that is welded on, and parameters that a subsystem has for its own studies, are nothing to remark.
#[test]
fn nothing_is_suspicious_about_the_whole_machine() {
    let notes = model_of(&root().join("models/assist-manipulator/machine.toml")).check().notes;
    assert!(notes.is_empty(), "{notes:?}");
}
