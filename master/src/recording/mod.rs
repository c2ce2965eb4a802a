//! Records a run as tables: named columns with unit and description, in Parquet files.
//!
//! | file | part |
//! |---|---|
//! | `column.rs` | a column and a key of a table, and how the file describes them |
//! | `tables.rs` | the tables of vehicles and of wheels |
//! | `accumulator.rs` | last value, mean, lowest and highest of every column between two records |
//! | `writer.rs` | writes a table while the run goes on |
//! | `parts.rs` | the files of a table: parts while the run goes on, one file at its end |
//! | `cut.rs` | cuts a table for a run that goes on |
//! | `open_part.rs` | the records since the last part, for when the program dies |
//! | `complete.rs` | the tables of a run that was killed, completed |
//! | `csv_copy.rs` | the tables as comma-separated values |
//! | `reader.rs` | reads a column of a table, of a finished or of a killed run |
//!
//! Nothing here knows FMUs, and nothing in a file depends on the clock, on threads or on the
//! machine: identical runs give identical bytes.

mod accumulator;
mod column;
mod complete;
mod csv_copy;
mod cut;
mod open_part;
mod parts;
mod reader;
mod tables;
mod writer;

#[cfg(test)]
mod other_reader_tests;
#[cfg(test)]
mod tests;

use std::path::{Path, PathBuf};

use parquet::errors::ParquetError;

pub use column::{Column, Key, KeyValues};
pub use complete::{Recorded, complete};
pub use csv_copy::copy_as_csv;
pub use parts::table_names;
pub use reader::{KeyValue, SeriesReader};
pub use tables::{Side, VehicleRow, WheelRow, vehicle_keys, vehicle_keys_of, wheel_keys};
pub use writer::{SeriesWriter, TableState};

/// Name of the first column of every table.
pub const TIME: &str = "time";

/// Name of the table of the train.
pub const TRAIN_TABLE: &str = "train";

/// Name of the table of the rails.
pub const RAIL_TABLE: &str = "rail";

/// Why a series cannot be written or read.
#[derive(Debug, thiserror::Error)]
pub enum RecordingError {
    /// The file system refuses.
    #[error("{file}: {source}")]
    File {
        /// File or folder.
        file: PathBuf,
        /// Reason.
        source: std::io::Error,
    },
    /// The content is not what Parquet or the table wants.
    #[error("{file}: {source}")]
    Parquet {
        /// File.
        file: PathBuf,
        /// Reason.
        source: ParquetError,
    },
    /// A table has neither a file nor parts.
    #[error("{folder} has neither {name}.parquet nor {name}.parts: no run has recorded it there")]
    NoTable {
        /// Folder of the series.
        folder: PathBuf,
        /// Name of the table.
        name: String,
    },
    /// A table has no such column.
    #[error("{file} has no column {column}; it has {available}")]
    NoColumn {
        /// File.
        file: PathBuf,
        /// Name asked for.
        column: String,
        /// The names there are.
        available: String,
    },
    /// Two columns of a table would have one name.
    #[error(
        "table {table}: two columns would have the name {column}; leave the variable of that name out, or \
         rename it"
    )]
    OneName {
        /// Name of the table.
        table: String,
        /// The name.
        column: String,
    },
    /// A table does not reach as far as the run that goes on with it had come.
    #[error("{table}: the table ends before the time at which the run is to go on")]
    TooShort {
        /// File of the table, without its ending.
        table: PathBuf,
    },
    /// What was saved of a table is of another one.
    #[error("{table}: what was saved of this table is of another one")]
    OtherTable {
        /// File of the table, without its ending.
        table: PathBuf,
    },
    /// The keys of a table do not belong together.
    #[error("table {table}: key {key} has {found} values where the keys before have {wanted}")]
    Keys {
        /// Name of the table.
        table: String,
        /// Name of the key.
        key: String,
        /// Its number of values.
        found: usize,
        /// The number the other keys have.
        wanted: usize,
    },
}

impl RecordingError {
    /// An error of the file system at `file`.
    fn file(file: &Path) -> impl FnOnce(std::io::Error) -> Self {
        let file = file.to_owned();
        |source| Self::File { file, source }
    }

    /// An error of writing rows into `file`.
    fn csv(file: &Path) -> impl Fn(csv::Error) -> Self {
        let file = file.to_owned();
        move |error| Self::File { file: file.clone(), source: error.into() }
    }

    /// An error of writing `file`, which is the file system's where that has refused.
    fn written(file: &Path) -> impl FnOnce(ParquetError) -> Self {
        let file = file.to_owned();
        |source| match source {
            ParquetError::External(error) => match error.downcast::<std::io::Error>() {
                Ok(source) => Self::File { file, source: *source },
                Err(error) => Self::Parquet { file, source: ParquetError::External(error) },
            },
            source => Self::Parquet { file, source },
        }
    }

    /// An error of the Parquet content of `file`.
    fn parquet<E: Into<ParquetError>>(file: &Path) -> impl FnOnce(E) -> Self {
        let file = file.to_owned();
        |source| Self::Parquet { file, source: source.into() }
    }
}
