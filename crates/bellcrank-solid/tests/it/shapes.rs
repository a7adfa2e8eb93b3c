//! Shapes with known volume, centre and inertia: closed forms of simple bodies, added and taken away, in general
//! position in plan.

use std::f64::consts::PI;

use bellcrank_solid::{Cut, CutShape, Eye, Link, MassProperties, Profile, Revolved, Web};

use crate::parts::{bar, corners, eye, link, plate, through};

/// Integrals over a prism: area, first and second moments in plan about the origin; and its heights.
#[derive(Clone, Copy)]
struct Known {
    /// 1, x, y, xx, yy, xy.
    plan: [f64; 6],
    z: [f64; 2],
}

/// Volume, first and second moments: 1, x, y, z, xx, yy, zz, yz, zx, xy.
type Sums = [f64; 10];

impl Known {
    fn disc(center: [f64; 2], d: f64, z: [f64; 2]) -> Known {
        let a = PI * d * d / 4.0;
        Known::about(center, a, [a * d * d / 16.0, a * d * d / 16.0, 0.0], z)
    }

    /// From an area, its centre and its second moments about it.
    fn about([x, y]: [f64; 2], a: f64, [xx, yy, xy]: [f64; 3], z: [f64; 2]) -> Known {
        Known { plan: [a, a * x, a * y, xx + a * x * x, yy + a * y * y, xy + a * x * y], z }
    }

    /// A polygon by the textbook sums over its corners.
    fn polygon(corners: &[[f64; 2]], z: [f64; 2]) -> Known {
        let mut plan = [0.0; 6];
        for ([x, y], [u, v]) in corners.iter().zip(corners.iter().cycle().skip(1)) {
            let c = x * v - u * y;
            let terms = [
                c / 2.0,
                (x + u) * c / 6.0,
                (y + v) * c / 6.0,
                (x * x + x * u + u * u) * c / 12.0,
                (y * y + y * v + v * v) * c / 12.0,
                (x * v + 2.0 * x * y + 2.0 * u * v + u * y) * c / 24.0,
            ];
            plan.iter_mut().zip(terms).for_each(|(p, t)| *p += t);
        }
        Known { plan, z }
    }

    /// The part of a disc within an angle either side of a direction.
    fn sector(center: [f64; 2], r: f64, direction: f64, half: f64, z: [f64; 2]) -> Known {
        let a = r * r * half;
        let reach = r * r * r * 2.0 / 3.0 * half.sin();
        let (s, c) = direction.sin_cos();
        let (along, aside) =
            (r.powi(4) / 4.0 * (half + half.sin() * half.cos()), r.powi(4) / 4.0 * (half - half.sin() * half.cos()));
        let (xx, yy, xy) = (along * c * c + aside * s * s, along * s * s + aside * c * c, (along - aside) * s * c);
        let [x, y] = center;
        let (u, v) = (reach * c, reach * s);
        let plan = [
            a,
            a * x + u,
            a * y + v,
            xx + 2.0 * x * u + a * x * x,
            yy + 2.0 * y * v + a * y * y,
            xy + x * v + y * u + a * x * y,
        ];
        Known { plan, z }
    }

    fn times(mut self, factor: f64) -> Known {
        self.plan.iter_mut().for_each(|p| *p *= factor);
        self
    }

    fn sums(&self) -> Sums {
        let [a, x, y, xx, yy, xy] = self.plan;
        let [l, h] = self.z;
        let (t, tz, tzz) = (h - l, (h * h - l * l) / 2.0, (h.powi(3) - l.powi(3)) / 3.0);
        [a * t, x * t, y * t, a * tz, xx * t, yy * t, a * tzz, y * tz, x * tz, xy * t]
    }
}

fn assert_is(link: &Link<f64>, of: &[Known]) {
    let stack = link.build().unwrap_or_else(|faults| panic!("{faults:?}"));
    let mut sums = [0.0; 10];
    of.iter().for_each(|known| sums.iter_mut().zip(known.sums()).for_each(|(s, k)| *s += k));
    assert_properties(&stack.mass_properties(7850.0), sums, 7850.0);
}

