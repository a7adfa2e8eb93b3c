//! Sections of beams against tables, closed forms and equilibrium.

use bellcrank_fem::beam::{Line, Section, SectionFault, SectionForces, SectionPoint, Segment, ShearRule, axes};
use bellcrank_math::linalg::dense;

const COWPER: ShearRule = ShearRule::Cowper(0.3);

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found} against {expected}");
}

#[test]
fn torsion_of_rectangles_is_that_of_the_table() {
    // Timoshenko and Goodier, art. 109: sides' ratio, J / (a b³), W / (a b²).
    let table = [
        (1.0, 0.1406, 0.208),
        (1.2, 0.166, 0.219),
        (1.5, 0.196, 0.231),
        (2.0, 0.229, 0.246),
        (2.5, 0.249, 0.258),
        (3.0, 0.263, 0.267),
        (4.0, 0.281, 0.282),
        (5.0, 0.291, 0.291),
        (10.0, 0.312, 0.312),
    ];
    let b = 0.017_f64;
    for (ratio, constant, modulus) in table {
        let a = ratio * b;
        for (width, height, side) in [(b, a, 4), (a, b, 6)] {
            let section = Section::rectangle(width, height, COWPER).expect("a section");
            close(section.torsion, constant * a * b.powi(3), 3e-3, "J");
            let peak = section.points[side].torsion.map(f64::abs).into_iter().fold(0.0, f64::max);
            close(1.0 / peak, modulus * a * b * b, 3e-3, "W");
        }
    }
    let square = Section::rectangle(b, b, COWPER).expect("a section");
    close(square.torsion, 0.140_577_014_955 * b.powi(4), 1e-10, "J of a square");
    close(square.points[4].torsion[1], -square.points[6].torsion[0], 1e-13, "both pairs of sides of a square");
}

#[test]
fn torsion_of_rectangles_is_that_of_differences() {
    // Prandtl's stress function on a grid, ∇²φ = −2, J = 2 ∫ φ dA, by successive over-relaxation.
    let (width, height, n) = (0.8_f64, 1.3_f64, 52_usize);
    let grid = |n: usize| {
        let (rows, columns) = (n * 13 / 13, n * 8 / 13);
        let h = height / rows as f64;
        let mut phi = vec![vec![0.0_f64; columns + 1]; rows + 1];
        for _ in 0..40 * n {
            for i in 1..rows {
                for j in 1..columns {
                    let mean = 0.25 * (phi[i - 1][j] + phi[i + 1][j] + phi[i][j - 1] + phi[i][j + 1] + 2.0 * h * h);
                    phi[i][j] += 1.85 * (mean - phi[i][j]);
                }
            }
        }
        2.0 * h * h * phi.iter().flatten().sum::<f64>()
    };
    // Second order: extrapolated.
    let extrapolated = (4.0 * grid(n) - grid(n / 2)) / 3.0;
    let section = Section::rectangle(width, height, COWPER).expect("a section");
    close(section.torsion, extrapolated, 1e-4, "J");
}

#[test]
fn shear_coefficients_are_coopers_with_their_limits() {
    let rectangle = Section::rectangle(0.03, 0.05, COWPER).expect("a section").shear.expect("given");
    close(rectangle[0], 13.0 / 15.3, 1e-14, "rectangle");
    let circle = Section::circle(0.03, COWPER).expect("a section").shear.expect("given");
    close(circle[1], 7.8 / 8.8, 1e-14, "circle");
    // A thin round tube: 2 (1 + ν) / (4 + 3 ν).
    let tube = Section::tube(1.0, 1e-6, COWPER).expect("a section").shear.expect("given");
    close(tube[0], 2.6 / 4.9, 1e-5, "thin tube");
    // Flanges that vanish leave plates: box and I become rectangles along their webs.
    let plate = Section::hollow(1e-6, 1.0, 1e-9, 1e-9, COWPER).expect("a section").shear.expect("given");
    close(plate[1], 13.0 / 15.3, 1e-4, "box without flanges");
    let plate = Section::i_beam(1e-6, 1.0, 9e-7, 1e-9, COWPER).expect("a section").shear.expect("given");
    close(plate[1], 13.0 / 15.3, 1e-4, "I without flanges");
    // A square box of even walls after Cowper at ν = 0.3: 20 (1 + ν) / (48 + 39 ν).
    let square = Section::hollow(1.0, 1.0, 1e-6, 1e-6, COWPER).expect("a section").shear.expect("given");
    close(square[0], 26.0 / 59.7, 1e-5, "square box");
    close(square[0], square[1], 1e-14, "both ways");
    assert!(Section::circle(0.03, ShearRule::Rigid).expect("a section").shear.is_none());
}

