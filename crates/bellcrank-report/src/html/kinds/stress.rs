//! Hot spots of bodies, the meshes they were found on, and natural frequencies.

use bellcrank_results::{BodyModes, HotSpot, Stress, StressBody};

use super::super::Escaped;
use super::super::rows::{Rows, digits, words};
use crate::number;
use crate::told::{self, about};

pub(super) fn section(found: &Stress) -> String {
    found.bodies.iter().map(|body| of_body(found, body)).collect()
}

fn of_body(found: &Stress, body: &StressBody) -> String {
    let length = &found.length.symbol;
    let place = format!("Place in {length}");
    let heads =
        ["Where", " von Mises", " Error", " Largest principal", " Margin against yield", place.as_str(), "Position"];
    let (mut sure, mut singular) = (Rows::new(&heads), Rows::new(&heads));
    for spot in &body.spots {
        if spot.singular.is_some() { &mut singular } else { &mut sure }.push(&cells(found, body, spot));
    }
    let name = Escaped(&body.body).to_string();
    let mut html = format!("<h3>Hot spots of {name}</h3>\n<p class=\"hint\">{LEGEND}</p>\n{}", sure.html());
    let rest = singular.html();
    if !rest.is_empty() {
        html.push_str(&format!("<h4>Not to be trusted</h4>\n<p class=\"hint\">{SINGULAR}</p>\n{rest}"));
    }
    html.push_str(&format!("<h4>Meshes</h4>\n{}", meshes(found, body)));
    html
}

const LEGEND: &str = "The largest von Mises stress of each region on the smoothed field. Its error is the larger of what \
    the last mesh says and of the change from the mesh before. The margin is the yield strength over the stress, less one.";
const SINGULAR: &str = "At a sharp re-entrant edge, and where nodes are held, the stress of an elastic body has no bound: \
    these numbers grow with every finer mesh. A radius makes them real.";

fn cells(found: &Stress, body: &StressBody, spot: &HotSpot) -> [String; 7] {
    let place = if spot.place.is_empty() { &body.place } else { &spot.place };
    let at = told::stress::place(spot, found);
    let region = match spot.singular {
        Some(why) => format!("{}, {why}", spot.region),
        None => spot.region.clone(),
    };
    let stress = |si: f64, digits: usize| number::typeset(&about(si, &found.unit, digits));
    [
        words(&region),
        stress(spot.value, 4),
        if spot.singular.is_some() {
            "–".to_owned()
        } else {
            format!("{} ({} %)", stress(spot.error, 2), digits(100.0 * spot.relative_error(), 2))
        },
        stress(spot.principal[0], 4),
        spot.margin.map_or_else(|| "–".to_owned(), |margin| digits(margin, 3)),
        number::typeset_places(&at),
        words(place),
    ]
}

fn meshes(found: &Stress, body: &StressBody) -> String {
    let mut rows =
        Rows::new(&["Mesh", " Nodes", " Elements", "Kind", " Worst scaled Jacobian", " Largest stress", " Error"]);
    for (index, mesh) in body.meshes.iter().enumerate() {
        rows.push(&[
            (index + 1).to_string(),
            mesh.nodes.to_string(),
            mesh.elements.to_string(),
            Escaped(&mesh.element).to_string(),
            digits(mesh.worst_jacobian, 3),
            number::typeset(&about(mesh.peak, &found.unit, 5)),
            if mesh.error.is_finite() { number::percent(mesh.error) } else { "–".to_owned() },
        ]);
    }
    rows.html()
}

pub(super) fn modes(found: &BodyModes) -> String {
    let mut html = String::new();
    for body in &found.bodies {
        let mut rows = Rows::new(&["Mode", " Frequency in Hz"]);
        for (index, frequency) in body.frequencies.iter().enumerate() {
            rows.push(&[(index + 1).to_string(), digits(*frequency, 6)]);
        }
        html.push_str(&format!("<h3>Natural frequencies of {}</h3>\n{}", Escaped(&body.body), rows.html()));
    }
    html
}
