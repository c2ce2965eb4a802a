//! Quantities over time, with unit and label.

use serde::Serialize;

use super::decimate::Picks;
use super::packed::Packed;

/// A quantity at the shown records.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Quantity {
    /// Name of the column in the results.
    pub name: String,
    /// SI unit, `1` for a number.
    pub unit: String,
    /// Values at the records.
    pub value: Packed,
    /// Lowest since the shown record before, where that is recorded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub lowest: Option<Packed>,
    /// Highest since the shown record before, where that is recorded.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub highest: Option<Packed>,
}

impl Quantity {
    /// A quantity of which the values at the records are known.
    pub fn plain(name: &str, unit: &str, values: &[f64], picks: &Picks) -> Self {
        Self {
            name: name.to_owned(),
            unit: unit.to_owned(),
            value: Packed::of(picks.values(values)),
            lowest: None,
            highest: None,
        }
    }

    /// The same quantity with its extremes between records.
    pub fn between(self, lowest: &[f64], highest: &[f64], picks: &Picks) -> Self {
        Self {
            lowest: Some(Packed::of(picks.lowest(lowest))),
            highest: Some(Packed::of(picks.highest(highest))),
            ..self
        }
    }
}

/// Quantities at common times.
#[derive(Debug, Clone, Serialize)]
pub(super) struct Quantities {
    /// One record of so many is shown.
    pub every: usize,
    /// Times of the shown records, s.
    pub time: Packed,
    /// The quantities.
    pub quantities: Vec<Quantity>,
}
