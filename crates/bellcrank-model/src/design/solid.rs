//! Materials, and solids as recipes: a body that uses one gives the points that it is laid on.

use std::fmt;
use std::sync::Arc;

use bellcrank_doc::{Span, Spanned};
use bellcrank_fem::fatigue::{Beyond, MetalGroup};
use bellcrank_mesh::Mesh;

use super::{Components, Direction, Quantity};

/// What solids are made of.
#[derive(Debug)]
pub(crate) struct Material {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) density: Option<Quantity>,
    pub(crate) elastic: Option<Elastic>,
    pub(crate) strength: Option<Quantity>,
    /// Tensile strength.
    pub(crate) tensile: Option<Quantity>,
    /// One value, or one for each axis of the material.
    pub(crate) expansion: Vec<Quantity>,
    pub(crate) fatigue: Option<FatigueForm>,
    /// Its density could not be read, which has been reported.
    pub(crate) faulty: bool,
}

/// How a material gives way.
#[derive(Debug)]
pub(crate) enum Elastic {
    Isotropic {
        young: Quantity,
        poisson: Quantity,
    },
    /// Along and between the axes 1, 2, 3 of the solid: Young's moduli, ν12, ν23, ν13, and G12, G23, G13.
    Orthotropic {
        young: Box<[Quantity; 3]>,
        poisson: Box<[Quantity; 3]>,
        shear: Box<[Quantity; 3]>,
    },
}

/// What a material stands when loaded again and again.
#[derive(Debug)]
pub(crate) struct FatigueForm {
    /// At the knee of the Woehler line, at no mean stress.
    pub(crate) amplitude: Quantity,
    pub(crate) cycles: Quantity,
    pub(crate) slope: Quantity,
    pub(crate) beyond: Beyond,
    pub(crate) mean: MeanForm,
}

/// How the mean stress of a cycle counts.
#[derive(Debug)]
pub(crate) enum MeanForm {
    None,
    /// With the tensile strength of the material.
    Goodman,
    Sensitivity(Quantity),
    /// Sensitivity by the metal and the tensile strength.
    Group(MetalGroup),
}

/// A solid.
#[derive(Debug)]
pub(crate) struct Solid {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// Place in the list of materials; `None` where that has been reported as wrong.
    pub(crate) material: Option<usize>,
    pub(crate) form: SolidForm,
    /// Names of points that the body has to have: what stands there, and where.
    pub(crate) points: Vec<NamedSpot>,
}

/// A point that a solid is laid on, by name.
#[derive(Debug)]
pub(crate) struct NamedSpot {
    pub(crate) name: Spanned<String>,
    /// In messages, as "eye `B`".
    pub(crate) what: String,
}

#[derive(Debug)]
pub(crate) enum SolidForm {
    Link(Box<LinkForm>),
    Revolved(RevolvedForm),
    File(FileForm),
    /// What is wrong with it has been reported.
    Faulty,
}

/// Eyes, webs, plates and cuts in a plane of the body.
#[derive(Debug)]
pub(crate) struct LinkForm {
    pub(crate) plane: Plane,
    pub(crate) fillet: Option<Quantity>,
    pub(crate) eyes: Vec<EyeForm>,
    pub(crate) webs: Vec<WebForm>,
    pub(crate) plates: Vec<PlateForm>,
    pub(crate) cuts: Vec<CutForm>,
}

/// The plane of a link in the axes of its body.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Plane {
    Xy,
    Yz,
    Zx,
}

impl Plane {
    /// The plane of this name.
    pub(crate) fn of(name: &str) -> Plane {
        match name {
            "yz" => Plane::Yz,
            "zx" => Plane::Zx,
            _ => Plane::Xy,
        }
    }

    /// Which axis of the body is which of the plan: right, up, towards the reader.
    pub(crate) fn axes(self) -> [usize; 3] {
        match self {
            Plane::Xy => [0, 1, 2],
            Plane::Yz => [1, 2, 0],
            Plane::Zx => [2, 0, 1],
        }
    }
}

/// A place: a point of the body, or coordinates.
#[derive(Debug)]
pub(crate) enum Spot {
    /// Place in [`Solid::points`].
    Point(usize),
    At(Vec<Quantity>),
}

/// Where something is along the axis.
#[derive(Debug)]
pub(crate) enum Height {
    /// A thickness, and how far its middle is from the plane.
    Middle { thickness: Quantity, offset: Option<Quantity> },
    /// Intervals.
    Layers(Vec<[Quantity; 2]>),
}

#[derive(Debug)]
pub(crate) struct EyeForm {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) at: Spot,
    pub(crate) bore: Quantity,
    pub(crate) outer: Quantity,
    pub(crate) height: Height,
    pub(crate) clearance: Option<Quantity>,
}

#[derive(Debug)]
pub(crate) struct WebForm {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// Places in [`LinkForm::eyes`].
    pub(crate) eyes: Vec<usize>,
    pub(crate) height: Height,
    pub(crate) kind: WebKind,
}

#[derive(Debug)]
pub(crate) enum WebKind {
    Bar(Box<BarForm>),
    Hull,
}

#[derive(Debug)]
pub(crate) struct BarForm {
    /// At the first and the second eye.
    pub(crate) widths: [Quantity; 2],
    pub(crate) profile: ProfileForm,
}

#[derive(Debug)]
pub(crate) enum ProfileForm {
    Flat,
    Box { wall: Quantity, skin: Quantity },
    I { flange: Quantity, web: Quantity },
}

#[derive(Debug)]
pub(crate) struct PlateForm {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) outline: Vec<CornerForm>,
    pub(crate) height: Height,
}

