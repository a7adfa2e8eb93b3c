//! ISO 6358: numbers of the verification case P1_iso6358, all to 1e-12.

use bellcrank_sizing::pneumatic::flow::{
    Charging, Conductance, GAS_CONSTANT, discharge_pressure, discharge_time_constant,
};

use crate::near;

/// p1, p2, T1, b, q in kg/s, q in l/min ANR.
const TABLE: [[f64; 6]; 8] = [
    [700000.0, 100000.0, 293.15, 0.3, 0.008295, 420.0],
    [700000.0, 210000.0, 293.15, 0.3, 0.008295, 420.0],
    [700000.0, 400000.0, 293.15, 0.3, 0.007646019372516522, 387.14022139324163],
    [700000.0, 600000.0, 293.15, 0.3, 0.005021825832690491, 254.2696624147084],
    [700000.0, 690000.0, 293.15, 0.3, 0.0016672709278754796, 84.41878115825212],
    [600000.0, 500000.0, 313.15, 0.35, 0.004599686062989828, 232.89549686024446],
    [1013000.0, 101300.0, 293.15, 0.2, 0.01200405, 607.8],
    [700000.0, 600000.0, 293.15, 0.5, 0.005805290690396133, 293.9387691339814],
];

#[test]
fn flow_follows_the_table() {
    for [p1, p2, t1, b, mass, volume] in TABLE {
        let valve = Conductance::new(1e-8, b);
        near(valve.mass_flow(p1, p2, t1), mass, 1e-12);
        near(valve.volume_flow(p1, p2, t1) * 6e4, volume, 1e-12);
        near(valve.needed(volume / 6e4, p1, p2, t1), 1e-8, 1e-12);
    }
}

fn charging() -> Charging {
    let through = Conductance::new(1e-8, 0.3);
    Charging { through, volume: 1e-3, supply: 7e5, start: 1e5, temperature: 293.15 }
}

#[test]
fn a_tank_is_charged_as_in_the_closed_form() {
    let tank = charging();
    near(tank.choked_rate(), 698013.5287124999, 1e-12);
    near(tank.choked_time(), 0.15759006878118428, 1e-12);
    near(tank.full_time(), 1.2602767194958322, 1e-12);
    near(tank.pressure(tank.choked_time()), 210000.0, 1e-12);
    let times = [
        (0.3781273989241139, 361418.3272437242),
        (0.7089333941385083, 556482.3227814082),
        (1.0397393893529028, 676017.6929846252),
    ];
    for (time, pressure) in times {
        near(tank.pressure(time), pressure, 1e-12);
    }
    assert_eq!(tank.pressure(5.0), 7e5);
}

/// The closed form against the flow law, stepped by Runge and Kutta; also from a start above the critical pressure.
#[test]
fn charging_is_the_integral_of_the_flow_law() {
    for start in [1e5, 3.1e5] {
        let tank = Charging { start, ..charging() };
        let rate = |p: f64| tank.through.mass_flow(tank.supply, p, 293.15) * GAS_CONSTANT * 293.15 / tank.volume;
        let (mut p, step) = (start, 1e-5);
        for _ in 0..60_000 {
            let k1 = rate(p);
            let k2 = rate(p + step / 2.0 * k1);
            let k3 = rate(p + step / 2.0 * k2);
            p += step / 6.0 * (k1 + 2.0 * k2 + 2.0 * k3 + rate(p + step * k3));
        }
        near(tank.pressure(0.6), p, 1e-9);
    }
}

#[test]
fn a_tank_empties_as_in_the_closed_form() {
    let tau = discharge_time_constant(1e-3, 1e-8, 293.15);
    near(tau, 1.0028458922438996, 1e-12);
    near(discharge_pressure(7e5, 1.0, tau), 258247.42866110677, 1e-12);
}

#[test]
fn nothing_flows_uphill() {
    let valve = Conductance { sonic: 1e-8, critical_ratio: 0.3, index: 0.6 };
    assert_eq!(valve.mass_flow(5e5, 6e5, 293.15), 0.0);
    assert_eq!(valve.needed(1e-3, 5e5, 5e5, 293.15), f64::INFINITY);
    assert!(valve.share(0.7) < Conductance::new(1e-8, 0.3).share(0.7));
}
