//! Assembly: a position that closes all loops, near the starts.
//!
//! Levenberg–Marquardt on closures, held coordinates and (at first) starts of measured coordinates, with
//! steps of least norm `δ = Jᵀ (J Jᵀ + μ I)⁻¹ r`, so that what need not move stays. When that ends in a
//! gap, coordinates without a start are tried anew, at random but always the same.

use super::jacobian::{Entry, Rows, source_entries};
use super::machine::Machine;
use crate::attitude::wrap;
use crate::constraint::{Measure, RowKind};
use crate::mechanism::{Mechanism, Source};
use crate::topology::Motion;
use crate::workspace::NodeState;
use crate::{Assembled, Coordinate, JointId, MechanismError};
use bellcrank_math::linalg::{BandLu, band_ordering};
use bellcrank_math::{Components, Space};

/// Steps of one attempt.
const MOST_STEPS: usize = 120;
/// Random restarts before giving up, for machines of ordinary size.
const MOST_RESTARTS: usize = 60;
/// The same for one machine of a family: where its starts do not lead, luck seldom does, and there may be a million.
const RENEWED_RESTARTS: usize = 4;
/// Largest gap of an assembled machine, in machine sizes.
const CLOSED: f64 = 1e-11;
/// The same where equations are redundant and dimensions may be rounded.
const NEARLY_CLOSED: f64 = 1e-6;

/// Below this many equations a dense factorization needs no ordering.
const DENSE: usize = 120;

/// A row asked for: a coordinate and the value it should have.
type Asked = (Source, f64);

/// Rows as lists of (column, value).
pub(crate) struct SparseRows(Vec<Vec<(usize, f64)>>);

impl SparseRows {
    fn of<S: Space<T = f64>>(mech: &Mechanism<S>, rows: &Rows<S>, x: &[NodeState<S>], asked: &[Asked]) -> Self {
        let mut all = vec![Vec::new(); mech.rows() + asked.len()];
        rows.each(mech, |r, v, value| all[r].push((v, value)));
        let sources: Vec<Source> = asked.iter().map(|a| a.0).collect();
        all.truncate(mech.rows());
        all.extend(Self::of_sources(mech, x, &sources).0);
        Self(all)
    }
    /// Gradients of coordinates.
    pub(crate) fn of_sources<S: Space<T = f64>>(mech: &Mechanism<S>, x: &[NodeState<S>], sources: &[Source]) -> Self {
        let row = |s: &Source| {
            let mut entries = Vec::new();
            source_entries(mech, x, *s, 1.0, 0, &mut entries);
            entries.into_iter().map(|(_, v, value)| (v, value)).collect()
        };
        Self(sources.iter().map(row).collect())
    }
    pub(crate) fn dense(&self, columns: usize) -> Vec<Vec<f64>> {
        let fill = |row: &Vec<(usize, f64)>| {
            let mut out = vec![0.0; columns];
            row.iter().for_each(|(v, value)| out[*v] += value);
            out
        };
        self.0.iter().map(fill).collect()
    }
    /// `δ = Jᵀ (J Jᵀ + μ I)⁻¹ r`.
    fn least_norm(&self, normal: &mut Normal, r: &[f64], mu: f64, delta: &mut [f64]) {
        let mut rows_of = vec![Vec::new(); delta.len()];
        for (i, row) in self.0.iter().enumerate() {
            row.iter().for_each(|&(v, value)| rows_of[v].push((i, value)));
        }
        let Normal { place, lu, y, .. } = normal;
        lu.clear();
        for entries in &rows_of {
            for (i, a) in entries {
                entries.iter().for_each(|(k, b)| lu.add(place[*i], place[*k], a * b));
            }
        }
        (0..r.len()).for_each(|i| lu.add(i, i, mu));
        lu.factor();
        (0..r.len()).for_each(|i| y[place[i]] = r[i]);
        lu.solve(y);
        delta.fill(0.0);
        for (i, row) in self.0.iter().enumerate() {
            row.iter().for_each(|(v, value)| delta[*v] += value * y[place[i]]);
        }
    }
}

