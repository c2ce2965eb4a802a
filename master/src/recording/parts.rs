//! The files of a table: parts while the run goes on, one file at its end.
//!
//! ```text
//! series/vehicles.parts/part-00000.parquet    while the run goes on
//! series/vehicles.parts/part-00001.parquet
//! series/vehicles.parquet                     when it has finished
//! ```
//!
//! A Parquet file is readable only with its footer, which comes last. Three ways keep a run
//! readable when it is killed at any instant:
//!
//! - write the one file anew each recorded second: the work grows with the square of the time;
//! - append rows and a new footer behind the old one: a write that a kill cuts short leaves a
//!   file without footer, and every footer repeats all those before it;
//! - write each recorded second (of a train alone: 50 s) as a file of its own under a hidden name, then rename it, which
//!   is atomic: this is done here, because its cost is constant and a file once there is never
//!   touched again.
//!
//! What is recorded after the last part is in an open one (`open_part.rs`), from which
//! `complete.rs` makes the end of the tables of a run that was killed.
//!
//! pandas, pyarrow, polars and DuckDB read a folder of parts as one table, and pass over the
//! hidden file that a kill may leave. At the end of the run the parts are joined into one
//! file, which is smaller and quicker to read; it too gets its name only when it is complete.
//! A kill -9 loses nothing that a rename has made visible. Files are not forced to the disk
//! with fsync, so a power failure may lose more than a second.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::path::{Path, PathBuf};

use arrow_array::RecordBatch;
use arrow_schema::{ArrowError, DataType, SchemaRef};
use parquet::arrow::ArrowWriter;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::basic::{Compression, Encoding, ZstdLevel};
use parquet::errors::ParquetError;
use parquet::file::properties::{EnabledStatistics, WriterProperties};
use parquet::schema::types::ColumnPath;

use super::RecordingError;
use super::open_part::OpenPart;

/// Stands in every file as its writer; has no version of ours or of a library, so that the
/// bytes depend on the values only.
const WRITER: &str = "hotfoot";

/// The parts of a table that is being written.
pub(super) struct Parts {
    pub(super) folder: PathBuf,
    pub(super) joined: PathBuf,
    pub(super) written: usize,
    open: OpenPart,
    /// Whether the folder is theirs and not one of an earlier run.
    pub(super) begun: bool,
}

impl Parts {
    /// A table that begins with its first record.
    pub fn new(folder: &Path, name: &str) -> Self {
        let (folder, joined) = (parts_folder(folder, name), joined_file(folder, name));
        Self { open: OpenPart::new(&folder), folder, joined, written: 0, begun: false }
    }

    /// Makes the folder, and removes the file and the parts of an earlier run.
    fn begin(&mut self) -> Result<(), RecordingError> {
        if self.begun {
            return Ok(());
        }
        self.remove_joined()?;
        self.remove()?;
        fs::create_dir_all(&self.folder).map_err(RecordingError::file(&self.folder))?;
        self.begun = true;
        Ok(())
    }

    /// Removes the joined file if there is one.
    pub(super) fn remove_joined(&self) -> Result<(), RecordingError> {
        match self.joined.exists() {
            true => fs::remove_file(&self.joined).map_err(RecordingError::file(&self.joined)),
            false => Ok(()),
        }
    }

    /// Adds a record to those since the last part.
    pub fn append(
        &mut self,
        schema: &SchemaRef,
        record: Result<RecordBatch, ArrowError>,
    ) -> Result<(), RecordingError> {
        self.begin()?;
        self.open.append(schema, record)
    }

    /// Writes the next part, which has all records since the last one.
    pub fn write(
        &mut self,
        schema: &SchemaRef,
        batch: Result<RecordBatch, ArrowError>,
    ) -> Result<(), RecordingError> {
        self.begin()?;
        let file = self.file(self.written);
        write_file(&file, schema, std::iter::once(batch.map_err(ParquetError::from)))?;
        self.written += 1;
        self.open.clear()
    }

    /// The file of the part with that number, from zero.
    pub(super) fn file(&self, number: usize) -> PathBuf {
        self.folder.join(format!("part-{number:05}.parquet"))
    }

    /// Joins the parts into one file and removes them.
    pub fn join(&mut self, schema: &SchemaRef) -> Result<(), RecordingError> {
        self.begin()?;
        let files = part_files(&self.folder)?;
        write_file(&self.joined, schema, rows_of(&files))?;
        self.remove()
    }

    pub(super) fn remove(&self) -> Result<(), RecordingError> {
        remove_folder(&self.folder)
    }
}

