//! What is known of a run or of a measurement.

use serde::Serialize;

/// What is known of a run or of a measurement.
#[derive(Debug, Clone, Serialize)]
pub struct About {
    /// Its folder or file.
    pub name: String,
    /// The command that made it; empty for a measurement.
    pub command: String,
    /// When it began, UTC.
    pub begun: String,
    /// Version and commit of the program.
    pub version: String,
    /// Simulated time, s.
    pub simulated_s: Option<f64>,
    /// How it has ended.
    pub end: String,
}
