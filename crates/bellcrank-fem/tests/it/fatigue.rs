//! Fatigue against the examples of the standard, the definition written down plainly, closed forms and identities.

use bellcrank_fem::fatigue::{
    Beyond, Cycle, Damage, Equivalent, Fatigue, MeanStress, MetalGroup, Rainflow, Residue, Woehler, WoehlerFault,
    spectrum,
};
use bellcrank_fem::{Six, von_mises};

/// Of ASTM E1049-85, figures 6 and 7.
const STANDARD: [f64; 9] = [-2.0, 1.0, -3.0, 5.0, -1.0, 3.0, -4.0, 4.0, -2.0];

fn close(found: f64, expected: f64, tolerance: f64, what: &str) {
    assert!((found - expected).abs() <= tolerance * expected.abs(), "{what}: {found} against {expected}");
}

/// Numbers between 0 and 1 that are the same in every run.
struct Dice(u64);

impl Dice {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    fn history(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| 200.0 * self.next() - 80.0).collect()
    }

    /// Whole numbers: many equal ranges.
    fn steps(&mut self, count: usize) -> Vec<f64> {
        (0..count).map(|_| (7.0 * self.next()).floor()).collect()
    }
}

/// Range, mean and count of all cycles, equal ones together, by range and mean.
fn table(cycles: &[Cycle]) -> Vec<(f64, f64, f64)> {
    let mut sorted: Vec<(f64, f64, f64)> = cycles.iter().map(|c| (c.range, c.mean, c.count)).collect();
    sorted.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
    let mut merged: Vec<(f64, f64, f64)> = Vec::new();
    for (range, mean, count) in sorted {
        match merged.last_mut() {
            Some(last) if (last.0, last.1) == (range, mean) => last.2 += count,
            _ => merged.push((range, mean, count)),
        }
    }
    merged
}

fn by_range(cycles: &[Cycle]) -> Vec<(f64, f64)> {
    table(&cycles.iter().map(|c| Cycle { mean: 0.0, ..*c }).collect::<Vec<_>>()).iter().map(|c| (c.0, c.2)).collect()
}

fn turning_points(history: &[f64]) -> Vec<f64> {
    let mut points: Vec<f64> = history.to_vec();
    points.dedup();
    let inner = |w: &[f64]| (w[1] - w[0]) * (w[2] - w[1]) < 0.0;
    let middle: Vec<f64> = points.windows(3).filter(|w| inner(w)).map(|w| w[1]).collect();
    let ends = |p: &[f64]| (p[..1].to_vec(), p[p.len() - 1..].to_vec());
    let (mut all, last) = ends(&points);
    all.extend(middle);
    if points.len() > 1 {
        all.extend(last);
    }
    all
}

/// The rules of 5.4.4 as they are written: X the range under consideration, Y the one before it, S the starting point.
fn as_written(history: &[f64]) -> Vec<Cycle> {
    let cycle = |a: f64, b: f64, count: f64| Cycle { range: (a - b).abs(), mean: 0.5 * (a + b), count };
    let (mut points, mut cycles): (Vec<f64>, Vec<Cycle>) = (Vec::new(), Vec::new());
    // Step 1.
    for next in turning_points(history) {
        points.push(next);
        // Steps 2 and 3.
        while points.len() >= 3 {
            let n = points.len();
            let (x, y) = ((points[n - 1] - points[n - 2]).abs(), (points[n - 2] - points[n - 3]).abs());
            if x < y {
                break;
            }
            if n == 3 {
                // Step 5: Y holds S.
                cycles.push(cycle(points[0], points[1], 0.5));
                points.remove(0);
            } else {
                // Step 4.
                cycles.push(cycle(points[n - 3], points[n - 2], 1.0));
                points.drain(n - 3..n - 1);
            }
        }
    }
    // Step 6.
    cycles.extend(points.windows(2).map(|w| cycle(w[0], w[1], 0.5)));
    cycles
}

/// 5.4.5: begun at its highest value and ended there, every cycle closes.
fn repeating_as_written(history: &[f64]) -> Vec<Cycle> {
    let top = (0..history.len()).max_by(|&a, &b| history[a].total_cmp(&history[b])).expect("not empty");
    let turned: Vec<f64> = (0..=history.len()).map(|k| history[(top + k) % history.len()]).collect();
    let points = turning_points(&turned);
    let (mut stack, mut cycles): (Vec<f64>, Vec<Cycle>) = (Vec::new(), Vec::new());
    for point in points {
        stack.push(point);
        while let [.., a, b, c] = stack[..] {
            if (c - b).abs() < (b - a).abs() {
                break;
            }
            cycles.push(Cycle { range: (b - a).abs(), mean: 0.5 * (a + b), count: 1.0 });
            let n = stack.len();
            stack.drain(n - 3..n - 1);
        }
    }
    assert!(stack.len() <= 1, "all closed");
    cycles
}

