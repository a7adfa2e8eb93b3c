//! A body with its mesh, supports and loads, in terms of the solver.

use bellcrank_fem::{Coupling, CouplingKind, Load, Material, Part, Region, Support};
use bellcrank_mesh::{Cylinder, Face, Mesh};

use super::acting::{Acting, Field, Pin, RowLoads};
use super::meshing::Solid;
use super::vector::{V3, add, cross, norm, scale, sub};
use super::{Asked, End, faults};
use crate::build::{self, ElasticNumbers, Form};
use crate::design::{Design, Hinges, HoldForm, LoadForm, Quantity, StressForm, SupportForm, Values};

/// One body of a study.
pub(super) struct Problem<'d> {
    pub(super) asked: &'d Asked<'d>,
    pub(super) body: usize,
    pub(super) solid: &'d Solid,
    pub(super) material: &'d Material,
    pub(super) acting: &'d Acting,
    pub(super) supports: &'d [SupportForm],
    pub(super) loads: &'d [LoadForm],
}

/// The same on a mesh.
pub(super) struct Setup<'m> {
    pub(super) part: Part<'m>,
    /// By pin.
    grips: Vec<Grip>,
    /// What the study itself puts on the body.
    pub(super) own: Vec<Load>,
    /// Nodes that cannot move against each other in any direction: stress round them means nothing.
    pub(super) held: Vec<u32>,
    /// Pins without a bore.
    pub(super) warnings: Vec<String>,
    hinges: Hinges,
}

/// How a pin takes hold of the mesh.
struct Grip {
    coupling: usize,
    /// `None` without one.
    bore: Option<Bore>,
}

/// The hole that a pin goes through.
struct Bore {
    faces: Vec<Face>,
    middle: V3,
    axis: V3,
}

/// The material of a body as the solver takes it, and its yield strength.
pub(super) fn material(asked: &Asked<'_>, body: usize, solid: &Solid) -> Result<(Material, Option<f64>), End> {
    material_of(asked.design, &asked.study.values, body, solid)
}

/// The same at some values.
pub(crate) fn material_of(
    design: &Design,
    values: &Values,
    body: usize,
    solid: &Solid,
) -> Result<(Material, Option<f64>), End> {
    let of = design.bodies[body].solid.as_ref().and_then(|worn| design.solids.get(worn.solid));
    let place = of.and_then(|of| of.material);
    let mut reports = Vec::new();
    let numbers = place.and_then(|place| build::material(design, values, place, &mut reports));
    let Some((numbers, elastic)) = numbers.and_then(|numbers| Some((numbers.clone(), numbers.elastic?))) else {
        return Err(faults::no_material(design, body, reports.first()));
    };
    let density = numbers.density.unwrap_or(0.0);
    let made = match elastic {
        ElasticNumbers::Isotropic { young, poisson } => Material::isotropic(young, poisson, density),
        ElasticNumbers::Orthotropic { young, poisson, shear } => Material::orthotropic(young, poisson, shear, density),
    };
    let made = made.map_err(|fault| faults::material(design, body, fault))?;
    let made = made.with_expansion(numbers.expansion.unwrap_or_default());
    Ok((made.rotated(&solid.axes()), numbers.strength))
}

