//! What the report shows: plain vectors, in SI units.

use super::facts::{EnergyLine, RunFacts};

/// All that a report shows.
#[derive(Debug, Clone, Default)]
pub struct ReportData {
    /// Facts of the run.
    pub facts: RunFacts,
    /// The table of main figures.
    pub main_figures: Vec<MainFigure>,
    /// The energy audit.
    pub energy: Vec<EnergyLine>,
    /// Times of the records, s.
    pub time: Vec<f64>,
    /// Speed of the leading vehicle at these times, m/s.
    pub speed: Vec<f64>,
    /// Notch of the locomotives at these times; empty if the train does not give it.
    pub notch: Vec<f64>,
    /// The plotted vehicles, from the head of the train.
    pub vehicles: Vec<VehicleSeries>,
    /// Temperature of the heated rail.
    pub field: Option<RailField>,
}

/// A line of the table of main figures.
#[derive(Debug, Clone, PartialEq, Eq, serde::Serialize)]
pub struct MainFigure {
    /// What it is.
    pub name: String,
    /// The value with its unit.
    pub value: String,
    /// Where and when.
    pub place: String,
}

/// The series of a plotted vehicle at the times of the records.
#[derive(Debug, Clone, Default)]
pub struct VehicleSeries {
    /// Place in the train, from 1.
    pub place: usize,
    /// Whether it has traction.
    pub locomotive: bool,
    /// Force in the rear coupler, N, tension positive.
    pub coupler_force: Curve,
    /// Longitudinal creep force of all its wheels, N, positive in traction.
    pub creep_force: Curve,
    /// Synchronisation force, N.
    pub sync_force: Curve,
    /// Position error, vehicle model minus train model, m.
    pub position_error: Curve,
}

/// A recorded quantity: last values, and the lowest and highest between two records.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Curve {
    /// Values at the records.
    pub value: Vec<f64>,
    /// Lowest since the record before.
    pub lowest: Vec<f64>,
    /// Highest since the record before.
    pub highest: Vec<f64>,
}

impl Curve {
    /// A curve whose extremes are its values.
    pub fn plain(value: Vec<f64>) -> Self {
        Self { lowest: value.clone(), highest: value.clone(), value }
    }
}

/// Temperature rise of a rail over chainage and depth, at chosen times.
#[derive(Debug, Clone, Default)]
pub struct RailField {
    /// Chainage of the middle of each element, m, rising.
    pub chainage: Vec<f64>,
    /// Depth of the middle of each cell below the running surface, m, rising.
    pub depth: Vec<f64>,
    /// The field at the chosen times.
    pub snapshots: Vec<Snapshot>,
}

/// The field at one time.
#[derive(Debug, Clone, Default)]
pub struct Snapshot {
    /// Time, s.
    pub time: f64,
    /// Rise above the initial state, K: all depths of the first element, then of the second, …
    pub rise: Vec<f32>,
    /// Chainage of the middle of each vehicle at this time, m, from the head of the train.
    pub vehicles: Vec<f64>,
}

impl RailField {
    /// Rise on the surface of each element, K.
    pub fn surface<'a>(&self, snapshot: &'a Snapshot) -> impl Iterator<Item = f32> + use<'a> {
        snapshot.rise.iter().step_by(self.depth.len().max(1)).copied()
    }
}