/// Compares with sums about the origin.
fn assert_properties(found: &MassProperties<f64>, s: Sums, density: f64) {
    let v = s[0];
    let c = [s[1] / v, s[2] / v, s[3] / v];
    let [xx, yy, zz] = [s[4] - v * c[0] * c[0], s[5] - v * c[1] * c[1], s[6] - v * c[2] * c[2]];
    let [yz, zx, xy] = [s[7] - v * c[1] * c[2], s[8] - v * c[2] * c[0], s[9] - v * c[0] * c[1]];
    let inertia = [[yy + zz, -xy, -zx], [-xy, zz + xx, -yz], [-zx, -yz, xx + yy]];
    assert!((found.volume / v - 1.0).abs() < 1e-12, "volume {} for {v}", found.volume);
    assert!((found.mass / (v * density) - 1.0).abs() < 1e-12);
    let size = v.cbrt();
    for (f, c) in found.center.iter().zip(c) {
        assert!((f - c).abs() < 1e-12 * size.max(1.0), "centre {f} for {c}");
    }
    let scale = inertia.iter().flatten().fold(0.0, |a: f64, i| a.max(i.abs()));
    for (f, i) in found.inertia.iter().flatten().zip(inertia.iter().flatten()) {
        assert!((f / density - i).abs() < 1e-11 * scale, "inertia {} for {i}", f / density);
    }
}

/// A place along and aside of a line from (0.21, -0.13) that is turned by 0.7 rad.
fn place(along: f64, aside: f64) -> [f64; 2] {
    let (s, c) = 0.7_f64.sin_cos();
    [0.21 + along * c - aside * s, -0.13 + along * s + aside * c]
}

fn places(of: &[[f64; 2]]) -> Vec<[f64; 2]> {
    of.iter().map(|p| place(p[0], p[1])).collect()
}

const Z: [f64; 2] = [-0.011, 0.017];

/// Two eyes a length apart.
fn eyes(length: f64, bores: [f64; 2], outers: [f64; 2]) -> Vec<Eye<f64>> {
    vec![eye(place(0.0, 0.0), bores[0], outers[0], Z), eye(place(length, 0.0), bores[1], outers[1], Z)]
}

fn rectangle(from: f64, to: f64, half: f64, z: [f64; 2]) -> Known {
    Known::polygon(&places(&[[from, -half], [to, -half], [to, half], [from, half]]), z)
}

#[test]
fn ring() {
    let link = Link { eyes: vec![eye(place(0.0, 0.0), 0.04, 0.11, Z)], ..link() };
    assert_is(&link, &[Known::disc(place(0.0, 0.0), 0.11, Z), Known::disc(place(0.0, 0.0), 0.04, Z).times(-1.0)]);
}

#[test]
fn boss_of_two_heights() {
    let wide = Eye { layers: vec![[-0.03, 0.02]], ..eye(place(0.01, 0.0), 0.02, 0.05, Z) };
    let link = Link { eyes: vec![eye(place(0.0, 0.0), 0.0, 0.11, Z), wide], ..link() };
    let small = |z| Known::disc(place(0.01, 0.0), 0.05, z);
    let bore = Known::disc(place(0.01, 0.0), 0.02, [-0.03, 0.02]).times(-1.0);
    assert_is(&link, &[Known::disc(place(0.0, 0.0), 0.11, Z), small([-0.03, Z[0]]), small([Z[1], 0.02]), bore]);
}

#[test]
fn bar_with_round_ends() {
    let link = Link {
        eyes: eyes(0.5, [0.03, 0.02], [0.09, 0.09]),
        webs: vec![bar([0, 1], [0.09; 2], Z, Profile::Flat)],
        ..link()
    };
    let end = |along: f64, direction: f64| Known::sector(place(along, 0.0), 0.045, direction, PI / 2.0, Z);
    assert_is(
        &link,
        &[
            rectangle(0.0, 0.5, 0.045, Z),
            end(0.0, 0.7 + PI),
            end(0.5, 0.7),
            Known::disc(place(0.0, 0.0), 0.03, Z).times(-1.0),
            Known::disc(place(0.5, 0.0), 0.02, Z).times(-1.0),
        ],
    );
}

