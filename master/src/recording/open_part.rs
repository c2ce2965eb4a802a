//! The records since the last part: an Arrow stream that is readable up to its last whole record,
//! so that nothing recorded is lost when the program dies between two parts.

use std::fs::{self, File};
use std::io::BufWriter;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{Path, PathBuf};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, SchemaRef};

use arrow_ipc::reader::StreamReader;
use arrow_ipc::writer::StreamWriter;

use super::RecordingError;

/// Name beside the parts; hidden, so that readers of the parts pass over it.
const NAME: &str = ".open.arrows";

/// The stream of the records since the last part.
pub(super) struct OpenPart {
    file: PathBuf,
    stream: Option<StreamWriter<BufWriter<File>>>,
}

impl OpenPart {
    /// A stream in the folder of the parts; it begins with the first record.
    pub fn new(folder: &Path) -> Self {
        Self { file: folder.join(NAME), stream: None }
    }

    /// Appends a record; when this returns, the system has it.
    pub fn append(
        &mut self,
        schema: &SchemaRef,
        record: Result<RecordBatch, ArrowError>,
    ) -> Result<(), RecordingError> {
        let file = &self.file;
        let wrong = |file: &Path| {
            let file = file.to_owned();
            |error| match error {
                ArrowError::IoError(_, source) => RecordingError::File { file, source },
                error => RecordingError::Parquet { file, source: error.into() },
            }
        };
        let stream = match &mut self.stream {
            Some(stream) => stream,
            none => {
                let output = File::create(file).map_err(RecordingError::file(file))?;
                none.insert(StreamWriter::try_new_buffered(output, schema).map_err(wrong(file))?)
            }
        };
        stream.write(&record.map_err(wrong(file))?).map_err(wrong(file))?;
        stream.flush().map_err(wrong(file))
    }

    /// Removes the stream, because a part has what it holds.
    pub fn clear(&mut self) -> Result<(), RecordingError> {
        match self.stream.take() {
            Some(_) => fs::remove_file(&self.file).map_err(RecordingError::file(&self.file)),
            None => Ok(()),
        }
    }
}

/// The whole records of a stream that a dead program has left in the folder of the parts.
pub(super) fn left_records(folder: &Path) -> Option<(SchemaRef, Vec<RecordBatch>)> {
    let mut reader = StreamReader::try_new(File::open(folder.join(NAME)).ok()?, None).ok()?;
    let schema = reader.schema();
    // The first record that is not whole ends the stream. Lengths in a damaged record may be any, and
    // some of those the library answers with a panic; what it has read of such a record is dropped.
    let next = || catch_unwind(AssertUnwindSafe(|| reader.next())).ok()??.ok();
    let records: Vec<_> = std::iter::from_fn(next).collect();
    (!records.is_empty()).then_some((schema, records))
}
