//! Lists of integers as bytes that pack well.

use std::io::Write;

use flate2::Compression;
use flate2::write::GzEncoder;

/// Lists one after the other. Each holds differences from number to number, small ones of either sign near zero, all
/// low bytes first, then the next higher ones: what changes little becomes runs of zeros.
#[derive(Default)]
pub(crate) struct Integers {
    bytes: Vec<u8>,
}

impl Integers {
    /// Appends numbers of at most `width` bytes (1 to 4).
    pub(crate) fn push(&mut self, width: usize, numbers: impl Iterator<Item = u32>) {
        let shift = 32 - 8 * width;
        let mut before = 0;
        let step = |number: u32| {
            let difference = (number.wrapping_sub(before) << shift).cast_signed() >> shift;
            before = number;
            ((difference << 1) ^ (difference >> 31)).cast_unsigned()
        };
        let steps: Vec<u32> = numbers.map(step).collect();
        for plane in 0..width {
            self.bytes.extend(steps.iter().map(|step| (step >> (8 * plane)) as u8));
        }
    }

    /// Appends numbers in single precision, bit by bit as they are.
    pub(crate) fn push_floats(&mut self, numbers: impl Iterator<Item = f64>) {
        self.push(4, numbers.map(|number| (number as f32).to_bits()));
    }

    /// Appends signed numbers, in as many bytes each as the largest needs; gives how many. The middle of what the
    /// bytes hold stands for zero.
    pub(crate) fn push_signed(&mut self, numbers: &[i32]) -> usize {
        let most = numbers.iter().map(|number| number.unsigned_abs()).max().unwrap_or(0);
        let width = (1..4).find(|width| most < 1 << (8 * width - 1)).unwrap_or(4);
        let zero = 1_u32 << (8 * width - 1);
        self.push(width, numbers.iter().map(|number| zero.wrapping_add_signed(*number)));
        width
    }

    /// Everything as one gzip member.
    pub(crate) fn packed(&self) -> Vec<u8> {
        let mut encoder = GzEncoder::new(Vec::new(), Compression::new(6));
        encoder.write_all(&self.bytes).expect("memory takes every byte");
        encoder.finish().expect("memory takes every byte")
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// What the browser does.
    fn read(bytes: &[u8], width: usize) -> Vec<u32> {
        let count = bytes.len() / width;
        let mask = u32::MAX >> (32 - 8 * width);
        let mut before = 0_u32;
        let mut next = |k: usize| {
            let step = (0..width).fold(0, |sum, plane| sum | u32::from(bytes[plane * count + k]) << (8 * plane));
            let difference = (step >> 1) ^ (step & 1).wrapping_neg();
            before = before.wrapping_add(difference) & mask;
            before
        };
        (0..count).map(&mut next).collect()
    }

    #[test]
    fn signed_numbers_take_the_bytes_they_need() {
        for (width, numbers) in [
            (1, vec![0, -127, 127, 5]),
            (2, vec![-128, 3, 32_767]),
            (3, vec![40_000, -1]),
            (4, vec![i32::MAX, i32::MIN]),
        ] {
            let mut list = Integers::default();
            assert_eq!(list.push_signed(&numbers), width);
            let zero = 1_i64 << (8 * width - 1);
            let found: Vec<i64> = read(&list.bytes, width).into_iter().map(|step| i64::from(step) - zero).collect();
            assert_eq!(found, numbers.into_iter().map(i64::from).collect::<Vec<_>>());
        }
    }

    #[test]
    fn numbers_come_back() {
        for (width, numbers) in [
            (2, vec![0, 65535, 1, 40_000, 0]),
            (3, vec![1 << 20, 5, 0xff_ff_ff, 0]),
            (4, vec![u32::MAX, 0, 7, 1 << 31]),
        ] {
            let mut list = Integers::default();
            list.push(width, numbers.iter().copied());
            assert_eq!(read(&list.bytes, width), numbers);
        }
    }
}
