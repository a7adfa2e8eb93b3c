//! The summary that a run prints: what an engineer reads at a glance.

mod convergence;
mod events;
mod flexible;
mod grid;
mod kinds;
mod paint;

pub use convergence::terminal_convergence;

use bellcrank_results::{Reaction, RunResult, StudyResult};

use crate::findings::{self, Finding};
use crate::{number, told};
use grid::{Cell, Grid};
use paint::{Ink, clean, wrapped};

/// How the terminal is written to.
#[derive(Clone, Copy, Debug)]
pub struct Style {
    /// With ANSI colours. Meaning is never in colour alone.
    pub color: bool,
    /// Columns of the terminal: sentences are broken there; tables keep their width.
    pub width: usize,
}

impl Default for Style {
    fn default() -> Self {
        Self { color: false, width: 100 }
    }
}

/// Joints in the reaction table; the others are counted.
const MOST_JOINTS: usize = 12;

/// The run as text for a terminal, ending with a line break.
///
/// For each study: rows and axis, drive efforts and strokes with where their extremes occur, the
/// strongest reaction of each joint, residuals, warnings, failure. Control characters from the
/// model file are not passed on.
pub fn terminal_summary(run: &RunResult, style: &Style) -> String {
    let page = Page { style };
    let mut text = page.style.paint(Ink::Bold, &clean(&headline(run)));
    text.push('\n');
    for warning in &run.warnings {
        text.push_str(&page.note("warning", Ink::Yellow, warning));
    }
    for study in &run.studies {
        text.push('\n');
        text.push_str(&page.study(study));
    }
    text
}

fn headline(run: &RunResult) -> String {
    if run.title.is_empty() { run.model.clone() } else { format!("{}: {}", run.model, run.title) }
}

struct Page<'a> {
    style: &'a Style,
}

impl Page<'_> {
    fn study(&self, study: &StudyResult) -> String {
        let mut text = self.heading(study);
        if let Some(failure) = &study.failure {
            text.push_str(&self.note("stopped", Ink::Red, findings::why_stopped(study).unwrap_or(&failure.message)));
            for hint in &failure.hints {
                text.push_str(&self.note("  try", Ink::Plain, hint));
            }
        }
        let happened = study.events.iter().flat_map(told::events::sentences);
        let bends = study.flexible.iter().flat_map(told::flexible::sentences);
        for sentence in kinds::sentences(study).into_iter().chain(bends).chain(happened) {
            text.push_str(&self.line(&sentence));
        }
        if let Some(why) = told::unmet(study) {
            text.push_str(&self.note("goal not reached", Ink::Yellow, &why));
        }
        for table in kinds::tables(study) {
            text.push_str(&table.text(self.style));
        }
        for table in study.flexible.iter().flat_map(flexible::tables) {
            text.push_str(&table.text(self.style));
        }
        if let Some(happened) = &study.events {
            text.push_str(&events::table(happened).text(self.style));
        }
        for table in [drive_table(study), reaction_table(study), scalar_table(study)] {
            text.push_str(&table.text(self.style));
        }
        text.push_str(&self.checks(study));
        for warning in &study.warnings {
            text.push_str(&self.note("warning", Ink::Yellow, warning));
        }
        text
    }

    fn heading(&self, study: &StudyResult) -> String {
        let name = self.style.paint(Ink::Bold, &clean(&study.name));
        let rows = study.table.rows();
        let ranges: Vec<String> = findings::axis_ranges(study)
            .into_iter()
            .map(|(name, range)| format!(", {} {range}", clean(&name)))
            .collect();
        let (kind, took) = (clean(&study.kind), number::duration(study.seconds));
        if study.table.columns.is_empty() {
            return format!("{name}  {kind}, {took}\n");
        }
        let plural = if rows == 1 { "" } else { "s" };
        format!("{name}  {kind}, {rows} row{plural}{}, {took}\n", ranges.concat())
    }

    /// Residuals with a word on each: `closure 2.2e-16 m ok`.
    fn checks(&self, study: &StudyResult) -> String {
        let one = |check: &findings::Check<'_>| {
            let (ink, word) = if check.passed() { (Ink::Green, "ok") } else { (Ink::Red, "TOO LARGE") };
            let unit = &check.finding.column.unit;
            let peak = number::significant(unit.show(check.finding.peak()), 2);
            let peak = number::with_unit(&peak, &unit.symbol);
            format!("{} {peak} {}", check.title.to_lowercase(), self.style.paint(ink, word))
        };
        let all: Vec<String> = findings::checks(study).iter().map(one).collect();
        if all.is_empty() { String::new() } else { format!("  {}\n", all.join(" · ")) }
    }

    fn line(&self, sentence: &str) -> String {
        format!("  {}\n", wrapped(&clean(sentence), self.style.width.saturating_sub(4)).join("\n    "))
    }

    fn note(&self, word: &str, ink: Ink, sentence: &str) -> String {
        let indent = " ".repeat(word.chars().count() + 4);
        let room = self.style.width.saturating_sub(indent.len());
        let body = wrapped(&clean(sentence), room).join(&format!("\n{indent}"));
        format!("  {}: {body}\n", self.style.paint(ink, word))
    }
}

