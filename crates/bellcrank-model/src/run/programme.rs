//! What the motions of a study move when, to be read.

use bellcrank_results::{Move, Programme};

use super::Namer;
use super::course::Path;
use super::session::Session;
use crate::design::{Design, Law, Over, Study, Task};
use crate::measure::Measure;
use crate::motion::{Programme as Prescribed, Running, Stretch, Track, Turn};

/// The programme of a study over time, which is assembled for it; `None` of another one, of one without motions and
/// of one that cannot be assembled.
pub(crate) fn programme(design: &Design, study: &Study) -> Option<Programme> {
    let path = match &study.task {
        Task::Motion { over: over @ Over::Time { .. }, .. } => Path::Motion(over),
        Task::Dynamics(of) => Path::Free(of),
        _ => return None,
    };
    let (motions, holds) = study.task.prescribed();
    let mut session = Session::new(design, study, false).ok()?;
    let course = session.begin(path, holds, motions).ok()?;
    session.laws(&course).programme().and_then(|programme| moves(design, programme))
}

/// The moves in the order of time; `None` when there are none.
pub(super) fn moves(design: &Design, programme: &Prescribed<'_>) -> Option<Programme> {
    let turns = programme.tracks.iter().flat_map(|track| track.turns.iter().map(move |turn| (track, turn)));
    let mut moves: Vec<Move> = turns.flat_map(|(track, turn)| moves_of(design, track, turn)).collect();
    // Of one instant in the order of the tracks.
    moves.sort_by(|a, b| a.start.total_cmp(&b.start));
    (!moves.is_empty()).then(|| Programme { time: design.units.of(Measure::Time), moves })
}

fn moves_of(design: &Design, track: &Track<'_, f64>, turn: &Turn<'_, f64>) -> Vec<Move> {
    let namer = Namer::new(design);
    let motion = &design.motions[turn.motion];
    let one = |profile| Move {
        motion: motion.name.clone(),
        joint: namer.coordinate(track.coordinate),
        segment: None,
        profile,
        start: turn.begins,
        end: turn.ends,
        from: turn.running.at(0.0).value,
        to: turn.running.end(),
        unit: namer.unit(track.coordinate),
    };
    match (&turn.running, &motion.law) {
        (Running::Segments(stretches), Law::Segments(segments)) => {
            let several = stretches.len() > 1;
            let of = |(place, stretch): (usize, &Stretch<f64>)| {
                let number = several.then(|| (place + 1).to_string());
                let start = turn.begins + stretch.begins;
                let end = Some(start + stretch.lasts);
                let (from, to) = (stretch.from, Some(stretch.to));
                let segment = segments.get(place).and_then(|segment| segment.name.clone()).or(number);
                Move { segment, start, end, from, to, ..one(stretch.profile().unwrap_or("hold")) }
            };
            stretches.iter().enumerate().map(of).collect()
        }
        (Running::Table(_), _) => vec![one("table")],
        (Running::Velocity { .. }, _) => vec![one("velocity")],
        _ => vec![one("expression")],
    }
}
