//! What stands at the end of the file: its columns, its groups, and the units.

use serde_json::{Map, Value, json};

use super::super::{RowColumn, RowKind};
use super::chunk::{Chunks, Statistics};
use super::thrift::Struct;

const VERSION: i32 = 1;
const REQUIRED: i32 = 0;
const OPTIONAL: i32 = 1;
const INT64: i32 = 2;
const DOUBLE: i32 = 5;
const BYTE_ARRAY: i32 = 6;
const UTF8: i32 = 0;
const PLAIN: i32 = 0;
const RLE: i32 = 3;
const UNCOMPRESSED: i32 = 0;

/// Rows that were written together.
pub(super) struct Group {
    pub(super) rows: u64,
    pub(super) start: u64,
    pub(super) bytes: u64,
    pub(super) chunks: Vec<Chunks>,
}

/// The `FileMetaData` structure.
pub(super) fn footer(columns: &[RowColumn], words: Option<&str>, groups: &[Group]) -> Vec<u8> {
    let mut names: Vec<(&str, i32)> = columns.iter().map(|column| (column.name.as_str(), kind(column))).collect();
    names.extend(words.map(|words| (words, BYTE_ARRAY)));
    let rows = groups.iter().map(|group| group.rows).sum();
    let by_type = || Struct::default().structure(1, Struct::default());
    Struct::default()
        .i32(1, VERSION)
        .structures(2, schema(&names))
        .i64(3, rows)
        .structures(4, groups.iter().map(|group| of_group(group, &names)).collect())
        .structures(5, vec![Struct::default().binary(1, b"bellcrank.units").binary(2, units(columns).as_bytes())])
        .binary(6, b"bellcrank")
        .structures(7, names.iter().map(|_| by_type()).collect())
        .finish()
}

fn kind(column: &RowColumn) -> i32 {
    match column.kind {
        RowKind::Count => INT64,
        RowKind::Number(_) => DOUBLE,
    }
}

/// The root, then the columns.
fn schema(names: &[(&str, i32)]) -> Vec<Struct> {
    let root = Struct::default().binary(4, b"designs").i32(5, names.len() as i32);
    let leaf = |(name, kind): &(&str, i32)| {
        let repetition = if *kind == INT64 { REQUIRED } else { OPTIONAL };
        let leaf = Struct::default().i32(1, *kind).i32(3, repetition).binary(4, name.as_bytes());
        if *kind == BYTE_ARRAY {
            leaf.i32(6, UTF8).structure(10, Struct::default().structure(1, Struct::default()))
        } else {
            leaf
        }
    };
    [root].into_iter().chain(names.iter().map(leaf)).collect()
}

/// Units by column, those of pure numbers empty.
fn units(columns: &[RowColumn]) -> String {
    let unit = |column: &RowColumn| (column.name.clone(), json!(column.unit()));
    Value::Object(columns.iter().map(unit).collect::<Map<_, _>>()).to_string()
}

fn of_group(group: &Group, names: &[(&str, i32)]) -> Struct {
    let chunks = group.chunks.iter().zip(names).map(|(chunk, (name, kind))| of_chunk(chunk, name, *kind));
    Struct::default()
        .structures(1, chunks.collect())
        .i64(2, group.bytes)
        .i64(3, group.rows)
        .i64(5, group.start)
        .i64(6, group.bytes)
}

fn of_chunk(chunk: &Chunks, name: &str, kind: i32) -> Struct {
    let meta = Struct::default()
        .i32(1, kind)
        .i32s(2, &[PLAIN, RLE])
        .strings(3, &[name])
        .i32(4, UNCOMPRESSED)
        .i64(5, chunk.rows)
        .i64(6, chunk.bytes)
        .i64(7, chunk.bytes)
        .i64(9, chunk.start)
        .structure(12, statistics(&chunk.statistics));
    Struct::default().i64(2, chunk.start).structure(3, meta)
}

fn statistics(of: &Statistics) -> Struct {
    let counted = Struct::default().i64(3, of.nulls);
    match &of.span {
        Some((low, high)) => counted.binary(5, high).binary(6, low),
        None => counted,
    }
}
