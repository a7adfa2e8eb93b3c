//! STEP files in another CAD kernel: OpenCASCADE, through Gmsh.

use std::path::PathBuf;
use std::process::Command;

use bellcrank_solid::step::{Placement, StepPart, write};
use bellcrank_solid::{Link, Shell};

use crate::parts::{eye, link};
use crate::random::{Dice, random_link};
use crate::shells::{bush, pin};

const TIME: &str = "2000-01-01T00:00:00";

fn part(name: &str, shell: Shell) -> StepPart {
    StepPart { name: name.to_owned(), shell, color: None, material: None, instances: vec![Placement::IDENTITY] }
}

/// A solid as Gmsh reads it: volume in mm³, centre of mass in mm, and how many surfaces bound it.
#[derive(Debug)]
struct Read {
    volume: f64,
    center: [f64; 3],
    surfaces: f64,
}

/// Reads STEP files with Gmsh; `None` without Gmsh.
fn read(name: &str, files: &[String]) -> Option<Vec<Vec<Read>>> {
    if Command::new("gmsh").arg("--version").output().is_err() {
        println!("SKIPPED: no gmsh on this machine, STEP files are not read back");
        return None;
    }
    let folder = PathBuf::from(env!("CARGO_TARGET_TMPDIR")).join(name);
    std::fs::create_dir_all(&folder).expect("a folder for the files");
    let mut script = "General.Terminal = 1;\n".to_owned();
    for (i, file) in files.iter().enumerate() {
        std::fs::write(folder.join(format!("{i}.step")), file).expect("a file");
        script += &format!(
            "Delete All; SetFactory(\"OpenCASCADE\"); Merge \"{i}.step\"; v() = Volume{{:}};\n\
             For k In {{0 : #v()-1}}\n m = Mass Volume{{v(k)}}; c() = CenterOfMass Volume{{v(k)}};\n\
             s() = Boundary{{ Volume{{v(k)}}; }};\n\
             Printf(\"READ {i} %.15g %.15g %.15g %.15g %.15g\", m, c(0), c(1), c(2), #s());\nEndFor\n"
        );
    }
    std::fs::write(folder.join("all.geo"), script).expect("a script");
    let out = Command::new("gmsh").args(["-", "all.geo"]).current_dir(&folder).output().expect("gmsh runs");
    let text = String::from_utf8_lossy(&out.stdout).into_owned() + &String::from_utf8_lossy(&out.stderr);
    let mut solids: Vec<Vec<Read>> = files.iter().map(|_| Vec::new()).collect();
    for line in text.lines().filter_map(|l| l.split("READ ").nth(1)) {
        let n: Vec<f64> = line.split_whitespace().map(|n| n.parse().expect("a number")).collect();
        solids[n[0] as usize].push(Read { volume: n[1], center: [n[2], n[3], n[4]], surfaces: n[5] });
    }
    assert!(solids.iter().any(|s| !s.is_empty()), "nothing was read:\n{text}");
    Some(solids)
}

#[test]
fn random_links_have_the_same_volume_in_opencascade() {
    let (mut files, mut exact) = (Vec::new(), Vec::new());
    for seed in 0..150 {
        let mut link = random_link(&mut Dice::new(seed));
        if seed % 2 == 0 {
            link.fillet = Some(0.002);
        }
        if let Ok(stack) = link.build() {
            let shell = stack.shell();
            let faces = shell.faces.len();
            files.push(write("link", TIME, &[part("link", shell)]));
            exact.push((seed, stack.mass_properties(1.0), faces));
        }
    }
    assert!(files.len() > 100);
    let Some(read) = read("links", &files) else { return };
    for ((seed, exact, faces), read) in exact.iter().zip(&read) {
        assert_eq!(read.len(), 1, "seed {seed}: one solid");
        let read = &read[0];
        assert!((read.volume * 1e-9 / exact.volume - 1.0).abs() < 1e-6, "seed {seed}: {read:?}, {exact:?}");
        for (a, b) in read.center.iter().zip(exact.center) {
            assert!((a * 1e-3 - b).abs() < 1e-6, "seed {seed}: {read:?}, {exact:?}");
        }
        assert_eq!(read.surfaces, *faces as f64, "seed {seed}: every face is there");
    }
    println!("{} links read back", files.len());
}

#[test]
fn pins_have_the_same_volume_in_opencascade() {
    let bodies = [pin(), bush()];
    let files: Vec<String> =
        bodies.iter().map(|b| write("pin", TIME, &[part("pin", b.shell().expect("a sound profile"))])).collect();
    let Some(read) = read("pins", &files) else { return };
    for (body, read) in bodies.iter().zip(&read) {
        let exact = body.mass_properties(1.0).expect("a sound profile");
        assert_eq!(read.len(), 1);
        assert!((read[0].volume * 1e-9 / exact.volume - 1.0).abs() < 1e-6, "{read:?}, {exact:?}");
        assert!(
            read[0].center.iter().zip(exact.center).all(|(a, b)| (a * 1e-3 - b).abs() < 1e-6),
            "{read:?}, {exact:?}"
        );
    }
}

#[test]
fn an_assembly_stands_where_it_was_placed() {
    let ring: Link<f64> = Link { eyes: vec![eye([0.03, 0.01], 0.02, 0.05, [0.0, 0.01])], ..link() };
    let stack = ring.build().expect("a sound ring");
    let places = [
        Placement { rotation: [[0.0, -1.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.0]], translation: [0.2, 0.1, -0.3] },
        Placement {
            rotation: [[0.36, 0.48, -0.8], [-0.8, 0.6, 0.0], [0.48, 0.64, 0.6]],
            translation: [-0.5, 0.0, 0.1],
        },
    ];
    let parts = [
        StepPart {
            instances: places.to_vec(),
            color: Some([0.8, 0.2, 0.1]),
            material: Some("Stahl für Ösen".to_owned()),
            ..part("ring", stack.shell())
        },
        part("bush", bush().shell().expect("a sound profile")),
    ];
    let file = write("two rings and a bush", TIME, &parts);
    assert_eq!(file, write("two rings and a bush", TIME, &parts), "the same parts give the same text");
    let Some(read) = read("assembly", &[file]) else { return };
    let center = stack.mass_properties(1.0).center;
    let mut expected: Vec<[f64; 3]> = places
        .iter()
        .map(|p| std::array::from_fn(|i| p.translation[i] + (0..3).map(|k| p.rotation[i][k] * center[k]).sum::<f64>()))
        .collect();
    expected.push(bush().mass_properties(1.0).expect("a sound profile").center);
    assert_eq!(read[0].len(), 3, "{read:?}");
    for e in expected {
        let near = |r: &Read| r.center.iter().zip(e).all(|(a, b)| (a * 1e-3 - b).abs() < 1e-6);
        assert!(read[0].iter().any(near), "{e:?} in {read:?}");
    }
}
