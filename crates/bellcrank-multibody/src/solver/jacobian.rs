//! The constraint Jacobian, sparse: for each closing link a small dense block over the path it spans.

use crate::attitude::wrap;
use crate::constraint::{Gradient, Link};
use crate::mechanism::{Mechanism, Source};
use crate::topology::Motion;
use crate::workspace::NodeState;
use bellcrank_math::{Components, Space};

/// An entry of a row that is not a link's: row, velocity component, value.
pub(crate) type Entry = (usize, usize, f64);

/// Row values, wrenches and Jacobian at the present position. Rows of links first, then couplings.
#[derive(Clone, Debug)]
pub(crate) struct Rows<S: Space> {
    pub(crate) value: Vec<f64>,
    /// Wrench of each link row at the link's P₂.
    pub(crate) wrench: Vec<(S::Vector, S::Angular)>,
    /// P₂ of each closing link, world axes.
    pub(crate) p2: Vec<S::Vector>,
    /// Blocks `rows × columns` of the closing links, one after another.
    pub(crate) block: Vec<f64>,
    pub(crate) offset: Vec<usize>,
    pub(crate) coupling: Vec<Entry>,
    /// Last accepted positions of the two coordinates of each coupling: measured angles count on from them.
    pub(crate) coupled: Vec<[f64; 2]>,
    /// Motion of P₂ a unit rate of each path column, scratch.
    twist: Vec<(S::Vector, S::Angular)>,
}

impl<S: Space<T = f64>> Rows<S> {
    pub(crate) fn new(mech: &Mechanism<S>) -> Self {
        let zero = (S::Vector::default(), S::Angular::default());
        let mut offset = Vec::with_capacity(mech.closing.len() + 1);
        let mut total = 0;
        let mut widest = 0;
        for &k in &mech.closing {
            offset.push(total);
            total += mech.links[k].rows.len() * mech.links[k].columns.len();
            widest = widest.max(mech.links[k].columns.len());
        }
        offset.push(total);
        let terms = mech.links.iter().map(|l| l.columns.len()).max().unwrap_or(0).max(1);
        Self {
            value: vec![0.0; mech.rows()],
            wrench: vec![zero; mech.link_rows],
            p2: vec![S::Vector::default(); mech.closing.len()],
            block: vec![0.0; total],
            offset,
            coupling: Vec::with_capacity(2 * terms * mech.couplings.len()),
            coupled: vec![[0.0; 2]; mech.couplings.len()],
            twist: Vec::with_capacity(widest.max(terms)),
        }
    }

    /// Values of all rows only.
    #[inline]
    pub(crate) fn residuals(&mut self, mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>]) {
        for &k in &mech.closing {
            let link = &mech.links[k];
            if link.points_only {
                let [p1, p2] = link.points(x);
                let d = p2 - p1;
                for i in 0..link.rows.len() {
                    self.value[link.first_row + i] = d[i];
                }
            } else {
                let pose = link.pose(x);
                for (i, kind) in link.rows.iter().enumerate() {
                    self.value[link.first_row + i] = link.row(*kind, &pose).value;
                }
            }
        }
        self.coupling_values(mech, q, x);
    }

    fn coupling_values(&mut self, mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>]) {
        for (i, c) in mech.couplings.iter().enumerate() {
            let [a, b] = self.coupled_positions(mech, q, x, i);
            self.value[mech.link_rows + i] = b - c.ratio * a - c.offset;
        }
    }

    fn coupled_positions(&self, mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>], i: usize) -> [f64; 2] {
        let (c, last) = (&mech.couplings[i], self.coupled[i]);
        let near = |s: Source, last: f64| {
            let raw = value_of(mech, q, x, s);
            let wraps = matches!(s, Source::Measured { measure, .. } if measure.is_angle());
            if wraps { last + wrap(raw - last) } else { raw }
        };
        [near(c.a, last[0]), near(c.b, last[1])]
    }

    /// Remembers where coupled coordinates are, at an accepted position.
    pub(crate) fn note_coupled(&mut self, mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>]) {
        for i in 0..mech.couplings.len() {
            self.coupled[i] = self.coupled_positions(mech, q, x, i);
        }
    }

    /// Values, wrenches and Jacobian of all rows.
    #[inline]
    pub(crate) fn evaluate(&mut self, mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>]) {
        for (c, &k) in mech.closing.iter().enumerate() {
            let link = &mech.links[k];
            if link.points_only {
                self.point_rows(link, c, x, mech);
            } else {
                self.link_rows(link, c, x, mech);
            }
        }
        self.coupling_values(mech, q, x);
        self.coupling.clear();
        for (i, c) in mech.couplings.iter().enumerate() {
            let row = mech.link_rows + i;
            source_entries(mech, x, c.b, 1.0, row, &mut self.coupling);
            source_entries(mech, x, c.a, -c.ratio, row, &mut self.coupling);
        }
    }

    fn point_rows(&mut self, link: &Link<S>, c: usize, x: &[NodeState<S>], mech: &Mechanism<S>) {
        let [p1, p2] = link.points(x);
        let d = p2 - p1;
        self.p2[c] = p2;
        twists(mech, link, x, p2, &mut self.twist);
        let (width, start) = (link.columns.len(), self.offset[c]);
        for i in 0..link.rows.len() {
            self.value[link.first_row + i] = d[i];
            let mut e = S::Vector::default();
            e[i] = 1.0;
            self.wrench[link.first_row + i] = (e, S::Angular::default());
            let row = &mut self.block[start + i * width..start + (i + 1) * width];
            row.iter_mut().zip(&self.twist).for_each(|(b, t)| *b = t.0[i]);
        }
    }

    fn link_rows(&mut self, link: &Link<S>, c: usize, x: &[NodeState<S>], mech: &Mechanism<S>) {
        let pose = link.pose(x);
        self.p2[c] = pose.p[1];
        twists(mech, link, x, pose.p[1], &mut self.twist);
        let (width, start) = (link.columns.len(), self.offset[c]);
        for (i, kind) in link.rows.iter().enumerate() {
            let g = link.row(*kind, &pose);
            self.value[link.first_row + i] = g.value;
            self.wrench[link.first_row + i] = (g.f, g.n);
            let row = &mut self.block[start + i * width..start + (i + 1) * width];
            row.iter_mut().zip(&self.twist).for_each(|(b, t)| *b = g.f.dot(t.0) + g.n.dot(t.1));
        }
    }

    /// Calls `f(row, velocity component, value)` for every entry.
    pub(crate) fn each(&self, mech: &Mechanism<S>, mut f: impl FnMut(usize, usize, f64)) {
        self.each_of_links(mech, &mut f);
        for &(row, column, value) in &self.coupling {
            f(row, column, value);
        }
    }

    /// The same for links only, in the order of `block`.
    pub(crate) fn each_of_links(&self, mech: &Mechanism<S>, mut f: impl FnMut(usize, usize, f64)) {
        for (c, &k) in mech.closing.iter().enumerate() {
            let link = &mech.links[k];
            let width = link.columns.len();
            for i in 0..link.rows.len() {
                let row = &self.block[self.offset[c] + i * width..self.offset[c] + (i + 1) * width];
                for (value, column) in row.iter().zip(&link.columns) {
                    f(link.first_row + i, *column, *value);
                }
            }
        }
    }
}

