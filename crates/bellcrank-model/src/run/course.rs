//! What a study prescribes along its rows, over any scalar.

use bellcrank_multibody::{Actuation, Assembled, Blueprint, Coordinate, Engine, MechanismError};

use crate::build::Built;
use crate::design::{Design, Dynamics, Hold, Over, ROWS, Sweep, Values, moved};
use crate::motion::{Programme, Running, Schedule};
use crate::scalar::Scalar;

/// A machine with numbers, before its study begins.
pub(crate) struct Assembly<'a, 'd> {
    pub(crate) design: &'d Design,
    pub(crate) values: &'a Values,
    pub(crate) built: &'a Built,
    pub(crate) engine: &'a mut dyn Engine,
}

impl<'d> Assembly<'_, 'd> {
    /// The start that the file gives for a coordinate.
    pub(crate) fn start(&self, c: Coordinate) -> Option<f64> {
        start(&self.built.blueprint, c)
    }

    fn place(&self, c: Coordinate) -> f64 {
        self.engine.coordinate(c).position
    }

    /// The motions that act, as long as they are there, and nothing has moved yet.
    fn programme(&self, acting: &[usize]) -> Programme<'d> {
        let schedule = Schedule::new(self.design, self.values);
        let from = |c| self.start(c).unwrap_or(0.0);
        Programme::new(self.design, acting, &schedule, self.values, &from)
    }

    /// Where coordinates rest, as far as the study or a start says.
    pub(crate) fn held(&self, holds: &[Hold]) -> Vec<(Coordinate, f64)> {
        let place = |hold: &Hold| match &hold.at {
            Some(at) => Some((hold.coordinate, at.eval(self.values))),
            None => self.start(hold.coordinate).map(|start| (hold.coordinate, start)),
        };
        holds.iter().filter_map(place).collect()
    }

    /// Assembles with as much held as can be: first all of `wished`, then only what is `needed`. Starts that the
    /// file wants held exactly come before what a study would like.
    pub(crate) fn assemble(
        &mut self,
        needed: &[(Coordinate, f64)],
        wished: &[(Coordinate, f64)],
    ) -> Result<Assembled, MechanismError> {
        let exact_starts = self.design.joints.iter().any(|joint| joint.at_start);
        let all: Vec<(Coordinate, f64)> = needed.iter().chain(wished).copied().collect();
        let first = if exact_starts { needed } else { &all };
        match self.engine.assemble(first) {
            Err(_) if first.len() > needed.len() => self.engine.assemble(needed),
            other => other,
        }
    }
}

fn start<T: Copy>(blueprint: &Blueprint<T>, c: Coordinate) -> Option<T> {
    blueprint.joints.get(c.joint.0)?.start.get(c.index).copied().flatten()
}

