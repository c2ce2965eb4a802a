//! What the report shows besides the linked view: plain vectors, in SI units.

use numerics::seconds;

use super::facts::EnergyLine;
use super::quantity::with_unit;

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
    /// Highest rise of the surface along the track at the records, K, with their times, s.
    pub surface: Vec<(f64, f64)>,
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
