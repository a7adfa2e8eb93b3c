//! The same mesh, supports and loads in CalculiX: displacements and stresses agree to the digits that it prints.

use std::fmt::Write as _;
use std::path::Path;
use std::process::Command;

use bellcrank_fem::{Free, Load, Material, Part, Settings, Six, Statics, Support, stress};
use bellcrank_mesh::{Mesh, Shape};

use crate::grids;

const YOUNG: f64 = 2.07e11;
const POISSON: f64 = 0.28;
const GRAVITY: [f64; 3] = [2.0, -7.0, -5.0];

/// What CalculiX says: displacements by node and stresses by element.
struct Answer {
    displacement: Vec<[f64; 3]>,
    stress: Vec<Vec<Six>>,
}

fn deck(mesh: &Mesh, fixed: &[u32], loaded: &[u32], force: [f64; 3]) -> String {
    let mut text = String::new();
    // A field has 20 characters at most.
    text.push_str("*NODE, NSET=NALL\n");
    for (index, at) in mesh.nodes.iter().enumerate() {
        let _ = writeln!(text, "{}, {:.12e}, {:.12e}, {:.12e}", index + 1, at[0], at[1], at[2]);
    }
    let block = &mesh.blocks[0];
    let _ = writeln!(text, "*ELEMENT, TYPE={}, ELSET=EALL", block.shape.abaqus());
    for (index, element) in block.elements().enumerate() {
        let labels: Vec<String> = element.iter().map(|node| (node + 1).to_string()).collect();
        // Sixteen entries a line at most.
        let _ = writeln!(
            text,
            "{}, {}",
            index + 1,
            labels[..labels.len().min(15)].join(", ") + if labels.len() > 15 { "," } else { "" }
        );
        if labels.len() > 15 {
            let _ = writeln!(text, "{}", labels[15..].join(", "));
        }
    }
    let _ = write!(
        text,
        "*MATERIAL, NAME=M\n*ELASTIC\n{YOUNG:e}, {POISSON}\n*DENSITY\n7850.\n*SOLID SECTION, ELSET=EALL, MATERIAL=M\n*BOUNDARY\n"
    );
    for node in fixed {
        let _ = writeln!(text, "{}, 1, 3, 0.", node + 1);
    }
    text.push_str("*STEP\n*STATIC\n*CLOAD\n");
    for node in loaded {
        for (axis, force) in force.iter().enumerate() {
            let _ = writeln!(text, "{}, {}, {force:.12e}", node + 1, axis + 1);
        }
    }
    let size = GRAVITY.iter().map(|g| g * g).sum::<f64>().sqrt();
    let [x, y, z] = GRAVITY.map(|g| g / size);
    let _ = write!(
        text,
        "*DLOAD\nEALL, GRAV, {size:.12e}, {x:.12e}, {y:.12e}, {z:.12e}\n*NODE PRINT, NSET=NALL\nU\n*EL PRINT, ELSET=EALL\nS\n*END STEP\n"
    );
    text
}

fn run(folder: &Path, deck: &str) -> Option<Answer> {
    std::fs::write(folder.join("part.inp"), deck).ok()?;
    let done =
        Command::new("ccx").arg("-i").arg("part").current_dir(folder).env("OMP_NUM_THREADS", "1").output().ok()?;
    assert!(done.status.success(), "{}", String::from_utf8_lossy(&done.stdout));
    let text = std::fs::read_to_string(folder.join("part.dat")).ok()?;
    let mut answer = Answer { displacement: Vec::new(), stress: Vec::new() };
    for line in text.lines() {
        let numbers: Vec<f64> = line.split_whitespace().map_while(|word| word.parse().ok()).collect();
        match numbers[..] {
            [_, x, y, z] => answer.displacement.push([x, y, z]),
            // xx, yy, zz, xy, xz, yz.
            [element, _, xx, yy, zz, xy, xz, yz] => {
                answer.stress.resize(answer.stress.len().max(element as usize), Vec::new());
                answer.stress[element as usize - 1].push([xx, yy, zz, xy, yz, xz]);
            }
            _ => {}
        }
    }
    Some(answer)
}

#[test]
fn calculix_gives_the_same() {
    if Command::new("ccx").arg("-v").output().is_err() {
        eprintln!("not compared: no ccx here");
        return;
    }
    for shape in [Shape::Tet4, Shape::Tet10, Shape::Wedge15, Shape::Hex20] {
        let mesh = grids::grid(shape, [4, 2, 2], |[x, y, z]| {
            [0.3 * x + 0.02 * y * z, 0.07 * y + 0.03 * x * x, 0.05 * z - 0.02 * x * y + 0.01 * y]
        });
        let fixed = grids::nodes_where(&mesh, |at| at[0] < 0.03);
        let loaded = grids::nodes_where(&mesh, |at| at[0] > 0.29);
        let force = [110.0, -270.0, 190.0];
        let folder = std::env::temp_dir().join(format!("bellcrank-ccx-{}-{shape:?}", std::process::id()));
        std::fs::create_dir_all(&folder).unwrap();
        let answer = run(&folder, &deck(&mesh, &fixed, &loaded, force)).unwrap();
        let _ = std::fs::remove_dir_all(&folder);
        let part = Part {
            mesh: &mesh,
            materials: vec![Material::isotropic(YOUNG, POISSON, 7850.0).unwrap()],
            supports: vec![Support::clamped(fixed)],
            couplings: vec![],
        };
        let statics = Statics::new(&part, Free::Refused, &Settings::default()).unwrap();
        let solution = statics.solve(&[Load::Nodal { nodes: loaded, force }, Load::Gravity(GRAVITY)]).unwrap();
        let most = solution.displacement.iter().flatten().fold(0.0_f64, |m, u| m.max(u.abs()));
        assert_eq!(answer.displacement.len(), mesh.nodes.len());
        for (ours, theirs) in solution.displacement.iter().zip(&answer.displacement) {
            assert!((0..3).all(|i| (ours[i] - theirs[i]).abs() < 1e-6 * most), "{shape:?} {ours:?} {theirs:?}");
        }
        let points = shape.stiffness_points().len();
        let ours = stress::at_points(&part, &solution);
        let most = ours.iter().flatten().fold(0.0_f64, |m, s| m.max(s.abs()));
        for (own, theirs) in ours.chunks_exact(points).zip(&answer.stress) {
            assert_eq!(theirs.len(), points, "{shape:?}");
            for own in own {
                let apart = |other: &Six| (0..6).map(|i| (own[i] - other[i]).abs()).fold(0.0, f64::max);
                let nearest = theirs.iter().map(apart).fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-6 * most, "{shape:?}: {nearest:e} of {most:e}");
            }
        }
    }
}
