//! What happened during a study.

use serde_json::{Map, Value, json};

use super::values::quantity;
use crate::{Event, Events};

/// The keys that stand beside the signals.
pub(super) fn keys(of: &Events) -> Map<String, Value> {
    let mut keys = Map::new();
    keys.insert("events".to_owned(), of.list.iter().map(|one| event(of, one)).collect());
    if of.more > 0 {
        keys.insert("events_not_listed".to_owned(), json!(of.more));
    }
    if let Some(ended) = &of.ended {
        keys.insert("ended".to_owned(), json!({ "time": quantity(ended.time, &of.unit), "by": ended.by }));
    }
    keys
}

fn event(of: &Events, one: &Event) -> Value {
    let mut object = Map::new();
    object.insert("time".to_owned(), quantity(one.time, &of.unit));
    object.insert("kind".to_owned(), json!(one.kind.word()));
    object.insert("name".to_owned(), json!(one.name));
    for (key, word) in [("joint", one.joint.as_str()), ("side", one.side)] {
        if !word.is_empty() {
            object.insert(key.to_owned(), json!(word));
        }
    }
    for (name, si, unit) in &one.numbers {
        object.insert((*name).to_owned(), quantity(*si, unit));
    }
    Value::Object(object)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{Ended, EventKind, StudyResult, Unit, study_summary};

    #[test]
    fn events_stand_beside_the_signals() {
        let mut events = Events::none(Unit::new("ms", 1e-3));
        events.push(Event {
            time: 0.25,
            kind: EventKind::Impact,
            name: "floor".to_owned(),
            joint: "slide".to_owned(),
            side: "lower",
            numbers: vec![("speed", 2.0, Unit::new("mm/s", 1e-3))],
        });
        events.ended = Some(Ended { time: 0.5, by: "time > 0.5 s".to_owned() });
        let summary = study_summary(&StudyResult { events: Some(events), ..StudyResult::default() });
        let expected = json!([{
            "time": { "value": 250.0, "unit": "ms" }, "kind": "impact", "name": "floor", "joint": "slide",
            "side": "lower", "speed": { "value": 2000.0, "unit": "mm/s" },
        }]);
        assert_eq!(summary["events"], expected);
        assert_eq!(summary["ended"], json!({ "time": { "value": 500.0, "unit": "ms" }, "by": "time > 0.5 s" }));
        assert!(study_summary(&StudyResult::default()).get("events").is_none());
    }

    #[test]
    fn a_storm_of_events_is_counted() {
        let mut events = Events::none(Unit::new("s", 1.0));
        let event = Event {
            time: 0.0,
            kind: EventKind::Stick,
            name: String::new(),
            joint: String::new(),
            side: "",
            numbers: Vec::new(),
        };
        (0..10_007).for_each(|_| events.push(event.clone()));
        assert_eq!((events.count(), keys(&events)["events_not_listed"].as_u64()), (10_007, Some(7)));
    }
}
