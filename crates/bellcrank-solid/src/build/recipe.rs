//! A link as outlines in one plane and what is joined and taken away within them.

use bellcrank_math::Real;

use super::scale::Scale;
use crate::plane::outline::{Outline, bar, disc, doubled_area, hull, polygon, rounded};
use crate::plane::vector::values;
use crate::{Bar, Corner, Cut, CutShape, Link, Part, Plate, Profile, Web};

/// An interval along z; open where it has no end.
pub(crate) type Layer<T> = [Option<T>; 2];

/// Outlines and the pieces made of them.
pub(crate) struct Recipe<T> {
    pub(crate) outlines: Vec<Outline<T>>,
    pub(crate) pieces: Vec<Piece<T>>,
}

/// What a piece is.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Kind {
    /// Joined, for this part.
    Joined(Part),
    /// The hole of an eye.
    Bore(usize),
    /// The room round an eye.
    Clearance(usize),
    /// Taken away by this cut.
    Cut(usize),
}

/// What is inside an outline, in some layers.
#[derive(Clone, Debug)]
pub(crate) struct Piece<T> {
    pub(crate) kind: Kind,
    pub(crate) outline: usize,
    pub(crate) layers: Vec<Layer<T>>,
    /// An outline left out, and outlines within which it is not left out.
    pub(crate) cavity: Option<(usize, Vec<usize>)>,
}

impl<T> Piece<T> {
    /// Whether a place is in it that is within these outlines.
    pub(crate) fn holds(&self, within: &[bool]) -> bool {
        let cavity = |(out, except): &(usize, Vec<usize>)| within[*out] && !except.iter().any(|e| within[*e]);
        within[self.outline] && !self.cavity.as_ref().is_some_and(cavity)
    }

    pub(crate) fn joins(&self) -> bool {
        matches!(self.kind, Kind::Joined(_))
    }
}

impl<T: Real> Recipe<T> {
    /// The recipe of a link that has no faults.
    pub(crate) fn new(link: &Link<T>, scale: Scale) -> Self {
        let mut recipe = Recipe { outlines: Vec::new(), pieces: Vec::new() };
        // An eye's disc has the place of the eye among the outlines.
        for (i, eye) in link.eyes.iter().enumerate() {
            let outline = recipe.outline(disc(eye.center, half(eye.outer)));
            recipe.piece(Kind::Joined(Part::Eye(i)), outline, closed(&eye.layers));
        }
        for (i, web) in link.webs.iter().enumerate() {
            match web {
                Web::Bar(bar) => recipe.bar(link, i, bar),
                Web::Hull { eyes, layers } => {
                    let discs: Vec<_> =
                        eyes.iter().map(|e| (link.eyes[*e].center, half(link.eyes[*e].outer))).collect();
                    let outline = recipe.outline(hull(&discs, scale.tolerance).unwrap_or_default());
                    recipe.piece(Kind::Joined(Part::Web(i)), outline, closed(layers));
                }
            }
        }
        for (i, Plate { outline, layers }) in link.plates.iter().enumerate() {
            let outline = recipe.outline(corners(outline));
            recipe.piece(Kind::Joined(Part::Plate(i)), outline, closed(layers));
        }
        recipe.holes(link);
        link.cuts.iter().enumerate().for_each(|(i, cut)| recipe.cut(i, cut, scale));
        recipe
    }

    pub(crate) fn outline(&mut self, outline: Outline<T>) -> usize {
        self.outlines.push(outline);
        self.outlines.len() - 1
    }

    pub(crate) fn piece(&mut self, kind: Kind, outline: usize, layers: Vec<Layer<T>>) {
        self.pieces.push(Piece { kind, outline, layers, cavity: None });
    }

