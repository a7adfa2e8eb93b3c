//! The verification runner on cases that are fast in a debug build; `cargo xtask verify` runs them all.

use bellcrank_model::verify::run_case;

use crate::support::root;

#[test]
fn shipped_references_are_met() {
    for case in [
        "verify/cases/four-bar-k2",
        "verify/cases/bennett-k6",
        "verify/cases/loads",
        "models/assist-manipulator",
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
