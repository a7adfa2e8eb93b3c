//! CalculiX runs the files unchanged, and finds the same.

use std::process::Command;

use bellcrank_fem::{
    Coupling, CouplingKind, Free, Load, Material, Part, Region, Settings, Six, Statics, Stress, Support, stress,
};
use bellcrank_mesh::{Mesh, Shape, Sizes, mesh_stack};
use bellcrank_solid::{Bar, Eye, Link, Profile, Web};

use super::Written;

fn link() -> Mesh {
    let eye = |x: f64, bore: f64| Eye {
        center: [x, 0.01],
        bore,
        outer: 2.2 * bore,
        layers: vec![[-0.008, 0.008]],
        clearance: None,
    };
    let bar = Bar { eyes: [0, 1], widths: [0.03, 0.02], layers: vec![[-0.005, 0.005]], profile: Profile::Flat };
    let link = Link {
        eyes: vec![eye(0.0, 0.02), eye(0.12, 0.016)],
        webs: vec![Web::Bar(bar)],
        plates: Vec::new(),
        cuts: Vec::new(),
        fillet: Some(0.004),
    };
    let stack = link.build().expect("a sound link");
    let sizes = Sizes { size: Some(0.02), layers_across: 1, ..Sizes::default() };
    mesh_stack(&stack, &["A", "B"], Shape::Wedge15, &sizes).expect("a mesh")
}

/// Displacements by node, stresses by element.
fn answer(text: &str) -> (Vec<[f64; 3]>, Vec<Vec<Six>>) {
    let (mut displacement, mut stress) = (Vec::new(), Vec::<Vec<Six>>::new());
    for line in text.lines() {
        let numbers: Vec<f64> = line.split_whitespace().map_while(|word| word.parse().ok()).collect();
        match numbers[..] {
            [_, x, y, z] => displacement.push([x, y, z]),
            // xx, yy, zz, xy, xz, yz.
            [element, _, xx, yy, zz, xy, xz, yz] => {
                stress.resize(stress.len().max(element as usize), Vec::new());
                stress[element as usize - 1].push([xx, yy, zz, xy, yz, xz]);
            }
            _ => {}
        }
    }
    (displacement, stress)
}

fn compare(what: &str, part: &Part<'_>, free: Free, loads: &[Load]) {
    let statics = Statics::new(part, free, &Settings::default()).expect("a sound part");
    let solution = statics.solve(loads).expect("loads");
    let smooth = Stress::new(part, &solution);
    let written = Written { name: "part", part, solution: &solution, stress: &smooth };
    let folder = std::env::temp_dir().join(format!("bellcrank-deck-{what}-{}", std::process::id()));
    std::fs::create_dir_all(&folder).expect("a folder");
    std::fs::write(folder.join("part.inp"), written.deck()).expect("a file");
    let mut program = Command::new("ccx");
    let done =
        program.args(["-i", "part"]).current_dir(&folder).env("OMP_NUM_THREADS", "1").output().expect("ccx runs");
    let text = std::fs::read_to_string(folder.join("part.dat")).unwrap_or_default();
    let _ = std::fs::remove_dir_all(&folder);
    assert!(done.status.success(), "{what}: {}", String::from_utf8_lossy(&done.stdout));
    let (displacement, stresses) = answer(&text);
    let most = solution.displacement.iter().flatten().fold(0.0_f64, |most, u| most.max(u.abs()));
    assert_eq!(displacement.len(), part.mesh.nodes.len(), "{what}");
    for (own, theirs) in solution.displacement.iter().zip(&displacement) {
        assert!((0..3).all(|i| (own[i] - theirs[i]).abs() < 1e-5 * most), "{what}: {own:?} {theirs:?}");
    }
    let points = part.mesh.blocks[0].shape.stiffness_points().len();
    let own = stress::at_points(part, &solution);
    let most = own.iter().flatten().fold(0.0_f64, |most, s| most.max(s.abs()));
    for (own, theirs) in own.chunks_exact(points).zip(&stresses) {
        for own in own {
            let apart = |other: &Six| (0..6).map(|i| (own[i] - other[i]).abs()).fold(0.0, f64::max);
            let nearest = theirs.iter().map(apart).fold(f64::INFINITY, f64::min);
            assert!(nearest < 1e-5 * most, "{what}: {nearest:e} of {most:e}");
        }
    }
}

#[test]
fn calculix_finds_the_same() {
    if Command::new("ccx").arg("-v").output().is_err() {
        eprintln!("not compared: no ccx here");
        return;
    }
    let mesh = link();
    let steel = Material::isotropic(2.07e11, 0.28, 7850.0).expect("steel").with_expansion([1.2e-5; 3]);
    let bores: Vec<_> = ["bore.A", "bore.B"].map(|name| mesh.face_sets[name].clone()).into();
    let bearing = Load::Bearing {
        faces: bores[1].clone(),
        center: [0.12, 0.01, 0.0],
        axis: [0.0, 0.0, 1.0],
        force: [900.0, -700.0, 50.0],
    };
    let part = |supports, couplings| Part { mesh: &mesh, materials: vec![steel.clone()], supports, couplings };
    let clamped = part(vec![Support::clamped(mesh.node_sets["bore.A"].clone())], Vec::new());
    let warm = Load::Temperature(vec![30.0; mesh.nodes.len()]);
    compare("clamped", &clamped, Free::Refused, &[bearing.clone(), Load::Gravity([1.0, -9.0, 3.0]), warm]);
    let frame = |k: usize, kind| Coupling::free(Region::Faces(bores[k].clone()), [0.12 * k as f64, 0.01, 0.0], kind);
    let floating = part(Vec::new(), vec![frame(0, CouplingKind::Rigid), frame(1, CouplingKind::Distributing)]);
    let pushed = Load::Frame { coupling: 0, force: [300.0, 200.0, -100.0], moment: [1.0, 2.0, -3.0] };
    compare("floating", &floating, Free::Relieved, &[bearing.clone(), pushed]);
    let held = Coupling { held: [Some(0.0); 6], ..frame(0, CouplingKind::Distributing) };
    compare("held-by-its-middle", &part(Vec::new(), vec![held]), Free::Refused, &[bearing]);
}