fn drive_table(study: &StudyResult) -> Grid {
    if findings::is_single(study) {
        return value_table(study);
    }
    let mut grid = Grid::new(["drive and stroke", "min", "at", "max", "at", "range"]);
    let drives = findings::drives(study).into_iter().map(|(_, finding)| finding);
    for finding in drives.chain(findings::strokes(study)) {
        grid.push(extremes(study, &finding));
    }
    grid
}

fn value_table(study: &StudyResult) -> Grid {
    let mut grid = Grid::new(["drive or position", "value"]);
    for finding in findings::values(study) {
        grid.push(vec![Cell::left(&finding.column.name), Cell::right(&finding.shown(finding.reductions.first))]);
    }
    grid
}

fn extremes(study: &StudyResult, finding: &Finding<'_>) -> Vec<Cell> {
    let (found, unit, decimals) = (&finding.reductions, &finding.column.unit, finding.decimals());
    let show = |si: f64| number::with_unit(&number::aligned(unit.show(si), decimals), &unit.symbol);
    vec![
        Cell::left(&finding.column.name),
        Cell::right(&show(found.min.value)),
        Cell::right(&findings::whereabouts(study, found.min)),
        Cell::right(&show(found.max.value)),
        Cell::right(&findings::whereabouts(study, found.max)),
        Cell::right(&show(found.range)),
    ]
}

fn reaction_table(study: &StudyResult) -> Grid {
    let mut grid = Grid::new(["reaction", "", "max force", "at", "max moment", "at"]);
    let joints = findings::strongest(study);
    for (joint, force) in joints.iter().take(MOST_JOINTS) {
        grid.push(reaction_row(study, joint, force));
    }
    let rest = joints.len().saturating_sub(MOST_JOINTS);
    if rest > 0 {
        grid.push(vec![Cell::left(&format!("and {rest} more joints in the report"))]);
    }
    grid
}

fn reaction_row(study: &StudyResult, joint: &str, force: &Finding<'_>) -> Vec<Cell> {
    let of_joint = study.reactions.iter().find(|reaction| reaction.joint == joint);
    let moment = findings::finding(study, &format!("joint.{joint}.reaction.moment"));
    let moment = moment.filter(|moment| moment.peak() > 1e-9 * force.peak());
    let at = |finding: &Finding<'_>| findings::whereabouts(study, finding.reductions.max);
    vec![
        Cell::left(joint),
        Cell::left(&of_joint.map_or_else(String::new, kind_and_mark)),
        Cell::right(&force.shown(force.reductions.max.value)),
        Cell::right(&at(force)),
        Cell::right(&moment.as_ref().map_or("–".to_owned(), |m| m.shown(m.reductions.max.value))),
        Cell::right(&moment.as_ref().map_or_else(String::new, at)),
    ]
}

fn kind_and_mark(reaction: &Reaction) -> String {
    let loose: Vec<&str> =
        reaction.unique.iter().filter_map(|(name, unique)| (!unique).then_some(name.as_str())).collect();
    if loose.is_empty() {
        return reaction.kind.clone();
    }
    format!("{}, {} not unique", reaction.kind, loose.join(" "))
}

fn scalar_table(study: &StudyResult) -> Grid {
    let mut grid = Grid::new(["result", "value"]);
    for (name, si, unit) in &study.scalars {
        let value = number::with_unit(&number::alone(unit.show(*si)), &unit.symbol);
        grid.push(vec![Cell::left(name), Cell::right(&value)]);
    }
    grid
}
