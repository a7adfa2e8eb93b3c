//! Bytes as text (RFC 4648, with padding).

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// `bytes` as base64.
pub(crate) fn encoded(bytes: &[u8]) -> Vec<u8> {
    let mut text = vec![b'='; bytes.len().div_ceil(3) * 4];
    let (groups, _) = text.as_chunks_mut::<4>();
    for (letters, group) in groups.iter_mut().zip(bytes.chunks(3)) {
        match *group {
            [a, b, c] => *letters = four([a, b, c]),
            [a, b] => letters[..3].copy_from_slice(&four([a, b, 0])[..3]),
            [a] => letters[..2].copy_from_slice(&four([a, 0, 0])[..2]),
            _ => {}
        }
    }
    text
}

fn four(group: [u8; 3]) -> [u8; 4] {
    let bits = u32::from_be_bytes([0, group[0], group[1], group[2]]);
    [18, 12, 6, 0].map(|shift| ALPHABET[(bits >> shift) as usize & 63])
}

#[cfg(test)]
mod tests {
    use super::encoded;

    #[test]
    fn the_vectors_of_the_standard() {
        for (bytes, expected) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("fooba", "Zm9vYmE=")] {
            assert_eq!(encoded(bytes.as_bytes()), expected.as_bytes());
        }
    }
}
