//! What is wrong with the numbers of a link, before anything is built of them.

use bellcrank_math::Real;

use super::scale::Scale;
use crate::plane::outline::{crossing_sides, doubled_area, setback};
use crate::plane::vector::{Point, distance, values};
use crate::{Bar, Corner, CutShape, Fault, Link, Part, Profile, Quantity, Web};

/// Parts with a number that is not finite.
pub(crate) fn not_finite<T: Real>(link: &Link<T>) -> Vec<Fault> {
    let eyes = link.eyes.iter().enumerate().map(|(i, eye)| {
        let mut numbers = vec![eye.center[0], eye.center[1], eye.bore, eye.outer];
        numbers.extend(eye.clearance);
        numbers.extend(eye.layers.iter().flatten());
        (Part::Eye(i), numbers)
    });
    let webs = link.webs.iter().enumerate().map(|(i, web)| (Part::Web(i), web_numbers(web)));
    let plates = link.plates.iter().enumerate().map(|(i, plate)| {
        let mut numbers = corner_numbers(&plate.outline);
        numbers.extend(plate.layers.iter().flatten());
        (Part::Plate(i), numbers)
    });
    let cuts = link.cuts.iter().enumerate().map(|(i, cut)| {
        let mut numbers = cut_numbers(&cut.shape);
        numbers.extend(cut.layers.iter().flatten().flatten());
        (Part::Cut(i), numbers)
    });
    let fillet = (Part::Fillet, link.fillet.into_iter().collect());
    let all = eyes.chain(webs).chain(plates).chain(cuts).chain([fillet]);
    all.filter(|(_, numbers)| numbers.iter().any(|x: &T| !x.value().is_finite()))
        .map(|(part, _)| Fault::NotFinite { part })
        .collect()
}

fn web_numbers<T: Real>(web: &Web<T>) -> Vec<T> {
    let (layers, mut numbers) = match web {
        Web::Bar(bar) => {
            let profile = match bar.profile {
                Profile::Flat => Vec::new(),
                Profile::Box { wall, skin } => vec![wall, skin],
                Profile::I { flange, web } => vec![flange, web],
            };
            (&bar.layers, [bar.widths.to_vec(), profile].concat())
        }
        Web::Hull { layers, .. } => (layers, Vec::new()),
    };
    numbers.extend(layers.iter().flatten());
    numbers
}

fn corner_numbers<T: Real>(corners: &[Corner<T>]) -> Vec<T> {
    corners.iter().flat_map(|c| [c.at[0], c.at[1], c.radius]).collect()
}

fn cut_numbers<T: Real>(shape: &CutShape<T>) -> Vec<T> {
    match shape {
        CutShape::Hole { center, diameter } => vec![center[0], center[1], *diameter],
        CutShape::Slot { from, to, width } => vec![from[0], from[1], to[0], to[1], *width],
        CutShape::Outline(corners) => corner_numbers(corners),
    }
}

/// Everything wrong with sizes, layers, webs and outlines. The numbers are finite.
pub(crate) fn faults<T: Real>(link: &Link<T>, scale: Scale) -> Vec<Fault> {
    let mut check = Check { scale, faults: Vec::new() };
    check.eyes(link);
    link.webs.iter().enumerate().for_each(|(i, web)| check.web(link, i, web));
    for (i, plate) in link.plates.iter().enumerate() {
        check.layers(Part::Plate(i), &plate.layers);
        check.outline(Part::Plate(i), &plate.outline);
    }
    check.cuts(link);
    if let Some(radius) = link.fillet {
        check.positive_or_none(Part::Fillet, Quantity::Radius, radius);
    }
    if link.eyes.is_empty() && link.plates.is_empty() {
        check.faults.push(Fault::Empty);
    }
    check.faults
}

struct Check {
    scale: Scale,
    faults: Vec<Fault>,
}

impl Check {
    fn add(&mut self, wrong: bool, fault: Fault) {
        if wrong {
            self.faults.push(fault);
        }
    }

    /// A length that must be there and be more than rounding.
    fn positive<T: Real>(&mut self, part: Part, quantity: Quantity, value: T) {
        let (value, least) = (value.value(), self.scale.least);
        self.add(value <= 0.0, Fault::NotPositive { part, quantity, value });
        self.add(value > 0.0 && value < least, Fault::TooSmall { part, quantity, value, least });
    }

    /// A length that may be zero.
    fn positive_or_none<T: Real>(&mut self, part: Part, quantity: Quantity, value: T) {
        if value.value() != 0.0 {
            self.positive(part, quantity, value);
        }
    }

    fn layers<T: Real>(&mut self, part: Part, layers: &[[T; 2]]) {
        self.add(layers.is_empty(), Fault::NoLayers { part });
        for (layer, ends) in layers.iter().enumerate() {
            let interval = values(*ends);
            self.add(interval[1] - interval[0] < self.scale.least, Fault::Layer { part, layer, interval });
            let far = interval[0].abs().max(interval[1].abs());
            self.add(far > 1e6, Fault::Extent { extent: far });
        }
    }

    fn eyes<T: Real>(&mut self, link: &Link<T>) {
        for (i, eye) in link.eyes.iter().enumerate() {
            let part = Part::Eye(i);
            self.layers(part, &eye.layers);
            self.positive_or_none(part, Quantity::Bore, eye.bore);
            self.positive(part, Quantity::Outer, eye.outer);
            if let Some(clearance) = eye.clearance {
                self.positive(part, Quantity::Clearance, clearance);
            }
            let (bore, outer) = (eye.bore.value(), eye.outer.value());
            let thin = bore > 0.0 && outer > 0.0 && outer - bore < self.scale.least;
            self.add(thin, Fault::EyeThinnerThanBore { eye: i, bore, outer });
        }
    }

