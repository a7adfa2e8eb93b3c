//! Bytes as text (RFC 4648, with padding).

const ALPHABET: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

/// Appends `bytes` to `text`.
pub(crate) fn push(text: &mut String, bytes: &[u8]) {
    text.reserve(bytes.len().div_ceil(3) * 4);
    let (whole, rest) = bytes.as_chunks::<3>();
    for &[a, b, c] in whole {
        push_group(text, [a, b, c], 4);
    }
    match *rest {
        [a] => push_group(text, [a, 0, 0], 2),
        [a, b] => push_group(text, [a, b, 0], 3),
        _ => {}
    }
}

fn push_group(text: &mut String, group: [u8; 3], count: usize) {
    let bits = u32::from_be_bytes([0, group[0], group[1], group[2]]);
    let letters = [18, 12, 6, 0].map(|shift| ALPHABET[(bits >> shift) as usize & 63]);
    let mut shown = [b'='; 4];
    shown[..count].copy_from_slice(&letters[..count]);
    text.extend(shown.map(char::from));
}

#[cfg(test)]
mod tests {
    use super::push;

    #[test]
    fn the_vectors_of_the_standard() {
        for (bytes, expected) in [("", ""), ("f", "Zg=="), ("fo", "Zm8="), ("foo", "Zm9v"), ("foobar", "Zm9vYmFy")] {
            let mut text = String::new();
            push(&mut text, bytes.as_bytes());
            assert_eq!(text, expected);
        }
    }
}
