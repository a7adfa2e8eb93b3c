//! The built-in catalogues, as texts in TOML with units. They are read where files are read; the shape is in each
//! file's head, and a user's own catalogue has the same.
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
