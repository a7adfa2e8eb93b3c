//! Stress: which rows count, then solutions on finer and finer meshes until the stress is as exact as was asked.

use std::time::Instant;

use bellcrank_fem::{
    Fault, Free, Settings, SizeField, Solution, Statics, Stress, element_sizes, element_stress_errors, wanted_sizes,
};
use bellcrank_mesh::Mesh;
use bellcrank_results::{Column, MeshRow, PartEffort, StressBody, StudyResult};

use super::acting::{self, Acting};
use super::files::Written;
use super::meshing::Solid;
use super::pictures::{self, Picture};
use super::problem::{self, Problem, Setup};
use super::regions::{Doubtful, Region, regions};
use super::spots::{self, Spot};
use super::vector::{V3, norm};
use super::watched::watched;
use super::{Asked, End, cancelled, ended, memory, worst};
use crate::MeshFormats;
use crate::design::{Accuracy, At, Hinges, StressForm, Study};
use crate::measure::Measure;
use crate::progress::Progress;
use crate::run::Places;

/// Errors are aimed below what is asked, for the estimate of the next mesh is one.
const AIM: f64 = 0.7;
/// Of stress on second-order elements.
const ORDER: f64 = 2.0;
/// An unbalance that is more than rounding and the curves of the mesh.
const UNBALANCED: f64 = 0.01;
/// Share of the progress that reading the loads takes.
const LOADS: f64 = 0.05;

/// The rows of the study that loads the bodies.
struct Loads<'d> {
    of: &'d Study,
    rows: StudyResult,
}

pub(super) fn run(
    asked: &Asked<'_>,
    form: &StressForm,
    of: Option<&Study>,
    result: &mut StudyResult,
    progress: &mut dyn Progress,
) -> Result<(), End> {
    let (loads, acting) = match of {
        Some(of) => {
            progress.at(0.0, "reading the loads");
            let (rows, acting) = acting::read(asked, of, progress)?;
            result.warnings.extend(rows.warnings.iter().cloned());
            (Some(Loads { of, rows }), acting)
        }
        None => (None, vec![Acting::default(); asked.parts.bodies.len()]),
    };
    let count = asked.parts.bodies.len() as f64;
    for (index, (&body, acting)) in asked.parts.bodies.iter().zip(&acting).enumerate() {
        let share = [index, index + 1].map(|i| LOADS + (1.0 - LOADS) * i as f64 / count);
        let mut one = One { asked, form, loads: loads.as_ref(), result, progress, share, begun: Instant::now() };
        one.run(body, acting)?;
    }
    progress.at(1.0, "done");
    Ok(())
}

/// One body of the study.
struct One<'a, 'd> {
    asked: &'a Asked<'d>,
    form: &'a StressForm,
    loads: Option<&'a Loads<'a>>,
    result: &'a mut StudyResult,
    progress: &'a mut dyn Progress,
    share: [f64; 2],
    begun: Instant,
}

/// What is the same on every mesh.
struct Fixed<'p> {
    problem: &'p Problem<'p>,
    strength: Option<f64>,
    doubtful: Doubtful,
    /// Rows that are solved, with their place in words.
    rows: Vec<(usize, String)>,
}

impl Fixed<'_> {
    /// The case with the largest stress.
    fn shown(&self, body: &StressBody) -> usize {
        let place = body.peak().map_or("", |spot| spot.place.as_str());
        self.rows.iter().position(|(_, of)| of == place).unwrap_or(0)
    }
}

/// A solved mesh.
struct Solved {
    mesh: Mesh,
    regions: Vec<Region>,
    cases: Vec<(Solution, Stress)>,
    spots: Vec<Spot>,
    effort: PartEffort,
    warnings: Vec<String>,
}

impl One<'_, '_> {
    fn run(&mut self, body: usize, acting: &Acting) -> Result<(), End> {
        let asked = self.asked;
        let solid = Solid::new(asked, body)?;
        let (material, strength) = problem::material(asked, body, &solid)?;
        let problem = Problem::new(asked, body, &solid, &material, self.form, acting);
        self.result.warnings.extend(acting.warnings.iter().cloned());
        let mesh = self.mesh(&solid, None)?;
        let held = problem.on(&mesh, self.form.hinges)?.held;
        let doubtful = Doubtful::new(&mesh, &held);
        let rows = self.rows(&problem, &mesh, &doubtful)?;
        let fixed = Fixed { problem: &problem, strength, doubtful, rows };
        self.refine(&fixed, mesh)
    }