/// The matrix `J Jᵀ` of a pattern of rows, ordered once for all steps.
#[derive(Debug)]
struct Normal {
    ordered: bool,
    place: Vec<usize>,
    lu: BandLu,
    y: Vec<f64>,
}

impl Default for Normal {
    fn default() -> Self {
        Self { ordered: false, place: Vec::new(), lu: BandLu::new(0, 0, 0), y: Vec::new() }
    }
}

impl Normal {
    /// Another search may have another pattern.
    fn begin(&mut self) {
        self.ordered = false;
    }

    fn order(&mut self, rows: &SparseRows, columns: usize) {
        if std::mem::replace(&mut self.ordered, true) {
            return;
        }
        let m = rows.0.len();
        let mut rows_of = vec![Vec::new(); columns];
        for (i, row) in rows.0.iter().enumerate() {
            row.iter().for_each(|(v, _)| rows_of[*v].push(i));
        }
        // Two rows meet in J Jᵀ when they share a column: the columns are the rows of that graph.
        let place = band_ordering(&rows_of, m).column;
        let spread = |rows: &Vec<usize>| {
            let places = rows.iter().map(|i| place[*i]);
            places.clone().max().unwrap_or(0) - places.min().unwrap_or(0)
        };
        let band = rows_of.iter().map(spread).max().unwrap_or(0);
        (self.lu, self.y) = (BandLu::new(m, band, band), vec![0.0; m]);
        self.place = place;
    }

    /// A full matrix needs no ordering.
    fn fill(&mut self, m: usize) {
        if self.lu.size() != m || self.place.len() != m || self.place.windows(2).any(|p| p[0] > p[1]) {
            self.place = (0..m).collect();
            (self.lu, self.y) = (BandLu::new(m, m, m), vec![0.0; m]);
        }
        self.lu.clear();
    }
}

/// Memory of the search, kept from one assembly to the next.
#[derive(Debug, Default)]
pub(crate) struct Room {
    r: Vec<f64>,
    next: Vec<f64>,
    q: Vec<f64>,
    /// Rows of the Jacobian one after another, where they are few.
    jacobian: Vec<f64>,
    entries: Vec<Entry>,
    normal: Normal,
}

impl Room {
    fn least_norm(&mut self, count: usize, width: usize, mu: f64, delta: &mut [f64]) {
        let Self { r, jacobian, normal, .. } = self;
        normal.fill(count);
        let row = |i: usize| &jacobian[i * width..(i + 1) * width];
        for i in 0..count {
            for k in 0..=i {
                let product: f64 = row(i).iter().zip(row(k)).map(|(a, b)| a * b).sum();
                normal.lu.add(i, k, product);
                if i != k {
                    normal.lu.add(k, i, product);
                }
            }
            normal.lu.add(i, i, mu);
        }
        normal.lu.factor();
        normal.y.copy_from_slice(&r[..count]);
        normal.lu.solve(&mut normal.y);
        delta.fill(0.0);
        for (i, y) in normal.y.iter().enumerate() {
            delta.iter_mut().zip(row(i)).for_each(|(d, j)| *d += j * y);
        }
    }
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn assemble_near_starts(&mut self, hold: &[(Coordinate, f64)]) -> Result<Assembled, MechanismError> {
        self.prepared = None;
        let (held, wished) = self.asked(hold);
        let mut iterations = 0;
        let mut nearest: Option<(f64, MechanismError)> = None;
        let restarts = match (self.mech.nv > 500, self.renewed) {
            (true, _) => 0,
            (false, true) => RENEWED_RESTARTS,
            (false, false) => MOST_RESTARTS,
        };
        for attempt in 0..=restarts {
            self.go_to_start();
            self.place_held(&held);
            if attempt > 0 {
                self.scatter(attempt, &held);
            }
            match self.attempt(&held, &wished) {
                Ok(steps) => {
                    self.reset_unwrapped();
                    return Ok(Assembled {
                        closure: self.closure(),
                        iterations: iterations + steps,
                        restarts: attempt,
                    });
                }
                Err(e) => {
                    iterations += MOST_STEPS;
                    let gap = if let MechanismError::NotAssembled { gap, .. } = &e { *gap } else { f64::INFINITY };
                    if nearest.as_ref().is_none_or(|n| gap < n.0) {
                        nearest = Some((gap, e));
                    }
                }
            }
        }
        Err(nearest.map_or(MechanismError::NotFinite("the starts"), |n| n.1))
    }

