//! Studies of bodies as elastic parts: stress, and natural frequencies.

use bellcrank_doc::Spanned;

use super::Quantity;

/// A study of parts.
#[derive(Clone, Debug)]
pub(crate) struct Parts {
    pub(crate) bodies: Vec<usize>,
    pub(crate) mesh: MeshForm,
    pub(crate) question: PartQuestion,
}

#[derive(Clone, Debug)]
pub(crate) enum PartQuestion {
    Stress(Box<StressForm>),
    Modes(BodyModes),
}

/// Stress in bodies.
#[derive(Clone, Debug)]
pub(crate) struct StressForm {
    /// The study whose rows load the bodies.
    pub(crate) of: Option<String>,
    pub(crate) at: At,
    pub(crate) hinges: Hinges,
    /// Largest error of the stress, and how many meshes after the first.
    pub(crate) accuracy: Option<Accuracy>,
    pub(crate) supports: Vec<SupportForm>,
    pub(crate) loads: Vec<LoadForm>,
}

/// Natural frequencies of a body.
#[derive(Clone, Debug)]
pub(crate) struct BodyModes {
    /// So many beside the rigid motions.
    pub(crate) count: usize,
    /// Sets that are clamped.
    pub(crate) fixed: Vec<Spanned<String>>,
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Accuracy {
    /// Relative.
    pub(crate) error: f64,
    pub(crate) refinements: usize,
}

/// Which rows of the other study.
#[derive(Clone, Debug)]
pub(crate) enum At {
    /// The one with the largest stress.
    Worst,
    /// Each hot spot at its own worst.
    All,
    Row(usize),
    /// The row in which a signal comes nearest to a value.
    Nearest {
        signal: String,
        value: Quantity,
    },
}

/// How pins bear in their bores.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Hinges {
    Bearing,
    Distributing,
    Rigid,
}

impl Hinges {
    pub(crate) fn named(word: &str) -> Hinges {
        match word {
            "distributing" => Hinges::Distributing,
            "rigid" => Hinges::Rigid,
            _ => Hinges::Bearing,
        }
    }

    pub(crate) fn name(self) -> &'static str {
        match self {
            Hinges::Bearing => "bearing",
            Hinges::Distributing => "distributing",
            Hinges::Rigid => "rigid",
        }
    }
}

#[derive(Clone, Debug, Default)]
pub(crate) struct MeshForm {
    pub(crate) size: Option<Quantity>,
    pub(crate) bores: Option<Quantity>,
    pub(crate) fillets: Option<Quantity>,
    pub(crate) layers: Option<usize>,
    /// Tetrahedra in place of wedges.
    pub(crate) tetrahedra: bool,
    /// Multiplies all sizes, given or not; 1 without. No file says it: studies of convergence do.
    pub(crate) scale: Option<f64>,
}

/// What holds a set.
#[derive(Clone, Debug)]
pub(crate) struct SupportForm {
    pub(crate) name: String,
    pub(crate) set: Spanned<String>,
    pub(crate) hold: HoldForm,
}

#[derive(Clone, Debug)]
pub(crate) enum HoldForm {
    /// Displacement prescribed at every node; `None` is free.
    Nodes(Box<[Option<Option<Quantity>>; 3]>),
    Spring(Box<[Quantity; 3]>),
    /// Of the set as a whole: displacements, then rotations.
    Frame {
        rigid: bool,
        held: Box<[Option<Option<Quantity>>; 6]>,
    },
}

/// What acts on a set, or on the whole body.
#[derive(Clone, Debug)]
pub(crate) struct LoadForm {
    pub(crate) name: String,
    pub(crate) set: Option<Spanned<String>>,
    pub(crate) force: Vec<Quantity>,
    pub(crate) moment: Vec<Quantity>,
    pub(crate) rigid: bool,
    pub(crate) bearing: bool,
    pub(crate) pressure: Option<Quantity>,
    pub(crate) traction: Vec<Quantity>,
    pub(crate) gravity: Vec<Quantity>,
    pub(crate) temperature: Option<Quantity>,
}

/// Visits a value.
type Visit<'v> = &'v mut dyn FnMut(&Quantity);

impl Parts {
    /// Every value in it.
    pub(crate) fn each_quantity(&self, visit: Visit<'_>) {
        self.mesh.each_quantity(visit);
        let PartQuestion::Stress(stress) = &self.question else { return };
        if let At::Nearest { value, .. } = &stress.at {
            visit(value);
        }
        stress.supports.iter().for_each(|support| support.hold.each_quantity(visit));
        for load in &stress.loads {
            let lists = [&load.force, &load.moment, &load.traction, &load.gravity];
            lists.into_iter().flatten().for_each(&mut *visit);
            load.pressure.iter().chain(&load.temperature).for_each(&mut *visit);
        }
    }
}

impl HoldForm {
    fn each_quantity(&self, visit: Visit<'_>) {
        match self {
            HoldForm::Nodes(held) => held.iter().flatten().flatten().for_each(visit),
            HoldForm::Spring(stiffness) => stiffness.iter().for_each(visit),
            HoldForm::Frame { held, .. } => held.iter().flatten().flatten().for_each(visit),
        }
    }
}
