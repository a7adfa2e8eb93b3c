//! A solved mesh in files of other programs.

use std::fmt::Write;

use bellcrank_fem::{
    Coupling, CouplingKind, Material, Part, Region, Solution, Stress, Support, nodal_forces, von_mises,
};
use bellcrank_mesh::{Mesh, VtuField, write_inp, write_msh, write_vtu};
use bellcrank_results::Attachment;

use super::vector::{V3, cross, norm, sub};
use crate::MeshFormats;

/// Forces below this share of the largest are rounding.
const NOTHING: f64 = 1e-11;

/// What is written of a body; a solution where there is one.
pub(super) struct Written<'a> {
    pub(super) name: &'a str,
    pub(super) part: &'a Part<'a>,
    pub(super) solution: &'a Solution,
    pub(super) stress: &'a Stress,
}

impl Written<'_> {
    pub(super) fn files(&self, formats: MeshFormats) -> Vec<Attachment> {
        let file = |ending: &str, bytes: Vec<u8>| Attachment { name: format!("{}.{ending}", self.name), bytes };
        let mut files = Vec::new();
        files.extend(formats.vtu.then(|| file("vtu", self.vtu())));
        files.extend(formats.inp.then(|| file("inp", self.deck().into_bytes())));
        files.extend(formats.msh.then(|| file("msh", write_msh(self.part.mesh).into_bytes())));
        files
    }

    fn vtu(&self) -> Vec<u8> {
        let flat = |vectors: &[V3]| -> Vec<f64> { vectors.iter().flatten().copied().collect() };
        let displacement = flat(&self.solution.displacement);
        // VTK's order is xx, yy, zz, xy, yz, xz: that of the solver.
        let stress: Vec<f64> = self.stress.nodal.iter().flatten().copied().collect();
        let mises: Vec<f64> = self.stress.nodal.iter().map(von_mises).collect();
        let field = |name, components, values| VtuField { name, components, values };
        let at_nodes = [
            field("displacement [m]", 3, &displacement),
            field("stress [Pa]", 6, &stress),
            field("von Mises stress [Pa]", 1, &mises),
            field("estimated error of the stress [Pa]", 1, &self.stress.spread),
        ];
        write_vtu(self.part.mesh, &at_nodes, &[])
    }

    /// A whole input file of CalculiX: mesh, material, what holds it, forces at nodes. Frames of couplings have no nodes
    /// there: what they do to the mesh is written instead, so that the solution is the same.
    fn deck(&self) -> String {
        let mut text = String::new();
        line(&mut text, format_args!("** {}: SI units, axes of the body", self.name));
        write_inp(self.part.mesh, &mut text);
        if let Some(material) = self.part.materials.first() {
            written_material(&mut text, material);
        }
        line(&mut text, format_args!("*SOLID SECTION, ELSET=Eall, MATERIAL=material"));
        line(&mut text, format_args!("*NSET, NSET=Nall, GENERATE\n1, {}", self.part.mesh.nodes.len()));
        let held = self.held();
        if self.solution.temperature.is_some() {
            line(&mut text, format_args!("*INITIAL CONDITIONS, TYPE=TEMPERATURE\nNall, 0."));
        }
        line(&mut text, format_args!("*STEP\n*STATIC"));
        line(&mut text, format_args!("*BOUNDARY"));
        for &(node, component) in &held {
            let value = self.solution.displacement[node as usize][component];
            line(&mut text, format_args!("{}, {}, {}, {}", node + 1, component + 1, component + 1, short(value)));
        }
        self.forces(&mut text, &held);
        if let Some(temperature) = &self.solution.temperature {
            line(&mut text, format_args!("*TEMPERATURE"));
            for (node, rise) in temperature.iter().enumerate() {
                line(&mut text, format_args!("{}, {}", node + 1, short(*rise)));
            }
        }
        line(&mut text, format_args!("*NODE FILE\nU\n*EL FILE\nS\n*NODE PRINT, NSET=Nall\nU"));
        line(&mut text, format_args!("*EL PRINT, ELSET=Eall\nS\n*END STEP"));
        text
    }

    /// Components of nodes that are prescribed, ascending.
    fn held(&self) -> Vec<(u32, usize)> {
        let mut held = Vec::new();
        for support in &self.part.supports {
            if let Support::Fixed { nodes, values, .. } = support {
                let components = (0..3).filter(|&i| values[i].is_some());
                held.extend(components.flat_map(|i| nodes.iter().map(move |&node| (node, i))));
            }
        }
        for coupling in self.part.couplings.iter().filter(|coupling| coupling.kind == CouplingKind::Rigid) {
            held.extend(nodes_of(self.part.mesh, coupling).into_iter().flat_map(|node| (0..3).map(move |i| (node, i))));
        }
        // What else holds it (springs, frames, inertia) is among the forces; three nodes say where it is.
        let elsewhere = |coupling: &Coupling| coupling.kind == CouplingKind::Distributing && coupling.held != [None; 6];
        let springs = self.part.supports.iter().any(|support| matches!(support, Support::Spring { .. }));
        if self.solution.relief.is_some() || springs || self.part.couplings.iter().any(elsewhere) {
            let three = far_apart(&self.part.mesh.nodes);
            held.extend(three.into_iter().flat_map(|node| (0..3).map(move |i| (node, i))));
        }
        held.sort_unstable();
        held.dedup();
        held
    }

    fn forces(&self, text: &mut String, held: &[(u32, usize)]) {
        let forces = nodal_forces(self.part, self.solution);
        let largest = forces.iter().flatten().fold(0.0_f64, |most, f| most.max(f.abs()));
        let mut any = false;
        for (node, force) in (0_u32..).zip(&forces) {
            for (component, value) in force.iter().enumerate() {
                if value.abs() <= NOTHING * largest || held.binary_search(&(node, component)).is_ok() {
                    continue;
                }
                if !any {
                    line(text, format_args!("*CLOAD"));
                    any = true;
                }
                line(text, format_args!("{}, {}, {}", node + 1, component + 1, short(*value)));
            }
        }
    }
}

