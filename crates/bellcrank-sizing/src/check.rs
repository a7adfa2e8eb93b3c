//! One check: what is needed against what there is.

/// What a check is about.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Subject {
    /// Largest push.
    Push,
    /// Largest pull.
    Pull,
    /// Travel.
    Stroke,
    /// Supply pressure against the pressure limit.
    Pressure,
    /// Buckling of the piston rod.
    Buckling,
    /// Largest speed.
    Speed,
    /// Kinetic energy at the end of the stroke.
    Cushion,
    /// Flow through the valve.
    Valve,
    /// Largest effort, at the speed it is needed at.
    PeakEffort,
    /// Root mean square of the effort.
    RmsEffort,
    /// Mean power.
    RatedPower,
    /// Largest power.
    PeakPower,
}

impl Subject {
    /// Key for machines, e.g. `peak_effort`.
    pub fn key(self) -> &'static str {
        match self {
            Subject::Push => "push",
            Subject::Pull => "pull",
            Subject::Stroke => "stroke",
            Subject::Pressure => "pressure",
            Subject::Buckling => "buckling",
            Subject::Speed => "speed",
            Subject::Cushion => "cushion",
            Subject::Valve => "valve",
            Subject::PeakEffort => "peak_effort",
            Subject::RmsEffort => "rms_effort",
            Subject::RatedPower => "rated_power",
            Subject::PeakPower => "peak_power",
        }
    }
}

/// What the two numbers of a check measure, all SI.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Quantity {
    /// N.
    Force,
    /// N·m.
    Torque,
    /// m.
    Length,
    /// rad.
    Angle,
    /// m/s.
    Speed,
    /// rad/s.
    AngularSpeed,
    /// Pa.
    Pressure,
    /// J.
    Energy,
    /// W.
    Power,
    /// m³/s of free air (ANR).
    Flow,
}

/// How a check ended.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Verdict {
    /// There is enough.
    Passes,
    /// There is not.
    Fails,
    /// A number is missing; the reason says which. It stands in no candidate's way.
    NotChecked,
}

/// One check.
#[derive(Clone, Debug, PartialEq)]
pub struct Check {
    /// What it is about.
    pub subject: Subject,
    /// What the numbers measure.
    pub quantity: Quantity,
    /// What is needed, SI; NaN where that is unknown.
    pub needed: f64,
    /// What there is, SI; NaN where that is unknown.
    pub available: f64,
    /// How it ended.
    pub verdict: Verdict,
    /// In words with numbers.
    pub reason: String,
}

/// Rounding errors that a check forgives, relative.
const ROUNDING: f64 = 1e-9;

impl Check {
    /// Share of what is available that is needed; 1 is just enough. NaN where a number is unknown.
    pub fn utilization(&self) -> f64 {
        if self.needed == 0.0 { 0.0 } else { self.needed / self.available }
    }
    /// What is left, relative to what is needed: `available / needed − 1`; infinite where nothing is needed.
    pub fn margin(&self) -> f64 {
        1.0 / self.utilization() - 1.0
    }
    /// `Some(true)` passes, `Some(false)` fails, `None` was not checked.
    pub fn passes(&self) -> Option<bool> {
        match self.verdict {
            Verdict::Passes => Some(true),
            Verdict::Fails => Some(false),
            Verdict::NotChecked => None,
        }
    }
    pub(crate) fn new(subject: Subject, quantity: Quantity, needed: f64, available: f64, reason: String) -> Check {
        // A catalogue may say -0, and a share of it would be negative.
        let available = available + 0.0;
        let enough = needed <= available * (1.0 + ROUNDING) || needed == 0.0;
        let verdict = if enough { Verdict::Passes } else { Verdict::Fails };
        Check { subject, quantity, needed, available, verdict, reason }
    }
    pub(crate) fn unknown(subject: Subject, quantity: Quantity, needed: f64, available: f64, why: &str) -> Check {
        let reason = format!("not checked: {why}");
        Check { subject, quantity, needed, available, verdict: Verdict::NotChecked, reason }
    }
}
