//! Beams against closed forms and against frequencies of an independent program (Chebyshev collocation).

#![expect(clippy::needless_range_loop, reason = "indices of components are how the formulas are written down")]

use bellcrank_fem::beam::{BeamFault, Line, Section, Segment, ShearRule, axes};
use bellcrank_math::linalg::dense;
use bellcrank_math::{Dual, Real};

use crate::chains::{STRAIGHT, chain, frequencies, generalized, part};

const YOUNG: f64 = 210e9;
const SHEAR: f64 = YOUNG / 2.6;

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found} against {expected}");
}

/// 50 mm along z, 100 mm along y, which is the stiff direction of bending in the plane x–y.
fn steel_bar() -> Line {
    let rule = ShearRule::Given([5.0 / 6.0; 2]);
    Section::rectangle(0.1, 0.05, rule).expect("a section").line(YOUNG, SHEAR, 7850.0)
}

/// Without shear deformation and rotary inertia.
fn slender(line: Line) -> Line {
    Line { shear: [None; 2], rotary: [0.0; 2], ..line }
}

fn general_line() -> Line {
    Line {
        axial: 3.7e7,
        shear: [Some(4.3e6), Some(2.9e6)],
        torsion: 811.0,
        bending: [2.3e4, 5.9e4],
        mass: 3.1,
        rotary: [0.0023, 0.0047],
    }
}

/// Turned and moved, nothing zero.
fn general() -> Segment {
    let axes = axes(&[0.3, -0.7, 0.45], &[0.2, 0.5, 0.9]).expect("not parallel");
    Segment { line: general_line(), length: 0.83, start: [0.21, -0.34, 0.55], axes }
}

#[test]
fn stiffness_in_the_axes_of_the_beam_is_that_of_the_textbooks() {
    let beam = Segment { axes: STRAIGHT, ..general() }.reduce(0).expect("a beam");
    let (line, l) = (general_line(), 0.83_f64);
    let k = |e: usize, f: usize| beam.stiffness[e * 12 + f];
    for (deflection, turn, plane, sign) in [(1, 5, 0, 1.0), (2, 4, 1, -1.0)] {
        let bending = line.bending[1 - plane];
        let phi = 12.0 * bending / (line.shear[plane].expect("given") * l * l);
        let unit = bending / (1.0 + phi);
        close(k(deflection, deflection), 12.0 * unit / l.powi(3), 1e-13, "12 EI / L³");
        close(k(deflection, 6 + deflection), -12.0 * unit / l.powi(3), 1e-13, "−12 EI / L³");
        close(k(deflection, turn), sign * 6.0 * unit / l.powi(2), 1e-13, "6 EI / L²");
        close(k(6 + deflection, turn), -sign * 6.0 * unit / l.powi(2), 1e-13, "−6 EI / L²");
        close(k(turn, turn), (4.0 + phi) * unit / l, 1e-13, "(4 + Φ) EI / L");
        close(k(turn, 6 + turn), (2.0 - phi) * unit / l, 1e-12, "(2 − Φ) EI / L");
    }
    close(k(0, 6), -line.axial / l, 1e-14, "−EA / L");
    close(k(9, 9), line.torsion / l, 1e-14, "GJ / L");
    let coupled = [(0, 1), (1, 2), (1, 4), (2, 5), (3, 4), (0, 9), (5, 10)];
    assert!(coupled.iter().all(|&(e, f)| k(e, f) == 0.0), "nothing else couples");
}

/// Coordinates of a rigid motion: displacement along or turn about axis `k` of the body at its origin.
fn rigid(segment: &Segment, k: usize) -> Vec<f64> {
    let mut d = vec![0.0; 12];
    for end in 0..2 {
        let p: [f64; 3] = std::array::from_fn(|i| segment.start[i] + end as f64 * segment.length * segment.axes[i][0]);
        if k < 3 {
            d[6 * end + k] = 1.0;
        } else {
            let (i, j) = ((k - 2) % 3, (k - 1) % 3);
            // e_k × p
            d[6 * end + i] = -p[j];
            d[6 * end + j] = p[i];
            d[6 * end + k] = 1.0;
        }
    }
    d
}

