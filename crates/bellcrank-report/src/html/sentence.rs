//! Sentences as the program writes them: names stand between backticks.

use super::Escaped;

/// A sentence as HTML: what stands between backticks is set as code, all else is plain text.
pub(crate) fn sentence(text: &str) -> String {
    let parts = text.split('`').enumerate();
    // Without a partner the last backtick is just a character.
    let paired = text.matches('`').count().is_multiple_of(2);
    if !paired {
        return Escaped(text).to_string();
    }
    parts
        .map(|(index, part)| match index % 2 {
            0 => Escaped(part).to_string(),
            _ => format!("<code>{}</code>", Escaped(part)),
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::sentence;

    #[test]
    fn names_are_set_as_code() {
        assert_eq!(sentence("joint `A<b>` & `B`"), "joint <code>A&lt;b&gt;</code> &amp; <code>B</code>");
        assert_eq!(sentence("a lone ` stays"), "a lone ` stays");
    }
}
