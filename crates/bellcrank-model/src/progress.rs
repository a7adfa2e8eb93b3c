//! What a long run tells its caller, and how the caller stops it.

/// Told how far a run is; asked whether to go on.
pub trait Progress {
    /// Called before each part of the work: the share done (0 to 1) and what is being done.
    fn at(&mut self, fraction: f64, message: &str);

    /// A line for whoever watches, as the work goes on: the iterations of an optimization.
    fn line(&mut self, _text: &str) {}

    /// Asked often; the run stops soon after the answer is `true` and keeps what it has.
    fn cancelled(&self) -> bool {
        false
    }
}

/// Says nothing and never stops.
#[derive(Clone, Copy, Debug, Default)]
pub struct Silent;

impl Progress for Silent {
    fn at(&mut self, _fraction: f64, _message: &str) {}
}
