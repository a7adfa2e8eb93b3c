//! `start` and `delay` of motions: what they wait for.

use bellcrank_doc::{Diagnostic, Dimension, Span, Spanned, Value};

use super::PartReader;
use super::motions::ReadMotions;
use crate::design::{Law, Mark, Origin, Prescribed, Start};
use crate::keyed::Keyed;
use crate::names::Index;

const SEVERAL: &str = "a time, `start = \"2 s\"`, or `start = \"after NAME\"` or `\"with NAME\"` of a motion";

/// A motion that waits for something whose name is not yet looked up.
pub(super) struct Waiting<'a> {
    /// Its place in the list; `None` of one that is wrong otherwise.
    motion: Option<usize>,
    part: PartReader<'a>,
    edge: Edge,
    name: Spanned<&'a str>,
}

/// Which end of what it waits for.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Edge {
    After,
    With,
}

/// `start` and `delay` of the motion at place `motion`, and what it waits for if that has a name. Without them its
/// place in the file is `span`.
pub(super) fn read<'a>(
    part: PartReader<'a>,
    keyed: &Keyed<'a>,
    motion: usize,
    span: Span,
) -> (Start, Option<Waiting<'a>>) {
    let delay = keyed.quantity("delay").map(|delay| part.quantity(delay));
    let value = keyed.value("start");
    let span = value.or_else(|| keyed.value("delay")).map_or(span, |value| value.span);
    let start = |origin| Start { span, origin, delay };
    let Some(value) = value else { return (start(Origin::Zero), None) };
    if let Some((edge, name)) = named(value) {
        return (start(Origin::Unknown), Some(Waiting { motion: Some(motion), part, edge, name }));
    }
    if let Some(word) = wrong_word(value) {
        let message = format!("{} begins with `{word}`", keyed.named("start"));
        part.reader.report(Diagnostic::error("motion-start", value.span, message).hint(format!("it is {SEVERAL}")));
        return (start(Origin::Unknown), None);
    }
    let time = part.reader.quantity(value, &keyed.named("start"), Dimension::TIME);
    (start(time.map_or(Origin::Unknown, |time| Origin::Time(part.quantity(time)))), None)
}

/// `after NAME` or `with NAME`.
fn named(value: &Value) -> Option<(Edge, Spanned<&str>)> {
    let text = value.as_str()?;
    let (word, name) = words(text)?;
    let edge = match word {
        "after" => Edge::After,
        "with" => Edge::With,
        _ => return None,
    };
    Some((edge, Spanned { value: name, span: within(value.span, text, name) }))
}

/// The first of two words in a row that is none of those.
fn wrong_word(value: &Value) -> Option<&str> {
    words(value.as_str()?).map(|(word, _)| word)
}

/// A word and the name after it: no expression begins like that.
fn words(text: &str) -> Option<(&str, &str)> {
    let begins = |word: &str| word.starts_with(|c: char| c.is_alphabetic() || c == '_');
    let (word, name) = text.trim().split_once(char::is_whitespace)?;
    let is_word = begins(word) && word.chars().all(|c| c.is_alphanumeric() || c == '_');
    let name = name.trim_start();
    (is_word && begins(name)).then_some((word, name))
}

/// The place of a part of a text, when the text stands in the file as it is.
fn within(span: Span, text: &str, part: &str) -> Span {
    let offset = part.as_ptr() as usize - text.as_ptr() as usize;
    match span.end - span.start == text.len() + 2 {
        true => Span::new(span.source, span.start + 1 + offset, span.start + 1 + offset + part.len()),
        false => span,
    }
}

