//! Why a checkpoint cannot be written, or a run not go on from one.

use crate::files::file_error::FileError;
use crate::system::unit::UnitError;

/// Why a checkpoint cannot be written, or a run not go on from one.
#[derive(Debug, thiserror::Error)]
pub enum CheckpointError {
    /// A file cannot be read or written.
    #[error("checkpoint: {0}")]
    File(#[from] FileError),
    /// A unit cannot be saved or set back.
    #[error("checkpoint: {0}")]
    Unit(#[from] UnitError),
    /// There is nothing to go on with.
    #[error(
        "--resume {results}: there is no {results}/checkpoint/run.toml, so there is nothing to go on with; a \
         run writes checkpoints if `--checkpoint` or `record.checkpoint_s` says how often, and removes them \
         when it has come to its end"
    )]
    None {
        /// Folder of the results.
        results: String,
    },
    /// Something is not as it was when the run began.
    #[error("--resume {results}: the run cannot go on as it was: {what}")]
    Changed {
        /// Folder of the results.
        results: String,
        /// What is different, and what would be right.
        what: String,
    },
}
