//! The keys of a scenario file.

use std::path::PathBuf;

use files::{Check, Document};
use garde::Validate;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::fmus::Fmus;
use super::heat::Heat;
use crate::system::checks::Checks;

/// What is run: the train on its track, how it is driven, what is computed and recorded.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Scenario {
    /// Title for the report.
    #[garde(length(min = 1))]
    pub title: String,
    /// Simulated time, s.
    #[garde(range(min = 0.001, max = 1e7))]
    pub duration_s: f64,
    /// Step of the exchange between the models, s.
    #[serde(default = "default_step")]
    #[garde(range(min = 1e-6, max = 1.0))]
    pub step_s: f64,
    /// Order of the exchange.
    #[serde(default)]
    #[garde(skip)]
    pub scheme: Scheme,
    /// What becomes of values that FMUs give and that cannot be.
    ///
    /// `error` ends the run, `warn` warns the first time for each variable, `off` looks for none. Left out: a value that is not finite ends the run, and one out of its range is a warning.
    #[garde(skip)]
    pub checks: Option<Checks>,
    /// Runs the train model alone: no vehicles in three dimensions, no rail heat.
    #[serde(default)]
    #[garde(skip)]
    pub train_alone: bool,
    /// Folder of the rolling-stock library, relative to the scenario's file.
    ///
    /// Left out: `../../stock` if it is there, else the library that is shipped with the program.
    #[serde(default)]
    #[garde(skip)]
    pub stock: PathBuf,
    /// The train.
    #[garde(dive)]
    pub train: Train,
    /// The track.
    #[garde(dive)]
    pub track: Track,
    /// The driver.
    #[garde(dive)]
    pub driver: Driver,
    /// How vehicles are kept at their position in the train.
    #[serde(default)]
    #[garde(dive)]
    pub synchronisation: Synchronisation,
    /// Rail heat; left out: no rail is heated.
    #[garde(dive)]
    pub heat: Option<Heat>,
    /// FMUs that replace Hotfoot's own.
    #[serde(default)]
    #[garde(dive)]
    pub fmus: Fmus,
    /// What is recorded.
    #[serde(default)]
    #[garde(dive)]
    pub record: Record,
    /// The text that it was read from, for messages that point at a line of it.
    #[serde(skip)]
    #[garde(skip)]
    pub document: Document,
}

impl Scenario {
    /// Checks for values of its text.
    pub fn check(&self) -> Check<'_> {
        self.document.check()
    }
}

/// Order of the exchange between the models (docs/user-guide, "The step").
#[derive(Debug, Clone, Copy, Default, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Scheme {
    /// The train first, then the vehicles with its new forces, then the rail.
    #[default]
    Sequential,
    /// All models take the values of the last communication point.
    Jacobi,
}

/// The train from head to tail.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Train {
    /// Chainage of the middle of the leading vehicle at the start, m.
    #[serde(default)]
    #[garde(range(min = -1e7, max = 1e7))]
    pub leading_vehicle_position_m: f64,
    /// Speed at the start, m/s.
    #[garde(range(min = 0.0, max = 60.0))]
    pub speed_m_per_s: f64,
    /// How the couplers are at the start.
    ///
    /// Left out: as the train's FMU has it, which is in balance for Hotfoot's own.
    #[garde(skip)]
    pub couplers: Option<Couplers>,
    /// Wind over the line; left out: none.
    #[garde(dive)]
    pub wind: Option<Wind>,
    /// Groups of equal vehicles from head to tail.
    #[garde(length(min = 1), dive)]
    pub vehicles: Vec<VehicleGroup>,
}

/// How the couplers are at the start: the values of the train's parameter `initial.couplers`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize, Serialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Couplers {
    /// Without force, in the middle of their slack.
    Unstressed = 0,
    /// Loaded to the forces of uniform acceleration.
    InBalance = 1,
}

/// A uniform wind over the line.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Wind {
    /// Speed of the air, m/s.
    #[garde(range(min = 0.0, max = 60.0))]
    pub speed_m_per_s: f64,
    /// Angle that it comes from, to the right of the heading at the beginning of the track.
    ///
    /// 0 is a head wind there.
    #[serde(default)]
    #[garde(range(min = -360.0, max = 360.0))]
    pub direction_deg: f64,
}

/// A number of equal vehicles one behind the other.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct VehicleGroup {
    /// Vehicle type: a name in the folder `vehicles` of the stock library, or the path of a vehicle file
    /// that ends in `.toml`, relative to the scenario's file; after loading the file's name without its ending.
    #[serde(rename = "type")]
    #[garde(length(min = 1))]
    pub kind: String,
    /// File of a type that is not in the library.
    #[serde(skip)]
    #[garde(skip)]
    pub file: Option<PathBuf>,
    /// How many.
    #[serde(default = "one")]
    #[garde(range(min = 1, max = 1000))]
    pub count: usize,
    /// Group of locomotives whose commands they follow; 0 is the leading one.
    #[serde(default)]
    #[garde(range(max = 16))]
    pub group: usize,
    /// Share of the hand brakes' force that is applied.
    #[serde(default)]
    #[garde(range(min = 0.0, max = 1.0))]
    pub hand_brake: f64,
}

