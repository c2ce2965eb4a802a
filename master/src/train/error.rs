//! Why a scenario cannot be set up.

use files::Mistake;

use crate::files::file_error::FileError;
use crate::fmi::ImportError;
use crate::fmi::pack::PackError;
use crate::system::compile::CompileError;
use crate::system::unit::UnitError;

/// Why a scenario cannot be set up.
#[derive(Debug, thiserror::Error)]
pub enum PrepareError {
    /// A file or folder cannot be written.
    #[error(transparent)]
    File(#[from] FileError),
    /// An FMU cannot be packed.
    #[error(transparent)]
    Pack(#[from] PackError),
    /// An FMU cannot be imported.
    #[error(transparent)]
    Import(#[from] ImportError),
    /// A unit refuses.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The units cannot be connected.
    #[error(transparent)]
    Compile(#[from] CompileError),
    /// An FMU lacks what its role needs.
    #[error("{file} cannot be used as {role}: {}", problems.join("; "))]
    Unfit {
        /// FMU.
        file: String,
        /// Role.
        role: &'static str,
        /// What is missing.
        problems: Vec<String>,
    },
    /// A model does not accept what the scenario gives it.
    #[error("{file} cannot be packed: {message}")]
    Refused {
        /// FMU that was to be packed.
        file: String,
        /// What the model says.
        message: String,
    },
    /// One of Hotfoot's own FMUs is not where it should be.
    #[error(
        "{path} is missing; build Hotfoot's FMUs with `cargo xtask fmus`, or name their folder with --fmus"
    )]
    NoFmu {
        /// Path looked at.
        path: String,
    },
    /// The user names a component that is not there.
    #[error("{0}")]
    Component(String),
    /// A value of the scenario is not possible.
    #[error(transparent)]
    Value(#[from] Mistake),
    /// What the wheels do cannot be kept for further trains.
    #[error("{folder}: {source}; for heat.trains what the wheels do is kept on this disk")]
    Tape {
        /// Folder.
        folder: String,
        /// Reason.
        source: std::io::Error,
    },
}
