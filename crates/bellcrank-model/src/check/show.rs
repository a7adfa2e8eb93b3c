//! A check as text for people and as JSON for programs.

use bellcrank_results::{Move, Programme, SpaceKind, moves};
use serde_json::{Value, json};

use super::{BodyFact, Check, JointFact};
use crate::run::shown;

impl Check {
    /// For people.
    #[must_use]
    pub fn text(&self) -> String {
        let mut lines = vec![format!("{} ({})", self.title, space(self.space))];
        lines.extend(self.facts().into_iter().map(|(label, text)| format!("  {label:<22}{text}")));
        lines.push(String::new());
        lines.push("bodies".to_owned());
        let wide = self.name_column();
        lines.extend(self.bodies.iter().map(|body| body_line(body, wide)));
        lines.push("joints".to_owned());
        lines.extend(self.joints.iter().map(|joint| joint_line(joint, wide)));
        if !self.studies.is_empty() {
            lines.push("studies".to_owned());
            lines.extend(self.studies.iter().map(|study| {
                let later = if study.available { "" } else { "  (not in this version)" };
                format!("  {:<wide$}{}{later}", study.name, study.kind)
            }));
        }
        self.programmes.iter().for_each(|(studies, of)| lines.extend(programme_lines(studies, of)));
        if let Some(failure) = &self.failure {
            lines.push(String::new());
            lines.push(failure.message.clone());
            lines.extend(failure.hints.iter().map(|hint| format!("  hint: {hint}")));
        }
        if !self.notes.is_empty() {
            lines.push(String::new());
            lines.extend(self.notes.iter().map(|note| format!("note: {note}")));
        }
        lines.join("\n") + "\n"
    }

    /// Width of the column of names: 16, or what the longest needs.
    fn name_column(&self) -> usize {
        let bodies = self.bodies.iter().map(|body| &body.name);
        let joints = self.joints.iter().map(|joint| &joint.name);
        let names = bodies.chain(joints).chain(self.studies.iter().map(|study| &study.name));
        names.map(|name| name.chars().count() + 2).fold(16, usize::max)
    }

    /// The counts in words: label and text, as results carry them.
    #[must_use]
    pub fn facts(&self) -> Vec<(String, String)> {
        let massive = self.bodies.iter().filter(|body| body.mass > 0.0).count();
        let mut facts = vec![
            ("bodies", format!("{} ({massive} with mass) and the ground", self.bodies.len())),
            ("joints", format!("{}", self.joints.len())),
            ("degrees of freedom", self.freedom()),
            ("loops", self.loops_closed()),
        ];
        if !self.redundant.is_empty() {
            facts
                .push(("redundant equations", format!("{} among: {}", self.redundancies(), self.redundant.join(", "))));
        }
        if !self.mobile.is_empty() {
            facts.push(("can move", self.mobile.join(", ")));
        }
        if self.special {
            facts.push(("position", "special: the rank is another nearby".to_owned()));
        }
        facts.into_iter().map(|(label, text)| (label.to_owned(), text)).collect()
    }

    /// Number of equations that follow from others.
    #[must_use]
    pub fn redundancies(&self) -> usize {
        self.equations - self.rank.unwrap_or(self.equations).min(self.equations)
    }

    fn freedom(&self) -> String {
        let counted = format!("counted {} - {} = {}", self.coordinates, self.equations, self.counted);
        match (self.degrees, self.rank) {
            (Some(degrees), Some(rank)) => format!("{degrees} (rank {rank} of {}; {counted})", self.equations),
            _ => format!("unknown: not assembled ({counted})"),
        }
    }

    fn loops_closed(&self) -> String {
        let closing: Vec<&str> =
            self.joints.iter().filter(|joint| joint.closes).map(|joint| joint.name.as_str()).collect();
        match closing.is_empty() {
            true => format!("{}", self.loops),
            false => format!("{}, closed by {}", self.loops, closing.join(", ")),
        }
    }

