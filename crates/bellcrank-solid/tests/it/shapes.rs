//! Shapes with known volume, centre and inertia.

use bellcrank_solid::{Link, Profile};

use crate::parts::{bar, eye, link};

fn volume(link: &Link<f64>) -> f64 {
    link.build().expect("a sound link").moments.volume
}

#[test]
fn smoke() {
    use std::f64::consts::PI;
    let ring = Link { eyes: vec![eye([0.3, -0.7], 0.04, 0.1, [-0.013, 0.027])], ..link() };
    let v = volume(&ring);
    let e = PI / 4.0 * (0.01 - 0.0016) * 0.04;
    println!("{v} {e} {}", v / e - 1.0);
    let (c, s) = (0.3_f64.cos(), 0.3_f64.sin());
    let mut l = Link {
        eyes: vec![
            eye([0.3, -0.7], 0.04, 0.1, [-0.01, 0.01]),
            eye([0.3 + 0.5 * c, -0.7 + 0.5 * s], 0.03, 0.1, [-0.01, 0.01]),
        ],
        webs: vec![bar([0, 1], [0.1, 0.1], [-0.01, 0.01], Profile::Flat)],
        ..link()
    };
    let st = l.build().unwrap();
    let e = (0.5 * 0.1 + PI / 4.0 * (0.01 - 0.0016 - 0.0009)) * 0.02;
    println!(
        "{} {} edges {} vertices {} cells {} {:?}",
        st.moments.volume / e - 1.0,
        e,
        st.edges.len(),
        st.vertices.len(),
        st.cells.len(),
        st.levels
    );
    l.webs = vec![bar([0, 1], [0.06, 0.05], [-0.008, 0.008], Profile::Box { wall: 0.01, skin: 0.002 })];
    l.fillet = Some(0.005);
    let st = l.build();
    match st {
        Ok(st) => println!(
            "{} edges {} vertices {} cells {} {:?}",
            st.moments.volume,
            st.edges.len(),
            st.vertices.len(),
            st.cells.len(),
            st.levels
        ),
        Err(e) => println!("{e:?}"),
    }
}