#[test]
fn rigid_motions_cost_nothing() {
    let segment = general();
    let beam = segment.reduce(3).expect("a beam");
    let n = beam.coordinates();
    for k in 0..6 {
        let d = rigid(&segment, k);
        for e in 0..n {
            let force: f64 = d.iter().enumerate().map(|(f, d)| beam.stiffness[e * n + f] * d).sum();
            let scale: f64 = d.iter().enumerate().map(|(f, d)| (beam.stiffness[e * n + f] * d).abs()).sum();
            assert!(force.abs() <= 1e-13 * scale, "motion {k}, row {e}: {force} of {scale}");
        }
    }
}

/// ∫ x xᵀ dm of a straight bar with thickness.
fn bar_second(segment: &Segment) -> [[f64; 3]; 3] {
    let Segment { line, length, start, axes } = segment;
    let middle: [f64; 3] = std::array::from_fn(|i| start[i] + 0.5 * length * axes[i][0]);
    let about = [line.mass * length * length / 12.0, line.rotary[1], line.rotary[0]];
    std::array::from_fn(|i| {
        std::array::from_fn(|j| {
            let thick: f64 = (0..3).map(|k| about[k] * axes[i][k] * axes[j][k]).sum();
            length * (line.mass * middle[i] * middle[j] + thick)
        })
    })
}

#[test]
fn moved_as_a_rigid_body_it_has_the_inertia_of_a_bar() {
    let segment = general();
    let integrals = segment.reduce(2).expect("a beam").inertia;
    let n = integrals.coordinates();
    let second = bar_second(&segment);
    let near = |found: f64, expected: f64| assert!((found - expected).abs() < 1e-12, "{found} against {expected}");
    near(integrals.mass, 3.1 * 0.83);
    for i in 0..3 {
        near(integrals.first[i], 3.1 * 0.83 * (segment.start[i] + 0.5 * 0.83 * segment.axes[i][0]));
        (0..3).for_each(|j| near(integrals.second[i][j], second[i][j]));
    }
    // e_k × x as a matrix on x: the displacement of a unit turn; a displacement by e_k is one on 1.
    let turn = |k: usize| -> [[f64; 3]; 3] {
        let mut s = [[0.0; 3]; 3];
        (s[(k + 1) % 3][(k + 2) % 3], s[(k + 2) % 3][(k + 1) % 3]) = (-1.0, 1.0);
        s
    };
    for k in 0..3 {
        let (moved, turned) = (rigid(&segment, k), rigid(&segment, 3 + k));
        for i in 0..3 {
            let flow = |d: &[f64]| -> f64 { (0..12).map(|e| d[e] * integrals.flow[e][i]).sum() };
            near(flow(&moved), if i == k { integrals.mass } else { 0.0 });
            near(flow(&turned), (0..3).map(|j| turn(k)[i][j] * integrals.first[j]).sum());
            for j in 0..3 {
                let placed = |d: &[f64]| -> f64 { (0..12).map(|e| d[e] * integrals.placed[e][i][j]).sum() };
                near(placed(&moved), if j == k { integrals.first[i] } else { 0.0 });
                near(placed(&turned), (0..3).map(|l| second[i][l] * turn(k)[j][l]).sum());
                for other in 0..3 {
                    let product: f64 = (0..144)
                        .map(|ef| {
                            let (e, f) = (ef / 12, ef % 12);
                            turned[e] * rigid(&segment, 3 + other)[f] * integrals.products[e * n + f][i][j]
                        })
                        .sum();
                    let expected: f64 =
                        (0..9).map(|ab| turn(k)[i][ab / 3] * second[ab / 3][ab % 3] * turn(other)[j][ab % 3]).sum();
                    near(product, expected);
                }
            }
        }
    }
}

#[test]
fn a_turned_beam_is_the_same_beam() {
    let free = |segment: Segment| {
        let beam = segment.reduce(4).expect("a beam");
        let n = beam.coordinates();
        let rows = |m: &[f64]| m.chunks(n).map(<[f64]>::to_vec).collect::<Vec<_>>();
        generalized(&rows(&beam.stiffness), &rows(&beam.inertia.mass_matrix()))
    };
    let (here, there) = (free(Segment { axes: STRAIGHT, start: [0.0; 3], ..general() }), free(general()));
    for (a, b) in here.iter().zip(&there) {
        assert!((a - b).abs() < 1e-9 * here[15], "{a} and {b}");
    }
    assert!(here[5].abs() < 1e-9 * here[15] && here[6] > 1e-6 * here[15], "six rigid motions");
}

