//! A reader of tags, strict where a browser forgives.

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
