//! Flexible bodies: in the page, as files, in words.

use std::fs;

use bellcrank_report::{Exports, Style, render_html, terminal_summary, write_run};
use bellcrank_results::{FlexibleMotion, RunResult, StudyResult};
use serde_json::Value;

use crate::markup::{assert_balanced, between, unpacked};
use crate::sample::flexible::{ROWS, motion, run, run_of};

/// Lists of differences, as the browser reads them.
struct Reader {
    bytes: Vec<u8>,
    at: usize,
}

impl Reader {
    fn next(&mut self, count: usize, width: usize) -> Vec<u32> {
        let bytes = &self.bytes[self.at..self.at + count * width];
        self.at += count * width;
        let mask = u32::MAX >> (32 - 8 * width);
        let mut before = 0_u32;
        let mut number = |k: usize| {
            let step = (0..width).fold(0, |sum, plane| sum | u32::from(bytes[plane * count + k]) << (8 * plane));
            before = before.wrapping_add((step >> 1) ^ (step & 1).wrapping_neg()) & mask;
            before
        };
        (0..count).map(&mut number).collect()
    }

    fn floats(&mut self, count: usize) -> Vec<f64> {
        self.next(count, 4).into_iter().map(|bits| f64::from(f32::from_bits(bits))).collect()
    }

    /// Nothing of a list that was left out.
    fn signed(&mut self, count: usize, width: &Value, size: &Value) -> Vec<f64> {
        let (width, size) = (width.as_u64().unwrap() as usize, size.as_f64().unwrap());
        if width == 0 {
            return vec![0.0; count];
        }
        let zero = f64::from(1_u32 << (8 * width - 1));
        self.next(count, width).into_iter().map(|step| (f64::from(step) - zero) * size).collect()
    }
}

/// What the page holds of a body: places, then displacement and stress of each column, then coordinates by frame, and
/// the rest.
struct Held {
    moves: Vec<Vec<f64>>,
    stresses: Vec<Vec<f64>>,
    coordinates: Vec<Vec<f64>>,
    poses: Vec<Vec<f64>>,
    marks: Vec<Vec<f64>>,
}

fn catalogue(page: &str) -> Value {
    serde_json::from_str(between(page, "id=\"bellcrank-flexible\">", "</script>")).unwrap()
}

fn held(page: &str) -> Held {
    let study = &catalogue(page)["studies"][0];
    let body = &study["bodies"][0];
    let count = |key: &str| body[key].as_u64().unwrap() as usize;
    let bytes = unpacked(between(page, "id=\"bellcrank-flexible-0-0\">", "</script>"));
    let mut reader = Reader { bytes, at: 0 };
    let (nodes, frames) = (count("nodes"), count("frames"));
    (0..3).for_each(|_| drop(reader.next(nodes, 3)));
    for (key, corners) in [("triangles", 3), ("edges", 2), ("outline", 2)] {
        reader.next(corners * count(key), 4);
    }
    let (mut moves, mut stresses) = (Vec::new(), Vec::new());
    let columns = body["columns"].as_array().unwrap();
    for of in columns {
        moves.push(reader.signed(3 * nodes, &of["moveWidth"], &of["moveStep"]));
        stresses.push(reader.signed(6 * nodes, &of["stressWidth"], &of["stressStep"]));
    }
    let coordinates = columns.iter().map(|_| reader.floats(frames)).collect();
    let poses = (0..7).map(|_| reader.floats(frames)).collect();
    let marks = body["marks"].as_array().unwrap().iter().map(|_| reader.floats(frames)).collect();
    assert_eq!(reader.at, reader.bytes.len());
    Held { moves, stresses, coordinates, poses, marks }
}

/// Sum over the columns of a component of a node.
fn sum(columns: &[Vec<f64>], held: &Held, frame: usize, place: usize) -> f64 {
    columns.iter().zip(&held.coordinates).map(|(column, d)| column[place] * d[frame]).sum()
}

