//! The two outputs: results on standard output, everything else on standard error.

use std::io::{self, ErrorKind, IsTerminal, Write};

use bellcrank_report::Style;

use crate::args::When;
use crate::exit::{Exit, Refusal};

/// Sentences are broken here when nothing says how wide the terminal is.
const WIDTH: usize = 100;

/// Where things are said, and in which clothes.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Console {
    color_out: bool,
    color_err: bool,
}

impl Console {
    /// Colours as asked for; `auto` looks at what stands behind each output.
    pub(crate) fn new(when: When) -> Self {
        let wanted = |terminal: bool| match when {
            When::Always => true,
            When::Never => false,
            When::Auto => terminal && colors_are_welcome(),
        };
        Self { color_out: wanted(io::stdout().is_terminal()), color_err: wanted(io::stderr().is_terminal()) }
    }

    /// Whether standard error takes colours.
    pub(crate) fn color_err(self) -> bool {
        self.color_err
    }

    /// How the summary is dressed.
    pub(crate) fn style(self) -> Style {
        let width = terminal_size::terminal_size().map_or(WIDTH, |(width, _)| usize::from(width.0));
        Style { color: self.color_out, width: width.max(40) }
    }

    /// Prints a result. A reader that has gone away (`| head`) is no error.
    pub(crate) fn print(self, text: &str) -> Result<(), Refusal> {
        let mut out = io::stdout().lock();
        match out.write_all(text.as_bytes()).and_then(|()| out.flush()) {
            Err(error) if error.kind() != ErrorKind::BrokenPipe => {
                Err(Refusal::command_line(format!("cannot write to standard output: {error}")))
            }
            _ => Ok(()),
        }
    }

    /// Says something beside the results. Where even that fails there is nobody to tell.
    pub(crate) fn say(self, text: &str) {
        let _ = io::stderr().lock().write_all(text.as_bytes());
    }

    /// Says why nothing was done.
    pub(crate) fn refuse(self, refusal: &Refusal) -> Exit {
        if !refusal.message.is_empty() {
            self.error(&refusal.message, &refusal.hints);
        }
        refusal.exit
    }

    /// An error and what to try, as diagnostics look.
    pub(crate) fn error(self, message: &str, hints: &[String]) {
        let (bold, plain) = if self.color_err { ("\u{1b}[1;31m", "\u{1b}[0m") } else { ("", "") };
        let hints: String = hints.iter().map(|hint| format!("hint: {}\n", visible(hint))).collect();
        self.say(&format!("{bold}error{plain}: {}\n{hints}", visible(message)));
    }
}

/// Names come from files and arguments: a control character in one must not steer the terminal.
pub(crate) fn visible(text: &str) -> String {
    text.chars().map(|c| if c.is_control() && c != '\n' { '\u{fffd}' } else { c }).collect()
}

fn colors_are_welcome() -> bool {
    let refused = std::env::var_os("NO_COLOR").is_some_and(|value| !value.is_empty());
    let dumb = std::env::var_os("TERM").is_some_and(|value| value == "dumb");
    !refused && !dumb
}
