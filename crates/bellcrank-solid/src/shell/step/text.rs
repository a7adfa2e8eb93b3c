//! Numbers, strings and entities as a STEP file has them.

use std::fmt::Write;

/// Number of an entity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(super) struct Id(usize);

impl std::fmt::Display for Id {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "#{}", self.0)
    }
}

/// Entities so far.
#[derive(Default)]
pub(super) struct File {
    pub(super) entities: String,
    count: usize,
}

/// Entities that everything refers to.
pub(super) struct Context {
    pub(super) application: Id,
    /// Millimetres, radians and how exact places are.
    pub(super) geometry: Id,
}

impl File {
    /// Adds an entity: its name and arguments.
    pub(super) fn add(&mut self, entity: &str) -> Id {
        self.count += 1;
        let _ = writeln!(self.entities, "#{}={entity};", self.count);
        Id(self.count)
    }

    pub(super) fn context(&mut self) -> Context {
        let application = self.add("APPLICATION_CONTEXT('core data for automotive mechanical design processes')");
        self.add(&format!(
            "APPLICATION_PROTOCOL_DEFINITION('international standard','automotive_design',2000,{application})"
        ));
        let length = self.add("(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.))");
        let angle = self.add("(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.))");
        let solid = self.add("(NAMED_UNIT(*)SI_UNIT($,.STERADIAN.)SOLID_ANGLE_UNIT())");
        let exact = self.add(&format!(
            "UNCERTAINTY_MEASURE_WITH_UNIT(LENGTH_MEASURE(1.E-6),{length},'distance_accuracy_value','')"
        ));
        let geometry = self.add(&format!(
            "(GEOMETRIC_REPRESENTATION_CONTEXT(3)GLOBAL_UNCERTAINTY_ASSIGNED_CONTEXT(({exact}))\
             GLOBAL_UNIT_ASSIGNED_CONTEXT(({length},{angle},{solid}))REPRESENTATION_CONTEXT('',''))"
        ));
        Context { application, geometry }
    }

    /// A place given in m.
    pub(super) fn point(&mut self, p: [f64; 3]) -> Id {
        let [x, y, z] = p.map(|x| real(x * 1000.0));
        self.add(&format!("CARTESIAN_POINT('',({x},{y},{z}))"))
    }

    pub(super) fn direction(&mut self, d: [f64; 3]) -> Id {
        let [x, y, z] = d.map(real);
        self.add(&format!("DIRECTION('',({x},{y},{z}))"))
    }

    /// Axes at a place given in m, with their z and x directions.
    pub(super) fn axes(&mut self, at: [f64; 3], z: [f64; 3], x: [f64; 3]) -> Id {
        let (at, z, x) = (self.point(at), self.direction(z), self.direction(x));
        self.add(&format!("AXIS2_PLACEMENT_3D('',{at},{z},{x})"))
    }
}

/// A real number: always with a point, an exponent with `E`.
pub(super) fn real(x: f64) -> String {
    if x == 0.0 || !x.is_finite() {
        return "0.".to_owned();
    }
    if !(1e-5..1e15).contains(&x.abs()) {
        let plain = format!("{x:E}");
        let (digits, exponent) = plain.split_once('E').unwrap_or((&plain, "0"));
        let point = if digits.contains('.') { "" } else { "." };
        return format!("{digits}{point}E{exponent}");
    }
    let plain = format!("{x}");
    if plain.contains('.') { plain } else { plain + "." }
}

/// A string in quotes, everything beyond ASCII as UTF-16 in hexadecimal.
pub(super) fn text(words: &str) -> String {
    let mut quoted = "'".to_owned();
    for letter in words.chars() {
        match letter {
            '\'' => quoted.push_str("''"),
            '\\' => quoted.push_str("\\\\"),
            ' '..='~' => quoted.push(letter),
            _ => {
                let units = letter.encode_utf16(&mut [0; 2]).iter().map(|u| format!("{u:04X}")).collect::<String>();
                let _ = write!(quoted, "\\X2\\{units}\\X0\\");
            }
        }
    }
    quoted + "'"
}

/// A list of entities.
pub(super) fn list(ids: &[Id]) -> String {
    let ids: Vec<String> = ids.iter().map(Id::to_string).collect();
    format!("({})", ids.join(","))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_and_strings_are_those_of_the_standard() {
        assert_eq!(real(12.0), "12.");
        assert_eq!(real(-0.25), "-0.25");
        assert_eq!(real(1e-9), "1.E-9");
        assert_eq!(real(1.5e-9), "1.5E-9");
        assert_eq!(real(-0.0), "0.");
        assert_eq!(text("L'axe Ø"), "'L''axe \\X2\\00D8\\X0\\'");
    }
}
