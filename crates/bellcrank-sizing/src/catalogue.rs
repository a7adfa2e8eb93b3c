//! The built-in catalogues, as texts in TOML with units. They are read where files are read; the shape is in each
//! file's head, and a user's own catalogue has the same.
//!
//! | key | goes to |
//! | --- | --- |
//! | `[series.S]`, `series = "S"` | what a whole series shares; a key of the entry itself comes first |
//! | `[cylinders.N]` | a [`crate::pneumatic::Cylinder`] of that name, its fields under the same names |
//! | `[drives.N]` | a [`crate::electric::Drive`] of that name, its fields under the same names, but: |
//! | `kind` | `linear` or `rotary`: [`crate::electric::Kind`] |
//! | `rated_force`, `rated_torque` | `rated_effort` |
//! | `peak_force`, `peak_torque` | `peak_effort` |
//! | `moving_mass`, `inertia` | `inertia` |
//! | `gear_ratio`, `gear_efficiency` | `gear`; the efficiency is 1 where it is left out |
//!
//! The numbers have their source in the files. What no source was at hand for is left out (cushion energies, largest
//! speeds, moving masses of cylinders), and the check says that it was not made.

/// Pneumatic cylinders to ISO 15552: bores 32 to 320 mm.
pub const ISO_15552: &str = include_str!("../catalogue/iso-15552.toml");
/// Pneumatic cylinders to ISO 6432: bores 8 to 25 mm.
pub const ISO_6432: &str = include_str!("../catalogue/iso-6432.toml");
/// Electric linear drives: generic sizes, no maker's data.
pub const ELECTRIC_LINEAR: &str = include_str!("../catalogue/electric-linear.toml");
/// Electric rotary drives: generic sizes, no maker's data.
pub const ELECTRIC_ROTARY: &str = include_str!("../catalogue/electric-rotary.toml");

/// All of them with their names.
pub const ALL: [(&str, &str); 4] = [
    ("iso-15552", ISO_15552),
    ("iso-6432", ISO_6432),
    ("electric-linear", ELECTRIC_LINEAR),
    ("electric-rotary", ELECTRIC_ROTARY),
];
