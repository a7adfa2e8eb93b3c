//! A reader of tags, strict where a browser forgives, and of what is packed between them.

use std::io::Read;

/// Elements that have no end tag.
const VOID: [&str; 5] = ["meta", "link", "br", "input", "img"];

/// Fails unless every element that opens closes, in order. Scripts and sheets are skipped.
pub fn assert_balanced(page: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = page;
    while let Some(at) = rest.find('<') {
        let tag = &rest[at + 1..];
        let end = tag.find('>').expect("a tag that does not end");
        let inside = &tag[..end];
        rest = &tag[end + 1..];
        if inside.starts_with('!') {
            continue;
        }
        let name = inside.trim_start_matches('/').split([' ', '/', '\n']).next().unwrap();
        if inside.starts_with('/') {
            assert_eq!(open.pop(), Some(name), "closing tag out of order near {inside}");
        } else if !inside.ends_with('/') && !VOID.contains(&name) {
            open.push(name);
            rest = skip_raw(name, rest);
        }
    }
    assert!(open.is_empty(), "never closed: {open:?}");
}

fn skip_raw<'a>(name: &str, rest: &'a str) -> &'a str {
    if name == "script" || name == "style" {
        &rest[rest.find(&format!("</{name}>")).expect("raw text that does not end")..]
    } else {
        rest
    }
}

/// What stands between `from` and `to`.
pub fn between<'a>(page: &'a str, from: &str, to: &str) -> &'a str {
    let start = page.find(from).unwrap_or_else(|| panic!("no {from}")) + from.len();
    &page[start..start + page[start..].find(to).unwrap()]
}

/// What a block of packed numbers holds.
pub fn unpacked(text: &str) -> Vec<u8> {
    let mut bytes = Vec::new();
    flate2::read::GzDecoder::new(&decoded(text)[..]).read_to_end(&mut bytes).unwrap();
    bytes
}

/// Base64 without checks.
fn decoded(text: &str) -> Vec<u8> {
    const ALPHABET: &str = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let six = |c: char| ALPHABET.find(c).unwrap() as u32;
    let letters: Vec<u32> = text.trim_end_matches('=').chars().map(six).collect();
    let four = |group: &[u32]| {
        let bits = group.iter().enumerate().fold(0, |sum, (k, six)| sum | six << (18 - 6 * k));
        bits.to_be_bytes()[1..group.len()].to_vec()
    };
    letters.chunks(4).flat_map(four).collect()
}
