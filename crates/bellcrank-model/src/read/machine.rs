//! What has been read so far, by name; and the order of reading.

use bellcrank_doc::{Diagnostic, Diagnostics, Reader, Span};
use bellcrank_multibody::{Coordinate, JointId};

use super::flexible::{self, Deforming};
use super::{
    Files, PartReader, Tables, beams, bodies, forces, joints, materials, motions, planes, solids, studies, units,
};
use crate::design::{Beam, Body, Design, Joint, Material, PointRef, Quantity, Solid, Study, coordinates};
use crate::keyed::Keyed;
use crate::measure::{DisplayUnits, Motion};
use crate::names::Index;
use crate::schema::MODEL;
use crate::written::sections;

/// Bodies and joints by name.
#[derive(Debug, Default)]
pub(crate) struct Machine {
    /// Ground first.
    pub(crate) bodies: Vec<Body>,
    pub(crate) materials: Vec<Material>,
    pub(crate) solids: Vec<Solid>,
    pub(crate) beams: Vec<Beam>,
    pub(crate) joints: Vec<Joint>,
    pub(crate) body_names: Index,
    pub(crate) joint_names: Index,
    pub(crate) material_names: Index,
    pub(crate) solid_names: Index,
    pub(crate) beam_names: Index,
    /// Bodies that deform, as far as they are read: what takes hold of them is not known before forces are.
    pub(super) deforming: Vec<Deforming>,
    /// Points by the name of their body: that of a subsystem's ground leads to the body that carries it.
    pub(crate) point_names: Vec<Index>,
    /// Where the points of a body of this name are: body, and what stands before their names there.
    grounds: Vec<(String, usize, String)>,
    /// The point that carries the ground of each part; `None` where it is that of the world.
    pub(crate) mounts: Vec<Option<PointRef>>,
    /// Names whose definitions were reported as wrong: references to them are not reported again.
    pub(crate) faulty_joints: Index,
}

impl Machine {
    /// Makes a subsystem's ground a name for part of another body.
    pub(crate) fn mount(&mut self, ground: String, body: usize, point_prefix: String) {
        self.body_names.insert(&ground, body);
        self.grounds.push((ground, body, point_prefix));
    }

    /// The body of a full name.
    pub(crate) fn body(&self, full: &str) -> Option<usize> {
        self.body_names.get(full)
    }

    /// The point of a reference as a file with this prefix writes it.
    pub(crate) fn point(&self, written: &str, prefix: &str, span: Span) -> Result<PointRef, Box<Diagnostic>> {
        let Some((body_name, point_name)) = written.rsplit_once('.') else {
            let message = format!("expected a point, `body.point`, found `{written}`");
            let report = Diagnostic::error("not-a-point", span, message);
            return Err(Box::new(match self.body_names.get(&format!("{prefix}{written}")) {
                Some(body) => report.hint(self.points_of(body, "", written)),
                None => report,
            }));
        };
        let body = self.body_names.find(body_name, prefix, "body", span)?;
        let full = format!("{prefix}{body_name}");
        let ground = self.grounds.iter().find(|(name, _, _)| *name == full);
        let before = ground.map_or("", |(_, _, before)| before.as_str());
        let point = self.point_names[body].get(&format!("{before}{point_name}"));
        match point {
            Some(point) => Ok(PointRef { body, point }),
            None => Err(Box::new(self.unknown_point(body, before, body_name, point_name, span))),
        }
    }

    fn unknown_point(&self, body: usize, before: &str, body_name: &str, point_name: &str, span: Span) -> Diagnostic {
        let full = format!("{before}{point_name}");
        let names = &self.point_names[body];
        let message = match body {
            0 => format!("the ground has no point `{point_name}`"),
            _ => format!("body `{body_name}` has no point `{point_name}`"),
        };
        let mut report = Diagnostic::error("unknown-name", span, message);
        report = match names.nearest(&full) {
            Some(near) => report.hint(format!("did you mean `{}`?", near.strip_prefix(before).unwrap_or(near))),
            None => report.hint(self.points_of(body, before, body_name)),
        };
        if let Some(body) = self.bodies.get(body).filter(|body| body.name != "ground") {
            report = report.also(body.span, "this body");
        }
        report
    }

    /// The points that a body has, or how it gets some.
    fn points_of(&self, body: usize, before: &str, written: &str) -> String {
        match self.point_names[body].listed(before) {
            Some(names) => format!("points of `{written}`: {names}"),
            None if body == 0 => "points of the ground stand in `[ground.points]`, as `O = [0, 0]`".to_owned(),
            None => format!("`{written}` has no points; give it some: `points = {{ A = [0, 0] }}`"),
        }
    }

