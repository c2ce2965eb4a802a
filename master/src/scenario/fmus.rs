//! The keys of a scenario's table `[fmus]`.

use std::collections::BTreeMap;
use std::path::PathBuf;

use garde::Validate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::value::Value;
use crate::system::structure::Home;

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
    /// `process`: each FMU that is named here runs in a process of its own.
    ///
    /// If it crashes, ends its process or never returns, that costs this FMU only.
    #[garde(skip)]
    pub isolate: Option<Isolate>,
    /// What becomes of the run if such an FMU of a vehicle fails in a step.
    #[garde(skip)]
    pub on_failure: OnFailure,
    /// Components that the command line isolates besides.
    #[serde(skip)]
    #[garde(skip)]
    pub isolated: Vec<String>,
}

/// How an FMU is kept apart from the others.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Isolate {
    /// In a process of its own.
    Process,
}

/// What becomes of the run if the isolated FMU of a vehicle fails in a step.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum OnFailure {
    /// It ends.
    #[default]
    End,
    /// It goes on, and the vehicle follows the motion of the train, without forces.
    Follow,
}

impl OnFailure {
    /// Whether the vehicle follows the train.
    pub fn follows(self) -> bool {
        self == Self::Follow
    }
}

impl Fmus {
    /// Where the FMUs that are named here are called.
    pub fn home(&self) -> Home {
        home(self.isolate, self.same_thread)
    }
}

impl VehicleReplacement {
    /// Where its FMU is called at least.
    pub fn home(&self) -> Home {
        home(self.isolate, self.same_thread)
    }
}

fn home(isolate: Option<Isolate>, same_thread: bool) -> Home {
    match (isolate, same_thread) {
        (Some(Isolate::Process), _) => Home::OwnProcess,
        (None, true) => Home::OwnThread,
        (None, false) => Home::AnyThread,
    }
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
    /// `process`: its FMU runs in a process of its own.
    #[garde(skip)]
    pub isolate: Option<Isolate>,
    /// What becomes of the run if that fails in a step; left out: as for all.
    #[garde(skip)]
    pub on_failure: Option<OnFailure>,
}
