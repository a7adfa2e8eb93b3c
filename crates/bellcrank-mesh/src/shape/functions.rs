//! Shape functions and their derivatives (e.g. Zienkiewicz, Taylor & Zhu, "The Finite Element Method: Its Basis and
//! Fundamentals", 6th ed., chapter 4).

use super::Shape;

pub(super) const HEX: [[f64; 3]; 8] = [
    [-1.0, -1.0, -1.0],
    [1.0, -1.0, -1.0],
    [1.0, 1.0, -1.0],
    [-1.0, 1.0, -1.0],
    [-1.0, -1.0, 1.0],
    [1.0, -1.0, 1.0],
    [1.0, 1.0, 1.0],
    [-1.0, 1.0, 1.0],
];

pub(super) fn evaluate(shape: Shape, at: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    match shape {
        Shape::Tet4 => tet4(at, n, d),
        Shape::Tet10 => tet10(at, n, d),
        Shape::Wedge6 => wedge6(at, n, d),
        Shape::Wedge15 => wedge15(at, n, d),
        Shape::Hex8 => hex8(at, n, d),
        Shape::Hex20 => hex20(at, n, d),
    }
}

const TET: [[f64; 3]; 4] = [[-1.0, -1.0, -1.0], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];

fn tet4([r, s, t]: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    n[..4].copy_from_slice(&[1.0 - r - s - t, r, s, t]);
    d[..4].copy_from_slice(&TET);
}

fn tet10([r, s, t]: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    let l = [1.0 - r - s - t, r, s, t];
    for k in 0..4 {
        n[k] = l[k] * (2.0 * l[k] - 1.0);
        d[k] = TET[k].map(|g| g * (4.0 * l[k] - 1.0));
    }
    for (k, [a, b]) in Shape::Tet10.edges().iter().map(|ends| ends.map(usize::from)).enumerate() {
        n[4 + k] = 4.0 * l[a] * l[b];
        d[4 + k] = std::array::from_fn(|i| 4.0 * (TET[a][i] * l[b] + l[a] * TET[b][i]));
    }
}

const TRIANGLE: [[f64; 2]; 3] = [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0]];

fn wedge6([r, s, z]: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    let l = [1.0 - r - s, r, s];
    for k in 0..6 {
        let (i, side) = (k % 3, if k < 3 { -1.0 } else { 1.0 });
        let height = (1.0 + side * z) / 2.0;
        n[k] = l[i] * height;
        d[k] = [TRIANGLE[i][0] * height, TRIANGLE[i][1] * height, l[i] * side / 2.0];
    }
}

fn wedge15([r, s, z]: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    let l = [1.0 - r - s, r, s];
    let bubble = 1.0 - z * z;
    for k in 0..6 {
        let (i, side) = (k % 3, if k < 3 { -1.0 } else { 1.0 });
        let height = 1.0 + side * z;
        n[k] = l[i] * ((2.0 * l[i] - 1.0) * height - bubble) / 2.0;
        let by_l = ((4.0 * l[i] - 1.0) * height - bubble) / 2.0;
        let by_z = l[i] * ((2.0 * l[i] - 1.0) * side + 2.0 * z) / 2.0;
        d[k] = [TRIANGLE[i][0] * by_l, TRIANGLE[i][1] * by_l, by_z];
    }
    for k in 0..6 {
        let (i, side) = (k % 3, if k < 3 { -1.0 } else { 1.0 });
        let (j, height) = ((i + 1) % 3, 1.0 + side * z);
        n[6 + k] = 2.0 * l[i] * l[j] * height;
        let by = |c: usize| 2.0 * height * (TRIANGLE[i][c] * l[j] + l[i] * TRIANGLE[j][c]);
        d[6 + k] = [by(0), by(1), 2.0 * l[i] * l[j] * side];
    }
    for i in 0..3 {
        n[12 + i] = l[i] * bubble;
        d[12 + i] = [TRIANGLE[i][0] * bubble, TRIANGLE[i][1] * bubble, -2.0 * z * l[i]];
    }
}

fn hex8(at: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    for (k, corner) in HEX.into_iter().enumerate() {
        let f: [f64; 3] = std::array::from_fn(|i| 1.0 + at[i] * corner[i]);
        n[k] = f[0] * f[1] * f[2] / 8.0;
        d[k] = [corner[0] * f[1] * f[2] / 8.0, corner[1] * f[0] * f[2] / 8.0, corner[2] * f[0] * f[1] / 8.0];
    }
}

fn hex20(at: [f64; 3], n: &mut [f64], d: &mut [[f64; 3]]) {
    for (k, corner) in HEX.into_iter().enumerate() {
        let p: [f64; 3] = std::array::from_fn(|i| at[i] * corner[i]);
        let f = p.map(|x| 1.0 + x);
        let sum = p[0] + p[1] + p[2] - 2.0;
        n[k] = f[0] * f[1] * f[2] * sum / 8.0;
        d[k] = std::array::from_fn(|i| {
            let others = f[(i + 1) % 3] * f[(i + 2) % 3];
            corner[i] * others * (sum + f[i]) / 8.0
        });
    }
    for (k, ends) in Shape::Hex20.edges().iter().enumerate() {
        let [a, b] = ends.map(|corner| HEX[corner as usize]);
        let along = (0..3).find(|&i| a[i] != b[i]).unwrap_or(0);
        let (u, v) = ((along + 1) % 3, (along + 2) % 3);
        let (fu, fv) = (1.0 + at[u] * a[u], 1.0 + at[v] * a[v]);
        let bubble = 1.0 - at[along] * at[along];
        n[8 + k] = bubble * fu * fv / 4.0;
        d[8 + k][along] = -at[along] * fu * fv / 2.0;
        d[8 + k][u] = bubble * a[u] * fv / 4.0;
        d[8 + k][v] = bubble * fu * a[v] / 4.0;
    }
}