    /// Whether a joint of this full name (or coordinate) was there, but wrong.
    pub(crate) fn is_faulty(&self, full: &str) -> bool {
        let joint = full.rsplit_once('.').map_or(full, |(joint, _)| joint);
        self.faulty_joints.get(full).or_else(|| self.faulty_joints.get(joint)).is_some()
    }

    /// The joint of a reference as a file with this prefix writes it.
    pub(crate) fn joint(&self, written: &str, prefix: &str, span: Span) -> Result<usize, Box<Diagnostic>> {
        self.joint_names.find(written, prefix, "joint", span)
    }

    /// The coordinate of a reference `joint` or `joint.1`, and what it counts.
    pub(crate) fn coordinate(
        &self,
        written: &str,
        prefix: &str,
        span: Span,
        planar: bool,
    ) -> Result<(Coordinate, Motion), Box<Diagnostic>> {
        let (joint, index) = self.joint_and_index(written, prefix, span)?;
        let of = &self.joints[joint];
        let motions = of.coordinates(planar);
        let picked = index.unwrap_or(0);
        match motions.get(picked) {
            Some(_) if index.is_none() && motions.len() > 1 => Err(Box::new(ambiguous(of, motions.len(), span))),
            Some(&motion) => Ok((Coordinate { joint: JointId(joint), index: picked }, motion)),
            None => Err(Box::new(no_coordinate(of, written, motions.len(), span))),
        }
    }

    /// A joint, and the index behind its name; a joint that is itself called `a.1` comes first.
    fn joint_and_index(
        &self,
        written: &str,
        prefix: &str,
        span: Span,
    ) -> Result<(usize, Option<usize>), Box<Diagnostic>> {
        let known = |name: &str| self.joint_names.get(&format!("{prefix}{name}"));
        if let Some(joint) = known(written) {
            return Ok((joint, None));
        }
        let split = written.rsplit_once('.').and_then(|(name, index)| Some((known(name)?, index.parse().ok()?)));
        match split {
            Some((joint, index)) => Ok((joint, Some(index))),
            None => Err(self.joint(written, prefix, span).err().unwrap_or_else(|| {
                Box::new(Diagnostic::error("unknown-name", span, format!("there is no joint `{written}`")))
            })),
        }
    }
}

fn ambiguous(joint: &Joint, count: usize, span: Span) -> Diagnostic {
    let name = local(&joint.name);
    let message = format!("joint `{name}` ({}) has {count} coordinates; say which", joint.kind);
    let all: Vec<String> = (0..count).map(|i| format!("`{name}.{i}`")).collect();
    Diagnostic::error("which-coordinate", span, message).hint(format!("one of {}", all.join(", ")))
}

fn no_coordinate(joint: &Joint, written: &str, count: usize, span: Span) -> Diagnostic {
    let name = local(&joint.name);
    let message = match count {
        0 => format!("joint `{name}` ({}) has no coordinate", joint.kind),
        _ => format!("there is no coordinate `{written}`: joint `{name}` ({}) has {count}", joint.kind),
    };
    let report = Diagnostic::error("no-coordinate", span, message).also(joint.span, "this joint");
    if count > 1 { report.hint(format!("they count from 0: `{name}.0` to `{name}.{}`", count - 1)) } else { report }
}

/// The last part of a dotted name.
fn local(name: &str) -> &str {
    name.rsplit('.').next().unwrap_or(name)
}

/// A model read from its files.
pub(crate) struct ReadModel {
    pub(crate) title: Option<String>,
    pub(crate) design: Design,
    pub(crate) studies: Vec<Study>,
}

/// Reads the parts; everything wrong is reported. `None` when so much is wrong that nothing can be built.
pub(crate) fn read_model(files: Files, tables: &Tables<'_>, diagnostics: &mut Diagnostics) -> Option<ReadModel> {
    let Files { parts, scopes, .. } = files;
    let readers: Vec<Reader<'_>> = scopes.iter().map(|scope| Reader::new(&scope.parameters)).collect();
    let read = read_parts(&parts, &readers, &scopes, tables);
    for reader in readers {
        diagnostics.append(reader.finish());
    }
    let (head, machine, forces, motions, studies) = read?;
    let design = Design {
        planar: head.planar,
        gravity: head.gravity,
        gravity_span: head.gravity_span,
        bodies: machine.bodies,
        materials: machine.materials,
        solids: machine.solids,
        beams: machine.beams,
        joints: machine.joints,
        forces: forces.forces,
        inputs: forces.inputs,
        input_signals: forces.signals,
        motions: motions.list,
        motion_order: motions.order,
        units: head.units,
        catalogue: forces.catalogue,
        scopes,
        written: sections(&parts),
        reductions: crate::flex::Store::default(),
    };
    Some(ReadModel { title: head.title, design, studies })
}

