//! A link on the points of a body, in numbers.

use bellcrank_multibody::Place;
use bellcrank_solid::{Bar, Corner, Cut, CutShape, Eye, Link, Plate, Profile, Web};

use crate::build::Numbers;
use crate::design::{
    CornerForm, CutForm, CutKind, EyeForm, Height, LinkForm, Plane, PlateForm, ProfileForm, Quantity, Solid, Spot,
    WebForm, WebKind, Worn,
};
use crate::scalar::Scalar;

/// Intervals along the axis.
type Layers<T> = Vec<[T; 2]>;

/// A solid while it is laid on a body.
pub(super) struct Laying<'n, 'a, T: Scalar> {
    pub(super) numbers: &'n mut Numbers<'a, T>,
    pub(super) solid: &'n Solid,
    pub(super) worn: &'n Worn,
    /// The points of the body.
    pub(super) places: &'n [Place<T>],
}

impl<T: Scalar> Laying<'_, '_, T> {
    /// The link; what its numbers cannot be is reported.
    pub(super) fn link(&mut self, form: &LinkForm) -> Link<T> {
        let fillet = form.fillet.as_ref();
        let fillet = fillet.map(|fillet| self.not_negative(fillet, "fillet", "", "")).filter(|one| one.value() > 0.0);
        Link {
            eyes: form.eyes.iter().map(|eye| self.eye(form.plane, eye)).collect(),
            webs: form.webs.iter().map(|web| self.web(web)).collect(),
            plates: form.plates.iter().map(|plate| self.plate(form.plane, plate)).collect(),
            cuts: form.cuts.iter().map(|cut| self.cut(form.plane, cut)).collect(),
            fillet,
        }
    }

    fn eye(&mut self, plane: Plane, eye: &EyeForm) -> Eye<T> {
        let name = &eye.name;
        Eye {
            center: self.plan(plane, &eye.at, "eye", name),
            bore: self.not_negative(&eye.bore, "bore", "eye", name),
            outer: self.above_zero(&eye.outer, "outer", "eye", name),
            layers: self.layers(&eye.height, "width", "eye", name),
            clearance: eye.clearance.as_ref().map(|one| self.above_zero(one, "clearance", "eye", name)),
        }
    }

    fn web(&mut self, web: &WebForm) -> Web<T> {
        let name = &web.name;
        let layers = self.layers(&web.height, "thickness", "web", name);
        match (&web.kind, web.eyes.as_slice()) {
            (WebKind::Bar(bar), &[a, b]) => Web::Bar(Bar {
                eyes: [a, b],
                widths: std::array::from_fn(|k| self.above_zero(&bar.widths[k], "width", "web", name)),
                layers,
                profile: self.profile(&bar.profile, name),
            }),
            _ => Web::Hull { eyes: web.eyes.clone(), layers },
        }
    }

    fn profile(&mut self, profile: &ProfileForm, web: &str) -> Profile<T> {
        match profile {
            ProfileForm::Flat => Profile::Flat,
            ProfileForm::Box { wall, skin } => Profile::Box {
                wall: self.above_zero(wall, "wall", "web", web),
                skin: self.not_negative(skin, "skin", "web", web),
            },
            ProfileForm::I { flange, web: thin } => Profile::I {
                flange: self.above_zero(flange, "flange", "web", web),
                web: self.above_zero(thin, "web", "web", web),
            },
        }
    }

    fn plate(&mut self, plane: Plane, plate: &PlateForm) -> Plate<T> {
        Plate {
            outline: self.outline(plane, &plate.outline, "plate", &plate.name),
            layers: self.layers(&plate.height, "thickness", "plate", &plate.name),
        }
    }

    fn outline(&mut self, plane: Plane, outline: &[CornerForm], kind: &str, name: &str) -> Vec<Corner<T>> {
        let mut corner = |corner: &CornerForm| Corner {
            at: self.plan(plane, &corner.at, kind, name),
            radius: corner.radius.as_ref().map_or(T::zero(), |one| self.not_negative(one, "radius", kind, name)),
        };
        outline.iter().map(&mut corner).collect()
    }