impl<'d> Problem<'d> {
    /// What the study of stress says of a body.
    pub(super) fn new(
        asked: &'d Asked<'d>,
        body: usize,
        solid: &'d Solid,
        material: &'d Material,
        form: &'d StressForm,
        acting: &'d Acting,
    ) -> Problem<'d> {
        Problem { asked, body, solid, material, acting, supports: &form.supports, loads: &form.loads }
    }

    pub(super) fn name(&self) -> &str {
        &self.asked.design.bodies[self.body].name
    }

    /// Of its solid and its material.
    pub(super) fn names(&self) -> (String, String) {
        let design = self.asked.design;
        let worn = design.bodies[self.body].solid.as_ref();
        let solid = worn.and_then(|worn| design.solids.get(worn.solid));
        let material = solid.and_then(|solid| design.materials.get(solid.material?));
        let name = |name: Option<&String>| name.cloned().unwrap_or_default();
        (name(solid.map(|solid| &solid.name)), name(material.map(|material| &material.name)))
    }

    /// On a mesh, with pins that bear in some way.
    pub(super) fn on<'m>(&self, mesh: &'m Mesh, hinges: Hinges) -> Result<Setup<'m>, End> {
        let part = Part {
            mesh,
            materials: vec![self.material.clone(); mesh.blocks.len()],
            supports: Vec::new(),
            couplings: Vec::new(),
        };
        let mut setup =
            Setup { part, grips: Vec::new(), own: Vec::new(), held: Vec::new(), warnings: Vec::new(), hinges };
        for (index, pin) in self.acting.pins.iter().enumerate() {
            let grip = self.grip(&mut setup, index, pin);
            setup.grips.push(grip);
        }
        for support in self.supports {
            self.support(&mut setup, support)?;
        }
        for load in self.loads {
            self.load(&mut setup, load)?;
        }
        Ok(setup)
    }

    fn grip(&self, setup: &mut Setup<'_>, index: usize, pin: &Pin) -> Grip {
        let mesh = setup.part.mesh;
        let bore = self.solid.bore_at(mesh, pin.at).filter(|_| !pin.name.is_empty());
        let rigid = setup.hinges == Hinges::Rigid && bore.is_some();
        let kind = if rigid { CouplingKind::Rigid } else { CouplingKind::Distributing };
        let faces = match &bore {
            Some((faces, _)) => faces.clone(),
            None if pin.name.is_empty() => mesh.boundary(),
            None => near(mesh, pin.at),
        };
        if rigid {
            setup.held.extend(mesh.nodes_of_faces(&faces));
        }
        if bore.is_none() && self.acts(index) {
            setup.warnings.push(without_bore(self.name(), pin));
        }
        setup.part.couplings.push(Coupling::free(Region::Faces(faces), pin.at, kind));
        let bore = bore.map(|(faces, axis)| Bore { middle: centroid(mesh, &faces), faces, axis });
        Grip { coupling: setup.part.couplings.len() - 1, bore }
    }

    /// Whether anything acts at a pin in any row.
    fn acts(&self, pin: usize) -> bool {
        self.acting.rows.iter().flatten().any(|row| row.wrenches[pin].iter().any(|x| *x != 0.0))
    }

    /// The axis of the bore that a set is.
    fn axis_of(&self, mesh: &Mesh, set: &str) -> V3 {
        let full = format!("bore.{set}");
        let of_set = |cylinder: &Cylinder| cylinder.sets.iter().any(|name| name == set || *name == full);
        match self.solid.form {
            Form::Mesh(_) => mesh.cylinders().iter().find(|one| of_set(one)).map_or(self.solid.axis(), |one| one.axis),
            _ => self.solid.axis(),
        }
    }

    fn value(&self, quantity: &Quantity) -> f64 {
        quantity.eval::<f64>(&self.asked.study.values)
    }

    fn vector(&self, quantities: &[Quantity]) -> V3 {
        let mut vector = [0.0; 3];
        vector.iter_mut().zip(quantities).for_each(|(place, quantity)| *place = self.value(quantity));
        vector
    }

    pub(super) fn nodes(&self, mesh: &Mesh, set: &str) -> Result<Vec<u32>, End> {
        let known = [set.to_owned(), format!("bore.{set}")];
        let found = known.iter().find_map(|name| {
            let faces = mesh.face_sets.get(name).map(|faces| mesh.nodes_of_faces(faces));
            mesh.node_sets.get(name).cloned().or(faces)
        });
        found.ok_or_else(|| faults::no_set(self.name(), set, mesh, false))
    }

    fn faces(&self, mesh: &Mesh, set: &str) -> Result<Vec<Face>, End> {
        let found = mesh.face_sets.get(set).or_else(|| mesh.face_sets.get(&format!("bore.{set}")));
        found.cloned().ok_or_else(|| faults::no_set(self.name(), set, mesh, true))
    }

    fn support(&self, setup: &mut Setup<'_>, support: &SupportForm) -> Result<(), End> {
        let mesh = setup.part.mesh;
        let set = &support.set.value;
        let held = |value: &Option<Quantity>| value.as_ref().map_or(0.0, |value| self.value(value));
        match &support.hold {
            HoldForm::Nodes(values) => {
                let nodes = self.nodes(mesh, set)?;
                if values.iter().all(Option::is_some) {
                    setup.held.extend_from_slice(&nodes);
                }
                let values = std::array::from_fn(|k| values[k].as_ref().map(held));
                setup.part.supports.push(Support::along(nodes, values));
            }
            HoldForm::Spring(stiffness) => {
                let stiffness = self.vector(&stiffness[..]);
                setup.part.supports.push(Support::Spring { nodes: self.nodes(mesh, set)?, stiffness });
            }
            HoldForm::Frame { rigid, held: values } => {
                let coupling = self.coupling(setup, set, *rigid)?;
                setup.part.couplings[coupling].held = std::array::from_fn(|k| values[k].as_ref().map(held));
            }
        }
        Ok(())
    }

    /// A coupling of a set about its middle.
    fn coupling(&self, setup: &mut Setup<'_>, set: &str, rigid: bool) -> Result<usize, End> {
        let mesh = setup.part.mesh;
        let faces = self.faces(mesh, set)?;
        let middle = centroid(mesh, &faces);
        let kind = if rigid { CouplingKind::Rigid } else { CouplingKind::Distributing };
        if rigid {
            setup.held.extend(mesh.nodes_of_faces(&faces));
        }
        setup.part.couplings.push(Coupling::free(Region::Faces(faces), middle, kind));
        Ok(setup.part.couplings.len() - 1)
    }

    fn load(&self, setup: &mut Setup<'_>, load: &LoadForm) -> Result<(), End> {
        let mesh = setup.part.mesh;
        let set = load.set.as_ref().map_or("", |set| set.value.as_str());
        if !load.force.is_empty() || !load.moment.is_empty() {
            let (force, moment) = (self.vector(&load.force), self.vector(&load.moment));
            if load.bearing {
                let faces = self.faces(mesh, set)?;
                let center = centroid(mesh, &faces);
                let axis = self.axis_of(mesh, set);
                setup.own.push(Load::Bearing { faces, center, axis, force });
            } else {
                let coupling = self.coupling(setup, set, load.rigid)?;
                setup.own.push(Load::Frame { coupling, force, moment });
            }
        }
        if let Some(pressure) = &load.pressure {
            setup.own.push(Load::Pressure { faces: self.faces(mesh, set)?, value: self.value(pressure) });
        }
        if !load.traction.is_empty() {
            setup.own.push(Load::Traction { faces: self.faces(mesh, set)?, vector: self.vector(&load.traction) });
        }
        if !load.gravity.is_empty() {
            setup.own.push(Load::Gravity(self.vector(&load.gravity)));
        }
        if let Some(rise) = &load.temperature {
            setup.own.push(Load::Temperature(vec![self.value(rise); mesh.nodes.len()]));
        }
        Ok(())
    }
}

