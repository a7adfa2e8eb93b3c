//! The report as its readers get it: page, files and terminal text of made-up runs.

#![allow(missing_docs, unreachable_pub, reason = "helpers of a test binary")]

mod files;
mod flexible;
mod forward;
mod html;
mod kinds;
mod markup;
mod pictures;
mod sample;
mod solid;
mod terminal;