/// What the rows run over.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Path<'d> {
    /// Motion over positions or time.
    Motion(&'d Over),
    /// Rest, at each position of a held coordinate when swept.
    Rest(Option<&'d Sweep>),
    /// Time, with some coordinates prescribed and the others free.
    Free(&'d Dynamics),
}

/// A study, begun: what it prescribes, and places that only assembly knows.
#[derive(Debug)]
pub(crate) struct Course<'d> {
    design: &'d Design,
    pub(crate) actuation: Actuation,
    pub(crate) rows: usize,
    pub(crate) assembled: Assembled,
    path: Path<'d>,
    holds: &'d [Hold],
    /// Motions that act, by their places in the design.
    pub(crate) acting: Vec<usize>,
    /// Where each held coordinate rests, and where each one that a motion moves begins.
    rests: Vec<f64>,
    begins: Vec<(Coordinate, f64)>,
}

impl<'d> Course<'d> {
    /// Assembles the machine where the study begins; `motions` are those that act.
    ///
    /// # Errors
    /// When it cannot be assembled.
    pub(crate) fn begin(
        machine: &mut Assembly<'_, 'd>,
        path: Path<'d>,
        holds: &'d [Hold],
        acting: &[usize],
    ) -> Result<Course<'d>, MechanismError> {
        let held = machine.held(holds);
        let assembled = match path {
            Path::Motion(Over::Time { .. }) | Path::Free(_) => assemble_in_time(machine, &held, acting)?,
            _ => assemble_at_rest(machine, path.sweep(), &held, acting)?,
        };
        let rest = |hold: &Hold| {
            let place = held.iter().find(|(coordinate, _)| *coordinate == hold.coordinate);
            place.map_or_else(|| machine.place(hold.coordinate), |(_, place)| *place)
        };
        let rests = holds.iter().map(rest).collect();
        let design = machine.design;
        let moved = moved(acting.iter().filter_map(|&motion| design.motions.get(motion)));
        let begins = moved.iter().map(|&c| (c, machine.place(c))).collect();
        let actuation = actuation(path, holds, &moved);
        let rows = path.rows(machine.values);
        Ok(Course { design, actuation, rows, assembled, path, holds, acting: acting.to_vec(), rests, begins })
    }

    /// The study's laws with these numbers.
    pub(crate) fn laws<T: Scalar>(&self, values: &Values<T>, blueprint: &Blueprint<T>) -> Laws<'d, T> {
        let rest = |(hold, place): (&Hold, &f64)| match &hold.at {
            Some(at) => at.eval(values),
            None => start(blueprint, hold.coordinate).unwrap_or(T::from_f64(*place)),
        };
        let rests: Vec<T> = self.holds.iter().zip(&self.rests).map(rest).collect();
        let rate = |quantity: &Option<crate::design::Quantity>| {
            quantity.as_ref().map_or(T::zero(), |quantity| quantity.eval(values))
        };
        let schedule = Schedule::new(self.design, values);
        let from = |c| self.begin_of(c, blueprint);
        let programme = Programme::new(self.design, &self.acting, &schedule, values, &from);
        let swept = |sweep: &Sweep| Swept { from: sweep.from.eval(values), to: sweep.to.eval(values) };
        match self.path {
            Path::Motion(Over::Positions { sweep, velocity, acceleration, .. }) => Laws::Positions {
                swept: Some(swept(sweep)),
                velocity: rate(velocity),
                acceleration: rate(acceleration),
                last: self.rows.saturating_sub(1),
                rests,
            },
            Path::Rest(sweep) => {
                let mut all: Vec<T> = programme.tracks.iter().map(|track| track.at(T::zero()).value).collect();
                all.extend(rests);
                let last = self.rows.saturating_sub(1);
                let (velocity, acceleration) = (T::zero(), T::zero());
                Laws::Positions { swept: sweep.map(swept), velocity, acceleration, last, rests: all }
            }
            Path::Motion(Over::Time { duration, step, .. }) => {
                let (duration, step) = (duration.eval(values), step.eval(values));
                Laws::Time { programme, duration, step, last: self.rows - 1, rests }
            }
            Path::Free(of) => {
                let duration: T = of.duration.eval(values);
                let step = output_step(of, values);
                Laws::Time { programme, duration, step, last: self.rows - 1, rests }
            }
        }
    }

    /// A coordinate begins at the start of the file where assembly met it, and follows its parameters then.
    fn begin_of<T: Scalar>(&self, c: Coordinate, blueprint: &Blueprint<T>) -> T {
        let assembled = self.begins.iter().find(|(of, _)| *of == c).map_or(0.0, |(_, place)| *place);
        let met = |start: &T| (start.value() - assembled).abs() <= 1e-9 * assembled.abs().max(1.0);
        let start = start(blueprint, c).filter(met);
        start.map_or(T::from_f64(assembled), |start| start.with_value(assembled))
    }
}

/// Assembles where motions begin: those that say where they are are met, the others start from the file's start.
fn assemble_in_time(
    machine: &mut Assembly<'_, '_>,
    held: &[(Coordinate, f64)],
    acting: &[usize],
) -> Result<Assembled, MechanismError> {
    let mut needed = held.to_vec();
    let mut wished = Vec::new();
    for track in machine.programme(acting).tracks {
        let c = track.coordinate;
        match track.turns.first().map(|turn| &turn.running) {
            Some(Running::Expression { .. } | Running::Table(_)) => needed.push((c, track.at(0.0).value)),
            _ => wished.extend(machine.start(c).map(|start| (c, start))),
        }
    }
    machine.assemble(&needed, &wished)
}

/// Assembles with all that is held where it rests.
fn assemble_at_rest(
    machine: &mut Assembly<'_, '_>,
    sweep: Option<&Sweep>,
    held: &[(Coordinate, f64)],
    acting: &[usize],
) -> Result<Assembled, MechanismError> {
    let mut needed = held.to_vec();
    needed.extend(machine.programme(acting).tracks.iter().map(|track| (track.coordinate, track.at(0.0).value)));
    // A start of the swept coordinate selects the branch where the file says it; the sweep walks from there.
    let at = |sweep: &Sweep| machine.start(sweep.coordinate).unwrap_or_else(|| sweep.from.eval(machine.values));
    let swept = sweep.map(|sweep| (sweep.coordinate, at(sweep)));
    machine.assemble(&needed, swept.as_slice())
}

fn actuation(path: Path<'_>, holds: &[Hold], moved: &[Coordinate]) -> Actuation {
    let with_held = |first: &[Coordinate]| -> Vec<Coordinate> {
        first.iter().copied().chain(holds.iter().map(|hold| hold.coordinate)).collect()
    };
    match path {
        Path::Motion(Over::Positions { sweep, drive, .. }) => {
            let rate = with_held(&[*drive]);
            Actuation { position: with_held(&[sweep.coordinate]), effort: rate.clone(), rate }
        }
        Path::Motion(Over::Time { drives, .. }) => {
            let position = with_held(moved);
            // Held coordinates rest by an effort of their own, whatever else drives the machine.
            let effort = drives.as_ref().map_or_else(|| position.clone(), |drives| with_held(drives));
            Actuation { rate: position.clone(), position, effort }
        }
        Path::Free(_) => {
            let list = with_held(moved);
            Actuation { position: list.clone(), rate: list.clone(), effort: list }
        }
        Path::Rest(sweep) => {
            let first: Vec<Coordinate> =
                sweep.map(|sweep| sweep.coordinate).into_iter().chain(moved.iter().copied()).collect();
            let list = with_held(&first);
            Actuation { position: list.clone(), rate: list.clone(), effort: list }
        }
    }
}

