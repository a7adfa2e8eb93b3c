//! Exact derivatives all the way from parameters to numbers, against differences.

mod everything;
mod flat;
mod solved;
mod wave;

use std::path::{Path, PathBuf};

use bellcrank_math::Real;
use bellcrank_multibody::{Coordinate, SEEDS, Seeded};

use crate::Model;
use crate::build::{self, Built};
use crate::design::{Design, Values};
use crate::motion::{Programme, Schedule};
use crate::run::inputs::{Evaluated, Inputs};
use crate::scalar::Scalar;
use crate::signals::{Level, MOST, Source, View};

/// Instants off the joints of the laws.
const TIMES: [f64; 6] = [0.0317, 0.1713, 0.3371, 0.4789, 0.7193, 1.0811];

/// Where the numbers of a model are asked for: parameters of the main file, and a shift of time.
struct At<'a, T> {
    fixed: &'a [(usize, T)],
    shift: T,
}

/// Every number that comes out of a model.
fn numbers<T: Scalar>(design: &Design, at: &At<'_, T>) -> Vec<T> {
    let mut values = Values::new(&design.scopes, &design.scopes[0].parameters);
    let mut built = build::build(design, &values, &mut Vec::new()).expect("a model");
    values.update(&design.scopes, &design.scopes[0].parameters, at.fixed);
    // A massless body may get a negative mass by a difference: what is reported does not matter here.
    build::rebuild(design, &values, &mut built, &mut Vec::new());
    let mut all = flat::numbers(&built);
    motions(design, &values, &built, at.shift, &mut all);
    signals(design, &values, &built, at.shift, &mut all);
    all
}

/// The signals and the inputs of a position that moves with time.
fn signals<T: Scalar>(design: &Design, values: &Values<T>, built: &Built<T>, time: T, all: &mut Vec<T>) {
    let (catalogue, geometry) = (&design.catalogue, &built.geometry);
    let efforts: Vec<Coordinate> = catalogue.sources().iter().filter_map(drive).collect();
    let readings = &wave::Wave(time);
    let view = View { readings, catalogue, geometry, efforts: &efforts, level: Level::Force };
    let mut answers = [T::zero(); MOST];
    for &source in catalogue.sources() {
        view.read(source, &mut answers);
        all.extend(&answers[..catalogue.columns(source).len()]);
    }
    let mut inputs = vec![T::zero(); design.inputs.len()];
    Inputs::new(design).evaluate(readings, Evaluated { design, values, geometry }, &mut inputs);
    all.extend(inputs);
}

fn drive(source: &Source) -> Option<Coordinate> {
    match source {
        Source::Drive(c) => Some(*c),
        _ => None,
    }
}

fn motions<T: Scalar>(design: &Design, values: &Values<T>, built: &Built<T>, shift: T, all: &mut Vec<T>) {
    let schedule = Schedule::new(design, values);
    let start = |c: Coordinate| built.blueprint.joints[c.joint.0].start.get(c.index).copied().flatten();
    let from = |c| start(c).unwrap_or(T::zero());
    // One by one: a file may have several of one joint that are not meant to act together.
    for motion in 0..design.motions.len() {
        let programme = Programme::new(design, &[motion], &schedule, values, &from);
        for (track, time) in programme.tracks.iter().flat_map(|track| TIMES.map(|time| (track, time))) {
            let jet = track.at(T::from_f64(time) + shift);
            all.extend([jet.value, jet.first, jet.second]);
        }
    }
}

/// The numbers with parameter `i` set; beyond the last parameter it is time that moves.
fn moved(design: &Design, i: usize, value: f64) -> Vec<f64> {
    let time = i == design.scopes[0].parameters.all().len();
    let fixed = [(i, value)];
    numbers(design, &At { fixed: if time { &[] } else { &fixed }, shift: if time { value } else { 0.0 } })
}

