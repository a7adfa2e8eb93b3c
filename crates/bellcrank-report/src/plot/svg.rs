//! SVG text, one element at a time.

use crate::html::Escaped;

/// The typeface of labels: what the reader's system has.
const FONT: &str = "system-ui, 'Segoe UI', 'Helvetica Neue', Arial, 'DejaVu Sans', sans-serif";

/// SVG text under construction.
pub(crate) struct Svg {
    text: String,
}

/// Where a text is held.
#[derive(Clone, Copy)]
pub(crate) enum Anchor {
    Start,
    Middle,
    End,
}

impl Anchor {
    fn word(self) -> &'static str {
        match self {
            Self::Start => "start",
            Self::Middle => "middle",
            Self::End => "end",
        }
    }
}

impl Svg {
    /// A picture of that size (px) on white; `extra` goes into the opening tag.
    pub(crate) fn new(size: (f64, f64), title: &str, extra: &str) -> Self {
        let (width, height) = size;
        let title = Escaped(title);
        let text = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {width} {height}\" \
             width=\"{width}\" height=\"{height}\" role=\"img\" font-family=\"{FONT}\" \
             font-size=\"12\" fill=\"#222\"{extra}>\n<title>{title}</title>\n\
             <rect width=\"{width}\" height=\"{height}\" fill=\"#fff\"/>\n"
        );
        Self { text }
    }

    pub(crate) fn raw(&mut self, text: &str) {
        self.text.push_str(text);
    }

    pub(crate) fn line(&mut self, from: (f64, f64), to: (f64, f64), stroke: &str) {
        let path = format!("M{} {}L{} {}", px(from.0), px(from.1), px(to.0), px(to.1));
        self.path(&path, stroke);
    }

    pub(crate) fn path(&mut self, path: &str, stroke: &str) {
        for part in ["<path d=\"", path, "\" fill=\"none\" ", stroke, "/>\n"] {
            self.text.push_str(part);
        }
    }

    pub(crate) fn circle(&mut self, center: (f64, f64), radius: f64, style: &str) {
        let (x, y, r) = (px(center.0), px(center.1), px(radius));
        self.raw(&format!("<circle cx=\"{x}\" cy=\"{y}\" r=\"{r}\" {style}/>\n"));
    }

    pub(crate) fn label(&mut self, at: (f64, f64), anchor: Anchor, style: &str, text: &str) {
        let (x, y, anchor, text) = (px(at.0), px(at.1), anchor.word(), Escaped(text));
        self.raw(&format!("<text x=\"{x}\" y=\"{y}\" text-anchor=\"{anchor}\" {style}>{text}</text>\n"));
    }

    pub(crate) fn finish(mut self) -> String {
        self.text.push_str("</svg>\n");
        self.text
    }
}

/// A length in pixels with two decimals at most.
pub(crate) fn px(value: f64) -> String {
    let mut text = String::new();
    push_px(&mut text, value);
    text
}

/// Appends a length in pixels: hundredths are finer than any screen or printer needs here, and
/// writing them as integers is several times faster than formatting a float.
pub(crate) fn push_px(text: &mut String, value: f64) {
    let hundredths = (value * 100.0).round() as i64;
    if hundredths < 0 {
        text.push('-');
    }
    push_integer(text, hundredths.unsigned_abs() / 100);
    let rest = hundredths.unsigned_abs() % 100;
    if rest > 0 {
        text.push('.');
        text.push(digit(rest / 10));
        if !rest.is_multiple_of(10) {
            text.push(digit(rest % 10));
        }
    }
}

fn push_integer(text: &mut String, value: u64) {
    if value >= 10 {
        push_integer(text, value / 10);
    }
    text.push(digit(value % 10));
}

fn digit(value: u64) -> char {
    char::from(b'0' + (value % 10) as u8)
}

#[cfg(test)]
mod tests {
    use super::px;

    #[test]
    fn pixels_are_short() {
        for (value, text) in [(0.0, "0"), (12.0, "12"), (-3.456, "-3.46"), (0.104, "0.1"), (100.05, "100.05")] {
            assert_eq!(px(value), text);
        }
    }
}
