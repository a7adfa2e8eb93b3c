//! `[forces]`.

use bellcrank_doc::{Diagnostic, Entry, Expression, Value};
use bellcrank_multibody::Coordinate;

use super::bodies::entries;
use super::flexible::Deforming;
use super::{Machine, PartReader};
use crate::design::{Axes, Force, ForceShape, Input, Load, SolidForm};
use crate::elastic::stroke::PEAK;
use crate::keyed::Keyed;
use crate::measure::Motion;
use crate::names;
use crate::schema::{Along, FORCE};
use crate::signals::{Catalogue, ForceLayout, InstantSignals, JointLayout, Layout, MOST, Outputs, Signal};

/// The forces of a model, and the signals they use.
pub(crate) struct ReadForces {
    pub(crate) forces: Vec<Force>,
    pub(crate) inputs: Vec<Input>,
    pub(crate) signals: Vec<Signal>,
    pub(crate) catalogue: Catalogue,
}

/// A force whose kind is known.
struct Opened<'a> {
    part: PartReader<'a>,
    entry: &'a Entry,
    keyed: Keyed<'a>,
    kind: &'static str,
    /// The coordinate it acts on, for kinds with `joint`.
    along: Option<(Coordinate, Motion)>,
}

/// Reads the forces of all parts: first which there are, since their values may refer to each other.
pub(crate) fn read(parts: &[PartReader<'_>], machine: &Machine) -> ReadForces {
    let opened: Vec<Opened<'_>> = parts
        .iter()
        .flat_map(|part| entries(part, "forces").into_iter().filter_map(|entry| open(*part, machine, entry)))
        .collect();
    let catalogue = Catalogue::new(layout(parts[0].planar, machine, &opened));
    let mut loads = Loads { catalogue: &catalogue, inputs: Vec::new(), signals: Vec::new() };
    let forces = opened.into_iter().filter_map(|force| read_force(force, machine, &mut loads)).collect();
    let Loads { inputs, signals, .. } = loads;
    ReadForces { forces, inputs, signals, catalogue }
}

fn open<'a>(part: PartReader<'a>, machine: &Machine, entry: &'a Entry) -> Option<Opened<'a>> {
    if let Some(fault) = names::fault(entry, "force") {
        part.reader.report(fault);
    }
    let fields = part.reader.fields(&entry.value, &format!("force `{}`", entry.key))?;
    let keyed = Keyed::new(fields, &FORCE, part.space());
    let Some(kind) = keyed.kind() else {
        keyed.finish();
        return None;
    };
    let acts_along = matches!(kind, "effort" | "joint-spring" | "friction" | "stop");
    let along = if acts_along { keyed.text("joint").and_then(|name| part.coordinate(machine, name)) } else { None };
    Some(Opened { part, entry, keyed, kind, along })
}

fn layout(planar: bool, machine: &Machine, forces: &[Opened<'_>]) -> Layout {
    let body =
        |body: &crate::design::Body| (body.name.clone(), body.points.iter().map(|point| point.name.clone()).collect());
    let joint = |joint: &crate::design::Joint| JointLayout {
        name: joint.name.clone(),
        coordinates: joint.coordinates(planar),
        coupler: joint.kind == "coupler",
    };
    let force = |force: &Opened<'_>| ForceLayout {
        name: force.part.full(&force.entry.key),
        outputs: outputs(force.kind, force.along.map(|(_, motion)| motion)),
    };
    Layout {
        planar,
        bodies: machine.bodies.iter().map(body).collect(),
        joints: machine.joints.iter().map(joint).collect(),
        forces: forces.iter().map(force).collect(),
        stresses: stresses(machine),
    }
}

/// Bodies that deform as solids: their peak, and their bores.
fn stresses(machine: &Machine) -> Vec<(usize, Vec<String>)> {
    let mut all = Vec::new();
    for index in machine.deforming.iter().map(Deforming::body) {
        let worn = machine.bodies.get(index).and_then(|body| body.solid.as_ref());
        let Some(solid) = worn.and_then(|worn| machine.solids.get(worn.solid)) else { continue };
        let mut regions = vec![PEAK.to_owned()];
        if let SolidForm::Link(link) = &solid.form {
            let bored = link.eyes.iter().filter(|eye| eye.bore.expression.as_constant() != Some(0.0));
            regions.extend(bored.map(|eye| format!("bore.{}", eye.name)));
        }
        regions.truncate(MOST);
        all.push((index, regions));
    }
    all
}

fn outputs(kind: &str, along: Option<Motion>) -> Outputs {
    let motion = along.unwrap_or(Motion::Slide);
    match kind {
        "force" | "bushing" => Outputs::Force,
        "torque" => Outputs::Torque,
        "effort" => Outputs::Effort(motion),
        _ => Outputs::Element(motion),
    }
}

/// Turns expressions into loads: those over signals become inputs.
struct Loads<'c> {
    catalogue: &'c Catalogue,
    inputs: Vec<Input>,
    signals: Vec<Signal>,
}