impl Solid {
    /// The faces of the bores whose axis goes through a place, and that axis.
    pub(crate) fn bore_at(&self, mesh: &Mesh, at: V3) -> Option<(Vec<Face>, V3)> {
        const SAME: f64 = 1e-4;
        let Form::Stack { stack, plane } = &self.form else { return found_bore(mesh, at) };
        let [right, up, _] = plane.axes();
        let through = stack.bores.iter().filter(|bore| {
            let apart = (bore.center[0] - at[right]).hypot(bore.center[1] - at[up]);
            apart <= SAME * bore.diameter
        });
        let names = through.filter_map(|bore| self.eyes.get(bore.eye));
        let faces: Vec<Face> =
            names.filter_map(|name| mesh.face_sets.get(&format!("bore.{name}"))).flatten().copied().collect();
        (!faces.is_empty()).then(|| (faces, self.axis()))
    }
}

impl Setup<'_> {
    /// The loads of a row.
    pub(super) fn row(&self, row: &RowLoads, pins: &[Pin]) -> Vec<Load> {
        let mut loads = field(&row.field);
        for ((grip, pin), wrench) in self.grips.iter().zip(pins).zip(&row.wrenches) {
            let ([fx, fy, fz, ..], [.., mx, my, mz]) = (*wrench, *wrench);
            loads.extend(self.pin(grip, pin, [fx, fy, fz], [mx, my, mz]));
        }
        loads
    }

    /// A unit force or moment at a pin.
    pub(super) fn unit(&self, pin: usize, component: usize) -> Load {
        let unit = |from: usize| std::array::from_fn(|i| f64::from(from + i == component));
        Load::Frame { coupling: self.grips[pin].coupling, force: unit(0), moment: unit(3) }
    }

    fn pin(&self, grip: &Grip, pin: &Pin, force: V3, moment: V3) -> Vec<Load> {
        let frame = |force, moment| Load::Frame { coupling: grip.coupling, force, moment };
        match &grip.bore {
            Some(Bore { faces, middle, axis }) if self.hinges == Hinges::Bearing && norm(force) > 0.0 => {
                // Pressure has its resultant in the middle of the bore: what the force has about it goes in beside.
                let left = add(moment, cross(sub(pin.at, *middle), force));
                let pressed = Load::Bearing { faces: faces.clone(), center: *middle, axis: *axis, force };
                vec![pressed, frame([0.0; 3], left)]
            }
            _ => vec![frame(force, moment)],
        }
    }
}

