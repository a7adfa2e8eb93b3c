//! Inner points moved to the middle of their triangles, weighed by area and wanted size.

use super::field::Field;
use super::plane::Plane;

/// New places of all points. The first `fixed` stay where they are, and no triangle of the given connection turns over.
pub(super) fn smooth(plane: &Plane, fixed: usize, field: &Field) -> Vec<[f64; 2]> {
    let mut points = plane.points.clone();
    let stars = Stars::of(plane);
    let weights: Vec<f64> = plane
        .triangles
        .iter()
        .map(|triangle| {
            let [a, b, c] = triangle.map(|corner| points[corner as usize]);
            field.at([(a[0] + b[0] + c[0]) / 3.0, (a[1] + b[1] + c[1]) / 3.0]).powi(-3)
        })
        .collect();
    for point in fixed..points.len() {
        let star = stars.of_point(point);
        let old = points[point];
        let Some(new) = middle(&points, plane, star, &weights) else { continue };
        let least = worst(&points, plane, star);
        points[point] = new;
        if worst(&points, plane, star) < (0.3 * least).max(1e-12) {
            points[point] = old;
        }
    }
    points
}

/// Triangles round each point.
struct Stars {
    starts: Vec<usize>,
    triangles: Vec<u32>,
}

impl Stars {
    fn of(plane: &Plane) -> Stars {
        let mut starts = vec![0; plane.points.len() + 1];
        plane.triangles.iter().flatten().for_each(|&corner| starts[corner as usize + 1] += 1);
        (1..starts.len()).for_each(|k| starts[k] += starts[k - 1]);
        let mut next = starts.clone();
        let mut triangles = vec![0; 3 * plane.triangles.len()];
        for (k, triangle) in plane.triangles.iter().enumerate() {
            for &corner in triangle {
                triangles[next[corner as usize]] = k as u32;
                next[corner as usize] += 1;
            }
        }
        Stars { starts, triangles }
    }

    fn of_point(&self, point: usize) -> &[u32] {
        &self.triangles[self.starts[point]..self.starts[point + 1]]
    }
}

pub(super) fn area([a, b, c]: [[f64; 2]; 3]) -> f64 {
    ((b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])) / 2.0
}

fn corners(points: &[[f64; 2]], plane: &Plane, triangle: u32) -> [[f64; 2]; 3] {
    plane.triangles[triangle as usize].map(|corner| points[corner as usize])
}

fn middle(points: &[[f64; 2]], plane: &Plane, star: &[u32], weights: &[f64]) -> Option<[f64; 2]> {
    let (mut sum, mut total) = ([0.0; 2], 0.0);
    for &triangle in star {
        let places = corners(points, plane, triangle);
        let weight = area(places) * weights[triangle as usize];
        for i in 0..2 {
            sum[i] += weight * (places[0][i] + places[1][i] + places[2][i]) / 3.0;
        }
        total += weight;
    }
    (total > 0.0).then(|| sum.map(|c| c / total))
}

/// Smallest area of a star by the square of the longest side: 0.43 for equilateral triangles.
fn worst(points: &[[f64; 2]], plane: &Plane, star: &[u32]) -> f64 {
    let shape = |&triangle: &u32| {
        let places = corners(points, plane, triangle);
        let side = |i: usize, j: usize| (places[i][0] - places[j][0]).powi(2) + (places[i][1] - places[j][1]).powi(2);
        area(places) / side(0, 1).max(side(1, 2)).max(side(2, 0))
    };
    star.iter().map(shape).fold(f64::INFINITY, f64::min)
}
