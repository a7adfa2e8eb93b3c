//! Random links: what is inside them, said another way.

use bellcrank_solid::{CutShape, Eye, Link, Profile, Web};

use crate::random::{Dice, random_link};

/// Whether a place is in a link without fillets and with sharp corners, straight from what its parts mean.
pub(crate) fn inside(link: &Link<f64>, [x, y, z]: [f64; 3]) -> bool {
    let p = [x, y];
    let within = |layers: &[[f64; 2]]| layers.iter().any(|l| z >= l[0] && z <= l[1]);
    let in_disc = |c: [f64; 2], d: f64| (p[0] - c[0]).hypot(p[1] - c[1]) <= d / 2.0;
    let eye = |e: &Eye<f64>| within(&e.layers) && in_disc(e.center, e.outer);
    let web = |w: &Web<f64>| match w {
        Web::Hull { eyes, layers } => within(layers) && in_hull(link, eyes, p),
        Web::Bar(bar) => {
            let ends = bar.eyes.map(|e| link.eyes[e].center);
            let at_eye = bar.eyes.iter().any(|e| in_disc(link.eyes[*e].center, link.eyes[*e].outer));
            bar.layers.iter().any(|l| in_bar(p, z, ends, bar.widths, *l, &bar.profile, at_eye))
        }
    };
    let joined = link.eyes.iter().any(eye)
        || link.webs.iter().any(web)
        || link.plates.iter().any(|plate| {
            within(&plate.layers) && in_polygon(&plate.outline.iter().map(|c| c.at).collect::<Vec<_>>(), p)
        });
    let taken =
        link.eyes.iter().any(|e| {
            in_disc(e.center, e.bore) || e.clearance.is_some_and(|d| in_disc(e.center, d)) && !within(&e.layers)
        }) || link.cuts.iter().any(|cut| cut.layers.as_ref().is_none_or(|l| within(l)) && in_cut(&cut.shape, p));
    joined && !taken
}

fn in_bar(
    p: [f64; 2],
    z: f64,
    [a, b]: [[f64; 2]; 2],
    widths: [f64; 2],
    layer: [f64; 2],
    profile: &Profile<f64>,
    at_eye: bool,
) -> bool {
    let d = [b[0] - a[0], b[1] - a[1]];
    let length = d[0].hypot(d[1]);
    let q = [p[0] - a[0], p[1] - a[1]];
    let along = (q[0] * d[0] + q[1] * d[1]) / length / length;
    let aside = (q[0] * d[1] - q[1] * d[0]).abs() / length;
    let width = widths[0] + (widths[1] - widths[0]) * along;
    let whole = (0.0..=1.0).contains(&along) && aside <= width / 2.0 && z >= layer[0] && z <= layer[1];
    let middle = (layer[0] + layer[1]) / 2.0;
    let hollow = match profile {
        Profile::Flat => false,
        Profile::Box { wall, skin } => aside < width / 2.0 - wall && z > layer[0] + skin && z < layer[1] - skin,
        Profile::I { flange, web } => aside < width / 2.0 - flange && (z - middle).abs() > web / 2.0,
    };
    whole && (at_eye || !hollow)
}

/// Discs between any two of a hull fill that of two; hulls here have two eyes.
fn in_hull(link: &Link<f64>, eyes: &[usize], p: [f64; 2]) -> bool {
    let [a, b] = [&link.eyes[eyes[0]], &link.eyes[eyes[1]]];
    // The hull is the union of the discs between: the function is concave along the way.
    let reach = |t: f64| {
        let c = [a.center[0] + (b.center[0] - a.center[0]) * t, a.center[1] + (b.center[1] - a.center[1]) * t];
        (a.outer + (b.outer - a.outer) * t) / 2.0 - (p[0] - c[0]).hypot(p[1] - c[1])
    };
    let (mut low, mut high) = (0.0, 1.0);
    for _ in 0..60 {
        let (s, t) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if reach(s) < reach(t) { low = s } else { high = t }
    }
    reach(low) >= 0.0
}