/// The bore among the cylinders of a mesh whose axis goes through a place; sets of one that lie on another are told with it.
fn found_bore(mesh: &Mesh, at: V3) -> Option<(Vec<Face>, V3)> {
    const SAME: f64 = 1e-2;
    let through = |one: &&Cylinder| {
        let arm = sub(at, one.center);
        one.bore && norm(cross(arm, one.axis)) <= SAME * one.radius
    };
    let found = mesh.cylinders();
    let bore = found.iter().filter(through).min_by(|a, b| a.radius.total_cmp(&b.radius))?;
    let faces = bore.sets.iter().filter_map(|set| mesh.face_sets.get(set)).flatten().copied().collect();
    Some((faces, bore.axis))
}

/// Weight and inertia.
pub(super) fn field(field: &Field) -> Vec<Load> {
    let zero = [0.0; 3];
    let moving = Load::Motion { about: zero, acceleration: zero, omega: field.omega, alpha: field.alpha };
    vec![Load::Gravity(field.free), moving]
}

fn without_bore(body: &str, pin: &Pin) -> String {
    let from = pin.from.join(", ");
    match pin.name.as_str() {
        "" => format!("{from} acts on no point of body `{body}`: it is spread over its whole surface"),
        name => format!(
            "body `{body}` has no bore at point `{name}`: the load of {from} is spread over the faces nearest to it"
        ),
    }
}

/// The middle of some faces.
fn centroid(mesh: &Mesh, faces: &[Face]) -> V3 {
    let (mut sum, mut area) = ([0.0; 3], 0.0);
    for &face in faces {
        let places: Vec<V3> = mesh.face_nodes(face).map(|node| mesh.nodes[node as usize]).collect();
        let shape = mesh.face_shape(face);
        for point in shape.points() {
            let (mut n, mut d) = ([0.0; 8], [[0.0; 2]; 8]);
            shape.evaluate([point.at[0], point.at[1]], &mut n, &mut d);
            let along = |c: usize| places.iter().zip(&d).fold([0.0; 3], |sum, (at, d)| add(sum, scale(*at, d[c])));
            let share = point.weight * norm(cross(along(0), along(1)));
            let at = places.iter().zip(&n).fold([0.0; 3], |sum, (at, n)| add(sum, scale(*at, *n)));
            sum = add(sum, scale(at, share));
            area += share;
        }
    }
    scale(sum, 1.0 / area)
}

/// Faces of the surface that are nearest to a place: all within twice the distance of the first, and those beside it.
pub(crate) fn near(mesh: &Mesh, at: V3) -> Vec<Face> {
    let faces = mesh.boundary();
    let measured: Vec<(f64, f64)> = faces
        .iter()
        .map(|&face| {
            let places: Vec<V3> = mesh.face_nodes(face).map(|node| mesh.nodes[node as usize]).collect();
            let middle = scale(places.iter().fold([0.0; 3], |sum, place| add(sum, *place)), 1.0 / places.len() as f64);
            let size = places.iter().map(|place| norm(sub(*place, middle))).fold(0.0, f64::max);
            (norm(sub(middle, at)), size)
        })
        .collect();
    let first =
        measured.iter().copied().fold((f64::INFINITY, 0.0), |best, next| if next.0 < best.0 { next } else { best });
    let reach = (2.0 * first.0).max(first.0 + 2.0 * first.1);
    faces.into_iter().zip(measured).filter(|(_, (away, _))| *away <= reach).map(|(face, _)| face).collect()
}

/// What relief had to balance, relative to the largest load: forces by the largest force, moments about the centre of
/// mass by that force times the half size of the part.
pub(super) fn unbalance(relief: &[f64; 6], row: &RowLoads, mesh: &Mesh, center: V3, mass: f64) -> f64 {
    let [force, moment] = [0, 3].map(|from| [relief[from], relief[from + 1], relief[from + 2]]);
    let moment = sub(moment, cross(center, force));
    let forces = row.wrenches.iter().map(|w| norm([w[0], w[1], w[2]]));
    let largest = forces.fold(mass * norm(row.field.free), f64::max);
    let half = mesh.nodes.iter().map(|node| norm(sub(*node, center))).fold(0.0, f64::max);
    let moments = row.wrenches.iter().map(|w| norm([w[3], w[4], w[5]]) / half);
    let largest = moments.fold(largest, f64::max);
    if largest > 0.0 { norm(force).max(norm(moment) / half) / largest } else { 0.0 }
}
