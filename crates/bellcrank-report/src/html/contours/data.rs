//! Surfaces, shapes and fields as the page holds them.
//!
//! One JSON block tells what there is; the numbers of each contour follow as one block of packed integers: places in
//! millionths of the box around the part, displacements and values in 16 bits of their range.

use bellcrank_results::{Contour, ContourField, ContourShape, RunResult};
use serde_json::{Value, json};

use crate::PictureFile;
use crate::html::data::{Integers, encoded};
use crate::picture::{
    ABOVE, DIVERGING, NONE, SEQUENTIAL, Scale, TILT, bounds, contours, fields, nearest, outline, plan, usual_scale,
};

/// Steps across the box around a part.
const PLACES: f32 = 1_048_575.0;
/// Steps of a displacement to either side.
const MOVES: f32 = 32_767.0;
/// Steps of a value; the one above stands for none.
const VALUES: f64 = 65_534.0;
const NO_VALUE: u32 = 65_535;

/// Turbo (Mikhailov, Apache-2.0): the rainbow that engineers know, smoothed; not for colour-blind readers.
const RAINBOW: [u32; 33] = [
    0x30_12_3b, 0x39_2a_73, 0x40_40_a2, 0x44_56_c7, 0x46_6b_e3, 0x46_80_f6, 0x42_94_ff, 0x37_a8_fa, 0x28_bc_eb,
    0x1c_cd_d8, 0x18_dd_c2, 0x1f_e9_af, 0x32_f2_98, 0x4e_f9_7d, 0x6d_fe_62, 0x8b_ff_4b, 0xa4_fc_3c, 0xb9_f6_35,
    0xcd_ec_34, 0xdf_df_37, 0xee_cf_3a, 0xf8_be_39, 0xfd_ac_34, 0xfe_96_2b, 0xfb_7e_21, 0xf4_66_17, 0xeb_50_0e,
    0xdf_3f_08, 0xd0_2f_05, 0xbe_21_02, 0xa9_16_01, 0x92_0b_01, 0x7a_04_03,
];

/// Bytes of a contour, before they are packed, that a page takes: some 1.5 million triangles of one shape, or
/// 200,000 in seventy modes.
const MOST_BYTES: usize = 64 << 20;

/// Whether the page holds the numbers of a contour; else the still picture is all.
pub(super) fn is_light(contour: &Contour) -> bool {
    let of_shape = |shape: &ContourShape| 6 + 2 * shape.fields.len().max(1);
    let of_node = 13 + contour.shapes.iter().map(of_shape).sum::<usize>();
    12 * contour.triangles.len() + 8 * contour.edges.len() + of_node * contour.nodes.len() < MOST_BYTES
}

/// Appends the numbers behind every picture.
pub(crate) fn push(page: &mut String, run: &RunResult, pictures: &[Vec<Option<PictureFile>>]) {
    let mut described = Vec::new();
    let mut blocks = String::new();
    for (study, (of, pictures)) in run.studies.iter().zip(pictures).enumerate() {
        let all = contours(of);
        let drawn = all.iter().map(AsRef::as_ref).zip(pictures).enumerate();
        for (index, (contour, _)) in drawn.filter(|(_, (contour, picture))| picture.is_some() && is_light(contour)) {
            let mut numbers = Integers::default();
            let key = super::key(study, index);
            described.push(part(contour, &key, &mut numbers));
            let text = encoded(&numbers.packed());
            blocks.push_str(&format!("<script type=\"text/plain\" id=\"bellcrank-contour-{key}\">"));
            blocks.push_str(&String::from_utf8_lossy(&text));
            blocks.push_str("</script>\n");
        }
    }
    let data = json!({ "colours": colours(), "tilt": [TILT.0, TILT.1], "contours": described });
    page.push_str("<script type=\"application/json\" id=\"bellcrank-contours\">");
    page.push_str(&data.to_string().replace('<', "\\u003c"));
    page.push_str("</script>\n");
    page.push_str(&blocks);
}

/// The colours of all pictures, from low to high.
pub(crate) fn colours() -> Value {
    json!({ "even": SEQUENTIAL[..], "signed": DIVERGING[..], "rainbow": RAINBOW[..], "above": ABOVE, "none": NONE })
}

