//! Why a report cannot be made.

use crate::files::file_error::FileError;
use crate::recording::RecordingError;

/// Why a report cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ReportError {
    /// A series cannot be read.
    #[error(transparent)]
    Series(#[from] RecordingError),
    /// A file cannot be read or written, or the manifest is not what a run writes.
    #[error(transparent)]
    File(#[from] FileError),
    /// A figure cannot be drawn.
    #[error("figure \"{figure}\": {reason}")]
    Drawing {
        /// Its title.
        figure: String,
        /// Reason.
        reason: String,
    },
    /// The page cannot be made from its template.
    #[error("report page: {0}")]
    Page(#[from] minijinja::Error),
}
