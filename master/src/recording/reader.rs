//! Reads a column of a table, of a finished or of a killed run.

use std::fs::File;
use std::path::{Path, PathBuf};

use arrow_array::cast::AsArray;
use arrow_array::types::{Float32Type, Float64Type, Int32Type};
use arrow_array::{Array, RecordBatch};
use arrow_schema::{DataType, Field, SchemaRef};
use parquet::arrow::ProjectionMask;
use parquet::arrow::arrow_reader::ParquetRecordBatchReaderBuilder;
use parquet::errors::ParquetError;

use super::RecordingError;
use super::parts::table_files;

/// The value a key must have for a row to be read.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum KeyValue<'a> {
    /// A number.
    Integer(i32),
    /// A name.
    Text(&'a str),
}

/// Reads a table.
#[derive(Debug)]
pub struct SeriesReader {
    files: Vec<PathBuf>,
    schema: SchemaRef,
}

impl SeriesReader {
    /// Opens the table `name` in `folder`.
    ///
    /// # Errors
    /// When there is no such table, or a file of it cannot be read.
    pub fn open(folder: &Path, name: &str) -> Result<Self, RecordingError> {
        let files = table_files(folder, name)?;
        let schema = schema_of(&files[0])?;
        Ok(Self { files, schema })
    }

    /// The columns: name, type, and metadata with `unit` and `description`.
    pub fn columns(&self) -> impl Iterator<Item = &Field> {
        self.schema.fields().iter().map(AsRef::as_ref)
    }

    /// The values of `column` in all rows whose keys have the wanted values, in the order of time.
    ///
    /// # Errors
    /// When there is no such column, or a file cannot be read.
    pub fn read(
        &self,
        column: &str,
        keys: &[(&str, KeyValue<'_>)],
    ) -> Result<Vec<f64>, RecordingError> {
        let column = self.index(column)?;
        let keys: Vec<(usize, KeyValue<'_>)> = keys
            .iter()
            .map(|&(name, value)| Ok((self.index(name)?, value)))
            .collect::<Result<_, RecordingError>>()?;
        let mut wanted: Vec<usize> = keys.iter().map(|key| key.0).chain([column]).collect();
        wanted.sort_unstable();
        wanted.dedup();
        // The file is read only where it is wanted: these are the indices in what is read.
        let position = |index: usize| wanted.partition_point(|&other| other < index);

        let mut values = vec![];
        for file in &self.files {
            let builder = open(file)?;
            let mask = ProjectionMask::roots(builder.parquet_schema(), wanted.iter().copied());
            let reader = builder.with_projection(mask).build();
            for batch in reader.map_err(RecordingError::parquet(file))? {
                let batch = batch.map_err(RecordingError::parquet(file))?;
                let selected = |row: &usize| {
                    keys.iter().all(|&(index, value)| has(&batch, position(index), *row, value))
                };
                let column = numbers(batch.column(position(column)).as_ref());
                values.extend((0..batch.num_rows()).filter(selected).map(|row| column[row]));
            }
        }
        Ok(values)
    }

    /// The keys of the rows of an instant, such as `2,1,left`; one empty text in a table without keys.
    ///
    /// # Errors
    /// When a file cannot be read.
    pub fn rows(&self) -> Result<Vec<String>, RecordingError> {
        let is_key = |field: &&Field| matches!(field.data_type(), DataType::Int32 | DataType::Utf8);
        let names: Vec<&String> = self.columns().filter(is_key).map(Field::name).collect();
        let mut rows: Vec<String> = vec![];
        let mut is_over = false;
        self.each_batch(|batch| {
            let columns = names.iter().filter_map(|name| batch.column_by_name(name));
            let columns: Vec<_> = columns.collect();
            for row in 0..batch.num_rows() {
                let keys = columns.iter().map(|column| cell(column.as_ref(), row));
                let keys = keys.collect::<Vec<_>>().join(",");
                // The next instant begins with the same keys.
                is_over |= rows.first() == Some(&keys);
                if is_over {
                    break;
                }
                rows.push(keys);
            }
            Ok(())
        })?;
        Ok(rows)
    }

    /// Gives all rows to `take`, in the order of time, some at once.
    ///
    /// # Errors
    /// When a file cannot be read, or `take` has an error.
    pub(super) fn each_batch(
        &self,
        mut take: impl FnMut(&RecordBatch) -> Result<(), RecordingError>,
    ) -> Result<(), RecordingError> {
        for file in &self.files {
            for batch in open(file)?.build().map_err(RecordingError::parquet(file))? {
                take(&batch.map_err(RecordingError::parquet(file))?)?;
            }
        }
        Ok(())
    }

    fn index(&self, column: &str) -> Result<usize, RecordingError> {
        self.schema.index_of(column).map_err(|_| {
            let names: Vec<_> = self.columns().map(|field| field.name().as_str()).collect();
            RecordingError::NoColumn {
                file: self.files[0].clone(),
                column: column.to_owned(),
                available: names.join(", "),
            }
        })
    }
}

/// The columns of a file.
pub(super) fn schema_of(file: &Path) -> Result<SchemaRef, RecordingError> {
    Ok(open(file)?.schema().clone())
}

fn open(file: &Path) -> Result<ParquetRecordBatchReaderBuilder<File>, RecordingError> {
    let input = File::open(file).map_err(RecordingError::file(file))?;
    ParquetRecordBatchReaderBuilder::try_new(input)
        .map_err(RecordingError::parquet::<ParquetError>(file))
}

/// Whether a key has the wanted value; a key of another type never has.
fn has(batch: &RecordBatch, column: usize, row: usize, wanted: KeyValue<'_>) -> bool {
    let column = batch.column(column);
    match wanted {
        KeyValue::Integer(wanted) => {
            column.as_primitive_opt::<Int32Type>().is_some_and(|column| column.value(row) == wanted)
        }
        KeyValue::Text(wanted) => {
            column.as_string_opt::<i32>().is_some_and(|column| column.value(row) == wanted)
        }
    }
}

/// A value with as few digits as tell it from its neighbours.
pub(super) fn cell(column: &dyn Array, row: usize) -> String {
    match column.data_type() {
        DataType::Float64 => format!("{:?}", column.as_primitive::<Float64Type>().value(row)),
        DataType::Float32 => format!("{:?}", column.as_primitive::<Float32Type>().value(row)),
        DataType::Int32 => column.as_primitive::<Int32Type>().value(row).to_string(),
        _ => {
            let names = column.as_string_opt::<i32>();
            names.map(|names| names.value(row)).unwrap_or_default().to_owned()
        }
    }
}

/// A column of numbers; one of names gives no numbers.
fn numbers(column: &dyn Array) -> Vec<f64> {
    match column.data_type() {
        DataType::Float64 => column.as_primitive::<Float64Type>().values().to_vec(),
        DataType::Float32 => {
            let values = column.as_primitive::<Float32Type>().values();
            values.iter().map(|&value| value.into()).collect()
        }
        DataType::Int32 => {
            let values = column.as_primitive::<Int32Type>().values();
            values.iter().map(|&value| value.into()).collect()
        }
        _ => vec![f64::NAN; column.len()],
    }
}
