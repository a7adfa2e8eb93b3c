//! Progress of long work on standard error: a bar, only on a terminal and only when the work takes long, and lines as
//! they come (the iterations of an optimization), into files and pipes as well.

use std::io::IsTerminal;
use std::time::{Duration, Instant};

use bellcrank_model::Progress;
use indicatif::{ProgressBar, ProgressStyle};

use crate::config::Printed;
use crate::console::{Console, visible};
use crate::interrupt::Interrupt;

/// Shorter work is over before one has read that it is under way.
const PATIENCE: Duration = Duration::from_millis(500);
const STEPS: u64 = 1000;

/// What a run is told about and asks.
pub(crate) struct Watch {
    interrupt: Interrupt,
    start: Instant,
    shown: bool,
    /// Whether lines are printed.
    lines: bool,
    console: Console,
    bar: Option<ProgressBar>,
}

impl Watch {
    /// A watch that shows a bar if `printed` and the terminal allow one, and lines where somebody reads them: beside a
    /// summary always, beside JSON only on a terminal.
    pub(crate) fn new(interrupt: Interrupt, printed: Printed, console: Console) -> Self {
        let shown = printed != Printed::Nothing && std::io::stderr().is_terminal();
        let lines = shown || printed == Printed::Summary;
        Self { interrupt, start: Instant::now(), shown, lines, console, bar: None }
    }

    /// Takes the bar away.
    pub(crate) fn finish(self) {
        if let Some(bar) = self.bar {
            bar.finish_and_clear();
        }
    }
}

impl Progress for Watch {
    fn at(&mut self, fraction: f64, message: &str) {
        if !self.shown || self.start.elapsed() < PATIENCE {
            return;
        }
        let bar = self.bar.get_or_insert_with(bar);
        bar.set_position((fraction.clamp(0.0, 1.0) * STEPS as f64) as u64);
        bar.set_message(message.to_owned());
    }

    fn line(&mut self, text: &str) {
        if !self.lines {
            return;
        }
        let say = || self.console.say(&format!("{}\n", visible(text)));
        match &self.bar {
            Some(bar) => bar.suspend(say),
            None => say(),
        }
    }

    fn cancelled(&self) -> bool {
        self.interrupt.pressed()
    }
}

fn bar() -> ProgressBar {
    let style = ProgressStyle::with_template("{bar:30} {percent:>3} % {msg}");
    ProgressBar::new(STEPS).with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar()))
}
