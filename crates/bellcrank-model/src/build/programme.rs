//! Motions of a study that cannot act together with their numbers.

use bellcrank_doc::{Diagnostic, Span};
use bellcrank_multibody::Coordinate;

use crate::design::{Design, Prescribed, Values};
use crate::measure::Measure;
use crate::motion::{EPS, Jet, Programme, Running, Schedule, Track, Turn};
use crate::run::{Namer, shown};

/// What is wrong with the times of motions that act together.
pub(crate) fn programme_faults(design: &Design, values: &Values, acting: &[usize]) -> Vec<Diagnostic> {
    let known: Vec<usize> = acting.iter().copied().filter(|&motion| motion < design.motions.len()).collect();
    let schedule = Schedule::new(design, values);
    // Times that are not known have been told.
    let (timed, mut faults): (Vec<usize>, Vec<Diagnostic>) = (timed(&schedule, &known), Vec::new());
    faults.extend(timed.iter().filter_map(|&motion| early(design, &schedule, motion)));
    if !faults.is_empty() {
        return faults;
    }
    let start = |c: Coordinate| design.joints.get(c.joint.0).and_then(|joint| joint.start.get(c.index)?.as_ref());
    let from = |c| start(c).map_or(f64::NAN, |start| start.eval(values));
    let programme = Programme::new(design, &timed, &schedule, values, &from);
    for track in &programme.tracks {
        for pair in track.turns.windows(2) {
            faults.extend(overlap(design, track, pair).or_else(|| jump(design, track, pair)));
        }
    }
    faults
}

/// A motion that waits for one that does not act in a study, which is called `study` and stands at `span`.
pub(super) fn left_out(design: &Design, acting: &[usize], study: &str, span: Span) -> Vec<Diagnostic> {
    let fault = |motion: &Prescribed| {
        let of = motion.start.mark().filter(|mark| !acting.contains(&mark.motion))?;
        let of = design.motions.get(of.motion)?;
        let message =
            format!("study `{study}` leaves out motion `{}`, which motion `{}` waits for", of.name, motion.name);
        let report = Diagnostic::error("motion-left-out", span, message).also(motion.start.span, "waits here");
        Some(report.hint(format!("add `{}` to the `motions` of the study", of.name)))
    };
    acting.iter().filter_map(|&motion| design.motions.get(motion)).filter_map(fault).collect()
}

fn timed(schedule: &Schedule<f64>, acting: &[usize]) -> Vec<usize> {
    acting.iter().copied().filter(|&motion| schedule.begin(motion).is_some_and(f64::is_finite)).collect()
}

fn early(design: &Design, schedule: &Schedule<f64>, motion: usize) -> Option<Diagnostic> {
    let begins = schedule.begin(motion).filter(|begins| *begins < -EPS)?;
    let motion = &design.motions[motion];
    let begins = shown(begins, &design.units.of(Measure::Time));
    let message = format!("motion `{}` begins at {begins}: a study over time begins at 0", motion.name);
    Some(Diagnostic::error("motion-start", motion.start.span, message))
}

/// The later of two motions of a coordinate that begins before the earlier one ends.
fn overlap(design: &Design, track: &Track<'_, f64>, pair: &[Turn<'_, f64>]) -> Option<Diagnostic> {
    let [first, next] = pair else { return None };
    let slack = EPS * next.begins.abs().max(1.0);
    if first.ends.is_some_and(|ends| next.begins >= ends - slack) {
        return None;
    }
    let namer = Namer::new(design);
    let time = |time| shown(time, &design.units.of(Measure::Time));
    let [a, b] = [first, next].map(|turn| &design.motions[turn.motion]);
    let ends = first.ends.map_or("never ends".to_owned(), |ends| format!("ends at {}", time(ends)));
    let message = format!(
        "motions `{}` and `{}` move joint `{}` at once: the first begins at {} and {ends}, the second begins at {}",
        a.name,
        b.name,
        namer.coordinate(track.coordinate),
        time(first.begins),
        time(next.begins),
    );
    let report = Diagnostic::error("motion-overlap", b.start.span, message).also(a.span, "the first");
    Some(match first.ends {
        Some(_) => report.hint(format!(
            "let one follow the other, `start = \"after {}\"`, or name those that act in `motions` of the study",
            a.name
        )),
        None => report.hint("name those that act in `motions` of the study"),
    })
}

/// A motion that says where it is, and is not where the one before left the coordinate.
fn jump(design: &Design, track: &Track<'_, f64>, pair: &[Turn<'_, f64>]) -> Option<Diagnostic> {
    let [first, next] = pair else { return None };
    let (Running::Expression { .. } | Running::Table(_)) = &next.running else { return None };
    let left = first.running.end()?;
    let Jet { value: begins, .. } = next.running.at(0.0);
    // A start that only assembly knows makes no number here.
    if (left - begins).abs() <= 1e-6 * left.abs().max(begins.abs()).max(1e-3) || !(left - begins).is_finite() {
        return None;
    }
    let namer = Namer::new(design);
    let place = |value| namer.place(track.coordinate, value);
    let [a, b] = [first, next].map(|turn| &design.motions[turn.motion]);
    let message = format!(
        "motion `{}` begins at {}, motion `{}` before it leaves joint `{}` at {}",
        b.name,
        place(begins),
        a.name,
        namer.coordinate(track.coordinate),
        place(left),
    );
    Some(Diagnostic::error("motion-jump", b.span, message).also(a.span, "the one before"))
}
