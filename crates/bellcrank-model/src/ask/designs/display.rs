//! How far a sweep is, in words.

use std::time::{Duration, Instant};

use crate::progress::Progress;

/// Between two messages.
const PAUSE: Duration = Duration::from_millis(200);

/// Rows done, their rate, and the time that is left.
pub(super) struct Display {
    begun: Instant,
    told: Instant,
    resumed: u64,
    done: u64,
    total: u64,
}

impl Display {
    pub(super) fn new(resumed: u64, total: u64) -> Display {
        let now = Instant::now();
        Display { begun: now, told: now, resumed, done: resumed, total }
    }

    /// One more row.
    pub(super) fn row(&mut self, progress: &mut dyn Progress) {
        self.done += 1;
        if self.told.elapsed() < PAUSE {
            return;
        }
        self.told = Instant::now();
        let message = message(self.resumed, self.done, self.total, self.begun.elapsed().as_secs_f64());
        progress.at(self.done as f64 / self.total as f64, &message);
    }
}

fn message(resumed: u64, done: u64, total: u64, seconds: f64) -> String {
    let rate = (done - resumed) as f64 / seconds.max(1e-9);
    let left = (total - done) as f64 / rate;
    let digits = if rate < 10.0 { 1 } else { 0 };
    format!("{done} of {total} designs, {rate:.digits$}/s, {} left", duration(left))
}

fn duration(seconds: f64) -> String {
    let whole = seconds.round() as u64;
    match whole {
        0..60 => format!("{whole} s"),
        60..3600 => format!("{} min {} s", whole / 60, whole % 60),
        _ => format!("{} h {} min", whole / 3600, whole / 60 % 60),
    }
}

#[cfg(test)]
mod tests {
    use super::message;

    #[test]
    fn the_rate_is_that_of_this_run() {
        assert_eq!(message(1000, 3000, 9000, 2.0), "3000 of 9000 designs, 1000/s, 6 s left");
        assert_eq!(message(0, 3, 9000, 2.0), "3 of 9000 designs, 1.5/s, 1 h 39 min left");
    }
}
