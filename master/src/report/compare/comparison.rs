//! What a comparison has found.

use serde::Serialize;

use super::about::About;
use super::along::AlongRail;
use super::curves::Curve;
use super::errors::ColumnErrors;
use super::field_errors::FieldErrors;
use super::inputs::InputDifference;

/// What a comparison has found.
#[derive(Debug, Serialize)]
pub struct Comparison {
    /// The run that the others are compared with.
    pub first: About,
    /// The others, in their order.
    pub compared: Vec<Compared>,
    #[serde(skip)]
    pub(super) curves: Vec<Curve>,
    #[serde(skip)]
    pub(super) along: Vec<AlongRail>,
}

/// One of the others with what differs from the first.
#[derive(Debug, Serialize)]
pub struct Compared {
    /// What is known of it.
    pub with: About,
    /// Inputs that differ.
    pub inputs: Vec<InputDifference>,
    /// Errors of every column that both have, in the order of the first one's tables.
    pub columns: Vec<ColumnErrors>,
    /// Errors of the fields of the rails that both have.
    pub fields: Vec<FieldErrors>,
    /// Why other fields cannot be compared, in sentences.
    pub fields_not_compared: Vec<String>,
    /// Columns and fields that only the first has; none for a measurement.
    pub only_in_first: Vec<String>,
    /// Columns and fields that only the other has, with why, where they found no home.
    pub only_in_other: Vec<String>,
}

impl Comparison {
    /// The largest relative difference of all columns and fields.
    pub fn largest_relative(&self) -> f64 {
        let columns = self.compared.iter().flat_map(|compared| &compared.columns);
        let fields = self.compared.iter().flat_map(|compared| &compared.fields);
        let relative = columns.map(|column| column.relative);
        relative.chain(fields.map(|field| field.relative)).fold(0.0, f64::max)
    }
}