    /// Values to meet exactly, and starts of measured coordinates to meet at first.
    fn asked(&self, hold: &[(Coordinate, f64)]) -> (Vec<Asked>, Vec<Asked>) {
        let mut held: Vec<Asked> = hold.iter().filter_map(|(c, x)| Some((self.mech.source(*c)?, *x))).collect();
        let mut wished = Vec::new();
        for (j, joint) in self.blueprint.joints.iter().enumerate() {
            for (i, start) in joint.start.iter().enumerate() {
                let (Some(value), Some(source)) = (start, self.mech.sources[j].get(i)) else { continue };
                if joint.at_start && !held.iter().any(|h| h.0 == *source) {
                    held.push((*source, *value));
                } else if matches!(source, Source::Measured { .. }) && self.mech.tree_joint[j].is_none() {
                    wished.push((*source, *value));
                }
            }
        }
        (held, wished)
    }

    fn place_held(&mut self, held: &[Asked]) {
        for (source, value) in held {
            if let Source::Node(n) = source {
                self.q[self.mech.nodes[*n].q] = *value;
            }
        }
        self.update_positions();
    }

    fn attempt(&mut self, held: &[Asked], wished: &[Asked]) -> Result<usize, MechanismError> {
        let mut steps = 0;
        if !wished.is_empty() {
            let mut all = held.to_vec();
            all.extend(wished);
            all.extend(self.tree_starts(held));
            steps += self.levenberg_marquardt(&all, 40);
        }
        steps += self.levenberg_marquardt(held, MOST_STEPS);
        self.check_closed(held)?;
        Ok(steps)
    }

    /// Starts given in the tree: kept while starts of closing joints pull.
    fn tree_starts(&self, held: &[Asked]) -> Vec<Asked> {
        let mut starts = Vec::new();
        for (j, joint) in self.blueprint.joints.iter().enumerate() {
            for (i, start) in joint.start.iter().enumerate() {
                if let (Some(value), Some(source @ Source::Node(_))) = (start, self.mech.sources[j].get(i))
                    && !held.iter().any(|h| h.0 == *source)
                {
                    starts.push((*source, *value));
                }
            }
        }
        starts
    }

    /// Closes the loops from where the machine stands.
    pub(crate) fn close_loops(&mut self, held: &[(Source, f64)]) -> Result<(), MechanismError> {
        self.levenberg_marquardt(held, 30);
        self.check_closed(held)
    }

    /// What is missing to close the loops and meet what is asked, into `r`.
    fn residual(&mut self, asked: &[Asked], r: &mut Vec<f64>) {
        self.rows.evaluate(&self.mech, &self.q, &self.x);
        r.clear();
        r.extend(self.rows.value.iter().map(|v| -v));
        for (source, value) in asked {
            r.push(match source {
                Source::Node(n) => value - self.q[self.mech.nodes[*n].q],
                Source::Measured { link, measure } => {
                    let now = self.mech.links[*link].measure(*measure, &self.mech.links[*link].pose(&self.x)).value;
                    if measure.is_angle() { wrap(value - now) } else { value - now }
                }
            });
        }
    }

