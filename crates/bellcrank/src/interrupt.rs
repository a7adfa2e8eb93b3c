//! Ctrl-C: the first asks the run to stop and keep what it has, the second ends the program.

use std::sync::Arc;
use std::sync::atomic::{AtomicBool, Ordering};

use crate::exit::Exit;

/// Whether Ctrl-C was pressed.
#[derive(Clone, Debug, Default)]
pub(crate) struct Interrupt {
    pressed: Arc<AtomicBool>,
}

impl Interrupt {
    /// Starts listening. Where that is impossible Ctrl-C ends the program as it always did; files are whole either way.
    pub(crate) fn listen() -> Self {
        let interrupt = Self::default();
        let heard = interrupt.clone();
        let _ = ctrlc::set_handler(move || heard.press());
        interrupt
    }

    /// Whether it was pressed.
    pub(crate) fn pressed(&self) -> bool {
        self.pressed.load(Ordering::Relaxed)
    }

    fn press(&self) {
        if self.pressed.swap(true, Ordering::Relaxed) {
            end_at_once();
        }
    }
}

#[expect(clippy::disallowed_methods, reason = "the second Ctrl-C must end a run that does not listen to the first")]
fn end_at_once() -> ! {
    std::process::exit(Exit::Interrupted.code().into())
}
