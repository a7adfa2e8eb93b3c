//! Names from a file as HTML text.

use std::fmt;

/// Text that is shown as it is: the five characters that HTML and XML read otherwise are replaced,
/// and so are control characters, which XML does not allow.
pub(crate) struct Escaped<'a>(pub(crate) &'a str);

impl fmt::Display for Escaped<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let special = |c: char| "&<>\"'".contains(c) || (c.is_control() && !"\n\t".contains(c));
        let mut rest = self.0;
        while let Some(at) = rest.find(special) {
            f.write_str(&rest[..at])?;
            let mut after = rest[at..].chars();
            f.write_str(after.next().map_or("", replacement))?;
            rest = after.as_str();
        }
        f.write_str(rest)
    }
}

fn replacement(c: char) -> &'static str {
    match c {
        '&' => "&amp;",
        '<' => "&lt;",
        '>' => "&gt;",
        '"' => "&quot;",
        '\'' => "&#39;",
        _ => "\u{fffd}",
    }
}

#[cfg(test)]
mod tests {
    use super::Escaped;

    #[test]
    fn markup_becomes_text() {
        let text = Escaped("<b a='1'>&\"é\u{1b}\n</b>").to_string();
        assert_eq!(text, "&lt;b a=&#39;1&#39;&gt;&amp;&quot;é\u{fffd}\n&lt;/b&gt;");
    }
}
