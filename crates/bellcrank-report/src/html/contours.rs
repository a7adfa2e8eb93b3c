//! Pictures of parts with stress or mode shapes on them.

use super::Escaped;
use super::data::encoded;
use crate::PictureFile;

/// Each as a still picture, which print and pages without scripts keep; a drawing to turn takes its place where the
/// browser can.
pub(crate) fn section(pictures: &[Option<PictureFile>], study: usize) -> String {
    let one = |(index, picture): (usize, &Option<PictureFile>)| {
        picture.as_ref().map_or_else(String::new, |picture| figure(picture, study, index))
    };
    let all: String = pictures.iter().enumerate().map(one).collect();
    if all.is_empty() { all } else { format!("<h3>Parts</h3>\n{all}") }
}

fn figure(picture: &PictureFile, study: usize, index: usize) -> String {
    let (width, height) = picture.size;
    let data = encoded(&picture.png);
    format!(
        "<figure class=\"contour\" data-contour=\"{study}-{index}\">\n<figcaption>{title}</figcaption>\n\
         <img src=\"data:image/png;base64,{}\" width=\"{width}\" height=\"{height}\" alt=\"{title}\">\n</figure>\n",
        String::from_utf8_lossy(&data),
        title = Escaped(&picture.title)
    )
}