impl Loads<'_> {
    /// Reads with `read`, and reports a signal that is not known before forces are solved.
    fn with<T>(&mut self, part: PartReader<'_>, at: &Value, read: impl FnOnce(&mut InstantSignals<'_>) -> T) -> T {
        let mut signals = InstantSignals {
            catalogue: self.catalogue,
            prefix: part.prefix(),
            used: &mut self.signals,
            too_late: None,
            embedded: part.is_embedded(),
            out_of_plane: None,
        };
        let result = read(&mut signals);
        if let Some(name) = signals.out_of_plane {
            let message =
                format!("`{name}` is along world axes, which a planar file in a spatial machine does not know");
            let hint = "use the signals of joints, `time`, and lengths and rates of other elements";
            part.reader.report(Diagnostic::error("not-in-plane", at.span, message).hint(hint));
            return result;
        }
        if let Some(name) = signals.too_late {
            let message = format!("a force cannot depend on `{name}`: it is known only after the forces are solved");
            let hint = "positions, velocities, `time`, and lengths and rates of other elements can be used";
            part.reader.report(Diagnostic::error("signal-too-late", at.span, message).hint(hint));
        }
        result
    }

    fn load(&mut self, part: PartReader<'_>, expression: Expression) -> Load {
        if expression.signals().is_empty() {
            return Load::Fixed(Box::new(part.quantity(expression)));
        }
        self.inputs.push(Input { scope: part.part.scope, expression });
        Load::Input(self.inputs.len() - 1)
    }

    /// A value of a force; `None` when absent (or wrong, and reported).
    fn optional(&mut self, force: &Opened<'_>, name: &'static str) -> Option<Load> {
        let value = force.keyed.value(name)?;
        let motion = force.along.map(|(_, motion)| motion);
        let read = self.with(force.part, value, |signals| force.keyed.signal(name, motion, signals))?;
        Some(self.load(force.part, read))
    }

    /// The same, 0 when absent.
    fn or_zero(&mut self, force: &Opened<'_>, name: &'static str) -> Load {
        self.optional(force, name).unwrap_or(Load::Absent(0.0))
    }

    /// Components; those that the plane does not have are 0.
    fn vector(&mut self, force: &Opened<'_>, name: &'static str) -> Option<[Load; 3]> {
        let value = force.keyed.value(name)?;
        let read = self.with(force.part, value, |signals| force.keyed.signal_vector(name, signals))?;
        let mut loads =
            read.into_iter().map(|expression| self.load(force.part, expression)).collect::<Vec<_>>().into_iter();
        Some(std::array::from_fn(|_| loads.next().unwrap_or(Load::Absent(0.0))))
    }

    /// Six values along and about x, y, z; the plane gives x, y and the angle.
    fn six(&mut self, force: &Opened<'_>, name: &'static str, along: Along) -> Option<[Load; 6]> {
        let value = force.keyed.value(name)?;
        let places: &[usize] = if force.part.planar { &[0, 1, 5] } else { &[0, 1, 2, 3, 4, 5] };
        let motion = |place: &usize| if *place < 3 { Motion::Slide } else { Motion::Turn };
        let dimensions: Vec<_> = places.iter().map(|place| along.dimension(motion(place))).collect();
        let what = force.keyed.named(name);
        let reader = force.part.reader;
        let read = self.with(force.part, value, |signals| reader.signal_vector(value, &what, &dimensions, signals))?;
        let mut six: [Load; 6] = std::array::from_fn(|_| Load::Absent(0.0));
        for (place, expression) in places.iter().zip(read) {
            six[*place] = self.load(force.part, expression);
        }
        Some(six)
    }
}

