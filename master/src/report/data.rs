//! What the report shows: plain vectors, in SI units.

use super::facts::{EnergyLine, RunFacts};
use super::quantity::{seconds, with_unit};

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
    /// The heated rails.
    pub rails: Vec<RailData>,
}

impl ReportData {
    /// The highest rise in all fields, K.
    pub fn highest_of_fields(&self) -> f64 {
        let fields = self.rails.iter().filter_map(|rail| rail.field.as_ref());
        let snapshots = fields.flat_map(|field| &field.snapshots);
        snapshots.flat_map(|snapshot| &snapshot.rise).copied().fold(0.0, f32::max).into()
    }
}

/// A line of a table of figures; programs find it under its key in the manifest.
#[derive(Debug, Clone, PartialEq, serde::Serialize, serde::Deserialize)]
pub struct MainFigure {
    /// Its name for programs, such as `left.foot.highest`.
    pub key: String,
    /// What it is.
    pub name: String,
    /// The value in SI units; `None` for the time of what never happened.
    pub value: Option<f64>,
    /// SI unit of the value.
    pub unit: String,
    /// The value with its unit as people read it.
    pub text: String,
    /// Where and when, in words.
    #[serde(rename = "place")]
    pub location: String,
    /// Where on the track, m.
    pub chainage_m: Option<f64>,
    /// When, s.
    pub time_s: Option<f64>,
}

impl MainFigure {
    /// A figure whose text has three digits.
    pub fn new(key: impl Into<String>, name: impl Into<String>, value: f64, unit: &str) -> Self {
        Self {
            key: key.into(),
            name: name.into(),
            value: Some(value),
            unit: unit.to_owned(),
            text: with_unit(value, unit),
            location: String::new(),
            chainage_m: None,
            time_s: None,
        }
    }

    /// Whether it is worth a line on the terminal: heat by source is for the report and programs.
    pub fn is_shown(&self) -> bool {
        !self.key.contains(".heat.")
    }

    /// The figure with words for where and when.
    #[must_use]
    pub fn at(self, location: impl Into<String>) -> Self {
        Self { location: location.into(), ..self }
    }

    /// The figure with its chainage and its time.
    #[must_use]
    pub fn on_track(self, chainage_m: f64, time_s: f64) -> Self {
        let location = format!("chainage {chainage_m:.1} m at {} s", seconds(time_s));
        Self { chainage_m: Some(chainage_m), time_s: Some(time_s), ..self.at(location) }
    }
}

/// What the report shows of a heated rail.
#[derive(Debug, Clone, Default)]
pub struct RailData {
    /// `left` or `right`.
    pub side: String,
    /// What the run says of it.
    pub figures: Vec<MainFigure>,
    /// Its energies at the end of the run.
    pub energy: Vec<EnergyLine>,
    /// What cameras see of its foot; `None` if the model has no foot.
    pub foot: Option<Foot>,
    /// Heat per metre by source, at the probes and in the mean.
    pub heat: Vec<HeatAt>,
    /// Its temperature field.
    pub field: Option<RailField>,
}

/// Rise of a rail's foot over rail that no wheel has touched.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Foot {
    /// Times of the records, s.
    pub time: Vec<f64>,
    /// Highest along the track at these times, K.
    pub highest: Vec<f64>,
    /// Under the last wheel at these times, K.
    pub under_train: Vec<f64>,
}

/// Heat per metre of rail by source at a probe, or in the mean.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatAt {
    /// Where, in words.
    pub location: String,
    /// Heat of each of [`super::rail_figures::SOURCES`], J/m.
    pub sources: Vec<f64>,
}

/// The series of a plotted vehicle at the times of the records.
#[derive(Debug, Clone, Default)]
pub struct VehicleSeries {
    /// Number in the train, from 1.
    pub number: usize,
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
