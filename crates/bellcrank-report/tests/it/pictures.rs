//! Pictures of parts: as files, in the page, and where there is nothing to draw.

use std::io::Cursor;

use bellcrank_report::{PictureFile, pictures, render_html, write_run};
use bellcrank_results::{Contour, ContourShape, StudyResult};

use crate::markup::{assert_balanced, between, unpacked};
use crate::sample::{lift, stress};

const ABOVE: [u8; 3] = [0xd6, 0x1c, 0x8c];

/// Pixels of a picture, three bytes each, with its width.
fn decoded(picture: &PictureFile) -> (Vec<[u8; 3]>, usize) {
    let mut reader = png::Decoder::new(Cursor::new(&picture.png)).read_info().unwrap();
    let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
    let frame = reader.next_frame(&mut bytes).unwrap();
    assert_eq!((frame.width as usize, frame.height as usize), picture.size);
    (bytes.as_chunks::<3>().0.to_vec(), frame.width as usize)
}

fn only(contour: Contour) -> PictureFile {
    let study = StudyResult { contours: vec![contour], ..StudyResult::default() };
    pictures(&study).pop().flatten().unwrap()
}

/// Pixels of about that hue: light changes how bright they are.
fn count_like(picture: &PictureFile, colour: [u8; 3]) -> usize {
    let direction = |c: [u8; 3]| {
        let length = c.iter().map(|x| f64::from(*x).powi(2)).sum::<f64>().sqrt().max(1.0);
        c.map(|x| f64::from(x) / length)
    };
    let wanted = direction(colour);
    let near = |c: &&[u8; 3]| direction(**c).iter().zip(wanted).all(|(a, b)| (a - b).abs() < 0.04);
    decoded(picture).0.iter().filter(near).count()
}

#[test]
fn what_lies_above_the_ceiling_has_its_own_colour() {
    let mut contour = stress::bracket();
    let cut = count_like(&only(contour.clone()), ABOVE);
    contour.shapes[0].fields[0].ceiling = None;
    let whole = count_like(&only(contour), ABOVE);
    assert!(cut > 700 && whole < 20, "{cut} {whole}");
}

#[test]
fn each_contour_is_a_file_beside_the_curves() {
    let dir = std::env::temp_dir().join(format!("bellcrank-report-{}-pictures", std::process::id()));
    let written = write_run(&stress::run(), &dir, bellcrank_report::Exports::default()).unwrap();
    for name in [
        "stress/strip_stress_under_60_MPa_tension.png",
        "stress/bracket_stress_at_joint.B.position_-30_deg.png",
        "swinging/bar_mode_shapes_clamped_at_its_left_end.png",
    ] {
        let path = dir.join(name);
        assert!(written.contains(&path) && path.is_file(), "{name}");
    }
    std::fs::remove_dir_all(dir).unwrap();
}

#[test]
fn pictures_stand_in_the_page_and_only_where_there_are_some() {
    let page = render_html(&stress::run());
    assert_balanced(&page);
    assert_eq!(page.matches("<img src=\"data:image/png;base64,iVBORw0KGgo").count(), 3);
    assert!(page.contains("alt=\"strip: stress under 60 MPa tension\""));
}

/// What the page holds of a contour: its description and its numbers, unpacked.
fn held(page: &str, key: &str) -> (serde_json::Value, Vec<u8>) {
    let catalogue: serde_json::Value =
        serde_json::from_str(between(page, "id=\"bellcrank-contours\">", "</script>")).unwrap();
    let described = catalogue["contours"].as_array().unwrap().iter().find(|part| part["key"] == key).unwrap().clone();
    let packed = between(page, &format!("id=\"bellcrank-contour-{key}\">"), "</script>");
    (described, unpacked(packed))
}

#[test]
fn the_page_holds_the_numbers_of_each_contour() {
    let run = stress::run();
    let page = render_html(&run);
    for (key, contour) in [
        ("0-0", &run.studies[0].contours[0]),
        ("0-1", &run.studies[0].contours[1]),
        ("1-0", &run.studies[1].contours[0]),
    ] {
        let (described, bytes) = held(&page, key);
        let nodes = contour.nodes.len();
        assert_eq!(described["nodes"], nodes);
        assert_eq!(described["shapes"].as_array().unwrap().len(), contour.shapes.len());
        let fields: usize = contour.shapes.iter().map(|shape| shape.fields.len()).sum();
        let pairs = described["edges"].as_u64().unwrap() + described["outline"].as_u64().unwrap();
        // Each edge of the samples is named by the two faces beside it.
        assert_eq!(2 * described["edges"].as_u64().unwrap() as usize, contour.edges.len());
        let expected = 9 * nodes + 12 * contour.triangles.len() + 8 * pairs as usize + 4 * nodes;
        assert_eq!(bytes.len(), expected + nodes * (6 * contour.shapes.len() + 2 * fields), "{key}");
    }
    assert!(page.len() < 1_400_000, "{}", page.len());
}

#[test]
fn the_script_of_parts_comes_once_and_only_with_parts() {
    let page = render_html(&stress::run());
    assert_eq!(page.matches("id=\"bellcrank-solid\"").count(), 1);
    assert_eq!(page.matches("data-contour=\"").count(), 3);
    let without = render_html(&lift::run());
    assert!(!without.contains("bellcrank-contour") && !without.contains(".contour"));
}

#[test]
fn gaps_in_the_numbers_are_grey_and_nothing_ends_the_run() {
    let mut contour = stress::bracket();
    contour.shapes[0].fields[0].values.truncate(40);
    contour.shapes[0].displacement[3] = [f32::NAN; 3];
    contour.shapes[0].displacement.truncate(90);
    assert!(count_like(&only(contour), [0xb4, 0xbb, 0xc2]) > 10_000);
    let bare = Contour { shapes: Vec::new(), marks: Vec::new(), ..stress::bracket() };
    assert!(count_like(&only(bare), [0xb4, 0xbb, 0xc2]) > 10_000);
    let without_fields = ContourShape { fields: Vec::new(), ..stress::bar().shapes.remove(0) };
    assert!(only(Contour { shapes: vec![without_fields], ..stress::bar() }).png.len() > 10_000);
}

#[test]
fn without_a_sound_surface_there_is_no_picture() {
    let none = Contour { triangles: Vec::new(), ..stress::bar() };
    let broken = Contour { triangles: vec![[0, 1, 9_999_999]], ..stress::bar() };
    let mut nowhere = stress::bar();
    nowhere.nodes[7] = [f32::NAN; 3];
    let study = StudyResult { contours: vec![none, broken, nowhere], ..StudyResult::default() };
    assert!(pictures(&study).iter().all(Option::is_none));
}

#[test]
fn names_of_contours_cannot_break_the_page() {
    let mut run = stress::run();
    let evil = "</script><img src=x onerror=alert(1)>\"'&\u{1b}[2J";
    for contour in run.studies.iter_mut().flat_map(|study| &mut study.contours) {
        evil.clone_into(&mut contour.title);
        contour.marks.iter_mut().for_each(|mark| evil.clone_into(&mut mark.label));
        for shape in &mut contour.shapes {
            evil.clone_into(&mut shape.name);
            for field in &mut shape.fields {
                evil.clone_into(&mut field.name);
                evil.clone_into(&mut field.unit.symbol);
            }
        }
    }
    let page = render_html(&run);
    assert_balanced(&page);
    assert!(!page.contains("<img src=x"));
}
