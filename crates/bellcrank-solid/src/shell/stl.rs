//! STL, the list of triangles that printers and viewers read.

use super::Surface;
use super::space::{cross, sub, unit};

/// A binary STL file; coordinates in m times `scale` (1000 for the mm that most programs take for granted).
pub fn write(surface: &Surface, scale: f64) -> Vec<u8> {
    let mut file = vec![0_u8; 80];
    file[..9].copy_from_slice(b"bellcrank");
    file.extend((surface.triangles.len() as u32).to_le_bytes());
    for triangle in &surface.triangles {
        let [a, b, c] = triangle.map(|node| surface.nodes[node as usize]);
        let normal = unit(cross(sub(b, a), sub(c, a)));
        let places = [a, b, c].map(|p| p.map(|x| x * scale));
        let numbers = normal.into_iter().chain(places.into_iter().flatten());
        numbers.for_each(|x| file.extend((x as f32).to_le_bytes()));
        file.extend([0_u8; 2]);
    }
    file
}