/// ∫ f dA over what `inside` a rectangle, by midpoints.
fn integral(width: f64, height: f64, inside: impl Fn(f64, f64) -> bool, f: impl Fn(f64, f64) -> f64) -> f64 {
    let n = 800;
    let (dy, dz) = (width / f64::from(n), height / f64::from(n));
    let cell = |k: i32| {
        let (y, z) = ((f64::from(k % n) + 0.5) * dy - 0.5 * width, (f64::from(k / n) + 0.5) * dz - 0.5 * height);
        if inside(y, z) { f(y, z) * dy * dz } else { 0.0 }
    };
    (0..n * n).map(cell).sum()
}

#[test]
fn areas_and_second_moments_are_those_of_the_shapes() {
    let (b, h, web, flange) = (0.8, 1.0, 0.1, 0.15);
    let hollow = |y: f64, z: f64| y.abs() > 0.5 * b - web || z.abs() > 0.5 * h - flange;
    let profile = |y: f64, z: f64| y.abs() < 0.5 * web || z.abs() > 0.5 * h - flange;
    let tube = |y: f64, z: f64| (0.3..0.4).contains(&y.hypot(z));
    let whole = |_: f64, _: f64| true;
    let check = |section: Section, inside: &dyn Fn(f64, f64) -> bool, tolerance: f64| {
        close(section.area, integral(b, h, inside, |_, _| 1.0), tolerance, "A");
        close(section.second[0], integral(b, h, inside, |_, z| z * z), tolerance, "I_y");
        close(section.second[1], integral(b, h, inside, |y, _| y * y), tolerance, "I_z");
    };
    check(Section::rectangle(b, h, COWPER).expect("a section"), &whole, 1e-5);
    check(Section::hollow(b, h, web, flange, COWPER).expect("a section"), &hollow, 1e-5);
    check(Section::i_beam(b, h, web, flange, COWPER).expect("a section"), &profile, 1e-5);
    check(Section::tube(0.8, 0.1, COWPER).expect("a section"), &tube, 1e-3);
    check(Section::circle(0.8, COWPER).expect("a section"), &|y, z| y.hypot(z) < 0.4, 1e-3);
}

/// The points with a place near (y, z).
fn at(section: &Section, y: f64, z: f64) -> SectionPoint {
    let near = |point: &&SectionPoint| (point.place[0] - y).abs() + (point.place[1] - z).abs() < 1e-9;
    *section.points.iter().find(near).expect("a point there")
}

#[test]
fn shear_stress_follows_from_the_part_cut_off() {
    // V S / (I t) with the static moment S of what lies above the cut, by midpoints.
    let (b, h, web, flange) = (0.8, 1.0, 0.1, 0.15);
    let hollow = |y: f64, z: f64| y.abs() > 0.5 * b - web || z.abs() > 0.5 * h - flange;
    let profile = |y: f64, z: f64| y.abs() < 0.5 * web || z.abs() > 0.5 * h - flange;
    let above = |inside: &dyn Fn(f64, f64) -> bool, cut: f64| integral(b, h, |y, z| inside(y, z) && z > cut, |_, z| z);
    let boxed = Section::hollow(b, h, web, flange, COWPER).expect("a section");
    let neutral = above(&hollow, 0.0) / (boxed.second[0] * 2.0 * web);
    close(at(&boxed, 0.5 * b, 0.0).shear_z[1], neutral, 1e-5, "middle of the box's web");
    let corner = above(&hollow, 0.5 * h - flange) / (boxed.second[0] * 2.0 * web);
    close(at(&boxed, -0.5 * b, -0.5 * h).shear_z[1], corner, 1e-5, "corner of the box");
    let right = integral(b, h, |y, z| hollow(y, z) && y > 0.0, |y, _| y) / (boxed.second[1] * 2.0 * flange);
    close(at(&boxed, 0.0, -0.5 * h).shear_y[0], right, 1e-5, "middle of the box's flange");
    let beam = Section::i_beam(b, h, web, flange, COWPER).expect("a section");
    let neutral = above(&profile, 0.0) / (beam.second[0] * web);
    close(at(&beam, 0.5 * web, 0.0).shear_z[1], neutral, 1e-5, "middle of the I's web");
    let end = above(&profile, 0.5 * h - flange) / (beam.second[0] * web);
    close(at(&beam, -0.5 * web, 0.5 * h - flange).shear_z[1], end, 1e-5, "end of the I's web");
    let tube = Section::tube(0.8, 0.1, COWPER).expect("a section");
    let half = integral(b, b, |y, z| z > 0.0 && (0.3..0.4).contains(&y.hypot(z)), |_, z| z);
    close(at(&tube, 0.4, 0.0).shear_z[1], half / (tube.second[0] * 0.2), 1e-3, "neutral axis of the tube");
}

