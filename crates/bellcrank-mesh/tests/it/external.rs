//! Gmsh as a program, where it is installed.

use std::f64::consts::PI;
use std::path::{Path, PathBuf};
use std::time::Duration;

use bellcrank_mesh::{Gmsh, VolumeMesher, VolumeMesherError, VolumeWishes};

fn data(name: &str) -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/data").join(name)
}

fn gmsh() -> Gmsh {
    Gmsh { program: "gmsh".into(), scratch: std::env::temp_dir() }
}

fn wishes() -> VolumeWishes<'static> {
    let timeout = Duration::from_secs(120);
    VolumeWishes { size: 0.01, per_turn: 16.0, quadratic: true, timeout, interrupted: &|| false }
}

/// Whether the program is there; a test that cannot run says so.
fn present() -> bool {
    let there = std::process::Command::new("gmsh").arg("--version").output().is_ok();
    if !there {
        println!("SKIPPED: the program gmsh is not installed");
    }
    there
}

#[test]
fn a_step_file_is_meshed_in_metres_with_its_bore() {
    if !present() {
        return;
    }
    let made = gmsh().mesh(&data("part.step"), &wishes()).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(made.mesh.check(), []);
    let exact = (40.0 * 30.0 - PI * 36.0) * 10.0 * 1e-9;
    assert!((made.mesh.quality().volume / exact - 1.0).abs() < 1e-4, "{}", made.mesh.quality().volume);
    assert_eq!(made.mesh.face_sets.keys().filter(|name| name.starts_with("face.")).count(), 7);
    assert_eq!(made.cylinders.len(), 1, "{:?}", made.cylinders);
    let bore = &made.cylinders[0];
    assert!(bore.bore && (bore.radius - 0.006).abs() < 1e-8 && (bore.length - 0.01).abs() < 1e-9, "{bore:?}");
    assert!((bore.center[0] - 0.012).abs().max((bore.center[1] - 0.014).abs()) < 1e-8, "{bore:?}");
}

#[test]
fn an_open_part_is_refused_with_the_reason() {
    if !present() {
        return;
    }
    let refused = gmsh().mesh(&data("open.step"), &wishes()).expect_err("the part is open");
    assert!(matches!(refused, VolumeMesherError::Open { .. }), "{refused}");
}

#[test]
fn a_file_that_is_no_geometry_is_refused() {
    if !present() {
        return;
    }
    let file = std::env::temp_dir().join(format!("bellcrank-no-part-{}.step", std::process::id()));
    std::fs::write(&file, "this is no part\n").expect("the folder can be written");
    let refused = gmsh().mesh(&file, &wishes()).expect_err("there is no part");
    std::fs::remove_file(&file).expect("the file is there");
    assert!(matches!(refused, VolumeMesherError::Failed { .. } | VolumeMesherError::Open { .. }), "{refused}");
}

#[test]
fn an_impatient_user_is_served() {
    if !present() {
        return;
    }
    let fine = VolumeWishes { size: 2e-4, ..wishes() };
    let hasty = VolumeWishes { timeout: Duration::from_millis(300), ..fine };
    let refused = gmsh().mesh(&data("part.step"), &hasty).expect_err("that takes longer");
    assert!(matches!(refused, VolumeMesherError::TimedOut { .. }), "{refused}");
    let stopped = VolumeWishes { interrupted: &|| true, ..fine };
    let refused = gmsh().mesh(&data("part.step"), &stopped).expect_err("it was stopped");
    assert_eq!(refused, VolumeMesherError::Interrupted);
}

#[test]
fn an_absent_program_is_named() {
    let absent = Gmsh { program: "no-such-mesher".into(), scratch: std::env::temp_dir() };
    let refused = absent.mesh(&data("part.step"), &wishes()).expect_err("there is no such program");
    assert_eq!(refused, VolumeMesherError::Absent { program: "no-such-mesher".into() });
    assert!(refused.to_string().contains("work without it"), "{refused}");
    let kind = gmsh().mesh(&data("README.md"), &wishes()).expect_err("that is no geometry");
    assert!(matches!(kind, VolumeMesherError::FileKind { .. }), "{kind}");
}