#[test]
fn the_examples_of_the_standard() {
    let half = Rainflow::count(STANDARD, Residue::Half);
    assert_eq!(by_range(&half), [(3.0, 0.5), (4.0, 1.5), (6.0, 0.5), (8.0, 1.0), (9.0, 0.5)]);
    let whole = half.iter().find(|cycle| cycle.count == 1.0).expect("one closes");
    assert_eq!((whole.range, whole.mean, whole.highest(), whole.lowest()), (4.0, 1.0, 3.0, -1.0));
    let repeated = Rainflow::count(STANDARD, Residue::Repeated);
    assert_eq!(by_range(&repeated), [(3.0, 1.0), (4.0, 1.0), (7.0, 1.0), (9.0, 1.0)]);
}

#[test]
fn random_histories_are_counted_as_the_rules_say() {
    let mut dice = Dice(17);
    for round in 0..400 {
        let count = 2 + round % 97;
        for history in [dice.history(count), dice.steps(count)] {
            let found = table(&Rainflow::count(history.iter().copied(), Residue::Half));
            assert_eq!(found, table(&as_written(&history)), "{history:?}");
            let found = table(&Rainflow::count(history.iter().copied(), Residue::Repeated));
            assert_eq!(found, table(&repeating_as_written(&history)), "repeated {history:?}");
        }
    }
}

#[test]
fn counts_do_not_depend_on_sampling_scale_sign_or_start() {
    let mut dice = Dice(5);
    let history = dice.history(60);
    let cycles = |h: &[f64], residue| table(&Rainflow::count(h.iter().copied(), residue));
    for residue in [Residue::Half, Residue::Repeated] {
        let plain = cycles(&history, residue);
        // Values between two others, and repeated ones, change nothing.
        let fine: Vec<f64> = history.windows(2).flat_map(|w| [w[0], 0.7 * w[0] + 0.3 * w[1], w[1], w[1]]).collect();
        assert_eq!(cycles(&fine, residue), plain);
        let mirrored: Vec<f64> = history.iter().map(|x| -2.0 * x).collect();
        let mut expected: Vec<(f64, f64, f64)> = plain.iter().map(|(r, m, c)| (2.0 * r, -2.0 * m, *c)).collect();
        expected.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.total_cmp(&b.1)));
        assert_eq!(cycles(&mirrored, residue), expected);
    }
    let plain = cycles(&history, Residue::Repeated);
    for start in [1, 23, 59] {
        let turned: Vec<f64> = (0..60).map(|k| history[(start + k) % 60]).collect();
        assert_eq!(cycles(&turned, Residue::Repeated), plain, "begun at {start}");
    }
    let reversals = turning_points(&history).len() as f64 - 1.0;
    let total: f64 = Rainflow::count(history, Residue::Half).iter().map(|c| c.count).sum();
    assert_eq!(total, 0.5 * reversals, "every range is half a cycle");
}

#[test]
fn histories_without_cycles() {
    for residue in [Residue::Half, Residue::Repeated] {
        assert!(Rainflow::count([], residue).is_empty());
        assert!(Rainflow::count([3.0; 5], residue).is_empty());
    }
    assert_eq!(by_range(&Rainflow::count([1.0, 2.0, 5.0], Residue::Half)), [(4.0, 0.5)]);
    assert_eq!(by_range(&Rainflow::count([1.0, 2.0, 5.0], Residue::Repeated)), [(4.0, 1.0)]);
}

#[test]
fn a_spectrum_holds_every_cycle_once() {
    let cycles = Rainflow::count(Dice(3).history(500), Residue::Half);
    let classes = spectrum(&cycles, 16);
    let total: f64 = cycles.iter().map(|c| c.count).sum();
    assert_eq!(classes.iter().map(|c| c.1).sum::<f64>(), total);
    let below: f64 = cycles.iter().filter(|c| c.amplitude() <= classes[4].0).map(|c| c.count).sum();
    assert_eq!(classes[..5].iter().map(|c| c.1).sum::<f64>(), below);
    assert!(spectrum(&[], 3).iter().all(|c| c.1 == 0.0) && spectrum(&cycles, 0).is_empty());
}

