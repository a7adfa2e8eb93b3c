//! Wöhler line: cycles to failure for an amplitude at R = −1, straight in logarithms with a knee.

/// How damage goes on below the amplitude at the knee.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Beyond {
    /// No damage (original Miner). Unsafe where larger cycles have begun a crack.
    Infinite,
    /// The same slope (elementary Miner).
    Elementary,
    /// Slope 2k − 1 (modified Miner after Haibach).
    Haibach,
}

/// N = N_D (a / a_D)^−k down to the knee.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Woehler {
    /// Amplitude a_D at the knee, Pa.
    pub amplitude: f64,
    /// Cycles N_D at the knee.
    pub cycles: f64,
    /// Slope k.
    pub slope: f64,
    /// Below the knee.
    pub beyond: Beyond,
}

/// Why numbers make no line: the one that is not positive.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum WoehlerFault {
    /// Amplitude at the knee, Pa.
    Amplitude(f64),
    /// Cycles at the knee.
    Cycles(f64),
    /// A slope below 1.
    Slope(f64),
}

impl Woehler {
    /// A line whose numbers make sense.
    ///
    /// # Errors
    /// The first number that does not.
    pub fn new(amplitude: f64, cycles: f64, slope: f64, beyond: Beyond) -> Result<Self, WoehlerFault> {
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !positive(amplitude) {
            return Err(WoehlerFault::Amplitude(amplitude));
        }
        if !positive(cycles) {
            return Err(WoehlerFault::Cycles(cycles));
        }
        if !(slope >= 1.0 && slope.is_finite()) {
            return Err(WoehlerFault::Slope(slope));
        }
        Ok(Self { amplitude, cycles, slope, beyond })
    }

    /// Slope below the knee of amplitudes.
    fn low_slope(&self) -> f64 {
        match self.beyond {
            Beyond::Infinite => f64::INFINITY,
            Beyond::Elementary => self.slope,
            Beyond::Haibach => 2.0 * self.slope - 1.0,
        }
    }

    /// Cycles to failure; infinite where there is no damage.
    pub fn cycles_at(&self, amplitude: f64) -> f64 {
        1.0 / self.damage(amplitude)
    }

    /// Damage of one cycle, 1/N.
    pub fn damage(&self, amplitude: f64) -> f64 {
        let ratio = amplitude / self.amplitude;
        let slope = if ratio >= 1.0 { self.slope } else { self.low_slope() };
        // 0^∞ = 0, and so is any ratio below 1 to the power of ∞.
        ratio.powf(slope) / self.cycles
    }

    /// Amplitude that fails after so many cycles; beyond the knee of a line without damage there, as if its slope went on.
    pub fn amplitude_at(&self, cycles: f64) -> f64 {
        let low = if self.beyond == Beyond::Infinite { self.slope } else { self.low_slope() };
        let slope = if cycles <= self.cycles { self.slope } else { low };
        self.amplitude * (self.cycles / cycles).powf(1.0 / slope)
    }
}
