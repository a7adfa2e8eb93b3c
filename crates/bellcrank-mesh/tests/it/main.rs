//! Meshes of random links; files of other programs, and what becomes of broken ones.

mod broken;
mod external;
mod files;
mod links;
#[path = "../../../bellcrank-solid/tests/it/parts.rs"]
mod parts;
#[path = "../../../bellcrank-solid/tests/it/random.rs"]
mod random;
mod revolved;
