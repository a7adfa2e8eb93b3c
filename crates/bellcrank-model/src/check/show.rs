//! A check as text for people and as JSON for programs.

use bellcrank_results::{Move, Programme, SpaceKind, moves};
use serde_json::{Value, json};

use super::{BodyFact, Check, JointFact, SolidFact};
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
        let solids: Vec<&SolidFact> = self.bodies.iter().filter_map(|body| body.solid.as_ref()).collect();
        if !solids.is_empty() {
            lines.push("solids".to_owned());
            lines.extend(solids.into_iter().flat_map(|solid| solid_lines(solid, wide)));
        }
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

impl SolidFact {
    /// For programs.
    #[must_use]
    pub fn json(&self) -> Value {
        json!({
            "body": self.body,
            "solid": self.solid,
            "material": self.material,
            "properties": self.properties.iter().map(|(key, values, unit)| {
                let value = if let [one] = values.as_slice() { json!(one) } else { json!(values) };
                ((*key).to_owned(), json!({ "value": value, "unit": unit }))
            }).collect::<serde_json::Map<_, _>>(),
            "volume": { "value": self.volume, "unit": "m^3" },
            "mass": { "value": self.mass, "unit": "kg" },
            "center": { "value": self.center, "unit": "m" },
            "inertia": { "value": self.inertia, "unit": "kg*m^2" },
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

/// A body's solid in four lines.
fn solid_lines(of: &SolidFact, wide: usize) -> Vec<String> {
    let show = |x: f64| rounded_near(of.length.show(x), of.length.show(of.volume.cbrt()));
    let center = of.center.map(show).map(|x| x.to_string()).join(", ");
    let largest = of.inertia.iter().flatten().fold(0.0, |most: f64, x| most.max(x.abs()));
    let entry = |[i, j]: [usize; 2]| rounded_near(of.inertia[i][j], largest);
    let list = |places: [[usize; 2]; 3]| places.map(|place| entry(place).to_string()).join(", ");
    let products = [[0, 1], [0, 2], [1, 2]];
    let off = if products.iter().any(|&place| entry(place) != 0.0) {
        format!("; Ixy, Ixz, Iyz [{}]", list(products))
    } else {
        String::new()
    };
    let symbol = &of.length.symbol;
    let blank = "";
    vec![
        format!("  {:<wide$}{} of {}{}", of.body, of.solid, of.material, property_text(of)),
        format!("  {blank:<wide$}volume   {} cm^3, mass {} kg", rounded(of.volume * 1e6), rounded(of.mass)),
        format!("  {blank:<wide$}centre   [{center}] {symbol}"),
        format!("  {blank:<wide$}inertia  Ixx, Iyy, Izz [{}]{off} kg*m^2", list([[0, 0], [1, 1], [2, 2]])),
    ]
}

/// `: density 7850 kg/m^3, young 210 GPa, ...`
fn property_text(of: &SolidFact) -> String {
    let number = |x: f64, unit: &str| match unit {
        // Moduli are told in what data sheets have.
        "Pa" if x.abs() >= 1e9 => (rounded(x * 1e-9), "GPa"),
        "Pa" => (rounded(x * 1e-6), "MPa"),
        _ => (rounded(x), ""),
    };
    let one = |(key, values, unit): &(&str, Vec<f64>, &str)| {
        let unit_of = |x: f64| match number(x, unit) {
            (_, "") => (*unit).to_owned(),
            (_, shown) => shown.to_owned(),
        };
        let texts = values.iter().map(|&x| format!("{} {}", number(x, unit).0, unit_of(x)).trim_end().to_owned());
        let texts: Vec<String> = texts.collect();
        if let [one] = texts.as_slice() { format!("{key} {one}") } else { format!("{key} [{}]", texts.join(", ")) }
    };
    let all: Vec<String> = of.properties.iter().map(one).collect();
    if all.is_empty() { String::new() } else { format!(": {}", all.join(", ")) }
}

/// Solids with their mass properties, for people; inertias are about the centre of mass, along body axes.
#[must_use]
pub fn solid_table(solids: &[SolidFact]) -> String {
    let wide = solids.iter().map(|solid| solid.body.chars().count() + 2).fold(16, usize::max);
    let lines: Vec<String> = solids.iter().flat_map(|solid| solid_lines(solid, wide)).collect();
    lines.join("\n") + "\n"
}

/// Six significant digits; zero for what is nothing but rounding beside `size`.
fn rounded_near(value: f64, size: f64) -> f64 {
    if value.abs() < 1e-9 * size.abs() { 0.0 } else { rounded(value) }
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
    let mut told = json!({ "name": body.name, "mass": { "value": body.mass, "unit": "kg" }, "joints": body.joints });
    if let Some(solid) = &body.solid {
        told["solid"] = solid.json();
    }
    told
}

fn joint_json(joint: &JointFact) -> Value {
    json!({ "name": joint.name, "kind": joint.kind, "bodies": joint.bodies, "closes_loop": joint.closes })
}
