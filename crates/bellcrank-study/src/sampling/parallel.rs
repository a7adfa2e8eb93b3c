//! Many evaluations on several threads, delivered in order.
//!
//! Rows are computed in chunks; a thread takes the next chunk as long as it is not too far ahead of what was delivered, so
//! memory stays bounded, and the sink sees the same rows in the same order for any number of threads.

use std::ops::Range;
use std::panic::{AssertUnwindSafe, catch_unwind, resume_unwind};
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// Rows a thread computes at a time, unless said otherwise.
const CHUNK: u64 = 64;
/// Chunks that may wait for delivery, for each thread.
const AHEAD: u64 = 4;

/// Evaluates `rows` on `threads` threads (zero counts as one) and gives them to `sink` strictly in order, on the calling
/// thread. `worker` makes the state of a thread; `evaluate` must depend on the row alone. Returns how many rows were
/// delivered: fewer than asked if `cancel` was set or the sink said `false`; what was delivered has no gaps.
///
/// # Panics
///
/// A panic in `worker`, `evaluate` or `sink` ends all threads and goes on in the caller.
pub fn for_each_ordered<S, T: Send>(
    rows: Range<u64>,
    threads: usize,
    cancel: &AtomicBool,
    worker: impl Fn() -> S + Sync,
    evaluate: impl Fn(&mut S, u64) -> T + Sync,
    sink: impl FnMut(u64, T) -> bool,
) -> u64 {
    for_each_in_chunks(rows, threads, CHUNK, cancel, worker, evaluate, sink)
}

/// As [`for_each_ordered`], with so many rows in a chunk (zero counts as one): a thread delivers them together, so that rows
/// that take long come in smaller chunks. The rows are the same for any chunk.
///
/// # Panics
///
/// As [`for_each_ordered`].
pub fn for_each_in_chunks<S, T: Send>(
    rows: Range<u64>,
    threads: usize,
    chunk: u64,
    cancel: &AtomicBool,
    worker: impl Fn() -> S + Sync,
    evaluate: impl Fn(&mut S, u64) -> T + Sync,
    mut sink: impl FnMut(u64, T) -> bool,
) -> u64 {
    if threads <= 1 {
        return alone(rows, cancel, &mut worker(), evaluate, sink);
    }
    let size = chunk.max(1);
    let desk = Desk::new(&rows, threads, size);
    let work = || {
        let outcome = catch_unwind(AssertUnwindSafe(|| {
            let mut state = worker();
            while let Some(chunk) = desk.next_chunk(cancel) {
                let from = rows.start + chunk * size;
                let to = from.saturating_add(size).min(rows.end);
                desk.put(chunk, (from..to).map(|row| evaluate(&mut state, row)).collect());
            }
        }));
        desk.leave(outcome.err());
    };
    std::thread::scope(|scope| {
        (0..threads).for_each(|_| drop(scope.spawn(work)));
        let delivered = catch_unwind(AssertUnwindSafe(|| deliver(&desk, &rows, cancel, &mut sink)));
        desk.stop();
        match (delivered, desk.panic()) {
            (Ok(count), None) => count,
            (Err(panic), _) | (Ok(_), Some(panic)) => resume_unwind(panic),
        }
    })
}

fn alone<S, T>(
    rows: Range<u64>,
    cancel: &AtomicBool,
    state: &mut S,
    evaluate: impl Fn(&mut S, u64) -> T,
    mut sink: impl FnMut(u64, T) -> bool,
) -> u64 {
    let first = rows.start;
    for row in rows.clone() {
        if cancel.load(Ordering::Relaxed) {
            return row - first;
        }
        let value = evaluate(state, row);
        if !sink(row, value) {
            return row - first + 1;
        }
    }
    rows.end.saturating_sub(first)
}

fn deliver<T>(desk: &Desk<T>, rows: &Range<u64>, cancel: &AtomicBool, sink: &mut impl FnMut(u64, T) -> bool) -> u64 {
    let mut delivered = 0;
    while let Some(chunk) = desk.take(cancel) {
        for value in chunk {
            if cancel.load(Ordering::Relaxed) {
                return delivered;
            }
            delivered += 1;
            if !sink(rows.start + delivered - 1, value) {
                return delivered;
            }
        }
    }
    delivered
}

type Panic = Box<dyn std::any::Any + Send>;

/// What the threads share.
struct Desk<T> {
    shared: Mutex<Shared<T>>,
    changed: Condvar,
    chunks: u64,
    ahead: u64,
}

struct Shared<T> {
    /// Next chunk that nobody computes yet.
    next: u64,
    /// Next chunk to deliver.
    wanted: u64,
    /// Chunk k waits at k modulo the length.
    waiting: Vec<Option<Vec<T>>>,
    working: usize,
    stopped: bool,
    panic: Option<Panic>,
}

impl<T> Desk<T> {
    fn new(rows: &Range<u64>, threads: usize, chunk: u64) -> Self {
        let chunks = rows.end.saturating_sub(rows.start).div_ceil(chunk);
        let ahead = AHEAD * threads as u64;
        let waiting = (0..ahead).map(|_| None).collect();
        let shared = Shared { next: 0, wanted: 0, waiting, working: threads, stopped: false, panic: None };
        Self { shared: Mutex::new(shared), changed: Condvar::new(), chunks, ahead }
    }

    fn lock(&self) -> MutexGuard<'_, Shared<T>> {
        self.shared.lock().unwrap_or_else(PoisonError::into_inner)
    }

    fn wait<'a>(&self, shared: MutexGuard<'a, Shared<T>>) -> MutexGuard<'a, Shared<T>> {
        self.changed.wait(shared).unwrap_or_else(PoisonError::into_inner)
    }

    /// The next chunk to compute, when there is room for it; `None` at the end.
    fn next_chunk(&self, cancel: &AtomicBool) -> Option<u64> {
        let mut shared = self.lock();
        loop {
            if shared.stopped || shared.next >= self.chunks || cancel.load(Ordering::Relaxed) {
                return None;
            }
            if shared.next < shared.wanted + self.ahead {
                shared.next += 1;
                return Some(shared.next - 1);
            }
            shared = self.wait(shared);
        }
    }

    fn put(&self, chunk: u64, values: Vec<T>) {
        let mut shared = self.lock();
        shared.waiting[(chunk % self.ahead) as usize] = Some(values);
        if chunk == shared.wanted {
            self.changed.notify_all();
        }
    }

    /// The next chunk in order; `None` when all are delivered, or will never come.
    fn take(&self, cancel: &AtomicBool) -> Option<Vec<T>> {
        let mut shared = self.lock();
        loop {
            let place = (shared.wanted % self.ahead) as usize;
            if cancel.load(Ordering::Relaxed) {
                return None;
            }
            if let Some(values) = shared.waiting[place].take() {
                shared.wanted += 1;
                self.changed.notify_all();
                return Some(values);
            }
            if shared.working == 0 || shared.panic.is_some() {
                return None;
            }
            shared = self.wait(shared);
        }
    }

    fn leave(&self, panic: Option<Panic>) {
        let mut shared = self.lock();
        shared.working -= 1;
        shared.stopped |= panic.is_some();
        shared.panic = shared.panic.take().or(panic);
        self.changed.notify_all();
    }

    fn stop(&self) {
        self.lock().stopped = true;
        self.changed.notify_all();
    }

    fn panic(&self) -> Option<Panic> {
        self.lock().panic.take()
    }
}

#[cfg(test)]
mod tests;
