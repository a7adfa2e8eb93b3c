use super::*;

fn column(name: &str, unit: Unit, values: &[f64]) -> Column {
    Column { name: name.to_owned(), unit, values: values.to_vec() }
}

fn csv(columns: Vec<Column>) -> String {
    let mut out = Vec::new();
    write_csv(&Table { columns }, &mut out).unwrap();
    String::from_utf8(out).unwrap()
}

#[test]
fn numbers_are_shown_in_their_units() {
    let text = csv(vec![
        column("time", Unit::new("s", 1.0), &[0.0, 0.1]),
        column("joint.B.position", Unit::new("mm", 0.001), &[-0.25, 1e-9]),
        column("ratio", Unit::one(), &[1.5, -0.0]),
    ]);
    assert_eq!(text, "time [s],joint.B.position [mm],ratio\n0,-250,1.5\n0.1,1e-6,-0\n");
}

#[test]
fn undefined_numbers_leave_empty_cells() {
    let text = csv(vec![
        column("a", Unit::one(), &[f64::NAN, 1.0]),
        column("b", Unit::one(), &[f64::INFINITY, f64::NEG_INFINITY]),
    ]);
    assert_eq!(text, "a,b\n,\n1,\n");
}

#[test]
fn awkward_names_are_quoted() {
    let text = csv(vec![
        column("a,b", Unit::one(), &[]),
        column("say \"x\"", Unit::new("m", 1.0), &[]),
        column("line\nbreak", Unit::one(), &[]),
    ]);
    assert_eq!(text, "\"a,b\",\"say \"\"x\"\" [m]\",\"line\nbreak\"\n");
}

#[test]
fn a_table_without_columns_is_empty() {
    assert_eq!(csv(Vec::new()), "");
}

#[test]
fn numbers_read_back_exactly() {
    let values = [std::f64::consts::PI, 1.0 / 3.0, 6.02e23, -5e-324, 6_473.606_158];
    let text = csv(vec![column("x", Unit::one(), &values)]);
    let read: Vec<f64> = text.lines().skip(1).map(|line| line.parse().unwrap()).collect();
    assert_eq!(read, values);
}

#[test]
fn large_tables_are_written_whole() {
    let values: Vec<f64> = (0..50_000).map(|row| f64::from(row) / 7.0).collect();
    let text = csv(vec![column("x", Unit::one(), &values)]);
    assert_eq!(text.lines().count(), 50_001);
    assert_eq!(text.lines().last().unwrap().parse::<f64>().unwrap(), 49_999.0 / 7.0);
}
