//! What is wrong is told, all at once, with its numbers; nothing panics.

use bellcrank_solid::{Cut, CutShape, Eye, Fault, Link, Part, Plate, Profile, Quantity, Revolved, Web};

use crate::parts::{bar, corners, eye, link, plate, through};
use crate::random::{Dice, random_link};
use crate::shells::assert_closed;

const Z: [f64; 2] = [-0.01, 0.01];

fn faults(link: &Link<f64>) -> Vec<Fault> {
    match link.build() {
        Ok(stack) => stack.warnings,
        Err(faults) => faults,
    }
}

fn two_eyes() -> Link<f64> {
    Link {
        eyes: vec![eye([0.01, 0.02], 0.03, 0.1, Z), eye([0.4, 0.1], 0.02, 0.08, Z)],
        webs: vec![bar([0, 1], [0.06, 0.05], Z, Profile::Flat)],
        ..link()
    }
}

#[test]
fn everything_wrong_with_sizes_is_told_at_once() {
    let mut link = two_eyes();
    link.eyes[0].bore = 0.11;
    link.eyes[1].layers = vec![[0.02, 0.02], [0.05, 0.03]];
    link.webs = vec![
        bar([0, 1], [0.06, -0.05], [0.1, 0.12], Profile::Flat),
        bar([0, 0], [0.06, 0.05], Z, Profile::Box { wall: 0.025, skin: 0.01 }),
        bar([0, 7], [0.06, 0.05], Z, Profile::I { flange: 0.03, web: 0.02 }),
        Web::Hull { eyes: vec![1], layers: vec![] },
    ];
    let butterfly = [[0.0, 0.0], [0.1, 0.1], [0.1, 0.0], [0.0, 0.1]].map(|p| (p, 0.0));
    let round = [([0.0, 0.0], 0.03), ([0.1, 0.0], 0.08), ([0.1, 0.1], 0.0), ([0.0, 0.1], 0.0)];
    link.plates = vec![plate(&butterfly, Z), plate(&round, Z), plate(&round[..2], Z)];
    link.cuts = vec![through(CutShape::Hole { center: [0.0, 0.0], diameter: 0.0 })];
    link.fillet = Some(-0.01);
    let found = faults(&link);
    let web = |quantity, web: usize| Fault::NotPositive { part: Part::Web(web), quantity, value: -0.05 };
    let expected = [
        Fault::EyeThinnerThanBore { eye: 0, bore: 0.11, outer: 0.1 },
        Fault::Layer { part: Part::Eye(1), layer: 0, interval: [0.02, 0.02] },
        Fault::Layer { part: Part::Eye(1), layer: 1, interval: [0.05, 0.03] },
        web(Quantity::SecondWidth, 0),
        Fault::WebOfNoLength { web: 1 },
        Fault::WallsMeet { web: 1, quantity: Quantity::Wall, value: 0.025, width: 0.05 },
        Fault::SkinsMeet { web: 1, quantity: Quantity::Skin, value: 0.01, height: 0.02 },
        Fault::NoSuchEye { web: 2, eye: 7 },
        Fault::WallsMeet { web: 2, quantity: Quantity::Flange, value: 0.03, width: 0.05 },
        Fault::SkinsMeet { web: 2, quantity: Quantity::Web, value: 0.02, height: 0.02 },
        Fault::NoLayers { part: Part::Web(3) },
        Fault::TooFewEyes { web: 3, count: 1 },
        Fault::SidesCross { part: Part::Plate(0), sides: [0, 2] },
        Fault::TooFewCorners { part: Part::Plate(2), count: 2 },
        Fault::NotPositive { part: Part::Cut(0), quantity: Quantity::Diameter, value: 0.0 },
        Fault::NotPositive { part: Part::Fillet, quantity: Quantity::Radius, value: -0.01 },
    ];
    for fault in expected {
        assert!(found.contains(&fault), "{fault:?} is missing in {found:#?}");
    }
    assert!(
        found.iter().any(|f| matches!(f, Fault::WebMissesEye { web: 0, eye: 0, gap } if (gap - 0.09).abs() < 1e-12))
    );
    let large = found.iter().find_map(|f| match f {
        Fault::RadiusTooLarge { part: Part::Plate(1), corners: [0, 1], needed, length, .. } => Some(needed - length),
        _ => None,
    });
    assert!((large.expect("a radius that is too large") - 0.01).abs() < 1e-12, "{found:#?}");
}

