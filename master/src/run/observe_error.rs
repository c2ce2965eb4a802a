//! Why recording failed.

use files::Mistake;

use crate::recording::RecordingError;
use crate::system::unit::UnitError;

/// Why recording failed.
#[derive(Debug, thiserror::Error)]
pub enum ObserveError {
    /// A file cannot be written.
    #[error(transparent)]
    Recording(#[from] RecordingError),
    /// A unit does not give its outputs.
    #[error(transparent)]
    Unit(#[from] UnitError),
    /// The outputs that the scenario names are not there.
    #[error(transparent)]
    Outputs(#[from] OutputsError),
}

/// Why outputs cannot be recorded.
#[derive(Debug, thiserror::Error)]
pub enum OutputsError {
    /// No vehicle has such an output.
    #[error(transparent)]
    None(Mistake),
    /// No component of a package has an output that fits.
    #[error("--record '{pattern}': no output that is a number has this name{meant}")]
    Pattern {
        /// What was to be recorded.
        pattern: String,
        /// What is likely meant, or what there is.
        meant: String,
    },
    /// Two vehicles have it in two units.
    #[error(
        "record.outputs: \"{name}\" is in \"{unit}\" in vehicle {vehicle}, but in \"{other}\" in one \
         before; one column cannot have both"
    )]
    Units {
        /// Name of the output.
        name: String,
        /// Its unit in a vehicle.
        unit: String,
        /// Number of that vehicle.
        vehicle: usize,
        /// Its unit before.
        other: String,
    },
}
