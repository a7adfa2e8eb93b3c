//! What ends a study of parts, in names of the file.

use bellcrank_doc::Diagnostic;
use bellcrank_fem::{Fault, FreeMotion, MaterialFault};
use bellcrank_mesh::{Mesh, MesherError};

use super::acting::Pin;
use super::problem::Problem;
use super::vector::V3;
use super::{End, ended};
use crate::design::{Design, HoldForm, LoadForm, SupportForm};
use crate::measure::Measure;
use crate::run::shown;

pub(super) fn no_form(design: &Design, body: usize, report: Option<&Diagnostic>) -> End {
    let name = &design.bodies[body].name;
    match report {
        Some(report) => {
            Box::new(bellcrank_results::Failure { message: report.message.clone(), hints: report.hints.clone() })
        }
        None => ended(format!("the solid of body `{name}` is a file, of which no mesh is made in this version"), ""),
    }
}

pub(super) fn mesh_from_file() -> End {
    ended("the mesh is from a file", "a finer file; or the solid as eyes, webs and plates")
}

pub(super) fn no_material(design: &Design, body: usize, report: Option<&Diagnostic>) -> End {
    let message = format!("the material of body `{}` is not elastic", design.bodies[body].name);
    let message = report.map_or(message, |report| report.message.clone());
    ended(message, "give it `young` and `poisson`")
}

pub(super) fn material(design: &Design, body: usize, fault: MaterialFault) -> End {
    material_of(&design.bodies[body].name, fault)
}

fn material_of(name: &str, fault: MaterialFault) -> End {
    let why = match fault {
        MaterialFault::Modulus(_) => "a modulus is not positive".to_owned(),
        MaterialFault::Incompressible => "`poisson` is 0.5: it keeps its volume".to_owned(),
        MaterialFault::Poisson(nu) => format!("`poisson` is {nu}, not between -1 and 0.5"),
        MaterialFault::Unstable(_) => "it would give energy away".to_owned(),
        MaterialFault::Density(rho) => format!("its density is {rho}"),
    };
    ended(format!("the material of body `{name}` is none: {why}"), "")
}

pub(super) fn no_mesh(error: &MesherError) -> End {
    let hint = match error {
        MesherError::TooLarge { .. } => "take larger elements: `mesh = { size = ..., bores = ..., fillets = ... }`",
        MesherError::Size { .. } => "every size in `mesh` is above zero",
        _ => "",
    };
    ended(error.to_string(), hint)
}

pub(super) fn no_set(body: &str, set: &str, mesh: &Mesh, faces: bool) -> End {
    let mut names: Vec<&str> = mesh.face_sets.keys().map(String::as_str).collect();
    if !faces {
        names.extend(mesh.node_sets.keys().map(String::as_str));
    }
    names.sort_unstable();
    names.dedup();
    let message = format!("body `{body}` has no set `{set}`, or nothing is in it");
    ended(message, format!("its sets are {}", names.join(", ")))
}

/// Names of what the solver refers to by number.
pub(crate) struct Words<'a> {
    design: &'a Design,
    body: &'a str,
    /// Hinges and what else takes hold, by name or in words; they come first among the couplings.
    pins: Vec<String>,
    /// By name, those that hold a set as a whole, which are couplings as well, marked.
    supports: Vec<(&'a str, bool)>,
    /// By name, those that are spread by a coupling.
    loads: Vec<&'a str>,
}

impl Problem<'_> {
    /// What the solver found wrong.
    pub(super) fn refused(&self, mesh: &Mesh, faults: &[Fault]) -> End {
        self.words().refused(mesh, faults)
    }

    fn words(&self) -> Words<'_> {
        let hinge = |pin: &Pin| match pin.name.as_str() {
            "" => pin.from.join(", "),
            name => format!("the hinge at `{name}`"),
        };
        let framed = |one: &SupportForm| matches!(one.hold, HoldForm::Frame { .. });
        let spread = |one: &&LoadForm| !one.bearing && (!one.force.is_empty() || !one.moment.is_empty());
        Words {
            design: self.asked.design,
            body: self.name(),
            pins: self.acting.pins.iter().map(hinge).collect(),
            supports: self.supports.iter().map(|one| (one.name.as_str(), framed(one))).collect(),
            loads: self.loads.iter().filter(spread).map(|one| one.name.as_str()).collect(),
        }
    }
}