/// Discs joined by a straight bar narrower than they are: from chord to chord, and the discs.
fn narrow(length: f64, radii: [f64; 2], half: f64, z: [f64; 2]) -> Vec<Known> {
    let reach = radii.map(|r| (r * r - half * half).sqrt());
    let mut known = vec![rectangle(reach[0], length - reach[1], half, z)];
    for (i, direction) in [(0, 0.7), (1, 0.7 + PI)] {
        let center = place(if i == 0 { 0.0 } else { length }, 0.0);
        let angle = (half / radii[i]).asin();
        // The sector beside the chord is the triangle and the segment behind it; the segment is the disc's.
        known.push(Known::disc(center, 2.0 * radii[i], z));
        known.push(Known::sector(center, radii[i], direction, angle, z).times(-1.0));
        let side = if i == 0 { 1.0 } else { -1.0 };
        let along = if i == 0 { 0.0 } else { length };
        let corners = [[along, 0.0], [along + side * reach[i], -side * half], [along + side * reach[i], side * half]];
        known.push(Known::polygon(&places(&corners), z));
    }
    known
}

#[test]
fn narrow_bar() {
    let link = Link {
        eyes: eyes(0.4, [0.0, 0.0], [0.1, 0.12]),
        webs: vec![bar([0, 1], [0.05; 2], Z, Profile::Flat)],
        ..link()
    };
    assert_is(&link, &narrow(0.4, [0.05, 0.06], 0.025, Z));
}

#[test]
fn thin_bar_between_thick_eyes() {
    let z = [-0.004, 0.006];
    let link = Link {
        eyes: eyes(0.4, [0.0, 0.0], [0.1, 0.12]),
        webs: vec![bar([0, 1], [0.05; 2], z, Profile::Flat)],
        ..link()
    };
    let mut known = narrow(0.4, [0.05, 0.06], 0.025, z);
    for layer in [[Z[0], z[0]], [z[1], Z[1]]] {
        known.push(Known::disc(place(0.0, 0.0), 0.1, layer));
        known.push(Known::disc(place(0.4, 0.0), 0.12, layer));
    }
    assert_is(&link, &known);
}

#[test]
fn tapered_bar_alone_within_its_eyes() {
    // Small eyes within a wide bar: the bar's own corners are all that is left outside.
    let link = Link {
        eyes: vec![eye(place(0.0, 0.0), 0.0, 0.02, Z), eye(place(0.3, 0.0), 0.0, 0.02, Z)],
        webs: vec![bar([0, 1], [0.1, 0.06], Z, Profile::Flat)],
        ..link()
    };
    let half_disc = |along: f64, d: f64| Known::sector(place(along, 0.0), 0.01, d, PI / 2.0, Z);
    let taper = Known::polygon(&places(&[[0.0, -0.05], [0.3, -0.03], [0.3, 0.03], [0.0, 0.05]]), Z);
    assert_is(&link, &[taper, half_disc(0.0, 0.7 + PI), half_disc(0.3, 0.7)]);
}

/// What is left out of a bar between two discs as wide as it: a narrower strip that ends at the discs.
fn recess(length: f64, radius: f64, half: f64, z: [f64; 2]) -> Vec<Known> {
    let mut strip = vec![rectangle(0.0, length, half, z)];
    let angle = (half / radius).asin();
    let reach = (radius * radius - half * half).sqrt();
    for (along, direction, side) in [(0.0, 0.7, 1.0), (length, 0.7 + PI, -1.0)] {
        let center = place(along, 0.0);
        strip.push(Known::sector(center, radius, direction, angle, z).times(-1.0));
        // Beside the sector, triangles between the axis, the strip's side and the chord.
        for up in [1.0, -1.0] {
            let corners = [[along, 0.0], [along + side * reach, up * half], [along, up * half]];
            strip.push(Known::polygon(&places(&corners), z).times(-side * up));
        }
    }
    strip
}

