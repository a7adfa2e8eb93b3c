//! Every verification case and every shipped machine against its reference numbers.

use std::collections::BTreeMap;
use std::fmt::Write;
use std::panic::catch_unwind;
use std::path::{Path, PathBuf};

use bellcrank_model::verify::{CaseReport, Comparison, case_name, run_case};

use crate::shell::{Outcome, files, root};

const PAGE: &str = "docs/validation/verification.md";

/// Prints the worst number of each case and what went wrong; `--page` writes the page with all of them. Names choose
/// among the cases.
pub(crate) fn run(arguments: &[String]) -> Outcome {
    let names: Vec<&String> = arguments.iter().filter(|argument| !argument.starts_with("--")).collect();
    let chosen = |case: &PathBuf| names.is_empty() || names.iter().any(|name| case_name(case) == **name);
    let reports: Vec<CaseReport> = cases().into_iter().filter(chosen).map(|case| told(&case)).collect();
    println!("{}", counts(&reports));
    if names.is_empty() && arguments.iter().any(|argument| argument == "--page") {
        std::fs::write(root().join(PAGE), page(&reports)).map_err(|error| format!("{PAGE}: {error}"))?;
    }
    match reports.iter().filter(|report| !report.passed()).count() {
        0 => Ok(()),
        failed => Err(format!("{failed} of {} cases failed", reports.len())),
    }
}

/// Runs a case and prints its line at once; a panic in one does not hide the others.
fn told(case: &Path) -> CaseReport {
    let report = catch_unwind(|| run_case(case)).unwrap_or_else(|_| CaseReport {
        name: case_name(case),
        faults: vec!["the program panicked".to_owned()],
        ..CaseReport::default()
    });
    print!("{}", line(&report));
    report
}

/// Files with reference numbers, cases first.
fn cases() -> Vec<PathBuf> {
    let mut cases = files(&root().join("verify/cases"), &|name| name == "reference.toml");
    cases.extend(files(&root().join("models"), &|name| name == "expected.toml" || name.ends_with(".expected.toml")));
    cases
}

fn line(report: &CaseReport) -> String {
    let word = if report.passed() { "ok    " } else { "FAILED" };
    let used = report.comparisons.iter().map(share).fold(0.0, f64::max);
    let numbers = report.comparisons.len();
    let mut text = format!(
        "{word} {:<28} {:<12} {numbers:>4} numbers, worst {:>5.1} % of its tolerance\n",
        report.name,
        report.kind,
        1e2 * used
    );
    for fault in &report.faults {
        let _ = writeln!(text, "       {fault}");
    }
    for wrong in report.comparisons.iter().filter(|comparison| !comparison.passed) {
        let _ = writeln!(text, "       {}", sentence(wrong));
    }
    text
}

/// Error as a share of what is allowed. No allowance and no error is none of it.
fn share(of: &Comparison) -> f64 {
    if of.error == 0.0 { 0.0 } else { of.error / of.allowed }
}

fn sentence(of: &Comparison) -> String {
    let Comparison { study, what, value, reference, unit, error, allowed, .. } = of;
    format!("{study}: {what} is {value} {unit}, reference {reference}, error {error:.1e}, allowed {allowed:.1e}")
}

/// Cases by kind of truth: a regression says "unchanged", not "right", and is counted apart.
fn counts(reports: &[CaseReport]) -> String {
    let mut kinds: BTreeMap<&str, (usize, usize)> = BTreeMap::new();
    for report in reports {
        let kind = kinds.entry(&report.kind).or_default();
        *kind = (kind.0 + 1, kind.1 + report.comparisons.len());
    }
    let parts = kinds.iter().map(|(kind, (cases, numbers))| format!("{kind} {cases} cases, {numbers} numbers"));
    parts.collect::<Vec<_>>().join("; ")
}

fn page(reports: &[CaseReport]) -> String {
    let mut text = format!(
        "# Verification\n\nWritten by `cargo xtask verify --page`. Every case says where its truth comes from; a regression \
         says \"unchanged\", not \"right\".\n\n{}.\n",
        counts(reports)
    );
    for report in reports {
        let _ = write!(text, "\n## {}\n\n{}: {}\n\n", report.name, report.kind, report.source);
        text.push_str("| study | what | value | reference | unit | error | allowed |\n|---|---|---|---|---|---|---|\n");
        report.comparisons.iter().for_each(|comparison| text.push_str(&row(comparison)));
        report.faults.iter().for_each(|fault| text.push_str(&format!("\n{fault}\n")));
    }
    text
}

fn row(of: &Comparison) -> String {
    let Comparison { study, what, value, reference, unit, error, allowed, passed } = of;
    let word = if *passed { "" } else { " **failed**" };
    format!("| {study} | {what} | {value} | {reference} | {unit} | {error:.1e}{word} | {allowed:.1e} |\n")
}
