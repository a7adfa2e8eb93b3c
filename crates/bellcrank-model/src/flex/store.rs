//! Reductions at hand: made once for all studies of a model, whatever thread asks first.

use std::path::PathBuf;
use std::sync::{Arc, Mutex, MutexGuard, PoisonError};

use super::recipe::{Key, Recipe};
use super::{Reduced, cache, make};
use crate::RunOptions;
use crate::design::{Design, Flexible, Values};
use crate::elastic::End;
use crate::progress::Progress;

/// Reductions of other numbers that are kept in memory: an optimization comes back to few.
const KEPT: usize = 16;

/// Where a reduction comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Origin {
    Made,
    Cache,
}

/// A reduction, and what there is to say of where it comes from.
#[derive(Clone, Debug)]
pub(crate) struct Found {
    pub(crate) reduced: Arc<Reduced>,
    pub(crate) origin: Origin,
    /// A file of the cache that was of no use, or could not be written.
    pub(crate) notes: Vec<String>,
}

/// Locked while the reduction is made, so that others wait for it.
type Slot = Arc<Mutex<Option<Found>>>;

/// The reductions of a design.
#[derive(Debug, Default)]
pub(crate) struct Store {
    /// The one used last at the end.
    kept: Mutex<Vec<(Key, Slot)>>,
    how: Mutex<How>,
}

/// How reductions are made.
#[derive(Clone, Debug, Default)]
struct How {
    /// Where they outlive the run.
    folder: Option<PathBuf>,
    /// 0 is one a core.
    threads: usize,
}

/// What a panic of another thread leaves is whole: values are put in place in one go.
fn locked<T>(mutex: &Mutex<T>) -> MutexGuard<'_, T> {
    mutex.lock().unwrap_or_else(PoisonError::into_inner)
}

impl Store {
    /// Chooses how what is not at hand yet is made, and the folder that it is kept in from run to run.
    pub(crate) fn set(&self, options: &RunOptions) {
        *locked(&self.how) = How { folder: options.cache.clone(), threads: options.threads };
    }

    /// The reduction of a flexible solid at some values.
    pub(super) fn get(
        &self,
        design: &Design,
        values: &Values,
        body: usize,
        form: &Flexible,
        progress: &mut dyn Progress,
    ) -> Result<Found, End> {
        let recipe = Recipe::new(design, values, body, form)?;
        let key = recipe.key();
        let slot = self.slot(key);
        let mut place = locked(&slot);
        if let Some(found) = &*place {
            return Ok(found.clone());
        }
        let name = &design.bodies[body].name;
        let found = self.find(&recipe, key, name, design, progress)?;
        *place = Some(found.clone());
        Ok(found)
    }

    /// Gives up what is at hand: reductions of fine meshes are large.
    pub(crate) fn clear(&self) {
        locked(&self.kept).clear();
    }

    /// Puts at hand what is known already.
    pub(super) fn put(
        &self,
        design: &Design,
        values: &Values,
        body: usize,
        form: &Flexible,
        reduced: Reduced,
    ) -> Result<(), End> {
        let key = Recipe::new(design, values, body, form)?.key();
        let found = Found { reduced: Arc::new(reduced), origin: Origin::Made, notes: Vec::new() };
        *locked(&self.slot(key)) = Some(found);
        Ok(())
    }

    fn slot(&self, key: Key) -> Slot {
        let mut kept = locked(&self.kept);
        let slot = match kept.iter().position(|(of, _)| *of == key) {
            Some(place) => kept.remove(place).1,
            None => Slot::default(),
        };
        kept.push((key, Arc::clone(&slot)));
        if kept.len() > KEPT {
            kept.remove(0);
        }
        slot
    }

    fn find(
        &self,
        recipe: &Recipe,
        key: Key,
        name: &str,
        design: &Design,
        progress: &mut dyn Progress,
    ) -> Result<Found, End> {
        let How { folder, threads } = locked(&self.how).clone();
        let threads = match threads {
            0 => std::thread::available_parallelism().map_or(1, std::num::NonZero::get),
            threads => threads,
        };
        let mut notes = Vec::new();
        if let Some(folder) = &folder {
            progress.at(0.0, &format!("{name}: looking into the cache"));
            match cache::load(folder, key) {
                Ok(Some(reduced)) => {
                    let reduced = Arc::new(reduced.with_regions(recipe));
                    return Ok(Found { reduced, origin: Origin::Cache, notes });
                }
                Ok(None) => {}
                Err(fault) => notes.push(format!("the reduction of body `{name}` was made again: {fault}")),
            }
        }
        let reduced = make::reduced(recipe, name, design, threads, progress)?;
        if let Some(folder) = &folder
            && let Err(fault) = cache::save(folder, key, &reduced)
        {
            notes.push(format!("the reduction of body `{name}` was not kept: {fault}"));
        }
        Ok(Found { reduced: Arc::new(reduced.with_regions(recipe)), origin: Origin::Made, notes })
    }
}
