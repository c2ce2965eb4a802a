//! What is recorded of the rails: a row for each at every record, of the run and after it.

use std::path::Path;

use crate::recording::{Key, KeyValues, SeriesWriter};
use crate::run::observe::{ObserveError, all_outputs};
use crate::system::port::Port;
use crate::train::rail::Rail;

/// Name of the table.
pub const TABLE: &str = "rail";

/// Records the outputs of the rails that belong to no single vehicle.
pub struct RailRecorder {
    series: SeriesWriter,
    outputs: Vec<Port>,
}

impl RailRecorder {
    /// Begins the table in `folder`; none without rails.
    ///
    /// # Errors
    /// When the folder cannot be written.
    pub fn new(
        rails: &[Rail],
        folder: &Path,
        per_part: usize,
    ) -> Result<Option<Self>, ObserveError> {
        let Some(first) = rails.first() else { return Ok(None) };
        let (_, columns) = all_outputs(first.unit.as_ref());
        let keys = vec![Key {
            name: "rail".to_owned(),
            description: "Rail, seen in the running direction".to_owned(),
            values: KeyValues::Text(rails.iter().map(|r| r.side_name().to_owned()).collect()),
        }];
        let series = SeriesWriter::create(folder, TABLE, keys, columns, per_part)?;
        let outputs = rails.iter().map(|rail| all_outputs(rail.unit.as_ref()).0).collect();
        Ok(Some(Self { series, outputs }))
    }

    /// Records the rails at a time.
    ///
    /// # Errors
    /// When a unit does not give its outputs, or a file cannot be written.
    pub fn record(&mut self, time: f64, rails: &mut [Rail]) -> Result<(), ObserveError> {
        for (row, (rail, outputs)) in rails.iter_mut().zip(&mut self.outputs).enumerate() {
            outputs.get(rail.unit.as_mut())?;
            self.series.observe(row, &outputs.values);
        }
        Ok(self.series.record(time)?)
    }

    /// Completes the table.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        Ok(self.series.finish()?)
    }
}
