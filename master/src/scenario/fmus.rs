//! The keys of a scenario's table `[fmus]`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use garde::Validate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::value::Value;

/// FMUs that replace Hotfoot's own.
#[derive(Debug, Clone, Default, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Fmus {
    /// For the whole train.
    #[garde(skip)]
    pub longitudinal: Option<PathBuf>,
    /// For all vehicles.
    #[garde(skip)]
    pub vehicle: Option<PathBuf>,
    /// The names of the FMU for all vehicles for our signals, where they differ.
    #[garde(skip)]
    pub vehicle_names: BTreeMap<String, String>,
    /// For the rail.
    #[garde(skip)]
    pub railheat: Option<PathBuf>,
    /// For single vehicles.
    #[garde(dive)]
    pub vehicle_at: Vec<VehicleReplacement>,
    /// Whether a step that an FMU discards is tried again in up to 16 parts.
    ///
    /// Each try begins from the state before the step, which costs a saved state of every FMU in each step.
    #[garde(skip)]
    pub retry_discarded_steps: bool,
    /// Relative tolerance of the FMUs' solvers; left out: what each FMU proposes.
    #[garde(inner(range(min = 1e-15, max = 1.0)))]
    pub tolerance: Option<f64>,
    /// Whether each FMU that is named here is made, called and freed on a thread of its own.
    ///
    /// For FMUs that may be called only by the thread that has made them.
    #[garde(skip)]
    pub same_thread: bool,
}

/// An FMU, or other parameters, for one vehicle.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct VehicleReplacement {
    /// Number of the vehicle in the train, from 1.
    #[serde(alias = "place")]
    #[garde(range(min = 1))]
    pub vehicle: usize,
    /// FMU, relative to the scenario's file; left out: that of the others.
    #[garde(skip)]
    pub file: Option<PathBuf>,
    /// Its names for our signals, where they differ: `"sync.force" = "control_force"`.
    #[serde(default)]
    #[garde(skip)]
    pub names: BTreeMap<String, String>,
    /// Its parameters, and inputs that keep a value throughout, by their names in the FMU.
    #[serde(default)]
    #[garde(skip)]
    pub parameters: BTreeMap<String, Value>,
    /// Whether its FMU is made, called and freed on a thread of its own.
    #[serde(default)]
    #[garde(skip)]
    pub same_thread: bool,
}
