//! What the run itself adds to the results: the part `[run]` of the manifest.

use serde::{Deserialize, Serialize};
use track::SpeedLimit;

/// Facts that stand in no series; the run writes them as the table `run` of `manifest.toml`.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RunFacts {
    /// Title of the scenario.
    pub title: String,
    /// Whether there were no vehicles in three dimensions.
    #[serde(default)]
    pub train_alone: bool,
    /// Number of vehicles in the train.
    pub vehicles: usize,
    /// Places in the train, from 1, of the vehicles with traction.
    pub locomotives: Vec<usize>,
    /// Places in the train, from 1, of the vehicles that the report plots.
    pub plotted: Vec<usize>,
    /// Names of further outputs that are recorded, with `*` for any text.
    #[serde(default)]
    pub outputs: Vec<String>,
    /// The heated rails; `None` without rail heat.
    #[serde(default)]
    pub rails: Option<RailFacts>,
    /// What was foreseen before the first step, such as wheels outside the modelled rail.
    #[serde(default)]
    pub notes: Vec<String>,
    /// What the units warned of during the run, such as a field that could no longer be written.
    #[serde(default)]
    pub warnings: Vec<String>,
    /// Times whose temperature field the report shows, s.
    #[serde(default)]
    pub heat_maps_at_s: Vec<f64>,
    /// The track; empty if it cannot be read.
    #[serde(default)]
    pub track: TrackFacts,
    /// Limits that the run is judged by.
    #[serde(default)]
    pub limits: LimitFacts,
    /// Step of the exchange between the models, s.
    pub step_s: f64,
    /// Number of threads.
    pub threads: usize,
    /// Wall time of the stepping, s; left out by a run that was killed.
    pub wall_time_s: Option<f64>,
    /// Energy audit of the run.
    #[serde(default)]
    pub energy: Vec<EnergyLine>,
}

/// What the run knows of the heated rails.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct RailFacts {
    /// `left`, `right` or both.
    pub sides: Vec<String>,
    /// Name of the store with the field of each of them.
    pub fields: Vec<String>,
    /// Heat model.
    pub model: String,
    /// Length of the modelled rail, m.
    pub length_m: f64,
    /// Rise of the foot that a camera can see, K.
    pub detection_threshold_k: f64,
    /// Trains that passed, that of the run included.
    pub trains: u32,
    /// When the last train's run ended, s.
    pub last_train_end_s: f64,
}

/// What is said of the numbers of the paper's heat model.
const PAPERS_MODEL: &str = "The rail is heated by the paper's model (model = \"paper\"), so that its numbers can be compared with the \
    paper's figures. They are no temperatures of a rail: the heat that a wheel puts in is proportional to the size of the \
    cells, which the paper does not state, and heat is not conserved. Do not read from them whether, when or where the foot \
    warms; model = \"energy\" answers that.";

impl RailFacts {
    /// What not to read from the results, in sentences, where the heat model is the paper's.
    pub fn caution(&self) -> Option<&'static str> {
        (self.model == "paper").then_some(PAPERS_MODEL)
    }
}

/// A line of the energy audit.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct EnergyLine {
    /// What the energy is.
    pub name: String,
    /// Energy, J.
    pub joules: f64,
}

/// The track by points, between which it is linear.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct TrackFacts {
    /// Chainage of the points, m, rising.
    pub chainage_m: Vec<f64>,
    /// Curvature, 1/m, positive in a right-hand curve.
    pub curvature_per_m: Vec<f64>,
    /// Cant angle, rad, positive when the right rail is the lower.
    pub cant_angle_rad: Vec<f64>,
    /// Gradient, positive uphill.
    pub gradient: Vec<f64>,
    /// Speed limits.
    #[serde(default)]
    pub speed_limit: Vec<SpeedLimit>,
}

/// Limits of a run's figures, from the file of expected figures beside its scenario.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct LimitFacts {
    /// Simulated time after which they hold, s.
    pub simulated_s: f64,
    /// The limits.
    pub figures: Vec<Limit>,
}

/// A limit of a figure.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Limit {
    /// Key of the figure.
    pub key: String,
    /// The figure is not below this, in its SI unit.
    pub at_least: Option<f64>,
    /// The figure is not above this, in its SI unit.
    pub at_most: Option<f64>,
    /// Where the limit comes from.
    pub source: String,
}
