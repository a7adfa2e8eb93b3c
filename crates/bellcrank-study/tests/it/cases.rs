//! Test problems of the literature with their published optima.
//!
//! `HSnn`: W. Hock and K. Schittkowski, *Test Examples for Nonlinear Programming Codes*, 1981; starts and optima also in
//! `verification/cases/O1_nlp.json`. CB2, CB3: C. Charalambous and A. Conn, SIAM J. Numer. Anal. 15 (1978) 162. DM: V.
//! Dem'yanov and V. Malozemov. Optima of the minimax problems as in L. Lukšan and J. Vlček, *Test problems for nonsmooth
//! unconstrained and linearly constrained optimization*, report 798, 2000.

use std::f64::consts::SQRT_2;

use bellcrank_study::nlp::{Evaluation, Function, Problem, Relation, Undefined};

use crate::jet::Jet;

type Functions = fn(&[Jet]) -> (Vec<Jet>, Vec<Jet>);

/// A problem: objective pieces and constraints as functions of jets.
#[derive(Clone)]
pub(crate) struct Case {
    pub(crate) name: &'static str,
    pub(crate) start: Vec<f64>,
    pub(crate) bounds: Vec<(f64, f64)>,
    pub(crate) relations: Vec<Relation>,
    functions: Functions,
    /// Published optimum.
    pub(crate) optimum: f64,
    pub(crate) calls: usize,
}

impl Problem for Case {
    fn variables(&self) -> usize {
        self.start.len()
    }
    fn bounds(&self) -> &[(f64, f64)] {
        &self.bounds
    }
    fn relations(&self) -> &[Relation] {
        &self.relations
    }
    fn evaluate(&mut self, x: &[f64]) -> Result<Evaluation, Undefined> {
        self.calls += 1;
        assert!(x.iter().zip(&self.bounds).all(|(x, b)| *x >= b.0 && *x <= b.1), "{}: {x:?} outside", self.name);
        let (objective, constraints) = (self.functions)(&Jet::variables(x));
        let n = x.len();
        let function = |jets: &[Jet]| Function {
            pieces: jets
                .iter()
                .map(|j| bellcrank_study::nlp::Piece { value: j.v, gradient: j.d[..n].to_vec() })
                .collect(),
        };
        let constraints = constraints.iter().map(|c| function(&[*c])).collect();
        Ok(Evaluation { objective: function(&objective), constraints })
    }
}

const FREE: (f64, f64) = (f64::NEG_INFINITY, f64::INFINITY);
const POSITIVE: (f64, f64) = (0.0, f64::INFINITY);

fn case(name: &'static str, start: &[f64], bounds: &[(f64, f64)], relations: &str, optimum: f64, f: Functions) -> Case {
    let relations = relations.chars().map(|c| if c == '=' { Relation::Zero } else { Relation::AtMostZero }).collect();
    Case { name, start: start.to_vec(), bounds: bounds.to_vec(), relations, functions: f, optimum, calls: 0 }
}

fn squares(x: &[Jet]) -> Jet {
    x.iter().fold(Jet::constant(0.0), |sum, x| sum + *x * *x)
}

/// All cases.
pub(crate) fn all() -> Vec<Case> {
    let mut cases = smooth();
    cases.extend(engineering());
    cases.extend(minimax());
    cases
}

pub(crate) fn by_name(name: &str) -> Case {
    all().into_iter().find(|case| case.name == name).unwrap()
}

