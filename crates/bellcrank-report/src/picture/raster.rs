//! Triangles and lines before each other: a depth for every sample, and what is seen there.

/// A corner of a triangle: across and down in samples, towards the reader in any unit; value and light at it.
#[derive(Clone, Copy)]
pub(crate) struct Corner {
    pub(crate) at: [f32; 3],
    pub(crate) value: f32,
    pub(crate) light: f32,
}

/// What is seen of a part, sample by sample.
pub(crate) struct Raster {
    pub(crate) width: usize,
    pub(crate) height: usize,
    /// Towards the reader; minus infinity where nothing is.
    depth: Vec<f32>,
    value: Vec<f32>,
    light: Vec<f32>,
    /// How dark a line covers the sample, of 255.
    pub(crate) ink: Vec<u8>,
}

/// A line: its width in samples, how dark it is, how far it may lie behind a surface and still be seen.
#[derive(Clone, Copy)]
pub(crate) struct Stroke {
    pub(crate) width: usize,
    pub(crate) ink: u8,
    pub(crate) before: f32,
}

impl Raster {
    pub(crate) fn new(width: usize, height: usize) -> Self {
        let count = width * height;
        Self {
            width,
            height,
            depth: vec![f32::NEG_INFINITY; count],
            value: vec![f32::NAN; count],
            light: vec![0.0; count],
            ink: vec![0; count],
        }
    }

    /// Value and light of a sample of the part; nothing beside it.
    pub(crate) fn seen(&self, sample: usize) -> Option<(f32, f32)> {
        (self.depth[sample] > f32::NEG_INFINITY).then(|| (self.value[sample], self.light[sample]))
    }

    /// Whether a place lies behind the part.
    pub(crate) fn hides(&self, at: [f32; 3], before: f32) -> bool {
        self.index(at[0].round() as i64, at[1].round() as i64).is_some_and(|k| self.depth[k] > at[2] + before)
    }

    /// Whether the part covers a place.
    pub(crate) fn covers(&self, x: f32, y: f32) -> bool {
        self.index(x.round() as i64, y.round() as i64).is_some_and(|k| self.depth[k] > f32::NEG_INFINITY)
    }

    fn index(&self, x: i64, y: i64) -> Option<usize> {
        let inside = x >= 0 && y >= 0 && (x as usize) < self.width && (y as usize) < self.height;
        inside.then(|| y as usize * self.width + x as usize)
    }

    /// Fills a triangle; samples lie at whole numbers. A corner without a value leaves the whole triangle without.
    pub(crate) fn triangle(&mut self, corners: &[Corner; 3]) {
        let [a, b, c] = corners.map(|corner| corner.at);
        let area = (b[0] - a[0]) * (c[1] - a[1]) - (c[0] - a[0]) * (b[1] - a[1]);
        if !area.is_finite() || area.abs() < 1e-9 {
            return;
        }
        let planes = Planes::new(corners, area);
        let low = a[1].min(b[1]).min(c[1]).ceil().max(0.0) as usize;
        let high = a[1].max(b[1]).max(c[1]).floor().min(self.height as f32 - 1.0);
        if high < 0.0 {
            return;
        }
        for y in low..=high as usize {
            if let Some((from, to)) = span(&[a, b, c], y as f32, self.width) {
                self.row(y, from, to, &planes);
            }
        }
    }

    fn row(&mut self, y: usize, from: usize, to: usize, planes: &Planes) {
        let start = y * self.width;
        let [depth, value, light] = planes.0.map(|plane| plane.along(from as f32, y as f32));
        for x in from..=to {
            let (k, step) = (start + x, (x - from) as f32);
            let here = depth.0 + step * depth.1;
            if here > self.depth[k] {
                self.depth[k] = here;
                self.value[k] = value.0 + step * value.1;
                self.light[k] = light.0 + step * light.1;
            }
        }
    }

    /// Draws a line where it is not behind the part.
    pub(crate) fn line(&mut self, from: [f32; 3], to: [f32; 3], stroke: Stroke) {
        let d: [f32; 3] = std::array::from_fn(|k| to[k] - from[k]);
        let steps = d[0].abs().max(d[1].abs()).ceil();
        if !d.iter().all(|x| x.is_finite()) || steps > 4.0 * (self.width + self.height) as f32 {
            return;
        }
        let steep = d[1].abs() > d[0].abs();
        let shift = stroke.width as i64 / 2;
        for k in 0..=steps as usize {
            let t = k as f32 / steps.max(1.0);
            let p: [f32; 3] = std::array::from_fn(|k| from[k] + t * d[k]);
            let (x, y) = (p[0].round() as i64, p[1].round() as i64);
            for aside in (0..stroke.width as i64).map(|side| side - shift) {
                let (x, y) = if steep { (x + aside, y) } else { (x, y + aside) };
                self.dot(x, y, p[2] + stroke.before, stroke.ink);
            }
        }
    }

    fn dot(&mut self, x: i64, y: i64, depth: f32, ink: u8) {
        if let Some(k) = self.index(x, y).filter(|k| self.depth[*k] <= depth) {
            self.ink[k] = self.ink[k].max(ink);
        }
    }
}

/// Depth, value and light over a triangle, each as a plane.
struct Planes([Plane; 3]);

impl Planes {
    fn new(corners: &[Corner; 3], area: f32) -> Self {
        let plane = |of: fn(&Corner) -> f32| Plane::through(corners, of, area);
        Self([plane(|c| c.at[2]), plane(|c| c.value), plane(|c| c.light)])
    }
}

