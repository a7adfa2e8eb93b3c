//! What moves when.

use serde_json::{Value, json};

use super::values::quantity;
use crate::{Move, Programme};

/// The moves as a list, in the order of time; what never ends has no end.
pub fn moves(of: &Programme) -> Value {
    of.moves.iter().map(|one| entry(of, one)).collect()
}

fn entry(of: &Programme, one: &Move) -> Value {
    json!({
        "motion": one.motion,
        "joint": one.joint,
        "segment": one.segment,
        "profile": one.profile,
        "start": quantity(one.start, &of.time),
        "end": one.end.map(|end| quantity(end, &of.time)),
        "from": quantity(one.from, &one.unit),
        "to": one.to.map(|to| quantity(to, &one.unit)),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::{StudyResult, Unit, study_summary};

    #[test]
    fn moves_are_told_with_units() {
        let unit = Unit::new("mm", 1e-3);
        let one = Move {
            motion: "out".to_owned(),
            joint: "rail".to_owned(),
            segment: Some("1".to_owned()),
            profile: "poly5",
            start: 0.5,
            end: Some(2.0),
            from: 0.1,
            to: None,
            unit,
        };
        let programme = Some(Programme { time: Unit::new("s", 1.0), moves: vec![one] });
        let summary = study_summary(&StudyResult { programme, ..StudyResult::default() });
        let expected = json!([{
            "motion": "out", "joint": "rail", "segment": "1", "profile": "poly5",
            "start": { "value": 0.5, "unit": "s" }, "end": { "value": 2.0, "unit": "s" },
            "from": { "value": 100.0, "unit": "mm" }, "to": null,
        }]);
        assert_eq!(summary["programme"], expected);
    }
}
