//! Turned, shifted, grown: the same solid. And where it is sharp.

use bellcrank_solid::{CutShape, Eye, Link, Profile, Web};

use crate::parts::{bar, eye, link, plate};
use crate::random::{Dice, random_link};

/// A link turned by an angle, grown, then shifted.
fn moved(link: &Link<f64>, angle: f64, grown: f64, [x, y]: [f64; 2]) -> Link<f64> {
    let (s, c) = angle.sin_cos();
    let place = |p: [f64; 2]| [x + grown * (c * p[0] - s * p[1]), y + grown * (s * p[0] + c * p[1])];
    let mut link = link.clone();
    let grow = |layers: &mut Vec<[f64; 2]>| layers.iter_mut().flatten().for_each(|z| *z *= grown);
    for eye in &mut link.eyes {
        eye.center = place(eye.center);
        (eye.bore, eye.outer) = (eye.bore * grown, eye.outer * grown);
        eye.clearance = eye.clearance.map(|d| d * grown);
        grow(&mut eye.layers);
    }
    for web in &mut link.webs {
        match web {
            Web::Hull { layers, .. } => grow(layers),
            Web::Bar(bar) => {
                bar.widths = bar.widths.map(|w| w * grown);
                grow(&mut bar.layers);
                match &mut bar.profile {
                    Profile::Flat => {}
                    Profile::Box { wall: a, skin: b } | Profile::I { flange: a, web: b } => {
                        (*a, *b) = (*a * grown, *b * grown)
                    }
                }
            }
        }
    }
    for plate in &mut link.plates {
        plate
            .outline
            .iter_mut()
            .for_each(|corner| (corner.at, corner.radius) = (place(corner.at), corner.radius * grown));
        grow(&mut plate.layers);
    }
    for cut in &mut link.cuts {
        cut.layers.iter_mut().for_each(grow);
        match &mut cut.shape {
            CutShape::Hole { center, diameter } => (*center, *diameter) = (place(*center), *diameter * grown),
            CutShape::Slot { from, to, width } => (*from, *to, *width) = (place(*from), place(*to), *width * grown),
            CutShape::Outline(corners) => {
                corners
                    .iter_mut()
                    .for_each(|corner| (corner.at, corner.radius) = (place(corner.at), corner.radius * grown));
            }
        }
    }
    link.fillet = link.fillet.map(|r| r * grown);
    link
}

#[test]
fn a_moved_link_has_moved_mass_properties() {
    for seed in 0..200 {
        let dice = &mut Dice::new(seed);
        let mut link = random_link(dice);
        link.fillet = (seed % 2 == 0).then_some(0.002);
        let (angle, grown, shift) =
            (dice.between(0.0, 6.0), dice.between(0.1, 10.0), [dice.between(-2.0, 2.0), dice.between(-2.0, 2.0)]);
        let (Ok(here), there) = (link.build(), moved(&link, angle, grown, shift).build()) else { continue };
        let there = there.unwrap_or_else(|faults| panic!("seed {seed}: {faults:?}"));
        assert_eq!(
            (here.edges.len(), here.cells.len(), here.levels.len()),
            (there.edges.len(), there.cells.len(), there.levels.len()),
            "seed {seed}"
        );
        let (a, b) = (here.mass_properties(1.0), there.mass_properties(1.0));
        let near =
            |x: f64, y: f64, scale: f64| assert!((x - y).abs() < 1e-9 * scale, "seed {seed}: {x} {y} of {scale}");
        near(a.volume * grown.powi(3), b.volume, b.volume);
        let (s, c) = angle.sin_cos();
        let center = [
            shift[0] + grown * (c * a.center[0] - s * a.center[1]),
            shift[1] + grown * (s * a.center[0] + c * a.center[1]),
            grown * a.center[2],
        ];
        center.iter().zip(b.center).for_each(|(x, y)| near(*x, y, grown));
        let turn = [[c, -s, 0.0], [s, c, 0.0], [0.0, 0.0, 1.0]];
        for i in 0..3 {
            for j in 0..3 {
                let turned: f64 = (0..9).map(|kl| turn[i][kl / 3] * a.inertia[kl / 3][kl % 3] * turn[j][kl % 3]).sum();
                near(turned * grown.powi(5), b.inertia[i][j], b.inertia[2][2]);
            }
        }
    }
}

#[test]
fn re_entrant_edges_are_sharp_until_they_are_rounded() {
    let corner = [[0.0, 0.0], [0.3, 0.0], [0.3, 0.1], [0.1, 0.1], [0.1, 0.25], [0.0, 0.25]].map(|p| (p, 0.0));
    let mut link = Link { plates: vec![plate(&corner, [0.0, 0.02])], ..link() };
    let sharp = link.build().expect("a sound plate").sharp_edges();
    assert_eq!(sharp.len(), 1);
    assert!((sharp[0].angle - 1.5 * std::f64::consts::PI).abs() < 1e-12);
    assert!(sharp[0].ends.iter().all(|p| p[0] == 0.1 && p[1] == 0.1));
    link.fillet = Some(0.01);
    assert!(link.build().expect("a sound plate").sharp_edges().is_empty());
}

#[test]
fn steps_between_layers_are_sharp() {
    let boss: Eye<f64> = eye([0.0, 0.0], 0.02, 0.05, [-0.01, 0.03]);
    let link = Link {
        eyes: vec![boss, eye([0.2, 0.05], 0.02, 0.08, [-0.01, 0.01])],
        webs: vec![bar([0, 1], [0.08, 0.08], [-0.01, 0.01], Profile::Flat)],
        ..link()
    };
    let sharp = link.build().expect("a sound link").sharp_edges();
    let flat = sharp.iter().filter(|e| e.ends.iter().all(|p| (p[2] - 0.01).abs() < 1e-12)).count();
    assert!(flat > 0, "the boss's foot is re-entrant: {sharp:?}");
    assert!(sharp.iter().all(|e| e.angle > std::f64::consts::PI + 5_f64.to_radians()));
}
