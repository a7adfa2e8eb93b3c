//! Pictures of parts with stress or mode shapes on them, and the numbers with which they can be turned.

mod data;
mod integers;

use super::Escaped;
use super::data::encoded;
use crate::PictureFile;

pub(crate) use data::push as push_data;

/// The drawing to turn, built from `web/` like the rest; it goes only into pages with such pictures.
pub(crate) const SCRIPT: &str = include_str!("../../web/dist/contour.js");
pub(crate) const SHEET: &str = include_str!("../../web/dist/contour.css");

/// Whether any study has such a picture.
pub(crate) fn any(pictures: &[Vec<Option<PictureFile>>]) -> bool {
    pictures.iter().flatten().any(Option::is_some)
}

/// Each as a still picture, which print and pages without scripts keep; a drawing to turn takes its place where the
/// browser can.
pub(crate) fn section(pictures: &[Option<PictureFile>], index: usize) -> String {
    let one = |(at, picture): (usize, &Option<PictureFile>)| {
        picture.as_ref().map_or_else(String::new, |picture| figure(picture, index, at))
    };
    let all: String = pictures.iter().enumerate().map(one).collect();
    if all.is_empty() { all } else { format!("<h3>Parts</h3>\n{all}") }
}

fn figure(picture: &PictureFile, study: usize, index: usize) -> String {
    let (width, height) = picture.size;
    let still = encoded(&picture.png);
    format!(
        "<figure class=\"contour\" data-contour=\"{study}-{index}\">\n\
         <img src=\"data:image/png;base64,{}\" width=\"{width}\" height=\"{height}\" alt=\"{}\">\n</figure>\n",
        String::from_utf8_lossy(&still),
        Escaped(&picture.title)
    )
}
