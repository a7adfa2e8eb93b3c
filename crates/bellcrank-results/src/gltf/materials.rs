//! Colours of parts as physically based materials.

use serde_json::{Value, json};

use crate::{Drawing, Paint, Solid};

/// Materials used so far: paint, and the body where the paint is that of a body.
#[derive(Default)]
pub(super) struct Materials {
    used: Vec<(Paint, usize)>,
}

impl Materials {
    /// The material of a part.
    pub(super) fn of(&mut self, part: &Solid) -> usize {
        let key = (part.paint, if part.paint == Paint::Body { part.body } else { 0 });
        let known = self.used.iter().position(|other| *other == key);
        known.unwrap_or_else(|| {
            self.used.push(key);
            self.used.len() - 1
        })
    }

    pub(super) fn list(&self, drawing: &Drawing) -> Vec<Value> {
        self.used.iter().map(|(paint, body)| material(drawing, *paint, *body)).collect()
    }
}

fn material(drawing: &Drawing, paint: Paint, body: usize) -> Value {
    let name = match paint {
        Paint::Body => drawing.bodies.get(body).map_or("", |body| &body.name),
        Paint::Steel => "steel",
        Paint::Drive => "drive",
        Paint::Ground => "ground",
    };
    let [r, g, b] = paint.colour(body).map(linear);
    let (metallic, roughness) = if paint == Paint::Steel { (0.6, 0.35) } else { (0.1, 0.55) };
    json!({
        "name": name,
        "pbrMetallicRoughness": {
            "baseColorFactor": [r, g, b, 1.0],
            "metallicFactor": metallic,
            "roughnessFactor": roughness,
        },
    })
}

/// sRGB to linear light, IEC 61966-2-1; four digits.
fn linear(byte: u8) -> f64 {
    let c = f64::from(byte) / 255.0;
    let light = if c <= 0.040_45 { c / 12.92 } else { ((c + 0.055) / 1.055).powf(2.4) };
    (light * 1e4).round() / 1e4
}
