//! Pictures of parts coloured by a field: PNG, drawn here without a graphics card.

mod axes;
mod bar;
mod canvas;
mod file;
mod labels;
mod palette;
mod panel;
mod raster;
mod scale;
mod sheet;
mod still;
mod surface;
mod text;
mod vector;

pub(crate) use axes::plan;
pub(crate) use palette::{ABOVE, DIVERGING, NONE, SEQUENTIAL};
pub(crate) use scale::Scale;
pub(crate) use sheet::{TILT, fields};
pub(crate) use still::{contours, in_row};
pub(crate) use surface::{nearest, outline, usual_scale};
pub(crate) use vector::bounds;

use bellcrank_results::{Contour, StudyResult, file_stems};

/// A picture of a part, ready to be written.
#[derive(Clone, Debug)]
pub struct PictureFile {
    /// File name without folder and `.png`.
    pub stem: String,
    /// What it shows.
    pub title: String,
    /// Size in pixels.
    pub size: (usize, usize),
    /// The picture: a PNG file.
    pub png: Vec<u8>,
}

/// One picture for each contour of a study, in their order, then one for each flexible body in its worst row; none of
/// what has no surface.
pub fn pictures(study: &StudyResult) -> Vec<Option<PictureFile>> {
    let drawn = contours(study);
    let titles: Vec<String> = drawn.iter().map(|contour| stem(&contour.title)).collect();
    let stems = file_stems(titles.iter().map(String::as_str));
    drawn.iter().zip(stems).map(|(contour, stem)| picture(contour, stem)).collect()
}

fn picture(contour: &Contour, stem: String) -> Option<PictureFile> {
    if !surface::is_drawable(contour) {
        return None;
    }
    let canvas = sheet::drawn(contour);
    let png = file::png(&canvas);
    Some(PictureFile { stem, title: contour.title.clone(), size: (canvas.width, canvas.height), png })
}

/// A title as a file name: each run of what a file name should not hold becomes one `_`.
fn stem(title: &str) -> String {
    let keep = |c: char| c.is_ascii_alphanumeric() || ".-".contains(c);
    title.split(|c| !keep(c)).filter(|word| !word.is_empty()).collect::<Vec<_>>().join("_")
}

#[cfg(test)]
mod tests {
    #[test]
    fn titles_become_file_names() {
        assert_eq!(
            super::stem("link3: stress at joint.B.position = -30 deg"),
            "link3_stress_at_joint.B.position_-30_deg"
        );
        assert_eq!(super::stem("«»"), "");
    }
}
