//! Craig–Bampton reduction by published numbers and identities.

use bellcrank_fem::reduce::{self, natural_frequencies};

fn close(found: &[f64], expected: &[f64], bound: f64, what: &str) {
    assert!(found.len() >= expected.len(), "{what}: {found:?}");
    for (found, expected) in found.iter().zip(expected) {
        assert!((found / expected - 1.0).abs() < bound, "{what}: {found} {expected}");
    }
}

/// Stiffness and consistent mass of `count` equal Hermite beam elements; unknowns w, θ of each node.
fn hermite(ei: f64, mass: f64, length: f64, count: usize) -> (Vec<f64>, Vec<f64>) {
    let (h, size) = (length / count as f64, 2 * (count + 1));
    let k = [
        [12.0, 6.0 * h, -12.0, 6.0 * h],
        [6.0 * h, 4.0 * h * h, -6.0 * h, 2.0 * h * h],
        [-12.0, -6.0 * h, 12.0, -6.0 * h],
        [6.0 * h, 2.0 * h * h, -6.0 * h, 4.0 * h * h],
    ];
    let m = [
        [156.0, 22.0 * h, 54.0, -13.0 * h],
        [22.0 * h, 4.0 * h * h, 13.0 * h, -3.0 * h * h],
        [54.0, 13.0 * h, 156.0, -22.0 * h],
        [-13.0 * h, -3.0 * h * h, -22.0 * h, 4.0 * h * h],
    ];
    let (mut stiffness, mut masses) = (vec![0.0; size * size], vec![0.0; size * size]);
    for element in 0..count {
        for i in 0..4 {
            for j in 0..4 {
                let at = (2 * element + i) * size + 2 * element + j;
                stiffness[at] += ei / h.powi(3) * k[i][j];
                masses[at] += mass * h / 420.0 * m[i][j];
            }
        }
    }
    (stiffness, masses)
}

/// Without the rows and columns of the first two unknowns: the first end clamped.
fn clamped(matrix: &[f64]) -> Vec<f64> {
    let size = matrix.len().isqrt();
    let rows = matrix.chunks_exact(size).skip(2);
    rows.flat_map(|row| row[2..].to_vec()).collect()
}

/// Case F9: a beam of ten Hermite elements, reduced to its ends and 2, 4, 6 modes.
#[test]
fn f9_beam_of_ten_elements() {
    let (b, h): (f64, f64) = (0.05, 0.01);
    let (k, m) = hermite(2.1e11 * b * h.powi(3) / 12.0, 7850.0 * b * h, 1.0, 10);
    let fixed = [
        53.167_854_452_800_73,
        146.592_369_874_049_7,
        287.588_316_257_772_3,
        476.183_153_714_260_1,
        713.521_660_670_107_5,
        1_001.515_430_678_865_9,
    ];
    let free: [&[f64]; 3] = [
        &[53.357_979_020_513_28, 147.218_263_245_427_95, 484.165_831_092_948, 871.836_956_174_084_2],
        &[53.188_757_409_159_01, 146.713_045_144_193_13, 288.718_366_445_838_6, 477.665_807_635_853_3],
        &[53.171_752_872_210_5, 146.619_844_188_057_93, 287.876_693_474_862, 476.579_800_794_234_7],
    ];
    let cantilever: [&[f64]; 3] = [
        &[8.355_657_571_749_07, 52.419_257_590_534_1, 147.183_446_271_431_73, 596.671_684_121_541],
        &[8.355_216_251_651_262, 52.369_615_488_968_43, 146.747_053_240_507_4, 288.007_330_425_304_7],
        &[8.355_180_636_062_6, 52.364_037_565_427_324, 146.671_605_968_995_72, 287.692_043_252_376_2],
    ];
    let ends = [0, 1, 20, 21];
    for (place, count) in [2, 4, 6].into_iter().enumerate() {
        let reduced = reduce::reduce_matrices(&k, &m, &ends, count).unwrap();
        let found: Vec<f64> = reduced.eigenvalues.iter().map(|l| l.sqrt() / std::f64::consts::TAU).collect();
        close(&found, &fixed[..count], 1e-8, "fixed");
        close(&natural_frequencies(&reduced.stiffness, &reduced.mass)[2..], free[place], 1e-8, "free");
        let (kc, mc) = (clamped(&reduced.stiffness), clamped(&reduced.mass));
        close(&natural_frequencies(&kc, &mc), cantilever[place], 1e-8, "cantilever");
        let size = 4 + count;
        let block = |of: &[f64]| [of[0], of[1], of[2], of[3], of[size + 1], of[2 * size + 2], of[2 * size + 3]];
        close(
            &block(&reduced.stiffness),
            &[10_500.0, 5_250.0, -10_500.0, 5_250.0, 3_500.0, 10_500.0, -5_250.0],
            1e-8,
            "K",
        );
        let mass = [
            1.457_857_142_857_112,
            0.205_595_238_095_232_53,
            0.504_642_857_142_836_6,
            -0.121_488_095_238_090_91,
            0.037_380_952_380_951_38,
            1.457_857_142_857_112,
            -0.205_595_238_095_236_03,
        ];
        close(&block(&reduced.mass), &mass, 1e-8, "M");
    }
}