fn round_bar(length: f64, radius: f64, z: [f64; 2]) -> Vec<Known> {
    let end = |along: f64, direction: f64| Known::sector(place(along, 0.0), radius, direction, PI / 2.0, z);
    vec![rectangle(0.0, length, radius, z), end(0.0, 0.7 + PI), end(length, 0.7)]
}

#[test]
fn box_section() {
    let profile = Profile::Box { wall: 0.008, skin: 0.003 };
    let link = Link { eyes: eyes(0.5, [0.0; 2], [0.09; 2]), webs: vec![bar([0, 1], [0.09; 2], Z, profile)], ..link() };
    let mut known = round_bar(0.5, 0.045, Z);
    known.extend(recess(0.5, 0.045, 0.037, [Z[0] + 0.003, Z[1] - 0.003]).into_iter().map(|k| k.times(-1.0)));
    assert_is(&link, &known);
}

#[test]
fn ladder_of_two_strips() {
    let profile = Profile::Box { wall: 0.008, skin: 0.0 };
    let link = Link { eyes: eyes(0.5, [0.0; 2], [0.09; 2]), webs: vec![bar([0, 1], [0.09; 2], Z, profile)], ..link() };
    let mut known = round_bar(0.5, 0.045, Z);
    known.extend(recess(0.5, 0.045, 0.037, Z).into_iter().map(|k| k.times(-1.0)));
    assert_is(&link, &known);
}

#[test]
fn i_section() {
    let profile = Profile::I { flange: 0.012, web: 0.006 };
    let link = Link { eyes: eyes(0.5, [0.0; 2], [0.09; 2]), webs: vec![bar([0, 1], [0.09; 2], Z, profile)], ..link() };
    let mut known = round_bar(0.5, 0.045, Z);
    for z in [[Z[0], 0.0], [0.006, Z[1]]] {
        known.extend(recess(0.5, 0.045, 0.033, z).into_iter().map(|k| k.times(-1.0)));
    }
    assert_is(&link, &known);
}

/// Hull of discs round corners that go counter-clockwise: the polygon of touching places, and sectors.
fn hull_of(discs: &[([f64; 2], f64)], z: [f64; 2]) -> Vec<Known> {
    let n = discs.len();
    let mut corners = Vec::new();
    let mut angles = Vec::new();
    for i in 0..n {
        let ((a, r), (b, s)) = (discs[i], discs[(i + 1) % n]);
        let d = [b[0] - a[0], b[1] - a[1]];
        // The outward normal of the tangent leans from the right of the way by the difference of radii.
        let angle = d[1].atan2(d[0]) - PI / 2.0 + ((r - s) / d[0].hypot(d[1])).asin();
        corners.extend([(a, r), (b, s)].map(|(c, r)| [c[0] + r * angle.cos(), c[1] + r * angle.sin()]));
        angles.push(angle);
    }
    let mut known = Vec::new();
    let mut ring = Vec::new();
    for i in 0..n {
        let before = angles[(i + n - 1) % n];
        let turn = (angles[i] - before).rem_euclid(2.0 * PI);
        known.push(Known::sector(discs[i].0, discs[i].1, before + turn / 2.0, turn / 2.0, z));
        ring.extend([discs[i].0, corners[2 * i], corners[2 * i + 1]]);
    }
    known.push(Known::polygon(&ring, z));
    known
}

#[test]
fn hull_of_two_discs() {
    let link = Link {
        eyes: eyes(0.3, [0.0; 2], [0.16, 0.07]),
        webs: vec![Web::Hull { eyes: vec![1, 0], layers: vec![Z] }],
        ..link()
    };
    assert_is(&link, &hull_of(&[(place(0.0, 0.0), 0.08), (place(0.3, 0.0), 0.035)], Z));
}

#[test]
fn hull_of_three_discs_with_one_inside() {
    let discs = [(place(0.0, 0.0), 0.08), (place(0.3, -0.05), 0.035), (place(0.17, 0.24), 0.05)];
    let mut eyes: Vec<Eye<f64>> = discs.iter().map(|(c, r)| eye(*c, 0.0, 2.0 * r, Z)).collect();
    eyes.push(eye(place(0.15, 0.05), 0.0, 0.04, Z));
    let link = Link { eyes, webs: vec![Web::Hull { eyes: vec![2, 3, 0, 1], layers: vec![Z] }], ..link() };
    assert_is(&link, &hull_of(&discs, Z));
}