    fn bar(&mut self, link: &Link<T>, i: usize, form: &Bar<T>) {
        let kind = Kind::Joined(Part::Web(i));
        let ends = form.eyes.map(|e| link.eyes[e].center);
        let outline = self.outline(bar(ends, form.widths));
        let two = T::from_f64(2.0);
        let (sides, full, hollow): (T, Vec<Layer<T>>, Vec<Layer<T>>) = match form.profile {
            Profile::Flat => return self.piece(kind, outline, closed(&form.layers)),
            Profile::Box { wall, skin } => {
                let skins = form.layers.iter().flat_map(|[a, b]| [[*a, *a + skin], [*b - skin, *b]]);
                let skins: Vec<[T; 2]> = skins.filter(|_| skin.value() > 0.0).collect();
                let room: Vec<[T; 2]> = form.layers.iter().map(|[a, b]| [*a + skin, *b - skin]).collect();
                (wall, closed(&skins), closed(&room))
            }
            Profile::I { flange, web } => {
                let middle = |[a, b]: &[T; 2]| [(*a + *b - web) / two, (*a + *b + web) / two];
                let webs: Vec<[T; 2]> = form.layers.iter().map(middle).collect();
                let room = form.layers.iter().zip(&webs).flat_map(|([a, b], [c, d])| [[*a, *c], [*d, *b]]);
                (flange, closed(&webs), closed(&room.collect::<Vec<_>>()))
            }
        };
        let cavity = self.outline(bar(ends, form.widths.map(|w| w - two * sides)));
        self.piece(kind, outline, full);
        self.piece(kind, outline, hollow);
        if let Some(piece) = self.pieces.last_mut() {
            piece.cavity = Some((cavity, form.eyes.to_vec()));
        }
    }

    /// Bores, through everything, and the room round eyes, outside their layers.
    fn holes(&mut self, link: &Link<T>) {
        for (i, eye) in link.eyes.iter().enumerate() {
            if eye.bore.value() > 0.0 {
                let outline = self.outline(disc(eye.center, half(eye.bore)));
                self.piece(Kind::Bore(i), outline, vec![[None, None]]);
            }
            if let Some(clearance) = eye.clearance {
                let outline = self.outline(disc(eye.center, half(clearance)));
                self.piece(Kind::Clearance(i), outline, outside(&eye.layers));
            }
        }
    }

    fn cut(&mut self, i: usize, cut: &Cut<T>, scale: Scale) {
        let outline = match &cut.shape {
            CutShape::Hole { center, diameter } => disc(*center, half(*diameter)),
            CutShape::Slot { from, to, width } => {
                hull(&[(*from, half(*width)), (*to, half(*width))], scale.tolerance).unwrap_or_default()
            }
            CutShape::Outline(places) => corners(places),
        };
        let outline = self.outline(outline);
        let layers = cut.layers.as_ref().map_or(vec![[None, None]], |layers| closed(layers));
        self.piece(Kind::Cut(i), outline, layers);
    }
}

fn half<T: Real>(diameter: T) -> T {
    diameter * T::from_f64(0.5)
}

fn closed<T: Real>(layers: &[[T; 2]]) -> Vec<Layer<T>> {
    layers.iter().map(|ends| ends.map(Some)).collect()
}

/// What some intervals leave of the z axis.
fn outside<T: Real>(layers: &[[T; 2]]) -> Vec<Layer<T>> {
    let mut sorted = layers.to_vec();
    sorted.sort_by(|a, b| a[0].value().total_cmp(&b[0].value()));
    let mut gaps = Vec::new();
    let mut top: Option<T> = None;
    for [low, high] in sorted {
        if top.is_none_or(|t| t.value() < low.value()) {
            gaps.push([top, Some(low)]);
        }
        if top.is_none_or(|t| t.value() < high.value()) {
            top = Some(high);
        }
    }
    gaps.push([top, None]);
    gaps
}

/// An outline with round corners, counter-clockwise.
fn corners<T: Real>(corners: &[Corner<T>]) -> Outline<T> {
    let places: Vec<_> = corners.iter().map(|c| values(c.at)).collect();
    let mut corners: Vec<_> = corners.iter().map(|c| (c.at, c.radius)).collect();
    if doubled_area(&places) < 0.0 {
        corners.reverse();
    }
    if corners.iter().all(|c| c.1.value() == 0.0) {
        return polygon(&corners.iter().map(|c| c.0).collect::<Vec<_>>());
    }
    rounded(&corners)
}
