//! A reduction as bytes: a head (magic, version, key), numbers little-endian, a checksum over all of it.

use std::collections::BTreeMap;

use bellcrank_fem::{Effort, Reduction, ReductionChecks, ShapeIntegrals, Shortening};
use bellcrank_mesh::{Block, Face, Mesh, Shape};
use sha2::{Digest, Sha256};

use super::Reduced;
use super::recipe::Key;

const MAGIC: &[u8; 8] = b"bcrkredu";
const VERSION: u64 = 1;
const CHECKSUM: usize = 32;

/// All bytes of the file.
pub(super) fn written(of: &Reduced, key: Key) -> Vec<u8> {
    let mut out = Writer { bytes: Vec::new() };
    out.bytes.extend(MAGIC);
    out.whole(VERSION as usize);
    out.bytes.extend(key.0);
    out.mesh(&of.mesh);
    out.reduction(&of.reduction);
    out.list(&of.stress, |out, column| out.numbers(column.as_flattened()));
    out.list(&of.shortenings, |out, one| {
        out.whole(one.along);
        out.numbers(&one.matrix);
    });
    out.numbers(&of.left_out);
    out.list(&of.notes, |out, note| out.text(note));
    let sum = Sha256::digest(&out.bytes);
    out.bytes.extend(sum);
    out.bytes
}

/// What a file holds, if it is whole and is what its name says.
pub(super) fn read(bytes: &[u8], key: Key) -> Result<Reduced, &'static str> {
    const DAMAGED: &str = "is damaged";
    let end = bytes.len().checked_sub(CHECKSUM).ok_or(DAMAGED)?;
    let (body, sum) = bytes.split_at(end);
    if body.get(..MAGIC.len()) != Some(MAGIC) {
        return Err("is no file of reductions");
    }
    if Sha256::digest(body).as_slice() != sum {
        return Err(DAMAGED);
    }
    let mut input = Input { bytes: &body[MAGIC.len()..] };
    if input.whole() != Some(VERSION as usize) {
        return Err("is of another version");
    }
    if input.take(key.0.len()) != Some(&key.0[..]) {
        return Err("is the reduction of another body");
    }
    // The checksum was right: what does not read now was never written by this version.
    input.reduced().filter(|_| input.bytes.is_empty()).ok_or(DAMAGED)
}

struct Writer {
    bytes: Vec<u8>,
}

impl Writer {
    fn whole(&mut self, value: usize) {
        self.bytes.extend((value as u64).to_le_bytes());
    }

    fn number(&mut self, value: f64) {
        self.bytes.extend(value.to_le_bytes());
    }

    fn text(&mut self, text: &str) {
        self.whole(text.len());
        self.bytes.extend(text.as_bytes());
    }

    fn numbers(&mut self, values: &[f64]) {
        self.whole(values.len());
        values.iter().for_each(|&value| self.number(value));
    }

    fn nodes(&mut self, values: &[u32]) {
        self.whole(values.len());
        values.iter().for_each(|value| self.bytes.extend(value.to_le_bytes()));
    }

    fn list<T>(&mut self, items: &[T], write: impl Fn(&mut Writer, &T)) {
        self.whole(items.len());
        items.iter().for_each(|item| write(self, item));
    }

    fn mesh(&mut self, mesh: &Mesh) {
        self.numbers(mesh.nodes.as_flattened());
        self.list(&mesh.blocks, |out, block| {
            out.text(&block.name);
            out.text(block.shape.abaqus());
            out.nodes(&block.nodes);
        });
        self.whole(mesh.node_sets.len());
        for (name, nodes) in &mesh.node_sets {
            self.text(name);
            self.nodes(nodes);
        }
        self.whole(mesh.face_sets.len());
        for (name, faces) in &mesh.face_sets {
            self.text(name);
            let all: Vec<u32> = faces.iter().flat_map(|face| [face.block, face.element, face.face.into()]).collect();
            self.nodes(&all);
        }
    }

    fn reduction(&mut self, of: &Reduction) {
        self.numbers(of.points.as_flattened());
        self.whole(of.modes);
        self.numbers(&of.frequencies);
        self.numbers(&of.stiffness);
        self.integrals(&of.inertia);
        self.list(&of.shapes, |out, column| out.numbers(column.as_flattened()));
        let ReductionChecks { rigid, unstrained, symmetry, coupling, static_residual, mode_residual, free_frequencies } =
            &of.checks;
        for value in [rigid, unstrained, symmetry, coupling, static_residual, mode_residual] {
            self.number(*value);
        }
        self.numbers(free_frequencies);
        self.whole(of.effort.equations);
        self.whole(of.effort.factor_entries);
    }

    fn integrals(&mut self, of: &ShapeIntegrals) {
        self.number(of.mass);
        of.first.iter().for_each(|&value| self.number(value));
        of.second.as_flattened().iter().for_each(|&value| self.number(value));
        self.numbers(of.flow.as_flattened());
        self.numbers(of.placed.as_flattened().as_flattened());
        self.numbers(of.products.as_flattened().as_flattened());
    }
}

