//! One study while it runs: the mechanism, what is prescribed, what has been recorded.

mod forward;

use bellcrank_doc::Diagnostic;
use bellcrank_multibody::{Actuation, Coordinate, Engine, MechanismError, Moved};
use bellcrank_results::{Column, Failure, Reaction, StudyResult};

use super::End;
use super::animation::Frames;
use super::course::{Assembly, Course, Laws, Path};
use super::explain::{self, Namer, Places};
use super::inputs::{Evaluated, Inputs};
use super::notes::Notes;
use super::recorder::Recorder;
use crate::build::{self, Built};
use crate::design::{Design, Hold, Study, Task};
use crate::elastic::stroke::{self, Shapes};
use crate::flex;
use crate::measure::Measure;
use crate::model::parameter_row;
use crate::signals::{Level, View};

/// Numbers that a table may have; beyond, memory is at stake.
const MOST_NUMBERS: usize = 1 << 28;

/// Told of every row that is recorded, with the acceleration of free fall.
pub(crate) type Watch<'w> = Box<dyn FnMut(&View<'_>, [f64; 3]) + 'w>;

/// One study while it runs.
pub(crate) struct Session<'d> {
    pub(super) design: &'d Design,
    pub(super) study: &'d Study,
    built: Built,
    engine: Box<dyn Engine>,
    inputs: Inputs,
    recorder: Recorder,
    frames: Frames,
    shapes: Shapes,
    /// Columns beside those of the model's signals, as long as the table.
    pub(super) beside: Vec<Column>,
    efforts: Vec<Coordinate>,
    pub(super) notes: Notes,
    pub(super) result: StudyResult,
    effort: Effort,
    watch: Option<Watch<'d>>,
}

/// Work done.
#[derive(Default)]
struct Effort {
    positions: usize,
    iterations: usize,
    steps: usize,
    restarts: usize,
    force_solutions: usize,
}

