//! A table whose rows see every step, as functions of the system.

use super::observe_error::ObserveError;
use crate::recording::SeriesWriter;
use crate::system::step::System;
use crate::system::tap::Tap;

/// Appends the values of a row after the step to a communication point.
pub type Row = Box<dyn Fn(u64, &System, &mut Vec<f64>) + Send>;

/// The row of these signals; a signal that an FMU does not have is `missing`.
pub fn signals(taps: Vec<Option<Tap>>, missing: f64) -> Row {
    Box::new(move |_, system, values| {
        let value = |tap: &Option<Tap>| tap.as_ref().map_or(missing, |tap| system.value(tap));
        values.extend(taps.iter().map(value));
    })
}

/// Records a table whose rows see every step.
pub struct StepTable {
    series: SeriesWriter,
    rows: Vec<Row>,
    values: Vec<f64>,
}

impl StepTable {
    /// A table of these rows.
    pub fn new(series: SeriesWriter, rows: Vec<Row>) -> Self {
        Self { series, rows, values: vec![] }
    }

    /// Takes the values after the step to point `k`.
    pub fn observe(&mut self, k: u64, system: &System) {
        for (number, row) in self.rows.iter().enumerate() {
            self.values.clear();
            row(k, system, &mut self.values);
            self.series.observe(number, &self.values);
        }
    }

    /// Records the instant.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn record(&mut self, time: f64) -> Result<(), ObserveError> {
        Ok(self.series.record(time)?)
    }

    /// Its series.
    pub fn series(&mut self) -> &mut SeriesWriter {
        &mut self.series
    }

    /// Completes the files.
    ///
    /// # Errors
    /// When a file cannot be written.
    pub fn finish(self) -> Result<(), ObserveError> {
        Ok(self.series.finish()?)
    }
}
