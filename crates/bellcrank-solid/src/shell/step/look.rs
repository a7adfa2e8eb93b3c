//! Colours of parts.

use super::StepPart;
use super::assembly::Product;
use super::text::{Context, File, Id, list, real};

/// Gives parts their colours.
pub(super) fn colors(file: &mut File, context: &Context, parts: &[StepPart], products: &[Product]) {
    let mut styled = Vec::new();
    for (part, product) in parts.iter().zip(products) {
        if let (Some(color), Some(solid)) = (part.color, product.solid) {
            styled.push(style(file, color, solid));
        }
    }
    if !styled.is_empty() {
        let (items, geometry) = (list(&styled), context.geometry);
        file.add(&format!("MECHANICAL_DESIGN_GEOMETRIC_PRESENTATION_REPRESENTATION('',{items},{geometry})"));
    }
}

fn style(file: &mut File, color: [f64; 3], solid: Id) -> Id {
    let [r, g, b] = color.map(real);
    let color = file.add(&format!("COLOUR_RGB('',{r},{g},{b})"));
    let fill = file.add(&format!("FILL_AREA_STYLE_COLOUR('',{color})"));
    let area = file.add(&format!("FILL_AREA_STYLE('',({fill}))"));
    let area = file.add(&format!("SURFACE_STYLE_FILL_AREA({area})"));
    let side = file.add(&format!("SURFACE_SIDE_STYLE('',({area}))"));
    let usage = file.add(&format!("SURFACE_STYLE_USAGE(.BOTH.,{side})"));
    let assignment = file.add(&format!("PRESENTATION_STYLE_ASSIGNMENT(({usage}))"));
    file.add(&format!("STYLED_ITEM('color',({assignment}),{solid})"))
}
