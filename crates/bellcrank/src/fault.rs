//! Our own mistakes: caught at the top, told in two lines, exit code 70.

use std::backtrace::{Backtrace, BacktraceStatus};
use std::io::Write;
use std::panic::{self, PanicHookInfo, UnwindSafe};

use crate::exit::Exit;

/// Replaces Rust's report of a panic by ours.
pub(crate) fn install_hook() {
    panic::set_hook(Box::new(report));
}

/// Runs the program; a panic in it is a [`Exit::Fault`].
pub(crate) fn guarded(program: impl FnOnce() -> Exit + UnwindSafe) -> Exit {
    panic::catch_unwind(program).unwrap_or(Exit::Fault)
}

fn report(info: &PanicHookInfo<'_>) {
    let place = info.location().map_or_else(String::new, |at| format!(" ({}:{})", at.file(), at.line()));
    let text = text(message(info), &place);
    // `eprintln!` would panic in turn where standard error is closed.
    let mut out = std::io::stderr().lock();
    let _ = out.write_all(text.as_bytes());
    let trace = Backtrace::capture();
    if trace.status() == BacktraceStatus::Captured {
        let _ = writeln!(out, "{trace}");
    }
}

fn message<'a>(info: &'a PanicHookInfo<'_>) -> &'a str {
    let payload = info.payload();
    let text = payload.downcast_ref::<&str>().copied();
    text.or_else(|| payload.downcast_ref::<String>().map(String::as_str)).unwrap_or("no message")
}

fn text(message: &str, place: &str) -> String {
    format!(
        "error: a fault of bellcrank {}, not of your model: {message}{place}\n\
         hint: please report it at {}/issues with this line, the command and the model file\n",
        env!("CARGO_PKG_VERSION"),
        env!("CARGO_PKG_REPOSITORY"),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_panic_is_a_fault_and_nothing_else_is() {
        assert_eq!(guarded(|| panic!("on purpose")), Exit::Fault);
        assert_eq!(guarded(|| Exit::Model), Exit::Model);
    }

    #[test]
    fn the_report_names_the_place_and_what_to_do() {
        let text = text("index out of bounds", " (src/a.rs:7)");
        assert!(text.contains("index out of bounds (src/a.rs:7)"), "{text}");
        assert!(text.contains("please report it"), "{text}");
    }
}
