//! Failures of the mathematics in names and units of the file.

use bellcrank_multibody::{Coordinate, JointId, MechanismError, System};
use bellcrank_results::{Failure, Unit};

use super::End;
use crate::design::{Design, JointShape, Over, Study, Task};
use crate::measure::{Measure, Motion};

/// Names of coordinates, and their places in display units.
#[derive(Clone, Copy)]
pub(crate) struct Namer<'d> {
    design: &'d Design,
}

impl<'d> Namer<'d> {
    pub(crate) fn new(design: &'d Design) -> Namer<'d> {
        Namer { design }
    }

    pub(crate) fn joint(&self, id: JointId) -> &'d str {
        self.design.joints.get(id.0).map_or("the shape of a flexible body", |joint| joint.name.as_str())
    }

    fn motions(&self, c: Coordinate) -> &'static [Motion] {
        self.design.joints.get(c.joint.0).map_or(&[], |joint| joint.coordinates(self.design.planar))
    }

    fn motion(&self, c: Coordinate) -> Motion {
        self.motions(c).get(c.index).copied().unwrap_or(Motion::Slide)
    }

    /// Belongs to a joint that turns any way.
    fn is_ball(&self, c: Coordinate) -> bool {
        self.design.joints.get(c.joint.0).is_some_and(|joint| matches!(joint.shape, JointShape::Spherical))
    }

    /// `slide`, or `J.1` for one of several.
    pub(crate) fn coordinate(&self, c: Coordinate) -> String {
        let name = self.joint(c.joint);
        if self.motions(c).len() > 1 { format!("{name}.{}", c.index) } else { name.to_owned() }
    }

    /// The signal of its position.
    pub(crate) fn signal(&self, c: Coordinate) -> String {
        let suffix = if self.motions(c).len() > 1 { format!(".{}", c.index) } else { String::new() };
        format!("joint.{}.position{suffix}", self.joint(c.joint))
    }

    /// Unit of its position.
    pub(crate) fn unit(&self, c: Coordinate) -> Unit {
        self.design.units.of(Measure::position(self.motion(c)))
    }

    /// A place of the coordinate, with unit.
    pub(crate) fn place(&self, c: Coordinate, value: f64) -> String {
        shown(value, &self.unit(c))
    }

    /// `time = 0.5 s`.
    pub(crate) fn time(&self, value: f64) -> String {
        format!("time = {}", shown(value, &self.design.units.of(Measure::Time)))
    }

    /// A velocity of the coordinate, with unit.
    fn rate(&self, c: Coordinate, value: f64) -> String {
        shown(value, &self.design.units.of(Measure::velocity(self.motion(c))))
    }

    fn effort(&self, c: Coordinate, value: f64) -> String {
        shown(value, &self.design.units.of(Measure::effort(self.motion(c))))
    }

    fn length(&self, value: f64) -> String {
        shown(value, &self.design.units.of(Measure::Length))
    }

    fn list(&self, coordinates: &[Coordinate]) -> String {
        enumerated(coordinates.iter().map(|&c| format!("`{}`", self.coordinate(c))).collect())
    }
}

/// A number with its unit, rounded for reading.
pub(crate) fn shown(value: f64, unit: &Unit) -> String {
    let rounded: f64 = format!("{:.5e}", unit.show(value)).parse().unwrap_or(f64::NAN);
    let rounded = rounded + 0.0;
    if unit.symbol.is_empty() { format!("{rounded}") } else { format!("{rounded} {}", unit.symbol) }
}

