//! What happened during a study, in words.

use bellcrank_results::{Event, EventKind, Events};

use super::{listed, shown};

/// How the study ended, and how much happened; nothing where nothing did.
pub(crate) fn sentences(events: &Events) -> Vec<String> {
    let ended = events.ended.as_ref().map(|ended| {
        let time = shown(ended.time, &events.unit);
        format!("Ended at {time}, where `{}` became true.", ended.by)
    });
    ended.into_iter().chain(counted(events)).collect()
}

/// `12 events: 8 impacts and 4 contacts.`
fn counted(events: &Events) -> Option<String> {
    let all = events.count();
    let kinds = [
        (EventKind::Impact, "impact", "impacts"),
        (EventKind::Contact, "contact", "contacts"),
        (EventKind::Release, "release", "releases"),
        (EventKind::Stick, "sticking", "stickings"),
        (EventKind::Slip, "slip", "slips"),
        (EventKind::Condition, "condition", "conditions"),
    ];
    let of = |kind: EventKind| events.list.iter().filter(|event| event.kind == kind).count();
    let part = |(kind, one, many): &(EventKind, &str, &str)| match of(*kind) {
        0 => None,
        1 => Some(format!("1 {one}")),
        count => Some(format!("{count} {many}")),
    };
    let mut parts: Vec<String> = kinds.iter().filter_map(part).collect();
    if events.more > 0 {
        parts.push(format!("{} more that are not listed", events.more));
    }
    let plural = if all == 1 { "" } else { "s" };
    (all > 0).then(|| format!("{all} event{plural}: {}.", listed(&parts)))
}

/// `upper limit of slide`, `slide, upwards`; nothing for a condition.
pub(crate) fn whereabouts(event: &Event) -> String {
    let joint = &event.joint;
    match event.side {
        "" => joint.clone(),
        "up" | "down" => format!("{joint}, {}wards", event.side),
        side => format!("{side} limit of {joint}"),
    }
}

/// `speed 1.2 m/s, impulse 3 N*s`.
pub(crate) fn numbers(event: &Event) -> String {
    let number = |(name, si, unit): &(&str, f64, bellcrank_results::Unit)| format!("{name} {}", shown(*si, unit));
    event.numbers.iter().map(number).collect::<Vec<_>>().join(", ")
}
