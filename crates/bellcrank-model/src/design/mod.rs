//! The checked model: names resolved, dimensions known, values still expressions over the parameters.

mod ask;
mod dynamics;
mod flexible;
mod force;
mod joint;
mod motion;
mod part;
mod scope;
mod sizing;
mod solid;
mod study;

use bellcrank_doc::Span;

use crate::measure::DisplayUnits;
use crate::signals::Catalogue;

pub(crate) use ask::{
    Ask, Designs, Levels, Method, NamedResponse, Optimize, Question, Scattered, Sensitivity, Term, Tolerance, Variable,
    Varied,
};
pub(crate) use dynamics::{Dynamics, Modes, ROWS, Stepping, StopWhen};
pub(crate) use flexible::{Beam, Flexible, Kept, Rod, Section, holds};
pub(crate) use force::{Axes, Force, ForceShape, Input, Load};
pub(crate) use joint::{Joint, JointShape, coordinates};
pub(crate) use motion::{Goal, Law, Mark, Origin, Prescribed, Segment, SegmentKind, Start, moved};
pub(crate) use part::{
    Accuracy, At, BodyModes, Hinges, HoldForm, LoadForm, MeshForm, PartQuestion, Parts, StressForm, SupportForm,
};
pub(crate) use scope::{Quantity, Scope, ScopeId, Values};
pub(crate) use sizing::{Actuator, Electric, Pneumatic, Sizing, Valve};
pub(crate) use solid::{
    BarForm, CornerForm, CutForm, CutKind, Elastic, EyeForm, FatigueForm, FileForm, Height, LinkForm, Material,
    MeanForm, NamedSpot, Plane, PlateForm, ProfileForm, RevolvedForm, Solid, SolidForm, Spot, WebForm, WebKind, Worn,
};
pub(crate) use study::{Hold, Missing, Over, Study, Sweep, Task};

/// A whole machine with all its subsystems.
#[derive(Debug)]
pub(crate) struct Design {
    pub(crate) planar: bool,
    pub(crate) gravity: Vec<Quantity>,
    pub(crate) gravity_span: Span,
    /// The main file first.
    pub(crate) scopes: Vec<Scope>,
    /// Ground first.
    pub(crate) bodies: Vec<Body>,
    pub(crate) materials: Vec<Material>,
    pub(crate) solids: Vec<Solid>,
    pub(crate) beams: Vec<Beam>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) forces: Vec<Force>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) motions: Vec<Prescribed>,
    /// Places in `motions`, each after the one it waits for; those that wait for each other in a circle are left out.
    pub(crate) motion_order: Vec<usize>,
    pub(crate) units: DisplayUnits,
    pub(crate) catalogue: Catalogue,
    /// Signals that force expressions use: places in the catalogue, in the order of their indices.
    pub(crate) input_signals: Vec<crate::signals::Signal>,
    /// What the files say, part by part.
    pub(crate) written: Vec<crate::written::Section>,
    /// Reductions of its flexible bodies, as they are needed.
    pub(crate) reductions: crate::flex::Store,
}

/// A body; the first one is the ground.
#[derive(Debug)]
pub(crate) struct Body {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) mass: Option<Quantity>,
    pub(crate) center: Option<Vec<Quantity>>,
    pub(crate) inertia: Option<Vec<Quantity>>,
    /// What mass, centre and inertia come from in place of numbers.
    pub(crate) solid: Option<Worn>,
    /// The same of a rod.
    pub(crate) rod: Option<Rod>,
    /// It deforms.
    pub(crate) flexible: Option<Flexible>,
    pub(crate) points: Vec<Point>,
    /// It is of a planar file.
    pub(crate) planar: bool,
}

/// A named frame of a body.
#[derive(Debug)]
pub(crate) struct Point {
    pub(crate) name: String,
    pub(crate) span: Span,
    pub(crate) at: Vec<Quantity>,
    pub(crate) rotation: Rotation,
    /// The point of the same body that `at` and `rotation` are given in: where a subsystem's ground sits.
    pub(crate) base: Option<usize>,
    /// It is of a planar file.
    pub(crate) planar: bool,
}

/// How the axes of a point lie in the body.
#[derive(Debug)]
pub(crate) enum Rotation {
    None,
    About { axis: Direction, angle: Quantity },
    Quaternion(Vec<Quantity>),
    Rpy(Vec<Quantity>),
}

impl Rotation {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: &mut dyn FnMut(&Quantity)) {
        match self {
            Rotation::None => {}
            Rotation::About { axis, angle } => {
                axis.each_quantity(visit);
                visit(angle);
            }
            Rotation::Quaternion(values) | Rotation::Rpy(values) => values.iter().for_each(visit),
        }
    }
}

/// An axis.
#[derive(Debug)]
pub(crate) struct Direction {
    pub(crate) span: Span,
    pub(crate) components: Components,
}

#[derive(Debug)]
pub(crate) enum Components {
    Fixed([f64; 3]),
    Given(Vec<Quantity>),
}

/// A point by its places in the lists.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct PointRef {
    pub(crate) body: usize,
    pub(crate) point: usize,
}
