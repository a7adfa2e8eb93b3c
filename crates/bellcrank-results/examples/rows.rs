//! Writes made-up designs as CSV and Parquet and says how long that took: `cargo run --release -p
//! bellcrank-results --example rows -- DIR ROWS`.

use std::fs::File;
use std::io::{BufWriter, Result};
use std::path::Path;
use std::time::Instant;

use bellcrank_results::{CsvRows, ParquetRows, RowColumn, RowKind, RowWriter, Unit};

const NUMBERS: usize = 20;

fn main() -> Result<()> {
    let mut given = std::env::args().skip(1);
    let dir = given.next().unwrap_or_else(|| ".".to_owned());
    let rows: u64 = given.next().and_then(|text| text.parse().ok()).unwrap_or(1_000_000);
    let dir = Path::new(&dir);
    let create = |name: &str| File::create(dir.join(name)).map(BufWriter::new);
    timed("csv", rows, &mut CsvRows::new(create("designs.csv")?, columns(), "reason"))?;
    timed("parquet", rows, &mut ParquetRows::new(create("designs.parquet")?, columns(), Some("reason"))?)
}

fn columns() -> Vec<RowColumn> {
    let number = |index| RowColumn { name: format!("p{index}"), kind: RowKind::Number(Unit::new("mm", 1e-3)) };
    let design = RowColumn { name: "design".to_owned(), kind: RowKind::Count };
    [design].into_iter().chain((0..NUMBERS).map(number)).collect()
}

fn timed(name: &str, rows: u64, file: &mut dyn RowWriter) -> Result<()> {
    let start = Instant::now();
    let mut row = vec![0.0; NUMBERS + 1];
    for design in 0..rows {
        row[0] = design as f64;
        for (index, value) in row[1..].iter_mut().enumerate() {
            *value = ((design * 31 + index as u64) as f64 * 0.618_033_988_749_895).fract();
        }
        let failed = design % 97 == 5;
        if failed {
            row[NUMBERS] = f64::NAN;
        }
        file.push(&row, if failed { "cannot be assembled" } else { "" })?;
    }
    file.finish()?;
    let seconds = start.elapsed().as_secs_f64();
    println!("{name}: {rows} rows of {NUMBERS} numbers in {seconds:.2} s, {:.0} rows/s", rows as f64 / seconds);
    Ok(())
}
