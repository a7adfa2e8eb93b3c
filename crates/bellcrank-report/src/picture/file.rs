//! A canvas as a PNG file (ISO/IEC 15948).

use std::io::Write;

use flate2::write::ZlibEncoder;
use flate2::{Compression, Crc};

use super::canvas::Canvas;

/// The bytes of the file. Even colours between sharp lines pack best without a filter: against the best filter of
/// each line half the time and four fifths of the size.
pub(crate) fn png(canvas: &Canvas) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let [width, height] = [canvas.width, canvas.height].map(|pixels| (pixels as u32).to_be_bytes());
    // Eight bits, red green blue, the only ways to pack and filter, rows from top to bottom.
    chunk(&mut file, b"IHDR", &[&width[..], &height, &[8, 2, 0, 0, 0]].concat());
    chunk(&mut file, b"IDAT", &packed(canvas));
    chunk(&mut file, b"IEND", &[]);
    file
}

/// Rows, each behind the number of its filter.
fn packed(canvas: &Canvas) -> Vec<u8> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::new(3));
    for row in canvas.pixels.chunks(3 * canvas.width.max(1)) {
        encoder.write_all(&[0]).and_then(|()| encoder.write_all(row)).expect("memory takes every byte");
    }
    encoder.finish().expect("memory takes every byte")
}

fn chunk(file: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    let mut sum = Crc::new();
    sum.update(kind);
    sum.update(data);
    file.extend((data.len() as u32).to_be_bytes());
    file.extend(kind);
    file.extend(data);
    file.extend(sum.sum().to_be_bytes());
}