    fn mesh(&mut self, solid: &Solid, wanted: Option<&SizeField>) -> Result<Mesh, End> {
        self.progress.at(self.share[0], "meshing");
        solid.mesh(wanted, memory::most_nodes())
    }

    /// A part of this body's share of the progress.
    fn part(&self, from: f64, to: f64) -> [f64; 2] {
        [from, to].map(|at| self.share[0] + at * (self.share[1] - self.share[0]))
    }

    /// The rows that are solved with the hinges asked for.
    fn rows(&mut self, problem: &Problem<'_>, mesh: &Mesh, doubtful: &Doubtful) -> Result<Vec<(usize, String)>, End> {
        let Some(loads) = self.loads else { return Ok(Vec::new()) };
        let chosen = match &self.form.at {
            At::Row(row) => vec![loads.row(*row)?],
            At::Nearest { signal, value } => vec![loads.nearest(signal, value.eval(&self.asked.study.values))?],
            At::Worst | At::All => {
                let ranked = self.ranked(problem, mesh, doubtful)?;
                let (first, mut each) = worst::worst(&ranked);
                let first = first.ok_or_else(|| loads.nothing())?;
                if matches!(self.form.at, At::Worst) {
                    each.clear();
                }
                let mut rows: Vec<usize> = std::iter::once(first).chain(each.into_iter().flatten()).collect();
                rows.sort_unstable();
                rows.dedup();
                rows
            }
        };
        let known = |row: &usize| problem.acting.rows.get(*row).is_some_and(Option::is_some);
        if !chosen.iter().all(known) {
            return Err(loads.nothing());
        }
        Ok(chosen.into_iter().map(|row| (row, loads.place(self.asked, row))).collect())
    }

    /// The largest stress of each region in each row; they become columns of the table.
    fn ranked(&mut self, problem: &Problem<'_>, mesh: &Mesh, doubtful: &Doubtful) -> Result<Vec<Vec<f64>>, End> {
        let unit = self.asked.design.units.of(Measure::Length);
        let regions = regions(problem.solid, mesh, &unit);
        let setup = problem.on(mesh, Hinges::Distributing)?;
        let (threads, span) = (self.asked.threads, self.part(0.0, 0.2));
        let ranked = watched(self.progress, span, "looking for the worst position", |tell| {
            let settings = Settings { threads, memory: memory::allowed(), progress: &|done| tell(0.5 * done) };
            let statics = Statics::new(&setup.part, Free::Relieved, &settings)?;
            worst::ranked(&setup, &statics, problem.acting, &regions, doubtful, &|done| tell(0.5 + 0.5 * done))
        });
        let ranked = ranked.map_err(|faults| self.refused(problem, mesh, &faults))?;
        self.columns(problem.name(), &regions, &ranked);
        Ok(ranked)
    }

    fn columns(&mut self, body: &str, regions: &[Region], ranked: &[Vec<f64>]) {
        let Some(loads) = self.loads else { return };
        let table = &mut self.result.table.columns;
        if table.is_empty() {
            let axis = |name: &String| loads.rows.table.column(name).cloned();
            table.extend(loads.rows.axis.iter().filter_map(axis));
            self.result.axis.clone_from(&loads.rows.axis);
        }
        let unit = self.asked.design.units.of(Measure::Stress);
        table.extend(regions.iter().zip(ranked).map(|(region, values)| Column {
            name: format!("stress.{body}.{}", region.key),
            unit: unit.clone(),
            values: values.clone(),
        }));
    }

    fn refused(&self, problem: &Problem<'_>, mesh: &Mesh, faults: &[Fault]) -> End {
        match faults {
            [Fault::Interrupted] => cancelled("before the first solution"),
            _ => problem.refused(mesh, faults),
        }
    }