/// `a`, `a and b`, `a, b and c`; the rest is counted.
fn enumerated(mut all: Vec<String>) -> String {
    const SHOWN: usize = 6;
    if all.len() > SHOWN {
        let more = all.len() - SHOWN + 1;
        all.truncate(SHOWN - 1);
        all.push(format!("{more} more"));
    }
    match all.as_slice() {
        [] => "nothing".to_owned(),
        [one] => one.clone(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

/// A run that was stopped from outside.
pub(super) fn cancelled(rows: usize) -> End {
    Box::new(Failure { message: format!("stopped on request after {rows} rows"), hints: Vec::new() })
}

/// Which study, where, which joints; and what to try.
pub(crate) fn failure(namer: &Namer<'_>, error: &MechanismError, who: &str, place: &str) -> Failure {
    let (message, hints) = explain(namer, error);
    let at = if place.is_empty() { String::new() } else { format!(", {place}") };
    Failure { message: format!("{who}{at}: {message}"), hints }
}

/// A row whose rates or forces are not determined.
pub(super) fn row(namer: &Namer<'_>, error: &MechanismError, what: &str) -> String {
    let (message, _) = explain(namer, error);
    format!("{what} are not determined: {message}")
}

fn explain(namer: &Namer<'_>, error: &MechanismError) -> (String, Vec<String>) {
    match error {
        MechanismError::NotAssembled { gap, open } => not_assembled(namer, *gap, open),
        MechanismError::UnderDriven { freedom, driven, free } => under_driven(namer, *freedom, *driven, free),
        MechanismError::OverDriven { freedom, driven, conflicting } => {
            over_driven(namer, *freedom, *driven, conflicting)
        }
        MechanismError::DrivenTwice(c) => (
            format!("`{}` is prescribed twice", namer.coordinate(*c)),
            vec!["a coordinate has one motion, or one `hold`, or is the swept one".to_owned()],
        ),
        MechanismError::AttitudeAlone(c) => (
            format!(
                "`{}` is one of the angles of free turning, which cannot be prescribed alone",
                namer.coordinate(*c)
            ),
            vec!["give a motion or `hold` for all angles of that joint, or use hinges in a row".to_owned()],
        ),
        MechanismError::Stopped { coordinate, reached, asked, mobile, .. } => {
            stopped(namer, *coordinate, *reached, *asked, mobile)
        }
        MechanismError::Singular { system, mobile, .. } => singular(namer, *system, mobile),
        MechanismError::Jammed { joint, change } => (
            format!(
                "the friction in `{}` does not settle (it still changes by {:.1} %): the joint jams",
                namer.joint(*joint),
                change * 100.0
            ),
            vec!["drive it elsewhere, or lower the friction coefficient".to_owned()],
        ),
        MechanismError::NoEquilibrium { residual, coordinate } => (
            format!(
                "no equilibrium was found: {} along `{}` stay unbalanced",
                namer.effort(*coordinate, *residual),
                namer.coordinate(*coordinate)
            ),
            vec!["give other starts, add a spring or stop, or `hold` more coordinates".to_owned()],
        ),
        MechanismError::NoMass { mobile } => (
            format!("no mass moves with {}: their accelerations are not determined", namer.list(mobile)),
            vec!["give the bodies that move there a mass and an inertia, or drive or hold the joint".to_owned()],
        ),
        MechanismError::VelocityConflict { conflicting } => {
            let one = |(c, asked, near): &(Coordinate, f64, f64)| {
                let (asked, near) = (namer.rate(*c, *asked), namer.rate(*c, *near));
                format!("`{}` (asked {asked}, possible {near})", namer.coordinate(*c))
            };
            let message = format!(
                "the velocities at the start do not fit the joints: {}",
                enumerated(conflicting.iter().map(one).collect())
            );
            (message, vec!["give `start_velocity` to as many coordinates as there are degrees of freedom".to_owned()])
        }
        MechanismError::StepCollapse { time, step, coordinate } => (
            format!(
                "the steps became too small ({:.1e} s) at {}: `{}` changes without bound",
                step,
                namer.time(*time),
                namer.coordinate(*coordinate)
            ),
            vec![
                "look for a motion that the machine cannot follow, a force that grows without bound, or a joint that jams"
                    .to_owned(),
            ],
        ),
        MechanismError::Blocked { force, time } => {
            let name = namer.design.forces.get(force.0).map_or("?", |force| force.name.as_str());
            let message = format!("at {} the stop `{name}` stands in the way", namer.time(*time));
            (message, vec!["let the motion or the start end before the stop, or give the stop a stiffness".to_owned()])
        }
        MechanismError::EventStorm { time, forces } => {
            let names = forces.iter().filter_map(|f| namer.design.forces.get(f.0));
            let names = enumerated(names.map(|force| format!("`{}`", force.name)).collect());
            let message =
                format!("at {} events follow each other without time between them: {names}", namer.time(*time));
            (message, vec!["give the friction a `smoothing_velocity`, or the stop a stiffness".to_owned()])
        }
        MechanismError::NotSettled { part } => (
            format!(
                "the flexible bodies find no shape that carries their loads: after the last iteration they still move \
                 by {:.1e} of the machine's size",
                part
            ),
            vec![
                "they buckle, or bend beyond what the theory of small deformation knows: look at loads, materials and \
                 sections, or let go of the machine in a study of dynamics"
                    .to_owned(),
            ],
        ),
        MechanismError::BendsToClose { equations } => (
            format!(
                "the loops of rigid bodies cannot all close while flexible ones bend ({equations} of their shapes would \
                 have to fit): a sweep cannot bend them one by one"
            ),
            vec!["use a study of `statics` or `dynamics`, free a redundant joint, or say `flexible = false`".to_owned()],
        ),
        MechanismError::NotFinite(quantity) => (
            format!("{quantity} became infinite or undefined"),
            vec!["look for a division by zero in expressions of forces and motions".to_owned()],
        ),
    }
}

fn not_assembled(namer: &Namer<'_>, gap: f64, open: &[(JointId, f64, f64)]) -> (String, Vec<String>) {
    let joints = open.iter().map(|(joint, gap, turn)| {
        let mut parts = Vec::new();
        if *gap > 0.0 {
            parts.push(namer.length(*gap));
        }
        if *turn > 1e-9 {
            parts.push(shown(*turn, &namer.design.units.of(Measure::Angle)));
        }
        format!("`{}` ({})", namer.joint(*joint), parts.join(", "))
    });
    let open = enumerated(joints.collect());
    let message =
        format!("the mechanism cannot be assembled: a gap of {} stays, open joints {open}", namer.length(gap));
    let hints = vec![
        "check the lengths: can the loop be closed at all?".to_owned(),
        "give `start` values near the position you mean".to_owned(),
    ];
    (message, hints)
}

fn degrees(count: usize) -> String {
    if count == 1 { "1 degree of freedom".to_owned() } else { format!("{count} degrees of freedom") }
}

fn under_driven(namer: &Namer<'_>, freedom: usize, driven: usize, free: &[Coordinate]) -> (String, Vec<String>) {
    let loose = crate::build::loose_bodies(namer.design);
    if free.is_empty() && !loose.is_empty() {
        let names = enumerated(loose.iter().map(|body| format!("`{}`", body.name)).collect());
        let message = format!("{}, {driven} driven: no joint holds {names}", degrees(freedom));
        return (message, vec!["connect it to the machine by a joint, or take it out".to_owned()]);
    }
    let message = format!("{}, {driven} driven: {} can still move", degrees(freedom), namer.list(free));
    let mut hints = vec!["add a drive, a motion or `hold`".to_owned()];
    if free.iter().any(|c| namer.is_ball(*c)) {
        hints.push("a rod between two spherical joints can spin: make one of them `universal`".to_owned());
    }
    (message, hints)
}

fn over_driven(namer: &Namer<'_>, freedom: usize, driven: usize, conflicting: &[Coordinate]) -> (String, Vec<String>) {
    let message = format!("{}, {driven} driven: {} depend on each other", degrees(freedom), namer.list(conflicting));
    (message, vec!["leave one of them free: drop a drive, a motion or a `hold`".to_owned()])
}

fn stopped(
    namer: &Namer<'_>,
    coordinate: Coordinate,
    reached: f64,
    asked: f64,
    mobile: &[Coordinate],
) -> (String, Vec<String>) {
    let name = namer.coordinate(coordinate);
    let message = format!(
        "`{name}` cannot go on to {}: it stops at {}{}",
        namer.place(coordinate, asked),
        namer.place(coordinate, reached),
        turning_back(namer, coordinate, mobile)
    );
    let mut hints = vec![format!("end the sweep of `{name}` before {}", namer.place(coordinate, reached))];
    if let Some(other) = mobile.iter().find(|c| **c != coordinate) {
        hints.push(format!("sweep `{}` instead, which moves freely there", namer.coordinate(*other)));
    }
    (message, hints)
}

/// Which joints move while the swept one stands still.
fn turning_back(namer: &Namer<'_>, coordinate: Coordinate, mobile: &[Coordinate]) -> String {
    let others: Vec<Coordinate> = mobile.iter().copied().filter(|c| *c != coordinate).collect();
    match others.as_slice() {
        [] => String::new(),
        others => format!(", a limit of its motion, where {} move", namer.list(others)),
    }
}

fn singular(namer: &Namer<'_>, system: System, mobile: &[Coordinate]) -> (String, Vec<String>) {
    let list = namer.list(mobile);
    match system {
        System::Position => (
            format!("singular position: {list} can move while the prescribed coordinates rest"),
            vec!["start the sweep elsewhere, or sweep another joint".to_owned()],
        ),
        System::Drive => (
            format!("dead position of the drives: {list} can move while they rest"),
            vec!["put the drive on another joint".to_owned()],
        ),
    }
}

/// Places on the axis of a study in words.
#[derive(Clone, Copy)]
pub(crate) struct Places<'d> {
    namer: Namer<'d>,
    study: &'d Study,
}

impl<'d> Places<'d> {
    pub(crate) fn new(design: &'d Design, study: &'d Study) -> Places<'d> {
        Places { namer: Namer::new(design), study }
    }

    /// `joint.B.position = 12 deg`, `time = 0.5 s`.
    pub(crate) fn at(&self, place: f64) -> String {
        match self.study.axis() {
            Some(c) => format!("{} = {}", self.namer.signal(c), self.namer.place(c, place)),
            None => self.namer.time(place),
        }
    }

    /// The same for what happens between two rows; in time the later one says it.
    pub(crate) fn between(&self, before: f64, now: f64) -> String {
        match self.study.axis() {
            Some(c) => {
                let [a, b] = [before, now].map(|place| self.namer.place(c, place));
                format!("{} between {a} and {b}", self.namer.signal(c))
            }
            None => self.at(now),
        }
    }

    /// The drive of a sweep by name; in time there may be several.
    pub(crate) fn drives(&self) -> String {
        match &self.study.task {
            Task::Motion { over: Over::Positions { drive, .. }, .. } => format!("`{}`", self.namer.coordinate(*drive)),
            _ => "the drives".to_owned(),
        }
    }
}
