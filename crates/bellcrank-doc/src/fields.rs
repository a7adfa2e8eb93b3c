//! Typed reading of tables: what a schema asks, with the reports of what it did not get.

mod cursor;
mod reader;
#[cfg(test)]
mod tests;

pub use cursor::Fields;
pub use reader::Reader;
pub(crate) use reader::quoted;
