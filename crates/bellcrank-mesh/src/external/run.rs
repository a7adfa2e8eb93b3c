//! Runs a program, listens to it, and stops it when it takes too long.

use std::io::{BufRead, BufReader, Read};
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc::{RecvTimeoutError, Sender, channel};
use std::time::{Duration, Instant};

/// How it ended, and what it said.
pub(super) struct Outcome {
    pub(super) end: End,
    pub(super) lines: Vec<String>,
}

pub(super) enum End {
    Exited(ExitStatus),
    TimedOut,
    Interrupted,
}

/// Pause between two looks at the clock and at the user.
const LOOK: Duration = Duration::from_millis(100);

pub(super) fn run(
    command: &mut Command,
    timeout: Duration,
    interrupted: &dyn Fn() -> bool,
) -> std::io::Result<Outcome> {
    let mut child = command.stdin(Stdio::null()).stdout(Stdio::piped()).stderr(Stdio::piped()).spawn()?;
    let (sender, receiver) = channel();
    if let Some(out) = child.stdout.take() {
        listen(out, sender.clone());
    }
    if let Some(errors) = child.stderr.take() {
        listen(errors, sender);
    }
    let (start, mut lines) = (Instant::now(), Vec::new());
    loop {
        match receiver.recv_timeout(LOOK) {
            Ok(line) => lines.push(line),
            Err(RecvTimeoutError::Timeout) => {}
            // Both ends are closed: the program has ended, or is about to.
            Err(RecvTimeoutError::Disconnected) => return Ok(Outcome { end: End::Exited(child.wait()?), lines }),
        }
        if interrupted() {
            return stop(child, End::Interrupted, lines);
        }
        if start.elapsed() > timeout {
            return stop(child, End::TimedOut, lines);
        }
    }
}

fn stop(mut child: Child, end: End, lines: Vec<String>) -> std::io::Result<Outcome> {
    // It may have ended by itself meanwhile, which is as good.
    let _ = child.kill();
    child.wait()?;
    Ok(Outcome { end, lines })
}

/// Sends lines as they come, from a thread of its own.
fn listen(source: impl Read + Send + 'static, sender: Sender<String>) {
    std::thread::spawn(move || {
        for line in BufReader::new(source).split(b'\n').map_while(Result::ok) {
            if sender.send(String::from_utf8_lossy(&line).trim_end().to_owned()).is_err() {
                return;
            }
        }
    });
}