    /// Solves on the first mesh, and on finer ones as long as the stress is not as exact as was asked. Whatever ends
    /// that early, the last solution stands.
    fn refine(&mut self, fixed: &Fixed<'_>, first: Mesh) -> Result<(), End> {
        let most = self.form.accuracy.map_or(0, |accuracy| accuracy.refinements);
        let mut last = self.solve(fixed, first, 0, most)?;
        let mut meshes = vec![mesh_row(&last)];
        let mut end = Ok(());
        for step in 1..=most {
            let Some(accuracy) = self.form.accuracy.filter(|asked| self.is_off(&last, *asked)) else { break };
            let wanted = wanted(&last, fixed, accuracy);
            let finer = self.mesh(fixed.problem.solid, Some(&wanted));
            let next = finer.and_then(|mesh| self.solve(fixed, mesh, step, most));
            match next {
                Ok(mut next) => {
                    spots::compared(&mut next.spots, &last.spots);
                    meshes.push(mesh_row(&next));
                    last = next;
                }
                Err(failure) if self.progress.cancelled() => {
                    end = Err(failure);
                    break;
                }
                Err(failure) => {
                    self.result.warnings.push(format!("the mesh was not refined further: {}", failure.message));
                    break;
                }
            }
        }
        self.tell(fixed, &last, meshes);
        end
    }

    fn is_off(&self, solved: &Solved, accuracy: Accuracy) -> bool {
        spots::worst_error(&solved.spots) > accuracy.error
    }

    fn solve(&mut self, fixed: &Fixed<'_>, mesh: Mesh, step: usize, most: usize) -> Result<Solved, End> {
        let begun = Instant::now();
        let problem = fixed.problem;
        let setup = problem.on(&mesh, self.form.hinges)?;
        let share = |step: usize| 0.2 + 0.8 * step as f64 / (most + 1) as f64;
        let (threads, span) = (self.asked.threads, self.part(share(step), share(step + 1)));
        let free = if self.loads.is_some() { Free::Relieved } else { Free::Refused };
        let message = if step == 0 { "solving" } else { "solving on a finer mesh" };
        let solved = watched(self.progress, span, message, |tell| {
            let settings = Settings { threads, memory: memory::allowed(), progress: &|done| tell(0.8 * done) };
            let statics = Statics::new(&setup.part, free, &settings)?;
            let cases = cases(fixed, &setup, &statics, tell)?;
            Ok((statics.effort, cases))
        });
        let (effort, cases) = solved.map_err(|faults: Vec<Fault>| self.refused(problem, &mesh, &faults))?;
        let unit = self.asked.design.units.of(Measure::Length);
        let regions = regions(problem.solid, &mesh, &unit);
        let places: Vec<&str> = fixed.rows.iter().map(|(_, place)| place.as_str()).collect();
        let mut found = Vec::new();
        for (index, (_, stress)) in cases.iter().enumerate() {
            let place = if places.len() > 1 { places[index] } else { "" };
            let new = spots::spots(&mesh, stress, &regions, &fixed.doubtful, place);
            found = spots::envelope(found, new);
        }
        let warnings = setup.warnings;
        let effort = PartEffort {
            equations: effort.equations,
            factor_entries: effort.factor_entries,
            seconds: begun.elapsed().as_secs_f64(),
        };
        Ok(Solved { mesh, regions, cases, spots: found, effort, warnings })
    }

    /// What was found, for the reader.
    fn tell(&mut self, fixed: &Fixed<'_>, solved: &Solved, meshes: Vec<MeshRow>) {
        let (problem, units) = (fixed.problem, &self.asked.design.units);
        let body = self.body(fixed, solved, meshes);
        for warning in &solved.warnings {
            if !self.result.warnings.contains(warning) {
                self.result.warnings.push(warning.clone());
            }
        }
        if let Some(unbalance) = body.unbalance {
            let name = format!("check.unbalance.{}", problem.name());
            self.result.scalars.push((name, unbalance, bellcrank_results::Unit::one()));
            if unbalance > UNBALANCED {
                self.result.warnings.push(format!(
                    "the loads of body `{}` are not in balance: {:.2} % of the largest is left over, and was balanced \
                     by inertia",
                    problem.name(),
                    100.0 * unbalance
                ));
            }
        }
        self.picture(fixed, solved, &body);
        self.files(fixed, solved, &body);
        let (form, loads) = (self.form, self.loads);
        let found = super::stress_finding(self.result, || bellcrank_results::Stress {
            of: loads.map_or_else(String::new, |loads| loads.of.name.clone()),
            hinges: loads.map_or_else(String::new, |_| form.hinges.name().to_owned()),
            accuracy: form.accuracy.map(|accuracy| accuracy.error),
            bodies: Vec::new(),
            unit: units.of(Measure::Stress),
            length: units.of(Measure::Length),
        });
        found.bodies.push(body);
    }

