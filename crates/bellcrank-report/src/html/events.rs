//! What happened during a study, in a table.

use bellcrank_results::{Event, Events, StudyResult};

use super::Escaped;
use super::rows::{Rows, code, number, words};
use crate::told::events;

/// Events of the table; the file has all.
const MOST: usize = 200;

/// Nothing for a study in which nothing can happen, or nothing did.
pub(crate) fn section(study: &StudyResult) -> String {
    let Some(of) = study.events.as_ref().filter(|of| of.count() > 0) else { return String::new() };
    let lead: String =
        events::sentences(of).iter().map(|text| format!("<p class=\"lead\">{}</p>\n", words(text))).collect();
    let mut rows = Rows::new(&[format!(" Time in {}", of.unit.symbol).as_str(), "Event", "Of", "Where", ""]);
    of.list.iter().take(MOST).for_each(|event| rows.push(&cells(of, event)));
    format!("<h3>Events</h3>\n{lead}{}{}", rows.html(), rest(of))
}

fn cells(of: &Events, event: &Event) -> [String; 5] {
    [
        number(event.time, &of.unit),
        event.kind.word().to_owned(),
        code(&event.name),
        Escaped(&events::whereabouts(event)).to_string(),
        words(&events::numbers(event)),
    ]
}

fn rest(of: &Events) -> String {
    let rest = of.list.len().saturating_sub(MOST);
    if rest == 0 {
        return String::new();
    }
    format!("<p class=\"hint\">and {rest} more in <code>events.csv</code>.</p>\n")
}
