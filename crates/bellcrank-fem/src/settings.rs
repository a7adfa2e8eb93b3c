//! How much of the machine a solution may take.

use crate::Fault;

/// Threads, memory, and whom to tell.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// Threads to use.
    pub threads: usize,
    /// Bytes that a factorization may take; `None` for as many as it wants.
    pub memory: Option<usize>,
    /// Called with the share that is done (0 to 1); `false` stops the work.
    pub progress: &'a (dyn Fn(f64) -> bool + Sync),
}

impl Default for Settings<'_> {
    /// One thread, any memory, nobody to tell.
    fn default() -> Self {
        Self { threads: 1, memory: None, progress: &|_| true }
    }
}

impl Settings<'_> {
    pub(crate) fn fits(&self, needed: usize) -> Result<(), Vec<Fault>> {
        match self.memory {
            Some(allowed) if needed > allowed => Err(vec![Fault::Memory { needed, allowed }]),
            _ => Ok(()),
        }
    }
}
