//! Which files are parts of a machine, and how what is wrong in them is told.

use bellcrank_doc::{Diagnostic, Diagnostics, Label, SourceId, Sources, Span};

/// The text of a subsystem, and the entries that lead to it.
#[derive(Clone, Debug)]
pub(crate) struct Mounted {
    pub(crate) source: SourceId,
    /// Full names and places of the subsystems, outermost first; the last is its own.
    pub(crate) chain: Vec<(String, Span)>,
}

/// Adds to what is wrong in a subsystem how it came into the machine. The same fault of a file that is mounted several
/// times is told once, with all its mounts.
pub(crate) fn tell(mounted: &[Mounted], sources: &Sources, diagnostics: &mut Diagnostics) {
    let of = |report: &Diagnostic| {
        let source = report.primary.as_ref()?.span.source;
        mounted.iter().find(|mounted| mounted.source == source)
    };
    diagnostics.revise(|all| {
        let mut told: Vec<Diagnostic> = Vec::with_capacity(all.len());
        for report in std::mem::take(all) {
            let Some(mounted) = of(&report) else {
                told.push(report);
                continue;
            };
            let known = told.iter_mut().find(|known| of(known).is_some() && is_same(known, &report, sources));
            match known {
                Some(known) => add(known, mounted),
                None => {
                    let mut report = report;
                    add(&mut report, mounted);
                    told.push(report);
                }
            }
        }
        *all = told;
    });
}

/// The innermost mount first: it is the nearest.
fn add(report: &mut Diagnostic, mounted: &Mounted) {
    for (name, span) in mounted.chain.iter().rev() {
        let label = Label { span: *span, message: format!("mounted as `{name}`") };
        if !report.secondary.contains(&label) {
            report.secondary.push(label);
        }
    }
}

/// Two reports of one fault of a file that was read twice.
fn is_same(a: &Diagnostic, b: &Diagnostic, sources: &Sources) -> bool {
    let place = |report: &Diagnostic| report.primary.as_ref().map(|label| label.span);
    let (Some(at), Some(to)) = (place(a), place(b)) else { return false };
    (a.code, &a.message, at.start, at.end) == (b.code, &b.message, to.start, to.end)
        && at.source != to.source
        && sources.name(at.source) == sources.name(to.source)
}
