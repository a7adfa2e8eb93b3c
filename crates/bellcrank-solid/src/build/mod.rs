//! From a link to a stack.

mod check;
mod connection;
mod dissolve;
mod fillet;
mod integrals;
mod layout;
mod recipe;
mod scale;

use bellcrank_math::Real;

use crate::{Bore, Cell, Fault, Link, Stack};
use connection::Table;
use layout::{Filling, Layout, lay_out};
use recipe::{Kind, Recipe};
use scale::Scale;

impl<T: Real> Link<T> {
    /// The solid of the link. Decisions are made on values; coordinates and moments carry derivatives.
    ///
    /// Fails with everything wrong at one level: numbers first, then sizes and outlines, then fillets, then what is
    /// in several pieces. What is only suspicious is in [`Stack::warnings`].
    pub fn build(&self) -> Result<Stack<T>, Vec<Fault>> {
        let scale = self.checked()?;
        let mut recipe = Recipe::new(self, scale);
        let mut layout = lay_out(&recipe, scale.tolerance);
        if let Some(radius) = self.fillet.filter(|r| r.value() > 0.0) {
            let faults = fillet::add_fillets(&mut recipe, &layout, radius, scale.tolerance);
            if !faults.is_empty() {
                return Err(faults);
            }
            layout = lay_out(&recipe, scale.tolerance);
        }
        self.stack(&recipe, &layout, scale)
    }

    fn checked(&self) -> Result<Scale, Vec<Fault>> {
        let faults = check::not_finite(self);
        if !faults.is_empty() {
            return Err(faults);
        }
        let scale = scale::scale(self).map_err(|fault| vec![fault])?;
        let faults = check::faults(self, scale);
        if faults.is_empty() { Ok(scale) } else { Err(faults) }
    }

    fn stack(&self, recipe: &Recipe<T>, layout: &Layout<T>, scale: Scale) -> Result<Stack<T>, Vec<Fault>> {
        let filling = Filling { pieces: &recipe.pieces, levels: &layout.levels, joined_only: false };
        let intervals = 0..layout.levels.count();
        let filled = |bits: &Vec<bool>| intervals.clone().map(|k| filling.filled(bits, k)).collect();
        let table: Table = layout.within.iter().map(filled).collect();
        let faults = connection::faults(layout, &table);
        if !faults.is_empty() {
            return Err(faults);
        }
        let moments = integrals::moments(layout, &filling, scale.middle);
        let remains = dissolve::dissolve(layout, &filling, &table, scale.tolerance);
        let (levels, cells) = trimmed(&layout.levels.heights, remains.cells);
        Ok(Stack {
            vertices: remains.vertices,
            edges: remains.edges,
            cells,
            levels,
            bores: self.bores(),
            moments,
            warnings: warnings(recipe, layout),
        })
    }

    fn bores(&self) -> Vec<Bore<T>> {
        let bored = self.eyes.iter().enumerate().filter(|(_, eye)| eye.bore.value() > 0.0);
        bored
            .map(|(i, eye)| Bore { eye: i, center: eye.center, diameter: eye.bore, layers: eye.layers.clone() })
            .collect()
    }
}

/// Levels at which something begins or ends, and cells with the intervals between them.
fn trimmed<T: Real>(levels: &[T], cells: Vec<Cell>) -> (Vec<T>, Vec<Cell>) {
    let filled = |cell: &Cell, interval: Option<usize>| interval.is_some_and(|i| cell.filled.get(i) == Some(&true));
    let changes = |level: &usize| cells.iter().any(|c| filled(c, level.checked_sub(1)) != filled(c, Some(*level)));
    let kept: Vec<usize> = (0..levels.len()).filter(changes).collect();
    let intervals = &kept[..kept.len().saturating_sub(1)];
    let heights = kept.iter().map(|level| levels[*level]).collect();
    let thin = |cell: &Cell| intervals.iter().map(|i| cell.filled[*i]).collect();
    let cells = cells.iter().map(|cell| Cell { loops: cell.loops.clone(), filled: thin(cell) }).collect();
    (heights, cells)
}

/// What is suspicious about the cuts.
fn warnings<T: Real>(recipe: &Recipe<T>, layout: &Layout<T>) -> Vec<Fault> {
    let joined = Filling { pieces: &recipe.pieces, levels: &layout.levels, joined_only: true };
    let mut faults = Vec::new();
    for (i, piece) in recipe.pieces.iter().enumerate() {
        let Kind::Cut(cut) = piece.kind else { continue };
        let inside = layout.within.iter().filter(|bits| piece.holds(bits));
        let met: Vec<(&Vec<bool>, usize)> = inside
            .flat_map(|bits| (0..layout.levels.count()).map(move |k| (bits, k)))
            .filter(|(bits, k)| layout.levels.active(i, *k) && joined.filled(bits, *k))
            .collect();
        if met.is_empty() {
            faults.push(Fault::CutRemovesNothing { cut });
        }
        faults.extend(eyes_cut(recipe, layout, &met).into_iter().map(|eye| Fault::CutInEye { cut, eye }));
    }
    faults
}

/// Eyes that have some of their ring among these cells and intervals.
fn eyes_cut<T: Real>(recipe: &Recipe<T>, layout: &Layout<T>, met: &[(&Vec<bool>, usize)]) -> Vec<usize> {
    let mut eyes = Vec::new();
    for (p, piece) in recipe.pieces.iter().enumerate() {
        let Kind::Joined(crate::Part::Eye(eye)) = piece.kind else { continue };
        let bore = recipe.pieces.iter().find(|b| b.kind == Kind::Bore(eye)).map(|b| b.outline);
        let ring = |bits: &Vec<bool>| piece.holds(bits) && !bore.is_some_and(|b| bits[b]);
        if met.iter().any(|(bits, k)| layout.levels.active(p, *k) && ring(bits)) {
            eyes.push(eye);
        }
    }
    eyes
}
