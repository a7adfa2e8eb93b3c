use super::*;

/// x has order 2^s − 1 modulo the polynomial.
fn is_primitive(polynomial: u32, degree: usize) -> bool {
    let times_x = |a: u32| if a >> (degree - 1) & 1 == 1 { (a << 1) ^ polynomial } else { a << 1 };
    let mut a = if degree == 1 { 1 } else { 2 };
    let mut order = 1;
    while a != 1 {
        a = times_x(a);
        order += 1;
    }
    order == (1 << degree) - 1
}

#[test]
fn the_table_holds_different_primitive_polynomials_and_odd_numbers() {
    for (i, (polynomial, first)) in DIMENSIONS.iter().enumerate() {
        assert!(is_primitive(*polynomial, first.len()), "{polynomial:b}");
        assert!(first.iter().enumerate().all(|(k, m)| m % 2 == 1 && *m < 2 << k));
        assert!(DIMENSIONS[..i].iter().all(|other| other.0 != *polynomial));
    }
}

#[test]
fn every_dimension_is_even_in_every_power_of_two() {
    let sobol = Sobol::new(Sobol::DIMENSIONS, 42).unwrap();
    let points: Vec<_> = (0..256).map(|i| sobol.point(i).unwrap()).collect();
    for j in 0..Sobol::DIMENSIONS {
        let mut cells: Vec<usize> = points.iter().map(|p| (p[j] * 256.0) as usize).collect();
        cells.sort_unstable();
        assert!(cells.iter().enumerate().all(|(k, cell)| k == *cell), "dimension {j}");
    }
}

#[test]
fn the_first_two_dimensions_are_even_in_all_boxes() {
    // A (0, 8, 2)-net: every box of area 2^-8 holds one point.
    let sobol = Sobol::new(2, 7).unwrap();
    for k in 0..=8 {
        let (a, b) = (1usize << k, 1usize << (8 - k));
        let mut boxes = vec![0; 256];
        for i in 0..256 {
            let p = sobol.point(i).unwrap();
            boxes[(p[0] * a as f64) as usize * b + (p[1] * b as f64) as usize] += 1;
        }
        assert!(boxes.iter().all(|n| *n == 1), "{a} × {b}");
    }
}

#[test]
fn a_smooth_integral_converges_faster_than_by_chance() {
    let d = 6;
    let error = |seed: u64| {
        let sobol = Sobol::new(d, seed).unwrap();
        let f = |p: Vec<f64>| p.iter().map(|x| 1.0 + 0.5 * (x - 0.5)).product::<f64>();
        (0..4096).map(|i| f(sobol.point(i).unwrap())).sum::<f64>() / 4096.0 - 1.0
    };
    let rms = ((0..16).map(|seed| error(seed).powi(2)).sum::<f64>() / 16.0).sqrt();
    // By chance: σ/√n = 0.36/64.
    assert!(rms < 5e-5, "{rms}");
}

#[test]
fn limits_are_typed_errors() {
    assert_eq!(Sobol::new(65, 0).unwrap_err(), SobolError::Dimensions { asked: 65, most: 64 });
    let sobol = Sobol::new(3, 0).unwrap();
    assert!(sobol.point(Sobol::POINTS - 1).is_some() && sobol.point(Sobol::POINTS).is_none());
    assert_eq!(Sobol::new(0, 0).unwrap().point(5), Some(vec![]));
}
