//! Forces: the verification case P2_iso15552, a trade journal's example, identities.

use bellcrank_sizing::pneumatic::Side;
use bellcrank_sizing::pneumatic::force::{annulus_area, circle, piston_area, pull, push, working_pressure};
use proptest::prelude::*;

use crate::near;

/// Bore and rod in mm, push and pull in N at 6 bar.
const P2: [[f64; 4]; 11] = [
    [32.0, 12.0, 482.5486315913922, 414.6902302738527],
    [40.0, 16.0, 753.9822368615503, 633.3450789637022],
    [50.0, 20.0, 1178.0972450961724, 989.6016858807849],
    [63.0, 20.0, 1870.3471863146833, 1681.8516270992957],
    [80.0, 25.0, 3015.928947446201, 2721.4046361721585],
    [100.0, 25.0, 4712.38898038469, 4417.864669110647],
    [125.0, 32.0, 7363.107781851078, 6880.559150259685],
    [160.0, 40.0, 12063.715789784805, 11309.733552923255],
    [200.0, 40.0, 18849.55592153876, 18095.57368467721],
    [250.0, 50.0, 29452.43112740431, 28274.33388230814],
    [320.0, 63.0, 48254.86315913922, 46384.51597282454],
];

#[test]
fn theoretical_forces_of_iso_15552_at_6_bar() {
    for [bore, rod, out, back] in P2 {
        near(push(bore / 1e3, 6e5), out, 4e-15);
        near(pull(bore / 1e3, rod / 1e3, 6e5), back, 4e-15);
    }
}

/// Hydraulics & Pneumatics, "A checklist for matching pneumatic cylinders": 1 1/2 in at 80 psi gives 141 lb.
#[test]
fn the_journals_cylinder_pushes_141_pounds() {
    let (inch, psi, pound) = (0.0254, 6894.757, 4.448222);
    near(push(1.5 * inch, 80.0 * psi) / pound, 141.0, 3e-3);
}

proptest! {
    #[test]
    fn force_grows_with_the_square_of_the_bore(bore in 0.008f64..0.32, k in 1.1f64..4.0, p in 1e4f64..1e6) {
        near(push(k * bore, p), k * k * push(bore, p), 1e-14);
        near(pull(k * bore, k * bore / 4.0, p), k * k * pull(bore, bore / 4.0, p), 1e-13);
        near(push(bore, p) - pull(bore, bore / 4.0, p), p * circle(bore / 4.0), 1e-12);
    }

    #[test]
    fn working_pressure_gives_the_force_back(effort in -2e4f64..2e4, bore in 0.03f64..0.3, eta in 0.5f64..1.0) {
        let (side, p) = working_pressure(effort, bore, bore / 3.0, eta);
        let area = if side == Side::Piston { piston_area(bore) } else { -annulus_area(bore, bore / 3.0) };
        near(p * area * eta, effort, 1e-13);
    }
}
