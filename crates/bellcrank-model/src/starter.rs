//! A model to start from.

/// The starter model; `TITLE` stands for the title.
const TEXT: &str = include_str!("starter.toml");

/// A commented model file that runs; `name` becomes its title.
#[must_use]
pub fn starter(name: &str) -> String {
    TEXT.replace("TITLE", &escaped(name))
}

/// The text of a basic TOML string.
fn escaped(name: &str) -> String {
    let mut text = String::with_capacity(name.len());
    for c in name.chars() {
        match c {
            '"' | '\\' => {
                text.push('\\');
                text.push(c);
            }
            c if c.is_control() => text.push_str(&format!("\\u{:04X}", u32::from(c))),
            c => text.push(c),
        }
    }
    text
}
