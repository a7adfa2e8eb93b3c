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

/// Without a factorization: the same solution.
#[test]
fn conjugate_gradients_agree_with_the_factorization() {
    let mut numbers = Numbers(23);
    for matrix in [grid(7, 6), random(300, 1500, &mut numbers), random(1, 0, &mut numbers)] {
        let b = numbers.many(matrix.size);
        let mut direct = b.clone();
        Cholesky::factor(Arc::new(Plan::new(&matrix)), &matrix, 1, &go_on)
            .expect("positive definite")
            .solve(&mut direct);
        let mut x = numbers.many(matrix.size);
        let preconditioner = Incomplete::new(&matrix).expect("a positive diagonal");
        let accuracy = Accuracy { tolerance: 1e-12, iterations: 500 };
        let found = conjugate_gradients(&matrix, &preconditioner, &b, &mut x, accuracy, &go_on).expect("converges");
        assert!(found.residual <= 1e-12 && found.iterations < 100, "{found:?}");
        let largest = direct.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        assert!(x.iter().zip(&direct).all(|(x, d)| (x - d).abs() < 1e-9 * largest));
    }
}

#[test]
fn a_breakdown_of_the_incomplete_factor_is_met_by_a_shift() {
    // Kershaw (1978): positive definite, but what is dropped leaves a negative pivot.
    let entries =
        [(0, 0, 3.0), (1, 1, 3.0), (2, 2, 3.0), (3, 3, 3.0), (1, 0, -2.0), (3, 0, 2.0), (2, 1, -2.0), (3, 2, -2.0)];
    let matrix = matrix(4, &entries);
    let preconditioner = Incomplete::new(&matrix).expect("a positive diagonal");
    assert!(preconditioner.shift > 0.0);
    let (b, mut x) = ([0.3, -1.7, 2.9, 0.4], vec![0.0; 4]);
    let accuracy = Accuracy { tolerance: 1e-13, iterations: 20 };
    conjugate_gradients(&matrix, &preconditioner, &b, &mut x, accuracy, &go_on).expect("converges");
    assert!(residual(&matrix, &x, &b) < 1e-12);
}

#[test]
fn conjugate_gradients_say_why_they_stop() {
    let matrix = grid(6, 6);
    let preconditioner = Incomplete::new(&matrix).expect("a positive diagonal");
    let b = Numbers(2).many(matrix.size);
    let run = |iterations: usize, progress: Progress| {
        let accuracy = Accuracy { tolerance: 1e-10, iterations };
        conjugate_gradients(&matrix, &preconditioner, &b, &mut vec![0.0; matrix.size], accuracy, progress)
    };
    assert!(matches!(run(3, &go_on), Err(IterationFailure::Stagnated(Iterated { iterations: 3, .. }))));
    assert!(matches!(run(100, &|_| false), Err(IterationFailure::Interrupted(Iterated { iterations: 0, .. }))));
    let mut indefinite = matrix.clone();
    indefinite.values.iter_mut().for_each(|v| *v = if *v > 6.0 { 0.5 } else { *v });
    let start = Incomplete::new(&matrix).expect("a positive diagonal");
    let accuracy = Accuracy { tolerance: 1e-10, iterations: 100 };
    let result = conjugate_gradients(&indefinite, &start, &b, &mut vec![0.0; matrix.size], accuracy, &go_on);
    assert!(matches!(result, Err(IterationFailure::NotPositive(_))), "{result:?}");
}

/// Rows in an order that the dissection does not know give the same solution.
#[test]
fn renumbering_renumbers_the_solution() {
    let mut numbers = Numbers(41);
    let (size, original) = (200, random(200, 700, &mut numbers));
    let mut place: Vec<usize> = (0..size).collect();
    (1..size).rev().for_each(|i| place.swap(i, numbers.below(i + 1)));
    let columns = (0..size).flat_map(|c| (original.starts[c]..original.starts[c + 1]).map(move |e| (c, e)));
    let entries: Vec<_> =
        columns.map(|(c, e)| (place[original.rows[e] as usize], place[c], original.values[e])).collect();
    let (b, renumbered) = (numbers.many(size), matrix(size, &entries));
    let solve = |matrix: &SymmetricMatrix, mut b: Vec<f64>| {
        Cholesky::factor(Arc::new(Plan::new(matrix)), matrix, 1, &go_on).expect("positive definite").solve(&mut b);
        b
    };
    let mut moved = vec![0.0; size];
    (0..size).for_each(|i| moved[place[i]] = b[i]);
    let (x, y) = (solve(&original, b), solve(&renumbered, moved));
    assert!((0..size).all(|i| (x[i] - y[place[i]]).abs() < 1e-12 * (1.0 + x[i].abs())));
}

#[test]
fn special_patterns_are_solved() {
    let mut numbers = Numbers(59);
    let size = 400;
    // A full row; equal patterns; blocks without connection; all of them connected.
    let dense_row = (1..size).flat_map(|i| [(i, 0, 0.5), (i, i, 1.5), (0, 0, 1.0)]).collect::<Vec<_>>();
    let twins = (0..size)
        .flat_map(|i| [(i, i, 9.0), (i, i ^ 1, -1.1), (i, (i + 2) % size, 0.7), (i, ((i + 2) % size) ^ 1, 0.6)]);
    let apart = (0..size).flat_map(|i| [(i, i, 4.0), (i, i / 5 * 5, 0.3)]);
    let full = (0..60).flat_map(|i| (0..=i).map(move |j| (i, j, if i == j { 90.0 } else { 1.0 / (1 + i + j) as f64 })));
    for (size, entries) in
        [(size, dense_row), (size, twins.collect()), (size, apart.collect()), (60, full.collect::<Vec<_>>())]
    {
        solve_and_check(&matrix(size, &entries), &mut numbers);
    }
}

/// Products with several vectors at once are those with one.
#[test]
fn products_do_not_depend_on_how_many_there_are() {
    let mut numbers = Numbers(77);
    let matrix = random(50, 200, &mut numbers);
    let x = numbers.many(50 * 13);
    let mut together = vec![0.0; x.len()];
    matrix.multiply(&x, &mut together);
    for (x, y) in x.chunks_exact(50).zip(together.chunks_exact(50)) {
        let mut alone = vec![0.0; 50];
        matrix.multiply(x, &mut alone);
        assert!(alone.iter().zip(y).all(|(a, b)| (a - b).abs() < 1e-14 * (1.0 + a.abs())));
    }
}

/// A part that nothing holds beside one that is held: the row is one of the loose part's, whatever rounding leaves of its pivot.
#[test]
fn a_loose_part_is_found_in_spite_of_rounding() {
    let mut numbers = Numbers(97);
    for half in [5, 60, 900] {
        let mut list = vec![(0, 0, 1.3e7)];
        for i in 0..2 * half {
            // Each with its neighbours and some further on, in the same half.
            for step in [1, 2, 7] {
                let j = i + step;
                if j < 2 * half && i / half == j / half {
                    let k = 1e9 * (1.1 + numbers.next());
                    list.extend([(i, i, k), (j, j, k), (i, j, -k)]);
                }
            }
        }
        let matrix = matrix(2 * half, &list);
        for threads in [1, 2] {
            let result = Cholesky::factor(Arc::new(Plan::new(&matrix)), &matrix, threads, &go_on);
            let Err(Failure::NotPositive(found)) = result else { panic!("a loose part of {half} was factored") };
            assert!(found.row >= half && found.pivot.abs() < 1e-13 * found.diagonal, "{found:?}");
        }
    }
}