    fn cut(&mut self, plane: Plane, cut: &CutForm) -> Cut<T> {
        let name = &cut.name;
        let shape = match &cut.kind {
            CutKind::Hole { at, diameter } => CutShape::Hole {
                center: self.plan(plane, at, "cut", name),
                diameter: self.above_zero(diameter, "diameter", "cut", name),
            },
            CutKind::Slot { from, to, width } => CutShape::Slot {
                from: self.plan(plane, from, "cut", name),
                to: self.plan(plane, to, "cut", name),
                width: self.above_zero(width, "width", "cut", name),
            },
            CutKind::Outline(outline) => CutShape::Outline(self.outline(plane, outline, "cut", name)),
        };
        Cut { shape, layers: cut.height.as_ref().map(|height| self.layers(height, "thickness", "cut", name)) }
    }

    fn plan(&mut self, plane: Plane, spot: &Spot, kind: &str, name: &str) -> [T; 2] {
        match spot {
            Spot::Point(_) => {
                let place = self.place(spot);
                let [right, up, _] = plane.axes();
                [place[right], place[up]]
            }
            Spot::At(at) => {
                let solid = &self.solid.name;
                let [x, y, _] = self.numbers.vector(at, format_args!("a place of {kind} `{name}` of solid `{solid}`"));
                [x, y]
            }
        }
    }

    /// A place in body axes.
    pub(super) fn place(&mut self, spot: &Spot) -> [T; 3] {
        match spot {
            Spot::Point(point) => {
                let point = self.worn.points.get(*point).and_then(|&point| self.places.get(point));
                point.map_or([T::zero(); 3], |place| place.position)
            }
            Spot::At(at) => self.numbers.vector(at, format_args!("`at` of solid `{}`", self.solid.name)),
        }
    }

    fn layers(&mut self, height: &Height, key: &str, kind: &str, name: &str) -> Layers<T> {
        match height {
            Height::Middle { thickness, offset } => {
                let half = self.above_zero(thickness, key, kind, name) / T::from_f64(2.0);
                let middle = offset.as_ref().map_or(T::zero(), |one| self.number(one, "offset", kind, name));
                vec![[middle - half, middle + half]]
            }
            Height::Layers(layers) => layers.iter().map(|pair| self.layer(pair, kind, name)).collect(),
        }
    }

    fn layer(&mut self, pair: &[Quantity; 2], kind: &str, name: &str) -> [T; 2] {
        let [low, high] = [&pair[0], &pair[1]].map(|one| self.number(one, "layers", kind, name));
        if low.value() >= high.value() {
            let solid = &self.solid.name;
            let message = format!("a layer of {kind} `{name}` of solid `{solid}` does not end above its beginning");
            self.numbers.report("out-of-range", pair[0].span().to(pair[1].span()), message);
        }
        [low, high]
    }

    fn number(&mut self, quantity: &Quantity, key: &str, kind: &str, name: &str) -> T {
        let solid = &self.solid.name;
        self.numbers.number(quantity, format_args!("`{key}` of {kind} `{name}` of solid `{solid}`"))
    }

    fn above_zero(&mut self, quantity: &Quantity, key: &str, kind: &str, name: &str) -> T {
        let solid = &self.solid.name;
        self.numbers.above_zero(quantity, format_args!("`{key}` of {kind} `{name}` of solid `{solid}`"))
    }

    fn not_negative(&mut self, quantity: &Quantity, key: &str, kind: &str, name: &str) -> T {
        let solid = &self.solid.name;
        match kind {
            "" => self.numbers.positive(quantity, format_args!("`{key}` of solid `{solid}`")),
            _ => self.numbers.positive(quantity, format_args!("`{key}` of {kind} `{name}` of solid `{solid}`")),
        }
    }
}
