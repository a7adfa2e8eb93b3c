//! A machine that takes other numbers answers like one built from them.

use crate::build::coordinate;
use crate::machines::lift_blueprint;
use crate::random::{prepared, random_mechanism};
use bellcrank_multibody::{Actuation, Blueprint, BodyId, Engine, JointId, engine_for};

/// The same machine, a little longer and heavier everywhere.
fn grown(b: &Blueprint<f64>, share: f64) -> Blueprint<f64> {
    let mut b = b.clone();
    b.bodies.iter_mut().for_each(|body| body.mass *= 1.0 + share);
    for place in b.joints.iter_mut().filter_map(|joint| joint.places.as_mut()).flatten() {
        place.position = place.position.map(|x| x * (1.0 + share));
    }
    b
}

fn answers(e: &dyn Engine, b: &Blueprint<f64>) -> Vec<f64> {
    let mut all = Vec::new();
    for body in (0..b.bodies.len()).map(BodyId) {
        let motion = e.body(body);
        all.extend(motion.center.position.iter().chain(&motion.center.acceleration).chain(&motion.omega));
    }
    (0..b.joints.len()).for_each(|j| all.extend(e.reaction(JointId(j)).force));
    all
}

fn solve(e: &mut dyn Engine, actuation: &Actuation, by: f64) -> bool {
    if e.assemble(&[]).is_err() || e.prepare(actuation).is_err() {
        return false;
    }
    let places: Vec<f64> = actuation.position.iter().map(|c| e.coordinate(*c).position + by).collect();
    let rates = vec![0.3; places.len()];
    e.move_to(0.0, &places).is_ok() && e.set_rates(&rates, &rates).is_ok() && e.solve_forces(&mut |_, _| {}).is_ok()
}

fn check(b: &Blueprint<f64>, planar: bool, actuation: &Actuation, what: &str) -> bool {
    let mut kept = engine_for(planar, b).expect("builds");
    if !solve(&mut *kept, actuation, 0.05) {
        return false;
    }
    for share in [0.02, -0.013, 0.0] {
        let other = grown(b, share);
        kept.renew(&other).expect("the same structure");
        let mut fresh = engine_for(planar, &other).expect("builds");
        let (a, b) = (solve(&mut *kept, actuation, 0.03), solve(&mut *fresh, actuation, 0.03));
        assert_eq!(a, b, "{what}");
        if a {
            // Bit for bit: the answers of a family of designs must not depend on which came before.
            assert_eq!(answers(&*kept, &other), answers(&*fresh, &other), "{what}, {share}");
        }
    }
    true
}

#[test]
fn a_renewed_machine_answers_like_a_fresh_one() {
    let lift = lift_blueprint([19.84, 20.8, 19.4]);
    let (lever, slide) = (vec![coordinate(2)], vec![coordinate(1)]);
    let actuation = Actuation { position: lever, rate: slide.clone(), effort: slide };
    assert!(check(&lift, true, &actuation, "the lift"));
    let mut tested = 0;
    for seed in 0..40 {
        let planar = seed % 2 == 0;
        let b = random_mechanism(seed, planar, 3, (seed % 3) as usize);
        let Some((_, list)) = prepared(&b, planar) else { continue };
        let actuation = Actuation { position: list.clone(), rate: list.clone(), effort: list };
        tested += usize::from(check(&b, planar, &actuation, &format!("seed {seed}")));
    }
    assert!(tested > 20, "only {tested} could be tested");
}
