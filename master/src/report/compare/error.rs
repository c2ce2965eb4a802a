//! Why results cannot be compared.

use crate::files::file_error::FileError;
use crate::recording::RecordingError;
use crate::report::error::ReportError;

/// Why results cannot be compared.
#[derive(Debug, thiserror::Error)]
pub enum CompareError {
    /// A file of a measurement is not what it must be.
    #[error(transparent)]
    Measurement(#[from] files::Mistake),
    /// A table cannot be read.
    #[error(transparent)]
    Series(#[from] RecordingError),
    /// A rail's field cannot be read.
    #[error(transparent)]
    Field(#[from] field::FieldError),
    /// A file cannot be read or written.
    #[error(transparent)]
    File(#[from] FileError),
    /// The page cannot be made.
    #[error(transparent)]
    Page(#[from] ReportError),
    /// There is nothing to compare.
    #[error("{first} and {other} have no column in common")]
    Nothing {
        /// The first run.
        first: String,
        /// The other one.
        other: String,
    },
}
