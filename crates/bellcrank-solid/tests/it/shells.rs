//! Boundaries and surfaces of random links: closed, of the right volume, of a possible topology.

use std::collections::HashMap;

use bellcrank_solid::{Link, Revolved, Shell, Surface, stl};

use crate::parts::{eye, link};
use crate::random::{Dice, random_link};

/// Each edge once in each direction, loops closed.
pub(crate) fn assert_closed(shell: &Shell, what: &str) {
    let mut uses = vec![[0; 2]; shell.edges.len()];
    for walk in shell.faces.iter().flat_map(|f| &f.loops) {
        let ends = |(edge, forward): (usize, bool)| {
            let [a, b] = shell.edges[edge].ends;
            if forward { [a, b] } else { [b, a] }
        };
        for (a, b) in walk.iter().zip(walk.iter().cycle().skip(1)) {
            assert_eq!(ends(*a)[1], ends(*b)[0], "{what}: a loop with a gap");
            uses[a.0][usize::from(a.1)] += 1;
        }
    }
    assert!(uses.iter().all(|u| *u == [1, 1]), "{what}: an edge is not used once in each direction");
}

/// Euler characteristic: 2 for a ball, 0 for a ring.
fn characteristic(shell: &Shell) -> i64 {
    let holes: usize = shell.faces.iter().map(|f| f.loops.len() - 1).sum();
    (shell.vertices.len() + shell.faces.len()) as i64 - (shell.edges.len() + holes) as i64
}

fn assert_watertight(surface: &Surface, what: &str) {
    let mut sides: HashMap<[u32; 2], i32> = HashMap::new();
    for [a, b, c] in &surface.triangles {
        for [p, q] in [[a, b], [b, c], [c, a]] {
            *sides.entry([*p.min(q), *p.max(q)]).or_default() += if p < q { 1 } else { -1 };
        }
    }
    assert!(sides.values().all(|n| *n == 0), "{what}: an open side");
}

fn volume(surface: &Surface) -> f64 {
    let at = |n: u32| surface.nodes[n as usize];
    let six = |[a, b, c]: &[u32; 3]| {
        let ([a, b, c], [d, e, f], [g, h, i]) = (at(*a), at(*b), at(*c));
        a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)
    };
    surface.triangles.iter().map(six).sum::<f64>() / 6.0
}

#[test]
fn shells_of_random_links_are_closed_and_hold_their_volume() {
    for seed in 0..300 {
        let mut link = random_link(&mut Dice::new(seed));
        if seed % 2 == 0 {
            link.fillet = Some(0.002);
        }
        let Ok(stack) = link.build() else { continue };
        let what = format!("seed {seed}");
        let shell = stack.shell();
        assert_closed(&shell, &what);
        let characteristic = characteristic(&shell);
        assert!(characteristic <= 2 && characteristic % 2 == 0, "{what}: {characteristic}");
        let surface = shell.surface(1e-5);
        assert_watertight(&surface, &what);
        let (exact, chords) = (stack.moments.volume, volume(&surface));
        assert!((chords / exact - 1.0).abs() < 3e-3, "{what}: {chords} for {exact}");
    }
}

#[test]
fn a_finer_surface_comes_nearer_with_the_square_of_its_chords() {
    let (seed, mut off) = (3, Vec::new());
    let stack = random_link(&mut Dice::new(seed)).build().expect("a sound link");
    for tolerance in [1e-4, 1e-5, 1e-6] {
        off.push((volume(&stack.surface(tolerance)) / stack.moments.volume - 1.0).abs());
    }
    assert!(off[1] < off[0] / 5.0 && off[2] < off[1] / 5.0, "{off:?}");
}

#[test]
fn a_thin_ring_has_chords_fine_enough_for_it() {
    let ring: Link<f64> = Link { eyes: vec![eye([0.3, 0.1], 0.0998, 0.1, [0.0, 0.01])], ..link() };
    let stack = ring.build().expect("a sound ring");
    let surface = stack.surface(1e-2);
    assert_watertight(&surface, "ring");
    assert!(volume(&surface) > 0.5 * stack.moments.volume);
    assert_eq!(characteristic(&stack.shell()), 0);
}

/// A pin with a head, a groove, a conical end and a hole along a part of it.
pub(crate) fn pin() -> Revolved<f64> {
    let profile = vec![
        [0.0, 0.02],
        [0.004, 0.015],
        [0.004, 0.0],
        [0.012, 0.0],
        [0.015, 0.003],
        [0.015, 0.01],
        [0.01, 0.01],
        [0.01, 0.05],
        [0.008, 0.05],
        [0.008, 0.053],
        [0.01, 0.053],
        [0.01, 0.058],
        [0.007, 0.062],
        [0.0, 0.062],
    ];
    let axis = [2.0 / 7.0, 3.0 / 7.0, 6.0 / 7.0];
    Revolved { base: [0.1, -0.2, 0.03], axis, profile }
}

/// A bush.
pub(crate) fn bush() -> Revolved<f64> {
    let profile = vec![[0.01, -0.02], [0.01, 0.02], [0.013, 0.02], [0.014, -0.015], [0.018, -0.015], [0.018, -0.02]];
    Revolved { base: [-0.1, 0.2, 0.3], axis: [-6.0 / 7.0, 2.0 / 7.0, 3.0 / 7.0], profile }
}

#[test]
fn shells_of_pins_are_closed_and_hold_their_volume() {
    for (body, ball) in [(pin(), 2), (bush(), 0)] {
        let shell = body.shell().expect("a sound profile");
        assert_closed(&shell, "pin");
        assert_eq!(characteristic(&shell), ball);
        let surface = shell.surface(1e-6);
        assert_watertight(&surface, "pin");
        let exact = body.moments().expect("a sound profile").volume;
        assert!((volume(&surface) / exact - 1.0).abs() < 1e-3, "{} for {exact}", volume(&surface));
    }
}

#[test]
fn stl_has_fifty_bytes_a_triangle() {
    let surface = pin().surface(1e-4).expect("a sound profile");
    let file = stl::write(&surface, 1000.0);
    assert_eq!(file.len(), 84 + 50 * surface.triangles.len());
    let first: [u8; 4] = file[84 + 12..84 + 16].try_into().expect("four bytes");
    let node = surface.nodes[surface.triangles[0][0] as usize];
    assert!((f64::from(f32::from_le_bytes(first)) - node[0] * 1000.0).abs() < 1e-4);
}
