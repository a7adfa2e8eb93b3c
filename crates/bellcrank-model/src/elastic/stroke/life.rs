//! Life under repeats of a study: rainflow cycles of the stress at a hot spot against the Woehler line of its material.

use bellcrank_fem::Six;
use bellcrank_fem::fatigue::{Beyond, Cycle, Equivalent, Fatigue as Rules, MeanStress, Rainflow};
use bellcrank_results::{Fatigue, Unit};

use super::spots::Spot;
use crate::build;
use crate::design::{Design, Values};
use crate::measure::Measure;
use crate::run::shown;

/// Holds whatever the material.
const BASIS: [&str; 4] = [
    "Life is worked out where the stress of each region is largest, from nodal stress at the surface; surface, size, notch \
     and temperature count as far as the Woehler line of the material has them.",
    "The six components become von Mises' stress, with the sign of its deviator's product with that of the largest stress: \
     exact where principal directions stay, and it may err to either side where they turn.",
    "One run of the study is one repeat, and repeats follow each other without end, so that ranges left open by one are \
     closed by the next (rainflow counting, ASTM E1049-85, 5.4.5).",
    "Stress is elastic, and damage adds up whatever the order of cycles (Miner); experiments fail at sums of about 0.3 to 3.",
];

/// How life of a body is worked out; `None` where its material does not say.
pub(super) struct Life {
    /// Name of the material.
    material: String,
    rules: Rules,
}

impl Life {
    /// Of the material of a body with a solid, which was checked when the model was read.
    pub(super) fn of(design: &Design, values: &Values, body: usize) -> Option<Life> {
        let solid = design.solids.get(design.bodies[body].solid.as_ref()?.solid)?;
        let rules = build::material(design, values, solid.material?, &mut Vec::new())?.fatigue?;
        Some(Life { material: design.materials.get(solid.material?)?.name.clone(), rules })
    }

    /// Fills in what can be trusted.
    pub(super) fn tell(&self, spots: &mut [Spot]) {
        for spot in spots.iter_mut().filter(|spot| spot.found.singular.is_none()) {
            spot.found.fatigue = fatigue(&self.rules, &spot.stresses);
        }
    }

    /// Adds what the numbers rest on, each sentence once.
    pub(super) fn assume(&self, design: &Design, sentences: &mut Vec<String>) {
        let own = self.sentence(&design.units.of(Measure::Stress));
        for sentence in BASIS.into_iter().map(str::to_owned).chain([own]) {
            if !sentences.contains(&sentence) {
                sentences.push(sentence);
            }
        }
    }

    fn sentence(&self, unit: &Unit) -> String {
        let line = &self.rules.line;
        let beyond = match line.beyond {
            Beyond::Infinite => "no damage below that amplitude",
            Beyond::Elementary => "the same slope below that amplitude (elementary Miner)",
            Beyond::Haibach => "slope 2k - 1 below that amplitude (Haibach)",
        };
        let mean = match self.rules.mean {
            MeanStress::None => "mean stress does not count".to_owned(),
            MeanStress::Goodman { tensile } => {
                format!("mean stress after Goodman with a tensile strength of {}", shown(tensile, unit))
            }
            MeanStress::Fkm { sensitivity } => {
                format!("mean stress after the FKM guideline with a sensitivity of {sensitivity:.3}")
            }
        };
        format!(
            "Woehler line of material `{}`: amplitude {} at {} cycles and R = -1, slope k = {}, {beyond}; {mean}.",
            self.material,
            shown(line.amplitude, unit),
            line.cycles,
            line.slope
        )
    }
}

/// What one repeat of a history of stress does, Pa; `None` of a single row, or where a stress is not a number.
fn fatigue(rules: &Rules, stresses: &[Six]) -> Option<Fatigue> {
    if stresses.len() < 2 {
        return None;
    }
    let equivalent = Equivalent::proportional(stresses);
    let history = || stresses.iter().map(|stress| equivalent.of(stress));
    let damage = rules.assess(history());
    if damage.sum.is_nan() {
        return None;
    }
    let cycles = Rainflow::count(history(), rules.residue);
    let larger = |a: &&Cycle, b: &&Cycle| a.range.total_cmp(&b.range).then(a.mean.total_cmp(&b.mean));
    let largest = cycles.iter().max_by(larger);
    Some(Fatigue {
        damage: damage.sum,
        life: (damage.sum > 0.0).then(|| damage.repeats()),
        amplitude: largest.map_or(0.0, Cycle::amplitude),
        mean: largest.map_or(0.0, |cycle| cycle.mean),
        cycles: damage.cycles,
    })
}

#[cfg(test)]
mod tests {
    use bellcrank_fem::fatigue::{Residue, Woehler};

    use super::*;

    fn rules(mean: MeanStress, beyond: Beyond) -> Rules {
        let line = Woehler::new(180e6, 1e6, 5.0, beyond).expect("a line");
        Rules { line, mean, residue: Residue::Repeated }
    }

    /// Tension along a general direction n: σ n nᵀ, components xx, yy, zz and shears in any order (von Mises is σ).
    fn tension(size: f64) -> Six {
        let n = [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0];
        [n[0] * n[0], n[1] * n[1], n[2] * n[2], n[0] * n[1], n[1] * n[2], n[2] * n[0]].map(|share| size * share)
    }

    /// By hand: between 260 and -100 MPa the amplitude is 180 and the mean 80 MPa; Goodman with 490 MPa makes 215.12 MPa
    /// of it, and 1e6 (215.12/180)^-5 = 410146 cycles; three of them a repeat.
    #[test]
    fn constant_amplitude_is_as_by_hand() {
        let history: Vec<Six> =
            [80.0, 260.0, -100.0, 260.0, -100.0, 260.0, -100.0, 80.0].map(|s| tension(1e6 * s)).to_vec();
        let found = fatigue(&rules(MeanStress::Goodman { tensile: 490e6 }, Beyond::Elementary), &history);
        let found = found.expect("a life");
        let near = |value: f64, hand: f64| assert!((value / hand - 1.0).abs() < 1e-5, "{value} and {hand}");
        near(found.life.expect("an end"), 410_146.38 / 3.0);
        near(found.damage, 3.0 / 410_146.38);
        near(found.amplitude, 180e6);
        near(found.mean, 80e6);
        near(found.cycles, 3.0);
    }

    #[test]
    fn small_cycles_have_no_end_where_the_line_says_so() {
        let history: Vec<Six> = [10.0, 150.0, -150.0, 10.0].map(|s| tension(1e6 * s)).to_vec();
        let found = fatigue(&rules(MeanStress::None, Beyond::Infinite), &history).expect("an answer");
        assert_eq!((found.damage, found.life), (0.0, None));
        assert!((found.amplitude - 150e6).abs() < 1.0);
        assert!(fatigue(&rules(MeanStress::None, Beyond::Infinite), &history[..1]).is_none());
    }
}