fn read_force(force: Opened<'_>, machine: &Machine, loads: &mut Loads<'_>) -> Option<Force> {
    let shape = match force.kind {
        "force" => point_force(&force, machine, loads),
        "torque" => torque(&force, machine, loads),
        "spring" => spring(&force, machine, loads),
        "bushing" => bushing(&force, machine, loads),
        _ => along_coordinate(&force, loads),
    };
    let Opened { part, entry, keyed, .. } = force;
    keyed.finish();
    Some(Force { name: part.full(&entry.key), shape: shape? })
}

/// The world of a planar file is its ground: in space that may lie and move any way.
fn axes(force: &Opened<'_>, machine: &Machine) -> Axes {
    let mount = machine.mounts.get(force.part.part.scope.0).copied().flatten();
    match force.keyed.choice("axes") {
        Some(choice) if choice.value == "body" => Axes::Body,
        _ if force.part.is_embedded() => mount.map_or(Axes::World, Axes::Point),
        _ => Axes::World,
    }
}

fn point_force(force: &Opened<'_>, machine: &Machine, loads: &mut Loads<'_>) -> Option<ForceShape> {
    let on = force.keyed.text("on").and_then(|name| force.part.point(machine, name));
    let vector = loads.vector(force, "vector");
    Some(ForceShape::Point { at: on?, vector: vector?, axes: axes(force, machine) })
}

fn torque(force: &Opened<'_>, machine: &Machine, loads: &mut Loads<'_>) -> Option<ForceShape> {
    let on = force.keyed.text("on").and_then(|name| {
        let found = machine.body_names.find(name.value, force.part.prefix(), "body", name.span);
        found.map_err(|report| force.part.reader.report(*report)).ok()
    });
    let (wanted, other) = if force.part.planar { ("value", "vector") } else { ("vector", "value") };
    if force.keyed.has(other) || !force.keyed.has(wanted) {
        let space = if force.part.planar { "the plane" } else { "space" };
        let message = format!("{} needs `{wanted}` in {space}", force.keyed.what());
        force.keyed.fault("missing-key", message);
        return None;
    }
    let vector = if force.part.planar {
        [Load::Absent(0.0), Load::Absent(0.0), loads.optional(force, "value")?]
    } else {
        loads.vector(force, "vector")?
    };
    // About the normal of the plane, which every body in it has for its own z.
    let axes = if force.part.is_embedded() { Axes::Body } else { axes(force, machine) };
    Some(ForceShape::Torque { on: on?, vector, axes })
}

fn between(force: &Opened<'_>, machine: &Machine) -> Option<[crate::design::PointRef; 2]> {
    let value = force.keyed.value("between")?;
    force.part.pair(machine, value, &force.keyed.named("between"))
}

fn spring(force: &Opened<'_>, machine: &Machine, loads: &mut Loads<'_>) -> Option<ForceShape> {
    acts(force, &["stiffness", "damping", "preload"]);
    let between = between(force, machine);
    let [stiffness, damping, free_length, preload] =
        ["stiffness", "damping", "free_length", "preload"].map(|name| loads.or_zero(force, name));
    Some(ForceShape::Spring { between: between?, stiffness, damping, free_length, preload })
}