fn smooth() -> Vec<Case> {
    vec![
        case("HS06", &[-1.2, 1.0], &[FREE; 2], "=", 0.0, |x| {
            (vec![(1.0 - x[0]).powi(2)], vec![10.0 * (x[1] - x[0] * x[0])])
        }),
        case("HS07", &[2.0, 2.0], &[FREE; 2], "=", -(3f64.sqrt()), |x| {
            let s = 1.0 + x[0] * x[0];
            (vec![s.ln() - x[1]], vec![s * s + x[1] * x[1] - 4.0])
        }),
        case("HS21", &[-1.0, -1.0], &[(2.0, 50.0), (-50.0, 50.0)], "<", -99.96, |x| {
            (vec![0.01 * x[0] * x[0] + x[1] * x[1] - 100.0], vec![10.0 - 10.0 * x[0] + x[1]])
        }),
        case("HS24", &[1.0, 0.5], &[POSITIVE; 2], "<<<", -1.0, |x| {
            let r = 3f64.sqrt();
            let f = ((x[0] - 3.0).powi(2) - 9.0) * x[1].powi(3) / (27.0 * r);
            (vec![f], vec![x[1] - x[0] / r, -x[0] - r * x[1], x[0] + r * x[1] - 6.0])
        }),
        case("HS28", &[-4.0, 1.0, 1.0], &[FREE; 3], "=", 0.0, |x| {
            ((vec![(x[0] + x[1]).powi(2) + (x[1] + x[2]).powi(2)]), vec![x[0] + 2.0 * x[1] + 3.0 * x[2] - 1.0])
        }),
        case("HS35", &[0.5; 3], &[POSITIVE; 3], "<", 1.0 / 9.0, |x| {
            let linear = 9.0 - 8.0 * x[0] - 6.0 * x[1] - 4.0 * x[2];
            let square = 2.0 * x[0] * x[0] + 2.0 * x[1] * x[1] + x[2] * x[2];
            (vec![linear + square + 2.0 * x[0] * (x[1] + x[2])], vec![x[0] + x[1] + 2.0 * x[2] - 3.0])
        }),
        case("HS39", &[2.0; 4], &[FREE; 4], "==", -1.0, |x| {
            (vec![-x[0]], vec![x[1] - x[0].powi(3) - x[2] * x[2], x[0] * x[0] - x[1] - x[3] * x[3]])
        }),
        case("HS40", &[0.8; 4], &[FREE; 4], "===", -0.25, |x| {
            let c = vec![x[0].powi(3) + x[1] * x[1] - 1.0, x[0] * x[0] * x[3] - x[2], x[3] * x[3] - x[1]];
            (vec![-x[0] * x[1] * x[2] * x[3]], c)
        }),
        // Rosen-Suzuki.
        case("HS43", &[0.0; 4], &[FREE; 4], "<<<", -44.0, |x| {
            let f =
                squares(&x[..2]) + 2.0 * x[2] * x[2] + x[3] * x[3] - 5.0 * x[0] - 5.0 * x[1] - 21.0 * x[2] + 7.0 * x[3];
            let c1 = squares(x) + x[0] - x[1] + x[2] - x[3] - 8.0;
            let c2 = squares(x) + x[1] * x[1] + x[3] * x[3] - x[0] - x[3] - 10.0;
            let c3 = squares(&x[..3]) + x[0] * x[0] + 2.0 * x[0] - x[1] - x[3] - 5.0;
            (vec![f], vec![c1, c2, c3])
        }),
        case("HS63", &[2.0; 3], &[POSITIVE; 3], "==", 961.715_172_1, |x| {
            let f = 1000.0 - x[0] * x[0] - 2.0 * x[1] * x[1] - x[2] * x[2] - x[0] * x[1] - x[0] * x[2];
            (vec![f], vec![8.0 * x[0] + 14.0 * x[1] + 7.0 * x[2] - 56.0, squares(x) - 25.0])
        }),
        case("HS65", &[-5.0, 5.0, 0.0], &[(-4.5, 4.5), (-4.5, 4.5), (-5.0, 5.0)], "<", 0.953_528_856_7, |x| {
            let f = (x[0] - x[1]).powi(2) + (x[0] + x[1] - 10.0).powi(2) / 9.0 + (x[2] - 5.0).powi(2);
            (vec![f], vec![squares(x) - 48.0])
        }),
        case("HS71", &[1.0, 5.0, 5.0, 1.0], &[(1.0, 5.0); 4], "<=", 17.014_017_3, |x| {
            let c = vec![25.0 - x[0] * x[1] * x[2] * x[3], squares(x) - 40.0];
            (vec![x[0] * x[3] * (x[0] + x[1] + x[2]) + x[2]], c)
        }),
        case("HS76", &[0.5; 4], &[POSITIVE; 4], "<<<", -4.681_818_181, |x| {
            let square = x[0] * x[0] + 0.5 * x[1] * x[1] + x[2] * x[2] + 0.5 * x[3] * x[3];
            let f = square - x[0] * x[2] + x[2] * x[3] - x[0] - 3.0 * x[1] + x[2] - x[3];
            let c1 = x[0] + 2.0 * x[1] + x[2] + x[3] - 5.0;
            (vec![f], vec![c1, 3.0 * x[0] + x[1] + 2.0 * x[2] - x[3] - 4.0, 1.5 - x[1] - 4.0 * x[2]])
        }),
        case("HS77", &[2.0; 5], &[FREE; 5], "==", 0.241_505_13, |x| {
            let f = (x[0] - 1.0).powi(2) + (x[0] - x[1]).powi(2) + (x[2] - 1.0).powi(2);
            let f = f + (x[3] - 1.0).powi(4) + (x[4] - 1.0).powi(6);
            let c1 = x[0] * x[0] * x[3] + (x[3] - x[4]).sin() - 2.0 * SQRT_2;
            (vec![f], vec![c1, x[1] + x[2].powi(4) * x[3] * x[3] - 8.0 - SQRT_2])
        }),
        case("HS78", &[-2.0, 1.5, 2.0, -1.0, -1.0], &[FREE; 5], "===", -2.919_700_41, |x| {
            let c = vec![squares(x) - 10.0, x[1] * x[2] - 5.0 * x[3] * x[4], x[0].powi(3) + x[1].powi(3) + 1.0];
            (vec![x[0] * x[1] * x[2] * x[3] * x[4]], c)
        }),
        // Heat exchangers, badly scaled; the book's 7049.330923 is not the optimum.
        case(
            "HS106",
            &[5000.0, 5000.0, 5000.0, 200.0, 350.0, 150.0, 225.0, 425.0],
            &HS106,
            "<<<<<<",
            7_049.248_020_5,
            |x| {
                let c4 = 833.33252 * x[3] + 100.0 * x[0] - x[0] * x[5] - 83333.333;
                let c5 = 1250.0 * (x[4] - x[3]) - x[1] * (x[6] - x[3]);
                let c6 = 1_250_000.0 - 2500.0 * x[4] - x[2] * (x[7] - x[4]);
                let c1 = 0.0025 * (x[3] + x[5]) - 1.0;
                let c2 = 0.0025 * (x[4] + x[6] - x[3]) - 1.0;
                (vec![x[0] + x[1] + x[2]], vec![c1, c2, 0.01 * (x[7] - x[4]) - 1.0, c4, c5, c6])
            },
        ),
        case("HS100", &[1.0, 2.0, 0.0, 4.0, 0.0, 1.0, 1.0], &[FREE; 7], "<<<<", 680.630_057_3, hs100),
    ]
}