#[test]
fn products_of_shapes_follow_from_their_columns() {
    // Simpson's rule with many slices, straight from the Hermite cubics of a slender beam in the plane x–y.
    let line = Line { rotary: [0.0; 2], ..slender(general_line()) };
    let (l, start) = (0.83_f64, [0.4, -0.2, 0.7]);
    let integrals = Segment { line, length: l, start, axes: STRAIGHT }.reduce(0).expect("a beam").inertia;
    let (count, mut product, mut placed) = (2000, 0.0, 0.0);
    for slice in 0..=count {
        let x = f64::from(slice) / f64::from(count);
        let weight = if slice == 0 || slice == count { 1.0 } else { 2.0 + 2.0 * f64::from(slice % 2) };
        let dm = weight / 3.0 / f64::from(count) * l * line.mass;
        let (stretch, turn) = (x, l * (x * x * x - x * x));
        product += dm * stretch * turn;
        placed += dm * (start[0] + l * x) * turn;
    }
    // Displacement of end 2 along x and its turn about z.
    close(integrals.products[6 * 12 + 11][0][1], product, 1e-11, "∫ φ φ dm");
    close(integrals.placed[11][0][1], placed, 1e-11, "∫ x φ dm");
}

#[test]
fn cantilevers_bend_as_they_should() {
    let (chain, held) = (chain(steel_bar(), 1.0, 3, 0, |_| 0.0), [(0, 0), (0, 1)]);
    let keep = chain.bending(&held);
    let stiffness = part(&chain.stiffness, &keep);
    let tip = keep.iter().position(|&key| key == 6 * 3 + 1).expect("the tip");
    let mut force = vec![0.0; keep.len()];
    force[tip] = 1000.0;
    let bent = dense::solve(&stiffness, &force).expect("held");
    close(bent[tip], 0.000_383_923_809_523_809_47, 1e-12, "1 kN at the tip");
    // 1 kN/m as the weight of the mass: ∫ φ dm times an acceleration.
    let lift = 1000.0 / steel_bar().mass;
    let weight: Vec<f64> =
        keep.iter().map(|&key| (0..4).map(|node| chain.mass[key][6 * node + 1]).sum::<f64>() * lift).collect();
    let bent = dense::solve(&stiffness, &weight).expect("held");
    close(bent[tip], 0.000_144_342_857_142_857_1, 1e-12, "1 kN/m");
}

const CLAMPED_FREE: [f64; 4] =
    [82.894_362_702_067_71, 496.814_531_606_585_4, 1_306.698_072_983_256_5, 2_370.308_405_741_917_3];
const FREE_FREE: [f64; 3] = [513.486_056_063_949, 1_335.675_927_726_611_7, 2_436.332_635_980_434];
const PINNED: [f64; 3] = [230.680_406_671_029_12, 881.522_232_995, 1_857.204_082_405_457_5];
const CLAMPED: [f64; 4] =
    [498.367_105_180_426_56, 1_277.193_391_724_819_3, 2_308.424_516_068_046_6, 3_505.295_554_776_658_3];

/// Largest relative error of the first frequencies over those expected.
fn worst(found: &[f64], expected: &[f64]) -> f64 {
    found.iter().zip(expected).map(|(f, e)| (f / e - 1.0).abs()).fold(0.0, f64::max)
}

#[test]
fn frequencies_of_slender_chains_converge_with_the_fourth_order() {
    let line = slender(steel_bar());
    let unit = (line.bending[1] / line.mass).sqrt() / std::f64::consts::TAU;
    let clamped =
        [1.875_104_068_711_961_f64, 4.694_091_132_974_174, 7.854_757_438_237_613].map(|root| root * root * unit);
    let free = [4.730_040_744_862_704_f64, 7.853_204_624_095_838, 10.995_607_838_001_67].map(|root| root * root * unit);
    let error = |k: usize| {
        let chain = chain(line, 1.0, k, 0, |_| 0.0);
        [worst(&frequencies(&chain, &[(0, 0), (0, 1)]), &clamped), worst(&frequencies(&chain, &[])[2..], &free)]
    };
    for (coarse, fine) in error(10).into_iter().zip(error(20)) {
        let order = (coarse / fine).log2();
        assert!(fine < 1e-4 && (3.8..4.2).contains(&order), "{coarse} then {fine}: order {order}");
    }
}

