//! How much of the machine a solution may take.

/// Threads, memory, and whom to tell.
#[derive(Clone, Copy)]
pub struct Settings<'a> {
    /// Threads to use.
    pub threads: usize,
    /// Bytes that a factorization may take; `None` for as many as it wants. Statics goes over to conjugate gradients
    /// where the factor takes more.
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
    /// Whether so many bytes may be taken; what is needed and what is allowed where not.
    pub(crate) fn fits(&self, needed: usize) -> Result<(), (usize, usize)> {
        match self.memory {
            Some(allowed) if needed > allowed => Err((needed, allowed)),
            _ => Ok(()),
        }
    }
}
