//! What a set of prescribed coordinates leaves to be found, and the rows it adds.

use crate::mechanism::{Mechanism, Source};
use bellcrank_math::Space;

/// No place: a prescribed component is no unknown.
pub(crate) const OUT: usize = usize::MAX;

/// How a prescribed coordinate enters.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) enum Prescribed {
    /// A tree coordinate, taken out of the unknowns.
    Node(usize),
    /// A row of its own: index among all rows, and what it measures.
    Row(usize, Source),
}

/// Unknowns and rows of a linear system over the tree's velocity components.
#[derive(Clone, Debug)]
pub(crate) struct Unknowns {
    /// In the order of the sources.
    pub(crate) prescribed: Vec<Prescribed>,
    /// Place of each velocity component among the unknowns, or [`OUT`].
    pub(crate) free: Vec<usize>,
    /// Velocity component of each unknown.
    pub(crate) columns: Vec<usize>,
    /// All rows: links, couplings, prescribed rows.
    pub(crate) rows: usize,
}

impl Unknowns {
    /// Prescribed tree coordinates leave the unknowns, measured ones add a row.
    pub(crate) fn new<S: Space>(mech: &Mechanism<S>, sources: &[Source]) -> Self {
        let mut free = vec![0; mech.nv];
        let mut rows = mech.rows();
        let mut prescribed = Vec::with_capacity(sources.len());
        for s in sources {
            prescribed.push(match s {
                Source::Node(n) => {
                    free[mech.nodes[*n].v] = OUT;
                    Prescribed::Node(*n)
                }
                measured => {
                    rows += 1;
                    Prescribed::Row(rows - 1, *measured)
                }
            });
        }
        let mut columns = Vec::new();
        for (v, f) in free.iter_mut().enumerate() {
            if *f != OUT {
                *f = columns.len();
                columns.push(v);
            }
        }
        Self { prescribed, free, columns, rows }
    }
}
