//! A picture of pixels: rectangles, lines, marks and text on it.

use super::palette::Rgb;
use super::text;

/// A picture, three bytes a pixel, row by row.
pub(crate) struct Canvas {
    pub(crate) width: usize,
    pub(crate) height: usize,
    pub(crate) pixels: Vec<u8>,
}

/// A rectangle of pixels: left, top, width, height.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Rect {
    pub(crate) x: f32,
    pub(crate) y: f32,
    pub(crate) width: f32,
    pub(crate) height: f32,
}

impl Rect {
    pub(crate) fn grown(self, by: f32) -> Self {
        Self { x: self.x - by, y: self.y - by, width: self.width + 2.0 * by, height: self.height + 2.0 * by }
    }

    pub(crate) fn middle(self) -> [f32; 2] {
        [self.x + self.width / 2.0, self.y + self.height / 2.0]
    }

    /// Area shared with another one.
    pub(crate) fn overlap(self, other: Self) -> f32 {
        let along = |a: f32, la: f32, b: f32, lb: f32| ((a + la).min(b + lb) - a.max(b)).max(0.0);
        along(self.x, self.width, other.x, other.width) * along(self.y, self.height, other.y, other.height)
    }
}

impl Canvas {
    pub(crate) fn white(width: usize, height: usize) -> Self {
        Self { width, height, pixels: vec![255; 3 * width * height] }
    }

    /// Mixes `colour` into a pixel; outside nothing happens.
    pub(crate) fn mix(&mut self, x: i64, y: i64, colour: Rgb, share: f32) {
        if x < 0 || y < 0 || x as usize >= self.width || y as usize >= self.height {
            return;
        }
        let at = 3 * (y as usize * self.width + x as usize);
        for (pixel, wanted) in self.pixels[at..at + 3].iter_mut().zip(colour) {
            let mixed = f32::from(*pixel) + share.clamp(0.0, 1.0) * (f32::from(wanted) - f32::from(*pixel));
            *pixel = mixed.round() as u8;
        }
    }

    /// Fills a rectangle; sides between pixels are soft.
    pub(crate) fn fill(&mut self, rect: Rect, colour: Rgb, share: f32) {
        let cover = |from: f32, length: f32, k: i64| {
            let k = k as f32;
            ((from + length).min(k + 1.0) - from.max(k)).clamp(0.0, 1.0)
        };
        for y in rect.y.floor() as i64..(rect.y + rect.height).ceil() as i64 {
            let tall = cover(rect.y, rect.height, y);
            for x in rect.x.floor() as i64..(rect.x + rect.width).ceil() as i64 {
                self.mix(x, y, colour, share * tall * cover(rect.x, rect.width, x));
            }
        }
    }

    /// The rim of a rectangle, one pixel wide.
    pub(crate) fn rim(&mut self, rect: Rect, colour: Rgb) {
        let Rect { x, y, width, height } = rect;
        self.fill(Rect { height: 1.0, ..rect }, colour, 1.0);
        self.fill(Rect { y: y + height - 1.0, height: 1.0, ..rect }, colour, 1.0);
        self.fill(Rect { width: 1.0, ..rect }, colour, 1.0);
        self.fill(Rect { x: x + width - 1.0, width: 1.0, ..rect }, colour, 1.0);
    }

    /// Slanted stripes inside a rectangle.
    pub(crate) fn hatch(&mut self, rect: Rect, colour: Rgb, share: f32) {
        for y in rect.y.ceil() as i64..(rect.y + rect.height) as i64 {
            for x in rect.x.ceil() as i64..(rect.x + rect.width) as i64 {
                if (x + y).rem_euclid(7) < 2 {
                    self.mix(x, y, colour, share);
                }
            }
        }
    }

    /// A soft line of that width.
    pub(crate) fn line(&mut self, from: [f32; 2], to: [f32; 2], width: f32, colour: Rgb) {
        let d = [to[0] - from[0], to[1] - from[1]];
        let length = d[0].hypot(d[1]).max(1e-6);
        let reach = width / 2.0 + 1.0;
        let (left, right) = (from[0].min(to[0]) - reach, from[0].max(to[0]) + reach);
        let (top, bottom) = (from[1].min(to[1]) - reach, from[1].max(to[1]) + reach);
        for y in top as i64..=bottom as i64 {
            for x in left as i64..=right as i64 {
                let p = [x as f32 + 0.5 - from[0], y as f32 + 0.5 - from[1]];
                let along = ((p[0] * d[0] + p[1] * d[1]) / (length * length)).clamp(0.0, 1.0);
                let far = (p[0] - along * d[0]).hypot(p[1] - along * d[1]);
                self.mix(x, y, colour, width / 2.0 + 0.5 - far);
            }
        }
    }

    /// A disk with a rim; hollow where `fill` is white.
    pub(crate) fn disk(&mut self, at: [f32; 2], radius: f32, fill: Rgb, rim: Rgb) {
        let reach = radius as i64 + 2;
        for y in at[1] as i64 - reach..=at[1] as i64 + reach {
            for x in at[0] as i64 - reach..=at[0] as i64 + reach {
                let far = (x as f32 + 0.5 - at[0]).hypot(y as f32 + 0.5 - at[1]);
                self.mix(x, y, rim, radius + 0.5 - far);
                self.mix(x, y, fill, radius - 1.0 - far);
            }
        }
    }

    /// Text with its base line at `at`; gives its width.
    pub(crate) fn text(&mut self, at: [f32; 2], size: f32, colour: Rgb, text: &str) -> f32 {
        text::draw(text, size, |x, y, share| self.mix(at[0] as i64 + x, at[1] as i64 + y, colour, share))
    }
}
