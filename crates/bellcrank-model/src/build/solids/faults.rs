//! What keeps a solid from being made, in names and places of the file.

use bellcrank_doc::{Diagnostic, Severity, Span};
use bellcrank_solid::{Fault, Part, Quantity as Length};

use crate::design::{CutKind, Design, Height, LinkForm, ProfileForm, Quantity, Solid, SolidForm, WebKind, Worn};
use crate::measure::Measure;
use crate::run::shown;

/// The report of a fault; a warning where the solid can be made all the same.
pub(super) fn report(design: &Design, solid: &Solid, worn: &Worn, fault: &Fault) -> Diagnostic {
    let teller = Teller { design, solid };
    let report = teller.report(fault);
    let severity = if fault.is_warning() { Severity::Warning } else { Severity::Error };
    let report = Diagnostic { severity, ..report };
    let others = |other: &&Worn| other.solid == worn.solid;
    let alone = design.bodies.iter().filter_map(|body| body.solid.as_ref()).filter(others).count() == 1;
    if alone { report } else { report.also(worn.span, "on the points of this body") }
}

struct Teller<'a> {
    design: &'a Design,
    solid: &'a Solid,
}

impl Teller<'_> {
    fn report(&self, fault: &Fault) -> Diagnostic {
        let what = |part| self.what(part);
        let long = |length: f64| self.length(length);
        match fault {
            Fault::NotFinite { part } => self.error(*part, format!("{} has a number that is not finite", what(*part))),
            Fault::Empty => self.error_of(self.solid.span, format!("{} has nothing in it", self.name())),
            Fault::Extent { extent } => {
                let message = format!("{} reaches over {}", self.name(), long(*extent));
                self.error_of(self.solid.span, message)
                    .hint("solids are larger than 0.001 mm and smaller than 1000 km; a unit may be wrong")
            }
            Fault::NotPositive { part, quantity, value } => {
                let message = format!("{} must be above zero, found {}", self.key_of(*part, *quantity), long(*value));
                self.error_at(*part, *quantity, message)
            }
            Fault::TooSmall { part, quantity, value, least } => {
                let message =
                    format!("{} is {}, too thin to be told from rounding", self.key_of(*part, *quantity), long(*value));
                self.error_at(*part, *quantity, message)
                    .hint(format!("{} is the least in a solid of this size", long(*least)))
            }
            Fault::EyeThinnerThanBore { eye, bore, outer } => {
                let part = Part::Eye(*eye);
                let message =
                    format!("`outer` of {} is {}, no more than its bore, {}", what(part), long(*outer), long(*bore));
                let report =
                    self.error_at(part, Length::Outer, message).also(self.span_of(part, Length::Bore), "the bore");
                report.hint("both are diameters; an eye of steel has 1.8 to 2.5 times its bore outside")
            }
            Fault::NoLayers { part } => self.error(*part, format!("{} has no layers", what(*part))),
            Fault::Layer { part, layer, interval } => {
                let message = format!(
                    "layer {} of {} goes from {} to {}",
                    layer + 1,
                    what(*part),
                    long(interval[0]),
                    long(interval[1])
                );
                self.error_of(self.height_span(*part), message).hint("a layer ends above its beginning")
            }
            Fault::NoSuchEye { web, .. } => {
                self.error(Part::Web(*web), format!("{} goes to an eye that is not there", what(Part::Web(*web))))
            }
            Fault::TooFewEyes { web, count } => {
                self.error(Part::Web(*web), format!("{} goes over {count} eyes; it needs two", what(Part::Web(*web))))
            }
            _ => self.report_shape(fault),
        }
    }

    /// Faults of what lies between the parts, and of outlines.
    fn report_shape(&self, fault: &Fault) -> Diagnostic {
        let what = |part| self.what(part);
        let long = |length: f64| self.length(length);
        match fault {
            Fault::WebOfNoLength { web } => {
                let message = format!("the eyes of {} are on one axis", what(Part::Web(*web)));
                self.error(Part::Web(*web), message).hint("it needs a distance between them")
            }
            Fault::WebMissesEye { web, eye, gap } => {
                let (web, eye) = (Part::Web(*web), Part::Eye(*eye));
                let message =
                    format!("{} misses {}: {} lie between them along the axis", what(web), what(eye), long(*gap));
                let report =
                    self.error_of(self.height_span(web), message).also(self.height_span(eye), "where the eye is");
                report.hint("give both layers that overlap: by `offset`, `layers`, or a larger thickness")
            }
            Fault::WallsMeet { web, quantity, value, width } => {
                let part = Part::Web(*web);
                let message = format!(
                    "{} is {}: two of them fill the width of {}",
                    self.key_of(part, *quantity),
                    long(*value),
                    long(*width)
                );
                self.error_at(part, *quantity, message).hint("for a full bar leave `kind` out")
            }
            Fault::SkinsMeet { web, quantity, value, height } => {
                let part = Part::Web(*web);
                let message = match quantity {
                    Length::Web => format!(
                        "{} is {}, no less than the height of {}",
                        self.key_of(part, *quantity),
                        long(*value),
                        long(*height)
                    ),
                    _ => format!(
                        "{} is {}: two of them fill the height of {}",
                        self.key_of(part, *quantity),
                        long(*value),
                        long(*height)
                    ),
                };
                self.error_at(part, *quantity, message).hint("for a full bar leave `kind` out")
            }
            Fault::TooFewCorners { part, count } => {
                self.error(*part, format!("the outline of {} has {count} corners; it needs three", what(*part)))
            }
            Fault::SideOfNoLength { part, corner } => {
                let message = format!("corner {} of {} is where the one before it is", corner + 1, what(*part));
                self.error_of(self.corner_span(*part, *corner), message)
                    .hint("leave one of them out: outlines are closed from the last corner to the first")
            }
            Fault::SidesCross { part, sides: [a, b] } => {
                let message =
                    format!("the outline of {} crosses itself: sides {} and {} meet", what(*part), a + 1, b + 1);
                let report = self.error_of(self.corner_span(*part, *a), message);
                report
                    .also(self.corner_span(*part, *b), "where the other side begins")
                    .hint("corners stand in order around the outline")
            }
            Fault::RadiusTooLarge { part, corners: [a, b], radii, needed, length } => {
                let message = format!(
                    "the radii of corners {} and {} of {}, {} and {}, take {} of a side of {}",
                    a + 1,
                    b + 1,
                    what(*part),
                    long(radii[0]),
                    long(radii[1]),
                    long(*needed),
                    long(*length)
                );
                self.error_of(self.corner_span(*part, *a), message)
            }
            Fault::FilletTooLarge { at, layer, radius, needed, length } => {
                let room = if needed.is_finite() {
                    format!("it takes {} of a side of {}", long(*needed), long(*length))
                } else {
                    "no such arc touches both sides".to_owned()
                };
                let message = format!(
                    "`fillet` of {}, {}, does not fit the corner at [{}, {}], between {} and {} along the axis: {room}",
                    self.name(),
                    long(*radius),
                    long(at[0]),
                    long(at[1]),
                    long(layer[0]),
                    long(layer[1])
                );
                self.error(Part::Fillet, message).hint("take a smaller radius, or make the corner wider")
            }
            Fault::Unconnected { pieces } => {
                let message = format!("{} is in {pieces} pieces", self.name());
                self.error_of(self.solid.span, message)
                    .hint("join them by webs or plates that overlap them, or make bodies of them")
            }
            Fault::ThinContact { at, interval } => {
                let message = format!(
                    "parts of {} touch in a line or a point only, at [{}, {}], {} to {} along the axis",
                    self.name(),
                    long(at[0]),
                    long(at[1]),
                    long(interval[0]),
                    long(interval[1])
                );
                self.error_of(self.solid.span, message).hint("let them overlap, or leave a gap between them")
            }
            Fault::CutRemovesNothing { cut } => {
                self.error(Part::Cut(*cut), format!("{} meets no material", what(Part::Cut(*cut))))
            }
            Fault::CutInEye { cut, eye } => {
                let (cut, eye) = (Part::Cut(*cut), Part::Eye(*eye));
                let message = format!("{} goes through the wall of {}", what(cut), what(eye));
                self.error(cut, message).also(self.span(eye), "this eye")
            }
            Fault::Axis { length } => {
                self.error_of(self.solid.span, format!("the axis of {} has the length {length}", self.name()))
            }
            Fault::NegativeRadius { corner, radius } => {
                let message = format!(
                    "corner {} of the profile of {} is beyond the axis: its distance is {}",
                    corner + 1,
                    self.name(),
                    long(*radius)
                );
                self.error_of(self.corner_span(Part::Profile, *corner), message)
                    .hint("corners are [distance from the axis, height along it]")
            }
            Fault::TouchesAxis { corner } => {
                let message = format!("the profile of {} touches the axis in corner {} only", self.name(), corner + 1);
                self.error_of(self.corner_span(Part::Profile, *corner), message)
                    .hint("a profile has a side on the axis, or none of it there")
            }
            Fault::NotFinite { .. }
            | Fault::Empty
            | Fault::Extent { .. }
            | Fault::NotPositive { .. }
            | Fault::TooSmall { .. }
            | Fault::EyeThinnerThanBore { .. }
            | Fault::NoLayers { .. }
            | Fault::Layer { .. }
            | Fault::NoSuchEye { .. }
            | Fault::TooFewEyes { .. } => self.error_of(self.solid.span, format!("{} cannot be made", self.name())),
        }
    }

    fn error(&self, part: Part, message: String) -> Diagnostic {
        self.error_of(self.span(part), message)
    }

    fn error_at(&self, part: Part, quantity: Length, message: String) -> Diagnostic {
        self.error_of(self.span_of(part, quantity), message)
    }

    fn error_of(&self, span: Span, message: String) -> Diagnostic {
        Diagnostic::error("solid", span, message)
    }

    fn length(&self, length: f64) -> String {
        shown(length, &self.design.units.of(Measure::Length))
    }

    fn name(&self) -> String {
        format!("solid `{}`", self.solid.name)
    }

    fn link(&self) -> Option<&LinkForm> {
        match &self.solid.form {
            SolidForm::Link(link) => Some(link),
            _ => None,
        }
    }

    /// A part in messages.
    fn what(&self, part: Part) -> String {
        let found = self.link().and_then(|link| match part {
            Part::Eye(place) => Some(("eye", &link.eyes.get(place)?.name)),
            Part::Web(place) => Some(("web", &link.webs.get(place)?.name)),
            Part::Plate(place) => Some(("plate", &link.plates.get(place)?.name)),
            Part::Cut(place) => Some(("cut", &link.cuts.get(place)?.name)),
            Part::Fillet | Part::Profile => None,
        });
        found.map_or_else(|| self.name(), |(kind, name)| format!("{kind} `{name}` of {}", self.name()))
    }

    fn key_of(&self, part: Part, quantity: Length) -> String {
        let key = match (part, quantity) {
            (Part::Fillet, _) => "fillet",
            (_, Length::Bore) => "bore",
            (_, Length::Outer) => "outer",
            (_, Length::Clearance) => "clearance",
            (_, Length::Width | Length::SecondWidth) => "width",
            (_, Length::Wall) => "wall",
            (_, Length::Skin) => "skin",
            (_, Length::Flange) => "flange",
            (_, Length::Web) => "web",
            (_, Length::Diameter) => "diameter",
            (_, Length::Radius) => "radius",
        };
        format!("`{key}` of {}", self.what(part))
    }

    fn span(&self, part: Part) -> Span {
        let found = self.link().and_then(|link| match part {
            Part::Eye(place) => link.eyes.get(place).map(|eye| eye.span),
            Part::Web(place) => link.webs.get(place).map(|web| web.span),
            Part::Plate(place) => link.plates.get(place).map(|plate| plate.span),
            Part::Cut(place) => link.cuts.get(place).map(|cut| cut.span),
            Part::Fillet => link.fillet.as_ref().map(Quantity::span),
            Part::Profile => None,
        });
        found.unwrap_or(self.solid.span)
    }

    /// The place of a length; that of its part where it has none of its own.
    fn span_of(&self, part: Part, quantity: Length) -> Span {
        let found = self.link().and_then(|link| match part {
            Part::Eye(place) => {
                let eye = link.eyes.get(place)?;
                match quantity {
                    Length::Bore => Some(&eye.bore),
                    Length::Clearance => eye.clearance.as_ref(),
                    _ => Some(&eye.outer),
                }
            }
            Part::Web(place) => match &link.webs.get(place)?.kind {
                WebKind::Bar(bar) => match (quantity, &bar.profile) {
                    (Length::SecondWidth, _) => Some(&bar.widths[1]),
                    (Length::Wall, ProfileForm::Box { wall, .. }) => Some(wall),
                    (Length::Skin, ProfileForm::Box { skin, .. }) => Some(skin),
                    (Length::Flange, ProfileForm::I { flange, .. }) => Some(flange),
                    (Length::Web, ProfileForm::I { web, .. }) => Some(web),
                    _ => Some(&bar.widths[0]),
                },
                WebKind::Hull => None,
            },
            Part::Cut(place) => match &link.cuts.get(place)?.kind {
                CutKind::Hole { diameter, .. } => Some(diameter),
                CutKind::Slot { width, .. } => Some(width),
                CutKind::Outline(_) => None,
            },
            Part::Plate(_) | Part::Fillet | Part::Profile => None,
        });
        found.map_or_else(|| self.span(part), Quantity::span)
    }

    /// Where the layers of a part are given.
    fn height_span(&self, part: Part) -> Span {
        let height = self.link().and_then(|link| match part {
            Part::Eye(place) => link.eyes.get(place).map(|eye| &eye.height),
            Part::Web(place) => link.webs.get(place).map(|web| &web.height),
            Part::Plate(place) => link.plates.get(place).map(|plate| &plate.height),
            Part::Cut(place) => link.cuts.get(place)?.height.as_ref(),
            Part::Fillet | Part::Profile => None,
        });
        match height {
            Some(Height::Middle { offset: Some(offset), .. }) => offset.span(),
            Some(Height::Layers(layers)) => match (layers.first(), layers.last()) {
                (Some([first, _]), Some([_, last])) => first.span().to(last.span()),
                _ => self.span(part),
            },
            _ => self.span(part),
        }
    }

    fn corner_span(&self, part: Part, corner: usize) -> Span {
        if let (Part::Profile, SolidForm::Revolved(revolved)) = (part, &self.solid.form) {
            let at = revolved.profile.get(corner);
            return at.map_or(revolved.profile_span, |[r, h]| r.span().to(h.span()));
        }
        let outline = self.link().and_then(|link| match part {
            Part::Plate(place) => link.plates.get(place).map(|plate| &plate.outline),
            Part::Cut(place) => match &link.cuts.get(place)?.kind {
                CutKind::Outline(outline) => Some(outline),
                _ => None,
            },
            _ => None,
        });
        outline.and_then(|outline| outline.get(corner)).map_or_else(|| self.span(part), |corner| corner.span)
    }
}
