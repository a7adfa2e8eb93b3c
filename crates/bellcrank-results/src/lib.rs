//! Result columns with names and units, and their CSV and JSON writers.
