//! What was run: the parts of a manifest that say where its results come from and where the time went.

use serde::{Deserialize, Serialize};

/// What was run, as far as the manifest tells it.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
#[serde(default)]
pub struct Provenance {
    /// Version of the program.
    pub hotfoot_version: String,
    /// Commit that the program is built from.
    pub git_commit: String,
    /// Operating system, processor and cores.
    pub machine: String,
    /// When the run began, UTC.
    pub begun: String,
    /// The command as it was given.
    pub command: String,
    /// Simulated time reached, s.
    pub simulated_s: f64,
    /// How the run has ended; empty while it goes on.
    pub end: String,
    /// Text of the scenario.
    pub scenario: String,
    /// The FMUs.
    pub fmu: Vec<Fmu>,
    /// Wall times of the parts of all steps.
    pub wall_time_of: Vec<PartTime>,
    /// The units.
    pub unit: Vec<UnitFacts>,
}

/// An FMU that took part.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
pub struct Fmu {
    /// Its file.
    pub file: String,
    /// Digest of the file.
    pub sha256: String,
}

/// Wall time of a part of all steps.
#[derive(Debug, Clone, Default, Deserialize, Serialize)]
pub struct PartTime {
    /// The part.
    pub part: String,
    /// Its wall time, s.
    pub seconds: f64,
}

/// What a run knows of one of its units.
#[derive(Debug, Clone, Default, PartialEq, Deserialize, Serialize)]
#[serde(default)]
pub struct UnitFacts {
    /// Its name.
    pub name: String,
    /// Name of its FMU's file.
    pub fmu: String,
    /// Wall time of its steps, s.
    pub wall_time_s: f64,
    /// Wall time of its slowest step, s.
    pub slowest_step_s: f64,
    /// Simulated time at the end of that step, s.
    pub slowest_at_s: f64,
    /// The last that it warned of.
    pub last_message: Option<String>,
}