const HS106: [(f64, f64); 8] =
    [(100.0, 1e4), (1e3, 1e4), (1e3, 1e4), (10.0, 1e3), (10.0, 1e3), (10.0, 1e3), (10.0, 1e3), (10.0, 1e3)];

fn hs100(x: &[Jet]) -> (Vec<Jet>, Vec<Jet>) {
    let f = (x[0] - 10.0).powi(2) + 5.0 * (x[1] - 12.0).powi(2) + x[2].powi(4) + 3.0 * (x[3] - 11.0).powi(2);
    let f = f + 10.0 * x[4].powi(6) + 7.0 * x[5] * x[5] + x[6].powi(4);
    let f = f - 4.0 * x[5] * x[6] - 10.0 * x[5] - 8.0 * x[6];
    let c1 = 2.0 * x[0] * x[0] + 3.0 * x[1].powi(4) + x[2] + 4.0 * x[3] * x[3] + 5.0 * x[4] - 127.0;
    let c2 = 7.0 * x[0] + 3.0 * x[1] + 10.0 * x[2] * x[2] + x[3] - x[4] - 282.0;
    let c3 = 23.0 * x[0] + x[1] * x[1] + 6.0 * x[5] * x[5] - 8.0 * x[6] - 196.0;
    let c4 = 4.0 * x[0] * x[0] + x[1] * x[1] - 3.0 * x[0] * x[1] + 2.0 * x[2] * x[2] + 5.0 * x[5] - 11.0 * x[6];
    (vec![f], vec![c1, c2, c3, c4])
}

fn engineering() -> Vec<Case> {
    // Arora's tension spring: wire, coil, turns.
    let bounds = [(0.05, 2.0), (0.25, 1.3), (2.0, 15.0)];
    vec![case("TENSION_SPRING", &[0.06, 0.5, 8.0], &bounds, "<<<<", 0.012_665_232_8, |x| {
        let (d, c, n) = (x[0], x[1], x[2]);
        let shear = (4.0 * c * c - d * c) / (12566.0 * (c * d.powi(3) - d.powi(4)));
        let limits = vec![
            1.0 - c.powi(3) * n / (71785.0 * d.powi(4)),
            shear + 1.0 / (5108.0 * d * d) - 1.0,
            1.0 - 140.45 * d / (c * c * n),
            (d + c) / 1.5 - 1.0,
        ];
        (vec![(n + 2.0) * c * d * d], limits)
    })]
}

fn minimax() -> Vec<Case> {
    vec![
        case("CB2", &[1.0, -0.1], &[FREE; 2], "", 1.952_224_494, |x| {
            let f1 = x[0] * x[0] + x[1].powi(4);
            (vec![f1, (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2), 2.0 * (x[1] - x[0]).exp()], vec![])
        }),
        case("CB3", &[2.0, 2.0], &[FREE; 2], "", 2.0, |x| {
            let f1 = x[0].powi(4) + x[1] * x[1];
            (vec![f1, (2.0 - x[0]).powi(2) + (2.0 - x[1]).powi(2), 2.0 * (x[1] - x[0]).exp()], vec![])
        }),
        case("DEM", &[1.0, 1.0], &[FREE; 2], "", -3.0, |x| {
            (vec![5.0 * x[0] + x[1], -5.0 * x[0] + x[1], squares(x) + 4.0 * x[1]], vec![])
        }),
        case("QL", &[-1.0, 5.0], &[FREE; 2], "", 7.2, |x| {
            let f1 = squares(x);
            let f2 = f1 + 10.0 * (-4.0 * x[0] - x[1] + 4.0);
            (vec![f1, f2, f1 + 10.0 * (-x[0] - 2.0 * x[1] + 6.0)], vec![])
        }),
        // Rosen-Suzuki as an exact penalty function.
        case("ROSEN", &[0.0; 4], &[FREE; 4], "", -44.0, |x| {
            let (f, c) = (by_name_functions("HS43"))(x);
            (vec![f[0], f[0] + 10.0 * c[0], f[0] + 10.0 * c[1], f[0] + 10.0 * c[2]], vec![])
        }),
    ]
}

fn by_name_functions(name: &str) -> Functions {
    smooth().into_iter().find(|case| case.name == name).unwrap().functions
}
