use super::*;

#[test]
fn of_a_plain_column() {
    let found = Reductions::of(&[3.0, -4.0, 2.0, -1.0]).unwrap();
    assert_eq!(found.min, Extreme { value: -4.0, row: 1 });
    assert_eq!(found.max, Extreme { value: 3.0, row: 0 });
    assert_eq!((found.range, found.mean, found.first, found.last), (7.0, 0.0, 3.0, -1.0));
    assert!((found.rms - 7.5_f64.sqrt()).abs() < 1e-15);
    assert_eq!(found.peak(), found.min);
}

#[test]
fn undefined_rows_do_not_count() {
    let found = Reductions::of(&[f64::NAN, 5.0, f64::INFINITY, 7.0, f64::NAN]).unwrap();
    assert_eq!((found.min.row, found.max.row), (1, 3));
    assert_eq!((found.first, found.last, found.mean), (5.0, 7.0, 6.0));
}

#[test]
fn nothing_finite_gives_nothing() {
    assert_eq!(Reductions::of(&[]), None);
    assert_eq!(Reductions::of(&[f64::NAN, f64::INFINITY]), None);
}

#[test]
fn the_first_of_equal_extremes_is_named() {
    let found = Reductions::of(&[1.0, 2.0, 1.0, 2.0]).unwrap();
    assert_eq!((found.min.row, found.max.row), (0, 1));
}

#[test]
fn huge_and_tiny_numbers_keep_their_rms() {
    for size in [1e-200, 1e200] {
        let found = Reductions::of(&[size, 0.0, -size, size]).unwrap();
        assert!((found.rms / (size * 0.75_f64.sqrt()) - 1.0).abs() < 1e-14);
    }
    assert_eq!(Reductions::of(&[0.0, 0.0]).unwrap().rms, 0.0);
}
