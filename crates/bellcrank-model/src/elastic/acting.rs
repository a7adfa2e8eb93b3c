//! What a machine puts on one of its bodies: reactions, force elements, weight and inertia, row by row.

use bellcrank_multibody::{BodyId, ForceId, JointId};
use bellcrank_results::StudyResult;

use super::vector::{V3, add, cross, scale, sub, turned_back};
use super::{Asked, End};
use crate::design::{Design, Force, ForceShape, PointRef, Study};
use crate::progress::Progress;
use crate::run;
use crate::signals::{Level, View};

/// Where something takes hold of a body.
#[derive(Clone, Debug)]
pub(super) struct Pin {
    /// Point of the body; `None` where the body as a whole is loaded.
    point: Option<usize>,
    /// Its name, and what acts there.
    pub(super) name: String,
    pub(super) from: Vec<String>,
    /// Place, body axes, m; the origin for the body as a whole.
    pub(super) at: V3,
}

/// What acts in one row; body axes.
#[derive(Clone, Debug)]
pub(super) struct RowLoads {
    /// Force and moment at each pin, about its place.
    pub(super) wrenches: Vec<[f64; 6]>,
    pub(super) field: Field,
}

/// Weight and inertia of a body: −ρ (g − a − α × r − ω × (ω × r)), r from the origin of the body.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Field {
    /// g − a.
    pub(super) free: V3,
    pub(super) omega: V3,
    pub(super) alpha: V3,
}

/// What acts on a body in all rows.
#[derive(Clone, Debug, Default)]
pub(super) struct Acting {
    pub(super) pins: Vec<Pin>,
    /// `None` where the machine has no solution.
    pub(super) rows: Vec<Option<RowLoads>>,
    pub(super) warnings: Vec<String>,
}

/// Something that acts at a pin.
#[derive(Clone, Copy, Debug)]
enum Source {
    /// The body is the second of the joint, else the first.
    Joint {
        joint: usize,
        second: bool,
    },
    /// The body is that of the point, or the second of two.
    Force {
        force: usize,
        second: bool,
    },
    Torque {
        force: usize,
    },
}

/// Reads the loads of one body.
struct Reader<'d> {
    body: usize,
    /// Sources, and the place of the pin that each acts at.
    sources: Vec<(Source, usize)>,
    design: &'d Design,
    acting: Acting,
}

/// Runs the study with the parameters of the one that asks, and reads what acts on its bodies.
pub(super) fn read(
    asked: &Asked<'_>,
    of: &Study,
    progress: &mut dyn Progress,
) -> Result<(StudyResult, Vec<Acting>), End> {
    let design = asked.design;
    let own = with_own_parameters(asked, of);
    let mut readers: Vec<Reader<'_>> = asked.parts.bodies.iter().map(|&body| Reader::new(design, body)).collect();
    let watch = Box::new(|view: &View<'_>, gravity| {
        readers.iter_mut().for_each(|reader| reader.row(view, gravity));
    });
    let result = run::run_watched(design, &own, progress, watch);
    if let Some(failure) = result.failure {
        return Err(Box::new(failure));
    }
    Ok((result, readers.into_iter().map(|reader| reader.acting).collect()))
}

fn with_own_parameters(asked: &Asked<'_>, of: &Study) -> Study {
    Study {
        name: of.name.clone(),
        span: of.span,
        kind: of.kind,
        task: of.task.clone(),
        // Loads on a part are those of the rigid machine.
        flexible: false,
        parameters: asked.study.parameters.clone(),
        changed: asked.study.changed.clone(),
        named: Vec::new(),
        values: asked.study.values.clone(),
    }
}

