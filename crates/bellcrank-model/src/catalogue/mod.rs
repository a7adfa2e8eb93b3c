//! Drives that can be bought: the built-in catalogues of [`bellcrank_sizing::catalogue`], and files of users.

mod entry;
mod read;
#[cfg(test)]
mod tests;

use std::sync::OnceLock;

use bellcrank_doc::{Diagnostics, Sources};
use bellcrank_sizing::catalogue::ALL;
use bellcrank_sizing::electric::Drive;
use bellcrank_sizing::pneumatic::Cylinder;

pub(crate) use entry::Allowed;
pub(crate) use read::stock;

/// What there is to choose from.
#[derive(Clone, Debug, Default, PartialEq)]
pub(crate) struct Stock {
    pub(crate) cylinders: Vec<Cylinder>,
    pub(crate) drives: Vec<Drive>,
}

impl Stock {
    /// The built-in catalogues.
    pub(crate) fn builtin() -> &'static Stock {
        static BUILTIN: OnceLock<Stock> = OnceLock::new();
        BUILTIN.get_or_init(|| {
            let mut sources = Sources::new();
            let mut diagnostics = Diagnostics::new();
            let mut all = Stock::default();
            for (name, text) in ALL {
                let id = sources.add(name, text);
                all.add(stock(&sources, id, &mut diagnostics).unwrap_or_default());
            }
            assert!(diagnostics.is_empty(), "a built-in catalogue:\n{}", diagnostics.render(&sources, false));
            all
        })
    }

    /// Adds entries; one of the same name takes the place of the old one.
    pub(crate) fn add(&mut self, more: Stock) {
        self.cylinders.retain(|old| more.cylinders.iter().all(|new| new.name != old.name));
        self.cylinders.extend(more.cylinders);
        self.drives.retain(|old| more.drives.iter().all(|new| new.name != old.name));
        self.drives.extend(more.drives);
    }
}