    /// Of the row with the largest stress.
    fn picture(&mut self, fixed: &Fixed<'_>, solved: &Solved, body: &StressBody) {
        let units = &self.asked.design.units;
        let (pressure, length) = (units.of(Measure::Stress), units.of(Measure::Length));
        let place = body.peak().map_or("", |spot| spot.place.as_str());
        let Some((solution, stress)) = solved.cases.get(fixed.shown(body)) else { return };
        let place = if place.is_empty() { body.place.as_str() } else { place };
        let at = if place.is_empty() { String::new() } else { format!(" at {place}") };
        let picture = Picture::new(&solved.mesh);
        let mut contour = picture.contour(format!("{}: stress{at}", body.body));
        let mut shape = picture.shape(String::new(), &solution.displacement, false);
        let singular = body.spots.iter().any(|spot| spot.singular.is_some());
        let ceiling = body.peak().filter(|_| singular).map(|spot| spot.value);
        shape.fields = pictures::fields(&picture, &solution.displacement, stress, [&pressure, &length], ceiling);
        contour.shapes.push(shape);
        contour.marks = body.spots.iter().map(|spot| pictures::mark(spot, &pressure)).collect();
        self.result.contours.push(contour);
    }

    /// Of the same row.
    fn files(&mut self, fixed: &Fixed<'_>, solved: &Solved, body: &StressBody) {
        let Some((solution, stress)) = solved.cases.get(fixed.shown(body)) else { return };
        if self.asked.meshes == MeshFormats::default() {
            return;
        }
        // It was made for the same mesh before.
        let Ok(setup) = fixed.problem.on(&solved.mesh, self.form.hinges) else { return };
        let written = Written { name: &body.body, part: &setup.part, solution, stress };
        self.result.attachments.extend(written.files(self.asked.meshes));
    }

    fn body(&self, fixed: &Fixed<'_>, solved: &Solved, meshes: Vec<MeshRow>) -> StressBody {
        let (problem, design) = (fixed.problem, self.asked.design);
        let mass = solved.mesh.mass_properties(problem.material.density);
        let (solid, material) = problem.names();
        let mut spots: Vec<_> = solved.spots.iter().map(|spot| spot.found.clone()).collect();
        for spot in &mut spots {
            let sure = fixed.strength.filter(|_| spot.singular.is_none() && spot.value > 0.0);
            spot.margin = sure.map(|strength| strength / spot.value - 1.0);
        }
        let row = |index: usize| problem.acting.rows.get(fixed.rows[index].0)?.as_ref();
        let left = |(index, (solution, _)): (usize, &(Solution, Stress))| {
            let relief = solution.relief.as_ref()?;
            Some(problem::unbalance(relief, row(index)?, &solved.mesh, mass.center, mass.mass))
        };
        let unbalance = solved.cases.iter().enumerate().take(fixed.rows.len()).filter_map(left).reduce(f64::max);
        let most = |of: &dyn Fn(&(Solution, Stress)) -> f64| solved.cases.iter().map(of).fold(0.0, f64::max);
        StressBody {
            body: design.bodies[problem.body].name.clone(),
            solid,
            material,
            strength: fixed.strength,
            place: if fixed.rows.len() == 1 { fixed.rows[0].1.clone() } else { String::new() },
            peak: spots::peak(&solved.spots),
            reached: self.form.accuracy.map(|accuracy| !self.is_off(solved, accuracy)),
            spots,
            meshes,
            mass: [mass.mass, problem.solid.mass(problem.material.density)],
            energy_error: most(&|(_, stress)| stress.relative_error()),
            unbalance,
            residual: most(&|(solution, _)| solution.residual),
            displacement: displacement(solved),
            effort: PartEffort { seconds: self.begun.elapsed().as_secs_f64(), ..solved.effort },
        }
    }
}

/// The solution of every row, or of the study's own loads alone.
fn cases(
    fixed: &Fixed<'_>,
    setup: &Setup<'_>,
    statics: &Statics<'_>,
    tell: &(dyn Fn(f64) -> bool + Sync),
) -> Result<Vec<(Solution, Stress)>, Vec<Fault>> {
    let acting = fixed.problem.acting;
    let rows = fixed.rows.iter().filter_map(|(row, _)| acting.rows.get(*row)?.as_ref());
    let mut loads: Vec<_> = rows.map(|row| setup.row(row, &acting.pins)).collect();
    if loads.is_empty() {
        loads.push(Vec::new());
    }
    let count = loads.len() as f64;
    let mut solved = Vec::with_capacity(loads.len());
    for (index, mut loads) in loads.into_iter().enumerate() {
        if !tell(0.8 + 0.2 * index as f64 / count) {
            return Err(vec![Fault::Interrupted]);
        }
        loads.extend(setup.own.iter().cloned());
        let solution = statics.solve(&loads)?;
        let stress = Stress::new(&setup.part, &solution);
        solved.push((solution, stress));
    }
    Ok(solved)
}

