//! Products: parts, and an assembly of them at their places.

use super::text::{Context, File, Id, list, text};
use super::{Placement, StepPart, brep};

/// Entities of a product that others refer to.
pub(super) struct Product {
    definition: Id,
    representation: Id,
    /// Axes of the representation.
    axes: Id,
    /// The solid; none for an assembly.
    pub(super) solid: Option<Id>,
}

/// Writes a part.
pub(super) fn part(file: &mut File, context: &Context, part: &StepPart) -> Product {
    let solid = brep::solid(file, &part.name, &part.shell);
    let axes = origin(file);
    let geometry = context.geometry;
    let name = text(&part.name);
    let representation = file.add(&format!("ADVANCED_BREP_SHAPE_REPRESENTATION({name},({axes},{solid}),{geometry})"));
    let definition = product(file, context, &part.name, representation);
    if let Some(name) = &part.material {
        material(file, context, definition, name);
    }
    Product { definition, representation, axes, solid: Some(solid) }
}

/// Writes the assembly of parts at their places.
pub(super) fn assembly(file: &mut File, context: &Context, name: &str, parts: &[StepPart], products: &[Product]) {
    let axes = origin(file);
    let places: Vec<Vec<Id>> =
        parts.iter().map(|part| part.instances.iter().map(|p| placed(file, p)).collect()).collect();
    let items: Vec<Id> = [axes].into_iter().chain(places.iter().flatten().copied()).collect();
    let representation =
        file.add(&format!("SHAPE_REPRESENTATION({},{},{})", text(name), list(&items), context.geometry));
    let definition = product(file, context, name, representation);
    let whole = Product { definition, representation, axes, solid: None };
    let mut count = 0;
    for ((part, product), places) in parts.iter().zip(products).zip(&places) {
        for place in places {
            count += 1;
            occurrence(file, &format!("{count}"), &part.name, [&whole, product], *place);
        }
    }
}

/// One part at one place of the assembly.
fn occurrence(file: &mut File, id: &str, name: &str, [whole, part]: [&Product; 2], place: Id) {
    let (outer, inner) = (whole.definition, part.definition);
    let name = text(name);
    let usage = file.add(&format!("NEXT_ASSEMBLY_USAGE_OCCURRENCE('{id}',{name},'',{outer},{inner},$)"));
    let shape = file.add(&format!("PRODUCT_DEFINITION_SHAPE('Placement','Placement of an item',{usage})"));
    let transformation = file.add(&format!("ITEM_DEFINED_TRANSFORMATION('','',{},{place})", part.axes));
    let relation = file.add(&format!(
        "(REPRESENTATION_RELATIONSHIP('','',{},{})REPRESENTATION_RELATIONSHIP_WITH_TRANSFORMATION({transformation})\
         SHAPE_REPRESENTATION_RELATIONSHIP())",
        part.representation, whole.representation
    ));
    file.add(&format!("CONTEXT_DEPENDENT_SHAPE_REPRESENTATION({relation},{shape})"));
}

/// A product with its one definition, and the shape of it.
fn product(file: &mut File, context: &Context, name: &str, representation: Id) -> Id {
    let application = context.application;
    let name = text(name);
    let mechanical = file.add(&format!("PRODUCT_CONTEXT('',{application},'mechanical')"));
    let product = file.add(&format!("PRODUCT({name},{name},'',({mechanical}))"));
    file.add(&format!("PRODUCT_RELATED_PRODUCT_CATEGORY('part',$,({product}))"));
    let formation = file.add(&format!("PRODUCT_DEFINITION_FORMATION('','',{product})"));
    let design = file.add(&format!("PRODUCT_DEFINITION_CONTEXT('part definition',{application},'design')"));
    let definition = file.add(&format!("PRODUCT_DEFINITION('design','',{formation},{design})"));
    let shape = file.add(&format!("PRODUCT_DEFINITION_SHAPE('','',{definition})"));
    file.add(&format!("SHAPE_DEFINITION_REPRESENTATION({shape},{representation})"));
    definition
}

fn material(file: &mut File, context: &Context, definition: Id, name: &str) {
    let property = file.add(&format!("PROPERTY_DEFINITION('material property','material name',{definition})"));
    let name = text(name);
    let item = file.add(&format!("DESCRIPTIVE_REPRESENTATION_ITEM({name},{name})"));
    let representation = file.add(&format!("REPRESENTATION('material name',({item}),{})", context.geometry));
    file.add(&format!("PROPERTY_DEFINITION_REPRESENTATION({property},{representation})"));
}

fn origin(file: &mut File) -> Id {
    placed(file, &Placement::IDENTITY)
}

fn placed(file: &mut File, place: &Placement) -> Id {
    let column = |k: usize| place.rotation.map(|row| row[k]);
    file.axes(place.translation, column(2), column(0))
}
