use serde_json::Value;

use super::*;
use crate::SpaceKind;
use crate::solid::sample;

/// The two chunks of a file, after looking at its head.
fn parsed(run: &RunResult) -> (Value, Vec<u8>) {
    let mut file = Vec::new();
    write_glb(run, &run.studies[0], &mut file).unwrap();
    let word = |at: usize| u32::from_le_bytes(file[at..at + 4].try_into().unwrap()) as usize;
    assert_eq!((&file[..4], word(4), word(8)), (&b"glTF"[..], 2, file.len()));
    assert_eq!((&file[16..20], word(12) % 4), (&b"JSON"[..], 0));
    let bytes = 20 + word(12);
    let document = serde_json::from_slice(&file[20..bytes]).unwrap();
    if bytes == file.len() {
        return (document, Vec::new());
    }
    assert_eq!((&file[bytes + 4..bytes + 8], bytes + 8 + word(bytes)), (&b"BIN\0"[..], file.len()));
    (document, file[bytes + 8..].to_vec())
}

fn number(value: &Value, key: &str) -> usize {
    value[key].as_u64().unwrap_or(0) as usize
}

/// The components of an accessor, row by row.
fn read(document: &Value, bytes: &[u8], accessor: &Value) -> Vec<Vec<f64>> {
    let accessor = &document["accessors"][accessor.as_u64().unwrap() as usize];
    let view = &document["bufferViews"][number(accessor, "bufferView")];
    let width = match accessor["type"].as_str().unwrap() {
        "SCALAR" => 1,
        "VEC3" => 3,
        _ => 4,
    };
    let size = if number(accessor, "componentType") == 5123 { 2 } else { 4 };
    let (start, length) = (number(view, "byteOffset"), number(view, "byteLength"));
    assert_eq!((start % 4, length), (0, number(accessor, "count") * width * size));
    let one = |part: &[u8]| match (size, number(accessor, "componentType")) {
        (2, _) => f64::from(u16::from_le_bytes(part.try_into().unwrap())),
        (_, 5125) => f64::from(u32::from_le_bytes(part.try_into().unwrap())),
        _ => f64::from(f32::from_le_bytes(part.try_into().unwrap())),
    };
    let numbers: Vec<f64> = bytes[start..start + length].chunks(size).map(one).collect();
    numbers.chunks(width).map(<[f64]>::to_vec).collect()
}

fn list(value: &Value) -> Vec<f64> {
    value.as_array().unwrap().iter().map(|x| x.as_f64().unwrap()).collect()
}

#[test]
fn the_parts_of_a_file_fit_together() {
    let run = sample::run(SpaceKind::Spatial, "time");
    let (document, bytes) = parsed(&run);
    assert_eq!(number(&document["buffers"][0], "byteLength"), bytes.len());
    let nodes = document["nodes"].as_array().unwrap();
    assert_eq!(nodes.len(), run.drawing.bodies.len() + 1);
    assert_eq!(nodes[3]["name"], "body2");
    // z up becomes y up: a quarter turn about -x.
    let half = 0.5_f32.sqrt();
    assert_eq!(list(&nodes[0]["rotation"]).iter().map(|x| *x as f32).collect::<Vec<_>>(), [-half, 0.0, 0.0, half]);
    for mesh in document["meshes"].as_array().unwrap() {
        for primitive in mesh["primitives"].as_array().unwrap() {
            assert!(number(primitive, "material") < document["materials"].as_array().unwrap().len());
        }
    }
}

#[test]
fn positions_say_how_far_they_reach() {
    let (document, bytes) = parsed(&sample::run(SpaceKind::Planar, "time"));
    for mesh in document["meshes"].as_array().unwrap() {
        for primitive in mesh["primitives"].as_array().unwrap() {
            let at = &primitive["attributes"]["POSITION"];
            let positions = read(&document, &bytes, at);
            let accessor = &document["accessors"][at.as_u64().unwrap() as usize];
            for k in 0..3 {
                let along = positions.iter().map(|p| p[k] as f32);
                assert_eq!(along.clone().fold(f32::INFINITY, f32::min), list(&accessor["min"])[k] as f32);
                assert_eq!(along.fold(f32::NEG_INFINITY, f32::max), list(&accessor["max"])[k] as f32);
            }
        }
    }
}

#[test]
fn triangles_look_where_their_normals_point() {
    for space in [SpaceKind::Planar, SpaceKind::Spatial] {
        let (document, bytes) = parsed(&sample::run(space, "time"));
        for mesh in document["meshes"].as_array().unwrap() {
            for primitive in mesh["primitives"].as_array().unwrap() {
                let positions = read(&document, &bytes, &primitive["attributes"]["POSITION"]);
                let normals = read(&document, &bytes, &primitive["attributes"]["NORMAL"]);
                assert!(normals.iter().all(|n| (n.iter().map(|x| x * x).sum::<f64>() - 1.0).abs() < 1e-5));
                let corners: Vec<usize> =
                    read(&document, &bytes, &primitive["indices"]).iter().map(|index| index[0] as usize).collect();
                for triangle in corners.chunks(3) {
                    let [a, b, c] = [0, 1, 2].map(|k| &positions[triangle[k]]);
                    let edge = |p: &[f64]| -> [f64; 3] { std::array::from_fn(|k| p[k] - a[k]) };
                    let area = cross(edge(b), edge(c));
                    let outward = triangle.iter().map(|v| (0..3).map(|k| area[k] * normals[*v][k]).sum::<f64>());
                    assert!(outward.sum::<f64>() > 0.0, "{space:?} {} {triangle:?}", mesh["name"]);
                }
            }
        }
    }
}