#[test]
fn slot_and_holes() {
    let slot = CutShape::Slot { from: place(0.1, 0.0), to: place(0.3, 0.0), width: 0.03 };
    let hole = CutShape::Hole { center: place(0.4, 0.01), diameter: 0.025 };
    let link = Link {
        eyes: eyes(0.5, [0.0; 2], [0.09; 2]),
        webs: vec![bar([0, 1], [0.09; 2], Z, Profile::Flat)],
        cuts: vec![through(slot), Cut { shape: hole, layers: Some(vec![[0.003, 0.1]]) }],
        ..link()
    };
    let mut known = round_bar(0.5, 0.045, Z);
    let end = |along: f64, direction: f64| Known::sector(place(along, 0.0), 0.015, direction, PI / 2.0, Z);
    let slot = [rectangle(0.1, 0.3, 0.015, Z), end(0.1, 0.7 + PI), end(0.3, 0.7)];
    known.extend(slot.map(|k| k.times(-1.0)));
    known.push(Known::disc(place(0.4, 0.01), 0.025, [0.003, Z[1]]).times(-1.0));
    assert_is(&link, &known);
}

#[test]
fn slot_as_wide_as_the_bore_it_leaves() {
    let slot = CutShape::Slot { from: place(0.0, 0.0), to: place(0.2, 0.0), width: 0.03 };
    let link = Link {
        eyes: eyes(0.5, [0.03, 0.0], [0.09; 2]),
        webs: vec![bar([0, 1], [0.09; 2], Z, Profile::Flat)],
        cuts: vec![through(slot)],
        ..link()
    };
    let mut known = round_bar(0.5, 0.045, Z);
    let end = |along: f64, direction: f64| Known::sector(place(along, 0.0), 0.015, direction, PI / 2.0, Z);
    known.extend([rectangle(0.0, 0.2, 0.015, Z), end(0.0, 0.7 + PI), end(0.2, 0.7)].map(|k| k.times(-1.0)));
    assert_is(&link, &known);
}

/// What rounding takes from a corner between two sides: two right triangles without the sector.
fn corner_loss([before, at, after]: [[f64; 2]; 3], r: f64, z: [f64; 2]) -> Vec<Known> {
    let unit = |a: [f64; 2], b: [f64; 2]| {
        let d = [b[0] - a[0], b[1] - a[1]];
        let l = d[0].hypot(d[1]);
        [d[0] / l, d[1] / l]
    };
    let (u, v) = (unit(before, at), unit(at, after));
    let turn = (u[0] * v[1] - u[1] * v[0]).atan2(u[0] * v[0] + u[1] * v[1]);
    let back = r * (turn.abs() / 2.0).tan();
    let side = turn.signum();
    let (p, q) = ([at[0] - u[0] * back, at[1] - u[1] * back], [at[0] + v[0] * back, at[1] + v[1] * back]);
    let center = [p[0] - u[1] * r * side, p[1] + u[0] * r * side];
    let toward = (at[1] - center[1]).atan2(at[0] - center[0]);
    // Of a corner that turns right, the corners of the kite run clockwise: its area is negative, as it must be.
    vec![Known::polygon(&[p, at, q, center], z), Known::sector(center, r, toward, turn.abs() / 2.0, z).times(-side)]
}

#[test]
fn outlines_with_round_corners_convex_and_re_entrant() {
    let outline = places(&[[0.0, 0.0], [0.3, 0.02], [0.28, 0.1], [0.11, 0.09], [0.09, 0.25], [-0.02, 0.24]]);
    let radii = [0.01, 0.02, 0.0, 0.03, 0.015, 0.004];
    let mut given: Vec<_> = outline.iter().copied().zip(radii).collect();
    for _ in 0..2 {
        let link = Link { plates: vec![plate(&given, Z)], ..link() };
        let n = outline.len();
        let mut known = vec![Known::polygon(&outline, Z)];
        for i in (0..n).filter(|i| radii[*i] > 0.0) {
            let around = [outline[(i + n - 1) % n], outline[i], outline[(i + 1) % n]];
            known.extend(corner_loss(around, radii[i], Z).into_iter().map(|k| k.times(-1.0)));
        }
        assert_is(&link, &known);
        given.reverse();
    }
}

