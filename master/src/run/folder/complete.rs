//! The results of a run that has ended anyhow, completed: tables, fields, manifest, report.

use std::ffi::OsString;
use std::fs;
use std::path::Path;

use arrow_schema::Field;
use field::{FieldError, fields_in};

use crate::files::file_error::FileError;
use crate::recording::{self, Recorded, RecordingError, SeriesReader, TRAIN_TABLE};
use crate::report::{self, EnergyLine, ReportError};
use crate::run::manifest::{Ended, Manifest};

/// Why results cannot be completed.
#[derive(Debug, thiserror::Error)]
pub enum CompleteError {
    /// A table cannot be read or written.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A field cannot be read or written.
    #[error(transparent)]
    Field(#[from] FieldError),
    /// Another file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The report cannot be made.
    #[error(transparent)]
    Report(#[from] ReportError),
}

/// Completes the results of a run that has not come to its end, from what lies in its folder, and gives
/// the times that are recorded; none where no whole record is there. The manifest says how it `ended`,
/// unless the run has said so itself.
///
/// # Errors
/// When a file cannot be read or written; what is whole stays readable.
pub fn complete(folder: &Path, ended: Ended) -> Result<Option<Recorded>, CompleteError> {
    let mut manifest = Manifest::read(folder)?;
    let Some(recorded) = series(folder, manifest.run.is_some())? else { return Ok(None) };
    fields(folder)?;
    if let Some(run) = manifest.run.as_mut().filter(|run| run.energy.is_empty()) {
        run.energy = energies(folder)?;
    }
    if !manifest.has_ended() {
        manifest.end(recorded.end - recorded.begin, ended);
        manifest.write(folder)?;
    }
    let (_, figures) = report::write(folder)?;
    manifest.figure = figures;
    manifest.write(folder)?;
    Ok(Some(recorded))
}

/// Whether the results in a folder are those of a run that has ended and completed them.
///
/// # Errors
/// When its manifest cannot be read.
pub fn is_complete(folder: &Path) -> Result<bool, FileError> {
    let entries = fs::read_dir(folder.join("series")).into_iter().flatten().flatten();
    let is_parts = |name: OsString| name.to_string_lossy().ends_with(".parts");
    let has_parts = entries.into_iter().any(|entry| is_parts(entry.file_name()));
    Ok(!has_parts && Manifest::read(folder)?.has_ended())
}

/// Completes the tables of a run; those of the rails of a train may go on after it.
pub(in crate::run) fn series(
    folder: &Path,
    is_train: bool,
) -> Result<Option<Recorded>, RecordingError> {
    let series = folder.join("series");
    match series.exists() {
        true => recording::complete(&series, is_train),
        false => Ok(None),
    }
}

/// The energies of the train at its last record.
fn energies(folder: &Path) -> Result<Vec<EnergyLine>, RecordingError> {
    let train = SeriesReader::open(&folder.join("series"), TRAIN_TABLE)?;
    let is_energy = |column: &&Field| column.metadata().get("unit").is_some_and(|unit| unit == "J");
    let line = |column: &Field| {
        let joules = train.read(column.name(), &[])?.last().copied().unwrap_or(f64::NAN);
        Ok(EnergyLine { name: column.name().clone(), joules })
    };
    train.columns().filter(is_energy).map(line).collect()
}

/// Completes the fields of the rails.
fn fields(folder: &Path) -> Result<(), CompleteError> {
    let fields = fields_in(folder).map_err(FileError::at(folder))?;
    fields.into_iter().try_for_each(|field| Ok(field::complete(&field)?))
}
