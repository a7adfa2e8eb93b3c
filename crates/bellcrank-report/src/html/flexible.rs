//! Flexible bodies: how they were reduced and the stress in them over the rows; and the numbers with which they move.

mod data;

use bellcrank_results::{FlexibleBodies, FlexibleBody, ReductionCheck, SpotHistory, StudyResult};

use super::Escaped;
use super::rows::{Rows, code, digits, words};
use crate::number;
use crate::told::{self, about};

pub(crate) use data::push as push_data;

const STRESS: &str = "The largest von Mises stress of each region over all rows. The margin is the yield strength over the \
    stress, less one; damage is the share of the life that one repeat of the study uses up.";
const SINGULAR: &str = "At a sharp re-entrant edge, and where a rigid coupling ends, the stress of an elastic body has no \
    bound: these numbers grow with every finer mesh.";

/// Sentences and tables; nothing for a study of rigid bodies.
pub(crate) fn section(study: &StudyResult) -> String {
    let Some(found) = &study.flexible else { return String::new() };
    let line = |text: &String| format!("<p class=\"lead\">{}</p>\n", words(text));
    let told: String = told::flexible::sentences(found).iter().map(line).collect();
    let bodies: String = found.bodies.iter().map(|body| of_body(found, body)).collect();
    let assumed: String = found.assumptions.iter().map(|text| format!("<li>{}</li>\n", words(text))).collect();
    let assumed =
        if assumed.is_empty() { assumed } else { format!("<p>Life is based on:</p>\n<ul>\n{assumed}</ul>\n") };
    format!("<h3>Flexible bodies</h3>\n{told}{bodies}{assumed}{}", heavy(study))
}

/// Says so where the page shows less than there is.
fn heavy(study: &StudyResult) -> String {
    let too_much = study.motions.iter().filter(|motion| !data::is_light(motion));
    too_much
        .map(|motion| {
            let (name, nodes) = (code(&motion.body), motion.nodes.len());
            format!("<p class=\"hint\">Too much to be moved in this page: {name} with {nodes} nodes.</p>\n")
        })
        .collect()
}

fn of_body(found: &FlexibleBodies, body: &FlexibleBody) -> String {
    let name = Escaped(&body.body).to_string();
    let mut html = stresses(found, body, false);
    if !html.is_empty() {
        html = format!("<h4>Stress in {name}</h4>\n<p class=\"hint\">{STRESS} {}</p>\n{html}", words(&body.error));
    }
    let singular = stresses(found, body, true);
    if !singular.is_empty() {
        html.push_str(&format!("<h4>Not to be trusted</h4>\n<p class=\"hint\">{SINGULAR}</p>\n{singular}"));
    }
    format!("{html}<h4>Reduction of {name}</h4>\n{}{}", facts(body), checks(&body.checks))
}

fn stresses(found: &FlexibleBodies, body: &FlexibleBody, singular: bool) -> String {
    let place = format!("Place in {}", found.length.symbol);
    let mut rows = Rows::new(&[
        "Where",
        " Largest von Mises",
        " Error",
        "Position",
        " Largest principal",
        " Margin against yield",
        " Amplitude",
        " Damage of a repeat",
        " Life in repeats",
        place.as_str(),
    ]);
    let wanted = body.spots.iter().filter(|spot| spot.singular.is_some() == singular);
    wanted.for_each(|spot| rows.push(&cells(found, spot)));
    rows.html()
}

fn cells(found: &FlexibleBodies, spot: &SpotHistory) -> [String; 10] {
    let stress = |si: f64, digits: usize| words(&about(si, &found.unit, digits));
    let none = || "–".to_owned();
    let region = spot.singular.map_or_else(|| spot.region.clone(), |why| format!("{}, {why}", spot.region));
    let at = spot.at.map(|x| number::significant(found.length.show(if x.abs() < 1e-12 { 0.0 } else { x }), 4));
    [
        words(&region),
        stress(spot.value, 4),
        spot.error.map_or_else(none, |error| {
            format!("{} ({} %)", stress(error, 2), digits(100.0 * spot.relative_error().unwrap_or(f64::NAN), 2))
        }),
        words(&spot.place),
        stress(spot.principal[0], 4),
        spot.margin.map_or_else(none, |margin| digits(margin, 3)),
        spot.fatigue.map_or_else(none, |of| stress(of.amplitude, 3)),
        spot.fatigue.map_or_else(none, |of| digits(of.damage, 2)),
        spot.fatigue.map_or_else(none, |of| of.life.map_or_else(|| "no end".to_owned(), |life| digits(life, 2))),
        number::typeset_places(&at.join(", ")),
    ]
}

/// What stands for the body.
fn facts(body: &FlexibleBody) -> String {
    let mut rows = Rows::new(&["What", "Value"]);
    let mut push = |what: &str, value: String| {
        if !value.is_empty() {
            rows.push(&[what.to_owned(), value]);
        }
    };
    push("Solid", Escaped(&body.solid).to_string());
    push("Material", Escaped(&body.material).to_string());
    push(
        "Interfaces, the first carries the floating frame",
        body.interfaces.iter().map(|name| code(name)).collect::<Vec<_>>().join(", "),
    );
    push("Couplings", Escaped(&body.coupling).to_string());
    push("Elastic coordinates", body.coordinates.to_string());
    push("Modes with all interfaces held, in Hz", modes(body));
    push("Damping ratio of the modes", damping(body));
    push("Tension stiffens", if body.stiffening { "yes" } else { "no" }.to_owned());
    if let Some(mesh) = &body.mesh {
        let text = format!("{} nodes, {} elements {}", mesh.nodes, mesh.elements, Escaped(&mesh.element));
        push("Mesh", format!("{text}, worst scaled Jacobian {}", digits(mesh.worst_jacobian, 3)));
    }
    push("Mass as reduced, of the solid", format!("{} kg, {} kg", digits(body.mass[0], 6), digits(body.mass[1], 6)));
    push("Taken from the cache", if body.cached { "yes" } else { "no" }.to_owned());
    if let Some(of) = &body.deformation {
        let share = format!(
            "{} of its size, linear theory doubtful above {}",
            number::percent(of.share),
            number::percent(of.limit)
        );
        push(
            "Largest deformation",
            format!("{share}; interfaces turn by up to {} deg", digits(of.turn.to_degrees(), 3)),
        );
    }
    rows.html()
}

fn modes(body: &FlexibleBody) -> String {
    body.modes.iter().map(|mode| digits(mode.frequency, 5)).collect::<Vec<_>>().join(", ")
}

/// One number where all modes have the same.
fn damping(body: &FlexibleBody) -> String {
    let Some(first) = body.modes.first() else { return String::new() };
    if body.modes.iter().all(|mode| mode.damping == first.damping) {
        return digits(first.damping, 3);
    }
    body.modes.iter().map(|mode| digits(mode.damping, 3)).collect::<Vec<_>>().join(", ")
}

fn checks(all: &[ReductionCheck]) -> String {
    let mut rows = Rows::new(&["Check", " Value", " Limit", ""]);
    for check in all {
        let word = match check.passed() {
            Some(true) => "<span class=\"pass\">pass</span>",
            Some(false) => "<span class=\"fail\">FAIL</span>",
            None => "",
        };
        let limit = check.limit.map_or_else(String::new, |limit| digits(limit, 2));
        rows.push(&[words(&check.meaning), digits(check.value, 2), limit, word.to_owned()]);
    }
    rows.html()
}