fn line(beyond: Beyond) -> Woehler {
    Woehler::new(173e6, 1.7e6, 5.3, beyond).expect("a line")
}

fn rules(beyond: Beyond) -> Fatigue {
    Fatigue { line: line(beyond), mean: MeanStress::None, residue: Residue::Half }
}

/// `n` cycles of an amplitude about a mean.
fn constant(amplitude: f64, mean: f64, n: usize) -> Vec<f64> {
    (0..=2 * n).map(|k| mean + if k % 2 == 0 { -amplitude } else { amplitude }).collect()
}

#[test]
fn constant_amplitudes_live_as_long_as_the_line_says() {
    for beyond in [Beyond::Infinite, Beyond::Elementary, Beyond::Haibach] {
        let damage = rules(beyond).assess(constant(260e6, 31e6, 40));
        close(damage.sum, 40.0 / (1.7e6 * (260.0_f64 / 173.0).powf(-5.3)), 1e-12, "above the knee");
        assert_eq!((damage.cycles, damage.largest), (40.0, 260e6));
        close(damage.repeats(), 1.0 / damage.sum, 1e-15, "repeats");
    }
    let low = |beyond| rules(beyond).assess(constant(90e6, 0.0, 1));
    assert_eq!(low(Beyond::Infinite).sum, 0.0);
    assert!(low(Beyond::Infinite).repeats().is_infinite());
    close(low(Beyond::Elementary).sum, (90.0_f64 / 173.0).powf(5.3) / 1.7e6, 1e-12, "elementary");
    close(low(Beyond::Haibach).sum, (90.0_f64 / 173.0).powf(9.6) / 1.7e6, 1e-12, "Haibach");
    assert_eq!(rules(Beyond::Haibach).assess([5.0; 4]).sum, 0.0);
}

#[test]
fn damage_grows_with_the_power_of_the_slope() {
    let history: Vec<f64> = Dice(11).history(300).iter().map(|x| 1e6 * x).collect();
    let damage = |factor: f64| rules(Beyond::Elementary).assess(history.iter().map(|x| factor * x)).sum;
    close(damage(1.37), damage(1.0) * 1.37_f64.powf(5.3), 1e-12, "s^k");
    let ordered =
        [Beyond::Infinite, Beyond::Haibach, Beyond::Elementary].map(|beyond| rules(beyond).assess(history.clone()).sum);
    assert!(ordered.is_sorted() && ordered[0] < ordered[2], "{ordered:?}");
}

#[test]
fn the_equivalent_amplitude_does_the_same_damage() {
    let history: Vec<f64> = Dice(29).history(300).iter().map(|x| 2e6 * x).collect();
    for beyond in [Beyond::Elementary, Beyond::Haibach] {
        let rules = rules(beyond);
        let damage = rules.assess(history.clone());
        for cycles in [1.0, damage.cycles, 1e7] {
            let amplitude = damage.equivalent(&rules.line, cycles);
            close(cycles * rules.line.damage(amplitude), damage.sum, 1e-12, "damage");
        }
        close(rules.line.cycles_at(rules.line.amplitude_at(3e8)), 3e8, 1e-12, "there and back");
        close(rules.line.cycles_at(rules.line.amplitude_at(4e4)), 4e4, 1e-12, "there and back");
    }
    assert_eq!(Damage::default().equivalent(&line(Beyond::Infinite), 10.0), 0.0);
}

#[test]
fn mean_stress_by_goodman_and_by_sensitivity() {
    let goodman = MeanStress::Goodman { tensile: 520e6 };
    close(goodman.equivalent(80e6, 130e6), 80e6 / 0.75, 1e-14, "Goodman");
    assert_eq!(goodman.equivalent(80e6, -130e6), 80e6);
    assert!(goodman.equivalent(1e6, 520e6).is_infinite());
    let m = MetalGroup::Steel.sensitivity(900e6);
    close(m, 0.215, 1e-14, "M of steel");
    assert_eq!(MetalGroup::Steel.sensitivity(200e6), 0.0);
    let fkm = |mean: f64| MeanStress::Fkm { sensitivity: m }.equivalent(100.0, mean);
    close(fkm(0.0), 100.0, 1e-15, "R = −1");
    close(fkm(100.0), 100.0 * (1.0 + m), 1e-14, "R = 0");
    close(fkm(-100.0), 100.0 * (1.0 - m), 1e-14, "R = −∞");
    close(fkm(300.0), 100.0 * (1.0 + m).powi(2) / (1.0 + m / 3.0), 1e-14, "R = ½");
    close(fkm(1e4), fkm(300.0), 1e-15, "R near 1");
    close(fkm(-1e4), fkm(-100.0), 1e-15, "compression");
    // No jumps, and never less damage for more tension.
    let values: Vec<f64> = (-200..=500).map(|mean| fkm(f64::from(mean))).collect();
    assert!(values.windows(2).all(|w| w[1] >= w[0] && w[1] - w[0] <= m + 1e-12));
    // Sensitivity is what relates amplitudes at R = −1 and R = 0.
    let rules = Fatigue { mean: MeanStress::Fkm { sensitivity: m }, ..rules(Beyond::Elementary) };
    let (pulsating, alternating) =
        (rules.assess(constant(100e6, 100e6, 7)), rules.assess(constant(100e6 * (1.0 + m), 0.0, 7)));
    close(pulsating.sum, alternating.sum, 1e-12, "damage");
}