    fn web<T: Real>(&mut self, link: &Link<T>, i: usize, web: &Web<T>) {
        let (eyes, layers) = match web {
            Web::Bar(bar) => (&bar.eyes[..], &bar.layers),
            Web::Hull { eyes, layers } => (&eyes[..], layers),
        };
        self.layers(Part::Web(i), layers);
        self.add(eyes.len() < 2, Fault::TooFewEyes { web: i, count: eyes.len() });
        for eye in eyes.iter().filter(|eye| **eye >= link.eyes.len()) {
            self.faults.push(Fault::NoSuchEye { web: i, eye: *eye });
        }
        let known: Vec<usize> = eyes.iter().copied().filter(|eye| *eye < link.eyes.len()).collect();
        for eye in &known {
            let gap = gap(layers, &link.eyes[*eye].layers);
            self.add(gap > self.scale.tolerance, Fault::WebMissesEye { web: i, eye: *eye, gap });
        }
        let place = |eye: usize| values(link.eyes[eye].center);
        let short = known.iter().all(|eye| distance(place(*eye), place(known[0])) < self.scale.least);
        self.add(short && known.len() > 1, Fault::WebOfNoLength { web: i });
        if let Web::Bar(bar) = web {
            self.bar(i, bar);
        }
    }

    fn bar<T: Real>(&mut self, web: usize, bar: &Bar<T>) {
        let part = Part::Web(web);
        self.positive(part, Quantity::Width, bar.widths[0]);
        self.positive(part, Quantity::SecondWidth, bar.widths[1]);
        let width = bar.widths[0].value().min(bar.widths[1].value());
        let height = bar.layers.iter().map(|l| (l[1] - l[0]).value()).fold(f64::INFINITY, f64::min);
        let least = self.scale.least;
        match bar.profile {
            Profile::Flat => {}
            Profile::Box { wall, skin } => {
                self.positive(part, Quantity::Wall, wall);
                self.positive_or_none(part, Quantity::Skin, skin);
                let (wall, skin) = (wall.value(), skin.value());
                let quantity = Quantity::Wall;
                self.add(width - 2.0 * wall < least, Fault::WallsMeet { web, quantity, value: wall, width });
                let quantity = Quantity::Skin;
                self.add(height - 2.0 * skin < least, Fault::SkinsMeet { web, quantity, value: skin, height });
            }
            Profile::I { flange, web: thin } => {
                self.positive(part, Quantity::Flange, flange);
                self.positive(part, Quantity::Web, thin);
                let (flange, thin) = (flange.value(), thin.value());
                let quantity = Quantity::Flange;
                self.add(width - 2.0 * flange < least, Fault::WallsMeet { web, quantity, value: flange, width });
                let quantity = Quantity::Web;
                self.add(height - thin < 2.0 * least, Fault::SkinsMeet { web, quantity, value: thin, height });
            }
        }
    }

    fn cuts<T: Real>(&mut self, link: &Link<T>) {
        for (i, cut) in link.cuts.iter().enumerate() {
            let part = Part::Cut(i);
            if let Some(layers) = &cut.layers {
                self.layers(part, layers);
            }
            match &cut.shape {
                CutShape::Hole { diameter, .. } => self.positive(part, Quantity::Diameter, *diameter),
                CutShape::Slot { width, .. } => self.positive(part, Quantity::Width, *width),
                CutShape::Outline(corners) => self.outline(part, corners),
            }
        }
    }

    fn outline<T: Real>(&mut self, part: Part, corners: &[Corner<T>]) {
        let count = corners.len();
        self.add(count < 3, Fault::TooFewCorners { part, count });
        let places: Vec<Point<f64>> = corners.iter().map(|c| values(c.at)).collect();
        let side = |i: usize| distance(places[i], places[(i + 1) % count]);
        let short: Vec<usize> = (0..count).filter(|i| side(*i) < self.scale.least).collect();
        corners.iter().for_each(|c| self.positive_or_none(part, Quantity::Radius, c.radius));
        if count < 3 {
            return;
        }
        self.faults.extend(short.iter().map(|i| Fault::SideOfNoLength { part, corner: (i + 1) % count }));
        if !short.is_empty() {
            return;
        }
        let crossings = crossing_sides(&places, self.scale.tolerance);
        self.faults.extend(crossings.iter().map(|sides| Fault::SidesCross { part, sides: *sides }));
        if crossings.is_empty() && doubled_area(&places).abs() > 0.0 {
            self.radii(part, corners, &places);
        }
    }

    fn radii<T: Real>(&mut self, part: Part, corners: &[Corner<T>], places: &[Point<f64>]) {
        let n = corners.len();
        let back = |i: usize| {
            let around = [places[(i + n - 1) % n], places[i], places[(i + 1) % n]];
            setback(around, corners[i].radius.value()).unwrap_or(f64::INFINITY)
        };
        for i in 0..n {
            let j = (i + 1) % n;
            let (needed, length) = (back(i) + back(j), distance(places[i], places[j]));
            let radii = [corners[i].radius.value(), corners[j].radius.value()];
            let fault = Fault::RadiusTooLarge { part, corners: [i, j], radii, needed, length };
            self.add(needed > length + self.scale.tolerance, fault);
        }
    }
}

/// Least distance between two sets of intervals; zero where they touch, and where one is missing altogether.
fn gap<T: Real>(a: &[[T; 2]], b: &[[T; 2]]) -> f64 {
    if a.is_empty() || b.is_empty() {
        return 0.0;
    }
    let pairs = a.iter().flat_map(|a| b.iter().map(move |b| (values(*a), values(*b))));
    pairs.map(|(a, b)| (a[0] - b[1]).max(b[0] - a[1]).max(0.0)).fold(f64::INFINITY, f64::min)
}