/// What is left to read; `None` wherever it ends too early or makes no sense.
struct Input<'b> {
    bytes: &'b [u8],
}

impl<'b> Input<'b> {
    fn take(&mut self, count: usize) -> Option<&'b [u8]> {
        let (taken, rest) = self.bytes.split_at_checked(count)?;
        self.bytes = rest;
        Some(taken)
    }

    fn whole(&mut self) -> Option<usize> {
        usize::try_from(u64::from_le_bytes(self.take(8)?.try_into().ok()?)).ok()
    }

    fn number(&mut self) -> Option<f64> {
        Some(f64::from_le_bytes(self.take(8)?.try_into().ok()?))
    }

    fn text(&mut self) -> Option<String> {
        let length = self.whole()?;
        String::from_utf8(self.take(length)?.to_vec()).ok()
    }

    fn numbers(&mut self) -> Option<Vec<f64>> {
        let bytes = self.whole()?.checked_mul(8)?;
        let number = |bytes: &[u8]| Some(f64::from_le_bytes(bytes.try_into().ok()?));
        self.take(bytes)?.chunks_exact(8).map(number).collect()
    }

    fn nodes(&mut self) -> Option<Vec<u32>> {
        let bytes = self.whole()?.checked_mul(4)?;
        let number = |bytes: &[u8]| Some(u32::from_le_bytes(bytes.try_into().ok()?));
        self.take(bytes)?.chunks_exact(4).map(number).collect()
    }

    fn vectors<const N: usize>(&mut self) -> Option<Vec<[f64; N]>> {
        let all = self.numbers()?;
        let (vectors, rest) = all.as_chunks::<N>();
        rest.is_empty().then(|| vectors.to_vec())
    }

    fn list<T>(&mut self, read: impl Fn(&mut Self) -> Option<T>) -> Option<Vec<T>> {
        let count = self.whole()?;
        (0..count).map(|_| read(self)).collect()
    }

    fn named<T>(&mut self, read: impl Fn(&mut Self) -> Option<T>) -> Option<BTreeMap<String, T>> {
        Some(self.list(|input| Some((input.text()?, read(input)?)))?.into_iter().collect())
    }

    fn reduced(&mut self) -> Option<Reduced> {
        let mesh = self.mesh()?;
        let reduction = self.reduction()?;
        let stress = self.list(Self::vectors)?;
        let shortenings = self.list(|input| Some(Shortening { along: input.whole()?, matrix: input.numbers()? }))?;
        let left_out = self.numbers()?;
        let notes = self.list(Self::text)?;
        Some(Reduced { shortenings, left_out, notes, ..Reduced::new(mesh, reduction, stress) })
    }

    fn mesh(&mut self) -> Option<Mesh> {
        let nodes = self.vectors()?;
        let blocks = self.list(|input| {
            let name = input.text()?;
            let shape = input.text()?;
            let shape = Shape::ALL.into_iter().find(|one| one.abaqus() == shape)?;
            Some(Block { name, shape, nodes: input.nodes()? })
        })?;
        let node_sets = self.named(Self::nodes)?;
        let face_sets = self.named(Self::faces)?;
        Some(Mesh { nodes, blocks, node_sets, face_sets })
    }

    fn faces(&mut self) -> Option<Vec<Face>> {
        let all = self.nodes()?;
        let face = |of: &[u32]| match *of {
            [block, element, face] => Some(Face { block, element, face: face.try_into().ok()? }),
            _ => None,
        };
        all.chunks(3).map(face).collect()
    }

    fn reduction(&mut self) -> Option<Reduction> {
        Some(Reduction {
            points: self.vectors()?,
            modes: self.whole()?,
            frequencies: self.numbers()?,
            stiffness: self.numbers()?,
            inertia: self.integrals()?,
            shapes: self.list(Self::vectors)?,
            checks: ReductionChecks {
                rigid: self.number()?,
                unstrained: self.number()?,
                symmetry: self.number()?,
                coupling: self.number()?,
                static_residual: self.number()?,
                mode_residual: self.number()?,
                free_frequencies: self.numbers()?,
            },
            effort: Effort { equations: self.whole()?, factor_entries: self.whole()? },
        })
    }

    fn three(&mut self) -> Option<[f64; 3]> {
        Some([self.number()?, self.number()?, self.number()?])
    }

    fn matrices(&mut self) -> Option<Vec<[[f64; 3]; 3]>> {
        let rows: Vec<[f64; 3]> = self.vectors()?;
        let (matrices, rest) = rows.as_chunks::<3>();
        rest.is_empty().then(|| matrices.to_vec())
    }

    fn integrals(&mut self) -> Option<ShapeIntegrals> {
        Some(ShapeIntegrals {
            mass: self.number()?,
            first: self.three()?,
            second: [self.three()?, self.three()?, self.three()?],
            flow: self.vectors()?,
            placed: self.matrices()?,
            products: self.matrices()?,
        })
    }
}
