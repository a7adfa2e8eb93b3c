//! Whether a filled layout is one piece that hangs together in faces.

use bellcrank_math::Real;

use super::layout::Layout;
use crate::Fault;
use crate::plane::faces::{Union, fans};

/// For each cell and the outside, for each interval, whether it is filled.
pub(crate) type Table = Vec<Vec<bool>>;

/// Pieces that hang together, and contacts along edges and in points only.
pub(crate) fn faults<T: Real>(layout: &Layout<T>, table: &Table) -> Vec<Fault> {
    let mut faults = Vec::new();
    let pieces = pieces(layout, table);
    if pieces == 0 {
        return vec![Fault::Empty];
    }
    if pieces > 1 {
        faults.push(Fault::Unconnected { pieces });
    }
    faults.extend(thin_contacts(layout, table));
    faults
}

fn pieces<T: Real>(layout: &Layout<T>, table: &Table) -> usize {
    let (cells, intervals) = (table.len(), layout.levels.count());
    let mut union = Union::new(cells * intervals);
    let place = |cell: usize, interval: usize| cell * intervals + interval;
    for (cell, filled) in table.iter().enumerate() {
        (1..intervals)
            .filter(|k| filled[k - 1] && filled[*k])
            .for_each(|k| union.join(place(cell, k - 1), place(cell, k)));
    }
    for sides in &layout.faces.sides {
        let [l, r] = sides.map(|side| side.unwrap_or(cells - 1));
        (0..intervals).filter(|k| table[l][*k] && table[r][*k]).for_each(|k| union.join(place(l, k), place(r, k)));
    }
    let filled = (0..cells).flat_map(|c| (0..intervals).map(move |k| (c, k))).filter(|(c, k)| table[*c][*k]);
    let mut roots: Vec<usize> = filled.map(|(c, k)| union.root(place(c, k))).collect();
    roots.sort_unstable();
    roots.dedup();
    roots.len()
}

fn thin_contacts<T: Real>(layout: &Layout<T>, table: &Table) -> Vec<Fault> {
    let intervals = layout.levels.count();
    let heights: Vec<f64> = layout.levels.heights.iter().map(|z| z.value()).collect();
    let mut faults = Vec::new();
    for (v, fan) in fans(&layout.plane.vertices, &layout.arcs).iter().enumerate().filter(|(_, fan)| !fan.is_empty()) {
        // The cell counter-clockwise of each half-strand.
        let sectors: Vec<&Vec<bool>> = fan
            .iter()
            .map(|(arc, forward)| layout.faces.sides[*arc][usize::from(!forward)].unwrap_or(table.len() - 1))
            .map(|cell| &table[cell])
            .collect();
        let at = layout.plane.vertices[v];
        let upright: Vec<usize> = (0..intervals).filter(|k| changes(&sectors, *k) > 2).collect();
        faults.extend(upright.iter().map(|k| Fault::ThinContact { at, interval: [heights[*k], heights[k + 1]] }));
        for (level, height) in heights.iter().enumerate() {
            let beside = |k: &usize| *k == level || *k + 1 == level;
            if !upright.iter().any(beside) && !round(&sectors, level, intervals) {
                faults.push(Fault::ThinContact { at, interval: [*height; 2] });
            }
        }
    }
    faults
}

/// How often filled and empty change round a vertex in an interval.
fn changes(sectors: &[&Vec<bool>], interval: usize) -> usize {
    let next = sectors.iter().cycle().skip(1);
    sectors.iter().zip(next).filter(|(a, b)| a[interval] != b[interval]).count()
}

/// Whether what is filled round a vertex at a level hangs together in faces, and so does what is empty.
fn round(sectors: &[&Vec<bool>], level: usize, intervals: usize) -> bool {
    let n = sectors.len();
    let full = |i: usize, above: bool| match above {
        true => level < intervals && sectors[i][level],
        false => level > 0 && sectors[i][level - 1],
    };
    let place = |i: usize, above: bool| 2 * i + usize::from(above);
    let mut union = Union::new(2 * n);
    for i in 0..n {
        if full(i, true) == full(i, false) {
            union.join(place(i, true), place(i, false));
        }
        for above in [true, false].into_iter().filter(|above| full(i, *above) == full((i + 1) % n, *above)) {
            union.join(place(i, above), place((i + 1) % n, above));
        }
    }
    let mut roots: Vec<usize> = (0..2 * n).map(|i| union.root(i)).collect();
    roots.sort_unstable();
    roots.dedup();
    roots.len() <= 2
}
