//! Random links; the tests of the mesher draw from here, too.

use bellcrank_solid::{Cut, CutShape, Eye, Link, Profile, Web};

use crate::parts::{bar, corners, eye, link, plate, through};

/// A small generator of numbers, the same on every machine.
pub(crate) struct Dice(u64);

impl Dice {
    pub(crate) fn new(seed: u64) -> Self {
        Dice(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15).wrapping_add(0x1234_5678_9ABC_DEF1))
    }

    /// Between 0 and 1.
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    pub(crate) fn below(&mut self, count: usize) -> usize {
        (self.unit() * count as f64) as usize
    }

    pub(crate) fn chance(&mut self, of: f64) -> bool {
        self.unit() < of
    }
}

/// A link as one might draw it: two to four eyes, webs of every kind from each to the next, often as wide as the
/// eyes and as thick; a plate, holes, slots.
pub(crate) fn random_link(dice: &mut Dice) -> Link<f64> {
    let mut made = link();
    let count = 2 + dice.below(3);
    let thickness = dice.between(0.01, 0.04);
    let outer = dice.between(0.06, 0.14);
    let turn = dice.between(0.0, 6.0);
    for i in 0..count {
        let along = 0.25 * i as f64;
        let aside = dice.between(-0.1, 0.1);
        let center = [along * turn.cos() - aside * turn.sin(), along * turn.sin() + aside * turn.cos()];
        let outer = if dice.chance(0.5) { outer } else { dice.between(0.05, 0.14) };
        let bore = if dice.chance(0.2) { 0.0 } else { outer * dice.between(0.2, 0.7) };
        made.eyes.push(random_eye(dice, center, bore, outer, thickness));
    }
    for i in 1..count {
        let web = random_web(dice, &made, i, thickness);
        made.webs.push(web);
    }
    if dice.chance(0.3) {
        let c = made.eyes[0].center;
        let outline = [[-0.07, -0.06], [0.08, -0.05], [0.06, 0.09], [-0.05, 0.07]].map(|p| [p[0] + c[0], p[1] + c[1]]);
        let radius = dice.between(0.0, 0.02);
        made.plates.push(plate(&outline.map(|p| (p, radius)), [-thickness / 2.0, thickness * dice.between(0.1, 0.5)]));
    }
    for _ in 0..dice.below(3) {
        let cut = random_cut(dice, &made);
        made.cuts.push(cut);
    }
    made
}

fn random_eye(dice: &mut Dice, center: [f64; 2], bore: f64, outer: f64, thickness: f64) -> Eye<f64> {
    let half = thickness / 2.0;
    let mut made = eye(center, bore, outer, [-half, half]);
    match dice.below(5) {
        0 => made.layers = vec![[-half * 1.5, half * 1.5]],
        1 => {
            made.layers = vec![[-half, -half / 3.0], [half / 3.0, half]];
            made.clearance = Some(outer * dice.between(1.0, 1.2));
        }
        2 => {
            made.layers = vec![[-half / 3.0, half / 3.0]];
            made.clearance = Some(outer * dice.between(1.0, 1.2));
        }
        _ => {}
    }
    made
}

fn random_web(dice: &mut Dice, link: &Link<f64>, i: usize, thickness: f64) -> Web<f64> {
    let eyes = [i - 1, i];
    let layer = [-thickness / 2.0, thickness / 2.0];
    let outer = eyes.map(|e| link.eyes[e].outer);
    let widths = match dice.below(4) {
        0 => outer,
        1 => [outer[0].min(outer[1]); 2],
        2 => outer.map(|o| o * dice.between(0.4, 0.95)),
        _ => [dice.between(0.03, 0.16), dice.between(0.03, 0.16)],
    };
    let least = widths[0].min(widths[1]);
    match dice.below(5) {
        0 => Web::Hull { eyes: eyes.to_vec(), layers: vec![layer] },
        1 => bar(
            eyes,
            widths,
            layer,
            Profile::Box { wall: least * dice.between(0.1, 0.3), skin: thickness * dice.between(0.1, 0.3) },
        ),
        2 => bar(
            eyes,
            widths,
            layer,
            Profile::I { flange: least * dice.between(0.1, 0.3), web: thickness * dice.between(0.2, 0.5) },
        ),
        _ => bar(eyes, widths, layer, Profile::Flat),
    }
}

fn random_cut(dice: &mut Dice, link: &Link<f64>) -> Cut<f64> {
    let (a, b) = (link.eyes[0].center, link.eyes[1].center);
    let at = |t: f64| [a[0] + (b[0] - a[0]) * t, a[1] + (b[1] - a[1]) * t];
    match dice.below(3) {
        0 => through(CutShape::Hole { center: at(dice.between(0.4, 0.6)), diameter: dice.between(0.005, 0.03) }),
        1 => through(CutShape::Slot {
            from: at(dice.between(0.35, 0.45)),
            to: at(dice.between(0.5, 0.65)),
            width: dice.between(0.005, 0.03),
        }),
        _ => {
            let c = at(0.5);
            let s = dice.between(0.005, 0.02);
            let places =
                [[-s, -s], [s * 1.3, -s], [s, s], [-s * 0.7, s * 1.1]].map(|p| ([p[0] + c[0], p[1] + c[1]], s * 0.2));
            Cut { shape: CutShape::Outline(corners(&places)), layers: Some(vec![[0.0, 1.0]]) }
        }
    }
}
