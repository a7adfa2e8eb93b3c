//! Boundary of a body of revolution, in two half turns.

use super::space::{Place, add, any_across, cross, scale, unit};
use super::{Face, Form, Path, SharpEdge, Shell, ShellEdge, Surface};
use crate::{Fault, Revolved};

impl Revolved<f64> {
    /// Its boundary. Fails as [`Revolved::moments`] does.
    pub fn shell(&self) -> Result<Shell, Vec<Fault>> {
        let corners = self.checked()?;
        let axis = unit(self.axis);
        let across = any_across(axis);
        let mut builder = Builder {
            base: self.base,
            axis,
            across: [across, cross(axis, across)],
            shell: Shell::default(),
            places: Vec::new(),
            rounds: Vec::new(),
        };
        builder.corners(&corners);
        builder.sides(&corners);
        Ok(builder.shell)
    }

    /// Triangles that are nowhere further from the boundary than the tolerance, in m. Fails as [`Revolved::moments`] does.
    pub fn surface(&self, chord_tolerance: f64) -> Result<Surface, Vec<Fault>> {
        Ok(self.shell()?.surface(chord_tolerance))
    }

    /// Re-entrant edges. Fails as [`Revolved::moments`] does.
    pub fn sharp_edges(&self) -> Result<Vec<SharpEdge>, Vec<Fault>> {
        Ok(self.shell()?.sharp_edges())
    }
}

struct Builder {
    base: Place,
    axis: Place,
    across: [Place; 2],
    shell: Shell,
    /// For each corner, its vertices at no turn and at half a turn; one and the same on the axis.
    places: Vec<[usize; 2]>,
    /// For each corner off the axis, its two half circles.
    rounds: Vec<Option<[usize; 2]>>,
}

impl Builder {
    fn on_axis(&self, h: f64) -> Place {
        add(self.base, scale(self.axis, h))
    }

    fn corners(&mut self, corners: &[[f64; 2]]) {
        for [r, h] in corners {
            let center = self.on_axis(*h);
            let first = self.shell.vertices.len();
            if *r == 0.0 {
                self.shell.vertices.push(center);
                self.places.push([first; 2]);
                self.rounds.push(None);
                continue;
            }
            for side in [*r, -*r] {
                self.shell.vertices.push(add(center, scale(self.across[0], side)));
            }
            let path = Path::Circle { center, axis: self.axis, radius: *r };
            let edge = self.shell.edges.len();
            self.shell.edges.push(ShellEdge { ends: [first, first + 1], path: path.clone() });
            self.shell.edges.push(ShellEdge { ends: [first + 1, first], path });
            self.places.push([first, first + 1]);
            self.rounds.push(Some([edge, edge + 1]));
        }
    }

    /// Faces of the sides; corners run counter-clockwise in (r, h).
    fn sides(&mut self, corners: &[[f64; 2]]) {
        for i in 0..corners.len() {
            let j = (i + 1) % corners.len();
            if corners[i][0] == 0.0 && corners[j][0] == 0.0 {
                continue;
            }
            let lines = [0, 1].map(|side| {
                let ends = [self.places[i][side], self.places[j][side]];
                self.shell.edges.push(ShellEdge { ends, path: Path::Line });
                self.shell.edges.len() - 1
            });
            for half in [0, 1] {
                let mut walk: Vec<(usize, bool)> = Vec::new();
                walk.extend(self.rounds[i].map(|round| (round[half], true)));
                walk.push((lines[1 - half], true));
                walk.extend(self.rounds[j].map(|round| (round[half], false)));
                walk.push((lines[half], false));
                self.shell.faces.push(Face { form: self.form(corners[i], corners[j]), loops: vec![walk] });
            }
        }
    }

    fn form(&self, [r, h]: [f64; 2], [s, k]: [f64; 2]) -> Form {
        let (out, up) = (s - r, k - h);
        if up.abs() <= 1e-9 * out.abs() {
            let normal = scale(self.axis, if out < 0.0 { 1.0 } else { -1.0 });
            return Form::Plane { point: self.on_axis(h), normal };
        }
        let convex = up > 0.0;
        if out.abs() <= 1e-9 * up.abs() {
            return Form::Cylinder { point: self.on_axis(h), axis: self.axis, radius: r, convex };
        }
        let slope = out / up;
        let apex = self.on_axis(h - r / slope);
        Form::Cone { apex, axis: scale(self.axis, slope.signum()), slope: slope.abs(), convex }
    }
}