fn in_polygon(corners: &[[f64; 2]], p: [f64; 2]) -> bool {
    let next = corners.iter().cycle().skip(1);
    let crossed = |(a, b): &(&[f64; 2], &[f64; 2])| {
        (a[1] > p[1]) != (b[1] > p[1]) && p[0] < a[0] + (p[1] - a[1]) / (b[1] - a[1]) * (b[0] - a[0])
    };
    corners.iter().zip(next).filter(crossed).count() % 2 == 1
}

fn in_cut(shape: &CutShape<f64>, p: [f64; 2]) -> bool {
    match shape {
        CutShape::Hole { center, diameter } => (p[0] - center[0]).hypot(p[1] - center[1]) < diameter / 2.0,
        CutShape::Slot { from, to, width } => {
            let d = [to[0] - from[0], to[1] - from[1]];
            let t = ((p[0] - from[0]) * d[0] + (p[1] - from[1]) * d[1]) / (d[0] * d[0] + d[1] * d[1]);
            let t = t.clamp(0.0, 1.0);
            (p[0] - from[0] - d[0] * t).hypot(p[1] - from[1] - d[1] * t) < width / 2.0
        }
        CutShape::Outline(corners) => in_polygon(&corners.iter().map(|c| c.at).collect::<Vec<_>>(), p),
    }
}

/// Volume, first and second moments by counting places of a lattice that is random in one direction and fills the box
/// evenly in the others, and the volume of the box.
fn counted(link: &Link<f64>, places: usize, seed: u64) -> ([f64; 7], f64) {
    let reach: Vec<[f64; 3]> = link.eyes.iter().map(|e| [e.center[0], e.center[1], 0.12]).collect();
    let low = [0, 1].map(|k| reach.iter().map(|r| r[k] - r[2]).fold(f64::INFINITY, f64::min));
    let high = [0, 1].map(|k| reach.iter().map(|r| r[k] + r[2]).fold(f64::NEG_INFINITY, f64::max));
    let (low, high) = ([low[0], low[1], -0.035], [high[0], high[1], 0.035]);
    let start = seed as f64 * 0.37;
    let mut sums = [0.0; 7];
    // Additive recurrence with the powers of the plastic number of three dimensions.
    let steps = [0.819_172_513_396_164_4, 0.671_043_606_703_789_3, 0.549_700_477_901_970_3];
    for i in 0..places {
        let p: [f64; 3] = std::array::from_fn(|k| low[k] + (high[k] - low[k]) * (start + steps[k] * i as f64).fract());
        if inside(link, p) {
            let terms = [1.0, p[0], p[1], p[2], p[0] * p[0], p[1] * p[1], p[2] * p[2]];
            sums.iter_mut().zip(terms).for_each(|(s, t)| *s += t);
        }
    }
    let volume: f64 = (0..3).map(|k| high[k] - low[k]).product();
    (sums.map(|s| s * volume / places as f64), volume)
}

#[test]
fn volume_and_moments_of_random_links_are_those_of_counted_places() {
    let mut built = 0;
    for seed in 0..300 {
        let mut link = random_link(&mut Dice::new(seed));
        link.plates.iter_mut().flat_map(|p| &mut p.outline).for_each(|c| c.radius = 0.0);
        link.cuts.iter_mut().for_each(|c| {
            if let CutShape::Outline(corners) = &mut c.shape {
                corners.iter_mut().for_each(|c| c.radius = 0.0);
            }
        });
        let stack = match link.build() {
            Ok(stack) => stack,
            Err(faults) => {
                println!("{seed}: {faults:?}");
                continue;
            }
        };
        built += 1;
        let (counted, bounds) = counted(&link, 40_000, seed);
        let m = &stack.moments;
        let exact = [m.volume, m.first[0], m.first[1], m.first[2], m.second[0], m.second[1], m.second[2]];
        let off = |counted: [f64; 7], most: f64| exact.iter().zip(counted).any(|(a, b)| (a - b).abs() > most * bounds);
        if off(counted, 2e-3) {
            // Chance: ten times as many places must be three times as near.
            let (more, _) = self::counted(&link, 400_000, seed);
            assert!(!off(more, 7e-4), "seed {seed}: {exact:?} and {more:?}, box {bounds}, {link:?}");
        }
    }
    println!("{built} of 300 built");
    assert!(built > 240, "{built} of 300");
}
