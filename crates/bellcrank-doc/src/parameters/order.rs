//! Definitions in the order of their evaluation, and the cycles that have none.

use crate::{Diagnostic, Span};

/// What ordering found.
pub(super) struct Order {
    /// Indices, each after all it uses; those in or behind a cycle are missing.
    pub(super) order: Vec<usize>,
    /// Members of each cycle, each using the next, the last using the first.
    pub(super) cycles: Vec<Vec<usize>>,
}

/// Orders items by what they use (`uses[i]` are the indices that `i` uses). O(items + uses), no
/// recursion: a file may hold a chain of any length.
pub(super) fn order(uses: &[Vec<usize>]) -> Order {
    let mut waiting: Vec<usize> = uses.iter().map(Vec::len).collect();
    let mut users: Vec<Vec<usize>> = vec![Vec::new(); uses.len()];
    for (i, used) in uses.iter().enumerate() {
        for &u in used {
            users[u].push(i);
        }
    }
    // Written order where nothing forbids it.
    let mut ready: std::collections::VecDeque<usize> = (0..uses.len()).filter(|&i| waiting[i] == 0).collect();
    let mut order = Vec::with_capacity(uses.len());
    while let Some(next) = ready.pop_front() {
        order.push(next);
        for &user in &users[next] {
            waiting[user] -= 1;
            if waiting[user] == 0 {
                ready.push_back(user);
            }
        }
    }
    let cycles = cycles(uses, &waiting);
    Order { order, cycles }
}

/// One cycle for each group of items that wait for each other: walk along what still waits until
/// the walk meets itself.
fn cycles(uses: &[Vec<usize>], waiting: &[usize]) -> Vec<Vec<usize>> {
    let mut walked_by: Vec<Option<usize>> = vec![None; uses.len()];
    let mut cycles = Vec::new();
    for start in 0..uses.len() {
        let mut path = Vec::new();
        let mut at = start;
        while waiting[at] > 0 && walked_by[at].is_none() {
            walked_by[at] = Some(start);
            path.push(at);
            match uses[at].iter().find(|&&u| waiting[u] > 0) {
                Some(&next) => at = next,
                None => break,
            }
        }
        let met_itself = !path.is_empty() && walked_by[at] == Some(start);
        if let Some(first) = path.iter().position(|&p| p == at).filter(|_| met_itself) {
            cycles.push(path.split_off(first));
        }
    }
    cycles
}

/// A member of a cycle: its name and the place that continues the cycle.
pub(super) struct Link<'a> {
    pub(super) name: &'a str,
    pub(super) span: Span,
}

/// Members that are named in a report.
const NAMED: usize = 8;

/// The report of a cycle, with a place for each of its members.
pub(super) fn cycle_report(links: &[Link<'_>]) -> Diagnostic {
    let nowhere = || Diagnostic::placeless("cycle", "parameters depend on each other in a circle");
    let Some((first, rest)) = links.split_first() else { return nowhere() };
    if rest.is_empty() {
        let message = format!("`{}` is defined by itself", first.name);
        return Diagnostic::error("cycle", first.span, message).hint("give it a value");
    }
    let mut names: Vec<&str> = links.iter().take(NAMED).map(|l| l.name).collect();
    if links.len() > NAMED {
        names.push("...");
    }
    names.push(first.name);
    let message = format!("parameters depend on each other in a circle: {}", names.join(" -> "));
    let label = |i: usize| format!("needs `{}`", links.get(i + 1).map_or(first.name, |l| l.name));
    let mut error = Diagnostic::error("cycle", first.span, message).label(label(0));
    for (i, link) in links.iter().enumerate().take(NAMED).skip(1) {
        error = error.also(link.span, label(i));
    }
    error.hint("give one of them a value of its own")
}
