//! Long chains: the closed form of the N-four-bar, and no allocation in the inner step.

use crate::build::*;
use crate::forward::run_to;
use crate::machines::{andrews, chain, lift, lift_blueprint};
use bellcrank_multibody::{Actuation, Dynamics, Engine, JointId, Reading, Readings, Seeded, Surroundings, engine_for};
use std::alloc::{GlobalAlloc, Layout, System};
use std::cell::Cell;

struct Counting;

thread_local! {
    static ALLOCATIONS: Cell<usize> = const { Cell::new(0) };
}

#[expect(unsafe_code, reason = "an allocator is unsafe by its trait; this one only counts")]
// SAFETY: every call is handed to the system allocator unchanged.
unsafe impl GlobalAlloc for Counting {
    unsafe fn alloc(&self, layout: Layout) -> *mut u8 {
        ALLOCATIONS.with(|c| c.set(c.get() + 1));
        // SAFETY: the caller's promises are passed on.
        unsafe { System.alloc(layout) }
    }
    unsafe fn dealloc(&self, p: *mut u8, layout: Layout) {
        // SAFETY: the caller's promises are passed on.
        unsafe { System.dealloc(p, layout) }
    }
}

#[global_allocator]
static COUNTING: Counting = Counting;

fn allocations() -> usize {
    ALLOCATIONS.with(Cell::get)
}

fn solve(e: &mut dyn Engine, theta: f64) {
    e.move_to(0.0, &[theta]).expect("moves");
    e.set_rates(&[0.7], &[0.3]).expect("regular");
    e.solve_forces(&mut |_, _| {}).expect("regular");
}

#[test]
fn no_allocation_in_a_position() {
    let mut e = lift([19.84, 20.8, 19.4]);
    e.assemble(&[]).expect("assembles");
    let (lever, slide) = (coordinate(2), coordinate(1));
    e.prepare(&Actuation { position: vec![lever], rate: vec![slide], effort: vec![slide] }).expect("drives");
    for i in 0..10 {
        solve(&mut *e, 0.001 * f64::from(i));
    }
    let before = allocations();
    for i in 10..200 {
        solve(&mut *e, 0.001 * f64::from(i));
    }
    assert_eq!(allocations() - before, 0);
}

/// Free and driven machines in time: after the first steps nothing is allocated, between outputs or at them.
#[test]
fn no_allocation_in_a_step() {
    let crank = coordinate(0);
    let slide = Dynamics { driven: vec![coordinate(1)], ..Dynamics::free() };
    for (b, dynamics, pace) in [
        (andrews(), Dynamics::free(), 1e-4),
        (chain(30), Dynamics::free(), 0.02),
        (lift_blueprint([19.84, 20.8, 19.4]), slide, 0.02),
    ] {
        let mut e = engine_for(true, &b).expect("builds");
        e.assemble(&[]).expect("assembles");
        let mut around = Steady { start: e.coordinate(coordinate(1)).position };
        e.begin(&Dynamics { largest_step: 5.0 * pace, ..dynamics }, &mut around).expect("begins");
        run_to(&mut *e, 10.0 * pace, &mut around);
        let (before, steps) = (allocations(), e.solver_effort().steps);
        for i in 11..60 {
            run_to(&mut *e, f64::from(i) * pace, &mut around);
        }
        assert_eq!(allocations() - before, 0, "{} bodies", b.bodies.len());
        assert!(e.solver_effort().steps > steps && e.coordinate(crank).position.is_finite());
    }
}

/// What is driven moves at 1 mm/s.
struct Steady {
    start: f64,
}

impl Surroundings for Steady {
    fn inputs(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
    fn exact_inputs(&mut self, _: &dyn Readings<Seeded>, _: &mut [Seeded]) {}
    fn drives(&mut self, time: f64, motion: &mut [Reading]) {
        motion[0] = Reading { position: self.start + 1e-3 * time, velocity: 1e-3, acceleration: 0.0 };
    }
    fn switches(&mut self, _: &dyn Readings<f64>, _: &mut [f64]) {}
}

/// All uprights stay parallel: ((N+1)/3 + N) θ̈ = −g ((N+1)/2 + N) cos θ + τ.
#[test]
fn the_n_four_bar_has_its_closed_form() {
    for n in [1, 2, 7, 60, 300] {
        let mut e = engine_for(true, &chain(n)).expect("builds");
        e.assemble(&[]).expect("assembles");
        let first = coordinate(0);
        e.prepare(&Actuation { position: vec![first], rate: vec![first], effort: vec![first] }).expect("one freedom");
        for i in 0..5 {
            let theta = 1.3 - 0.01 * f64::from(i);
            solve(&mut *e, theta);
            let (a, b) = ((n as f64 + 1.0) / 3.0 + n as f64, (n as f64 + 1.0) / 2.0 + n as f64);
            let torque = a * 0.3 + 9.81 * b * theta.cos();
            let last = e.coordinate(coordinate(3 * n - 2));
            assert!((last.position - theta).abs() < 1e-11 && (last.acceleration - 0.3).abs() < 1e-9, "{n}: {last:?}");
            assert!((e.drive(0) - torque).abs() < 1e-9 * torque, "{n}: {} against {torque}", e.drive(0));
            assert!(e.checks().closure < 1e-12 && e.checks().balance < 1e-9, "{n}: {:?}", e.checks());
        }
        assert!(e.reaction(JointId(0)).force[1].is_finite());
    }
}