/// Looks up what motions wait for; an order in which each comes after that. What cannot be is reported.
pub(super) fn resolve(waiting: &[Waiting<'_>], read: &mut ReadMotions) -> Vec<usize> {
    let marks = marks(&read.list);
    for one in waiting {
        if let (Some(mark), Some(motion)) = (one.mark(read, &marks), one.motion) {
            let origin = if one.edge == Edge::After { Origin::After(mark) } else { Origin::With(mark) };
            read.list[motion].start.origin = origin;
        }
    }
    let (order, circles) = order(&read.list);
    for circle in circles {
        report_circle(waiting, &read.list, &circle);
        circle.into_iter().for_each(|motion| read.list[motion].start.origin = Origin::Unknown);
    }
    order
}

/// Names of motions and of their segments, for hints.
fn marks(motions: &[Prescribed]) -> Index {
    let mut marks = Index::default();
    for (place, motion) in motions.iter().enumerate() {
        marks.insert(&motion.name, place);
        let segments = if let Law::Segments(segments) = &motion.law { segments.as_slice() } else { &[] };
        for name in segments.iter().filter_map(|segment| segment.name.as_ref()) {
            marks.insert(&format!("{}.{name}", motion.name), place);
        }
    }
    marks
}

impl Waiting<'_> {
    /// The same of a motion that made it into the list, or did not.
    pub(super) fn of(self, listed: bool) -> Self {
        Waiting { motion: self.motion.filter(|_| listed), ..self }
    }

    fn mark(&self, read: &ReadMotions, marks: &Index) -> Option<Mark> {
        let full = self.part.full(self.name.value);
        let motion = read.names.get(&full).map(|motion| Mark { motion, segment: None });
        let segment = full.rsplit_once('.').and_then(|(motion, name)| {
            let motion = read.names.get(motion)?;
            let Law::Segments(segments) = &read.list[motion].law else { return None };
            let segment = segments.iter().position(|segment| segment.name.as_deref() == Some(name))?;
            Some(Mark { motion, segment: Some(segment) })
        });
        match (motion, segment) {
            (Some(motion), Some(segment)) => self.report(ambiguous(self.name, read, motion, segment)),
            (Some(mark), None) | (None, Some(mark)) => self.checked(read, mark),
            (None, None) => {
                let of = full.rsplit_once('.').map_or(full.as_str(), |(motion, _)| motion);
                // What is wrong with that motion has been told.
                match read.names.get(of).filter(|_| of != full) {
                    _ if read.faulty.get(&full).or_else(|| read.faulty.get(of)).is_some() => None,
                    Some(motion) => self.report(self.no_segment(&read.list[motion], &full, marks)),
                    None => self.report(marks.unknown(&full, self.part.prefix(), "motion or segment", self.name.span)),
                }
            }
        }
    }

    fn report(&self, report: Diagnostic) -> Option<Mark> {
        self.part.reader.report(report);
        None
    }

    fn no_segment(&self, of: &Prescribed, full: &str, marks: &Index) -> Diagnostic {
        let local = full.rsplit('.').next().unwrap_or(full);
        let message = format!("motion `{}` has no segment of the name `{local}`", of.name);
        let report = Diagnostic::error("unknown-name", self.name.span, message).also(of.span, "this motion");
        let prefix = self.part.prefix();
        match marks.nearest(full).filter(|near| near.starts_with(&format!("{}.", of.name))) {
            Some(near) => report.hint(format!("did you mean `{}`?", near.strip_prefix(prefix).unwrap_or(near))),
            None => report.hint(format!("give one a name: `{{ ..., name = \"{local}\" }}`")),
        }
    }

    /// Only what ends can be waited for to its end.
    fn checked(&self, read: &ReadMotions, mark: Mark) -> Option<Mark> {
        let of = &read.list[mark.motion];
        if self.edge == Edge::With || of.law.ends() {
            return Some(mark);
        }
        let law = if matches!(of.law, Law::Velocity(_)) { "velocity" } else { "expression" };
        let message = format!("motion `{}` never ends: it is one of `{law}`, and nothing can come after it", of.name);
        let report = Diagnostic::error("motion-start", self.name.span, message).also(of.span, "this motion");
        self.report(
            report.hint(format!("count from its beginning: `start = \"with {}\"` and a `delay`", self.name.value)),
        )
    }
}

fn ambiguous(name: Spanned<&str>, read: &ReadMotions, motion: Mark, segment: Mark) -> Diagnostic {
    let (whole, of) = (&read.list[motion.motion], &read.list[segment.motion]);
    let local = name.value.rsplit('.').next().unwrap_or(name.value);
    let message =
        format!("`{}` is a motion of a subsystem, and also the segment `{local}` of motion `{}`", name.value, of.name);
    let part = match (&of.law, segment.segment) {
        (Law::Segments(segments), Some(place)) => segments[place].span,
        _ => of.span,
    };
    let report = Diagnostic::error("ambiguous-name", name.span, message);
    report.also(whole.span, "this motion").also(part, "this segment").hint("give the segment another name")
}

/// An order in which each motion comes after the one it waits for, and the circles, each in the order of waiting.
fn order(motions: &[Prescribed]) -> (Vec<usize>, Vec<Vec<usize>>) {
    let mut order = Vec::with_capacity(motions.len());
    let mut circles = Vec::new();
    // The walk that a motion was met on; each waits for one at most, so that a walk meets itself in a circle only.
    let mut met = vec![usize::MAX; motions.len()];
    for first in 0..motions.len() {
        let (mut walk, mut next) = (Vec::new(), Some(first));
        while let Some(motion) = next.filter(|&motion| met[motion] == usize::MAX) {
            met[motion] = first;
            walk.push(motion);
            next = motions[motion].start.mark().map(|mark| mark.motion);
        }
        let circle = next.filter(|&back| met[back] == first).and_then(|back| walk.iter().position(|&m| m == back));
        if let Some(begins) = circle {
            circles.push(walk.split_off(begins));
        }
        order.extend(walk.into_iter().rev());
    }
    (order, circles)
}

fn report_circle(waiting: &[Waiting<'_>], motions: &[Prescribed], circle: &[usize]) {
    let at = |motion: usize| waiting.iter().find(|one| one.motion == Some(motion));
    let Some(first) = circle.first().and_then(|&motion| at(motion)) else { return };
    let names: Vec<&str> = circle.iter().chain(circle.first()).map(|&motion| motions[motion].name.as_str()).collect();
    let message = match circle {
        [one] => format!("motion `{}` waits for itself", motions[*one].name),
        _ => format!("motions wait for each other: {}", names.join(" -> ")),
    };
    let mut report = Diagnostic::error("motion-cycle", first.name.span, message);
    for pair in circle.windows(2) {
        if let Some(one) = at(pair[1]) {
            report = report.also(one.name.span, format!("`{}` waits for this", motions[pair[1]].name));
        }
    }
    first.part.reader.report(report.hint(format!("let one of them have a time of its own: {SEVERAL}")));
}