#[test]
fn frequencies_of_thick_chains_converge_with_the_second_order_and_by_the_known_amount() {
    let line = steel_bar();
    let error = |k: usize| {
        let chain = chain(line, 1.0, k, 0, |_| 0.0);
        frequencies(&chain, &[(0, 0), (k, 0)])[2] / PINNED[2] - 1.0
    };
    let (coarse, fine) = (error(12), error(24));
    let order = (coarse / fine).log2();
    assert!((1.9..2.2).contains(&order), "{coarse} then {fine}: order {order}");
    // Without modes the shear strain is constant in a segment; what it misses of V' = ρA ω² v costs h² ρA ω² / (24 GA).
    let square = (PINNED[2] * std::f64::consts::TAU).powi(2);
    let expected = line.mass * square / (24.0 * line.shear[0].expect("given") * 24.0 * 24.0);
    close(fine, expected, 0.05, "error of the third pinned frequency");
}

#[test]
fn modes_make_up_for_segments() {
    // Two segments, clamped, free and pinned, with a rising number of modes in all four families.
    let error = |modes: usize| {
        let chain = chain(steel_bar(), 1.0, 2, modes, |_| 0.0);
        let worst = |held: &[(usize, usize)], expected: &[f64]| {
            // Modes of the other families are among those found.
            let found = frequencies(&chain, held);
            let nearest = |e: &f64| found.iter().map(|f| (f / e - 1.0).abs()).fold(f64::INFINITY, f64::min);
            expected.iter().map(nearest).fold(0.0, f64::max)
        };
        let clamped = worst(&[(0, 0), (0, 1)], &CLAMPED_FREE);
        clamped.max(worst(&[], &FREE_FREE)).max(worst(&[(0, 0), (2, 0)], &PINNED))
    };
    let errors = [4, 12, 36].map(error);
    // With a constant shear strain in what the ends do, modes come in with the third power of their number.
    assert!(errors[1] < 0.1 * errors[0] && errors[2] < 0.1 * errors[1] && errors[2] < 2e-4, "{errors:?}");
}

#[test]
fn fixed_interface_modes_are_those_of_a_clamped_beam() {
    let hertz = |line: Line| {
        let beam = Segment { line, length: 1.0, start: [0.0; 3], axes: STRAIGHT }.reduce(14).expect("a beam");
        beam.frequencies
    };
    let among = |all: &[f64], expected: f64, tolerance: f64| {
        assert!(all.iter().any(|f| (f / expected - 1.0).abs() < tolerance), "{expected} is not among {all:?}");
    };
    let (thick, thin) = (hertz(steel_bar()), hertz(slender(steel_bar())));
    CLAMPED.iter().for_each(|&expected| among(&thick, expected, 1e-10));
    for root in [4.730_040_744_862_704_f64, 7.853_204_624_095_838, 10.995_607_838_001_67] {
        let line = steel_bar();
        let square = |bending: f64| root * root * (bending / line.mass).sqrt() / std::f64::consts::TAU;
        line.bending.iter().for_each(|&bending| among(&thin, square(bending), 1e-10));
    }
    let line = steel_bar();
    among(&thick, 0.5 * (line.axial / line.mass).sqrt(), 1e-12);
    among(&thick, 0.5 * (line.torsion / (line.rotary[0] + line.rotary[1])).sqrt(), 1e-12);
    assert!(thick.is_sorted() && thick.len() == 14);
}

#[test]
fn modes_are_mass_normalized_and_hold_the_ends() {
    let beam = general().reduce(6).expect("a beam");
    let (n, mass) = (beam.coordinates(), beam.inertia.mass_matrix());
    for e in 12..n {
        for f in 12..n {
            let same = f64::from(e == f);
            let square = beam.frequencies[e - 12] * beam.frequencies[f - 12] * std::f64::consts::TAU.powi(2);
            assert!((mass[e * n + f] - same).abs() < 1e-10);
            assert!((beam.stiffness[e * n + f] - same * square).abs() < 1e-10 * square);
        }
        assert!((0..12).all(|f| beam.stiffness[e * n + f] == 0.0 && beam.stiffness[f * n + e] == 0.0));
    }
}