/// Velocity of `p_W` and spin a unit rate of each column of the link's path, second against first.
#[inline]
fn twists<S: Space<T = f64>>(
    mech: &Mechanism<S>,
    link: &Link<S>,
    x: &[NodeState<S>],
    p_W: S::Vector,
    out: &mut Vec<(S::Vector, S::Angular)>,
) {
    out.clear();
    for entry in &link.path {
        let node = &x[entry.node];
        match mech.nodes[entry.node].motion {
            Motion::Turn => {
                let w = node.s_w * entry.sign;
                out.push((S::cross(w, p_W - node.p), w));
            }
            Motion::Slide => out.push((node.s_v * entry.sign, S::Angular::default())),
            Motion::Screw(_) => {
                let w = node.s_w * entry.sign;
                out.push((S::cross(w, p_W - node.p) + node.s_v * entry.sign, w));
            }
            Motion::Ball => {
                for i in 0..3 {
                    let mut e = [0.0; 3];
                    e[i] = entry.sign;
                    let w = S::rotate_angular(&node.base, S::angular(&e));
                    out.push((S::cross(w, p_W - node.p), w));
                }
            }
            Motion::Fixed => {}
        }
    }
}

/// Position of a coordinate.
pub(crate) fn value_of<S: Space<T = f64>>(mech: &Mechanism<S>, q: &[f64], x: &[NodeState<S>], s: Source) -> f64 {
    match s {
        Source::Node(n) => q[mech.nodes[n].q],
        Source::Measured { link, measure } => mech.links[link].measure(measure, &mech.links[link].pose(x)).value,
    }
}

/// Entries of a coordinate's gradient times `factor`.
pub(crate) fn source_entries<S: Space<T = f64>>(
    mech: &Mechanism<S>,
    x: &[NodeState<S>],
    s: Source,
    factor: f64,
    row: usize,
    out: &mut Vec<Entry>,
) {
    match s {
        Source::Node(n) => out.push((row, mech.nodes[n].v, factor)),
        Source::Measured { link, measure } => {
            let link = &mech.links[link];
            let pose = link.pose(x);
            gradient_entries(mech, x, link, &link.measure(measure, &pose), pose.p[1], factor, row, out);
        }
    }
}

#[expect(clippy::too_many_arguments, reason = "one row of a sparse matrix: where, what, and where to")]
fn gradient_entries<S: Space<T = f64>>(
    mech: &Mechanism<S>,
    x: &[NodeState<S>],
    link: &Link<S>,
    g: &Gradient<S>,
    p2: S::Vector,
    factor: f64,
    row: usize,
    out: &mut Vec<Entry>,
) {
    let mut column = 0;
    for entry in &link.path {
        let node = &x[entry.node];
        let mut put = |v: S::Vector, w: S::Angular| {
            let rate = g.f.dot(v + S::cross(w, p2 - node.p)) + g.n.dot(w);
            out.push((row, link.columns[column], factor * entry.sign * rate));
            column += 1;
        };
        match mech.nodes[entry.node].motion {
            Motion::Turn => put(S::Vector::default(), node.s_w),
            Motion::Slide => put(node.s_v, S::Angular::default()),
            Motion::Screw(_) => put(node.s_v, node.s_w),
            Motion::Ball => {
                for i in 0..3 {
                    let mut e = [0.0; 3];
                    e[i] = 1.0;
                    put(S::Vector::default(), S::rotate_angular(&node.base, S::angular(&e)));
                }
            }
            Motion::Fixed => {}
        }
    }
}