#[test]
fn a_solid_in_pieces_and_contacts_without_faces_are_told() {
    let apart = Link { webs: Vec::new(), ..two_eyes() };
    assert_eq!(faults(&apart), [Fault::Unconnected { pieces: 2 }]);
    let touching = Link { eyes: vec![eye([0.0, 0.0], 0.03, 0.1, Z), eye([0.054, 0.072], 0.02, 0.08, Z)], ..link() };
    let found = faults(&touching);
    assert!(found.contains(&Fault::Unconnected { pieces: 2 }), "{found:?}");
    let thin = found.iter().find_map(|f| match f {
        Fault::ThinContact { at, interval } => Some((*at, *interval)),
        _ => None,
    });
    let (at, interval) = thin.expect("eyes that touch in a line");
    assert!((at[0] - 0.03).abs() < 1e-9 && (at[1] - 0.04).abs() < 1e-9 && interval == Z, "{found:?}");
    let corner = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.1], [0.0, 0.1]].map(|p| (p, 0.0));
    let upper = [[0.1, 0.0], [0.2, 0.0], [0.2, 0.1], [0.1, 0.1]].map(|p| (p, 0.0));
    let steps = Link { plates: vec![plate(&corner, [0.0, 0.01]), plate(&upper, [0.01, 0.02])], ..link() };
    let found = faults(&steps);
    assert!(found.iter().any(|f| matches!(f, Fault::ThinContact { interval: [a, b], .. } if a == b)), "{found:?}");
}

#[test]
fn eyes_that_touch_hold_together_by_a_web_or_a_fillet() {
    let mut link = Link {
        eyes: vec![eye([0.0, 0.0], 0.03, 0.1, Z), eye([0.054, 0.072], 0.02, 0.08, Z)],
        fillet: Some(0.01),
        ..link()
    };
    assert_eq!(faults(&link), []);
    link.fillet = None;
    link.webs = vec![bar([0, 1], [0.05, 0.05], Z, Profile::Flat)];
    assert_eq!(faults(&link), []);
}

#[test]
fn a_fillet_touches_what_is_beyond_a_short_curve_and_is_refused_where_nothing_is() {
    // Two bars so near each other that little of the eye is between them.
    let vee = |fillet: f64| Link {
        eyes: vec![eye([0.0, 0.0], 0.02, 0.08, Z), eye([0.3, 0.15], 0.02, 0.06, Z), eye([0.3, -0.15], 0.02, 0.06, Z)],
        webs: vec![bar([0, 1], [0.03, 0.03], Z, Profile::Flat), bar([0, 2], [0.03, 0.03], Z, Profile::Flat)],
        fillet: Some(fillet),
        ..link()
    };
    let volume = |fillet: f64| vee(fillet).build().expect("a sound link").moments.volume;
    let (small, middle, large) = (volume(0.002), volume(0.008), volume(0.012));
    assert!(small < middle && middle < large, "{small} {middle} {large}");
    // One fillet in place of two: fewer edges.
    let edges = |fillet: f64| vee(fillet).build().expect("a sound link").edges.len();
    assert!(edges(0.012) < edges(0.002));
    let step = [[0.0, 0.0], [0.1, 0.0], [0.1, 0.005], [0.05, 0.005], [0.05, 0.05], [0.0, 0.05]].map(|p| (p, 0.0));
    let found = faults(&Link { plates: vec![plate(&step, Z)], fillet: Some(0.06), ..link() });
    let told = found.iter().any(|f| {
        matches!(f, Fault::FilletTooLarge { at, layer, needed, length, .. }
            if *at == [0.05, 0.005] && *layer == Z && (needed - 0.06).abs() < 1e-12 && *length < 0.06)
    });
    assert!(told, "{found:?}");
}

#[test]
fn suspicious_cuts_are_warnings_with_a_solid() {
    let mut link = two_eyes();
    link.cuts = vec![
        through(CutShape::Hole { center: [0.0, 0.5], diameter: 0.02 }),
        through(CutShape::Slot { from: [0.01, 0.02], to: [0.2, 0.06], width: 0.01 }),
        Cut { shape: CutShape::Hole { center: [0.2, 0.06], diameter: 0.02 }, layers: Some(vec![[0.02, 0.03]]) },
    ];
    let found = link.build().expect("a solid all the same").warnings;
    let expected =
        [Fault::CutRemovesNothing { cut: 0 }, Fault::CutInEye { cut: 1, eye: 0 }, Fault::CutRemovesNothing { cut: 2 }];
    assert_eq!(found, expected);
    assert!(found.iter().all(Fault::is_warning));
}

