//! Cuts a table to its first parts, for a run that goes on from there.
//!
//! The parts may lie in their folder, as a run leaves them that was killed, or be joined already: then
//! they are taken apart again, so that the table comes out as if it had never been joined.

use std::fs::{self, File};
use std::path::Path;
use std::slice;

use arrow_array::RecordBatch;
use arrow_schema::SchemaRef;
use arrow_select::concat::concat_batches;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::errors::ParquetError;

use super::RecordingError;
use super::parts::{Parts, rows_of, write_file};

impl Parts {
    /// Leaves the first `count` parts, each of so many rows, and nothing of what was recorded then.
    ///
    /// # Errors
    /// When there are fewer, or a file cannot be read or written.
    pub fn cut(
        &mut self,
        schema: &SchemaRef,
        count: usize,
        rows: usize,
    ) -> Result<(), RecordingError> {
        match self.joined.exists() {
            true => self.separate(schema, count, rows)?,
            false => self.keep(count, rows)?,
        }
        (self.written, self.begun) = (count, true);
        Ok(())
    }

    /// Removes all but the first parts.
    fn keep(&self, count: usize, rows: usize) -> Result<(), RecordingError> {
        fs::create_dir_all(&self.folder).map_err(RecordingError::file(&self.folder))?;
        let kept: Vec<_> = (0..count).map(|number| self.file(number)).collect();
        for part in &kept {
            let found = count_rows(part).ok();
            if found != Some(rows) {
                return Err(self.too_short());
            }
        }
        let entries = fs::read_dir(&self.folder).map_err(RecordingError::file(&self.folder))?;
        for entry in entries {
            let file = entry.map_err(RecordingError::file(&self.folder))?.path();
            if !kept.contains(&file) {
                fs::remove_file(&file).map_err(RecordingError::file(&file))?;
            }
        }
        Ok(())
    }

    /// Writes the first parts anew from the joined file, which goes when they are there.
    fn separate(
        &self,
        schema: &SchemaRef,
        count: usize,
        rows: usize,
    ) -> Result<(), RecordingError> {
        self.remove()?;
        fs::create_dir_all(&self.folder).map_err(RecordingError::file(&self.folder))?;
        let wrong = || RecordingError::parquet::<ParquetError>(&self.joined);
        let mut written = 0;
        let mut left = RecordBatch::new_empty(schema.clone());
        for batch in rows_of(slice::from_ref(&self.joined)) {
            if written == count {
                break;
            }
            let batch = batch.map_err(wrong())?;
            left =
                concat_batches(schema, [&left, &batch]).map_err(|error| wrong()(error.into()))?;
            // A batch may hold several parts.
            while written < count && left.num_rows() >= rows {
                let part = std::iter::once(Ok(left.slice(0, rows)));
                write_file(&self.file(written), schema, part)?;
                written += 1;
                left = left.slice(rows, left.num_rows() - rows);
            }
        }
        match written == count {
            true => self.remove_joined(),
            false => Err(self.too_short()),
        }
    }

    fn too_short(&self) -> RecordingError {
        RecordingError::TooShort { table: self.joined.with_extension("") }
    }
}

/// Number of rows of a file.
fn count_rows(file: &Path) -> Result<usize, ParquetError> {
    let reader = ParquetRecordBatchReaderBuilder::try_new(File::open(file)?)?;
    Ok(usize::try_from(reader.metadata().file_metadata().num_rows()).unwrap_or_default())
}