/// What stands at the top of the main file.
struct Head {
    title: Option<String>,
    planar: bool,
    gravity: Vec<Quantity>,
    gravity_span: Span,
    units: DisplayUnits,
}

type ReadParts = (Head, Machine, forces::ReadForces, motions::ReadMotions, Vec<Study>);

fn read_parts<'a>(
    parts: &'a [super::Part],
    readers: &'a [Reader<'a>],
    scopes: &'a [crate::design::Scope],
    tables: &Tables<'_>,
) -> Option<ReadParts> {
    let main = parts.first()?;
    let planar = planar(main);
    let mut all: Vec<PartReader<'a>> = Vec::with_capacity(parts.len());
    for part in parts {
        // The file that includes it comes before it.
        let around = part.parent.and_then(|parent| all.get(parent)).map_or(planar, |parent| parent.planar);
        let own = around || space(part) == Some("planar");
        all.push(PartReader { part, reader: &readers[part.scope.0], planar: own, machine_planar: planar });
    }
    let head = read_head(all[0]);
    for part in &all[1..] {
        check_part(*part);
    }
    let mut machine = Machine::default();
    materials::read(&all, &mut machine);
    solids::read(&all, &mut machine);
    beams::read(&all, &mut machine);
    bodies::read(&all, &mut machine);
    beams::fit(&all, &mut machine);
    solids::fit(&all, &mut machine);
    joints::read(&all, &mut machine);
    planes::hold(&all, &mut machine);
    let forces = forces::read(&all, &machine);
    flexible::fit(all[0].reader, &mut machine, &forces.forces);
    let motions = motions::read(&all, &machine, tables);
    let studies = studies::read(all[0], &machine, &motions, tables, &forces.catalogue, scopes);
    Some((head?, machine, forces, motions, studies))
}

/// The space as far as it can be told; the plane while it is not known.
fn planar(main: &super::Part) -> bool {
    space(main) != Some("spatial")
}

fn space(part: &super::Part) -> Option<&str> {
    part.table.get("space").and_then(|entry| entry.value.as_str())
}

fn open<'a>(part: PartReader<'a>) -> Keyed<'a> {
    let fields = bellcrank_doc::Fields::new(part.reader, &part.part.table, "the model");
    Keyed::new(fields, &MODEL, part.space())
}

fn read_head(part: PartReader<'_>) -> Option<Head> {
    let keyed = open(part);
    check_version(&keyed);
    let title = keyed.text("title").map(|title| title.value.to_owned());
    let space = keyed.choice("space");
    // A wrong space would make the number of components wrong as well.
    let gravity = if space.is_some() { keyed.vector("gravity") } else { keyed.value("gravity").and(None) };
    let gravity_span = part.part.table.get("gravity").map_or(keyed.span(), |entry| entry.value.span);
    let units = keyed.table("units").map(units::read);
    keyed.finish();
    Some(Head {
        title,
        planar: part.planar,
        gravity: part.quantities(gravity?),
        gravity_span,
        units: units.unwrap_or_else(|| DisplayUnits::new(&[])),
    })
}

/// A subsystem's own head: its gravity, units and studies count only when it runs alone.
fn check_part(part: PartReader<'_>) {
    let keyed = open(part);
    check_version(&keyed);
    if let Some(space) = keyed.choice("space")
        && space.value == "spatial"
        && part.planar
    {
        let message = "this subsystem is spatial, the machine it is part of is planar";
        let report = Diagnostic::error("wrong-space", space.span, message);
        keyed.report(report.hint("a planar file can be part of a spatial machine, not the other way round"));
    }
    keyed.finish();
}

fn check_version(keyed: &Keyed<'_>) {
    let Some(value) = keyed.value("bellcrank") else { return };
    if !matches!(value.kind, bellcrank_doc::ValueKind::Integer(1)) {
        let message = "this version reads format version 1 only";
        keyed.report(Diagnostic::error("wrong-version", value.span, message).hint("write `bellcrank = 1`"));
    }
}

/// What the coordinates of a joint kind count, for messages.
pub(crate) fn describe_coordinates(kind: &str, planar: bool) -> String {
    let named = |motion: &Motion| match motion {
        Motion::Slide => "a distance",
        Motion::Turn => "an angle",
    };
    coordinates(kind, planar).iter().map(named).collect::<Vec<_>>().join(", ")
}
