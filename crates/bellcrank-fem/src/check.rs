//! What is wrong with a part before anything is solved.

use crate::element::Geometry;
use crate::numbering::nodes_of;
use crate::surface::{self, Spread};
use crate::{CouplingKind, Fault, Load, Part, Region, Support, pieces};

pub(crate) fn part(part: &Part<'_>) -> Vec<Fault> {
    let mut faults = Vec::new();
    if part.mesh.element_count() == 0 {
        faults.push(Fault::NoElements);
    }
    if part.materials.len() != part.mesh.blocks.len() {
        faults.push(Fault::Materials { blocks: part.mesh.blocks.len(), materials: part.materials.len() });
        return faults;
    }
    faults.extend(inverted(part));
    for (index, support) in part.supports.iter().enumerate() {
        let (Support::Fixed { nodes, .. } | Support::Spring { nodes, .. }) = support;
        if nodes.is_empty() {
            faults.push(Fault::EmptySupport(index));
        }
    }
    for (index, coupling) in part.couplings.iter().enumerate() {
        if nodes_of(part, &coupling.region).is_empty() || !has_area(part, &coupling.region) {
            faults.push(Fault::EmptyCoupling(index));
        } else if coupling.kind == CouplingKind::Distributing && !Spread::new(part.mesh, coupling).carries_moments() {
            faults.push(Fault::CouplingOnLine(index));
        }
    }
    if faults.is_empty() {
        faults.extend(pieces::loose(part));
    }
    faults
}

fn has_area(part: &Part<'_>, region: &Region) -> bool {
    match region {
        Region::Faces(faces) => surface::area(part.mesh, faces) > 0.0,
        Region::Nodes(_) => true,
    }
}

pub(crate) fn loads(part: &Part<'_>, loads: &[Load]) -> Vec<Fault> {
    let empty = |load: &Load| match load {
        Load::Pressure { faces, .. } | Load::Traction { faces, .. } | Load::Bearing { faces, .. } => {
            faces.is_empty() || surface::area(part.mesh, faces).is_nan()
        }
        Load::Nodal { nodes, .. } => nodes.is_empty(),
        Load::Frame { coupling, .. } => *coupling >= part.couplings.len(),
        Load::Temperature(nodes) => nodes.len() != part.mesh.nodes.len(),
        Load::Gravity(_) | Load::Motion { .. } => false,
    };
    loads.iter().enumerate().filter(|(_, load)| empty(load)).map(|(index, _)| Fault::EmptyLoad(index)).collect()
}

/// The first ten elements that are turned inside out at an integration point.
fn inverted(part: &Part<'_>) -> Vec<Fault> {
    let mut faults = Vec::new();
    let mut geometry = Geometry::default();
    for (b, block) in part.mesh.blocks.iter().enumerate() {
        for (e, element) in block.elements().enumerate() {
            geometry.set(block.shape, element, &part.mesh.nodes);
            let worst = block.shape.stiffness_points().iter().map(|point| geometry.at(point)).fold(f64::NAN, f64::min);
            if !worst.is_finite() || worst <= 0.0 {
                faults.push(Fault::Inverted { block: b, element: e, determinant: worst });
            }
            if faults.len() == 10 {
                return faults;
            }
        }
    }
    faults
}
