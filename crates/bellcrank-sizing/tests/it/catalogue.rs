//! The built-in catalogues have the shape they tell of, and hold what the standards say.

use bellcrank_sizing::catalogue::{ALL, ELECTRIC_LINEAR, ELECTRIC_ROTARY, ISO_6432, ISO_15552};
use bellcrank_sizing::electric::{self, Drive, Gear, Kind};
use bellcrank_sizing::pneumatic::{self, Conditions, Cylinder, EndCondition, Mount, Mounting, Supply};
use bellcrank_sizing::{Duty, Row};
use toml_edit::{Document, Item, Table};

use crate::near;

const CYLINDER_KEYS: [&str; 12] = [
    "standard",
    "bore",
    "rod",
    "strokes",
    "max_stroke",
    "max_pressure",
    "max_speed",
    "cushion_energy",
    "moving_mass",
    "moving_mass_per_stroke",
    "base_length",
    "youngs_modulus",
];
const DRIVE_KEYS: [&str; 15] = [
    "kind",
    "rated_force",
    "peak_force",
    "rated_torque",
    "peak_torque",
    "max_speed",
    "knee_speed",
    "rated_power",
    "peak_power",
    "strokes",
    "max_stroke",
    "moving_mass",
    "inertia",
    "gear_ratio",
    "gear_efficiency",
];

fn table<'t>(document: &'t Table, name: &str) -> &'t Table {
    document.get(name).and_then(Item::as_table).unwrap_or_else(|| panic!("no table `{name}`"))
}

/// An entry with what its series gives it.
fn entries(text: &str, group: &str) -> Vec<(String, Table)> {
    let document: Document<&str> = Document::parse(text).unwrap();
    let series = table(&document, "series");
    let whole = |(name, item): (&str, &Item)| {
        let own = item.as_table().unwrap();
        let mut all = table(series, own["series"].as_str().unwrap()).clone();
        own.iter().filter(|(key, _)| *key != "series").for_each(|(key, item)| {
            all.insert(key, item.clone());
        });
        (name.to_owned(), all)
    };
    table(&document, group).iter().map(whole).collect()
}

/// SI value of `"63 mm"`, or of a pure number.
fn si(item: &Item) -> f64 {
    let Some(text) = item.as_str() else {
        return item.as_float().or(item.as_integer().map(|i| i as f64)).expect("a number");
    };
    let (number, unit) = text.split_once(' ').expect("a number and a unit");
    let units = [("mm", 1e-3), ("bar", 1e5), ("N", 1.0), ("N*m", 1.0), ("W", 1.0), ("mm/s", 1e-3), ("J", 1.0)];
    let rpm = ("rpm", std::f64::consts::PI / 30.0);
    let unit = units.into_iter().chain([rpm]).find(|(symbol, _)| *symbol == unit).expect("a known unit");
    number.parse::<f64>().unwrap() * unit.1
}

fn list(table: &Table, key: &str) -> Vec<f64> {
    let all = table.get(key).and_then(Item::as_array);
    all.map_or(vec![], |all| all.iter().map(|value| si(&Item::Value(value.clone()))).collect())
}

fn cylinders(text: &str) -> Vec<Cylinder> {
    let read = |(name, table): (String, Table)| Cylinder {
        name,
        standard: table["standard"].as_str().unwrap().to_owned(),
        bore: si(&table["bore"]),
        rod: si(&table["rod"]),
        strokes: list(&table, "strokes"),
        max_stroke: table.get("max_stroke").map(si),
        max_pressure: table.get("max_pressure").map(si),
        ..Cylinder::bare()
    };
    entries(text, "cylinders").into_iter().map(read).collect()
}

fn drives(text: &str) -> Vec<Drive> {
    let read = |(name, table): (String, Table)| {
        let linear = table["kind"].as_str() == Some("linear");
        let (kind, effort) = if linear { (Kind::Linear, "force") } else { (Kind::Rotary, "torque") };
        let of = |prefix| si(&table[&format!("{prefix}_{effort}")]);
        let gear =
            table.get("gear_ratio").map(|ratio| Gear { ratio: si(ratio), efficiency: si(&table["gear_efficiency"]) });
        Drive {
            name,
            knee_speed: table.get("knee_speed").map(si),
            rated_power: table.get("rated_power").map(si),
            strokes: list(&table, "strokes"),
            gear,
            ..Drive::bare(kind, of("rated"), of("peak"), si(&table["max_speed"]))
        }
    };
    entries(text, "drives").into_iter().map(read).collect()
}

