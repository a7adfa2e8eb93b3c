//! Which joints carry bodies and which close loops.

use std::cmp::Reverse;
use std::collections::BinaryHeap;

/// A joint that may carry a body: between two bodies, at a cost that grows with its degrees of freedom.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Edge {
    pub(crate) joint: usize,
    pub(crate) bodies: [usize; 2],
    pub(crate) cost: usize,
}

/// A tree edge in the order of building: the body `child` is reached through `joint`.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Branch {
    /// `None` where nothing connects the body: it floats.
    pub(crate) joint: Option<usize>,
    pub(crate) parent: usize,
    pub(crate) child: usize,
}

/// A spanning tree from body 0, few degrees of freedom first, shallow first (Prim).
///
/// Every joint left over closes a loop; cutting the joints with most freedom leaves the fewest unknowns
/// and equations. Bodies that nothing carries float on ground.
pub(crate) fn spanning_tree(bodies: usize, edges: &[Edge]) -> Vec<Branch> {
    let mut at = vec![Vec::new(); bodies];
    for (k, e) in edges.iter().enumerate() {
        at[e.bodies[0]].push(k);
        at[e.bodies[1]].push(k);
    }
    let mut grow = Grow { edges, at, depth: vec![usize::MAX; bodies], heap: BinaryHeap::new(), tree: Vec::new() };
    grow.from(0, 0);
    for body in 1..bodies {
        if grow.depth[body] == usize::MAX {
            grow.tree.push(Branch { joint: None, parent: 0, child: body });
            grow.from(body, 1);
        }
    }
    grow.tree
}

struct Grow<'a> {
    edges: &'a [Edge],
    at: Vec<Vec<usize>>,
    depth: Vec<usize>,
    heap: BinaryHeap<Reverse<(usize, usize, usize, usize)>>,
    tree: Vec<Branch>,
}

impl Grow<'_> {
    fn from(&mut self, body: usize, depth: usize) {
        self.reach(body, depth);
        while let Some(Reverse((_, _, k, child))) = self.heap.pop() {
            if self.depth[child] != usize::MAX {
                continue;
            }
            let e = self.edges[k];
            let parent = if e.bodies[0] == child { e.bodies[1] } else { e.bodies[0] };
            self.tree.push(Branch { joint: Some(e.joint), parent, child });
            self.reach(child, self.depth[parent] + 1);
        }
    }
    fn reach(&mut self, body: usize, depth: usize) {
        self.depth[body] = depth;
        for &k in &self.at[body] {
            let e = self.edges[k];
            let other = if e.bodies[0] == body { e.bodies[1] } else { e.bodies[0] };
            if self.depth[other] == usize::MAX {
                self.heap.push(Reverse((e.cost, depth, k, other)));
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_freest_joint_of_a_loop_is_cut_and_lone_bodies_float() {
        let edge = |joint, a, b, cost| Edge { joint, bodies: [a, b], cost };
        let edges = [edge(0, 0, 1, 1), edge(1, 1, 2, 3), edge(2, 2, 0, 1), edge(3, 3, 3, 1)];
        let tree = spanning_tree(4, &edges);
        assert!(tree.iter().all(|b| b.joint != Some(1)));
        assert!(tree.iter().any(|b| b.child == 3 && b.joint.is_none()));
        assert_eq!(tree.len(), 3);
    }
}