fn nodes_of(mesh: &Mesh, coupling: &Coupling) -> Vec<u32> {
    match &coupling.region {
        Region::Faces(faces) => mesh.nodes_of_faces(faces),
        Region::Nodes(nodes) => nodes.clone(),
    }
}

/// Three nodes that are not on one line: the first, the one farthest from it, the one farthest from their line.
fn far_apart(nodes: &[V3]) -> Vec<u32> {
    let farthest = |measure: &dyn Fn(V3) -> f64| {
        let all = nodes.iter().zip(0_u32..);
        all.max_by(|a, b| measure(*a.0).total_cmp(&measure(*b.0))).map(|(at, node)| (*at, node))
    };
    let Some(&first) = nodes.first() else { return Vec::new() };
    let Some((second, b)) = farthest(&|at| norm(sub(at, first))) else { return Vec::new() };
    let third = farthest(&|at| norm(cross(sub(at, first), sub(second, first))));
    std::iter::once(0).chain([b]).chain(third.map(|(_, node)| node)).collect()
}

/// As C3D elements take it: 21 constants, by rows of the upper triangle in the order 11, 22, 33, 12, 13, 23.
fn written_material(text: &mut String, material: &Material) {
    // Their places among xx, yy, zz, xy, yz, zx.
    const ORDER: [usize; 6] = [0, 1, 2, 3, 5, 4];
    line(text, format_args!("*MATERIAL, NAME=material\n*ELASTIC, TYPE=ANISO"));
    let mut constants = Vec::new();
    for (last, &column) in ORDER.iter().enumerate() {
        constants.extend(ORDER[..=last].iter().map(|&row| short(material.stiffness[row][column])));
    }
    for chunk in constants.chunks(8) {
        line(text, format_args!("{}", chunk.join(", ")));
    }
    line(text, format_args!("*DENSITY\n{}", short(material.density)));
    if material.expansion != [0.0; 3] {
        let [x, y, z] = material.expansion.map(short);
        line(text, format_args!("*EXPANSION, TYPE=ORTHO, ZERO=0.\n{x}, {y}, {z}"));
    }
}

fn line(text: &mut String, what: std::fmt::Arguments<'_>) {
    // Writing to a string does not fail.
    let _ = text.write_fmt(what);
    text.push('\n');
}

/// At most 20 characters, which is what CalculiX reads; always with a point or an exponent.
fn short(value: f64) -> String {
    let text = format!("{value:e}");
    if text.len() <= 20 { text } else { format!("{value:.12e}") }
}

/// The shapes of natural modes, or what is left of it for a mesh alone.
pub(super) fn of_modes(
    name: &str,
    mesh: &Mesh,
    modes: &[(f64, &[V3])],
    formats: MeshFormats,
    deck: impl FnOnce() -> String,
) -> Vec<Attachment> {
    let file = |ending: &str, bytes: Vec<u8>| Attachment { name: format!("{name}.{ending}"), bytes };
    let mut files = Vec::new();
    if formats.vtu {
        let numbered = modes.iter().enumerate();
        let flat: Vec<(String, Vec<f64>)> = numbered
            .map(|(index, (frequency, shape))| {
                let name = format!("mode {}, {frequency:.2} Hz", index + 1);
                (name, shape.iter().flatten().copied().collect())
            })
            .collect();
        let fields: Vec<VtuField<'_>> =
            flat.iter().map(|(name, values)| VtuField { name, components: 3, values }).collect();
        files.push(file("vtu", write_vtu(mesh, &fields, &[])));
    }
    files.extend(formats.inp.then(|| file("inp", deck().into_bytes())));
    files.extend(formats.msh.then(|| file("msh", write_msh(mesh).into_bytes())));
    files
}

/// A whole input file of CalculiX that finds the modes.
pub(super) fn modes_deck(name: &str, part: &Part<'_>, count: usize) -> String {
    let mut text = String::new();
    line(&mut text, format_args!("** {name}: SI units, axes of the body"));
    write_inp(part.mesh, &mut text);
    if let Some(material) = part.materials.first() {
        written_material(&mut text, material);
    }
    line(&mut text, format_args!("*SOLID SECTION, ELSET=Eall, MATERIAL=material"));
    line(&mut text, format_args!("*STEP\n*FREQUENCY\n{count}"));
    for support in &part.supports {
        if let Support::Fixed { nodes, .. } = support {
            line(&mut text, format_args!("*BOUNDARY"));
            nodes.iter().for_each(|node| line(&mut text, format_args!("{}, 1, 3", node + 1)));
        }
    }
    line(&mut text, format_args!("*NODE FILE\nU\n*END STEP"));
    text
}

#[cfg(test)]
mod tests;
