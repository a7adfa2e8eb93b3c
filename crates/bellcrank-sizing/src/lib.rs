//! From what a drive must do to the drive one can buy: pneumatic cylinders, electric linear and
//! rotary drives.
//!
//! Plain SI numbers in, plain SI numbers and sentences out. No file, no unit, no mechanism is known
//! here; the built-in catalogues are texts that someone else reads ([`catalogue`]).
//!
//! In reading order:
//! 1. [`Duty`]: the rows a drive goes through; [`Requirement`]: what follows from them.
//! 2. [`Check`]: needed against available, with the reason in words; [`Selection`]: all candidates,
//!    those that pass first, smallest first.
//! 3. [`pneumatic`]: forces, working pressure, buckling, cushions, air, the ISO 6358 flow law, and
//!    [`pneumatic::select`].
//! 4. [`electric`]: ratings, gears, and [`electric::select`].
//!
//! ```
//! use bellcrank_sizing::pneumatic::{Conditions, Cylinder, EndCondition, Mount, Mounting, Supply, select};
//! use bellcrank_sizing::{Duty, Row};
//!
//! // A lift: 4845 N push at the bottom, 4680 N at the top, 160 mm, 20 mm/s.
//! let row = |position, effort| Row { position, effort, velocity: 0.02, acceleration: 0.0, time: None };
//! let duty = Duty::new(vec![row(0.0, 4845.0), row(0.08, 4750.0), row(0.16, 4680.0)])?;
//!
//! let cylinder = |bore, rod| {
//!     let strokes = vec![0.1, 0.16, 0.2];
//!     Cylinder { name: format!("bore {bore}"), bore, rod, strokes, ..Cylinder::bare() }
//! };
//! let mounting = Mounting { end: EndCondition::PinnedPinned, at: Mount::Rear, offset: 0.0 };
//! let conditions = Conditions::new(Supply::gauge(6e5), 0.7, mounting);
//! let found = select(&duty, &[cylinder(0.08, 0.025), cylinder(0.125, 0.032), cylinder(0.16, 0.04)], &conditions)?;
//!
//! assert_eq!(found.chosen().map(|c| c.cylinder.bore), Some(0.125));
//! let small = found.candidates.iter().find(|c| c.cylinder.bore == 0.08).unwrap();
//! assert_eq!(small.checks[0].reason, "push 3016 N × 0.7 = 2111 N, needed 4845 N at 0 mm");
//! # Ok::<(), bellcrank_sizing::SizingError>(())
//! ```

pub mod catalogue;
mod check;
mod duty;
pub mod electric;
mod error;
mod integrals;
pub mod pneumatic;
mod requirement;
mod select;
mod stroke;
mod words;

pub use check::{Check, Quantity, Subject, Verdict};
pub use duty::{Basis, Duty, Row};
pub use error::SizingError;
pub use requirement::{Motion, Peak, Requirement};
pub use select::{Candidate, Selection};
pub use stroke::Stroke;
