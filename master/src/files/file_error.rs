//! An error of the file system, or of a file's text, with the file that it is about.

use std::path::Path;

use serde::de::DeserializeOwned;

/// Why a file or folder cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum FileError {
    /// It cannot be read or written.
    #[error("{path}: {source}")]
    Io {
        /// File or folder.
        path: String,
        /// Reason.
        source: std::io::Error,
    },
    /// It is not the TOML that it should be.
    #[error("{path}: {source}")]
    Toml {
        /// File.
        path: String,
        /// Reason, with line and caret.
        source: Box<toml::de::Error>,
    },
}

impl FileError {
    /// What `map_err` needs for the error of a file or folder.
    pub fn at(path: &Path) -> impl FnOnce(std::io::Error) -> Self + '_ {
        move |source| Self::Io { path: path.display().to_string(), source }
    }
}

/// Writes a file under a hidden name first, so that whoever reads it finds the old or the new, whole.
///
/// # Errors
/// When it cannot be written.
pub fn write_whole(path: &Path, text: &str) -> Result<(), FileError> {
    let name = path.file_name().unwrap_or_default().to_string_lossy();
    let hidden = path.with_file_name(format!(".{name}"));
    let written = std::fs::write(&hidden, text).and_then(|()| std::fs::rename(&hidden, path));
    written.map_err(FileError::at(path))
}

/// Reads a TOML file.
///
/// # Errors
/// When the file cannot be read, or is not what `T` wants.
pub fn read_toml<T: DeserializeOwned>(path: &Path) -> Result<T, FileError> {
    let text = std::fs::read_to_string(path).map_err(FileError::at(path))?;
    toml::from_str(&text).map_err(|source| FileError::Toml {
        path: path.display().to_string(),
        source: Box::new(source),
    })
}