#[test]
fn the_page_gives_displacement_and_stress_of_every_row() {
    let run = run();
    let (page, of) = (render_html(&run), &run.studies[0].motions[0]);
    let held = held(&page);
    let nodes = of.nodes.len();
    let largest = of.limit();
    for (at, node) in [(0, 0), (15, 17), (60, nodes / 2), (ROWS - 1, nodes - 1), (of.worst, 3)] {
        let (moved, stress) = (of.displacement(at, node), of.stress(at, node));
        for (k, u) in moved.iter().enumerate() {
            assert!((sum(&held.moves, &held, at, k * nodes + node) - u).abs() < 1e-6, "{at} {node} {k}");
        }
        for (k, s) in stress.iter().enumerate() {
            let found = sum(&held.stresses, &held, at, k * nodes + node);
            assert!((found - s).abs() < 3e-4 * largest, "{at} {node} {k}: {found} {s}");
        }
        let pose = &of.poses[at];
        let own = pose.position.iter().chain(&pose.quaternion);
        assert!(own.zip(&held.poses).all(|(x, list)| (x - list[at]).abs() < 1e-6));
        let marks = of.marks.iter().zip(&held.marks);
        assert!(
            marks.clone().count() == 3
                && marks.clone().all(|(mark, list)| (mark.history[at] / 1e6 - list[at]).abs() < 1e-4)
        );
    }
}

#[test]
fn colours_mean_the_same_in_every_row_and_on_every_body() {
    let mut run = run();
    let mut other = motion([20, 4, 2], "other");
    other.stresses.iter_mut().flatten().flatten().for_each(|s| *s *= 2.0);
    other.envelope.iter_mut().for_each(|s| *s *= 2.0);
    let most = f64::from(other.envelope.iter().copied().fold(0.0, f32::max)) / 1e6;
    run.studies[0].motions.push(other);
    let study = &catalogue(&render_html(&run))["studies"][0];
    assert_eq!(study["bodies"].as_array().unwrap().len(), 2);
    assert!((study["stress"]["most"].as_f64().unwrap() - most).abs() < 1e-3);
    assert_eq!((study["stress"]["low"].as_f64(), study["stress"]["unit"].as_str()), (Some(0.0), Some("MPa")));
    assert_eq!((study["bodies"][0]["body"].as_u64(), study["bodies"][1]["body"].as_u64()), (Some(1), None));
}

#[test]
fn what_cannot_be_moved_is_left_out() {
    let broken = FlexibleMotion { triangles: vec![[0, 1, 9_999_999]], ..motion([10, 2, 2], "bar") };
    for run in [
        run_of(broken),
        {
            let mut run = run();
            run.studies[0].animation = None;
            run
        },
        {
            let mut run = run();
            run.studies[0].motions.clear();
            run
        },
    ] {
        let page = render_html(&run);
        assert_balanced(&page);
        assert!(!page.contains("id=\"bellcrank-flexible\""));
        assert!(page.contains("Flexible bodies"));
    }
}

/// A link of 15,000 nodes on its surface, with the page around it.
#[test]
fn a_page_stays_of_sane_size() {
    let mut large = motion([900, 6, 2], "bar");
    let nodes = large.nodes.len();
    assert!((14_000..16_000).contains(&nodes), "{nodes}");
    // Ten modes more, each of its own shape and small share.
    for extra in 1..=10 {
        let wave = |p: &[f32; 3]| (extra as f32 * 7.0 * p[0]).sin() * (1.0 + p[1] + 3.0 * p[2]);
        let wavy: Vec<f32> = large.nodes.iter().map(wave).collect();
        large.displacements.push(wavy.iter().map(|w| [0.1 * w, *w, -0.3 * w]).collect());
        large.stresses.push(wavy.iter().map(|w| [3e10, 1e10, -2e9, 4e9, 1e8, -7e9].map(|s| s * w)).collect());
        large
            .coordinates
            .iter_mut()
            .enumerate()
            .for_each(|(k, row)| row.push(1e-4 * (0.1 * k as f64).cos() / f64::from(extra)));
    }
    let without = render_html(&RunResult {
        studies: vec![StudyResult { motions: Vec::new(), ..run().studies.remove(0) }],
        ..run()
    });
    let with = render_html(&run_of(large));
    let bytes = with.len() - without.len();
    assert!(bytes < 5_000_000, "{bytes}");
}

