//! Meshes of random links; files of other programs, and what becomes of broken ones.

mod broken;
mod external;
mod files;
mod links;
mod parts;
mod random;
mod revolved;
