//! How much of a long study goes into the page.

use bellcrank_results::{Animation, StudyResult};

/// Numbers of a study's columns, and of its poses, that the page holds: about 16 MB of text each.
/// A browser opens that in a second; what a long run leaves in full is in `series.csv`.
const MOST_NUMBERS: usize = 3_000_000;
/// Curves keep at least that many points, however many columns there are.
const FEWEST_ROWS: usize = 1_000;
/// A drawing of very many bodies still moves.
const FEWEST_FRAMES: usize = 50;

/// The rows that the page holds, rising: all of them unless the study is very long.
pub(crate) fn kept_rows(study: &StudyResult) -> Vec<usize> {
    let most = MOST_NUMBERS / study.table.columns.len().max(1);
    spread(study.table.rows(), most.max(FEWEST_ROWS))
}

/// The frames that the page holds, rising.
pub(crate) fn kept_frames(animation: &Animation) -> Vec<usize> {
    let bodies = animation.frames.first().map_or(1, Vec::len);
    let most = MOST_NUMBERS / (7 * bodies.max(1));
    spread(animation.frames.len().min(animation.rows.len()), most.max(FEWEST_FRAMES))
}

/// At most about `most` of `count`, evenly spread, the last one among them.
fn spread(count: usize, most: usize) -> Vec<usize> {
    let mut kept: Vec<usize> = (0..count).step_by(count.div_ceil(most).max(1)).collect();
    let last = count.checked_sub(1);
    if kept.last().copied() != last {
        kept.extend(last);
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::spread;

    #[test]
    fn short_runs_are_kept_whole() {
        assert_eq!(spread(4, 10), [0, 1, 2, 3]);
        assert!(spread(0, 10).is_empty());
    }

    #[test]
    fn long_runs_keep_their_end() {
        assert_eq!(spread(10, 4), [0, 3, 6, 9]);
        assert_eq!(spread(9, 4), [0, 3, 6, 8]);
    }
}