/// Reports an element that has none of what would make it act.
fn acts(force: &Opened<'_>, names: &[&'static str]) {
    if names.iter().any(|name| force.keyed.has(name)) {
        return;
    }
    let names: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    let message = format!("{} does nothing: none of {} is given", force.keyed.what(), names.join(", "));
    force.keyed.report(Diagnostic::warning("no-effect", force.keyed.span(), message));
}

fn bushing(force: &Opened<'_>, machine: &Machine, loads: &mut Loads<'_>) -> Option<ForceShape> {
    let between = between(force, machine);
    let stiffness = loads.six(force, "stiffness", Along::Stiffness);
    let damping = match force.keyed.has("damping") {
        true => loads.six(force, "damping", Along::Damping),
        false => Some(std::array::from_fn(|_| Load::Absent(0.0))),
    };
    Some(ForceShape::Bushing { between: between?, stiffness: stiffness?, damping: damping? })
}

fn along_coordinate(force: &Opened<'_>, loads: &mut Loads<'_>) -> Option<ForceShape> {
    let (coordinate, motion) = force.along?;
    match force.kind {
        "effort" => Some(ForceShape::Effort { coordinate, value: loads.optional(force, "value")? }),
        "joint-spring" => {
            acts(force, &["stiffness", "damping", "preload"]);
            let [stiffness, damping, free_position, preload] =
                ["stiffness", "damping", "free_position", "preload"].map(|name| loads.or_zero(force, name));
            Some(ForceShape::JointSpring { coordinate, stiffness, damping, free_position, preload })
        }
        "friction" => Some(friction(force, coordinate, motion, loads)),
        _ => Some(stop(force, coordinate, loads)),
    }
}

fn friction(force: &Opened<'_>, coordinate: Coordinate, motion: Motion, loads: &mut Loads<'_>) -> ForceShape {
    acts(force, &["coulomb", "static", "viscous"]);
    let rubs = force.keyed.has("coulomb") || force.keyed.has("static");
    if motion == Motion::Turn && rubs && !force.keyed.has("radius") {
        let message = format!("`radius` is missing in {}: it is on a turning coordinate", force.keyed.what());
        force.keyed.fault("missing-key", message);
    }
    if force.keyed.has("static") && !force.keyed.has("stribeck_velocity") {
        let message = format!("`stribeck_velocity` is missing in {}: it goes with `static`", force.keyed.what());
        force.keyed.fault("missing-key", message);
    }
    ForceShape::Friction {
        coordinate,
        coulomb: loads.or_zero(force, "coulomb"),
        static_coefficient: loads.optional(force, "static"),
        stribeck_velocity: loads.optional(force, "stribeck_velocity"),
        viscous: loads.or_zero(force, "viscous"),
        radius: loads.optional(force, "radius"),
        smoothing_velocity: loads.optional(force, "smoothing_velocity"),
    }
}

/// A hard stop acts in forward dynamics only: in impacts, and as a limit that is not passed.
fn stop(force: &Opened<'_>, coordinate: Coordinate, loads: &mut Loads<'_>) -> ForceShape {
    let keyed = &force.keyed;
    if !keyed.has("min") && !keyed.has("max") {
        keyed.fault("missing-key", format!("{} needs `min`, `max` or both", keyed.what()));
    }
    match (keyed.has("stiffness"), keyed.value("restitution")) {
        (true, Some(value)) => {
            let message = format!("{} has a stiffness and a restitution; give one", keyed.what());
            keyed.report(Diagnostic::error("conflicting-keys", value.span, message));
        }
        (false, None) => {
            keyed.fault("missing-key", format!("{} needs `stiffness` or `restitution`", keyed.what()));
        }
        _ => {}
    }
    ForceShape::Stop {
        coordinate,
        min: loads.optional(force, "min"),
        max: loads.optional(force, "max"),
        stiffness: loads.or_zero(force, "stiffness"),
        damping: loads.or_zero(force, "damping"),
        restitution: loads.optional(force, "restitution"),
    }
}
