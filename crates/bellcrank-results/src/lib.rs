//! Result columns with names and units, findings, the drawing, and their CSV, JSON, Parquet and glTF writers.
//!
//! Everything in here is plain data in SI units; a [`Unit`] says how a number is shown.
//! No mechanics: what is stored was computed elsewhere.

mod cells;
mod contour;
mod convergence;
mod csv;
mod drawing;
mod events;
mod finding_tables;
mod findings;
mod folders;
mod gltf;
mod motion;
mod programme;
mod reductions;
mod rows;
mod run;
mod solid;
mod study;
mod summary;
mod table;
mod unit;
mod vtu;

pub use cells::{Field, TextTable, write_text_csv};
pub use contour::{Contour, ContourField, ContourMark, ContourShape};
pub use convergence::{Convergence, Ladder, Over, Rung, Watched};
pub use csv::{heading, write_csv};
pub use drawing::{Animation, Arrow, Drawing, DrawnBody, DrawnJoint, Pose, SpaceKind, Surface};
pub use events::{Ended, Event, EventKind, Events};
pub use finding_tables::{event_table, finding_tables, flexible_tables};
pub use findings::*;
pub use folders::{file_stems, study_folders};
pub use gltf::{upright, write_glb};
pub use motion::{FlexibleMotion, MotionMark};
pub use programme::{Move, Programme};
pub use reductions::{Extreme, Reductions};
pub use rows::{CsvRows, ParquetRows, RowColumn, RowKind, RowWriter, write_parquet};
pub use run::{ParameterRow, Provenance, RunResult};
pub use solid::{Paint, Shape, Solid, solids};
pub use study::{Attachment, Failure, Reaction, StudyResult};
pub use summary::{moves, run_summary, study_summary};
pub use table::{Column, Table};
pub use unit::Unit;
pub use vtu::{PvdEntry, write_pvd, write_vtu_row};
