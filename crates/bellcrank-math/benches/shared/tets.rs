//! The pattern of ten-node tetrahedra, six a cube of a grid, with numbers that make a positive definite matrix.

use bellcrank_math::linalg::sparse::SymmetricMatrix;

/// Axis of each step from one corner of a cube to the opposite one: a tetrahedron each (Kuhn's subdivision).
const PATHS: [[usize; 3]; 6] = [[0, 1, 2], [0, 2, 1], [1, 0, 2], [1, 2, 0], [2, 0, 1], [2, 1, 0]];

/// Three unknowns a node, the nodes corners and middles of edges.
pub(crate) fn tets(cells: [usize; 3]) -> SymmetricMatrix {
    let sides = cells.map(|n| 2 * n + 1);
    let number = |at: [usize; 3]| (at[0] * sides[1] + at[1]) * sides[2] + at[2];
    let mut later = vec![Vec::new(); sides.iter().product()];
    for cell in 0..cells.iter().product() {
        let at = [cell / (cells[1] * cells[2]), cell / cells[2] % cells[1], cell % cells[2]];
        for path in PATHS {
            let nodes = nodes(at, path).map(number);
            for a in nodes {
                later[a].extend(nodes.iter().filter(|&&b| b >= a));
            }
        }
    }
    later.iter_mut().for_each(|list: &mut Vec<usize>| {
        list.sort_unstable();
        list.dedup();
    });
    blocks(&later)
}

fn nodes(cell: [usize; 3], path: [usize; 3]) -> [[usize; 3]; 10] {
    let mut corners = [cell.map(|c| 2 * c); 4];
    for k in 0..3 {
        corners[k + 1] = corners[k];
        corners[k + 1][path[k]] += 2;
    }
    let middle = |a: usize, b: usize| std::array::from_fn(|i| corners[a][i].midpoint(corners[b][i]));
    let [a, b, c, d] = corners;
    [a, b, c, d, middle(0, 1), middle(0, 2), middle(0, 3), middle(1, 2), middle(1, 3), middle(2, 3)]
}

fn blocks(later: &[Vec<usize>]) -> SymmetricMatrix {
    let mut degree = vec![0.0; later.len()];
    for (a, list) in later.iter().enumerate() {
        list.iter().filter(|&&b| b != a).for_each(|&b| {
            degree[a] += 1.0;
            degree[b] += 1.0;
        });
    }
    let mut matrix = SymmetricMatrix { size: 3 * later.len(), starts: vec![0], ..SymmetricMatrix::default() };
    for column in 0..matrix.size {
        let node = column / 3;
        for row in later[node].iter().flat_map(|&b| 3 * b..3 * b + 3).filter(|&row| row >= column) {
            matrix.rows.push(row as u32);
            let own = if row == column { 1.2 * degree[node] + 1e-3 } else { 0.0 };
            matrix.values.push(
                own + if row % 3 != column % 3 {
                    0.1
                } else if row / 3 != node {
                    -1.0
                } else {
                    0.0
                },
            );
        }
        matrix.starts.push(matrix.rows.len());
    }
    matrix
}
