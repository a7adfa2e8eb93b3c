//! Long chains: the closed form of the N-four-bar, and no allocation in the inner step.

use crate::build::*;
use crate::machines::{chain, lift};
use bellcrank_multibody::{Actuation, Engine, JointId, engine_for};
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
