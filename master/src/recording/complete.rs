//! The tables of a run that was killed, completed: all that it recorded becomes one file a table, as at
//! the end of a run, and all tables end at the same record.

use std::path::{Path, PathBuf};

use arrow_array::RecordBatch;
use arrow_array::cast::AsArray;
use arrow_array::types::Float64Type;
use arrow_schema::SchemaRef;
use arrow_select::concat::concat_batches;

use super::open_part::left_records;
use super::parts::{
    joined_file, part_files, parts_folder, remove_folder, rows_of, table_names, write_file,
};
use super::reader::schema_of;
use super::{RAIL_TABLE, RecordingError};

/// Rows that a reader of Parquet gives at once; the bytes of a file depend on it.
const ROWS_AT_ONCE: usize = 1024;

/// From when to when all tables of a run have records, s.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Recorded {
    /// Time of the first record.
    pub begin: f64,
    /// Time of the last record that is in all tables.
    pub end: f64,
}

/// Completes the tables in `folder`, and gives the times that they have in common; none where no record
/// is in all of them, and then all is left as it is.
///
/// A record that the end of the program has cut short, in a table or between two tables, is left out. The
/// table of the rails may go on after the others if `rails_continue`, as it does after the run of a train.
///
/// # Errors
/// When a file cannot be read or written; what is not completed then stays as it is.
pub fn complete(folder: &Path, rails_continue: bool) -> Result<Option<Recorded>, RecordingError> {
    let mut tables = vec![];
    for name in table_names(folder)? {
        tables.push(Table::read(folder, name)?);
    }
    let of_run: Option<Vec<Recorded>> = tables.iter().map(|table| table.recorded).collect();
    let Some(first) = of_run.as_ref().and_then(|times| times.first()) else { return Ok(None) };
    let ends = of_run.iter().flatten().map(|times| times.end);
    let end = ends.fold(f64::INFINITY, f64::min);
    let is_after_run = |table: &Table| rails_continue && table.name == RAIL_TABLE;
    let others = tables.iter().filter(|table| !is_after_run(table));
    // Where a record was cut short, the rails have not gone on alone.
    let is_even = others.flat_map(|table| table.recorded).all(|times| times.end == end);
    for table in &tables {
        let stays = is_after_run(table) && is_even;
        table.complete(if stays { f64::INFINITY } else { end })?;
    }
    Ok(Some(Recorded { begin: first.begin, end }))
}

/// A table as a run has left it.
struct Table {
    name: String,
    parts: PathBuf,
    joined: PathBuf,
    /// The files with its rows, in the order of time.
    files: Vec<PathBuf>,
    /// The records after those of the files.
    open: Option<(SchemaRef, RecordBatch)>,
    /// Times of its first and last record.
    recorded: Option<Recorded>,
}

impl Table {
    fn read(folder: &Path, name: String) -> Result<Self, RecordingError> {
        let (parts, joined) = (parts_folder(folder, &name), joined_file(folder, &name));
        let is_joined = joined.exists();
        let files = match is_joined {
            true => vec![joined.clone()],
            false => part_files(&parts)?,
        };
        let mut recorded: Option<Recorded> = None;
        for batch in rows_of(&files) {
            let batch = batch.map_err(RecordingError::parquet(&parts))?;
            recorded = with(recorded, &batch);
        }
        let mut open = None;
        if let Some((schema, records)) = left_records(&parts).filter(|_| !is_joined) {
            // The part that has them may have been written before they could be removed.
            let written = recorded.map_or(f64::NEG_INFINITY, |times| times.end);
            let new: Vec<_> =
                records.into_iter().filter(|record| first_time(record) > Some(written)).collect();
            let new = concat_batches(&schema, &new).map_err(RecordingError::parquet(&parts))?;
            recorded = with(recorded, &new);
            open = Some((schema, new));
        }
        Ok(Self { name, parts, joined, files, open, recorded })
    }

    /// Makes one file of the rows until a time, s.
    fn complete(&self, until: f64) -> Result<(), RecordingError> {
        let ends_there = self.recorded.is_none_or(|times| times.end <= until);
        if self.files.first() != Some(&self.joined) || !ends_there {
            let schema = match (&self.open, self.files.first()) {
                (Some((schema, _)), _) => schema.clone(),
                (None, Some(file)) => schema_of(file)?,
                (None, None) => return Ok(()),
            };
            let open = self.open.iter().flat_map(|(_, rows)| in_pieces(rows)).map(Ok);
            let rows = rows_of(&self.files).chain(open).map(|rows| Ok(rows_until(&rows?, until)));
            let rows = rows
                .filter(|rows| !rows.as_ref().is_ok_and(|rows: &RecordBatch| rows.num_rows() == 0));
            write_file(&self.joined, &schema, rows)?;
        }
        remove_folder(&self.parts)
    }
}

/// The rows as a reader of a file gives them.
fn in_pieces(rows: &RecordBatch) -> Vec<RecordBatch> {
    let count = rows.num_rows();
    let piece = |begin: usize| rows.slice(begin, ROWS_AT_ONCE.min(count - begin));
    (0..count).step_by(ROWS_AT_ONCE).map(piece).collect()
}

/// The times with those of further rows.
fn with(recorded: Option<Recorded>, rows: &RecordBatch) -> Option<Recorded> {
    let (Some(first), Some(last)) = (first_time(rows), times(rows).last()) else { return recorded };
    Some(Recorded { begin: recorded.map_or(first, |times| times.begin), end: *last })
}

fn first_time(rows: &RecordBatch) -> Option<f64> {
    times(rows).first().copied()
}

/// The times, which every table has in its first column.
fn times(rows: &RecordBatch) -> &[f64] {
    let times = rows.columns().first().and_then(|column| column.as_primitive_opt::<Float64Type>());
    times.map(|times| &times.values()[..]).unwrap_or_default()
}

fn rows_until(rows: &RecordBatch, end: f64) -> RecordBatch {
    rows.slice(0, times(rows).partition_point(|&time| time <= end))
}