impl<'d> Reader<'d> {
    fn new(design: &'d Design, body: usize) -> Reader<'d> {
        let mut reader = Reader { body, sources: Vec::new(), design, acting: Acting::default() };
        for (index, joint) in design.joints.iter().enumerate() {
            for (side, end) in joint.connects.into_iter().flatten().enumerate().filter(|(_, end)| end.body == body) {
                let source = Source::Joint { joint: index, second: side == 1 };
                reader.add(source, Some(end), format!("joint `{}`", joint.name));
            }
        }
        for (index, force) in design.forces.iter().enumerate() {
            reader.force(index, force);
        }
        reader
    }

    fn force(&mut self, index: usize, force: &Force) {
        let name = format!("force `{}`", force.name);
        match &force.shape {
            ForceShape::Point { at, .. } if at.body == self.body => {
                self.add(Source::Force { force: index, second: true }, Some(*at), name);
            }
            ForceShape::Torque { on, .. } if *on == self.body => self.add(Source::Torque { force: index }, None, name),
            ForceShape::Spring { between, .. } | ForceShape::Bushing { between, .. } => {
                for (side, end) in between.iter().enumerate() {
                    if end.body != self.body {
                        continue;
                    }
                    if matches!(force.shape, ForceShape::Bushing { .. }) {
                        let message = format!("the moment of bushing `{}` is not among the loads", force.name);
                        self.acting.warnings.push(message);
                    }
                    self.add(Source::Force { force: index, second: side == 1 }, Some(*end), name.clone());
                }
            }
            // Efforts along coordinates go through the joint and are part of its reaction.
            _ => {}
        }
    }

    fn add(&mut self, source: Source, at: Option<PointRef>, from: String) {
        let point = at.map(|at| at.point);
        let pins = &mut self.acting.pins;
        let place = pins.iter().position(|pin| pin.point == point).unwrap_or_else(|| {
            let body = &self.design.bodies[self.body];
            let name = point.and_then(|point| body.points.get(point)).map_or_else(String::new, |p| p.name.clone());
            pins.push(Pin { point, name, from: Vec::new(), at: [0.0; 3] });
            pins.len() - 1
        });
        if !pins[place].from.contains(&from) {
            pins[place].from.push(from);
        }
        self.sources.push((source, place));
    }

    fn row(&mut self, view: &View<'_>, gravity: V3) {
        let points = view.geometry.points.get(self.body);
        for pin in &mut self.acting.pins {
            let place = pin.point.and_then(|point| points?.get(point));
            pin.at = place.map_or([0.0; 3], |place| place.position);
        }
        let loads = (view.level >= Level::Force).then(|| self.loads(view, gravity));
        self.acting.rows.push(loads);
    }

    fn loads(&self, view: &View<'_>, gravity: V3) -> RowLoads {
        let id = BodyId(self.body);
        let motion = view.readings.body(id);
        let inside = |a: V3| turned_back(&motion.rotation, a);
        let mut wrenches = vec![[0.0; 6]; self.acting.pins.len()];
        for &(source, pin) in &self.sources {
            let (force, moment, about) = self.wrench(source, view);
            // World axes, about a place of the world; then body axes, about the pin.
            let about = about.map_or(self.acting.pins[pin].at, |about| inside(sub(about, motion.origin)));
            let (force, moment) = (inside(force), inside(moment));
            let moment = add(moment, cross(sub(about, self.acting.pins[pin].at), force));
            (0..3).for_each(|i| {
                wrenches[pin][i] += force[i];
                wrenches[pin][3 + i] += moment[i];
            });
        }
        let origin = view.readings.point(id, [0.0; 3]);
        let free = inside(sub(gravity, origin.acceleration));
        RowLoads { wrenches, field: Field { free, omega: inside(motion.omega), alpha: inside(motion.alpha) } }
    }

    /// Force and moment on the body, world axes, and the place they are about; `None` is the pin.
    fn wrench(&self, source: Source, view: &View<'_>) -> (V3, V3, Option<V3>) {
        match source {
            Source::Joint { joint, second } => {
                let wrench = view.readings.reaction(JointId(joint));
                let sign = if second { 1.0 } else { -1.0 };
                let end = self.design.joints[joint].connects.map(|[_, end]| end);
                let about = end.and_then(|end| {
                    let place = view.geometry.points.get(end.body)?.get(end.point)?;
                    Some(view.readings.point(BodyId(end.body), place.position).position)
                });
                (scale(wrench.force, sign), scale(wrench.moment, sign), about)
            }
            Source::Force { force, second } => {
                let vector = view.readings.force(ForceId(force)).vector;
                (scale(vector, if second { 1.0 } else { -1.0 }), [0.0; 3], None)
            }
            Source::Torque { force } => ([0.0; 3], view.readings.force(ForceId(force)).vector, None),
        }
    }
}
