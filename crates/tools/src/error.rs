//! Why a command cannot answer.

use contact::ContactError;
use files::Mistake;
use vehicle::compile::StructureError;

/// Why a command cannot answer.
#[derive(Debug, thiserror::Error)]
pub enum ToolError {
    /// Options do not go together.
    #[error("{0}")]
    Options(String),
    /// A profile is not known, or a wheel does not stand on its rail.
    #[error(transparent)]
    Contact(#[from] ContactError),
    /// A vehicle's file has a mistake.
    #[error(transparent)]
    File(#[from] Mistake),
    /// A vehicle has no usable model in three dimensions.
    #[error(transparent)]
    Vehicle(#[from] StructureError),
    /// A plot cannot be drawn.
    #[error("the plot cannot be drawn: {0}")]
    Plot(String),
    /// A plot cannot be written.
    #[error("{file} cannot be written: {reason}")]
    Write {
        /// File.
        file: String,
        /// Reason.
        reason: std::io::Error,
    },
}

/// Refuses options unless they go together.
pub(crate) fn ensure(fit: bool, wanted: impl Into<String>) -> Result<(), ToolError> {
    match fit {
        true => Ok(()),
        false => Err(ToolError::Options(wanted.into())),
    }
}
