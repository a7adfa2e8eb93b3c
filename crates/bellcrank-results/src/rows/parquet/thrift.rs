//! Structures in the compact protocol of Apache Thrift, in which Parquet writes its headers.

const I32: u8 = 5;
const I64: u8 = 6;
const BINARY: u8 = 8;
const LIST: u8 = 9;
const STRUCT: u8 = 12;

/// A structure under construction; fields are added by rising number.
#[derive(Default)]
pub(super) struct Struct {
    bytes: Vec<u8>,
    last: u8,
}

impl Struct {
    pub(super) fn i32(self, field: u8, value: i32) -> Self {
        self.number(field, I32, i64::from(value))
    }

    pub(super) fn i64(self, field: u8, value: u64) -> Self {
        self.number(field, I64, i64::try_from(value).unwrap_or(i64::MAX))
    }

    pub(super) fn binary(mut self, field: u8, value: &[u8]) -> Self {
        self.head(field, BINARY);
        push_binary(&mut self.bytes, value);
        self
    }

    pub(super) fn structure(mut self, field: u8, value: Self) -> Self {
        self.head(field, STRUCT);
        self.bytes.extend(value.finish());
        self
    }

    pub(super) fn structures(mut self, field: u8, values: Vec<Self>) -> Self {
        self.list(field, STRUCT, values.len());
        for value in values {
            self.bytes.extend(value.finish());
        }
        self
    }

    pub(super) fn i32s(mut self, field: u8, values: &[i32]) -> Self {
        self.list(field, I32, values.len());
        for value in values {
            push_varint(&mut self.bytes, zigzag(i64::from(*value)));
        }
        self
    }

    pub(super) fn strings(mut self, field: u8, values: &[&str]) -> Self {
        self.list(field, BINARY, values.len());
        for value in values {
            push_binary(&mut self.bytes, value.as_bytes());
        }
        self
    }

    /// With the mark of its end.
    pub(super) fn finish(mut self) -> Vec<u8> {
        self.bytes.push(0);
        self.bytes
    }

    fn number(mut self, field: u8, kind: u8, value: i64) -> Self {
        self.head(field, kind);
        push_varint(&mut self.bytes, zigzag(value));
        self
    }

    /// All fields of Parquet's structures are fewer than 16 apart.
    fn head(&mut self, field: u8, kind: u8) {
        debug_assert!(field > self.last && field - self.last < 16, "fields rise by less than 16");
        self.bytes.push(((field - self.last) << 4) | kind);
        self.last = field;
    }

    fn list(&mut self, field: u8, kind: u8, count: usize) {
        self.head(field, LIST);
        if count < 15 {
            self.bytes.push(((count as u8) << 4) | kind);
        } else {
            self.bytes.push(0xf0 | kind);
            push_varint(&mut self.bytes, count as u64);
        }
    }
}

fn push_binary(bytes: &mut Vec<u8>, value: &[u8]) {
    push_varint(bytes, value.len() as u64);
    bytes.extend_from_slice(value);
}

/// Seven bits a byte, the lowest first.
pub(super) fn push_varint(bytes: &mut Vec<u8>, mut value: u64) {
    while value >= 0x80 {
        bytes.push(value as u8 | 0x80);
        value >>= 7;
    }
    bytes.push(value as u8);
}

/// Small magnitudes become small numbers.
fn zigzag(value: i64) -> u64 {
    ((value << 1) ^ (value >> 63)) as u64
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_take_few_bytes() {
        let mut bytes = Vec::new();
        push_varint(&mut bytes, 300);
        assert_eq!(bytes, [0xac, 0x02]);
        assert_eq!([0, -1, 1, -2].map(zigzag), [0, 1, 2, 3]);
    }

    #[test]
    fn long_lists_have_their_length_apart() {
        let short = Struct::default().i32s(1, &[1; 3]).finish();
        assert_eq!(short, [0x19, 0x35, 2, 2, 2, 0]);
        let long = Struct::default().i32s(2, &[0; 16]).finish();
        assert_eq!(long[..3], [0x29, 0xf5, 16]);
    }
}
