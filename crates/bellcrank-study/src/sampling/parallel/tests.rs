use super::*;

fn collect(rows: Range<u64>, threads: usize) -> Vec<(u64, u64)> {
    let mut out = Vec::new();
    let n = for_each_ordered(
        rows,
        threads,
        &AtomicBool::new(false),
        || 0u64,
        |_, i| i * i + 1,
        |i, y| {
            out.push((i, y));
            true
        },
    );
    assert_eq!(n, out.len() as u64);
    out
}

#[test]
fn rows_come_in_order_for_any_number_of_threads() {
    for rows in [0..0, 5..6, 0..64, 3..1000, 0..20_000] {
        let expected: Vec<_> = rows.clone().map(|i| (i, i * i + 1)).collect();
        for threads in [0, 1, 2, 3, 8] {
            assert_eq!(collect(rows.clone(), threads), expected);
        }
    }
}

#[test]
fn cancelling_keeps_a_prefix() {
    for threads in [1, 2, 4] {
        let cancel = AtomicBool::new(false);
        let mut rows = Vec::new();
        let n = for_each_ordered(
            0..1_000_000,
            threads,
            &cancel,
            || (),
            |(), i| i,
            |i, _| {
                rows.push(i);
                cancel.store(i == 777, Ordering::Relaxed);
                true
            },
        );
        assert_eq!((n, rows), (778, (0..778).collect()));
        let n = for_each_ordered(0..1000, threads, &AtomicBool::new(false), || (), |(), i| i, |i, _| i < 99);
        assert_eq!(n, 100);
    }
}

#[test]
fn few_chunks_are_in_flight_when_the_sink_is_slow() {
    use std::sync::atomic::AtomicU64;
    let (made, worst) = (AtomicU64::new(0), AtomicU64::new(0));
    for_each_ordered(
        0..20_000,
        4,
        &AtomicBool::new(false),
        || (),
        |(), _| made.fetch_add(1, Ordering::Relaxed),
        |i, _| {
            worst.fetch_max(made.load(Ordering::Relaxed) - i, Ordering::Relaxed);
            true
        },
    );
    // In waiting, plus one chunk in work a thread, plus the one being delivered.
    assert!(worst.into_inner() <= CHUNK * (AHEAD * 4 + 4 + 1));
}

#[test]
fn a_panic_comes_out_and_does_not_hang() {
    for threads in [1, 3] {
        let outcome = catch_unwind(|| {
            let cancel = AtomicBool::new(false);
            for_each_ordered(0..100_000, threads, &cancel, || (), |(), i| assert_ne!(i, 5000), |_, ()| true)
        });
        assert!(outcome.is_err());
        let outcome = catch_unwind(|| {
            let cancel = AtomicBool::new(false);
            for_each_ordered(
                0..100_000,
                threads,
                &cancel,
                || (),
                |(), i| i,
                |i, _| {
                    assert_ne!(i, 5000);
                    true
                },
            )
        });
        assert!(outcome.is_err());
    }
}
