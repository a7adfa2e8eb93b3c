//! The page itself.

use bellcrank_results::ParameterRow;

use super::figure::Figure;
use super::machine::{self, Study, parameters, study};
use super::{errors, positions, questions};

/// The whole page, computed now.
pub(crate) fn page() -> Result<String, String> {
    let parameters = parameters()?;
    let (lift, massless) = (study("lift", &[])?, study("massless", &[])?);
    let l1 = questions::value(&parameters, "l1")?;
    let parts = [
        introduction(),
        data(&parameters),
        format!("\n## Results\n\n{}{}", Figure::HEADING, rows(&results(&lift, &massless, l1)?)),
        peaks(&lift, &massless)?,
        format!("\n## Five positions\n\n{FIVE}\n\n{}", positions::table(&lift, &massless, l1)?),
        questions_section()?,
        format!("\n## Where the paper errs\n\n{}", errors::section(&lift, &massless, &parameters)?),
    ];
    Ok(parts.concat())
}

fn introduction() -> String {
    format!(
        "# The lift of the assist manipulator, against its paper\n\nWritten by `cargo xtask paper` from a run of \
         [`{model}`](../../{model}); a test compares this page with what the program computes. Source: \"Mechanism Analysis and \
         Dynamics Simulation of Assist Manipulator\". \"Recomputed\" figures come from the paper's own equations, corrected where \
         they err, by a script that shares nothing with this program. Deviations are computed less printed, in the unit of the \
         figure.\n",
        model = machine::MODEL
    )
}

const FIVE: &str = "At v2 = 20 mm/s, constant. Each cell: computed (less recomputed).";

/// What the paper leaves out and its results identify.
const IDENTIFIED: [(&str, &str); 6] = [
    ("l61", "identified: θ1 and the stroke come out to every printed digit; the optimum only if l61 follows l32"),
    ("l1", "identified: s2 = 0 at θ3 = 0"),
    ("m1", "identified: the one mass that brings the peak force to 6473.6 N, weights and inertia forces counted"),
    ("l62", "free: no effect on any stated figure"),
    ("l42", "free: no effect on any stated figure"),
    ("theta", "where assembly starts, for machines that carry the lift: no effect on any figure"),
];

fn data(parameters: &[ParameterRow]) -> String {
    let mut text = String::from("\n## Data\n\n| parameter | as written | value | from |\n|---|---|---|---|\n");
    for row in parameters {
        let origin =
            IDENTIFIED.iter().find(|(name, _)| *name == row.name).map_or("stated in the paper", |(_, why)| why);
        let (value, unit) = (row.unit.show(row.value), &row.unit.symbol);
        text.push_str(&format!("| {} | `{}` | {} {unit} | {origin} |\n", row.name, row.written, trimmed(value)));
    }
    text.push_str(
        "\nCentres of mass: link 1 at l1/2 from O, link 3 at l5/2 − 50 mm from B (both stated), link 5 at l5/2 from A \
         (identified). Inertia about the centre of mass J = m·c² with c that distance, as stated. Links 2 and 4 have no mass: \
         the load of 800 N at K is weight and inertia of the carried part together. g = 9.81 m/s².\n",
    );
    text
}

/// As many digits as a drawing has.
fn trimmed(value: f64) -> String {
    let text = format!("{value:.6}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn rows(figures: &[Figure]) -> String {
    figures.iter().map(Figure::row).collect()
}

fn results(lift: &Study, massless: &Study, l1: f64) -> Result<[Figure; 7], String> {
    let (low, high) = lift.range("joint.O.position")?;
    let (short, long) = lift.range("joint.slide.position")?;
    let figure = |quantity, paper, target, value| Figure { quantity, paper, target, value };
    Ok([
        figure("θ1, lowest [deg]", "-31.885", "-31.883", low.to_degrees()),
        figure("θ1, highest [deg]", "28.487", "28.488", high.to_degrees()),
        figure("s2, lowest [mm]", "-79.65", "-79.648", 1e3 * (short - l1)),
        figure("s2, highest [mm]", "80.28", "80.283", 1e3 * (long - l1)),
        figure("s2, total [mm]", "159.93", "159.931", 1e3 * (long - short)),
        figure("peak cylinder force, masses ignored [N]", "4842", "4844.5", massless.peak()?.0),
        figure("peak cylinder force, masses and inertia [N]", "6473.6", "6473.6", lift.peak()?.0),
    ])
}

fn peaks(lift: &Study, massless: &Study) -> Result<String, String> {
    Ok(format!(
        "\nThe peaks occur at θ3 = {:.0}° (masses ignored) and θ3 = {:.0}° (with masses). The paper prints \
         the first of them nowhere: 4842 N is what its \"25.2 %\" leaves of 6473.6 N (see the third error below).\n",
        massless.peak()?.1,
        lift.peak()?.1
    ))
}

fn questions_section() -> Result<String, String> {
    Ok(format!(
        "\n## The optimum\n\nThe study `shorter` of the model file: the smallest peak force over l31 [600, 800], l32 [100, 200], \
         l5 [800, 1000] mm, masses held, l61 following l32 and l1 following l31, at most 200 mm of stroke. {}\n\n{}{}\n\
         ## What matters\n\nThe study `influence`: relative sensitivities, d(ln peak)/d(ln parameter), from exact derivatives. The \
         recomputed ones are central differences of an independent script. The paper finds l32 and l5 the most significant lengths, \
         as here.\n\n{}{}",
        questions::search()?,
        Figure::HEADING,
        rows(&questions::optimum()?),
        Figure::HEADING,
        rows(&questions::sensitivities()?)
    ))
}
