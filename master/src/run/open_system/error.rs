//! Why a system cannot be opened, or a step or a request failed.

use numerics::seconds;

use crate::files::file_error::FileError;
use crate::run::after::StepFailure;
use crate::run::error::RunError;
use crate::system::unit::UnitError;

/// Why a system cannot be opened, or a step or a request failed.
#[derive(Debug, thiserror::Error)]
pub enum OpenSystemError {
    /// It cannot be set up or initialised.
    #[error(transparent)]
    Run(#[from] RunError),
    /// A unit failed in a step.
    #[error("at {} s: {source}", seconds(*time))]
    Step {
        /// Time at which the step began, s.
        time: f64,
        /// Reason.
        source: Box<StepFailure>,
    },
    /// A unit wants the run to end, in a sentence.
    #[error("{0}")]
    Early(String),
    /// A unit refuses.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// What is asked for is not there or cannot be, in a sentence.
    #[error("{0}")]
    Request(String),
}

impl From<FileError> for OpenSystemError {
    fn from(error: FileError) -> Self {
        RunError::from(error).into()
    }
}