/// Removes the folder of the parts, if it is there.
pub(super) fn remove_folder(parts: &Path) -> Result<(), RecordingError> {
    match parts.exists() {
        true => fs::remove_dir_all(parts).map_err(RecordingError::file(parts)),
        false => Ok(()),
    }
}

/// Names of the tables in a folder.
///
/// # Errors
/// When it cannot be read.
pub fn table_names(folder: &Path) -> Result<BTreeSet<String>, RecordingError> {
    let mut names = BTreeSet::new();
    for entry in fs::read_dir(folder).map_err(RecordingError::file(folder))? {
        let entry = entry.map_err(RecordingError::file(folder))?.file_name();
        let entry = entry.to_string_lossy();
        let name = entry.strip_suffix(".parts").or(entry.strip_suffix(".parquet"));
        // A hidden file is one that was being written.
        names.extend(name.filter(|name| !name.starts_with('.')).map(str::to_owned));
    }
    Ok(names)
}

/// The files that hold the table `name`, in the order of time: the joined file, or the parts of
/// a run that goes on or was killed.
pub(super) fn table_files(folder: &Path, name: &str) -> Result<Vec<PathBuf>, RecordingError> {
    let joined = joined_file(folder, name);
    if joined.exists() {
        return Ok(vec![joined]);
    }
    let parts = parts_folder(folder, name);
    let files = if parts.exists() { part_files(&parts)? } else { vec![] };
    match files.is_empty() {
        false => Ok(files),
        true => Err(RecordingError::NoTable { folder: folder.to_owned(), name: name.to_owned() }),
    }
}

pub(super) fn joined_file(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.parquet"))
}

pub(super) fn parts_folder(folder: &Path, name: &str) -> PathBuf {
    folder.join(format!("{name}.parts"))
}

/// The complete parts, in the order they were written.
pub(super) fn part_files(folder: &Path) -> Result<Vec<PathBuf>, RecordingError> {
    let entries = fs::read_dir(folder).map_err(RecordingError::file(folder))?;
    let paths: Result<Vec<_>, _> = entries.map(|entry| entry.map(|e| e.path())).collect();
    let mut files = paths.map_err(RecordingError::file(folder))?;
    files.retain(|file| {
        let name = file.file_name().map(|name| name.to_string_lossy());
        name.is_some_and(|name| name.starts_with("part-") && name.ends_with(".parquet"))
    });
    files.sort();
    Ok(files)
}

/// All rows of files that follow one another.
pub(super) fn rows_of(
    files: &[PathBuf],
) -> impl Iterator<Item = Result<RecordBatch, ParquetError>> {
    files.iter().flat_map(|file| match batches(file) {
        Ok(batches) => batches.into_iter().map(Ok).collect(),
        Err(error) => vec![Err(error)],
    })
}

/// All rows of a file. What is damaged ends the reading: the reader would give the same error for ever.
fn batches(file: &Path) -> Result<Vec<RecordBatch>, ParquetError> {
    let reader = ParquetRecordBatchReaderBuilder::try_new(File::open(file)?)?.build()?;
    reader.map(|batch| batch.map_err(ParquetError::from)).collect()
}

/// Writes a file under a hidden name and gives it its name when it is complete.
pub(super) fn write_file(
    file: &Path,
    schema: &SchemaRef,
    batches: impl Iterator<Item = Result<RecordBatch, ParquetError>>,
) -> Result<(), RecordingError> {
    let name = file.file_name().unwrap_or_default().to_string_lossy();
    let hidden = file.with_file_name(format!(".{name}"));
    let write = || {
        let output = File::create(&hidden)?;
        let mut writer = ArrowWriter::try_new(output, schema.clone(), Some(properties(schema)))?;
        for batch in batches {
            writer.write(&batch?)?;
        }
        writer.close().map(|_| ())
    };
    write().map_err(RecordingError::written(file))?;
    fs::rename(&hidden, file).map_err(RecordingError::file(file))
}

/// Floating-point columns are stored byte by byte (all first bytes, all second bytes, …), which
/// zstd packs better; time and keys repeat and use a dictionary.
fn properties(schema: &SchemaRef) -> WriterProperties {
    let mut properties = WriterProperties::builder()
        .set_created_by(WRITER.to_owned())
        .set_compression(Compression::ZSTD(ZstdLevel::default()))
        .set_statistics_enabled(EnabledStatistics::Chunk);
    for field in schema.fields() {
        let floating = matches!(field.data_type(), DataType::Float32 | DataType::Float64);
        if floating && field.name() != "time" {
            let column = ColumnPath::from(field.name().as_str());
            properties = properties
                .set_column_dictionary_enabled(column.clone(), false)
                .set_column_encoding(column, Encoding::BYTE_STREAM_SPLIT);
        }
    }
    properties.build()
}
