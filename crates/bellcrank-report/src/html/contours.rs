//! Pictures of parts with stress or mode shapes on them, and the numbers with which they can be turned.

mod data;

use bellcrank_results::{Contour, StudyResult};

use super::Escaped;
use super::data::encoded;
use crate::PictureFile;
use crate::picture::contours;

use data::is_light;
pub(crate) use data::{colours, distinct, push as push_data, push_places, scale};

/// The drawing to turn, built from `web/` like the rest; it goes only into pages with such pictures.
pub(crate) const SCRIPT: &str = include_str!("../../web/dist/contour.js");
pub(crate) const SHEET: &str = include_str!("../../web/dist/contour.css");

/// Whether any study has such a picture.
pub(crate) fn any(pictures: &[Vec<Option<PictureFile>>]) -> bool {
    pictures.iter().flatten().any(Option::is_some)
}

/// Each as a still picture, which print and pages without scripts keep; a drawing to turn takes its place where the
/// browser can.
pub(crate) fn section(study: &StudyResult, pictures: &[Option<PictureFile>], index: usize) -> String {
    let one = |((at, picture), contour): ((usize, &Option<PictureFile>), &Contour)| {
        picture.as_ref().map_or_else(String::new, |picture| figure(picture, contour, &key(index, at)))
    };
    let drawn = contours(study);
    let drawn = drawn.iter().map(AsRef::as_ref);
    let all: String = pictures.iter().enumerate().zip(drawn).map(one).collect();
    if all.is_empty() { all } else { format!("<h3>Parts</h3>\n{all}") }
}

/// What a contour is called in the page.
fn key(study: usize, index: usize) -> String {
    format!("{study}-{index}")
}

fn figure(picture: &PictureFile, contour: &Contour, key: &str) -> String {
    let (width, height) = picture.size;
    let still = encoded(&picture.png);
    let (turns, why) = if is_light(contour) {
        (format!(" data-contour=\"{key}\""), String::new())
    } else {
        let count = contour.triangles.len();
        (String::new(), format!("<p class=\"hint\">Too much to be turned in this page: {count} triangles.</p>\n"))
    };
    format!(
        "<figure class=\"contour\"{turns}>\n\
         <img src=\"data:image/png;base64,{}\" width=\"{width}\" height=\"{height}\" alt=\"{}\">\n{why}</figure>\n",
        String::from_utf8_lossy(&still),
        Escaped(&picture.title)
    )
}