/// Sizes for the next mesh, at every place of this one.
fn wanted(solved: &Solved, fixed: &Fixed<'_>, accuracy: Accuracy) -> SizeField {
    let mesh = &solved.mesh;
    let sizes = element_sizes(mesh);
    let peak = spots::peak(&solved.spots).map_or(0.0, |index| solved.spots[index].found.value);
    // What each node may be off by, and what it is: the change from the mesh before counts at the hot spot itself.
    let mut reference = vec![peak; mesh.nodes.len()];
    let mut changed = vec![0.0_f64; mesh.nodes.len()];
    for spot in solved.spots.iter().filter(|spot| spot.found.singular.is_none()) {
        let own = spot.found.value.max(spots::LOW * peak);
        solved.regions[spot.region].nodes.iter().for_each(|&node| reference[node as usize] = own);
        changed[spot.node as usize] = spot.found.error;
    }
    let mut errors = vec![0.0_f64; sizes.len()];
    for (_, stress) in &solved.cases {
        let own = element_stress_errors(mesh, stress);
        errors.iter_mut().zip(own).for_each(|(error, own)| *error = error.max(own));
    }
    let elements = mesh.blocks.iter().flat_map(|block| block.elements());
    let mut allowed = Vec::with_capacity(sizes.len());
    for (error, nodes) in errors.iter_mut().zip(elements) {
        let doubtful = nodes.iter().any(|&node| fixed.doubtful.at(mesh.nodes[node as usize]).is_some());
        let change = nodes.iter().map(|&node| changed[node as usize]).fold(0.0, f64::max);
        *error = if doubtful { 0.0 } else { error.max(change) };
        let least = nodes.iter().map(|&node| reference[node as usize]).fold(f64::INFINITY, f64::min);
        allowed.push(AIM * accuracy.error * least);
    }
    SizeField::new(mesh, &wanted_sizes(&sizes, &errors, &allowed, ORDER))
}

fn mesh_row(solved: &Solved) -> MeshRow {
    let peak = spots::peak(&solved.spots).map_or(f64::NAN, |index| solved.spots[index].found.value);
    MeshRow { peak, error: spots::worst_error(&solved.spots), ..super::meshing::row(&solved.mesh) }
}

fn displacement(solved: &Solved) -> (f64, V3) {
    let all = solved.cases.iter().flat_map(|(solution, _)| solution.displacement.iter().zip(&solved.mesh.nodes));
    all.fold((0.0, [0.0; 3]), |most, (u, at)| if norm(*u) > most.0 { (norm(*u), *at) } else { most })
}

impl Loads<'_> {
    fn row(&self, row: usize) -> Result<usize, End> {
        let count = self.rows.table.rows();
        if row < count {
            return Ok(row);
        }
        let message = format!("`at` asks for row {row} of study `{}`, which has {count}", self.of.name);
        Err(ended(message, format!("rows count from 0 to {}", count.saturating_sub(1))))
    }

    /// The row in which a signal comes nearest to a value.
    fn nearest(&self, signal: &str, value: f64) -> Result<usize, End> {
        let Some(column) = self.rows.table.column(signal) else {
            let message = format!("`at` asks for `{signal}`, which study `{}` does not tell", self.of.name);
            return Err(ended(message, ""));
        };
        let known = column.values.iter().enumerate().filter(|(_, x)| x.is_finite());
        let nearest = known.min_by(|a, b| (a.1 - value).abs().total_cmp(&(b.1 - value).abs()));
        nearest.map(|(row, _)| row).ok_or_else(|| self.nothing())
    }

    /// A row in words.
    fn place(&self, asked: &Asked<'_>, row: usize) -> String {
        let column = self.rows.axis.first().and_then(|axis| self.rows.table.column(axis));
        let value = column.and_then(|column| column.values.get(row).copied());
        value.map_or_else(String::new, |value| Places::new(asked.design, self.of).at(value))
    }

    fn nothing(&self) -> End {
        let message = format!("study `{}` has no forces in the row that counts", self.of.name);
        Box::new(bellcrank_results::Failure { message, hints: self.rows.warnings.clone() })
    }
}
