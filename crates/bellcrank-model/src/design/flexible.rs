//! Bodies that deform, and beams.

use bellcrank_doc::{Span, Spanned};

use super::{Body, Direction, Force, ForceShape, Joint, MeshForm, PointRef, Quantity};

/// How a body deforms.
#[derive(Debug)]
pub(crate) struct Flexible {
    /// Where the body says so.
    pub(crate) span: Span,
    /// Points of the body, each once.
    pub(crate) interfaces: Vec<Spanned<usize>>,
    /// Place in `interfaces`: the one that the body's frame goes with.
    pub(crate) reference: usize,
    pub(crate) modes: Kept,
    /// Bores are rigid surfaces; else they follow by their mean motion.
    pub(crate) rigid: bool,
    /// Part of critical damping.
    pub(crate) damping: Option<Quantity>,
    pub(crate) stiffening: bool,
    /// Of a solid.
    pub(crate) mesh: MeshForm,
    /// Of a beam.
    pub(crate) segments: usize,
}

/// Which modes with resting interfaces are kept.
#[derive(Clone, Debug, Default)]
pub(crate) struct Kept {
    /// At most so many.
    pub(crate) count: usize,
    /// None above, Hz.
    pub(crate) frequency: Option<Quantity>,
}

/// A straight rod of one section.
#[derive(Debug)]
pub(crate) struct Beam {
    pub(crate) name: String,
    pub(crate) span: Span,
    /// Place in the list; `None` after an error.
    pub(crate) material: Option<usize>,
    /// Names of the two ends.
    pub(crate) between: Vec<Spanned<String>>,
    pub(crate) section: Section,
    /// Direction of `height`.
    pub(crate) up: Option<Direction>,
}

/// A section.
#[derive(Debug)]
pub(crate) enum Section {
    Rectangle {
        width: Quantity,
        height: Quantity,
    },
    Round(Quantity),
    Tube {
        outer: Quantity,
        wall: Quantity,
    },
    Any {
        area: Quantity,
        /// Of bending along `up`, and across it; one is for both.
        second_moment: Vec<Quantity>,
        torsion: Option<Quantity>,
        shear_areas: Vec<Quantity>,
    },
    /// What is wrong with it has been reported.
    Faulty,
}

/// The beam of a body.
#[derive(Debug)]
pub(crate) struct Rod {
    /// Place in the list of beams.
    pub(crate) beam: usize,
    /// Where the body names it.
    pub(crate) span: Span,
    /// Points of the body.
    pub(crate) ends: [usize; 2],
}

/// Something that takes hold of a body at a point.
#[derive(Clone, Debug)]
pub(crate) struct Held {
    /// Point of the body.
    pub(crate) point: usize,
    /// `joint `B``.
    pub(crate) by: String,
    /// Where that stands, where it is known.
    pub(crate) span: Option<Span>,
}

/// Joints and forces that take hold of a body at a point; not those that only keep a planar part in its plane.
pub(crate) fn holds(body: usize, joints: &[Joint], forces: &[Force], bodies: &[Body]) -> Vec<Held> {
    let of_file = |joint: &&Joint| bodies.iter().all(|body| body.span != joint.span);
    let mut all = Vec::new();
    for joint in joints.iter().filter(of_file) {
        let ends = joint.connects.into_iter().flatten().filter(|end| end.body == body);
        let by = format!("joint `{}`", joint.name);
        all.extend(ends.map(|end| Held { point: end.point, by: by.clone(), span: Some(joint.span) }));
    }
    for force in forces {
        let ends: &[PointRef] = match &force.shape {
            ForceShape::Point { at, .. } => std::slice::from_ref(at),
            ForceShape::Spring { between, .. } | ForceShape::Bushing { between, .. } => between,
            _ => &[],
        };
        let by = format!("force `{}`", force.name);
        let ends = ends.iter().filter(|end| end.body == body);
        all.extend(ends.map(|end| Held { point: end.point, by: by.clone(), span: None }));
    }
    all
}

impl Section {
    fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Section::Rectangle { width, height } => [width, height].into_iter().for_each(visit),
            Section::Round(diameter) => visit(diameter),
            Section::Tube { outer, wall } => [outer, wall].into_iter().for_each(visit),
            Section::Any { area, second_moment, torsion, shear_areas } => {
                [area].into_iter().chain(second_moment).chain(torsion).chain(shear_areas).for_each(visit);
            }
            Section::Faulty => {}
        }
    }
}

impl Beam {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        self.section.each_quantity(visit);
        self.up.iter().for_each(|up| up.each_quantity(visit));
    }
}

impl Flexible {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        self.damping.iter().chain(&self.modes.frequency).for_each(&mut *visit);
        self.mesh.each_quantity(visit);
    }
}

impl MeshForm {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        let MeshForm { size, bores, fillets, .. } = self;
        [size, bores, fillets].into_iter().flatten().for_each(visit);
    }
}