#[test]
fn shear_flow_of_a_box_balances_at_its_corners() {
    // What arrives at a corner by the wall leaves by the flange: forces that hold both walls' flows at once.
    let section = Section::hollow(0.06, 0.09, 0.002, 0.002, COWPER).expect("a section");
    let forces = SectionForces { shear: [730.0, -410.0], torsion: 25.0, ..SectionForces::default() };
    let flow = |up: f64, right: f64| {
        let point = at(&section, right * 0.03, up * 0.045);
        // Along the wall, anticlockwise about x.
        right * section.stress(&point, &forces)[2] * 0.002
    };
    // ∫ r × q ds is the torque, as shear through the centre makes none: the mean of the four corners is Bredt's flow.
    let mean = 0.25 * (flow(1.0, 1.0) + flow(1.0, -1.0) + flow(-1.0, -1.0) + flow(-1.0, 1.0));
    close(mean, 25.0 / (2.0 * 0.058 * 0.088), 1e-12, "Bredt");
    // Right of the upper flange V_z adds to it, left it takes away; V_y the other way round.
    let (right, left) = (flow(1.0, 1.0) - mean, flow(1.0, -1.0) - mean);
    let end = 0.06 * 0.002 * 0.088 / 2.0 / (2.0 * section.second[0]);
    close(right - left, 2.0 * -410.0 * end, 1e-12, "V_z");
    let side = 0.09 * 0.002 * 0.058 / 2.0 / (2.0 * section.second[1]);
    close(right + left, -2.0 * 730.0 * side, 1e-12, "V_y");
}

/// A cantilever in general position with forces at its tip: (section, segment, coordinates, force and moment in its axes).
fn cantilever(rule: ShearRule) -> (Section, Segment, Vec<f64>, [f64; 6]) {
    let section = Section::rectangle(0.02, 0.03, rule).expect("a section");
    let axes = axes(&[0.3, -0.7, 0.45], &[0.2, 0.5, 0.9]).expect("not parallel");
    let segment = Segment { line: section.line(210e9, 81e9, 7850.0), length: 0.6, start: [0.1, 0.2, 0.3], axes };
    let beam = segment.reduce(0).expect("a beam");
    let load = [900.0, -130.0, 210.0, 17.0, 23.0, -31.0];
    let turned = |v: &[f64]| -> Vec<f64> { (0..3).map(|i| (0..3).map(|j| axes[i][j] * v[j]).sum()).collect() };
    let force: Vec<f64> = turned(&load[..3]).into_iter().chain(turned(&load[3..])).collect();
    let stiffness: Vec<Vec<f64>> = (6..12).map(|e| (6..12).map(|f| beam.stiffness[e * 12 + f]).collect()).collect();
    let tip = dense::solve(&stiffness, &force).expect("held");
    let d = std::iter::repeat_n(0.0, 6).chain(tip).collect();
    (section, segment, d, load)
}

