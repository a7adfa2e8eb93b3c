//! Short ways to say links.

use bellcrank_math::Real;
use bellcrank_solid::{Bar, Corner, Cut, CutShape, Eye, Link, Plate, Profile, Web};

pub(crate) fn link<T: Real>() -> Link<T> {
    Link { eyes: Vec::new(), webs: Vec::new(), plates: Vec::new(), cuts: Vec::new(), fillet: None }
}

pub(crate) fn eye<T: Real>(center: [T; 2], bore: T, outer: T, layer: [T; 2]) -> Eye<T> {
    Eye { center, bore, outer, layers: vec![layer], clearance: None }
}

pub(crate) fn bar<T: Real>(eyes: [usize; 2], widths: [T; 2], layer: [T; 2], profile: Profile<T>) -> Web<T> {
    Web::Bar(Bar { eyes, widths, layers: vec![layer], profile })
}

pub(crate) fn corners<T: Real>(places: &[([T; 2], T)]) -> Vec<Corner<T>> {
    places.iter().map(|(at, radius)| Corner { at: *at, radius: *radius }).collect()
}

pub(crate) fn plate<T: Real>(places: &[([T; 2], T)], layer: [T; 2]) -> Plate<T> {
    Plate { outline: corners(places), layers: vec![layer] }
}

pub(crate) fn through<T: Real>(shape: CutShape<T>) -> Cut<T> {
    Cut { shape, layers: None }
}
