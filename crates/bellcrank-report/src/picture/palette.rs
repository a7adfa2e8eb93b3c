//! Colours by number: ordered by lightness or about a neutral middle, and safe for colour-blind readers.

use super::scale::Scale;

pub(crate) type Rgb = [u8; 3];

/// What lies above the end of the colours.
pub(crate) const ABOVE: Rgb = [0xd6, 0x1c, 0x8c];
/// Where there is no number.
pub(crate) const NONE: Rgb = [0xb4, 0xbb, 0xc2];

/// Colours of a scale from its low to its high end, 33 stops as `0xrrggbb`.
pub(crate) type Stops = [u32; 33];

/// Viridis (Smith and van der Walt, CC0) without its darkest eighth, on which no line is seen: dark to light, for
/// numbers of one sign.
pub(crate) const SEQUENTIAL: Stops = [
    0x47_2e_7c, 0x45_37_81, 0x42_3f_85, 0x3f_47_88, 0x3c_4f_8a, 0x39_56_8c, 0x35_5e_8d, 0x32_65_8e, 0x2f_6b_8e,
    0x2c_71_8e, 0x2a_78_8e, 0x27_7f_8e, 0x25_85_8e, 0x22_8c_8d, 0x20_92_8c, 0x1f_99_8a, 0x1f_a0_88, 0x21_a6_85,
    0x26_ad_81, 0x2e_b3_7c, 0x38_b9_77, 0x44_bf_70, 0x52_c5_69, 0x60_ca_60, 0x70_cf_57, 0x81_d3_4d, 0x93_d7_41,
    0xa5_db_36, 0xb8_de_29, 0xca_e1_1f, 0xdd_e3_18, 0xef_e5_1c, 0xfd_e7_25,
];

/// Blue to red through grey (Moreland 2009): for numbers of both signs, zero in the middle.
pub(crate) const DIVERGING: Stops = [
    0x3b_4c_c0, 0x44_5a_cc, 0x4e_68_d8, 0x58_75_e1, 0x62_82_ea, 0x6c_8f_f1, 0x77_9a_f7, 0x82_a6_fb, 0x8d_b0_fe,
    0x98_b9_ff, 0xa3_c2_fe, 0xae_c9_fc, 0xb9_d0_f9, 0xc3_d5_f4, 0xcc_d9_ed, 0xd5_db_e5, 0xdd_dc_dc, 0xe5_d8_d1,
    0xec_d3_c5, 0xf1_cc_b8, 0xf5_c4_ac, 0xf7_ba_9f, 0xf7_b0_93, 0xf6_a5_86, 0xf4_98_7a, 0xf0_8b_6e, 0xeb_7d_62,
    0xe4_6e_56, 0xdd_5f_4b, 0xd4_4e_41, 0xca_3b_37, 0xbe_24_2e, 0xb4_04_26,
];

/// The colour at `share` of the way from low to high.
pub(crate) fn at(stops: &Stops, share: f64) -> Rgb {
    let place = share.clamp(0.0, 1.0) * 32.0;
    let index = (place as usize).min(31);
    let part = place - index as f64;
    let mix = |a: u8, b: u8| (f64::from(a) + part * (f64::from(b) - f64::from(a))).round() as u8;
    let (low, high) = (rgb(stops[index]), rgb(stops[index + 1]));
    std::array::from_fn(|k| mix(low[k], high[k]))
}

fn rgb(colour: u32) -> Rgb {
    let [_, r, g, b] = colour.to_be_bytes();
    [r, g, b]
}

/// Colours of a scale looked up by value: quick for millions of pixels.
pub(crate) struct Lookup {
    low: f32,
    per: f32,
    ceiling: f32,
    colours: Vec<Rgb>,
}

impl Lookup {
    pub(crate) fn new(scale: &Scale) -> Self {
        let stops = if scale.signed { &DIVERGING } else { &SEQUENTIAL };
        let bands = scale.bands();
        let colours = (0..bands).map(|band| at(stops, scale.share(band))).collect();
        let ceiling = if scale.is_cut() { scale.high as f32 } else { f32::INFINITY };
        Self { low: scale.low as f32, per: (1.0 / scale.step) as f32, ceiling, colours }
    }

    /// The colour of `value`, display units.
    pub(crate) fn colour(&self, value: f32) -> Rgb {
        if value.is_nan() || self.colours.is_empty() {
            return NONE;
        }
        if value > self.ceiling {
            return ABOVE;
        }
        let band = ((value - self.low) * self.per).max(0.0) as usize;
        self.colours[band.min(self.colours.len() - 1)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_ends_and_the_middle_are_the_stops() {
        assert_eq!(at(&SEQUENTIAL, 0.0), [0x47, 0x2e, 0x7c]);
        assert_eq!(at(&SEQUENTIAL, 1.0), [0xfd, 0xe7, 0x25]);
        assert_eq!(at(&DIVERGING, 0.5), [0xdd, 0xdc, 0xdc]);
        assert_eq!(at(&DIVERGING, 7.0), [0xb4, 0x04, 0x26]);
    }

    #[test]
    fn lightness_rises_along_the_sequential_colours() {
        let lightness = |k: u32| {
            let [r, g, b] = at(&SEQUENTIAL, f64::from(k) / 64.0).map(f64::from);
            0.2126 * r + 0.7152 * g + 0.0722 * b
        };
        assert!((0..64).all(|k| lightness(k) < lightness(k + 1)));
    }
}