#[test]
fn only_known_keys_and_every_number_with_a_unit() {
    for (name, text) in ALL {
        let (group, known): (_, &[&str]) =
            if name.starts_with("iso") { ("cylinders", &CYLINDER_KEYS) } else { ("drives", &DRIVE_KEYS) };
        for (entry, table) in entries(text, group) {
            for (key, item) in &table {
                assert!(known.contains(&key), "{name}: `{entry}` has `{key}`");
                let pure = ["standard", "kind", "strokes", "gear_ratio", "gear_efficiency"].contains(&key);
                assert!(pure || item.as_str().is_some() && si(item) > 0.0, "{name}: `{entry}`, `{key}`");
            }
        }
    }
}

/// Verification case P2_iso15552, and Pneumax' table for ISO 6432.
#[test]
fn bores_and_rods_of_the_standards() {
    let found = |text| -> Vec<(f64, f64)> { cylinders(text).iter().map(|c| (mm(c.bore), mm(c.rod))).collect() };
    let bores = [32., 40., 50., 63., 80., 100., 125., 160., 200., 250., 320.];
    let rods = [12., 16., 20., 20., 25., 25., 32., 40., 40., 50., 63.];
    assert_eq!(found(ISO_15552), bores.into_iter().zip(rods).collect::<Vec<_>>());
    assert_eq!(found(ISO_6432), [(8., 4.), (10., 4.), (12., 6.), (16., 6.), (20., 8.), (25., 10.)]);
    let parker = [25., 40., 50., 80., 100., 125., 160., 200., 250., 320., 400., 500., 600., 700., 800.];
    for cylinder in cylinders(ISO_15552) {
        assert_eq!(cylinder.strokes.iter().copied().map(mm).collect::<Vec<_>>(), parker);
    }
}

fn mm(metres: f64) -> f64 {
    (metres * 1e3).round()
}

/// What the page on buckling says: 26 MPa at most, so Euler's formula needs no help for short rods.
#[test]
fn rods_carry_at_most_26_megapascal() {
    let all = [cylinders(ISO_15552), cylinders(ISO_6432)].concat();
    let stress = all.iter().map(|c| 1e6 * (c.bore / c.rod).powi(2)).fold(0.0, f64::max);
    near(stress, 25.8e6, 1e-3);
}

#[test]
fn every_entry_can_be_judged() {
    let row = |position, effort| Row { position, effort, velocity: 0.02, acceleration: 0.0, time: None };
    let lift = Duty::new(vec![row(-0.079648, 4844.52), row(0.0, 4750.0), row(0.080283, 4680.32)]).unwrap();
    let mounting = Mounting { end: EndCondition::PinnedPinned, at: Mount::Rear, offset: 0.1 };
    let all = [cylinders(ISO_6432), cylinders(ISO_15552)].concat();
    let found = pneumatic::select(&lift, &all, &Conditions::new(Supply::gauge(6e5), 0.7, mounting)).unwrap();
    assert_eq!((found.candidates.len(), found.chosen().unwrap().cylinder.name.as_str()), (17, "iso15552-125"));
    let safe = electric::Conditions::new(1.0);
    let found = electric::select(&lift, Kind::Linear, &drives(ELECTRIC_LINEAR), &safe).unwrap();
    assert_eq!(found.chosen().unwrap().drive.name, "generic-linear-6300N");
    let found = electric::select(&lift, Kind::Rotary, &drives(ELECTRIC_ROTARY), &safe).unwrap();
    assert_eq!(found.candidates.len(), 30);
}

/// The rules that the files of generic sizes tell.
#[test]
fn generic_sizes_follow_their_rule() {
    for drive in drives(ELECTRIC_LINEAR) {
        near(drive.rated_power.unwrap(), drive.rated_effort * drive.max_speed, 1e-12);
        near(drive.peak_effort, 2.0 * drive.rated_effort, 1e-12);
    }
    for drive in drives(ELECTRIC_ROTARY) {
        near(drive.rated_effort * drive.knee_speed.unwrap(), drive.rated_power.unwrap(), 5e-3);
        near(drive.peak_effort, 3.0 * drive.rated_effort, 1e-12);
    }
}
