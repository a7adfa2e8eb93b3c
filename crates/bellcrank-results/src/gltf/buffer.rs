//! The bytes of a file, and the views and accessors that point into them.

use serde_json::{Value, json};

const FLOAT: u32 = 5126;
const UNSIGNED_SHORT: u32 = 5123;
const UNSIGNED_INT: u32 = 5125;
const VERTICES: u32 = 34962;
const INDICES: u32 = 34963;

/// One buffer that grows; each block starts at a multiple of four.
#[derive(Default)]
pub(super) struct Buffer {
    bytes: Vec<u8>,
    views: Vec<Value>,
    accessors: Vec<Value>,
}

impl Buffer {
    /// Appends places or normals; gives the accessor. Positions need their extent.
    pub(super) fn push_vertices(&mut self, vectors: &[[f32; 3]], extent: bool) -> usize {
        let view = self.push(vectors.as_flattened().iter().flat_map(|x| x.to_le_bytes()), Some(VERTICES));
        let mut accessor = accessor(view, FLOAT, vectors.len(), "VEC3");
        if extent {
            let of = |pick: fn(f32, f32) -> f32| -> [f32; 3] {
                std::array::from_fn(|k| vectors.iter().map(|v| v[k]).reduce(pick).unwrap_or(0.0))
            };
            accessor["min"] = json!(of(f32::min));
            accessor["max"] = json!(of(f32::max));
        }
        self.add(accessor)
    }

    /// Appends corners of triangles, in two bytes each where that holds `vertices`.
    pub(super) fn push_indices(&mut self, indices: &[u32], vertices: usize) -> usize {
        let (view, kind) = if vertices < usize::from(u16::MAX) {
            (self.push(indices.iter().flat_map(|i| (*i as u16).to_le_bytes()), Some(INDICES)), UNSIGNED_SHORT)
        } else {
            (self.push(indices.iter().flat_map(|i| i.to_le_bytes()), Some(INDICES)), UNSIGNED_INT)
        };
        self.add(accessor(view, kind, indices.len(), "SCALAR"))
    }

    /// Appends the times of frames, which rise.
    pub(super) fn push_times(&mut self, times: &[f32]) -> usize {
        let view = self.push(times.iter().flat_map(|t| t.to_le_bytes()), None);
        let mut accessor = accessor(view, FLOAT, times.len(), "SCALAR");
        accessor["min"] = json!([times.first()]);
        accessor["max"] = json!([times.last()]);
        self.add(accessor)
    }

    /// Appends what an animation moves: `VEC3` or `VEC4`.
    pub(super) fn push_track<const N: usize>(&mut self, values: &[[f32; N]]) -> usize {
        let view = self.push(values.as_flattened().iter().flat_map(|x| x.to_le_bytes()), None);
        self.add(accessor(view, FLOAT, values.len(), if N == 3 { "VEC3" } else { "VEC4" }))
    }

    /// Writes buffer, views and accessors into the document.
    pub(super) fn describe(&mut self, document: &mut Value) {
        if self.bytes.is_empty() {
            return;
        }
        document["buffers"] = json!([{ "byteLength": self.bytes.len() }]);
        document["bufferViews"] = Value::Array(std::mem::take(&mut self.views));
        document["accessors"] = Value::Array(std::mem::take(&mut self.accessors));
    }

    pub(super) fn into_bytes(self) -> Vec<u8> {
        self.bytes
    }

    fn push(&mut self, bytes: impl Iterator<Item = u8>, target: Option<u32>) -> usize {
        let start = self.bytes.len();
        self.bytes.extend(bytes);
        let mut view = json!({ "buffer": 0, "byteOffset": start, "byteLength": self.bytes.len() - start });
        if let Some(target) = target {
            view["target"] = json!(target);
        }
        self.bytes.resize(self.bytes.len().next_multiple_of(4), 0);
        self.views.push(view);
        self.views.len() - 1
    }

    fn add(&mut self, accessor: Value) -> usize {
        self.accessors.push(accessor);
        self.accessors.len() - 1
    }
}

fn accessor(view: usize, component: u32, count: usize, kind: &str) -> Value {
    json!({ "bufferView": view, "componentType": component, "count": count, "type": kind })
}
