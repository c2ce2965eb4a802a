//! When a snapshot of the field is written.

use std::path::Path;

use field::{Attribute, Axes, FieldError, FieldWriter};

use crate::heat_model::HeatModel;

/// Slack in comparing times, s.
const SAME_TIME: f64 = 1e-9;

/// Writes a snapshot at the start and whenever another interval has passed.
///
/// A snapshot is written at the end of the first step that reaches a multiple of the interval.
/// The file is no part of the model's state: after an earlier state has been restored, nothing is
/// written until the time of the next snapshot comes.
pub(crate) struct FieldFile {
    writer: FieldWriter,
    start_time: f64,
    interval: f64,
    /// Number of the interval at whose end the next snapshot is due.
    next: u64,
    values: Vec<f32>,
}

impl FieldFile {
    /// Begins the store at `path` with the snapshot at the start.
    pub(crate) fn create(
        path: &Path,
        interval: f64,
        start_time: f64,
        model: &dyn HeatModel,
    ) -> Result<Self, FieldError> {
        let line = model.line();
        let axes = Axes {
            chainage: (0..line.elements).map(|element| line.chainage(element)).collect(),
            depth: model.depths(),
        };
        let attributes = [
            ("title", Attribute::from("Temperature rise of a rail under a train")),
            ("model", Attribute::from(model.name())),
            ("initial_temperature_K", Attribute::from(model.initial_temperature())),
            ("element_length_m", Attribute::from(line.element_length)),
            ("cell_size_m", Attribute::from(2.0 * axes.depth[0])),
        ];
        let mut file = Self {
            writer: FieldWriter::create(path, &axes, &attributes)?,
            start_time,
            interval,
            next: 0,
            values: vec![0.0; axes.values()],
        };
        file.write_if_due(start_time, model)?;
        Ok(file)
    }

    /// Writes a snapshot if its time has come.
    pub(crate) fn write_if_due(
        &mut self,
        time: f64,
        model: &dyn HeatModel,
    ) -> Result<(), FieldError> {
        let passed = (time - self.start_time + SAME_TIME) / self.interval;
        if passed < self.next as f64 {
            return Ok(());
        }
        model.snapshot(&mut self.values);
        self.writer.append(time, &self.values)?;
        self.next = passed as u64 + 1;
        Ok(())
    }
}
