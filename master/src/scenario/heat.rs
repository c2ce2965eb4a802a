//! The keys of a scenario's table `[heat]`.

use std::collections::BTreeMap;

use garde::Validate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::value::Value;

/// Rail heat.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Heat {
    /// Heat model of the rail-heat FMU: `energy`, which conserves heat, or `paper`.
    #[serde(default = "default_heat_model")]
    #[garde(length(min = 1))]
    pub model: String,
    /// Which rail is heated, or both.
    #[serde(default)]
    #[garde(skip)]
    pub rail: Rail,
    /// Step of the exchange with the rail, s: a multiple of the scenario's `step_s`.
    ///
    /// What the wheels do in between is averaged.
    #[garde(range(min = 1e-6, max = 10.0))]
    pub step_s: Option<f64>,
    /// Chainage at which the modelled rail begins, m; left out: behind the tail of the train.
    #[garde(skip)]
    pub begin_m: Option<f64>,
    /// Length of the modelled rail, m; left out: as far as the leading vehicle may come.
    #[garde(range(min = 1.0, max = 1e6))]
    pub length_m: Option<f64>,
    /// Time for which the rail goes on alone after the last train, min.
    #[serde(default)]
    #[garde(range(min = 0.0, max = 1e5))]
    pub cool_down_minutes: f64,
    /// Longest step and time between two records while the rail is alone, s.
    #[serde(default = "default_cool_down_step")]
    #[garde(range(min = 0.001, max = 3600.0))]
    pub cool_down_step_s: f64,
    /// Trains that follow each other.
    #[serde(default)]
    #[garde(dive)]
    pub trains: Trains,
    /// Rise of the foot that a camera can see, mK.
    #[serde(default = "default_threshold")]
    #[garde(range(min = 1e-3, max = 1e6))]
    pub detection_threshold_mk: f64,
    /// Time between two records of the temperature field, s.
    #[serde(default = "default_field_interval")]
    #[garde(range(min = 0.01, max = 1e6))]
    pub field_interval_s: f64,
    /// What a field that cannot be written means, as on a full disk.
    #[serde(default)]
    #[garde(skip)]
    pub field_failure: FieldFailure,
    /// Depths below the crown at which the highest rise is given, mm.
    #[serde(default = "default_depths")]
    #[garde(inner(range(min = 0.0, max = 200.0)))]
    pub depths_mm: Vec<f64>,
    /// Places whose temperature is recorded.
    #[serde(default)]
    #[garde(dive)]
    pub probe: Vec<Probe>,
    /// Further parameters of the rail-heat FMU by name, of any type, and values of its inputs of
    /// the weather. A text that is the path of a file, relative to the scenario's, is that file.
    #[serde(default)]
    #[garde(skip)]
    pub parameters: BTreeMap<String, Value>,
}

/// Which rails are heated, seen in the running direction.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Rail {
    /// The left rail (the paper's).
    #[default]
    Left,
    /// The right rail.
    Right,
    /// Both, each with a unit of its own.
    Both,
}

impl Rail {
    /// The heated rails as places in [`crate::train::roles::SIDES`].
    pub fn sides(self) -> &'static [usize] {
        match self {
            Self::Left => &[0],
            Self::Right => &[1],
            Self::Both => &[0, 1],
        }
    }
}

/// Trains that follow each other: the train of the run, and others that do to the rail what it did.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Trains {
    /// How many, the one of the run included.
    #[garde(range(min = 1, max = 10_000))]
    pub count: u32,
    /// Time between two trains, min.
    #[garde(range(min = 0.0, max = 1e5))]
    pub headway_minutes: f64,
}

impl Default for Trains {
    /// The train of the run only.
    fn default() -> Self {
        Self { count: 1, headway_minutes: 0.0 }
    }
}

/// What a temperature field that cannot be written means.
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum FieldFailure {
    /// The run stops; what was recorded is kept.
    #[default]
    Stop,
    /// The run continues without the field, and says so.
    #[serde(rename = "go-on")]
    Continue,
}

impl FieldFailure {
    /// The rail-heat FMU's word for it.
    pub fn word(self) -> &'static str {
        match self {
            Self::Stop => "stop",
            Self::Continue => "go_on",
        }
    }
}

/// A point on the rail.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Probe {
    /// Chainage, m.
    #[garde(range(min = -1e7, max = 1e7))]
    pub chainage_m: f64,
}

fn default_heat_model() -> String {
    "energy".to_owned()
}

fn default_cool_down_step() -> f64 {
    10.0
}

fn default_threshold() -> f64 {
    15.0
}

fn default_field_interval() -> f64 {
    10.0
}

fn default_depths() -> Vec<f64> {
    vec![20.0, 60.0]
}
