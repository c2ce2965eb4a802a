//! An error of the file system with the file that it is about.

use std::path::Path;

/// A file or folder cannot be read or written.
#[derive(Debug, thiserror::Error)]
#[error("{path}: {source}")]
pub struct FileError {
    /// File or folder.
    path: String,
    /// Reason.
    source: std::io::Error,
}

impl FileError {
    /// What `map_err` needs for the error of a file or folder.
    pub fn at(path: &Path) -> impl FnOnce(std::io::Error) -> Self + '_ {
        move |source| Self { path: path.display().to_string(), source }
    }
}
