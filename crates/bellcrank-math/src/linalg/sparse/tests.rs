use std::sync::Arc;

use super::*;

/// Numbers between -1 and 1, always the same.
pub(super) struct Numbers(pub(super) u64);

impl Numbers {
    pub(super) fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        ((self.0 >> 11) as f64 / (1_u64 << 53) as f64) * 2.0 - 1.0
    }

    fn below(&mut self, n: usize) -> usize {
        ((self.next() * 0.5 + 0.5) * n as f64) as usize % n
    }

    fn many(&mut self, n: usize) -> Vec<f64> {
        (0..n).map(|_| self.next()).collect()
    }
}

/// A matrix from its lower entries, summed where they meet.
pub(super) fn matrix(size: usize, entries: &[(usize, usize, f64)]) -> SymmetricMatrix {
    let mut columns = vec![std::collections::BTreeMap::new(); size];
    for (i, column) in columns.iter_mut().enumerate() {
        column.insert(i, 0.0);
    }
    for &(i, j, value) in entries {
        *columns[i.min(j)].entry(i.max(j)).or_insert(0.0) += value;
    }
    let mut matrix = SymmetricMatrix { size, starts: vec![0], ..SymmetricMatrix::default() };
    for column in &columns {
        matrix.rows.extend(column.keys().map(|&row| row as u32));
        matrix.values.extend(column.values());
        matrix.starts.push(matrix.rows.len());
    }
    matrix
}

/// Random entries, made positive definite by a dominant diagonal.
fn random(size: usize, entries: usize, numbers: &mut Numbers) -> SymmetricMatrix {
    let mut list = Vec::new();
    for _ in 0..entries {
        let (i, j, value) = (numbers.below(size), numbers.below(size), numbers.next());
        if i != j {
            list.extend([(i, j, value), (i, i, value.abs() + 0.01), (j, j, value.abs() + 0.01)]);
        }
    }
    list.extend((0..size).map(|i| (i, i, 0.1 + numbers.next().abs())));
    matrix(size, &list)
}

/// Largest |b - A x| over the largest |b|.
fn residual(matrix: &SymmetricMatrix, x: &[f64], b: &[f64]) -> f64 {
    let mut product = vec![0.0; b.len()];
    matrix.multiply(x, &mut product);
    let largest = |values: &mut dyn Iterator<Item = f64>| values.fold(0.0, |most: f64, v| most.max(v.abs()));
    largest(&mut product.iter().zip(b).map(|(p, b)| p - b)) / largest(&mut b.iter().copied())
}

pub(super) fn go_on(_: f64) -> bool {
    true
}

fn solve_and_check(matrix: &SymmetricMatrix, numbers: &mut Numbers) {
    let plan = Arc::new(Plan::new(matrix));
    for threads in [1, 2] {
        let factor = Cholesky::factor(plan.clone(), matrix, threads, &go_on).expect("positive definite");
        for count in [1, 3, 17] {
            let b = numbers.many(matrix.size * count);
            let mut x = b.clone();
            factor.solve(&mut x);
            assert!(residual(matrix, &x, &b) < 1e-12, "{} rows, {threads} threads, {count} sides", matrix.size);
        }
    }
}

#[test]
fn random_matrices_are_solved() {
    let mut numbers = Numbers(7);
    for size in [1, 2, 3, 5, 10, 40, 150, 700] {
        for density in [0, 1, 4, 12] {
            solve_and_check(&random(size, size * density, &mut numbers), &mut numbers);
        }
    }
}

/// Laplacian of a grid of n × n × m points with fixed surroundings, each point three times with a little coupling.
fn grid(n: usize, m: usize) -> SymmetricMatrix {
    let at = |x: usize, y: usize, z: usize, d: usize| ((x * n + y) * m + z) * 3 + d;
    let mut list = Vec::new();
    for (x, y, z) in (0..n * n * m).map(|k| (k / (n * m), k / m % n, k % m)) {
        for d in 0..3 {
            list.extend([(at(x, y, z, d), at(x, y, z, d), 6.5), (at(x, y, z, d), at(x, y, z, (d + 1) % 3), 0.1)]);
            for other in [(x + 1, y, z), (x, y + 1, z), (x, y, z + 1)] {
                if other.0 < n && other.1 < n && other.2 < m {
                    for e in 0..3 {
                        list.push((at(x, y, z, d), at(other.0, other.1, other.2, e), if d == e { -1.0 } else { 0.03 }));
                    }
                }
            }
        }
    }
    matrix(3 * n * n * m, &list)
}

#[test]
fn threads_do_not_change_a_bit() {
    let matrix = grid(13, 9);
    let plan = Arc::new(Plan::new(&matrix));
    let one = Cholesky::factor(plan.clone(), &matrix, 1, &go_on).expect("positive definite");
    for threads in [2, 3] {
        let more = Cholesky::factor(plan.clone(), &matrix, threads, &go_on).expect("positive definite");
        assert!(one.blocks == more.blocks);
    }
}

#[test]
fn a_second_factorization_in_the_same_memory_is_the_same() {
    let mut numbers = Numbers(3);
    let (first, mut second) = (grid(6, 5), grid(6, 5));
    second.values.iter_mut().for_each(|v| *v *= 1.0 + 0.01 * numbers.next().abs());
    let plan = Arc::new(Plan::new(&first));
    let fresh = Cholesky::factor(plan.clone(), &second, 1, &go_on).expect("positive definite");
    let mut again = Cholesky::factor(plan, &first, 1, &go_on).expect("positive definite");
    again.refactor(&second, 2, &go_on).expect("positive definite");
    assert!(fresh.blocks == again.blocks);
}

#[test]
fn a_row_without_stiffness_is_named() {
    let mut numbers = Numbers(11);
    for (size, row) in [(1, 0), (40, 17), (300, 299)] {
        let mut broken = random(size, 3 * size, &mut numbers);
        // The row loses its neighbours and its diagonal.
        for column in 0..size {
            for entry in broken.starts[column]..broken.starts[column + 1] {
                if column == row || broken.rows[entry] as usize == row {
                    broken.values[entry] = 0.0;
                }
            }
        }
        for threads in [1, 2] {
            let result = Cholesky::factor(Arc::new(Plan::new(&broken)), &broken, threads, &go_on);
            let Err(Failure::NotPositive(found)) = result else { panic!("a zero row was factored") };
            assert_eq!(found, NotPositive { row, pivot: 0.0, diagonal: 0.0 });
        }
    }
}

#[test]
fn a_factorization_stops_when_asked() {
    let matrix = grid(8, 8);
    let result = Cholesky::factor(Arc::new(Plan::new(&matrix)), &matrix, 2, &|share| share < 0.3);
    assert_eq!(result.err(), Some(Failure::Interrupted));
}