    /// For programs.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "model": self.model,
            "title": self.title,
            "space": space(self.space),
            "bodies": self.bodies.iter().map(body_json).collect::<Vec<_>>(),
            "joints": self.joints.iter().map(joint_json).collect::<Vec<_>>(),
            "forces": self.forces,
            "studies": self.studies.iter()
                .map(|s| json!({ "name": s.name, "kind": s.kind, "available": s.available })).collect::<Vec<_>>(),
            "degrees_of_freedom": {
                "counted": self.counted,
                "computed": self.degrees,
                "coordinates": self.coordinates,
                "equations": self.equations,
                "rank": self.rank,
            },
            "loops": self.loops,
            "redundant": { "count": self.redundancies(), "equations": self.redundant },
            "mobile": self.mobile,
            "special_position": self.special,
            "programmes": self.programmes.iter()
                .map(|(studies, of)| json!({ "studies": studies, "moves": moves(of) })).collect::<Vec<_>>(),
            "notes": self.notes,
            "failure": self.failure.as_ref().map(|f| json!({ "message": f.message, "hints": f.hints })),
        })
    }
}

fn space(kind: SpaceKind) -> &'static str {
    match kind {
        SpaceKind::Planar => "planar",
        SpaceKind::Spatial => "spatial",
    }
}

fn body_line(body: &BodyFact, wide: usize) -> String {
    let mass = if body.mass > 0.0 { format!("{} kg", rounded(body.mass)) } else { "massless".to_owned() };
    let joints =
        if body.joints.is_empty() { "no joints".to_owned() } else { format!("joints {}", body.joints.join(", ")) };
    format!("  {:<wide$}{mass:<14}{joints}", body.name)
}

/// Six significant digits.
fn rounded(value: f64) -> f64 {
    format!("{value:.5e}").parse().unwrap_or(value)
}

fn joint_line(joint: &JointFact, wide: usize) -> String {
    let closes = if joint.closes { "  closes a loop" } else { "" };
    format!("  {:<wide$}{:<14}{}{closes}", joint.name, joint.kind, joint.bodies.join(" - "))
}

/// The moves of a programme, one a line.
fn programme_lines(studies: &[String], of: &Programme) -> Vec<String> {
    let cells: Vec<[String; 4]> = of.moves.iter().map(|one| move_cells(of, one)).collect();
    let width = |column: usize| cells.iter().map(|cells| cells[column].chars().count()).max().unwrap_or(0);
    let widths: [usize; 3] = std::array::from_fn(width);
    let line = |[time, joint, way, name]: &[String; 4]| {
        format!("  {time:<0$}  {joint:<1$}  {way:<2$}  {name}", widths[0], widths[1], widths[2])
    };
    let head = format!("programme of {}", studies.join(", "));
    std::iter::once(head).chain(cells.iter().map(line)).collect()
}

fn move_cells(of: &Programme, one: &Move) -> [String; 4] {
    let time = |si| shown(si, &of.time);
    let place = |si| shown(si, &one.unit);
    let until = one.end.map_or(" on".to_owned(), |end| format!(" to {}", time(end)));
    let way = match one.to {
        _ if one.holds() => format!("at {}", place(one.from)),
        Some(to) => format!("{} -> {}", place(one.from), place(to)),
        None => format!("from {}", place(one.from)),
    };
    let segment = one.segment.as_ref().map_or_else(String::new, |segment| format!(".{segment}"));
    let name = format!("{}{segment} ({})", one.motion, one.profile);
    [format!("{}{until}", time(one.start)), one.joint.clone(), way, name]
}

fn body_json(body: &BodyFact) -> Value {
    json!({ "name": body.name, "mass": { "value": body.mass, "unit": "kg" }, "joints": body.joints })
}

fn joint_json(joint: &JointFact) -> Value {
    json!({ "name": joint.name, "kind": joint.kind, "bodies": joint.bodies, "closes_loop": joint.closes })
}