#[test]
fn damping_damps_every_free_mode_alike_and_no_rigid_motion() {
    let segment = general();
    let beam = segment.reduce(4).expect("a beam");
    let (n, ratio) = (beam.coordinates(), 0.03);
    let damping = beam.damping(ratio).expect("it has mass");
    for k in 0..6 {
        let d = rigid(&segment, k);
        for (e, row) in damping.chunks(n).enumerate() {
            let force: f64 = d.iter().zip(row).map(|(d, c)| c * d).sum();
            // Entries are no larger than the mean of their diagonals.
            let bound = |f: usize| (damping[e * n + e] * damping[f * n + f]).sqrt();
            let scale: f64 = d.iter().enumerate().map(|(f, d)| d.abs() * bound(f)).sum();
            assert!(force.abs() <= 1e-11 * scale, "rigid motion {k}, row {e}: {force} of {scale}");
        }
    }
    let rows = |m: &[f64]| m.chunks(n).map(<[f64]>::to_vec).collect::<Vec<_>>();
    let (stiffness, mass) = (rows(&beam.stiffness), rows(&beam.inertia.mass_matrix()));
    let squares = generalized(&stiffness, &mass);
    let rates = generalized(&rows(&damping), &mass);
    for (square, rate) in squares.iter().zip(&rates).skip(6) {
        close(*rate, 2.0 * ratio * square.sqrt(), 1e-7, "2 ζ ω");
    }
}

#[test]
fn a_pinned_chain_buckles_at_eulers_load() {
    let load = |line: Line, k: usize| {
        let chain = chain(line, 1.0, k, 0, |_| 1.0);
        let keep = chain.bending(&[(0, 0), (k, 0)]);
        let inverse = generalized(&part(&chain.geometric, &keep), &part(&chain.stiffness, &keep));
        1.0 / inverse.last().expect("not empty")
    };
    let line = steel_bar();
    let euler = std::f64::consts::PI.powi(2) * line.bending[1];
    let (coarse, fine) = (load(slender(line), 4) / euler - 1.0, load(slender(line), 8) / euler - 1.0);
    let order = (coarse / fine).log2();
    assert!(fine > 0.0 && fine < 5e-5 && (3.9..4.1).contains(&order), "{coarse}, {fine}: order {order}");
    // Engesser: the shear force of a bent column turns with its axis.
    let sheared = euler / (1.0 + euler / line.shear[0].expect("given"));
    let [coarse, fine] = [8, 16].map(|k| load(line, k) / sheared - 1.0);
    assert!(fine > 0.0 && fine < 1e-4 && (1.9..2.3).contains(&(coarse / fine).log2()), "{coarse}, {fine}");
}

#[test]
fn tension_raises_the_frequencies_of_a_rotating_beam() {
    // Flapping of a slender cantilever: ω √(ρA L⁴ / EI) at Ω √(ρA L⁴ / EI) = γ, hub of radius r L.
    let table = [
        (1.0, 0.0, [3.681_646_259_714_44, 22.181_010_966_539_326]),
        (5.0, 0.0, [6.449_544_478_270_296, 25.446_080_073_341_44]),
        (12.0, 0.0, [13.170_150_281_985_29, 37.603_112_137_534_73]),
        (5.0, 1.0, [8.940_357_888_589_524, 29.352_834_881_375_458]),
    ];
    let line = Line { bending: [1.0; 2], mass: 1.0, axial: 1.0, torsion: 1.0, ..slender(steel_bar()) };
    for (gamma, hub, expected) in table {
        let error = |k: usize| {
            let tension = |i: usize| {
                let at = |x: f64| gamma * gamma * (0.5 * (1.0 - x * x) + hub * (1.0 - x));
                // The mean over the segment, which is what its stretch makes of a varying tension.
                let (a, b) = (i as f64 / k as f64, (i as f64 + 1.0) / k as f64);
                (at(a) + 4.0 * at(0.5 * (a + b)) + at(b)) / 6.0
            };
            let chain = chain(line, 1.0, k, 0, tension);
            let found: Vec<f64> =
                frequencies(&chain, &[(0, 0), (0, 1)]).iter().map(|f| f * std::f64::consts::TAU).collect();
            worst(&found, &expected)
        };
        let (coarse, fine) = (error(8), error(16));
        assert!(fine < 2e-3 && coarse / fine > 3.0, "γ = {gamma}, hub {hub}: {coarse} then {fine}");
    }
}