#[test]
fn turns_take_the_short_way_and_times_are_those_of_the_rows() {
    let run = sample::run(SpaceKind::Spatial, "time");
    let (document, bytes) = parsed(&run);
    let animation = &document["animations"][0];
    // All but the ground move.
    assert_eq!(animation["channels"].as_array().unwrap().len(), 2 * (run.drawing.bodies.len() - 1));
    for channel in animation["channels"].as_array().unwrap() {
        let sampler = &animation["samplers"][number(channel, "sampler")];
        let times = read(&document, &bytes, &sampler["input"]);
        assert_eq!(times.iter().map(|t| t[0]).collect::<Vec<_>>(), [0.0, 0.25, 0.5, 0.75, 1.0, 1.25, 1.5, 1.75, 2.0]);
        let body = number(&channel["target"], "node") - 1;
        let values = read(&document, &bytes, &sampler["output"]);
        let frames = &run.studies[0].animation.as_ref().unwrap().frames;
        for (frame, value) in frames.iter().zip(&values) {
            let pose = &frame[body];
            if channel["target"]["path"] == "translation" {
                assert!((0..3).all(|k| (value[k] - pose.position[k]).abs() < 1e-6));
            } else {
                let [w, x, y, z] = pose.quaternion;
                let same: f64 = [x, y, z, w].iter().zip(value).map(|(a, b)| a * b).sum();
                assert!((same.abs() - 1.0).abs() < 1e-6);
            }
        }
        for pair in values.windows(2).filter(|_| channel["target"]["path"] == "rotation") {
            assert!(pair[0].iter().zip(&pair[1]).map(|(a, b)| a * b).sum::<f64>() > 0.0);
        }
    }
}

#[test]
fn a_sweep_plays_for_four_seconds() {
    let (document, bytes) = parsed(&sample::run(SpaceKind::Planar, "joint.B.position"));
    let times = read(&document, &bytes, &document["animations"][0]["samplers"][0]["input"]);
    assert_eq!((times[0][0], times[1][0], times[8][0]), (0.0, 0.5, 4.0));
}

#[test]
fn frames_that_cannot_be_played_are_left_out() {
    let mut run = sample::run(SpaceKind::Spatial, "time");
    run.studies[0].table.columns[0].values[3] = run.studies[0].table.columns[0].values[2];
    run.studies[0].animation.as_mut().unwrap().frames[5][2].position[1] = f64::NAN;
    let (document, bytes) = parsed(&run);
    let times = read(&document, &bytes, &document["animations"][0]["samplers"][0]["input"]);
    assert_eq!(times.iter().map(|t| t[0]).collect::<Vec<_>>(), [0.0, 0.25, 0.5, 1.0, 1.5, 1.75, 2.0]);
}

#[test]
fn one_position_is_a_file_without_animation_and_no_position_one_without_nodes() {
    let mut run = sample::run(SpaceKind::Spatial, "time");
    run.studies[0].animation.as_mut().unwrap().frames.truncate(1);
    let (document, _) = parsed(&run);
    assert!(document.get("animations").is_none() && document["meshes"].is_array());
    run.studies[0].animation = None;
    let (document, bytes) = parsed(&run);
    assert!(document.get("nodes").is_none() && bytes.is_empty());
}

#[test]
fn upright_rows_are_right_handed_and_turn_up_to_y() {
    for axis in 0..3 {
        for sign in [1.0, -1.0] {
            let up: [f64; 3] = std::array::from_fn(|k| if k == axis { sign } else { 0.0 });
            let [right, middle, toward] = upright(up);
            assert_eq!((middle, cross(right, middle)), (up, toward));
            let [x, y, z, w] = motion::quaternion([right, middle, toward]).map(f64::from);
            let turned = crate::solid::vector::turned([w, x, y, z], up);
            assert!((turned[1] - 1.0).abs() < 1e-6, "{up:?} {turned:?}");
        }
    }
}

#[test]
fn real_forms_are_smooth_only_where_they_are_flat_enough() {
    let mut sharp = Mesh::default();
    let tetrahedron = sample::tetrahedron();
    sharp.push(&crate::Shape::Surface(tetrahedron));
    assert_eq!((sharp.positions.len(), sharp.indices.len()), (12, 12));
    // Each of the three corners of a face has its normal.
    for face in sharp.normals.chunks(3) {
        assert!(face.iter().all(|normal| (0..3).all(|k| (normal[k] - face[0][k]).abs() < 1e-6)), "{face:?}");
    }
    // Two strips of a cylinder, 20 degrees apart.
    let around: Vec<[f64; 2]> = [0.0f64, 20.0, 40.0].map(|degrees| degrees.to_radians().sin_cos().into()).to_vec();
    let points = around.iter().flat_map(|[sin, cos]| [[*cos, *sin, 0.0], [*cos, *sin, 1.0]]).collect();
    let strips = crate::Surface { points, triangles: vec![[0, 2, 3], [0, 3, 1], [2, 4, 5], [2, 5, 3]] };
    let mut smooth = Mesh::default();
    smooth.push(&crate::Shape::Surface(strips));
    let [sin, cos] = around[1].map(|x| x as f32);
    let ridge = smooth.positions.iter().zip(&smooth.normals).filter(|(at, _)| (at[1] - sin).abs() < 1e-6);
    for (_, normal) in ridge {
        assert!((normal[0] - cos).abs() < 1e-6 && (normal[1] - sin).abs() < 1e-6, "{normal:?}");
    }
}