#[test]
fn lines_that_make_no_sense_are_told() {
    let fault = |a, n, k| Woehler::new(a, n, k, Beyond::Haibach).expect_err("no line");
    assert_eq!(fault(-1.0, 1e6, 5.0), WoehlerFault::Amplitude(-1.0));
    assert_eq!(fault(1e8, 0.0, 5.0), WoehlerFault::Cycles(0.0));
    assert_eq!(fault(1e8, 1e6, 0.5), WoehlerFault::Slope(0.5));
    assert!(rules(Beyond::Haibach).assess([1e8, f64::NAN, -1e8]).sum.is_nan());
}

const ALL: [Equivalent; 3] = [Equivalent::VonMises, Equivalent::VonMisesByPrincipal, Equivalent::Principal];

#[test]
fn in_one_direction_every_rule_gives_the_stress_itself() {
    let unit = [0.6, -0.64, 0.48_f64];
    let uniaxial =
        |s: f64| -> Six { [(0, 0), (1, 1), (2, 2), (0, 1), (1, 2), (2, 0)].map(|(i, j)| s * unit[i] * unit[j]) };
    let proportional = Equivalent::proportional(&[uniaxial(30.0), uniaxial(-140.0)]);
    for rule in ALL.into_iter().chain([proportional]) {
        for s in [150.0, -70.0, 0.3] {
            close(rule.of(&uniaxial(s)), s, 1e-9, "uniaxial");
        }
    }
}

#[test]
fn a_proportional_history_is_its_factor() {
    // Also where the mean pressure is small against shear, and in pure shear.
    for direction in [[130.0, -40.0, 25.0, 60.0, -35.0, 80.0], [0.0, 0.0, 0.0, 50.0, -20.0, 70.0]] {
        let factors: Vec<f64> = Dice(2).history(50).iter().map(|x| x / 100.0).collect();
        let history: Vec<Six> = factors.iter().map(|c| direction.map(|s: f64| c * s)).collect();
        let rule = Equivalent::proportional(&history);
        let signs: Vec<f64> =
            history.iter().zip(&factors).map(|(s, c)| rule.of(s) / (c * von_mises(&direction))).collect();
        assert!(signs.iter().all(|s| (s - signs[0]).abs() < 1e-12 && (s.abs() - 1.0).abs() < 1e-12), "{signs:?}");
    }
    // The others see half the range of an alternating shear, as their pages say.
    for rule in ALL {
        assert!(rule.of(&[0.0, 0.0, 0.0, -50.0, 0.0, 0.0]) > 0.0);
    }
    let rule = Equivalent::proportional(&[[0.0, 0.0, 0.0, 50.0, 0.0, 0.0]]);
    close(rule.of(&[0.0, 0.0, 0.0, -50.0, 0.0, 0.0]), -50.0 * 3.0_f64.sqrt(), 1e-12, "alternating shear");
}

#[test]
fn signs_and_sizes_in_a_general_state() {
    let stress = [-90.0, -40.0, 35.0, 20.0, -15.0, 30.0];
    let [first, _, third] = bellcrank_fem::principal(&stress);
    assert!(first > 0.0 && -third > first, "pressure is larger");
    close(Equivalent::Principal.of(&stress), third, 1e-14, "principal");
    close(Equivalent::VonMisesByPrincipal.of(&stress), -von_mises(&stress), 1e-14, "by principal");
    close(Equivalent::VonMises.of(&stress), -von_mises(&stress), 1e-14, "by pressure");
    close(Equivalent::VonMises.of(&stress.map(|s| -s)), von_mises(&stress), 1e-14, "turned over");
}