fn part(contour: &Contour, key: &str, numbers: &mut Integers) -> Value {
    let sharp = outline(contour);
    let (low, high) = bounds(contour.nodes.iter().copied()).unwrap_or_default();
    push_places(&contour.nodes, low, high, numbers);
    numbers.push(4, contour.triangles.iter().flatten().copied());
    let edges = distinct(&contour.edges);
    numbers.push(4, edges.iter().flatten().copied());
    numbers.push(4, sharp.iter().flatten().copied());
    let numbered = contour.numbers.len() == contour.nodes.len();
    if numbered {
        numbers.push(4, contour.numbers.iter().copied());
    }
    let shapes: Vec<Value> = contour.shapes.iter().map(|of| shape(contour, of, numbers)).collect();
    let at: Vec<[f32; 3]> = contour.marks.iter().map(|mark| mark.at).collect();
    let mark = |(mark, node): (&bellcrank_results::ContourMark, usize)| json!({ "label": mark.label, "node": node, "doubtful": mark.doubtful });
    json!({
        "key": key,
        "title": contour.title,
        "nodes": contour.nodes.len(),
        "triangles": contour.triangles.len(),
        "edges": edges.len(),
        "outline": sharp.len(),
        "numbered": numbered,
        "low": low,
        "high": high,
        "axes": plan(contour),
        "shapes": shapes,
        "marks": contour.marks.iter().zip(nearest(contour, &at)).map(mark).collect::<Vec<_>>(),
    })
}

/// Each edge once, in an order that packs well.
pub(crate) fn distinct(edges: &[[u32; 2]]) -> Vec<[u32; 2]> {
    let mut once: Vec<[u32; 2]> = edges.iter().map(|[a, b]| [*a.min(b), *a.max(b)]).collect();
    once.sort_unstable();
    once.dedup();
    once
}

pub(crate) fn push_places(nodes: &[[f32; 3]], low: [f32; 3], high: [f32; 3], numbers: &mut Integers) {
    for k in 0..3 {
        let per = PLACES / (high[k] - low[k]).max(f32::MIN_POSITIVE);
        numbers.push(3, nodes.iter().map(|p| ((p[k] - low[k]) * per).round() as u32));
    }
}

fn shape(contour: &Contour, shape: &ContourShape, numbers: &mut Integers) -> Value {
    let of = |node: usize, k: usize| {
        let x = shape.displacement.get(node).map_or(0.0, |u| u[k]);
        if x.is_finite() { x } else { 0.0 }
    };
    let nodes = 0..contour.nodes.len();
    let most = nodes.clone().flat_map(|node| [0, 1, 2].map(|k| of(node, k).abs())).fold(0.0, f32::max);
    let per = if most > 0.0 { MOVES / most } else { 0.0 };
    for k in 0..3 {
        numbers.push(2, nodes.clone().map(|node| ((of(node, k) * per).round() + MOVES) as u32));
    }
    let fields: Vec<Value> = fields(contour, shape).iter().filter_map(|of| field(contour, of, numbers)).collect();
    json!({
        "name": shape.name,
        "swings": shape.swings,
        "most": most,
        "usual": usual_scale(contour, shape),
        "fields": fields,
    })
}

/// Nothing for a field without a number.
fn field(contour: &Contour, field: &ContourField, numbers: &mut Integers) -> Option<Value> {
    let scale = Scale::of(&[field])?;
    let value = |node: usize| field.unit.show(f64::from(field.values.get(node).copied().unwrap_or(f32::NAN)));
    let per = VALUES / (scale.most - scale.least).max(f64::MIN_POSITIVE);
    let step = |shown: f64| if shown.is_finite() { ((shown - scale.least) * per).round() as u32 } else { NO_VALUE };
    let nodes = 0..contour.nodes.len();
    numbers.push(2, nodes.clone().map(|node| step(value(node))));
    let least = nodes.clone().filter(|node| value(*node).is_finite()).min_by(|a, b| value(*a).total_cmp(&value(*b)));
    let most = nodes.filter(|node| value(*node).is_finite()).max_by(|a, b| value(*a).total_cmp(&value(*b)));
    let mut described = self::scale(&scale);
    described["leastAt"] = json!(least);
    described["mostAt"] = json!(most);
    Some(described)
}

/// What the colours of a field mean.
pub(crate) fn scale(scale: &Scale) -> Value {
    json!({
        "name": scale.name,
        "unit": scale.unit.symbol,
        "low": scale.low,
        "high": scale.high,
        "step": scale.step,
        "least": scale.least,
        "most": scale.most,
        "signed": scale.signed,
        "cut": scale.is_cut(),
        "marks": scale.marks,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_too_much_for_a_page_stays_a_picture() {
        let of = |triangles: usize| Contour { triangles: vec![[0, 1, 2]; triangles], ..Contour::default() };
        assert!(is_light(&of(100_000)) && !is_light(&of(6_000_000)));
    }

    #[test]
    fn edges_are_kept_once() {
        assert_eq!(distinct(&[[4, 1], [0, 2], [1, 4], [2, 0]]), [[0, 2], [1, 4]]);
    }
}
