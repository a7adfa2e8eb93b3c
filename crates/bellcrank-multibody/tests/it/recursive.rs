//! Inverse dynamics and mass matrix of an open chain: against Pinocchio, finite differences and forward dynamics.

use crate::arm::{AXES, machine, states};
use crate::build::coordinate;
use crate::forward::Nothing;
use bellcrank_math::Spatial;
use bellcrank_multibody::{Dynamics, Engine, Forward, Machine, Readings};

type Six = [f64; AXES];

fn torques(e: &mut Machine<Spatial<f64>>, q: &Six, v: &Six, a: &Six) -> Six {
    let mut tau = [0.0; AXES];
    e.inverse_dynamics(q, v, a, &mut tau);
    tau
}

fn masses(e: &mut Machine<Spatial<f64>>, q: &Six) -> [Six; AXES] {
    let mut m = [0.0; AXES * AXES];
    e.mass_matrix(q, &mut m);
    std::array::from_fn(|i| std::array::from_fn(|j| m[i * AXES + j]))
}

/// Pinocchio 4.1.0, `benches/peers/pinocchio_arm.cpp`: torques and lower triangle of the mass matrix, first state.
const PINOCCHIO: [f64; 27] = [
    4.425_965_642_760_994,
    -39.788_623_898_088_86,
    -12.844_634_690_914_267,
    -0.896_685_528_946_928_3,
    -0.037_887_537_511_554_31,
    -4.578_436_840_670_040_4e-5,
    2.744_354_573_881_631_5,
    -0.306_556_334_533_270_86,
    3.753_869_318_950_201,
    -0.062_417_374_747_069_5,
    1.430_884_908_315_714_5,
    0.727_421_966_431_228_9,
    -0.011_100_521_283_665_789,
    0.144_090_520_548_556_3,
    0.077_726_527_571_617_33,
    0.020_160_744_018_255_55,
    -0.012_175_221_592_968_612,
    0.002_127_797_444_247_132,
    0.001_185_565_532_826_967_8,
    0.000_337_504_733_015_494_47,
    0.002_272_445_459_471_115_8,
    8.955_165_682_365_585e-5,
    -5.202_648_639_884_876e-6,
    -4.931_853_213_088_802e-6,
    -1.206_189_077_829_122e-5,
    -6.546_712_934_858_711e-6,
    0.000_140_024_427,
];

#[test]
fn the_arm_of_pinocchio() {
    let (mut e, [q, v, a]) = (machine(), states()[0]);
    assert_eq!(e.sizes(), (AXES, AXES));
    let (tau, m) = (torques(&mut e, &q, &v, &a), masses(&mut e, &q));
    let lower = (0..AXES).flat_map(|i| (0..=i).map(move |j| (i, j))).map(|(i, j)| m[i][j]);
    for (ours, known) in tau.into_iter().chain(lower).zip(PINOCCHIO) {
        assert!((ours - known).abs() < 1e-12, "{ours} against {known}");
    }
}

/// Lagrange's equations by differences: `h = Σ (∂M_ij/∂q_k − ½ ∂M_jk/∂q_i) v_j v_k`.
#[test]
fn velocity_terms_are_the_derivatives_of_the_masses() {
    let mut e = machine();
    for [q, v, _] in &states()[..10] {
        let step = 1e-5;
        let slope: Vec<[Six; AXES]> = (0..AXES)
            .map(|k| {
                let moved = |s: f64| std::array::from_fn(|i| q[i] + if i == k { s } else { 0.0 });
                let (up, down) = (masses(&mut e, &moved(step)), masses(&mut e, &moved(-step)));
                std::array::from_fn(|i| std::array::from_fn(|j| (up[i][j] - down[i][j]) / (2.0 * step)))
            })
            .collect();
        let zero = [0.0; AXES];
        let (moving, still) = (torques(&mut e, q, v, &zero), torques(&mut e, q, &zero, &zero));
        for i in 0..AXES {
            let pairs = (0..AXES).flat_map(|j| (0..AXES).map(move |k| (j, k)));
            let h: f64 = pairs.map(|(j, k)| (slope[k][i][j] - 0.5 * slope[i][j][k]) * v[j] * v[k]).sum();
            assert!((moving[i] - still[i] - h).abs() < 1e-7, "axis {i}: {} against {h}", moving[i] - still[i]);
        }
    }
}

#[test]
fn what_falls_freely_asks_for_no_torque() {
    let mut e = machine();
    for [q, v, _] in &states()[..10] {
        let hold: Vec<_> = (0..AXES).map(|i| (coordinate(i), q[i])).collect();
        e.assemble(&hold).expect("assembles");
        let velocities = (0..AXES).map(|i| (coordinate(i), v[i])).collect();
        e.begin(&Dynamics { velocities, ..Dynamics::free() }, &mut Nothing).expect("begins");
        let at: [_; AXES] = std::array::from_fn(|i| e.coordinate(coordinate(i)));
        let tau = torques(&mut e, &at.map(|r| r.position), &at.map(|r| r.velocity), &at.map(|r| r.acceleration));
        assert!(tau.iter().all(|t| t.abs() < 1e-9), "{tau:?}");
        let m = masses(&mut e, &at.map(|r| r.position));
        let twice: f64 = (0..AXES).map(|i| (0..AXES).map(|j| v[i] * m[i][j] * v[j]).sum::<f64>()).sum();
        assert!((e.energy().kinetic - 0.5 * twice).abs() < 1e-10 * twice);
    }
}
