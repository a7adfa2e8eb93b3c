//! Fill-reducing orders of a graph: nested dissection.
//!
//! George (1973), "Nested dissection of a regular finite element mesh"; Karypis & Kumar (1998), "A fast and high quality
//! multilevel scheme for partitioning irregular graphs".

use feral_metis::{CscPattern, MetisOptions, metis_order_full};

use super::quotient::Lists;

/// Vertices in the order of elimination. A graph too large for the dissection's 32-bit numbers keeps its own order.
pub(super) fn order(neighbours: &Lists) -> Vec<u32> {
    dissect(neighbours).unwrap_or_else(|| (0..neighbours.len() as u32).collect())
}

fn dissect(neighbours: &Lists) -> Option<Vec<u32>> {
    let starts: Vec<i32> = neighbours.starts.iter().map(|&s| i32::try_from(s).ok()).collect::<Option<_>>()?;
    let items: Vec<i32> = neighbours.items.iter().map(|&i| i as i32).collect();
    let pattern = CscPattern::new(neighbours.len(), &starts, &items)?;
    let (order, ..) = metis_order_full(&pattern, &MetisOptions::default()).ok()?;
    let order: Vec<u32> = order.into_iter().map(|i| i as u32).collect();
    is_permutation(&order, neighbours.len()).then_some(order)
}

fn is_permutation(order: &[u32], count: usize) -> bool {
    let mut seen = vec![false; count];
    order.len() == count
        && order.iter().all(|&i| seen.get_mut(i as usize).is_some_and(|seen| !std::mem::replace(seen, true)))
}
