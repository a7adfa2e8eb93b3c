//! Long work on a thread of its own, while this one tells how far it is and asks whether to go on.

use std::sync::atomic::{AtomicBool, AtomicU64, Ordering};
use std::time::Duration;

use crate::progress::Progress;

/// How often is asked.
const PAUSE: Duration = Duration::from_millis(50);

/// Does the work; its progress counts from one share of the study to another.
pub(crate) fn watched<T: Send>(
    progress: &mut dyn Progress,
    [from, to]: [f64; 2],
    message: &str,
    work: impl FnOnce(&(dyn Fn(f64) -> bool + Sync)) -> T + Send,
) -> T {
    let (share, stop) = (AtomicU64::new(0.0_f64.to_bits()), AtomicBool::new(false));
    let tell = |done: f64| {
        share.store(done.to_bits(), Ordering::Relaxed);
        !stop.load(Ordering::Relaxed)
    };
    let caller = std::thread::current();
    std::thread::scope(|scope| {
        let worker = scope.spawn(|| {
            let done = work(&tell);
            caller.unpark();
            done
        });
        while !worker.is_finished() {
            progress.at(from + (to - from) * f64::from_bits(share.load(Ordering::Relaxed)), message);
            if progress.cancelled() {
                stop.store(true, Ordering::Relaxed);
            }
            std::thread::park_timeout(PAUSE);
        }
        worker.join().unwrap_or_else(|panic| std::panic::resume_unwind(panic))
    })
}
