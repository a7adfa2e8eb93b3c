//! From a stack of layers to a mesh of wedges or tetrahedra.
//!
//! One triangulation of the plane serves every height: the edges of the arrangement are divided by a size field, the
//! plane between them is filled by constrained Delaunay insertion and smoothing, and every triangle is extruded
//! through the layers that its cell is filled in. Layers are the same everywhere, so the mesh conforms.

mod curving;
mod estimate;
mod extrude;
mod field;
mod heights;
mod outline;
mod plan;
mod plane;
mod revolve;
mod sets;
mod size_map;
mod sizes;
mod smoothing;
mod walls;

use bellcrank_solid::Stack;

use crate::{Mesh, Shape};

pub use revolve::mesh_revolved;
pub use size_map::SizeMap;
pub use sizes::{Division, MesherError, Sizes};

/// Meshes a stack.
///
/// `names` are the names of the eyes, by their place in [`bellcrank_solid::Link::eyes`]; the bore of the eye NAME gives
/// the node set and the face set `bore.NAME`. The face sets `surface`, `top` and `bottom` hold all outer faces, and
/// those at the highest and the lowest level; the node set `sharp` (only where there is any) the nodes of re-entrant
/// sharp edges. Nodes of bores and of other arcs lie on their circle, except that mid-side nodes of arcs
/// other than bores move toward the chord where two edges meet in a cusp.
///
/// # Errors
///
/// When a size is not positive, when the mesh would have more nodes than `sizes.most_nodes` (told before it is made),
/// or when the edges of the stack cross each other.
pub fn mesh_stack(stack: &Stack<f64>, names: &[&str], shape: Shape, sizes: &Sizes) -> Result<Mesh, MesherError> {
    sizes::check(sizes, shape)?;
    let plan = plan::Plan::of(stack)?;
    let walls = walls::measure(&plan);
    let coarse = sizes.scale * sizes.size.unwrap_or_else(|| walls::default_size(&plan, &walls));
    let field = field::of_plan(&plan, &walls, coarse, sizes);
    let levels = heights::levels(&plan, coarse, sizes);
    estimate::check_outline(&plan, &field, sizes.most_nodes)?;
    let outline = outline::divide(&plan, &field)?;
    estimate::check(&plan, &outline, &field, &levels, shape, sizes.most_nodes)?;
    let plane = plane::triangulate(&plan, &outline, &field)?;
    let curves = curving::mid_sides(&plan, &plane, &levels);
    let (mut mesh, origin) = extrude::extrude(&plan, &plane, &curves, &levels, shape);
    sets::name(&mut mesh, &origin, &plan, &plane, &levels, names);
    Ok(mesh)
}

#[cfg(test)]
mod tests;