/// `value + across dx + down dy` from an origin.
#[derive(Clone, Copy)]
struct Plane {
    origin: [f32; 2],
    value: f32,
    across: f32,
    down: f32,
}

impl Plane {
    fn through(corners: &[Corner; 3], of: fn(&Corner) -> f32, area: f32) -> Self {
        let [a, b, c] = corners.map(|corner| corner.at);
        let [va, vb, vc] = [of(&corners[0]), of(&corners[1]), of(&corners[2])];
        let across = ((vb - va) * (c[1] - a[1]) - (vc - va) * (b[1] - a[1])) / area;
        let down = ((vc - va) * (b[0] - a[0]) - (vb - va) * (c[0] - a[0])) / area;
        Self { origin: [a[0], a[1]], value: va, across, down }
    }

    /// Value at a place and its growth a sample across.
    fn along(&self, x: f32, y: f32) -> (f32, f32) {
        (self.value + (x - self.origin[0]) * self.across + (y - self.origin[1]) * self.down, self.across)
    }
}

/// First and last sample of a row inside a triangle.
fn span(corners: &[[f32; 3]; 3], y: f32, width: usize) -> Option<(usize, usize)> {
    let (mut left, mut right) = (f32::INFINITY, f32::NEG_INFINITY);
    for (p, q) in [(0, 1), (1, 2), (2, 0)].map(|(p, q)| (corners[p], corners[q])) {
        if (p[1] > y) == (q[1] > y) && p[1] != y && q[1] != y {
            continue;
        }
        let t = if p[1] == q[1] { 0.0 } else { (y - p[1]) / (q[1] - p[1]) };
        for x in if p[1] == q[1] { [p[0], q[0]] } else { [p[0] + t * (q[0] - p[0]); 2] } {
            (left, right) = (left.min(x), right.max(x));
        }
    }
    let (from, to) = (left.ceil().max(0.0), right.floor().min(width as f32 - 1.0));
    (from <= to).then_some((from as usize, to as usize))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn corner(x: f32, y: f32, depth: f32, value: f32) -> Corner {
        Corner { at: [x, y, depth], value, light: 1.0 }
    }

    /// Value as a plane, so that each sample has a known one.
    fn tilted(x: f32, y: f32, depth: f32) -> Corner {
        corner(x, y, depth, 2.0 * x - 3.0 * y)
    }

    #[test]
    fn a_triangle_covers_its_area_with_its_values() {
        let mut raster = Raster::new(100, 80);
        raster.triangle(&[tilted(5.3, 4.1, 0.0), tilted(90.7, 20.2, 0.0), tilted(30.4, 70.9, 0.0)]);
        let covered: Vec<usize> = (0..8000).filter(|k| raster.seen(*k).is_some()).collect();
        let area = 0.5 * (85.4 * 66.8 - 25.1 * 16.1_f64);
        assert!((covered.len() as f64 - area).abs() < 0.01 * area, "{} {area}", covered.len());
        for k in covered {
            let (value, _) = raster.seen(k).unwrap();
            assert!((value - (2.0 * (k % 100) as f32 - 3.0 * (k / 100) as f32)).abs() < 1e-2);
        }
    }

    #[test]
    fn neighbours_leave_no_gap() {
        let mut raster = Raster::new(50, 50);
        let [a, b, c, d] = [(2.5, 3.5), (47.1, 5.2), (44.4, 46.6), (4.7, 41.3)].map(|(x, y)| tilted(x, y, 0.0));
        raster.triangle(&[a, b, c]);
        raster.triangle(&[a, c, d]);
        assert!((10..40).all(|y| (10..40).all(|x| raster.covers(x as f32, y as f32))));
    }

    #[test]
    fn the_nearer_is_seen_and_hides_lines() {
        let mut raster = Raster::new(20, 20);
        let at =
            |depth: f32, value: f32| [(0.0, 0.0), (19.0, 0.0), (0.0, 19.0)].map(|(x, y)| corner(x, y, depth, value));
        raster.triangle(&at(2.0, 7.0));
        raster.triangle(&at(1.0, 5.0));
        assert_eq!(raster.seen(22).map(|seen| seen.0), Some(7.0));
        let stroke = Stroke { width: 2, ink: 200, before: 0.1 };
        raster.line([1.0, 1.0, 1.5], [8.0, 1.0, 1.5], stroke);
        assert!(raster.ink.iter().all(|ink| *ink == 0));
        raster.line([1.0, 4.0, 2.0], [8.0, 4.0, 2.0], stroke);
        assert_eq!(raster.ink.iter().filter(|ink| **ink == 200).count(), 16);
        assert!(raster.hides([3.0, 3.0, 0.0], 0.1) && !raster.hides([3.0, 3.0, 3.0], 0.1));
    }

    #[test]
    fn what_is_outside_or_without_area_is_left_out() {
        let mut raster = Raster::new(10, 10);
        raster.triangle(&[tilted(-9.0, -9.0, 0.0), tilted(-2.0, -9.0, 0.0), tilted(-2.0, -1.0, 0.0)]);
        raster.triangle(&[tilted(1.0, 1.0, 0.0), tilted(5.0, 5.0, 0.0), tilted(3.0, 3.0, 0.0)]);
        raster.triangle(&[tilted(1.0, f32::NAN, 0.0), tilted(5.0, 5.0, 0.0), tilted(3.0, 3.0, 0.0)]);
        raster.line([0.0, f32::NAN, 0.0], [1.0, 1.0, 0.0], Stroke { width: 1, ink: 9, before: 0.0 });
        assert!((0..100).all(|k| raster.seen(k).is_none() && raster.ink[k] == 0));
    }
}