#[test]
fn names_cannot_break_the_page() {
    let mut run = run();
    let evil = "</script><img src=x onerror=alert(1)>\"'&\u{1b}[2J";
    let study = &mut run.studies[0];
    for motion in &mut study.motions {
        evil.clone_into(&mut motion.body);
        evil.clone_into(&mut motion.unit.symbol);
        motion.marks.iter_mut().for_each(|mark| evil.clone_into(&mut mark.label));
    }
    let found = study.flexible.as_mut().unwrap();
    evil.clone_into(&mut found.assumptions[0]);
    evil.clone_into(&mut found.unit.symbol);
    for body in &mut found.bodies {
        for text in [&mut body.body, &mut body.solid, &mut body.material, &mut body.coupling, &mut body.error] {
            evil.clone_into(text);
        }
        evil.clone_into(&mut body.interfaces[0]);
        body.checks.iter_mut().for_each(|check| evil.clone_into(&mut check.meaning));
        body.spots.iter_mut().for_each(|spot| {
            evil.clone_into(&mut spot.region);
            evil.clone_into(&mut spot.place);
        });
    }
    let page = render_html(&run);
    assert_balanced(&page);
    assert!(!page.contains("<img src=x"));
    assert!(!terminal_summary(&run, &Style::default()).contains('\u{1b}'));
}

#[test]
fn stress_over_the_rows_is_told() {
    let text = terminal_summary(&run(), &Style { color: false, width: 400 });
    for part in [
        "The largest stress of `bar` over all rows is 125.8 MPa ± 2.1 % at bore A, at time = 0.250 s; 64.6 % below yield at 355 MPa.",
        "`bar` lives for 3100000 repeats of this study; its weakest region is bore A.",
        "`bar` has 2 elastic coordinates: it is held at `A` and `B` by rigid couplings, and 3 modes with its interfaces held, from 231.5 Hz to 1251 Hz.",
        "It is deformed by up to 3.4 mm (0.57 % of its size) at time = 0.25 s.",
        "bar bore A",
        "NOT TO BE TRUSTED, re-entrant edge",
    ] {
        assert!(text.contains(part), "{part} in\n{text}");
    }
    assert!(!text.contains("FAILED"));
    let mut bad = run();
    bad.studies[0].flexible.as_mut().unwrap().bodies[0].checks[1].value = 0.02;
    assert!(terminal_summary(&bad, &Style::default()).contains("free frequencies against the whole mesh"));
    assert!(render_html(&bad).contains("residuals too large in 1 study"));
}

#[test]
fn files_hold_what_is_told() {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-flexible", std::process::id()));
    let written = write_run(&run(), &dir, Exports::default()).unwrap();
    let names = ["flexible_hot_spots.csv", "flexible_modes.csv", "bar_stress_at_time_0.25_s_where_it_is_largest.png"];
    for name in names {
        assert!(written.contains(&dir.join("swing").join(name)), "{name} in {written:?}");
    }
    let spots = fs::read_to_string(dir.join("swing/flexible_hot_spots.csv")).unwrap();
    assert!(spots.starts_with("body,region,position,x [mm],"), "{spots}");
    assert_eq!(spots.lines().count(), 4);
    let summary: Value = serde_json::from_str(&fs::read_to_string(dir.join("swing/summary.json")).unwrap()).unwrap();
    assert_eq!(summary["flexible"]["bodies"]["bar"]["peak"]["region"], "bore A");
    fs::remove_dir_all(dir).unwrap();
}

#[test]
fn paraview_gets_a_file_a_row() {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-series", std::process::id()));
    let mut run = run_of(motion([12, 3, 2], "bar"));
    let other = FlexibleMotion { body: "../bar".to_owned(), ..motion([8, 2, 2], "bar") };
    run.studies[0].motions.push(other);
    let written = write_run(&run, &dir, Exports { vtu: true, ..Exports::default() }).unwrap();
    let folder = dir.join("swing");
    for name in ["motion.pvd", "bar/bar_0000.vtu", "bar/bar_0120.vtu", "_bar/_bar_0120.vtu"] {
        assert!(written.contains(&folder.join(name)) && folder.join(name).is_file(), "{name}");
    }
    let series = fs::read_to_string(folder.join("motion.pvd")).unwrap();
    assert_eq!(series.matches("<DataSet").count(), 2 * ROWS);
    assert!(series.contains("timestep=\"0.25\" group=\"\" part=\"1\" name=\"../bar\" file=\"_bar/_bar_0015.vtu\""));
    fs::remove_dir_all(dir).unwrap();
}
