//! Numbers as bytes, each block at a multiple of eight.

/// Little-endian floats one block after the other.
#[derive(Default)]
pub(crate) struct Blob {
    bytes: Vec<u8>,
}

impl Blob {
    /// Appends in single precision, which draws any curve; gives the byte offset.
    pub(crate) fn push_floats(&mut self, values: impl Iterator<Item = f64>) -> usize {
        let at = self.aligned();
        for value in values {
            self.bytes.extend_from_slice(&(value as f32).to_le_bytes());
        }
        at
    }

    /// Appends in double precision; gives the byte offset.
    pub(crate) fn push_doubles(&mut self, values: impl Iterator<Item = f64>) -> usize {
        let at = self.aligned();
        for value in values {
            self.bytes.extend_from_slice(&value.to_le_bytes());
        }
        at
    }

    pub(crate) fn bytes(&self) -> &[u8] {
        &self.bytes
    }

    /// Typed arrays in the browser start only at multiples of their size.
    fn aligned(&mut self) -> usize {
        self.bytes.resize(self.bytes.len().next_multiple_of(8), 0);
        self.bytes.len()
    }
}