#[test]
fn derivatives_come_along() {
    type D = Dual<2>;
    let c = |x: f64| D::from_f64(x);
    // By length, and by the thickness of a rectangle.
    let beam = |length: f64, width: f64| {
        let section = Section::rectangle(D::variable(width, 1), c(0.03), ShearRule::Cowper(c(0.3))).expect("a section");
        let line = section.line(c(YOUNG), c(SHEAR), c(7850.0));
        let axes = general().axes.map(|row| row.map(c));
        Segment { line, length: D::variable(length, 0), start: [c(0.1), c(0.2), c(0.3)], axes }
            .reduce(3)
            .expect("a beam")
    };
    let (length, width) = (0.4, 0.02);
    let here = beam(length, width);
    let n = here.coordinates();
    let pick = |b: &bellcrank_fem::beam::Beam<D>, which: usize| match which {
        0 => b.stiffness[8 * n + 5],
        1 => b.stiffness[10 * n + 10],
        2 => b.inertia.second[0][1],
        3 => b.inertia.products[7 * n + 4][2][1],
        4 => b.inertia.placed[9][1][2],
        _ => b.shortenings[1].matrix[7 * n + 11],
    };
    for which in 0..6 {
        for seed in 0..2 {
            let step = 1e-5 * [length, width][seed];
            let at = |side: f64| {
                let moved = [length, width].map(f64::from);
                let shift = |k: usize| moved[k] + if k == seed { side * step } else { 0.0 };
                pick(&beam(shift(0), shift(1)), which).re
            };
            let difference = (at(1.0) - at(-1.0)) / (2.0 * step);
            let exact = pick(&here, which).eps[seed];
            assert!((difference - exact).abs() < 1e-6 * exact.abs(), "{which} by {seed}: {exact}, {difference}");
        }
    }
    // With the shapes of modes frozen, Rayleigh's quotient still has the exact derivative of each ω².
    let mass = here.inertia.mass_matrix();
    for k in 0..3 {
        let (place, square) = ((12 + k) * n + 12 + k, (std::f64::consts::TAU * here.frequencies[k]).powi(2));
        for seed in 0..2 {
            let step = 1e-5 * [length, width][seed];
            let at = |side: f64| {
                let shift = |k: usize| [length, width][k] + if k == seed { side * step } else { 0.0 };
                (std::f64::consts::TAU * beam(shift(0), shift(1)).frequencies[k]).powi(2)
            };
            let exact = here.stiffness[place].eps[seed] - square * mass[place].eps[seed];
            let (difference, scale) = ((at(1.0) - at(-1.0)) / (2.0 * step), square / [length, width][seed]);
            assert!((difference - exact).abs() < 1e-6 * scale, "ω²: {exact}, {difference}");
        }
    }
}

#[test]
fn numbers_that_make_no_beam_are_told() {
    let good = general();
    let fault = |segment: Segment| segment.reduce(0).expect_err("no beam");
    assert_eq!(fault(Segment { length: -0.1, ..good }), BeamFault::Length(-0.1));
    let line = Line { bending: [2.0, 0.0], ..good.line };
    assert_eq!(fault(Segment { line, ..good }), BeamFault::Stiffness("EI_z", 0.0));
    let line = Line { rotary: [-1.0, 0.1], ..good.line };
    assert_eq!(fault(Segment { line, ..good }), BeamFault::Mass("rho I_y", -1.0));
    assert!(matches!(fault(Segment { axes: [[0.7; 3]; 3], ..good }), BeamFault::Axes(_)));
    let line = Line { mass: 0.0, ..good.line };
    assert_eq!(Segment { line, ..good }.reduce(2).expect_err("no mass"), BeamFault::Modes(2));
    assert!(axes(&[1.0, 2.0, 3.0], &[-2.0, -4.0, -6.0]).is_none());
}
