//! Catalogues that are good.

use bellcrank_doc::{Diagnostics, Sources};
use bellcrank_sizing::electric::Kind;

use super::{Stock, stock};

fn read(text: &str) -> Stock {
    let (mut sources, mut diagnostics) = (Sources::new(), Diagnostics::new());
    let id = sources.add("mine.toml", text);
    let found = stock(&sources, id, &mut diagnostics);
    found.unwrap_or_else(|| panic!("{}", diagnostics.render(&sources, false)))
}

#[test]
fn the_built_in_catalogues_are_read() {
    let stock = Stock::builtin();
    let of = |kind| stock.drives.iter().filter(|drive| drive.kind == kind).count();
    assert_eq!((stock.cylinders.len(), of(Kind::Linear), of(Kind::Rotary)), (17, 13, 30));
    let found = stock.cylinders.iter().find(|cylinder| cylinder.name == "iso15552-63").expect("a bore of 63 mm");
    assert_eq!((found.bore, found.rod, found.max_pressure), (0.063, 0.02, Some(1e6)));
    assert_eq!((found.strokes.len(), found.strokes[6], found.standard.as_str()), (15, 0.16, "ISO 15552"));
    let servo = stock.drives.iter().find(|drive| drive.name == "generic-servo-750W").expect("a motor");
    assert_eq!((servo.rated_effort, servo.rated_power, servo.gear), (2.39, Some(750.0), None));
}

#[test]
fn entries_of_one_name_take_the_place_of_built_in_ones() {
    let mine = read(
        "[series.s]\nkind = \"rotary\"\nmax_speed = \"1200 rpm\"\n\
         [cylinders.iso15552-63]\nbore = \"63 mm\"\nrod = 0\nmax_stroke = \"1 m\"\nmoving_mass_per_stroke = \"2.5 g/mm\"\n\
         [drives.own]\nseries = \"s\"\nrated_torque = \"2 N*m\"\npeak_torque = \"0.005 kN*m\"\nmax_speed = \"600 rpm\"\n\
         gear_ratio = 12.5\nstrokes = [\"90 deg\"]\ninertia = \"3 kg*cm^2\"\n",
    );
    let mut all = Stock::builtin().clone();
    all.add(mine);
    assert_eq!((all.cylinders.len(), all.drives.len()), (17, 44));
    let found = all.cylinders.last().expect("the new one");
    assert_eq!((found.name.as_str(), found.rod, found.moving_mass_per_stroke), ("iso15552-63", 0.0, Some(2.5)));
    assert_eq!((found.max_stroke, found.max_pressure, found.standard.as_str()), (Some(1.0), None, ""));
    let own = all.drives.last().expect("the new one");
    let gear = own.gear.expect("a gear");
    assert_eq!((own.kind, gear.ratio, gear.efficiency, own.inertia), (Kind::Rotary, 12.5, 1.0, Some(3e-4)));
    assert!((own.max_speed - 20.0 * std::f64::consts::PI).abs() < 1e-12);
}
