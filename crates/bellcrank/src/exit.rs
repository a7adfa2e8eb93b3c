//! How the program ends: the contract of `docs/errors.md`.

use std::process::ExitCode;

/// How the program ends.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// All was done.
    Done,
    /// The model file is wrong.
    Model,
    /// The command line is wrong.
    CommandLine,
    /// The mathematics failed; what was computed is kept.
    Mathematics,
    /// A fault of this program.
    Fault,
    /// Stopped by Ctrl-C; what was computed is kept.
    Interrupted,
}

impl Exit {
    /// The number that the shell sees.
    pub(crate) fn code(self) -> u8 {
        match self {
            Self::Done => 0,
            Self::Model => 1,
            Self::CommandLine => 2,
            Self::Mathematics => 3,
            Self::Fault => 70,
            // As shells report a program that was ended by SIGINT.
            Self::Interrupted => 130,
        }
    }
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit.code())
    }
}

/// Why a command was not carried out: one sentence, and what to try.
#[derive(Clone, Debug)]
pub(crate) struct Refusal {
    /// The exit that it leads to.
    pub(crate) exit: Exit,
    /// The sentence, lowercase; empty when everything has been said already.
    pub(crate) message: String,
    /// What to try.
    pub(crate) hints: Vec<String>,
}

impl Refusal {
    /// The command line is wrong.
    pub(crate) fn command_line(message: impl Into<String>) -> Self {
        Self { exit: Exit::CommandLine, message: message.into(), hints: Vec::new() }
    }

    /// The program ends here and has said why.
    pub(crate) fn said(exit: Exit) -> Self {
        Self { exit, message: String::new(), hints: Vec::new() }
    }

    /// One more thing to try.
    pub(crate) fn hint(mut self, hint: impl Into<String>) -> Self {
        self.hints.push(hint.into());
        self
    }
}
