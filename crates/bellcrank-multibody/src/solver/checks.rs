//! Trust: loop closure, and the balance of powers by a route of its own.
//!
//! The powers are taken body by body from weights, applied forces, inertia and drives with the velocities
//! of the motion itself (d'Alembert), without the inward pass or the multipliers. A machine at rest is
//! tested with the velocities that unit rates of its drives would give.

use super::machine::{Machine, Stage};
use super::unknowns::Prescribed;
use crate::flexible::{Carriage, Deforming};
use crate::forces::{Element, read};
use crate::workspace::NodeState;
use crate::{Checks, kinematics};
use bellcrank_math::{Components, Space};

/// Velocities that count as none, m/s or rad/s.
const STILL: f64 = 1e-12;

/// A sum of powers, and what they would be if nothing cancelled: forces times speeds.
#[derive(Default)]
struct Sum {
    total: f64,
    size: f64,
}

impl Sum {
    fn add(&mut self, power: f64, size: f64) {
        self.total += power;
        self.size += size;
    }
    fn add_number(&mut self, power: f64) {
        self.add(power, power.abs());
    }
    /// A force on a velocity, or a moment on an angular velocity.
    fn add_product<V: Components<f64>>(&mut self, force: V, velocity: V) {
        self.add(force.dot(velocity), (force.dot(force) * velocity.dot(velocity)).sqrt());
    }
}

impl<S: Space<T = f64>> Machine<S> {
    pub(crate) fn read_checks(&self) -> Checks {
        let solved = self.stage >= Stage::Forces;
        Checks { closure: self.closure(), balance: if solved { self.power_balance() } else { f64::NAN } }
    }

    fn power_balance(&self) -> f64 {
        let moving = self.v.iter().any(|v| *v != 0.0);
        if self.flight.is_some() {
            // What rounding leaves of velocities that come to rest meets no constraint, and tests nothing.
            let still = self.v.iter().all(|v| v.abs() < STILL);
            return if still { 0.0 } else { self.balance_along(&self.v, &self.x) };
        }
        let Some(prepared) = &self.prepared else { return f64::NAN };
        if moving {
            return self.balance_along(&self.v, &self.x);
        }
        // At rest: the velocities of unit drive rates, solved on a copy of the factors.
        let mut system = prepared.effort.as_ref().or(prepared.rate.as_ref()).unwrap_or(&prepared.position).clone();
        let mut v = vec![0.0; self.mech.nv];
        let mut rhs = vec![0.0; system.rows];
        for p in &system.prescribed {
            match p {
                Prescribed::Node(n) => v[self.mech.nodes[*n].v] = 1.0,
                Prescribed::Row(row, _) => rhs[*row] = 1.0,
            }
        }
        let mut product = vec![0.0; system.rows];
        system.multiply_known(&self.rows, &v, &mut product);
        rhs.iter_mut().zip(&product).for_each(|(r, p)| *r -= p);
        system.solve(&rhs, &mut v);
        let mut x = self.x.clone();
        kinematics::velocities(&self.mech, &v, &mut x);
        self.balance_along(&v, &x)
    }

    /// Relative residual of the virtual powers with velocities `v` and their nodes `x`.
    fn balance_along(&self, v: &[f64], x: &[NodeState<S>]) -> f64 {
        let mut sum = Sum::default();
        self.add_body_powers(x, &mut sum);
        self.add_effort_powers(v, x, &mut sum);
        self.add_drive_powers(v, x, &mut sum);
        if sum.size > 0.0 { sum.total.abs() / sum.size } else { sum.total.abs() }
    }

    fn add_body_powers(&self, virtual_x: &[NodeState<S>], sum: &mut Sum) {
        for ((node, x), dx) in self.mech.nodes.iter().zip(&self.x).zip(virtual_x) {
            if let Some(body) = &node.inertia {
                let p = x.p + S::rotate(&x.R, body.center);
                let (dv, a) = (dx.at(p).0, x.at(p).1);
                let h = S::apply_inertia(&body.about_center, &x.R, x.w);
                let n = S::apply_inertia(&body.about_center, &x.R, x.wd) + S::cross_angular(x.w, h);
                sum.add_product(self.mech.gravity * body.mass, dv);
                sum.add_product(a * -body.mass, dv);
                sum.add_product(-n, dx.w);
            }
            sum.add_product(x.ext_f, dx.v);
            sum.add_product(x.ext_n, dx.w);
        }
        self.mech.flexible.iter().for_each(|body| self.add_flexible_powers(body, virtual_x, sum));
    }

    fn add_flexible_powers(&self, body: &Deforming<S>, virtual_x: &[NodeState<S>], sum: &mut Sum) {
        let mut carriage = Carriage::new(&self.mech, body, &self.x);
        for e in 0..body.count() {
            sum.add_number(-carriage.take(body, &self.x, e) * body.motion(virtual_x, e)[1]);
        }
        let ((f, n), dx) = (carriage.demand(body), &virtual_x[body.node]);
        sum.add_product(-f, dx.v);
        sum.add_product(-n, dx.w);
    }

    fn add_effort_powers(&self, v: &[f64], x: &[NodeState<S>], sum: &mut Sum) {
        self.efforts.iter().zip(v).for_each(|(e, v)| sum.add_number(e * v));
        for (element, e) in self.mech.elements.iter().zip(&self.friction) {
            if let Element::Friction(f) = element {
                sum.add_number(e * read(&self.mech, x, &self.q, v, f.source).1);
            }
        }
    }

    fn add_drive_powers(&self, v: &[f64], x: &[NodeState<S>], sum: &mut Sum) {
        if let Some(flight) = &self.flight {
            let sources = flight.driven.iter().copied().chain(flight.locks.iter().map(|l| l.source));
            for (source, u) in sources.zip(&self.drive) {
                sum.add_number(u * read(&self.mech, x, &self.q, v, source).1);
            }
            return;
        }
        let Some(prepared) = &self.prepared else { return };
        for (c, u) in prepared.actuation.effort.iter().zip(&self.drive) {
            let Some(source) = self.mech.source(*c) else { continue };
            sum.add_number(u * read(&self.mech, x, &self.q, v, source).1);
        }
    }
}