#[test]
fn l_plate_with_fillet_and_window() {
    let corner = places(&[[0.0, 0.0], [0.3, 0.0], [0.3, 0.1], [0.1, 0.1], [0.1, 0.25], [0.0, 0.25]]);
    let sharp: Vec<_> = corner.iter().map(|p| (*p, 0.0)).collect();
    let window: Vec<_> = places(&[[0.02, 0.03], [0.05, 0.03], [0.045, 0.07]]).into_iter().map(|p| (p, 0.0)).collect();
    let link = Link {
        plates: vec![plate(&sharp, Z)],
        cuts: vec![through(CutShape::Outline(corners(&window)))],
        fillet: Some(0.02),
        ..link()
    };
    let mut known = vec![Known::polygon(&corner, Z)];
    known.extend(corner_loss([corner[2], corner[3], corner[4]], 0.02, Z).into_iter().map(|k| k.times(-1.0)));
    known.push(Known::polygon(&window.iter().map(|w| w.0).collect::<Vec<_>>(), Z).times(-1.0));
    assert_is(&link, &known);
}

#[test]
fn fork() {
    let straps = vec![[-0.03, -0.012], [0.012, 0.03]];
    let fork = Eye { layers: straps.clone(), clearance: Some(0.13), ..eye(place(0.0, 0.0), 0.04, 0.12, Z) };
    let body = [-0.03, 0.03];
    let link = Link {
        eyes: vec![fork, Eye { layers: vec![body], ..eye(place(0.5, 0.0), 0.0, 0.12, Z) }],
        webs: vec![bar([0, 1], [0.12; 2], body, Profile::Flat)],
        ..link()
    };
    let mut known = round_bar(0.5, 0.06, body);
    known.push(Known::disc(place(0.0, 0.0), 0.04, body).times(-1.0));
    // The gap: the round end to its full depth, and the bar as far as the clearance reaches.
    let gap = [-0.012, 0.012];
    known.push(Known::disc(place(0.0, 0.0), 0.04, gap));
    known.push(Known::sector(place(0.0, 0.0), 0.06, 0.7 + PI, PI / 2.0, gap).times(-1.0));
    let (r, half) = (0.065_f64, 0.06_f64);
    let reach = (r * r - half * half).sqrt();
    known.push(Known::sector(place(0.0, 0.0), r, 0.7, (half / r).asin(), gap).times(-1.0));
    for up in [1.0, -1.0] {
        known.push(Known::polygon(&places(&[[0.0, 0.0], [reach, up * half], [0.0, up * half]]), gap).times(-up));
    }
    assert_is(&link, &known);
}

#[test]
fn tongue_with_clearance() {
    let tongue = Eye { layers: vec![[-0.01, 0.01]], clearance: Some(0.13), ..eye(place(0.0, 0.0), 0.0, 0.12, Z) };
    let body = [-0.03, 0.03];
    let link = Link {
        eyes: vec![tongue, Eye { layers: vec![body], ..eye(place(0.5, 0.0), 0.0, 0.12, Z) }],
        webs: vec![bar([0, 1], [0.12; 2], body, Profile::Flat)],
        ..link()
    };
    let mut known = round_bar(0.5, 0.06, [-0.01, 0.01]);
    let (r, half) = (0.065_f64, 0.06_f64);
    let reach = (r * r - half * half).sqrt();
    for z in [[-0.03, -0.01], [0.01, 0.03]] {
        known.push(rectangle(0.0, 0.5, 0.06, z));
        known.push(Known::sector(place(0.5, 0.0), 0.06, 0.7, PI / 2.0, z));
        known.push(Known::sector(place(0.0, 0.0), r, 0.7, (half / r).asin(), z).times(-1.0));
        for up in [1.0, -1.0] {
            known.push(Known::polygon(&places(&[[0.0, 0.0], [reach, up * half], [0.0, up * half]]), z).times(-up));
        }
    }
    assert_is(&link, &known);
}