/// The numbers with a parameter seeded (time beyond the last).
fn seeded(design: &Design, i: usize, value: f64) -> Vec<Seeded> {
    let time = i == design.scopes[0].parameters.all().len();
    let seed = Seeded::variable(value, i % SEEDS);
    let fixed = [(i, seed)];
    numbers(design, &At { fixed: if time { &[] } else { &fixed }, shift: if time { seed } else { Seeded::zero() } })
}

fn step(value: f64) -> f64 {
    2e-4 * if value == 0.0 { 1.0 } else { value.abs() }
}

/// Differences of the fourth order.
fn differences(design: &Design, i: usize, value: f64) -> Vec<f64> {
    let h = step(value);
    let [a, b, c, d] = [-2.0, -1.0, 1.0, 2.0].map(|k| moved(design, i, value + k * h));
    (0..a.len()).map(|k| (8.0 * (c[k] - b[k]) - (d[k] - a[k])) / (12.0 * h)).collect()
}

/// Asserts that all derivatives are those of differences, and counts those that are not zero: by each parameter, and
/// by time.
fn check(name: &str, model: &Model) -> Vec<usize> {
    let design = model.design();
    let parameters = &design.scopes[0].parameters;
    let plain = numbers(design, &At { fixed: &[], shift: 0.0 });
    let by = |i: usize| {
        let value = parameters.values().get(i).copied().unwrap_or(0.0);
        let of = parameters.all().get(i).map_or("time", |parameter| &parameter.name);
        let exact = seeded(design, i, value);
        // Stress of a body that is rigid here is no number.
        let same = |(x, y): (&Seeded, &f64)| x.re == *y || x.re.is_nan() && y.is_nan();
        assert!(exact.iter().zip(&plain).all(same), "{name}, {of}: other values with derivatives");
        let slopes = exact.iter().map(|x| x.eps[i % SEEDS]);
        for (k, (slope, difference)) in slopes.clone().zip(differences(design, i, value)).enumerate() {
            if plain[k].is_nan() {
                continue;
            }
            // Centres and products of symmetric solids are nothing but rounding, which a small step makes large.
            let slack = 1e-7 * slope.abs().max(plain[k].abs() * 1e-3) + 2e-15 / step(value);
            assert!((slope - difference).abs() <= slack, "{name}, {of}, number {k}: {slope} against {difference}");
        }
        slopes.filter(|slope| *slope != 0.0).count()
    };
    (0..=parameters.all().len()).map(by).collect()
}

fn loaded(path: &Path) -> Model {
    let loaded = crate::load(path, &[]);
    let told = loaded.diagnostics.render(&loaded.sources, false);
    loaded.model.unwrap_or_else(|| panic!("{}: {told}", path.display()))
}

/// The models below a folder: every TOML file but those with expected numbers.
fn models(folder: &str) -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("../..").join(folder);
    let inside = |path: &Path| std::fs::read_dir(path).expect("a folder").map(|entry| entry.expect("an entry").path());
    let machines = inside(&folder).filter(|path| path.is_dir()).flat_map(|path| inside(&path).collect::<Vec<_>>());
    let is_model = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        name.ends_with(".toml") && !name.ends_with("expected.toml") && name != "reference.toml"
    };
    let mut all: Vec<PathBuf> = machines.filter(is_model).collect();
    all.sort();
    all
}

#[test]
fn every_machine_has_the_derivatives_of_its_differences() {
    let paths: Vec<PathBuf> = ["models", "verify/cases"].into_iter().flat_map(models).collect();
    assert!(paths.len() > 40, "{}", paths.len());
    let found: usize = paths.iter().flat_map(|path| check(&path.display().to_string(), &loaded(path))).sum();
    assert!(found > 1000, "{found} derivatives");
}

#[test]
fn every_place_for_a_number_takes_derivatives() {
    let found = check("everything", &everything::model());
    let lost: Vec<usize> = (0..found.len()).filter(|&i| found[i] == 0).collect();
    // The smaller one of a `max`.
    assert_eq!(lost, [34], "parameters without any derivative");
}
