//! What a call returns (§2.1.3).

use crate::error::Error;

/// `fmi2Status`: what a call returns.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[repr(C)]
pub enum Status {
    /// All is well.
    Ok = 0,
    /// The result may be wrong; a message says why.
    Warning = 1,
    /// The step was not done, or the status asked for does not exist.
    Discard = 2,
    /// The instance cannot go on.
    Error = 3,
    /// No instance can go on.
    Fatal = 4,
    /// The step runs asynchronously.
    Pending = 5,
}

impl Error {
    /// What the FMU returns.
    pub fn status(&self) -> Status {
        match self {
            Self::Step { source, .. } if source.is_step_too_long() => Status::Discard,
            Self::NoStatus { .. } => Status::Discard,
            Self::UnknownCategory(_) => Status::Warning,
            _ => Status::Error,
        }
    }
}
