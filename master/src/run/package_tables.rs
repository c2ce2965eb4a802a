//! The series of a package's run.

use std::path::Path;

use super::observe_error::ObserveError;
use super::output_table::{OutputTable, table_name};
use super::recorder::Recorder;
use super::train_tables::PART_S;
use crate::system::step::System;

/// Begins the series of a system in `folder`, with a record every so many steps: a table for each
/// component with all its outputs that are numbers.
///
/// # Errors
/// When the folder cannot be written.
pub fn recorder(system: &System, every: u64, folder: &Path) -> Result<Recorder, ObserveError> {
    let interval = every as f64 * system.clock.length;
    let per_part = (PART_S / interval).ceil() as usize;
    let mut recorder = Recorder { every, ..Recorder::default() };
    for (number, part) in system.parts.iter().enumerate() {
        let Some(name) = table_name(part.unit.as_ref()) else { continue };
        let series = (folder, name.as_str(), per_part);
        let table = OutputTable::create(series, vec![], system, &[number], |_| true)?;
        recorder.outputs.extend(table);
    }
    Ok(recorder)
}