#[test]
fn forces_in_the_section_are_in_equilibrium_with_those_at_the_tip() {
    for rule in [COWPER, ShearRule::Rigid] {
        let (_, segment, d, [nx, vy, vz, tx, my, mz]) = cantilever(rule);
        let beam = segment.reduce(0).expect("a beam");
        for xi in [0.0, 0.37, 1.0] {
            let found = beam.forces(&d, xi, false);
            let arm = segment.length * (1.0 - xi);
            close(found.axial, nx, 1e-9, "N");
            close(found.shear[0], vy, 1e-9, "V_y");
            close(found.shear[1], vz, 1e-9, "V_z");
            close(found.torsion, tx, 1e-9, "T");
            close(found.bending[0], my - arm * vz, 1e-9, "M_y");
            close(found.bending[1], mz + arm * vy, 1e-9, "M_z");
        }
    }
}

#[test]
fn stress_in_the_corners_and_on_the_sides_of_a_rectangle() {
    let (section, segment, d, [nx, vy, vz, tx, my, mz]) = cantilever(COWPER);
    let forces = segment.reduce(0).expect("a beam").forces(&d, 0.0, false);
    let (b, h): (f64, f64) = (0.02, 0.03);
    let (my, mz) = (my - 0.6 * vz, mz + 0.6 * vy);
    let (about_y, about_z) = (my / (b * h * h / 6.0), mz / (h * b * b / 6.0));
    let found: Vec<f64> = section.von_mises(&forces).collect();
    let corners = [(1.0, 1.0), (-1.0, 1.0), (-1.0, -1.0), (1.0, -1.0)];
    for (k, (y, z)) in corners.into_iter().enumerate() {
        close(found[k], (nx / (b * h) + z * about_y - y * about_z).abs(), 1e-9, "corner");
    }
    // In the middle of the long sides torsion by the table (0.231 at 1.5) and 1.5 V / A.
    for (k, y) in [(4, 1.0), (5, -1.0)] {
        let normal = nx / (b * h) - y * about_z;
        let shear = y * tx / (0.231 * h * b * b) + 1.5 * vz / (b * h);
        close(found[k], (normal * normal + 3.0 * shear * shear).sqrt(), 3e-3, "side");
    }
}

#[test]
fn a_bent_axis_is_longer_than_its_chord() {
    // A half wave of sag held at both ends: tension E A δ with δ = ½ ∫ v'² dx / L, here of the cubic with turns ∓t at its ends.
    let line = Line { axial: 2.0e6, shear: [None; 2], torsion: 1.0, bending: [3.0, 5.0], mass: 1.0, rotary: [0.0; 2] };
    let axes = axes(&[0.3, -0.7, 0.45], &[0.2, 0.5, 0.9]).expect("not parallel");
    let beam = Segment { line, length: 0.9, start: [0.0; 3], axes }.reduce(0).expect("a beam");
    let t = 0.01;
    let mut d = vec![0.0; 12];
    (0..3).for_each(|i| (d[3 + i], d[9 + i]) = (t * axes[i][2], -t * axes[i][2]));
    // v = t x (1 − x/L): ∫ v'² dx = t² L / 3.
    close(beam.forces(&d, 0.5, true).axial, 2.0e6 * t * t / 6.0, 1e-12, "tension of a sagging beam");
    assert!(beam.forces(&d, 0.5, false).axial.abs() < 1e-9);
    // The shortenings together are the same length along the axis.
    let half: f64 = beam
        .shortenings
        .iter()
        .map(|s| {
            let work: f64 = (0..144).map(|k| d[k / 12] * s.matrix[k] * d[k % 12]).sum();
            0.5 * work * axes[s.along - 6][0]
        })
        .sum();
    close(half, 0.9 * t * t / 6.0, 1e-12, "length");
}

#[test]
fn sizes_that_make_no_section_are_told() {
    let fault = |section: Result<Section, SectionFault>| section.expect_err("no section");
    assert_eq!(fault(Section::rectangle(0.1, -0.2, COWPER)), SectionFault::Size("height", -0.2));
    assert_eq!(fault(Section::tube(0.1, 0.06, COWPER)), SectionFault::Wall("wall", 0.06, 0.05));
    assert_eq!(fault(Section::hollow(0.1, 0.2, 0.05, 0.01, COWPER)), SectionFault::Wall("web", 0.05, 0.05));
    assert_eq!(fault(Section::i_beam(0.1, 0.2, 0.01, 0.1, COWPER)), SectionFault::Wall("flange", 0.1, 0.1));
    assert!(matches!(fault(Section::circle(f64::NAN, COWPER)), SectionFault::Size("diameter", _)));
}