#[test]
fn what_is_wrong_with_a_profile_is_told_at_once() {
    let body = Revolved {
        base: [0.0; 3],
        axis: [0.0, 0.0, 2.0],
        profile: vec![[0.01, 0.0], [-0.02, 0.03], [0.02, 0.03], [0.0, 0.0]],
    };
    let found = body.moments().expect_err("a wrong profile");
    assert!(found.contains(&Fault::Axis { length: 2.0 }));
    assert!(found.contains(&Fault::NegativeRadius { corner: 1, radius: -0.02 }));
    assert!(found.contains(&Fault::TouchesAxis { corner: 3 }));
    assert!(found.iter().any(|f| matches!(f, Fault::SidesCross { part: Part::Profile, .. })), "{found:?}");
}

/// A number that nobody would give.
fn wild(dice: &mut Dice) -> f64 {
    let numbers = [
        0.0,
        -0.0,
        1e-300,
        -1e-300,
        1e300,
        -1e300,
        1e-9,
        1e-6,
        1e6,
        f64::NAN,
        f64::INFINITY,
        f64::NEG_INFINITY,
        f64::MIN_POSITIVE,
        f64::MAX,
        0.05,
        0.1,
        -0.1,
        1e-12,
        0.02,
        3.0,
    ];
    numbers[dice.below(numbers.len())]
}

/// Everything that a built link can be asked.
fn ask(link: &Link<f64>) {
    let Ok(stack) = link.build() else { return };
    let _ = stack.mass_properties(1.0);
    let shell = stack.shell();
    assert_closed(&shell, "a link in question");
    let _ = (shell.sharp_edges(), bellcrank_solid::step::write("x", "", &[]));
    if stack.edges.len() < 100 {
        let _ = shell.surface(1e-3);
    }
}

#[test]
fn wild_numbers_are_faults_or_solids_but_no_panics() {
    for seed in 0..2000 {
        let dice = &mut Dice::new(seed);
        let mut link = random_link(dice);
        for _ in 0..=dice.below(3) {
            let (i, j) = (dice.below(link.eyes.len()), dice.below(2));
            let value = wild(dice);
            match dice.below(9) {
                0 => link.eyes[i].bore = value,
                1 => link.eyes[i].outer = value,
                2 => link.eyes[i].center[j] = value,
                3 => link.eyes[i].clearance = Some(value),
                4 => link.eyes[i].layers[0][j] = value,
                5 => link.fillet = Some(value),
                6 => link.plates.push(Plate {
                    outline: corners(&[([value, 0.0], 0.0), ([0.1, wild(dice)], wild(dice)), ([0.0, 0.1], 0.0)]),
                    layers: vec![[wild(dice), wild(dice)]],
                }),
                7 => link.cuts.push(through(CutShape::Slot { from: [value, 0.0], to: [0.1, wild(dice)], width: 0.01 })),
                _ => {
                    link.webs.push(bar([i, 0], [value, wild(dice)], Z, Profile::Box { wall: wild(dice), skin: 0.001 }))
                }
            }
        }
        ask(&link);
    }
}

#[test]
fn coincident_and_nearly_coincident_parts_do_not_panic() {
    for seed in 0..400 {
        let dice = &mut Dice::new(seed);
        let mut link = random_link(dice);
        let near = [0.0, 1e-15, 1e-12, 1e-10, 1e-9, 3e-9, 1e-8, 1e-7, 1e-6, 1e-4];
        let by = near[dice.below(near.len())];
        let twin: Eye<f64> = link.eyes[0].clone();
        link.eyes.push(Eye { center: [twin.center[0] + by, twin.center[1]], outer: twin.outer + by, ..twin });
        if let Web::Bar(bar) = &mut link.webs[0] {
            let mut other = bar.clone();
            other.widths = other.widths.map(|w| w + by);
            other.layers.iter_mut().for_each(|l| l[1] += by);
            link.webs.push(Web::Bar(other));
        }
        link.fillet = dice.chance(0.5).then_some(0.003);
        ask(&link);
    }
}

#[test]
fn wild_profiles_do_not_panic() {
    for seed in 0..2000 {
        let dice = &mut Dice::new(seed);
        let count = dice.below(7);
        let number = |dice: &mut Dice| if dice.chance(0.1) { wild(dice) } else { dice.unit() };
        let profile = (0..count).map(|_| [number(dice), number(dice)]).collect();
        let body = Revolved { base: [0.0; 3], axis: [0.6, 0.0, 0.8], profile };
        let _ = (body.mass_properties(1.0), body.surface(1e-2).map(|s| s.nodes.len()));
    }
}