impl<'d> Path<'d> {
    fn sweep(self) -> Option<&'d Sweep> {
        match self {
            Path::Motion(Over::Positions { sweep, .. }) => Some(sweep),
            Path::Rest(sweep) => sweep,
            Path::Motion(Over::Time { .. }) | Path::Free(_) => None,
        }
    }

    fn rows(self, values: &Values) -> usize {
        match self {
            Path::Motion(Over::Time { duration, step, .. }) => steps(duration.eval(values), step.eval(values)) + 1,
            Path::Free(of) => steps(of.duration.eval(values), output_step(of, values)) + 1,
            _ => self.sweep().map_or(1, |sweep| sweep.points),
        }
    }
}

/// From row to row of a study of dynamics.
fn output_step<T: Scalar>(of: &Dynamics, values: &Values<T>) -> T {
    match &of.output_step {
        Some(step) => step.eval(values),
        None => of.duration.eval::<T>(values) / T::from_f64(ROWS as f64),
    }
}

/// Steps over a time, the last one perhaps shorter; one that fits but for rounding does not leave a sliver at the end.
fn steps(duration: f64, step: f64) -> usize {
    (duration / step - 1e-9).ceil().max(1.0) as usize
}

/// The ends of a sweep.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Swept<T> {
    from: T,
    to: T,
}

/// What is prescribed, with numbers.
#[derive(Debug)]
pub(crate) enum Laws<'d, T: Scalar = f64> {
    Positions { swept: Option<Swept<T>>, velocity: T, acceleration: T, last: usize, rests: Vec<T> },
    Time { programme: Programme<'d, T>, duration: T, step: T, last: usize, rests: Vec<T> },
}

/// Prescribed numbers in the order of the actuation.
#[derive(Clone, Debug, Default)]
pub(crate) struct Targets<T = f64> {
    pub(crate) time: T,
    pub(crate) position: Vec<T>,
    pub(crate) velocity: Vec<T>,
    pub(crate) acceleration: Vec<T>,
}

impl<'d, T: Scalar> Laws<'d, T> {
    /// The place on the axis at row `row`, which need not be whole: between rows lies what is between them. Both ends
    /// are exact.
    pub(crate) fn axis(&self, row: T) -> T {
        match self {
            Laws::Positions { swept: None, .. } => T::zero(),
            Laws::Positions { swept: Some(Swept { from, to }), last, .. } => {
                let share = row / T::from_f64((*last).max(1) as f64);
                *from * (T::one() - share) + *to * share
            }
            Laws::Time { duration, step, last, .. } => {
                let before = last.saturating_sub(1) as f64;
                if row.value() <= before {
                    return row * *step;
                }
                // The last step may be shorter.
                let share = row - T::from_f64(before);
                T::from_f64(before) * *step * (T::one() - share) + *duration * share
            }
        }
    }

    /// The row (not whole) of a place on the axis.
    pub(crate) fn row_of(&self, place: f64) -> f64 {
        match self {
            Laws::Positions { swept: None, .. } => 0.0,
            Laws::Positions { swept: Some(Swept { from, to }), last, .. } => {
                let (from, to) = (from.value(), to.value());
                if from == to { 0.0 } else { (place - from) / (to - from) * *last as f64 }
            }
            Laws::Time { duration, step, last, .. } => {
                let before = last.saturating_sub(1) as f64;
                let begins = before * step.value();
                if place <= begins {
                    place / step.value()
                } else {
                    before + (place - begins) / (duration.value() - begins)
                }
            }
        }
    }

    /// What moves when; `None` over positions.
    pub(crate) fn programme(&self) -> Option<&Programme<'d, T>> {
        match self {
            Laws::Positions { .. } => None,
            Laws::Time { programme, .. } => Some(programme),
        }
    }

    /// Times, s, in order, at which what is prescribed is not smooth: see [`Programme::breaks`].
    pub(crate) fn breaks(&self) -> Vec<f64> {
        self.programme().map_or_else(Vec::new, Programme::breaks)
    }

    /// What is prescribed at a place of the axis.
    pub(crate) fn prescribe(&self, place: T, targets: &mut Targets<T>) {
        let Targets { time, position, velocity, acceleration } = targets;
        [&mut *position, &mut *velocity, &mut *acceleration].into_iter().for_each(Vec::clear);
        let rests = match self {
            Laws::Positions { swept, velocity: v, acceleration: a, rests, .. } => {
                *time = T::zero();
                if swept.is_some() {
                    position.push(place);
                    velocity.push(*v);
                    acceleration.push(*a);
                }
                rests
            }
            Laws::Time { programme, rests, .. } => {
                *time = place;
                for track in &programme.tracks {
                    let jet = track.at(place);
                    position.push(jet.value);
                    velocity.push(jet.first);
                    acceleration.push(jet.second);
                }
                rests
            }
        };
        position.extend_from_slice(rests);
        velocity.resize(position.len(), T::zero());
        acceleration.resize(position.len(), T::zero());
    }
}