impl<'a> Words<'a> {
    /// Of a body that nothing but interfaces holds.
    pub(crate) fn of_interfaces(
        design: &'a Design,
        body: &'a str,
        interfaces: impl Iterator<Item = &'a str>,
    ) -> Words<'a> {
        let pins = interfaces.map(|name| format!("interface `{name}`")).collect();
        Words { design, body, pins, supports: Vec::new(), loads: Vec::new() }
    }

    /// What the solver found wrong.
    pub(crate) fn refused(&self, mesh: &Mesh, faults: &[Fault]) -> End {
        let mut message = String::new();
        let mut hints: Vec<String> = Vec::new();
        for fault in faults {
            let (one, hint) = self.told(mesh, fault);
            if !message.is_empty() {
                message.push_str("; ");
            }
            message.push_str(&one);
            hints.extend(Some(hint).filter(|hint| !hint.is_empty() && !hints.contains(hint)));
        }
        Box::new(bellcrank_results::Failure { message, hints })
    }

    fn told(&self, mesh: &Mesh, fault: &Fault) -> (String, String) {
        let body = self.body;
        let at = |node: u32| self.place(mesh.nodes[node as usize]);
        let support = |index: usize| self.supports.get(index).map_or(String::new(), |(name, _)| format!("`{name}`"));
        let say = |message: String, hint: &str| (message, hint.to_owned());
        match fault {
            Fault::NoElements => say(format!("the mesh of body `{body}` has no elements"), ""),
            Fault::Materials { blocks, materials } => {
                say(format!("the mesh of body `{body}` has {blocks} blocks and {materials} materials"), "")
            }
            Fault::Material { fault, .. } => (material_of(body, *fault).message, String::new()),
            Fault::Inverted { block, element, .. } => {
                let place = self.place(mesh.center_of((*block as u32, *element as u32)));
                let hint = "smaller elements there follow the curves better; or choose the other kind of `element`";
                say(format!("element {} of body `{body}` is turned inside out, at {place}", element + 1), hint)
            }
            Fault::EmptySupport(index) => {
                say(format!("support {} of body `{body}` holds no node", support(*index)), "")
            }
            Fault::EmptyCoupling(index) | Fault::CouplingOnLine(index) => {
                let what = self.coupling_name(*index);
                say(format!("{what} of body `{body}` takes hold of nothing that has an area"), "")
            }
            Fault::EmptyLoad(_) => say(format!("a load of body `{body}` acts on a set without faces or nodes"), ""),
            Fault::SupportsDisagree { support: index, node } => {
                let message = format!(
                    "support {} of body `{body}` wants another displacement of a node than one before, at {}",
                    support(*index),
                    at(*node)
                );
                say(message, "two supports that meet must agree there")
            }
            Fault::TwiceCoupled { node, couplings } => {
                let [a, b] = couplings.map(|index| self.coupling_name(index));
                let message = format!("{a} and {b} of body `{body}` both hold a node rigidly, at {}", at(*node));
                say(message, "one of them as `distributing`")
            }
            Fault::CoupledAndHeld { node, coupling } => {
                let what = self.coupling_name(*coupling);
                let message = format!(
                    "{what} of body `{body}` holds a node rigidly that a support holds as well, at {}",
                    at(*node)
                );
                say(message, "hold the frame of the set instead: `coupling = \"rigid\"` in the support")
            }
            Fault::UnderSupported(motions) => {
                let free: Vec<String> = motions.iter().map(|motion| self.free(motion)).collect();
                let message = format!("body `{body}` is not held: it is {}", listed(&free));
                say(
                    message,
                    "add `[studies.NAME.supports.NAME]`; or load it by a study `of`, then its inertia holds it",
                )
            }
            Fault::ReducedPartHeld => {
                say(format!("body `{body}` is to be flexible, and has supports or couplings of its own"), "")
            }
            Fault::NoInterface => {
                say(format!("flexible body `{body}` has no interface"), "name points of it: `interfaces = [...]`")
            }
            Fault::EmptyInterface(index) | Fault::InterfaceOnLine(index) => {
                let message =
                    format!("interface {} of body `{body}` takes hold of nothing that has an area", index + 1);
                say(message, "an interface takes hold of the bore round its point")
            }
            Fault::InterfacesOverlap { node, interfaces: [one, other] } => {
                let message = format!(
                    "interfaces {} and {} of body `{body}` take hold of the same place, {}",
                    one + 1,
                    other + 1,
                    at(*node)
                );
                say(message, "leave one of them out")
            }
            Fault::TooManyModes { asked, available } => {
                let message = format!(
                    "{asked} modes of body `{body}` were asked for, and its mesh has {available} unknowns with its interfaces held"
                );
                say(message, "ask for fewer `modes`")
            }
            Fault::Pieces { pieces, node } => {
                let message = format!(
                    "the mesh of body `{body}` is in {pieces} pieces that share no node, and nothing holds the one at {}",
                    at(*node)
                );
                say(message, "join them in the mesh, or hold each by a support")
            }
            Fault::Loose { node, .. } => {
                let message = format!("a piece of body `{body}` can move without being deformed, at {}", at(*node));
                say(message, "is the mesh in one piece there?")
            }
            Fault::ModesWithDistributingSupport(index) => {
                let what = self.coupling_name(*index);
                say(format!("{what} of body `{body}` is distributing, which modes do not take"), "hold it rigidly")
            }
            Fault::Memory { needed, allowed } => {
                let [needed, allowed] = [needed, allowed].map(|bytes| *bytes as f64 / 1e9);
                let message = format!(
                    "the mesh of body `{body}` is larger than memory: {} nodes need about {needed:.1} GB, {allowed:.1} GB may be used",
                    mesh.nodes.len()
                );
                say(message, "take larger elements: `mesh = { size = ..., bores = ..., fillets = ... }`")
            }
            Fault::Interrupted => say("stopped by the user".to_owned(), ""),
            Fault::Stagnated { residual } => {
                let message = format!(
                    "the factor of body `{body}` does not fit into memory, and iteration came to a halt: {residual:.1e} of \
                     the loads is left"
                );
                say(message, "take larger elements: `mesh = { size = ..., bores = ..., fillets = ... }`")
            }
            Fault::NotConverged { found } => say(
                format!("only {found} modes of body `{body}` were found: the iteration did not converge"),
                "ask for fewer",
            ),
        }
    }

    /// Couplings are those of the pins, then of supports, then of loads.
    fn coupling_name(&self, index: usize) -> String {
        let framed: Vec<&str> = self.supports.iter().filter(|(_, framed)| *framed).map(|(name, _)| *name).collect();
        if let Some(pin) = self.pins.get(index) {
            return pin.clone();
        }
        let index = index - self.pins.len();
        if let Some(support) = framed.get(index) {
            return format!("support `{support}`");
        }
        self.loads.get(index - framed.len()).map_or_else(String::new, |load| format!("load `{load}`"))
    }

    fn place(&self, at: V3) -> String {
        place(self.design, at)
    }

    fn free(&self, motion: &FreeMotion) -> String {
        match motion {
            FreeMotion::Along(direction) => format!("free to move along {}", direction_name(*direction)),
            FreeMotion::About { axis, point, pitch } => {
                let advance = if pitch.abs() > 1e-9 {
                    let unit = self.design.units.of(Measure::Length);
                    format!(", advancing by {} a turn", shown(pitch * std::f64::consts::TAU, &unit))
                } else {
                    String::new()
                };
                let axis = direction_name(*axis);
                format!("free to turn about an axis along {axis} through {}{advance}", self.place(*point))
            }
        }
    }
}

/// A place of a body with its unit.
fn place(design: &Design, at: V3) -> String {
    let unit = design.units.of(Measure::Length);
    let numbers = at.map(|x| {
        let rounded: f64 = format!("{:.3e}", unit.show(x)).parse().unwrap_or(f64::NAN);
        // What is left of nothing by rounding is nothing.
        if x.abs() < 1e-12 { "0".to_owned() } else { format!("{rounded}") }
    });
    format!("[{}] {}", numbers.join(", "), unit.symbol)
}

/// `x`, or the components.
fn direction_name(direction: V3) -> String {
    let letter = direction.iter().position(|x| x.abs() > 1.0 - 1e-9);
    match letter {
        Some(axis) => ["x", "y", "z"][axis].to_owned(),
        None => format!("[{}]", direction.map(|x| format!("{x:.3}")).join(", ")),
    }
}

fn listed(parts: &[String]) -> String {
    match parts {
        [] => String::new(),
        [one] => one.clone(),
        [front @ .., last] => format!("{} and {last}", front.join(", ")),
    }
}
