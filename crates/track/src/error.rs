//! Why a track file cannot be used.

use numerics::TableError;

/// Why a track file cannot be used.
#[derive(Debug, thiserror::Error)]
pub enum TrackError {
    /// The file cannot be read.
    #[error("track file {file}: {source}")]
    Read {
        /// File name.
        file: String,
        /// Reason.
        source: std::io::Error,
    },
    /// The file is not TOML, or has an unknown key or a wrong type.
    #[error("track file {file}: {source}")]
    Syntax {
        /// File name.
        file: String,
        /// Reason, with line and caret.
        source: Box<toml::de::Error>,
    },
    /// A value is not possible.
    #[error("track file {file}: {key} = {value}: {wanted}")]
    Value {
        /// File name.
        file: String,
        /// Key.
        key: String,
        /// Value found.
        value: f64,
        /// What would be right.
        wanted: &'static str,
    },
    /// A table of measured values has other columns.
    #[error("{file}: the first line must be \"{wanted}\"")]
    Columns {
        /// File name.
        file: String,
        /// The columns that it must have.
        wanted: &'static str,
    },
    /// A file with measured values lies in another folder.
    #[error(
        "track file {file}: irregularity.file = {value}: must be the name of a file in the folder of \
         the track file"
    )]
    Elsewhere {
        /// File name.
        file: String,
        /// Value found.
        value: String,
    },
    /// A row of measured values cannot be used.
    #[error(
        "{file}: line {line}: must be a chainage in m and four irregularities between -200 and 200 mm"
    )]
    Row {
        /// File name.
        file: String,
        /// Number of the line.
        line: usize,
    },
    /// Points cannot be used as a function of the chainage.
    #[error("track file {file}: {key}: {source}")]
    Points {
        /// File name.
        file: String,
        /// Key.
        key: &'static str,
        /// Reason.
        source: TableError,
    },
}