impl<'d> Session<'d> {
    /// With bodies that deform, or all of them rigid.
    pub(super) fn new(design: &'d Design, study: &'d Study, flexible: bool) -> Result<Session<'d>, End> {
        let mut faults = Vec::new();
        let mut built = build::build(design, &study.values, &mut faults).ok_or_else(|| refused(faults.first()))?;
        if flexible {
            flex::deform(design, &study.values, &study.values, &mut built)?;
        }
        let engine = build::engine(design, &built).map_err(|fault| refused(Some(&fault)))?;
        let inputs = Inputs::new(design);
        let result = StudyResult {
            changed: study.changed.iter().filter_map(|&i| parameter_row(design, &study.parameters, i, "")).collect(),
            ..StudyResult::default()
        };
        Ok(Session {
            design,
            study,
            built,
            engine,
            inputs,
            recorder: Recorder::default(),
            frames: Frames::default(),
            shapes: Shapes::default(),
            beside: Vec::new(),
            efforts: Vec::new(),
            notes: Notes::default(),
            result,
            effort: Effort::default(),
            watch: None,
        })
    }

    /// With somebody to tell of every row.
    pub(super) fn watched(self, watch: Watch<'d>) -> Session<'d> {
        Session { watch: Some(watch), ..self }
    }

    pub(super) fn namer(&self) -> Namer<'d> {
        Namer::new(self.design)
    }

    /// Present place of a coordinate.
    pub(super) fn place(&self, c: Coordinate) -> f64 {
        self.engine.coordinate(c).position
    }

    /// The start that the file gives for a coordinate.
    pub(super) fn start(&self, c: Coordinate) -> Option<f64> {
        self.built.blueprint.joints.get(c.joint.0)?.start.get(c.index).copied().flatten()
    }

    /// Assembles the machine where the study begins.
    pub(super) fn begin(&mut self, path: Path<'d>, holds: &'d [Hold], motions: &[usize]) -> Result<Course<'d>, End> {
        let (design, values) = (self.design, &self.study.values);
        let mut machine = Assembly { design, values, built: &self.built, engine: &mut *self.engine };
        match Course::begin(&mut machine, path, holds, motions) {
            Ok(course) => {
                self.effort.iterations += course.assembled.iterations;
                self.effort.restarts += course.assembled.restarts;
                Ok(course)
            }
            Err(error) => Err(self.failed(&error, "before the first position")),
        }
    }

    /// What the study prescribes along its rows.
    pub(super) fn laws(&self, course: &Course<'d>) -> Laws<'d> {
        course.laws(&self.study.values, &self.built.blueprint)
    }

    /// Places on the axis in words.
    pub(super) fn places(&self) -> Places<'d> {
        Places::new(self.design, self.study)
    }

    /// The signal that the rows are counted by.
    pub(super) fn axis_name(&self) -> String {
        self.study.axis().map_or_else(|| "time".to_owned(), |c| self.namer().signal(c))
    }

    /// Chooses what is prescribed and what carries efforts.
    pub(super) fn prepare(&mut self, actuation: &Actuation) -> Result<(), End> {
        self.efforts.clone_from(&actuation.effort);
        self.engine.prepare(actuation).map_err(|error| self.failed(&error, ""))
    }

    /// Makes room for the rows of the study.
    pub(super) fn expect_rows(&mut self, rows: usize, has_time: bool) -> Result<(), End> {
        let forces = match &self.study.task {
            Task::Motion { forces, .. } => *forces,
            Task::Modes(of) => of.equilibrium,
            _ => true,
        };
        self.recorder = Recorder::new(self.design, &self.efforts, forces, has_time);
        if rows.saturating_mul(self.recorder.width()) > MOST_NUMBERS {
            let message = format!("{rows} rows of {} signals do not fit into memory", self.recorder.width());
            return Err(Box::new(Failure { message, hints: vec!["take fewer points".to_owned()] }));
        }
        self.recorder.reserve(rows);
        self.frames = Frames::new(self.design, rows, has_time);
        Ok(())
    }

    /// Moves to a position; an error ends the study.
    pub(super) fn move_to(&mut self, time: f64, targets: &[f64], place: &dyn Fn() -> String) -> Result<Moved, End> {
        match self.engine.move_to(time, targets) {
            Ok(moved) => {
                self.effort.positions += 1;
                self.effort.iterations += moved.iterations;
                self.effort.steps += moved.steps;
                Ok(moved)
            }
            Err(error) => Err(self.failed(&error, &place())),
        }
    }

    /// Rates and forces of the present position, as far as they are determined; then records a row.
    pub(super) fn solve_row(&mut self, velocity: &[f64], acceleration: &[f64], place: &dyn Fn() -> String) -> Moved {
        let (level, moved) = self.solve(velocity, acceleration, place);
        self.record(level);
        moved
    }

    fn solve(&mut self, velocity: &[f64], acceleration: &[f64], place: &dyn Fn() -> String) -> (Level, Moved) {
        let moved = match self.engine.set_rates(velocity, acceleration) {
            Ok(moved) => moved,
            Err(error) => {
                let message = explain::row(&self.namer(), &error, "velocities and all that follows");
                self.notes.add(&message, place);
                return (Level::Position, Moved::default());
            }
        };
        // Kinematics solves forces as well: the loop closure is told together with the power balance.
        let of = Evaluated { design: self.design, values: &self.study.values, geometry: &self.built.geometry };
        let inputs = &mut self.inputs;
        match self.engine.solve_forces(&mut |at, values| inputs.evaluate(at, of, values)) {
            Ok(()) => {
                self.effort.force_solutions += 1;
                (Level::Force, moved)
            }
            Err(error) => {
                if self.recorder.has_forces() {
                    let message = explain::row(&self.namer(), &error, "forces");
                    self.notes.add(&message, place);
                }
                (Level::Acceleration, moved)
            }
        }
    }

    /// Adds the present position to the rows.
    pub(super) fn record(&mut self, level: Level) {
        let view = View {
            readings: &*self.engine,
            catalogue: &self.design.catalogue,
            geometry: &self.built.geometry,
            efforts: &self.efforts,
            level,
        };
        self.recorder.record(&view);
        self.frames.record(&view, self.recorder.rows() - 1);
        self.shapes.record(view.readings, &self.built.flexible);
        if let Some(watch) = &mut self.watch {
            watch(&view, self.built.blueprint.gravity);
        }
        if self.recorder.has_forces() && level == Level::Force && self.result.reactions.is_empty() {
            self.result.reactions = reactions(self.design, &mut *self.engine);
        }
    }

    /// What is recorded in a column so far.
    pub(super) fn recorded(&self, name: &str) -> &[f64] {
        self.recorder.values(name)
    }

    /// Finds equilibrium with some coordinates held, and records it.
    pub(super) fn equilibrium(
        &mut self,
        hold: &[(Coordinate, f64)],
        place: &str,
    ) -> Result<bellcrank_multibody::Equilibrium, End> {
        let of = Evaluated { design: self.design, values: &self.study.values, geometry: &self.built.geometry };
        let inputs = &mut self.inputs;
        match self.engine.equilibrium(hold, &mut |at, values| inputs.evaluate(at, of, values)) {
            Ok(found) => {
                self.effort.iterations += found.iterations;
                self.effort.positions += 1;
                self.record(Level::Force);
                Ok(found)
            }
            Err(error) => Err(self.failed(&error, place)),
        }
    }

    /// Sets which coordinates carry efforts where the engine chooses the rest.
    pub(super) fn carry(&mut self, efforts: Vec<Coordinate>) {
        self.efforts = efforts;
    }

    /// The failure of a run.
    pub(super) fn failed(&self, error: &MechanismError, place: &str) -> End {
        let namer = self.namer();
        let mut failure = explain::failure(&namer, error, &format!("study `{}`", self.study.name), place);
        // It is not the end that lies out of reach then.
        if let (MechanismError::Stopped { coordinate, reached, .. }, 0) = (error, self.recorder.rows())
            && let Some(hint) = failure.hints.first_mut()
        {
            let (name, reached) = (namer.coordinate(*coordinate), namer.place(*coordinate, *reached));
            *hint = format!("begin the sweep of `{name}` within its reach: the machine as assembled gets to {reached}");
        }
        Box::new(failure)
    }

    /// `3 mm`, in display units.
    pub(super) fn shown(&self, value: f64, measure: Measure) -> String {
        explain::shown(value, &self.design.units.of(measure))
    }

    /// The result with all that was recorded.
    pub(super) fn finish(mut self, failure: Option<End>) -> StudyResult {
        let notes = std::mem::take(&mut self.notes).sentences();
        let mut result = self.result;
        result.table = self.recorder.table();
        result.table.columns.append(&mut self.beside);
        result.animation = self.frames.animation();
        result.warnings.extend(notes);
        stroke::tell(self.design, self.study, &self.built, &self.shapes, &mut result);
        let count = |name: &str, value: usize| (name.to_owned(), value as f64);
        if result.effort.is_empty() {
            result.effort = vec![
                count("positions", self.effort.positions),
                count("newton_iterations", self.effort.iterations),
                count("steps", self.effort.steps),
                count("force_solutions", self.effort.force_solutions),
                count("assembly_restarts", self.effort.restarts),
            ];
        }
        result.failure = failure.map(|failure| *failure);
        result
    }
}

/// A model that was checked is refused only for a fault of the program; it is told like any other.
fn refused(fault: Option<&Diagnostic>) -> End {
    let message = fault.map_or_else(|| "the model makes no mechanism".to_owned(), |fault| fault.message.clone());
    Box::new(Failure { message, hints: fault.map_or_else(Vec::new, |fault| fault.hints.clone()) })
}

fn reactions(design: &Design, engine: &mut dyn Engine) -> Vec<Reaction> {
    let components = crate::signals::reaction_components(design.planar);
    let unique = engine.uniqueness();
    let of = |(joint, unique): (&crate::design::Joint, [bool; 6])| Reaction {
        joint: joint.name.clone(),
        kind: joint.kind.to_owned(),
        unique: components.iter().map(|(name, place)| ((*name).to_owned(), unique[*place])).collect(),
    };
    let with_points = design.joints.iter().zip(unique).filter(|(joint, _)| joint.connects.is_some());
    with_points.map(of).collect()
}