#[test]
fn fillets_between_eyes_and_a_bar() {
    let link = Link {
        eyes: eyes(0.4, [0.0; 2], [0.1; 2]),
        webs: vec![bar([0, 1], [0.05; 2], Z, Profile::Flat)],
        fillet: Some(0.02),
        ..link()
    };
    let mut known = narrow(0.4, [0.05, 0.05], 0.025, Z);
    // The fillet's centre is its radius from the bar and from the eye.
    let (r, f, half) = (0.05_f64, 0.02_f64, 0.025_f64);
    let x = ((r + f) * (r + f) - (half + f) * (half + f)).sqrt();
    let lean = ((half + f) / (r + f)).asin();
    let corner = (half / r).asin();
    for (along, side, direction) in [(0.0, 1.0, 0.7), (0.4, -1.0, 0.7 + PI)] {
        for up in [1.0, -1.0] {
            // Between the eye's centre, the foot on the bar's axis, and the fillet's centre.
            let reach = (r * r - half * half).sqrt();
            let quad = [
                [along, 0.0],
                [along + side * reach, up * half],
                [along + side * x, up * half],
                [along + side * x, up * (half + f)],
            ];
            known.push(Known::polygon(&places(&quad), Z).times(side * up));
            let middle = direction + side * up * (lean + corner) / 2.0;
            known.push(Known::sector(place(along, 0.0), r, middle, (lean - corner) / 2.0, Z).times(-1.0));
            let open = PI / 2.0 - lean;
            let toward = direction - side * up * (PI / 2.0 + open / 2.0);
            known.push(Known::sector(place(along + side * x, up * (half + f)), f, toward, open / 2.0, Z).times(-1.0));
        }
    }
    assert_is(&link, &known);
}

#[test]
fn frustum_and_tube_on_a_slanted_axis() {
    let (r, s, h) = (0.02, 0.012, 0.05);
    let axis = [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0];
    let frustum = Revolved { base: [0.1, 0.2, -0.3], axis, profile: vec![[0.0, 0.0], [r, 0.0], [s, h], [0.0, h]] };
    let v = PI * h / 3.0 * (r * r + r * s + s * s);
    let z = PI * h * h / 12.0 * (r * r + 2.0 * r * s + 3.0 * s * s);
    let zz = PI * h.powi(3) / 30.0 * (r * r + 3.0 * r * s + 6.0 * s * s);
    let xx = PI * h / 20.0 * (r.powi(4) + r.powi(3) * s + r * r * s * s + r * s.powi(3) + s.powi(4));
    let [a, b, c] = axis;
    let second = |p: f64, q: f64, same: f64| xx * (same - p * q) + zz * p * q;
    let base = frustum.base;
    let first: Vec<f64> = (0..3).map(|k| axis[k] * z).collect();
    let at = |i: usize, j: usize, local: f64| local + base[i] * first[j] + base[j] * first[i] + base[i] * base[j] * v;
    let sums = [
        v,
        first[0] + v * base[0],
        first[1] + v * base[1],
        first[2] + v * base[2],
        at(0, 0, second(a, a, 1.0)),
        at(1, 1, second(b, b, 1.0)),
        at(2, 2, second(c, c, 1.0)),
        at(1, 2, second(b, c, 0.0)),
        at(2, 0, second(c, a, 0.0)),
        at(0, 1, second(a, b, 0.0)),
    ];
    assert_properties(&frustum.mass_properties(2700.0).expect("a sound profile"), sums, 2700.0);
    let tube = Revolved { profile: vec![[0.01, 0.03], [0.01, -0.01], [0.02, -0.01], [0.02, 0.03]], ..frustum };
    let found = tube.mass_properties(1.0).expect("a sound profile");
    assert!((found.volume / (PI * 0.0003 * 0.04) - 1.0).abs() < 1e-13);
}