#[derive(Debug)]
pub(crate) struct CornerForm {
    pub(crate) span: Span,
    pub(crate) at: Spot,
    pub(crate) radius: Option<Quantity>,
}

#[derive(Debug)]
pub(crate) struct CutForm {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) kind: CutKind,
    /// Through everything unless given.
    pub(crate) height: Option<Height>,
}

#[derive(Debug)]
pub(crate) enum CutKind {
    Hole { at: Spot, diameter: Quantity },
    Slot { from: Spot, to: Spot, width: Quantity },
    Outline(Vec<CornerForm>),
}

/// A profile turned about an axis.
#[derive(Debug)]
pub(crate) struct RevolvedForm {
    pub(crate) at: Spot,
    pub(crate) axis: Direction,
    /// Distance from the axis, and height along it.
    pub(crate) profile: Vec<[Quantity; 2]>,
    pub(crate) profile_span: Span,
}

/// A mesh from a file, or one that a mesher made of the part in a file; body axes, m.
pub(crate) struct FileForm {
    pub(crate) mesh: Arc<Mesh>,
    /// As the model names it.
    pub(crate) file: String,
}

impl fmt::Debug for FileForm {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.debug_struct("FileForm").field("file", &self.file).finish_non_exhaustive()
    }
}

/// The solid of a body.
#[derive(Debug)]
pub(crate) struct Worn {
    /// Place in the list of solids.
    pub(crate) solid: usize,
    /// Where the body names it.
    pub(crate) span: Span,
    /// Points of the body for [`Solid::points`].
    pub(crate) points: Vec<usize>,
}

/// Visits a value.
type Visit<'v> = &'v mut dyn FnMut(&Quantity);

impl Material {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: Visit<'_>) {
        let strengths = self.strength.iter().chain(&self.tensile);
        self.density.iter().chain(strengths).chain(&self.expansion).for_each(&mut *visit);
        self.fatigue.iter().for_each(|fatigue| fatigue.each_quantity(visit));
        match &self.elastic {
            Some(Elastic::Isotropic { young, poisson }) => [young, poisson].into_iter().for_each(visit),
            Some(Elastic::Orthotropic { young, poisson, shear }) => {
                young.iter().chain(poisson.iter()).chain(shear.iter()).for_each(visit);
            }
            None => {}
        }
    }
}

impl FatigueForm {
    fn each_quantity(&self, visit: Visit<'_>) {
        [&self.amplitude, &self.cycles, &self.slope].into_iter().for_each(&mut *visit);
        if let MeanForm::Sensitivity(sensitivity) = &self.mean {
            visit(sensitivity);
        }
    }
}

impl SolidForm {
    /// Every value of its geometry.
    pub(crate) fn each_quantity(&self, visit: Visit<'_>) {
        match self {
            SolidForm::Link(link) => link.each_quantity(visit),
            SolidForm::Revolved(revolved) => {
                revolved.at.each_quantity(visit);
                if let Components::Given(components) = &revolved.axis.components {
                    components.iter().for_each(&mut *visit);
                }
                revolved.profile.iter().flatten().for_each(visit);
            }
            SolidForm::File(_) | SolidForm::Faulty => {}
        }
    }
}

impl LinkForm {
    fn each_quantity(&self, visit: Visit<'_>) {
        self.fillet.iter().for_each(&mut *visit);
        for eye in &self.eyes {
            eye.at.each_quantity(visit);
            [&eye.bore, &eye.outer].into_iter().chain(&eye.clearance).for_each(&mut *visit);
            eye.height.each_quantity(visit);
        }
        for web in &self.webs {
            web.height.each_quantity(visit);
            web.kind.each_quantity(visit);
        }
        for plate in &self.plates {
            corners(&plate.outline, visit);
            plate.height.each_quantity(visit);
        }
        for cut in &self.cuts {
            cut.kind.each_quantity(visit);
            cut.height.iter().for_each(|height| height.each_quantity(visit));
        }
    }
}

impl Spot {
    fn each_quantity(&self, visit: Visit<'_>) {
        if let Spot::At(at) = self {
            at.iter().for_each(visit);
        }
    }
}

impl Height {
    fn each_quantity(&self, visit: Visit<'_>) {
        match self {
            Height::Middle { thickness, offset } => [thickness].into_iter().chain(offset).for_each(visit),
            Height::Layers(layers) => layers.iter().flatten().for_each(visit),
        }
    }
}

impl WebKind {
    fn each_quantity(&self, visit: Visit<'_>) {
        let WebKind::Bar(bar) = self else { return };
        let BarForm { widths, profile } = &**bar;
        widths.iter().for_each(&mut *visit);
        match profile {
            ProfileForm::Flat => {}
            ProfileForm::Box { wall, skin } => [wall, skin].into_iter().for_each(visit),
            ProfileForm::I { flange, web } => [flange, web].into_iter().for_each(visit),
        }
    }
}

impl CutKind {
    fn each_quantity(&self, visit: Visit<'_>) {
        match self {
            CutKind::Hole { at, diameter } => {
                at.each_quantity(visit);
                visit(diameter);
            }
            CutKind::Slot { from, to, width } => {
                from.each_quantity(visit);
                to.each_quantity(visit);
                visit(width);
            }
            CutKind::Outline(outline) => corners(outline, visit),
        }
    }
}

fn corners(outline: &[CornerForm], visit: Visit<'_>) {
    for corner in outline {
        corner.at.each_quantity(visit);
        corner.radius.iter().for_each(&mut *visit);
    }
}
