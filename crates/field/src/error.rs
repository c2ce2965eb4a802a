//! Why a field cannot be written or read.

use std::path::{Path, PathBuf};

use numerics::seconds;

/// Why a field cannot be written or read; every message names the store.
#[derive(Debug, thiserror::Error)]
pub enum FieldError {
    /// There is something at the path that is not a rail field, and it is not overwritten.
    #[error("field {path}: exists and is not a rail field; choose another name or remove it")]
    Occupied {
        /// Path of the store.
        path: PathBuf,
    },
    /// The store has no rail field.
    #[error("field {path}: holds no rail field: {reason}")]
    NotAField {
        /// Path of the store.
        path: PathBuf,
        /// What is missing or wrong.
        reason: String,
    },
    /// An axis without values.
    #[error("field {path}: the {axis} axis has no values; it needs at least one")]
    EmptyAxis {
        /// Path of the store.
        path: PathBuf,
        /// Name of the axis.
        axis: &'static str,
    },
    /// A snapshot of the wrong size.
    #[error("field {path}: a snapshot has {found} values, but the axes want {wanted}")]
    Size {
        /// Path of the store.
        path: PathBuf,
        /// Number of values given.
        found: usize,
        /// Number of chainages times depths, or of places times cells.
        wanted: usize,
    },
    /// A snapshot that does not come after the last one.
    #[error(
        "field {path}: snapshot at {} s does not come after the last one at {} s",
        seconds(*time),
        seconds(*last)
    )]
    NotLater {
        /// Path of the store.
        path: PathBuf,
        /// Time of the snapshot, s.
        time: f64,
        /// Time of the last snapshot, s.
        last: f64,
    },
    /// The store was there and is not any more.
    #[error(
        "field {path}: is no longer there; something has removed or replaced it during the run"
    )]
    Gone {
        /// Path of the store.
        path: PathBuf,
    },
    /// The store lacks snapshots behind which it is to go on.
    #[error("field {path}: has {found} snapshots, where the run that goes on had written {wanted}")]
    TooShort {
        /// Path of the store.
        path: PathBuf,
        /// Number of its snapshots.
        found: usize,
        /// Number behind which it is to go on.
        wanted: usize,
    },
    /// The field has no snapshot yet.
    #[error("field {path}: has no snapshot")]
    NoSnapshot {
        /// Path of the store.
        path: PathBuf,
    },
    /// A file of the store cannot be written or read.
    #[error("field {path}: {source}")]
    Io {
        /// Path of the store.
        path: PathBuf,
        /// Reason.
        source: std::io::Error,
    },
    /// The Zarr library refuses.
    #[error("field {path}: {reason}")]
    Zarr {
        /// Path of the store.
        path: PathBuf,
        /// Reason.
        reason: String,
    },
}

impl FieldError {
    /// An error of the Zarr library about the store at `path`.
    pub(crate) fn zarr(path: &Path, error: impl std::error::Error) -> Self {
        Self::Zarr { path: path.to_owned(), reason: error.to_string() }
    }

    /// An error of the file system about the store at `path`.
    pub(crate) fn io(path: &Path, source: std::io::Error) -> Self {
        Self::Io { path: path.to_owned(), source }
    }
}
