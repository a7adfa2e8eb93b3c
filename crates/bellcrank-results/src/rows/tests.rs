use super::*;

fn columns() -> Vec<RowColumn> {
    vec![
        RowColumn { name: "design".to_owned(), kind: RowKind::Count },
        RowColumn { name: "l31".to_owned(), kind: RowKind::Number(Unit::new("mm", 1e-3)) },
        RowColumn { name: "max(abs(drive.slide.force))".to_owned(), kind: RowKind::Number(Unit::new("N", 1.0)) },
    ]
}

fn push_all(file: &mut dyn RowWriter) {
    file.push(&[0.0, 0.732, 6473.6], "").unwrap();
    file.push(&[1.0, 0.615, f64::NAN], "cannot be assembled, twice").unwrap();
    file.push(&[2.0, 0.6], "").unwrap();
    file.finish().unwrap();
}

#[test]
fn csv_rows_are_lines() {
    let mut out = Vec::new();
    push_all(&mut CsvRows::new(&mut out, columns(), "reason"));
    let expected = "design,l31 [mm],max(abs(drive.slide.force)) [N],reason\n\
        0,732,6473.6,\n1,615,,\"cannot be assembled, twice\"\n2,600,,\n";
    assert_eq!(String::from_utf8(out).unwrap(), expected);
}

#[test]
fn csv_rows_can_be_continued() {
    let mut out = b"design,reason\n0,\n".to_vec();
    let mut file = CsvRows::continued(&mut out, columns()[..1].to_vec());
    file.push(&[1.0], "").unwrap();
    file.finish().unwrap();
    assert_eq!(String::from_utf8(out).unwrap(), "design,reason\n0,\n1,\n");
}

/// A checksum as simple as can be: FNV-1a.
fn fingerprint(bytes: &[u8]) -> u64 {
    bytes.iter().fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(*byte)).wrapping_mul(0x0100_0000_01b3))
}

/// Of the file that pyarrow 26.0.1, DuckDB 2.0.0 and polars 2.1.0 read back as it was written.
const READ_BY_OTHERS: u64 = 12_701_215_835_123_894_575;

#[test]
fn parquet_rows_are_those_that_other_programs_read() {
    let mut out = Vec::new();
    push_all(&mut ParquetRows::new(&mut out, columns(), Some("reason")).unwrap());
    assert_eq!((&out[..4], &out[out.len() - 4..]), (&b"PAR1"[..], &b"PAR1"[..]));
    let length = u32::from_le_bytes(out[out.len() - 8..out.len() - 4].try_into().unwrap()) as usize;
    let footer = &out[out.len() - 8 - length..out.len() - 8];
    let units = br#"{"design":"","l31":"mm","max(abs(drive.slide.force))":"N"}"#;
    assert!(footer.windows(units.len()).any(|window| window == units));
    assert!(out.windows(8).any(|window| window == 732.0_f64.to_le_bytes()));
    assert_eq!(fingerprint(&out), READ_BY_OTHERS);
}

#[test]
fn many_rows_go_out_in_groups() {
    let mut out = Vec::new();
    let mut file = ParquetRows::new(&mut out, columns(), Some("reason")).unwrap();
    for row in 0..70_000 {
        file.push(&[f64::from(row), 0.5, 1.0], "").unwrap();
    }
    file.finish().unwrap();
    assert!((70_000 * 24..70_000 * 24 + 2_000).contains(&out.len()), "{}", out.len());
}

#[test]
fn a_file_without_rows_ends_as_it_should() {
    let mut out = Vec::new();
    ParquetRows::new(&mut out, columns(), Some("reason")).unwrap().finish().unwrap();
    assert!(out.ends_with(b"PAR1"));
}

#[test]
fn a_table_keeps_its_headings_and_numbers() {
    let column = |name: &str, symbol: &str, factor: f64, values: [f64; 3]| crate::Column {
        name: name.to_owned(),
        unit: Unit::new(symbol, factor),
        values: values.to_vec(),
    };
    let columns = vec![
        column("time", "s", 1.0, [0.0, 0.125, 0.25]),
        column("joint.A.position", "mm", 1e-3, [0.732, f64::NAN, 0.7]),
    ];
    let mut out = Vec::new();
    write_parquet(&crate::Table { columns }, &mut out).unwrap();
    let holds = |bytes: &[u8]| out.windows(bytes.len()).any(|window| window == bytes);
    assert!(holds(b"joint.A.position [mm]") && holds(br#"{"time [s]":"s","joint.A.position [mm]":"mm"}"#));
    assert!(holds(&732.0_f64.to_le_bytes()) && !holds(b"reason"));
    let mut none = Vec::new();
    write_parquet(&crate::Table::default(), &mut none).unwrap();
    assert!(none.is_empty());
}
