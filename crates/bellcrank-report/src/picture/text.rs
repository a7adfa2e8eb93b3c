//! Text in pixels, in a typeface that comes along (see `font/README.md`).

use std::sync::LazyLock;

use ab_glyph::{Font, FontRef, ScaleFont, point};

/// DejaVu Sans: Latin, Greek, Cyrillic, figures, signs.
static FACE: LazyLock<Option<FontRef<'static>>> =
    LazyLock::new(|| FontRef::try_from_slice(include_bytes!("font/DejaVuSans-subset.ttf")).ok());

/// Hands every pixel that `text` touches, from its origin on the base line, to `mix` with its share of ink; gives
/// the width. A letter that the typeface lacks is a box.
pub(crate) fn draw(text: &str, size: f32, mut mix: impl FnMut(i64, i64, f32)) -> f32 {
    let Some(face) = FACE.as_ref() else { return 0.0 };
    let scaled = face.as_scaled(size_of(face, size));
    let mut x = 0.0;
    for id in text.chars().map(|c| face.glyph_id(c)) {
        let glyph = id.with_scale_and_position(scaled.scale(), point(x, 0.0));
        if let Some(outline) = face.outline_glyph(glyph) {
            let corner = outline.px_bounds().min;
            outline.draw(|dx, dy, share| {
                mix(corner.x as i64 + i64::from(dx), corner.y as i64 + i64::from(dy), share);
            });
        }
        x += scaled.h_advance(id);
    }
    x
}

/// How wide `text` is.
pub(crate) fn width(text: &str, size: f32) -> f32 {
    let Some(face) = FACE.as_ref() else { return 0.0 };
    let scaled = face.as_scaled(size_of(face, size));
    text.chars().map(|c| scaled.h_advance(face.glyph_id(c))).sum()
}

/// `text`, or as much of it as has room, with an ellipsis.
pub(crate) fn fitted(text: &str, size: f32, room: f32) -> String {
    if width(text, size) <= room {
        return text.to_owned();
    }
    let letters: Vec<char> = text.chars().collect();
    let short = |count: usize| letters[..count].iter().collect::<String>() + "…";
    (0..letters.len()).rev().map(short).find(|short| width(short, size) <= room).unwrap_or_default()
}

/// The scale at which the square of the typeface is `size` pixels, as sizes are given everywhere else.
fn size_of(face: &FontRef<'_>, size: f32) -> ab_glyph::PxScale {
    face.pt_to_px_scale(size * 0.75).unwrap_or(ab_glyph::PxScale::from(size))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_typeface_is_there() {
        let mut ink = 0.0;
        let reach = draw("σ = 148 MPa ± 2 %", 14.0, |_, _, share| ink += share);
        assert!(ink > 100.0 && (110.0..150.0).contains(&reach), "{ink} {reach}");
        assert!((width("σ = 148 MPa ± 2 %", 14.0) - reach).abs() < 1e-3);
    }

    #[test]
    fn long_texts_are_cut() {
        let short = fitted("a title that is much too long for its place", 14.0, 100.0);
        assert!(short.ends_with('…') && width(&short, 14.0) <= 100.0 && short.starts_with("a title"));
        assert_eq!(fitted("short", 14.0, 100.0), "short");
        assert_eq!(fitted("no room at all", 14.0, 1.0), "");
    }
}