/// The track.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Track {
    /// Track file, relative to the scenario's file.
    #[garde(skip)]
    pub file: PathBuf,
}

/// The driver.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields)]
pub struct Driver {
    /// Driver file, relative to the scenario's file.
    #[garde(skip)]
    pub file: PathBuf,
    /// Files beside it that it names, such as the CSV of a logger.
    #[serde(default)]
    #[garde(skip)]
    pub with: Vec<PathBuf>,
}

/// Gains of the controllers that keep each vehicle at its position in the train.
///
/// F = -(Kp e + Ki ∫e dt + Kd de/dt) with e, the vehicle's own position less that in the train.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Synchronisation {
    /// Kp, kN/m; 0 is velocity-only control.
    #[garde(range(min = 0.0, max = 1e6))]
    pub kp_kn_per_m: f64,
    /// Ki, kN/(m s).
    #[garde(range(min = 0.0, max = 1e6))]
    pub ki_kn_per_m_s: f64,
    /// Kd, kN/(m/s).
    #[garde(range(min = 0.0, max = 1e6))]
    pub kd_kn_s_per_m: f64,
    /// Largest magnitude of the force, kN.
    #[garde(range(min = 0.0, max = 1e6))]
    pub limit_kn: f64,
}

impl Default for Synchronisation {
    /// The gains of Bosomworth et al. (2018), section 2.2.3; the limit is far above what is
    /// needed, so that reaching it shows an error elsewhere.
    fn default() -> Self {
        Self { kp_kn_per_m: 2.0, ki_kn_per_m_s: 0.0, kd_kn_s_per_m: 10.0, limit_kn: 500.0 }
    }
}

/// What is recorded.
#[derive(Debug, Clone, Deserialize, Serialize, JsonSchema, Validate)]
#[serde(deny_unknown_fields, default)]
pub struct Record {
    /// Time between two rows, s; extremes in between are kept.
    #[garde(range(min = 1e-6, max = 1e4))]
    pub interval_s: f64,
    /// Numbers, from 1, of the vehicles whose wheels are recorded and which the report plots.
    ///
    /// Left out: the locomotive at the head, a second one, and three more.
    #[garde(inner(range(min = 1)))]
    pub wheels_of: Vec<usize>,
    /// Further outputs of these vehicles, by their names in the FMU.
    ///
    /// `*` stands for any text: `"*.derailment_quotient"`. They stand in `series/outputs`, with their means
    /// and extremes, and the main figures have the highest and the lowest mean of each name.
    #[garde(inner(length(min = 1)))]
    pub outputs: Vec<String>,
    /// Times whose temperature field the report shows, s.
    #[garde(inner(range(min = 0.0)))]
    pub heat_maps_at_s: Vec<f64>,
    /// Simulated time between two checkpoints, from which `hotfoot run --resume` goes on, s.
    ///
    /// Left out: none is written.
    #[garde(inner(range(min = 1e-3, max = 1e7)))]
    pub checkpoint_s: Option<f64>,
}

impl Default for Record {
    /// 10 Hz, and the times of the paper's figures 11 and 12.
    fn default() -> Self {
        Self {
            interval_s: 0.1,
            wheels_of: vec![],
            outputs: vec![],
            heat_maps_at_s: vec![60.0, 160.0],
            checkpoint_s: None,
        }
    }
}

fn default_step() -> f64 {
    1e-3
}

fn one() -> usize {
    1
}

impl Scenario {
    /// File of a vehicle type: the one that the train names, else that in the stock library.
    pub fn vehicle_file(&self, kind: &str) -> PathBuf {
        let stated = self.train.vehicles.iter().find(|group| group.kind == kind);
        let stated = stated.and_then(|group| group.file.clone());
        stated
            .unwrap_or_else(|| self.stock.join("vehicles").join(kind).with_added_extension("toml"))
    }

    /// Number of vehicles in the train.
    pub fn vehicle_count(&self) -> usize {
        self.train.vehicles.iter().map(|group| group.count).sum()
    }

    /// The vehicles whose wheels are recorded.
    ///
    /// Those of `wheels_of`, or the head of the train, its second vehicle, one near the head, the middle
    /// and the tail.
    pub fn recorded_vehicles(&self) -> Vec<usize> {
        let count = self.vehicle_count();
        let mut numbers = match self.record.wheels_of.as_slice() {
            [] => vec![1, 2, 3, count.div_ceil(2), count],
            given => given.to_vec(),
        };
        numbers.retain(|&number| number <= count);
        numbers.sort_unstable();
        numbers.dedup();
        numbers
    }
}
