//! The solid parts of a drawing as JSON.

use bellcrank_results::{Animation, Drawing, Paint, Shape, Solid, solids};
use serde_json::{Value, json};

/// The parts for the solid drawing.
pub(crate) fn described(drawing: &Drawing, animation: &Animation) -> Vec<Value> {
    solids(drawing, animation).iter().map(part).collect()
}

fn part(solid: &Solid) -> Value {
    let [r, g, b] = solid.paint.colour(solid.body).map(u32::from);
    json!({
        "body": solid.body,
        "colour": r << 16 | g << 8 | b,
        "metal": solid.paint == Paint::Steel,
        "shape": shape(&solid.shape),
    })
}

fn shape(shape: &Shape) -> Value {
    match shape {
        Shape::Rod { from, to, radius, round } => {
            json!({ "rod": [short(from), short(to)], "radius": five(*radius), "round": round })
        }
        Shape::Ball { center, radius } => json!({ "ball": short(center), "radius": five(*radius) }),
        Shape::Block { center, along, across, size } => {
            json!({ "block": short(center), "along": along, "across": across, "size": short(size) })
        }
        Shape::Plate { points, normal, radius, thickness } => json!({
            "plate": points.iter().map(short).collect::<Vec<_>>(),
            "normal": normal,
            "radius": five(*radius),
            "thickness": five(*thickness),
        }),
        Shape::Surface(surface) => json!({
            "surface": surface.points.iter().flatten().copied().map(five).collect::<Vec<_>>(),
            "triangles": surface.triangles.as_flattened(),
        }),
    }
}

fn short(place: &[f64; 3]) -> [f64; 3] {
    place.map(five)
}

/// Five digits: a picture shows no more, and the page stays small.
fn five(x: f64) -> f64 {
    format!("{x:.4e}").parse().unwrap_or(x)
}

#[cfg(test)]
mod tests {
    use super::five;

    #[test]
    fn five_digits_are_kept() {
        assert_eq!((five(0.123_456_789), five(-1234.56), five(0.0)), (0.123_46, -1234.6, 0.0));
    }
}