    fn levenberg_marquardt(&mut self, asked: &[Asked], most: usize) -> usize {
        let mut room = self.room.take().unwrap_or_default();
        let steps = self.search(asked, most, &mut room);
        self.room = Some(room);
        steps
    }

    fn search(&mut self, asked: &[Asked], most: usize, room: &mut Room) -> usize {
        let cost = |r: &[f64]| r.iter().map(|x| x * x).sum::<f64>();
        self.residual(asked, &mut room.r);
        let mut before = cost(&room.r);
        let mut mu = 1e-4;
        let size = self.mech.size.max(1e-3);
        // Below `tight` all is done; from `rounding` on a step that does not help shows that nothing will.
        let (tight, rounding) = ((1e-16 * size).powi(2), (1e-13 * size).powi(2));
        let mut stalled = 0;
        room.normal.begin();
        for step in 0..most {
            let done = before <= tight || (before <= rounding && stalled > 0);
            if done || !before.is_finite() || stalled > 12 {
                return step;
            }
            self.least_norm(asked, mu, room);
            self.limit_step();
            room.q.clone_from(&self.q);
            self.step(1.0);
            self.update_positions();
            self.residual(asked, &mut room.next);
            let now = cost(&room.next);
            if now < before {
                stalled = if now > 0.999 * before { stalled + 1 } else { 0 };
                std::mem::swap(&mut room.r, &mut room.next);
                before = now;
                mu = (mu * 0.1).max(1e-15);
            } else {
                self.q.copy_from_slice(&room.q);
                self.update_positions();
                self.rows.evaluate(&self.mech, &self.q, &self.x);
                stalled += 1;
                mu = (mu * 10.0).min(1e6);
            }
        }
        most
    }

    /// `δ = Jᵀ (J Jᵀ + μ I)⁻¹ r` into the scratch.
    fn least_norm(&mut self, asked: &[Asked], mu: f64, room: &mut Room) {
        let count = self.mech.rows() + asked.len();
        if count > DENSE {
            let rows = SparseRows::of(&self.mech, &self.rows, &self.x, asked);
            room.normal.order(&rows, self.mech.nv);
            rows.least_norm(&mut room.normal, &room.r, mu, &mut self.scratch.delta);
            return;
        }
        let width = self.mech.nv;
        room.jacobian.clear();
        room.jacobian.resize(count * width, 0.0);
        self.rows.each(&self.mech, |r, v, value| room.jacobian[r * width + v] += value);
        room.entries.clear();
        for (i, (source, _)) in asked.iter().enumerate() {
            source_entries(&self.mech, &self.x, *source, 1.0, self.mech.rows() + i, &mut room.entries);
        }
        room.entries.iter().for_each(|&(r, v, value)| room.jacobian[r * width + v] += value);
        room.least_norm(count, width, mu, &mut self.scratch.delta);
    }

    /// Turns of more than about a radian a step leave the region where the tangent means anything.
    fn limit_step(&mut self) {
        let mut largest: f64 = 0.0;
        for node in &self.mech.nodes[1..] {
            let unit = if matches!(node.motion, Motion::Slide) { 2.0 * self.mech.size } else { 1.0 };
            let from = node.v..node.v + node.motion.dofs();
            largest = self.scratch.delta[from].iter().fold(largest, |m, d| m.max(d.abs() / unit));
        }
        if largest > 0.8 {
            self.scratch.delta.iter_mut().for_each(|d| *d *= 0.8 / largest);
        }
    }

    fn check_closed(&mut self, held: &[Asked]) -> Result<(), MechanismError> {
        let mut room = self.room.take().unwrap_or_default();
        self.residual(held, &mut room.r);
        let gap = room.r.iter().fold(0.0, |m: f64, x| if x.is_nan() { f64::INFINITY } else { m.max(x.abs()) });
        self.room = Some(room);
        let redundant = self.mech.rows() + held.len() > self.mech.nv || self.mech.rows() >= self.mech.nv;
        let limit = if redundant { NEARLY_CLOSED } else { CLOSED } * self.mech.size.max(1e-3);
        let flipped = self.flipped();
        if gap <= limit && flipped.is_empty() {
            return Ok(());
        }
        let mut open: Vec<(JointId, f64, f64)> = self.open_joints();
        open.extend(flipped.into_iter().map(|j| (j, 0.0, std::f64::consts::PI)));
        open.sort_by(|a, b| (b.1 + b.2).total_cmp(&(a.1 + a.2)));
        Err(MechanismError::NotAssembled { gap, open })
    }

    /// Closing joints whose axes met head to tail: perpendicularity alone cannot tell.
    fn flipped(&self) -> Vec<JointId> {
        let mut found = Vec::new();
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let pose = link.pose(&self.x);
            let opposite = |i: usize| S::column(&pose.R[0], i).dot(S::column(&pose.R[1], i)) < 0.0;
            let z_parallel = link.rows.contains(&RowKind::Perpendicular(0, 2));
            let rigid = link.rows.contains(&RowKind::Perpendicular(0, 1));
            if (z_parallel && S::DIM == 3 && opposite(2)) || (rigid && (0..S::DIM).any(opposite)) {
                found.push(link.joint);
            }
        }
        found
    }

    fn open_joints(&self) -> Vec<(JointId, f64, f64)> {
        let mut open = Vec::new();
        for &k in &self.mech.closing {
            let link = &self.mech.links[k];
            let (mut gap, mut turn) = (0.0_f64, 0.0_f64);
            for (i, kind) in link.rows.iter().enumerate() {
                let size = self.rows.value[link.first_row + i].abs();
                match kind {
                    RowKind::Perpendicular(..) => turn = turn.max(size.min(1.0).asin()),
                    RowKind::Held(Measure::Turn(_)) => turn = turn.max(size),
                    _ => gap = gap.max(size),
                }
            }
            if gap > CLOSED * self.mech.size || turn > CLOSED {
                open.push((link.joint, gap, turn));
            }
        }
        for (i, c) in self.mech.couplings.iter().enumerate() {
            let size = self.rows.value[self.mech.link_rows + i].abs();
            if size > CLOSED {
                open.push((c.joint, size, 0.0));
            }
        }
        open
    }

    /// Other first guesses: free coordinates anywhere, given starts a little off, farther with each attempt.
    fn scatter(&mut self, attempt: usize, held: &[Asked]) {
        let mut random = Random(0x9E37_79B9_7F4A_7C15 ^ (attempt as u64).wrapping_mul(0xD134_2543_DE82_EF95));
        let shake = 0.05 * attempt as f64 / MOST_RESTARTS as f64;
        for n in 1..self.mech.nodes.len() {
            let node = &self.mech.nodes[n];
            let fixed = held.iter().any(|h| h.0 == Source::Node(n));
            let given = self.has_start(n);
            let range = match node.motion {
                Motion::Slide => 2.0 * self.mech.size,
                _ => std::f64::consts::PI,
            };
            let reach = if fixed {
                0.0
            } else if given {
                shake * range
            } else {
                range
            };
            for k in 0..node.motion.dofs() {
                self.scratch.delta[node.v + k] = reach * random.symmetric();
            }
        }
        self.step(1.0);
        self.update_positions();
    }

    fn has_start(&self, n: usize) -> bool {
        let Some(joint) = self.mech.nodes[n].joint else { return false };
        let start = &self.blueprint.joints[joint.0].start;
        let index = self.mech.sources[joint.0].iter().position(|s| *s == Source::Node(n));
        match index {
            Some(i) => start.get(i).is_some_and(Option::is_some),
            None => start.iter().any(Option::is_some),
        }
    }
}

/// Xorshift: the same numbers on every machine.
struct Random(u64);

impl Random {
    /// In −1..1.
    fn symmetric(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }
}
